//! The names that figures, checks and claims may use: the tables of the problem, and the cases of the study.

use crate::Measure;
use crate::source::faults::{Faults, join, quoted};
use crate::source::object::Object;
use crate::source::tree::{Member, Node};
use crate::value::{name, value};
use slipgap_cases::{Block, Enumeration, Filter, Selected};
use slipgap_problem::problem::numbers::parameter::{Default, Value};
use slipgap_problem::problem::structure::StructureProblem;
use slipgap_problem::problem::{Case, Problem};
use std::sync::Arc;

/// Most combinations that are tested to find the cases that a filter selects. This takes some seconds; the cases of a figure
/// are in memory together.
const MOST_TRIED: u64 = 10_000_000;

/// The problem of a study and its blocks.
pub struct Scope {
    /// The problem.
    pub problem: Arc<dyn Problem>,
    /// Metrics, also in the units of the study.
    pub measures: Vec<Measure>,
    /// Empty if a block is faulty. The cases that a filter selects are then not tested.
    pub blocks: Vec<Block>,
    /// Parameters over which the cases are an ensemble; `None` without one, empty if the key has a fault.
    pub ensemble: Option<Vec<usize>>,
    /// Whether each step is solved once; there are then no profiles.
    pub once: bool,
    /// Rows of `measures` that have checks.
    pub checked: Vec<usize>,
    /// The parameters that the command line sets, each with the name of its setting.
    pub set: Vec<[String; 2]>,
}

impl Scope {
    /// The names of all parameters.
    pub fn parameters(&self) -> Vec<&str> {
        self.problem.parameters().iter().map(|p| &*p.name).collect()
    }

    /// The names of the quantities along the structure.
    pub fn profiles(&self) -> Vec<&str> {
        self.problem
            .schema()
            .profiles
            .iter()
            .map(|p| &*p.name)
            .collect()
    }

    /// The names of the measures that are computed after all cases.
    pub fn later(&self) -> Vec<&str> {
        self.problem
            .schema()
            .later
            .iter()
            .map(|name| &**name)
            .collect()
    }

    /// The names of all measures.
    pub fn metrics(&self) -> Vec<&str> {
        self.measures.iter().map(|m| m.name.as_str()).collect()
    }

    /// Whether the study has results in units.
    pub fn has_units(&self) -> bool {
        self.measures.iter().any(|m| m.dimension.is_some())
    }

    /// Whether the ground motions are a set.
    pub fn has_set(&self) -> bool {
        let structure = self.problem.as_structure();
        structure.is_some_and(StructureProblem::has_set)
    }

    /// Decodes a `where`. A filter that selects no case is a fault.
    pub fn filter(&self, node: &Node, path: &str, faults: &mut Faults) -> Option<Filter> {
        let table = self.problem.parameters();
        let before = faults.count();
        let object = Object::of_keys(node, path, &self.parameters(), faults)?;
        let mut terms = Vec::new();
        for member in &object.members {
            let Some(row) = table.iter().position(|p| p.name == member.key) else {
                continue;
            };
            let path = object.path(&member.key);
            if let Some(inner) = member.node.object() {
                let dotted = |inner: &Member| format!("{}.{}", member.key, inner.key);
                let known = |key: &String| self.parameters().contains(&key.as_str());
                if let Some(key) = inner.iter().map(dotted).find(known) {
                    let dotted = quoted(&key);
                    let message = format!("must be a value; write {dotted} as one key");
                    faults.add(member.node.at, &path, message);
                    continue;
                }
            }
            let wanted = self.wanted(&member.node, &path, row, faults);
            terms.extend(wanted.map(|wanted| (row, wanted)));
        }
        if faults.count() > before {
            return None;
        }
        let filter = Filter(terms);
        let selects = |block: &Block| {
            let mut selected = block.select_among(MOST_TRIED, &*self.problem, &filter);
            selected.next().is_some()
        };
        if self.blocks.is_empty() || self.blocks.iter().any(selects) {
            return Some(filter);
        }
        object.fault(self.no_case(&filter), faults);
        None
    }

    /// Reports a figure with so many combinations that selecting its cases would take very long; false if it is one.
    pub fn countable(&self, filter: &Filter, at: usize, path: &str, faults: &mut Faults) -> bool {
        let blocks = self.blocks.iter();
        let count = blocks.fold(0u64, |sum, block| {
            sum.saturating_add(block.candidates(filter))
        });
        if count > MOST_TRIED {
            let message = format!(
                "chooses among {count} combinations; allowed: at most {MOST_TRIED}; narrow the cases with \"where\""
            );
            faults.add(at, &join(path, "where"), message);
        }
        count <= MOST_TRIED
    }

    /// A value of a parameter or a list of values. Every value of a list must occur in a case.
    fn wanted(
        &self,
        node: &Node,
        path: &str,
        row: usize,
        faults: &mut Faults,
    ) -> Option<Vec<Value>> {
        let parameter = &self.problem.parameters()[row];
        let Some(items) = node.list() else {
            return value(node, path, parameter, faults).map(|value| vec![value]);
        };
        if items.is_empty() {
            faults.must_be(node, path, "a value or a non-empty list");
            return None;
        }
        let before = faults.count();
        let mut wanted = Vec::new();
        for (i, item) in items.iter().enumerate() {
            let path = format!("{path}[{i}]");
            let Some(value) = value(item, &path, parameter, faults) else {
                continue;
            };
            if let Some(message) = self.absent(row, value) {
                faults.add(item.at, &path, message);
            }
            wanted.push(value);
        }
        (faults.count() == before).then_some(wanted)
    }

    /// The message that no case has a value of a parameter, with the values that cases have; `None` if a case has it or the
    /// values are unknown.
    fn absent(&self, row: usize, wanted: Value) -> Option<String> {
        if self.too_many() {
            return None;
        }
        let levels = self.levels(&Filter::default(), row);
        if levels.is_empty() || wanted.is_one_of(&levels) {
            return None;
        }
        let parameter = &self.problem.parameters()[row].name;
        let mut shown: Vec<String> = levels.iter().take(10).map(Value::to_string).collect();
        if levels.len() > shown.len() {
            shown.push("...".into());
        }
        let shown = shown.join(", ");
        let mut set = self.set.iter();
        let by = match set.find(|[name, _]| **name == **parameter) {
            Some([_, setting]) => format!(", by --set {setting}"),
            None => String::new(),
        };
        Some(format!(
            "no case has {parameter} = {wanted}; the values are {shown}{by}"
        ))
    }

    /// Whether a block has so many combinations that testing all of them would take very long.
    fn too_many(&self) -> bool {
        let no_filter = Filter::default();
        let mut blocks = self.blocks.iter();
        blocks.any(|block| block.candidates(&no_filter) > MOST_TRIED)
    }

    /// The message that a filter selects no case, with the value that no case has, if that is the reason.
    fn no_case(&self, filter: &Filter) -> String {
        if self.too_many() {
            return format!(
                "no case among the first {MOST_TRIED} possible combinations has all these values"
            );
        }
        let single = filter.0.iter().filter(|(_, wanted)| wanted.len() == 1);
        let mut absent = single.filter_map(|(row, wanted)| self.absent(*row, wanted[0]));
        absent
            .next()
            .unwrap_or_else(|| "no case has all these values".into())
    }

    fn enumeration(&self) -> Enumeration<'_> {
        Enumeration {
            problem: &*self.problem,
            blocks: &self.blocks,
        }
    }

    /// The numbers of the cases of a filter.
    pub fn select<'a>(&'a self, filter: &'a Filter) -> Selected<'a, u64> {
        self.enumeration().select(filter)
    }

    /// The cases that a filter selects.
    pub fn cases<'a>(&'a self, filter: &'a Filter) -> Selected<'a, Case> {
        self.enumeration().cases(filter)
    }

    /// Whether the parameters in `from` decide a parameter, in every block with cases that a filter selects.
    pub fn follows(&self, filter: &Filter, parameter: usize, from: &[usize]) -> bool {
        let selected = |block: &&Block| block.select(&*self.problem, filter).next().is_some();
        let table = self.problem.parameters();
        let described = &table[parameter];
        let has_default = matches!(described.default, Default::Is(_));
        // Whether no case of a block has a name that the parameter applies to.
        let unsuitable = |block: &Block| {
            described.applies.as_ref().is_some_and(|on| {
                let row = table.iter().position(|p| p.name == on.governor);
                let levels = row.map(|row| block.levels(&*self.problem, filter, row));
                let mut names = levels.iter().flatten();
                names.all(|name| !on.allows(name.name()))
            })
        };
        // Such a block has no value of it, nor a block that does not give a parameter without default.
        let lacks = |block: &Block| !block.gives(parameter) && (!has_default || unsuitable(block));
        let mut blocks = self.blocks.iter().filter(selected);
        blocks.all(|block| lacks(block) || block.follows(filter, parameter, from))
    }

    /// The different values of a parameter among the cases that a filter selects.
    pub fn levels(&self, filter: &Filter, parameter: usize) -> Vec<Value> {
        self.enumeration().levels(filter, parameter)
    }
}

/// A name or a list of different names, as indices of those allowed.
pub fn names(
    node: &Node,
    path: &str,
    what: &str,
    allowed: &[&str],
    faults: &mut Faults,
) -> Option<Vec<usize>> {
    let Some(items) = node.list() else {
        return name(node, path, what, allowed, faults).map(|row| vec![row]);
    };
    if items.is_empty() {
        faults.must_be(
            node,
            path,
            &format!("the name of a {what} or a non-empty list of names"),
        );
        return None;
    }
    let before = faults.count();
    let mut rows = Vec::new();
    for (i, item) in items.iter().enumerate() {
        let path = format!("{path}[{i}]");
        let Some(row) = name(item, &path, what, allowed, faults) else {
            continue;
        };
        if rows.contains(&row) {
            faults.add(
                item.at,
                &path,
                format!("{} given twice", quoted(allowed[row])),
            );
        } else {
            rows.push(row);
        }
    }
    (faults.count() == before).then_some(rows)
}
