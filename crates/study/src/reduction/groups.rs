//! The values of reductions, collected case by case.

use super::{Operator, Reduction};
use slipgap_cases::alike;
use slipgap_problem::problem::Case;

/// Groups of cases that reductions of the same parameters take together, in the order of their first cases.
#[derive(Debug)]
pub struct Groups<'a> {
    reductions: Vec<&'a Reduction>,
    places: alike::Groups,
    groups: Vec<Group>,
}

/// A group of cases.
#[derive(Debug)]
struct Group {
    first: u64,
    cases: u64,
    /// One for each reduction.
    values: Vec<Values>,
}

/// The values of a metric in a group, as far as its operator needs them.
#[derive(Debug)]
enum Values {
    /// Case and value of the preferred one, and the number of values.
    One(Option<(u64, f64)>, u64),
    All(Vec<f64>),
}

/// The value of a reduction in a group.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reduced {
    /// Number of the first case of the group.
    pub first: u64,
    /// Number of cases.
    pub cases: u64,
    /// How many of them have no value.
    pub empty: u64,
    /// The value of the others; `None` if no case has one.
    pub value: Option<f64>,
    /// The first case with this value, for operators that are the value of a case.
    pub at: Option<u64>,
}

impl<'a> Groups<'a> {
    /// No cases yet; the reductions group alike.
    pub fn new(reductions: Vec<&'a Reduction>) -> Groups<'a> {
        let kept = reductions.first().map_or(&[][..], |first| &first.kept);
        Groups {
            places: alike::Groups::new(kept),
            reductions,
            groups: Vec::new(),
        }
    }

    /// The reductions.
    pub fn reductions(&self) -> &[&'a Reduction] {
        &self.reductions
    }

    /// Adds a case; `value` gives its metrics by their rows of the measures. It returns the place of its group, and whether
    /// the group is new.
    pub fn add(
        &mut self,
        number: u64,
        case: &Case,
        value: impl Fn(usize) -> Option<f64>,
    ) -> (usize, bool) {
        let (index, is_new) = self.places.place(case);
        if is_new {
            let empty = |reduction: &&Reduction| match reduction.operator.is_of_a_case() {
                true => Values::One(None, 0),
                false => Values::All(Vec::new()),
            };
            self.groups.push(Group {
                first: number,
                cases: 0,
                values: self.reductions.iter().map(empty).collect(),
            });
        }
        let group = &mut self.groups[index];
        group.cases += 1;
        for (values, reduction) in group.values.iter_mut().zip(&self.reductions) {
            if let Some(x) = value(reduction.of).filter(|x| x.is_finite()) {
                values.add(reduction.operator, number, x);
            }
        }
        (index, is_new)
    }

    /// The value of reduction `which` in every group.
    pub fn values(&self, which: usize) -> impl Iterator<Item = Reduced> {
        self.groups.iter().map(move |group| {
            let (value, at, count) = match &group.values[which] {
                Values::One(one, count) => (one.map(|one| one.1), one.map(|one| one.0), *count),
                Values::All(numbers) => {
                    let value = self.reductions[which].operator.of(numbers);
                    (value, None, numbers.len() as u64)
                }
            };
            Reduced {
                first: group.first,
                cases: group.cases,
                empty: group.cases - count,
                value,
                at,
            }
        })
    }
}

impl Values {
    fn add(&mut self, operator: Operator, number: u64, x: f64) {
        match self {
            Values::One(one, count) => {
                *count += 1;
                if one.is_none_or(|(_, before)| operator.prefers(x, before)) {
                    *one = Some((number, x));
                }
            }
            Values::All(numbers) => numbers.push(x),
        }
    }
}
