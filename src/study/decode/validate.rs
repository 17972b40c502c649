//! Rules across the parameters of a case, and the number of cases, checked before anything runs.

use crate::problem::parameter::Value;
use crate::problem::{Case, Problem, Violation};
use crate::study::axes::draft::Draft;
use crate::study::source::faults::Faults;
use crate::study::{Axis, Block, Group, Study};

/// Most raw combinations of a study, where nobody says otherwise.
pub const MOST_CASES: u64 = 1_000_000_000;

/// Blocks up to this size are checked case by case, larger ones at the ends of their axes.
const MOST_CHECKED: u64 = 1_000_000;

/// Blocks up to this size are looked at case by case where only the range of something is asked for.
const MOST_LISTED: u64 = 10_000;

/// Enough of one rule's faults: a long axis would repeat them a million times.
const MOST_TOLD: usize = 100;

/// Refuses more combinations than `limit`, without making any; false if there are too many.
pub(in crate::study) fn count(
    drafts: &[Draft],
    limit: u64,
    at: usize,
    path: &str,
    faults: &mut Faults,
) -> bool {
    let group = |draft: &Draft, members: &[usize]| {
        let given = members.first().map(|i| &draft.given[*i]);
        match (given, &draft.design) {
            (Some(given), Some(design)) if given.interval.is_some() => u128::from(design.points()),
            (Some(given), _) => given.values.len() as u128,
            (None, _) => 1,
        }
    };
    let block = |draft: &Draft| {
        let groups = draft.groups();
        let mut lens = groups.iter().map(|members| group(draft, members));
        lens.try_fold(1u128, u128::checked_mul)
    };
    let total = drafts
        .iter()
        .map(block)
        .try_fold(0u128, |sum, cases| sum.checked_add(cases?));
    let told = match total {
        Some(total) if total <= u128::from(limit) => return true,
        Some(total) => total.to_string(),
        None => "more than 10^38".into(),
    };
    let message = format!("{told} cases; allowed: at most {limit}; --limit sets another limit");
    faults.add(at, path, message);
    false
}

/// Reports every rule of the problem that a case of the block breaks, at the value it names.
pub(in crate::study) fn check(
    problem: &dyn Problem,
    draft: &Draft,
    block: &Block,
    faults: &mut Faults,
) {
    if apart(block)
        && broken(problem, draft, &sieved(block, &ends(block)))
            .next()
            .is_none()
    {
        return;
    }
    let places = if block.raw_len() <= MOST_CHECKED {
        every(block)
    } else {
        ends(block)
    };
    let lens: Vec<u64> = places.iter().map(|kept| kept.len() as u64).collect();
    let sieved = sieved(block, &places);
    let groups = draft.groups();
    let mut told = std::collections::HashSet::new();
    for (index, violations) in broken(problem, draft, &sieved) {
        for violation in violations {
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
            let given = draft.given.iter().position(|g| Some(g.parameter) == row);
            let group = groups
                .iter()
                .position(|members| members.iter().any(|m| Some(*m) == given));
            let (at, path) = match (given.map(|given| &draft.given[given]), group) {
                (Some(given), Some(group)) => {
                    let stride: u64 = lens[group + 1..].iter().product();
                    let place = places[group][(index / stride % lens[group]) as usize];
                    let path = match given.list {
                        true => format!("{}[{place}]", given.path),
                        false => given.path.clone(),
                    };
                    (given.values[place].1, path)
                }
                (Some(given), None) => (given.at, given.path.clone()),
                (None, _) => (draft.at, format!("{}.{}", draft.path, violation.parameter)),
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

/// The cases of a block that break rules.
fn broken(
    problem: &dyn Problem,
    draft: &Draft,
    block: &Block,
) -> impl Iterator<Item = (u64, Vec<Violation>)> {
    let mut case = Case::new(problem.schema());
    let cases = 0..block.raw_len().min(MOST_CHECKED);
    let kept = cases.filter(|index| block.keeps(problem, *index));
    let violations = kept.map(move |index| {
        block.put(problem, index, &mut case);
        for row in &draft.faulty {
            case.values[*row] = None;
        }
        (index, block.complete(problem, &mut case))
    });
    violations.filter(|(_, violations)| !violations.is_empty())
}

impl Study {
    /// Cases that stand for all where only the range of something is asked for: those at the ends of the axes, or every
    /// case of a small block whose axes are not apart.
    pub fn standing_for(&self) -> impl Iterator<Item = Case> + '_ {
        self.blocks.iter().flat_map(|block| {
            let places = match block.raw_len() <= MOST_LISTED && !apart(block) {
                true => every(block),
                false => ends(block),
            };
            let sieved = sieved(block, &places);
            let raws = 0..sieved.raw_len().min(MOST_CHECKED);
            let kept = raws.filter(|raw| sieved.keeps(&*self.problem, *raw));
            let cases = kept.map(|raw| sieved.completed(&*self.problem, raw));
            cases.collect::<Vec<_>>()
        })
    }
}

/// Whether the axes are apart from each other: then what is true at all their ends is true everywhere.
fn apart(block: &Block) -> bool {
    let alone = |group: &Group| group.axes.len() == 1;
    block.derived.is_empty() && block.when.is_none() && block.groups.iter().all(alone)
}

/// All places of every group.
fn every(block: &Block) -> Vec<Vec<usize>> {
    let all = |group: &Group| (0..group.len() as usize).collect();
    block.groups.iter().map(all).collect()
}

/// The places of the least and the greatest number of every axis, and of all names: where a rule that compares
/// parameters breaks anywhere, it breaks there.
fn ends(block: &Block) -> Vec<Vec<usize>> {
    let of_axis = |axis: &Axis| -> Vec<usize> {
        let numbers: Vec<f64> = axis.values.iter().filter_map(|v| v.as_f64()).collect();
        if numbers.len() < axis.values.len() {
            return first_of_each(&axis.values);
        }
        let by_size = |a: &usize, b: &usize| numbers[*a].total_cmp(&numbers[*b]);
        let least = (0..numbers.len()).min_by(by_size);
        let greatest = (0..numbers.len()).max_by(by_size);
        least.into_iter().chain(greatest).collect()
    };
    let of_group = |group: &Group| {
        let mut places: Vec<usize> = group.axes.iter().flat_map(of_axis).collect();
        places.sort_unstable();
        places.dedup();
        places
    };
    block.groups.iter().map(of_group).collect()
}

fn first_of_each(values: &[Value]) -> Vec<usize> {
    let positions = crate::study::cases::distinct(values.iter().copied());
    let first = |value: &Value| values.iter().position(|v| v == value);
    positions.iter().filter_map(first).collect()
}

/// The block with only some places of each group; what follows from them is computed anew.
fn sieved(block: &Block, places: &[Vec<usize>]) -> Block {
    let axis = |axis: &Axis, kept: &[usize]| Axis {
        parameter: axis.parameter,
        values: kept.iter().map(|place| axis.values[*place]).collect(),
    };
    let groups = block.groups.iter().zip(places).map(|(group, kept)| Group {
        axes: group.axes.iter().map(|a| axis(a, kept)).collect(),
    });
    let mut sieved = Block {
        groups: groups.collect(),
        derived: block.derived.clone(),
        when: block.when.clone(),
        ..Block::default()
    };
    let whole = block
        .groups
        .iter()
        .zip(&sieved.groups)
        .all(|(a, b)| a.len() == b.len());
    if !whole {
        let rules = sieved.derived.iter_mut().map(|d| &mut d.rule);
        for rule in rules.chain(sieved.when.iter_mut().map(|w| &mut w.rule)) {
            rule.table = None;
        }
    }
    sieved
}
