//! Rules across the parameters of a case, and the number of cases, checked before anything runs.

use super::parameters::Draft;
use super::report::Faults;
use super::{Axis, Block};
use crate::problem::Problem;
use crate::problem::parameter::Value;

/// Most cases of one study.
const MOST_CASES: u128 = 1_000_000_000;

/// Blocks up to this size are checked case by case, larger ones at the ends of their axes.
const MOST_CHECKED: u64 = 1_000_000;

/// Enough of one rule's faults: a long axis would repeat them a million times.
const MOST_TOLD: usize = 100;

/// Refuses more cases than can be run, without making any; false if there are too many.
pub(super) fn count(drafts: &[Draft], at: usize, path: &str, faults: &mut Faults) -> bool {
    let block = |draft: &Draft| {
        let mut lens = draft.given.iter().map(|given| given.values.len() as u128);
        lens.try_fold(1u128, u128::checked_mul)
    };
    let total = drafts
        .iter()
        .map(block)
        .try_fold(0u128, |sum, cases| sum.checked_add(cases?));
    let told = match total {
        Some(total) if total <= MOST_CASES => return true,
        Some(total) => total.to_string(),
        None => "more than 10^38".into(),
    };
    let message = format!("{told} cases; allowed: at most {MOST_CASES}");
    faults.add(at, path, message);
    false
}

/// Reports every rule of the problem that a case of the block breaks, at the value it names.
pub(super) fn check(problem: &dyn Problem, draft: &Draft, faults: &mut Faults) {
    let block = draft.block();
    let places = if block.len() <= MOST_CHECKED {
        every(&block)
    } else {
        ends(&block)
    };
    let lens: Vec<u64> = places.iter().map(|kept| kept.len() as u64).collect();
    let sieved = sieved(&block, &places);
    let mut told = std::collections::HashSet::new();
    for index in 0..sieved.len().min(MOST_CHECKED) {
        let mut case = sieved.case(problem, index);
        for row in &draft.faulty {
            case.values[*row] = None;
        }
        for violation in problem.complete(&mut case) {
            let row = problem
                .parameters()
                .iter()
                .position(|p| p.name == violation.parameter);
            // What is faulty itself has been told, and may be what another seems to lack.
            let told_already = row.is_some_and(|row| draft.faulty.contains(&row));
            let lacks = violation.message.starts_with("missing") && !draft.faulty.is_empty();
            if told_already || lacks {
                continue;
            }
            let axis = block.axes.iter().position(|a| Some(a.parameter) == row);
            let (at, path) = match axis {
                Some(axis) => {
                    let stride: u64 = lens[axis + 1..].iter().product();
                    let place = places[axis][(index / stride % lens[axis]) as usize];
                    let given = &draft.given[axis];
                    let path = match given.list {
                        true => format!("{}[{place}]", given.path),
                        false => given.path.clone(),
                    };
                    (given.values[place].1, path)
                }
                None => (draft.at, format!("{}.{}", draft.path, violation.parameter)),
            };
            if told.insert((at, violation.message.clone())) {
                faults.add(at, &path, violation.message);
            }
        }
        if told.len() >= MOST_TOLD {
            return;
        }
    }
}

/// All positions of every axis.
fn every(block: &Block) -> Vec<Vec<usize>> {
    let all = |axis: &Axis| (0..axis.values.len()).collect();
    block.axes.iter().map(all).collect()
}

/// The positions of the least and the greatest number of every axis, and all names: where a rule that compares
/// parameters breaks anywhere, it breaks there.
fn ends(block: &Block) -> Vec<Vec<usize>> {
    let ends = |axis: &Axis| -> Vec<usize> {
        let numbers: Vec<f64> = axis.values.iter().filter_map(|v| v.as_f64()).collect();
        if numbers.len() < axis.values.len() {
            return first_of_each(&axis.values);
        }
        let by_size = |a: &usize, b: &usize| numbers[*a].total_cmp(&numbers[*b]);
        let least = (0..numbers.len()).min_by(by_size);
        let greatest = (0..numbers.len()).max_by(by_size);
        let mut ends: Vec<usize> = least.into_iter().chain(greatest).collect();
        ends.dedup();
        ends
    };
    block.axes.iter().map(ends).collect()
}

fn first_of_each(values: &[Value]) -> Vec<usize> {
    let positions = super::cases::distinct(values.iter().copied());
    let first = |value: &Value| values.iter().position(|v| v == value);
    positions.iter().filter_map(first).collect()
}

/// The block with only some positions of each axis.
fn sieved(block: &Block, places: &[Vec<usize>]) -> Block {
    let axes = block.axes.iter().zip(places).map(|(axis, kept)| Axis {
        parameter: axis.parameter,
        values: kept.iter().map(|place| axis.values[*place]).collect(),
    });
    let axes = axes.collect();
    Block { axes }
}
