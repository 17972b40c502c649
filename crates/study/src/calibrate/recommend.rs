//! The key `recommend` of a study: the parameters to choose, and the metrics to keep.

use super::Free;
use super::decode::{free, measure};
use crate::cases::ensemble::refuse_constant;
use crate::cases::scope::{Scope, names};
use crate::computed::sources::WITHIN;
use crate::source::faults::Faults;
use crate::source::field::{ANY, Keys, Kind, field, fields, needed};
use crate::source::object::Object;
use crate::value::number;
use slipgap_problem::problem::numbers::parameter::{self, Range};

/// The keys besides the names of free parameters, each with its meaning.
pub(crate) const KEYS: Keys = Keys::new(&fields![
    /// parameters to choose, such as ["law", "dt", "n"]; cases that differ only in these, and in what changes with them, are candidates for one physical case
    needed("over", NAMES),
    /// metrics with tolerances, as in {"peak(gap.S)": 0.02}: the largest error such as rms_error(a), or of any other metric the largest fraction by which it differs from the exact or finest motion
    needed(WITHIN, Kind::Shared("tolerances")),
    /// numbers in over whose next smaller and larger values must keep the metrics, too
    field("neighbours", NAMES),
]);

/// One name, or a list of names.
const NAMES: Kind = Kind::Several(&Kind::Text, [1, ANY]);

/// The parameters of a study to choose, and the metrics that a choice must keep in every physical case.
#[derive(Debug, Clone, PartialEq)]
pub struct Recommend {
    /// Rows of `problem.parameters()`.
    pub over: Vec<usize>,
    /// Those of which the next values must keep the metrics, too.
    pub neighbours: Vec<usize>,
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
    let keys = KEYS.names();
    let allowed = [&keys[..], &parameters].concat();
    let object = Object::of_keys(node, &path, &allowed, faults)?.with(&KEYS);
    let over = object.given("over", faults).and_then(|(node, path)| {
        let rows = names(node, &path, "parameter", &parameters, faults)?;
        // A parameter of one law has its values in the blocks of this law.
        let count = |row: usize| scope.blocks.iter().filter(|block| block.gives(row)).count();
        let alike = |row: usize| [0, scope.blocks.len()].contains(&count(row));
        for (i, row) in rows.iter().enumerate() {
            if !scope.blocks.is_empty() && alike(*row) {
                refuse_constant(scope, *row, "a choice", node.item(&path, i), faults);
            }
        }
        Some(rows)
    });
    let free = free(&object, &keys, scope, faults);
    let neighbours = object.given("neighbours", faults).map(|(node, path)| {
        let rows = over.iter().flatten();
        let chosen: Vec<usize> = rows.copied().filter(|row| is_number(scope, *row)).collect();
        let allowed: Vec<&str> = chosen.iter().map(|row| parameters[*row]).collect();
        let places = names(node, &path, "number in over", &allowed, faults);
        places.map(|places| places.into_iter().map(|index| chosen[index]).collect())
    });
    let within = object.given(WITHIN, faults).map(|(node, path)| {
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
    (faults.count() == before).then_some(Recommend {
        over: over?,
        neighbours: neighbours.map_or(Some(Vec::new()), |rows| rows)?,
        free,
        within: within?,
    })
}

/// Whether the values of a parameter are numbers.
fn is_number(scope: &Scope, row: usize) -> bool {
    !matches!(
        scope.problem.parameters()[row].kind,
        parameter::Kind::Choice(_)
    )
}
