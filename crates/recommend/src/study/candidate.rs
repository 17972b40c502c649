//! The candidates of a study: each has its cost, its largest errors over the physical cases, and what becomes of it.

use super::judge::{Judge, Judged, all_of};
use super::usage::used;
use super::verdict::{State, Trial};
use crate::calibrate::{Objective, Options, Stopped, search};
use crate::{EnergyChange, cost, sub_steps};
use slipgap_motion::solve::{WARNINGS, Warning, Warnings};
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_problem::problem::table::cases::Cases;
use slipgap_problem::problem::{Case, Problem};
use slipgap_study::{Alternative, Free};
use std::cmp::Ordering;
use std::collections::HashSet;

/// Cases of the search of free parameters, for each candidate.
const CASES: u64 = 4000;

/// A candidate.
#[derive(Debug)]
pub struct Choice {
    /// Its cases.
    pub alternative: Alternative,
    /// The chosen parameters that it has and its free ones, with their values.
    pub values: Vec<(usize, Value)>,
    /// Cost of all its cases.
    pub cost: u64,
    /// The largest error of each metric over the physical cases.
    pub errors: Vec<f64>,
    /// The largest changes of energy.
    pub energy: EnergyChange,
    /// What `run` warns of in its cases; without notes.
    pub warnings: Warnings,
    /// The largest quotient of error and tolerance.
    pub worst: f64,
    /// What becomes of it.
    pub state: State,
    /// What further tests show, if it was tested.
    pub trial: Option<Trial>,
    /// Its free parameters.
    free: Vec<Free>,
    /// Its smallest step.
    step: f64,
    /// Number of its modes or nodes.
    pub(super) size: u64,
    /// Number of its physical cases.
    conditions: usize,
}

/// A candidate, not yet solved. The judge then knows its physical cases.
pub(super) fn choice(alternative: Alternative, judge: &mut Judge) -> Choice {
    let study = judge.study;
    let within: Vec<usize> = judge
        .recommend
        .within
        .iter()
        .map(|metric| metric.0)
        .collect();
    let cases = all_of(&study.point_cases(&alternative, &[]).cases(&[Vec::new()]));
    let mut conditions = HashSet::new();
    for case in &cases {
        let condition = judge.condition(case);
        judge.conditions.insert(condition.clone());
        conditions.insert(condition);
    }
    let problem = &*study.problem;
    let free = study.free_of_candidate(&alternative);
    let [free, _] = used(study, &alternative, &free, &within);
    let over = judge.recommend.over.iter();
    let value = |row: &usize| Some((*row, cases.first()?.values[*row]?));
    let step = cases
        .iter()
        .filter_map(|case| case.at(problem.schema().step));
    Choice {
        values: over.filter_map(value).collect(),
        cost: cases.iter().map(|case| cost(problem, case)).sum(),
        errors: Vec::new(),
        energy: EnergyChange::UNKNOWN,
        warnings: Warnings::NONE,
        worst: f64::INFINITY,
        state: State::Incomplete,
        trial: None,
        step: step.fold(f64::INFINITY, f64::min),
        size: cases.first().map_or(0, |case| size(problem, case)),
        conditions: conditions.len(),
        free,
        alternative,
    }
}

/// Number of modes or nodes of a case, which a finer mesh has more of.
pub(super) fn size(problem: &dyn Problem, case: &Case) -> u64 {
    cost(problem, case) / (case.steps() * sub_steps(case)).max(1)
}

impl Choice {
    /// Whether it has all physical cases.
    pub(super) fn is_whole(&self, judge: &Judge) -> bool {
        self.conditions == judge.conditions.len()
    }

    /// The value of a parameter that it has.
    pub fn value(&self, row: usize) -> Option<Value> {
        let found = self.values.iter().find(|(known, _)| *known == row);
        found.map(|(_, value)| *value)
    }

    /// The same as a number.
    pub(super) fn number(&self, row: usize) -> Option<f64> {
        self.value(row).and_then(Value::as_f64)
    }

    /// Its cases, at these values of some free parameters.
    pub(super) fn cases(&self, judge: &Judge, free: &[Free], values: &[f64]) -> Cases {
        let cases = judge.study.point_cases(&self.alternative, free);
        cases.cases_with(&[values.to_vec()])
    }

    /// Its free parameters, each with its best value.
    pub(super) fn free(&self) -> (&[Free], Vec<f64>) {
        let value = |free: &Free| self.number(free.parameter).unwrap_or(f64::NAN);
        (&self.free, self.free.iter().map(value).collect())
    }

    /// The one chosen number in which both differ; `None` if they differ in a name or in several.
    pub(super) fn differing(&self, other: &Choice) -> Option<usize> {
        let is_free = |row: usize| self.free.iter().any(|free| free.parameter == row);
        let chosen = |of: &Choice| -> Vec<(usize, Value)> {
            let fixed = of.values.iter().filter(|pair| !is_free(pair.0));
            fixed.copied().collect()
        };
        let (these, others) = (chosen(self), chosen(other));
        let mut differing = these
            .iter()
            .zip(&others)
            .filter(|(one, other)| one != other);
        let (first, second) = (differing.next()?, differing.next());
        let is_number = first.0.0 == first.1.0 && first.0.1.as_f64().is_some();
        (is_number && second.is_none() && these.len() == others.len()).then_some(first.0.0)
    }

    /// Greater for a finer mesh, then for a smaller step.
    pub(super) fn compare_fineness(&self, other: &Choice) -> Ordering {
        let steps = other.step.total_cmp(&self.step);
        self.size.cmp(&other.size).then(steps)
    }
}

/// Solves the cases of a candidate, at the best values of its free parameters.
pub(super) fn decide(choice: &mut Choice, judge: &mut Judge) -> Result<(), Stopped> {
    if !choice.is_whole(judge) || judge.references.is_empty() {
        return Ok(());
    }
    if !choice.free.is_empty() {
        let options = Options {
            seed: 1,
            cases: CASES / choice.alternative.cases().max(1) as u64,
        };
        let mut worst = Worst { choice, judge };
        let best = search(worst.choice.free.len(), &mut worst, &options)?;
        let free = choice.free.iter().zip(&best.at);
        let values = free.map(|(number, u)| (number.parameter, Value::Number(number.range.at(*u))));
        choice.values.extend(values);
    }
    let (free, values) = choice.free();
    let judged = judge.judged(&choice.cases(judge, free, &values))?;
    let (errors, energy) = largest(&judged);
    let why = judged.iter().find_map(|case| case.why.clone());
    choice.worst = judge.worst(&judged);
    choice.warnings = warnings(&judged);
    choice.state = match why {
        Some(why) => State::Unsolved(why),
        None if !judge.allows(energy) => State::Energy,
        None if choice.warnings.iter().any(Warning::is_contact_energy) => State::ContactEnergy,
        None if choice.worst <= 1.0 => State::Keeps,
        None => State::Misses,
    };
    (choice.errors, choice.energy) = (errors, energy);
    Ok(())
}

/// The warnings of cases, as `run` gives them: of some kinds only if all cases have them.
fn warnings(judged: &[Judged]) -> Warnings {
    let applies = |kind: Warning| match kind.is_of_all_cases() {
        true => judged.iter().all(|case| case.warnings.has(kind)),
        false => judged.iter().any(|case| case.warnings.has(kind)),
    };
    let said = WARNINGS.into_iter().filter(|kind| !kind.is_note());
    said.fold(Warnings::NONE, |set, kind| set.with(kind, applies(kind)))
}

/// The largest errors and changes of energy of cases.
fn largest(judged: &[Judged]) -> (Vec<f64>, EnergyChange) {
    let count = judged.first().map_or(0, |case| case.errors.len());
    let error = |at: usize| {
        judged
            .iter()
            .map(|case| case.errors[at])
            .fold(0.0, f64::max)
    };
    let fold = |of: fn(&EnergyChange) -> f64| {
        judged
            .iter()
            .map(|case| of(&case.energy))
            .fold(0.0, f64::max)
    };
    let energy = EnergyChange {
        gain: fold(|change| change.gain),
        loss: fold(|change| change.loss),
    };
    ((0..count).map(error).collect(), energy)
}

/// The largest quotient of a candidate at points of its free parameters.
struct Worst<'a, 'b> {
    choice: &'a Choice,
    judge: &'a mut Judge<'b>,
}

impl Objective for Worst<'_, '_> {
    fn misfits(&mut self, points: &[Vec<f64>]) -> Result<Vec<f64>, Stopped> {
        let sampled = self
            .judge
            .study
            .point_cases(&self.choice.alternative, &self.choice.free);
        let judged = self.judge.judged(&sampled.cases(points))?;
        // Those of the first physical case come first.
        let of = |point: usize| {
            let of_point = judged.iter().skip(point).step_by(points.len());
            of_point
                .map(|case| self.judge.worst(std::slice::from_ref(case)))
                .fold(0.0, f64::max)
        };
        Ok((0..points.len()).map(of).collect())
    }
}
