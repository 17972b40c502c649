//! A block of cases. Each case is made from its number, so that 10^9 cases need no more memory than ten.

use crate::axis::design::Design;
use crate::axis::group::{Axis, AxisGroup};
use crate::formulas::derived::{Condition, Derived};
use slipgap_problem::problem::numbers::parameter::{Default, Parameter, Value};
use slipgap_problem::problem::{Case, Problem};
use std::ops::Range;
use std::sync::OnceLock;

/// A block: all combinations of its groups of axes in file order, the last group fastest; the derived parameters; and the
/// condition that selects the cases among the combinations.
#[derive(Debug, Clone, std::default::Default)]
pub struct Block {
    /// The axes of all parameters that have values. A single value is an axis of length 1.
    pub groups: Vec<AxisGroup>,
    /// Parameters given by expressions. Each comes after those in its expression.
    pub derived: Vec<Derived>,
    /// The condition that a combination must meet to be a case.
    pub when: Option<Condition>,
    /// The design that gives the values of one group.
    pub design: Option<Design>,
    /// Numbers of cases, counted at the first use.
    pub(crate) counts: OnceLock<CaseCounts>,
    /// The values that all combinations share, found at the first use.
    pub(crate) shared: OnceLock<Option<Shared>>,
}

/// Numbers of cases of a block with a condition.
#[derive(Debug, Clone)]
pub(crate) enum CaseCounts {
    /// For a condition with a table: how many of the entries before each one meet it, and how many in all. No combination
    /// has to be made.
    Tabled(Vec<u64>),
    /// Otherwise the number of cases before every `STRIDE`-th combination, and at the end.
    Counted {
        counts: Vec<u64>,
        /// The first combination for which the condition has no value.
        undecided: Option<u64>,
    },
}

/// The values that all combinations of a block share, and the groups that vary.
#[derive(Debug, Clone)]
pub(crate) struct Shared {
    values: Vec<Option<Value>>,
    varying: Vec<usize>,
    /// See [`Block::is_complete`].
    complete: bool,
}

impl Block {
    /// All combinations of these groups.
    pub fn of(groups: Vec<AxisGroup>) -> Block {
        Block {
            groups,
            ..Block::default()
        }
    }

    /// All axes.
    pub fn axes(&self) -> impl Iterator<Item = &Axis> {
        self.groups.iter().flat_map(|group| &group.axes)
    }

    /// Number of raw combinations.
    pub fn raw_len(&self) -> u64 {
        self.groups.iter().map(AxisGroup::len).product()
    }

    /// The position in each group of combination `raw`.
    pub fn positions(&self, raw: u64) -> Vec<u64> {
        let mut positions = vec![0; self.groups.len()];
        let mut rest = raw;
        for (position, group) in positions.iter_mut().zip(&self.groups).rev() {
            *position = rest % group.len();
            rest /= group.len();
        }
        positions
    }

    /// Combination `raw` with the defaults, before `Problem::complete`.
    pub fn raw_case(&self, problem: &dyn Problem, raw: u64) -> Case {
        let mut case = Case::new(problem.schema());
        self.put(problem, raw, &mut case);
        case
    }

    /// The same, written over `case`.
    pub fn put(&self, problem: &dyn Problem, raw: u64, case: &mut Case) {
        let Some(shared) = self.shared.get_or_init(|| self.shared(problem)) else {
            case.values.fill(None);
            self.fill(case, &self.positions(raw), self.derived.len());
            return;
        };
        case.values.copy_from_slice(&shared.values);
        let mut rest = raw;
        let varying = shared.varying.iter().rev();
        for group in varying.map(|group| &self.groups[*group]) {
            for axis in &group.axes {
                case.values[axis.parameter] = Some(axis.values.at((rest % group.len()) as usize));
            }
            rest /= group.len();
        }
    }

    /// The values of the parameters that all completed combinations share, and the rows of the others.
    pub fn alike(&self, problem: &dyn Problem) -> (Vec<Option<Value>>, Vec<usize>) {
        let table = problem.parameters();
        let Some(shared) = self.shared.get_or_init(|| self.shared(problem)) else {
            return (vec![None; table.len()], (0..table.len()).collect());
        };
        let varies = |row: usize| {
            let mut groups = shared.varying.iter().map(|group| &self.groups[*group]);
            groups.any(|group| group.has(row))
        };
        // The problem fills in what follows from other parameters.
        let follows = |row: usize| matches!(table[row].default, Default::Follows(_));
        let changing = (0..table.len()).filter(|row| varies(*row) || follows(*row));
        (shared.values.clone(), changing.collect())
    }

    /// Whether the axes are independent of each other. A rule that holds at all their ends then holds everywhere.
    pub fn is_independent(&self) -> bool {
        let single = |group: &AxisGroup| group.axes.len() == 1;
        self.derived.is_empty() && self.when.is_none() && self.groups.iter().all(single)
    }

    /// Whether all combinations are cases that break no rule, and no value follows from others.
    pub fn is_complete(&self, problem: &dyn Problem) -> bool {
        let shared = self.shared.get_or_init(|| self.shared(problem));
        shared.as_ref().is_some_and(|shared| shared.complete)
    }

    /// The parameters that vary in the block, as rows, with their values in these combinations and how many of these have each value one
    /// after the other.
    pub fn runs(
        &self,
        raws: Range<u64>,
    ) -> impl Iterator<Item = (usize, impl Iterator<Item = (Value, usize)>)> {
        let varying = self
            .groups
            .iter()
            .zip(1..)
            .filter(|group| group.0.len() > 1);
        varying.flat_map(move |(group, after)| {
            let each: u64 = self.groups[after..].iter().map(AxisGroup::len).product();
            let (start, length) = (raws.start, raws.end - raws.start);
            group.axes.iter().map(move |axis| {
                let (len, mut rest) = (axis.values.len(), length);
                let mut position = (start / each) as usize % len;
                let mut left = each - start % each;
                let run = move || {
                    let count = left.min(rest);
                    let value = (count > 0).then(|| axis.values.at(position))?;
                    (left, rest) = (each, rest - count);
                    position = if position + 1 == len { 0 } else { position + 1 };
                    Some((value, count as usize))
                };
                (axis.parameter, std::iter::from_fn(run))
            })
        })
    }

    /// The values that all combinations share; `None` for a block with expressions, or with an axis of names that decide
    /// which other parameters apply.
    fn shared(&self, problem: &dyn Problem) -> Option<Shared> {
        let table = problem.parameters();
        let varying: Vec<usize> = (0..self.groups.len())
            .filter(|g| self.groups[*g].len() > 1)
            .collect();
        let governs = |axis: &Axis| {
            let name = &table[axis.parameter].name;
            let mut conditions = table.iter().filter_map(|p| p.applies.as_ref());
            conditions.any(|on| on.governor == name)
        };
        let axes = |group: &usize| self.groups[*group].axes.iter();
        if !self.derived.is_empty() || varying.iter().flat_map(axes).any(governs) {
            return None;
        }
        let mut case = Case::new(problem.schema());
        self.fill(&mut case, &vec![0; self.groups.len()], 0);
        let follows = |p: &Parameter| matches!(p.default, Default::Follows(_));
        Some(Shared {
            values: case.values,
            varying,
            // The rules of a structure have expressions, which can have any value between the ends of an axis.
            complete: self.is_independent()
                && !problem.schema().described
                && !table.iter().any(follows),
        })
    }

    /// Sets the values at these positions of the groups, the defaults, and the first `derived` of the derived parameters.
    pub fn fill(&self, case: &mut Case, positions: &[u64], derived: usize) {
        for (group, position) in self.groups.iter().zip(positions) {
            for axis in &group.axes {
                case.values[axis.parameter] = Some(axis.values.at(*position as usize));
            }
        }
        drop_unsuitable(case);
        for row in 0..case.schema.parameters.len() {
            if case.values[row].is_none() && self.derived.iter().all(|d| d.parameter != row) {
                case.values[row] = case.default_at(row);
            }
        }
        for derived in self.derived.iter().take(derived) {
            case.values[derived.parameter] = derived.value(&self.groups, case, positions);
        }
        if derived > 0 {
            drop_unsuitable(case);
        }
    }
}

/// Removes values of parameters that do not apply to the names of a case: a block with several laws may give a parameter of some of
/// them.
fn drop_unsuitable(case: &mut Case) {
    let schema = case.schema.clone();
    let chosen = |case: &Case, governor: &str| {
        let row = schema.parameters.iter().position(|p| p.name == *governor);
        let value = row.and_then(|row| case.values[row].or_else(|| case.default_at(row)));
        value.map_or("", Value::name)
    };
    for (row, parameter) in schema.parameters.iter().enumerate() {
        if let Some(on) = &parameter.applies
            && case.values[row].is_some()
            && !on.allows(chosen(case, on.governor))
        {
            case.values[row] = None;
        }
    }
}
