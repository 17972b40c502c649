//! The key `recommend` of a study: the parameters to choose, and the metrics to keep.

use super::decode::{free, measure};
use super::{Alternative, Free};
use crate::Study;
use crate::cases::ensemble::{item, refuse_constant};
use crate::cases::scope::{Scope, names};
use crate::computed::sources::WITHIN;
use crate::source::faults::Faults;
use crate::source::object::Object;
use crate::value::number;
use slipgap_problem::problem::numbers::parameter::Range;

/// The keys besides the names of free parameters, each with its meaning.
pub(crate) const KEYS: [(&str, &str); 2] = [
    (
        "over",
        "the parameters to choose, such as [\"law\", \"dt\", \"n\"]; cases that differ only in these, and in what changes with them, are one physical case",
    ),
    (
        WITHIN,
        "the metrics to keep, each with its tolerance, as in {\"peak(gap.S)\": 0.02}: the largest error, or the largest relative difference from the exact or finest motion",
    ),
];

/// Most cases of a study whose candidates are compared.
const MOST: u64 = 1_000_000;

/// The parameters of a study to choose, and the metrics that a choice must keep in every physical case.
#[derive(Debug, Clone, PartialEq)]
pub struct Recommend {
    /// Rows of `problem.parameters()`.
    pub over: Vec<usize>,
    /// Parameters that are searched for each candidate, in the order of the file.
    pub free: Vec<Free>,
    /// Rows of the study's measures, each with its tolerance.
    pub within: Vec<(usize, f64)>,
}

/// Decodes the key; `None` without it or with a fault.
pub(crate) fn recommend(root: &Object, scope: &Scope, faults: &mut Faults) -> Option<Recommend> {
    let node = root.get("recommend")?;
    let (path, before) = (root.path("recommend"), faults.count());
    let parameters = scope.parameters();
    let own = KEYS.map(|key| key.0);
    let allowed: Vec<&str> = own.iter().chain(&parameters).copied().collect();
    let object = Object::open(node, &path, &allowed, faults)?;
    let over = object.need(own[0], KEYS[0].1, faults).and_then(|node| {
        let path = object.path(own[0]);
        let rows = names(node, &path, "parameter", &parameters, faults)?;
        // A parameter of one law has its values in the blocks of this law.
        let count = |row: usize| scope.blocks.iter().filter(|block| block.gives(row)).count();
        let alike = |row: usize| [0, scope.blocks.len()].contains(&count(row));
        for (i, row) in rows.iter().enumerate() {
            if !scope.blocks.is_empty() && alike(*row) {
                refuse_constant(scope, *row, "a choice", item(node, &path, i), faults);
            }
        }
        Some(rows)
    });
    let free = free(&object, &own, scope, faults);
    let within = object.need(WITHIN, KEYS[1].1, faults);
    let within = within.map(|node| {
        let path = object.path(WITHIN);
        let mut rows = Vec::new();
        let Some(metrics) = Object::of_any_keys(node, &path, faults) else {
            return rows;
        };
        for member in &metrics.members {
            let path = metrics.path(&member.key);
            let row = measure(&member.key, (member.at, &path), "keep", scope, faults);
            let tolerance = number(&member.node, &path, Range::Positive, faults);
            rows.extend(row.zip(tolerance));
        }
        if metrics.members.is_empty() {
            metrics.fault("names no metric", faults);
        }
        rows
    });
    let blocks = scope.blocks.iter();
    let count = blocks.fold(0, |sum: u64, block| sum.saturating_add(block.raw_len()));
    if count > MOST {
        let message =
            format!("{count} combinations; a study with \"recommend\" has at most {MOST}");
        faults.add(node.at, &path, message);
    }
    (faults.count() == before).then_some(Recommend {
        over: over?,
        free,
        within: within?,
    })
}

impl Study {
    /// The candidates of `recommend` in the order of the cases, each with its physical cases as tests; none without the key.
    pub fn candidates(&self) -> Vec<Alternative> {
        let over = self.recommend.as_ref().map(|own| &own.over);
        over.map_or(Vec::new(), |over| {
            self.grouped(None, |group| over.iter().any(|row| group.has(*row)))
        })
    }
}
