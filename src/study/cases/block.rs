//! A block of cases, made one at a time from their numbers: 10^9 of them take no more memory than ten.

use std::sync::OnceLock;

use super::counts::Kept;
use super::derived::{Condition, Derived};
use super::design::Design;
use crate::problem::parameter::Value;
use crate::problem::{Case, Problem};

/// A block: the product of its groups of axes in file order, the last one fastest; what follows from them; and which of
/// these raw combinations are cases.
#[derive(Debug, Clone, Default)]
pub struct Block {
    /// Every parameter that has values of its own, a single value being an axis of one.
    pub groups: Vec<Group>,
    /// Parameters given by expressions, each after those it names.
    pub derived: Vec<Derived>,
    /// What a combination must meet to be a case.
    pub when: Option<Condition>,
    /// Where the values of one group come from, if from a design.
    pub design: Option<Design>,
    /// Which combinations are cases; counted when first asked for.
    pub(in crate::study) kept: OnceLock<Kept>,
    /// What all raw combinations share; found when the first is made.
    pub(in crate::study) shared: OnceLock<Option<Shared>>,
}

/// The values that all combinations of a block have, and the groups that make the difference.
#[derive(Debug, Clone)]
pub(in crate::study) struct Shared {
    values: Vec<Option<Value>>,
    varying: Vec<usize>,
}

/// Axes that advance together.
#[derive(Debug, Clone)]
pub struct Group {
    /// At least one, all of one length.
    pub axes: Vec<Axis>,
}

/// The values of one parameter.
#[derive(Debug, Clone)]
pub struct Axis {
    /// Row of `problem.parameters()`.
    pub parameter: usize,
    /// At least one value.
    pub values: Vec<Value>,
}

impl Group {
    /// Number of values.
    pub fn len(&self) -> u64 {
        self.axes.first().map_or(0, |axis| axis.values.len() as u64)
    }

    /// Whether there are no values, which no study that was read allows.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl Block {
    /// All axes.
    pub fn axes(&self) -> impl Iterator<Item = &Axis> {
        self.groups.iter().flat_map(|group| &group.axes)
    }

    /// Number of raw combinations.
    pub fn raw_len(&self) -> u64 {
        self.groups.iter().map(Group::len).product()
    }

    /// Place of each group in combination `raw`.
    pub(in crate::study) fn digits(&self, raw: u64) -> Vec<u64> {
        let mut digits = vec![0; self.groups.len()];
        let mut rest = raw;
        for (digit, group) in digits.iter_mut().zip(&self.groups).rev() {
            *digit = rest % group.len();
            rest /= group.len();
        }
        digits
    }

    /// Combination `raw` with what it leaves out at its default, but before `Problem::complete`.
    pub(in crate::study) fn raw_case(&self, problem: &dyn Problem, raw: u64) -> Case {
        let mut case = Case::new(problem.schema());
        self.put(problem, raw, &mut case);
        case
    }

    /// The same in place of another case.
    pub(in crate::study) fn put(&self, problem: &dyn Problem, raw: u64, case: &mut Case) {
        let Some(shared) = self.shared.get_or_init(|| self.shared(problem)) else {
            case.values.fill(None);
            self.fill(case, &self.digits(raw), self.derived.len());
            return;
        };
        case.values.copy_from_slice(&shared.values);
        let mut rest = raw;
        for group in shared
            .varying
            .iter()
            .rev()
            .map(|group| &self.groups[*group])
        {
            for axis in &group.axes {
                case.values[axis.parameter] = Some(axis.values[(rest % group.len()) as usize]);
            }
            rest /= group.len();
        }
    }

    /// What all combinations share; `None` where expressions or names that bring other parameters take part.
    fn shared(&self, problem: &dyn Problem) -> Option<Shared> {
        let table = problem.parameters();
        let varying: Vec<usize> = (0..self.groups.len())
            .filter(|g| self.groups[*g].len() > 1)
            .collect();
        let governs = |axis: &Axis| {
            let name = &table[axis.parameter].name;
            table.iter().any(|p| {
                p.applies
                    .as_ref()
                    .is_some_and(|(governor, _)| governor == name)
            })
        };
        let axes = |group: &usize| self.groups[*group].axes.iter();
        if !self.derived.is_empty() || varying.iter().flat_map(axes).any(governs) {
            return None;
        }
        let mut case = Case::new(problem.schema());
        self.fill(&mut case, &vec![0; self.groups.len()], 0);
        Some(Shared {
            values: case.values,
            varying,
        })
    }

    /// Sets what stands at these places of the groups, defaults, and the first of the derived parameters.
    pub(in crate::study) fn fill(&self, case: &mut Case, digits: &[u64], derived: usize) {
        for (group, digit) in self.groups.iter().zip(digits) {
            for axis in &group.axes {
                case.values[axis.parameter] = Some(axis.values[*digit as usize]);
            }
        }
        for row in 0..case.schema.parameters.len() {
            if case.values[row].is_none() && self.derived.iter().all(|d| d.parameter != row) {
                case.values[row] = case.default_at(row);
            }
        }
        for derived in self.derived.iter().take(derived) {
            case.values[derived.parameter] = derived.value(self, case, digits);
        }
    }

    /// The same as `raw_case`, with the values that follow from others. The rules that it breaks are named where it is
    /// solved, see `Study::columns`.
    pub(in crate::study) fn completed(&self, problem: &dyn Problem, raw: u64) -> Case {
        let mut case = self.raw_case(problem, raw);
        let _ = self.complete(problem, &mut case);
        case
    }
}
