//! Solves cases and judges them: how far each metric is from its reference, and how much energy the case gains or loses.

use super::errors::{From, errors};
use super::sweep::sweep;
use crate::Stop;
use crate::calibrate::Stopped;
use crate::energy_change::{EnergyChange, FRICTION_LIMITS, LIMITS, energy_change, energy_gain};
use rayon::prelude::*;
use slipgap_motion::solve::{Warning, Warnings};
use slipgap_problem::problem::friction::FrictionOscillator;
use slipgap_problem::problem::structure::metrics::metric::OF_ALL;
use slipgap_problem::problem::table::cases::Cases;
use slipgap_problem::problem::{Case, Problem};
use slipgap_study::alike::{Identity, identity};
use slipgap_study::{Recommend, Study};
use std::collections::{HashMap, HashSet};

/// A solved case.
#[derive(Debug, Clone)]
pub struct SolvedCase {
    /// Its metrics in the order of the problem's table.
    pub metrics: Vec<Option<f64>>,
    /// The change of its energy.
    pub energy: EnergyChange,
    /// What `run` warns of.
    pub warnings: Warnings,
}

/// A case, or why it has no solution.
pub type Solved = Result<SolvedCase, String>;

/// A case as it was judged.
#[derive(Debug)]
pub struct Judged {
    /// The error of each metric to keep; infinite without a value.
    pub errors: Vec<f64>,
    /// The change of its energy.
    pub energy: EnergyChange,
    /// What `run` warns of.
    pub warnings: Warnings,
    /// Why it was not solved.
    pub why: Option<String>,
}

/// Judges the cases of a study.
pub struct Judge<'a> {
    pub study: &'a Study,
    pub recommend: &'a Recommend,
    /// The physical cases of the study, by the values of `kept`.
    pub conditions: HashSet<Identity>,
    /// Largest changes of energy allowed.
    pub limits: EnergyChange,
    /// Number of cases solved so far.
    pub solved: u64,
    /// The reference of each metric in each physical case, of the study or fresh.
    pub references: HashMap<Identity, Vec<Option<f64>>>,
    /// The cases of the finest candidate, whose motions are the references.
    pub finest: Vec<Case>,
    /// By metric: where its references come from.
    pub from: Vec<From>,
    /// Rows of the parameters that distinguish physical cases.
    pub kept: Vec<usize>,
    /// How often the step of a candidate is halved in its tests.
    pub halvings: u32,
    stop: &'a Stop,
}

impl<'a> Judge<'a> {
    pub fn new(study: &'a Study, recommend: &'a Recommend, stop: &'a Stop) -> Judge<'a> {
        let free = recommend.free.iter().map(|free| free.parameter);
        let chosen: Vec<usize> = recommend.over.iter().copied().chain(free).collect();
        let friction = study.problem.name() == FrictionOscillator.schema().name;
        Judge {
            kept: study.outside_choice(&chosen),
            study,
            recommend,
            conditions: HashSet::new(),
            limits: if friction { FRICTION_LIMITS } else { LIMITS },
            solved: 0,
            references: HashMap::new(),
            finest: Vec::new(),
            from: Vec::new(),
            halvings: 1,
            stop,
        }
    }

    /// The physical case of a case.
    pub fn condition(&self, case: &Case) -> Identity {
        identity(case, &self.kept)
    }

    /// Whether a change of energy is within the limits.
    pub fn allows(&self, energy: EnergyChange) -> bool {
        energy.gain <= self.limits.gain && energy.loss <= self.limits.loss
    }

    /// The largest quotient of error and tolerance; infinite if a case gains or loses too much energy, or if a contact may make some.
    pub fn worst(&self, judged: &[Judged]) -> f64 {
        let makes = |case: &Judged| case.warnings.iter().any(Warning::is_contact_energy);
        if judged
            .iter()
            .any(|case| !self.allows(case.energy) || makes(case))
        {
            return f64::INFINITY;
        }
        let quotients = judged.iter().map(|case| self.quotient(&case.errors));
        quotients.fold(0.0, f64::max)
    }

    /// The largest quotient of error and tolerance of a case.
    fn quotient(&self, errors: &[f64]) -> f64 {
        let within = self.recommend.within.iter();
        let quotients = errors
            .iter()
            .zip(within)
            .map(|(error, metric)| error / metric.1);
        quotients.fold(0.0, f64::max)
    }

    /// The largest quotients of error and tolerance of cases, before their changes of energy are known; infinite for one without a
    /// solution, and for one of which a contact may make energy.
    pub fn quotients(&self, cases: &Cases) -> Vec<f64> {
        let mut quotients = vec![f64::INFINITY; cases.len()];
        let rows: Vec<u32> = (0..cases.len() as u32)
            .filter(|row| cases.may_be_solved(*row as usize))
            .collect();
        let table = self.study.problem.sweep(cases, &rows);
        let mut shown = cases.shown();
        for (index, row) in rows.into_iter().enumerate() {
            let case = shown.at(row as usize);
            let makes = table.warnings(index).iter().any(Warning::is_contact_energy);
            let reference = self.references.get(&self.condition(case));
            if let (Some(reference), false) = (reference, makes || table.failure(index).is_some()) {
                let metrics: Vec<Option<f64>> = table.row(index).collect();
                let values = self.measured(case, &metrics);
                quotients[row as usize] = self.quotient(&errors(&self.from, &values, reference));
            }
        }
        quotients
    }

    /// Whether the metrics to keep are all known of cases that are solved side by side.
    pub fn has_quotients(&self) -> bool {
        let table = self.study.problem.metrics();
        let mut metrics = self.study.metrics.iter();
        metrics.all(|row| table[*row].default)
    }

    /// Whether the user ended the search.
    pub fn is_stopped(&self) -> bool {
        self.stop.is_stopped()
    }

    /// Rows of the measures to keep.
    pub fn rows(&self) -> impl Iterator<Item = usize> {
        self.recommend.within.iter().map(|metric| metric.0)
    }

    /// The metrics to keep, from those of the problem.
    pub fn measured(&self, case: &Case, metrics: &[Option<f64>]) -> Vec<Option<f64>> {
        let value = |row: usize| self.study.measure_value(row, case, &|at| metrics[at]);
        self.rows().map(value).collect()
    }

    /// The errors of cases, and their changes of energy.
    pub fn judged(&mut self, cases: &Cases) -> Result<Vec<Judged>, Stopped> {
        let solved = self.solve(cases)?;
        let mut shown = cases.shown();
        let judged = solved.into_iter().enumerate().map(|(row, solved)| {
            let case = shown.at(row);
            let reference = self.references.get(&self.condition(case));
            let (Ok(solved), Some(reference)) = (&solved, reference) else {
                return Judged {
                    errors: vec![f64::INFINITY; self.recommend.within.len()],
                    energy: EnergyChange::UNKNOWN,
                    warnings: Warnings::NONE,
                    why: solved.err(),
                };
            };
            let values = self.measured(case, &solved.metrics);
            Judged {
                errors: errors(&self.from, &values, reference),
                energy: solved.energy,
                warnings: solved.warnings,
                why: None,
            }
        });
        Ok(judged.collect())
    }

    /// The metrics of cases and their changes of energy: those of structures side by side.
    pub fn solve(&mut self, cases: &Cases) -> Result<Vec<Solved>, Stopped> {
        let (study, stop) = (self.study, self.stop);
        let problem = &*study.problem;
        let mut results: Vec<Solved> = vec![Err(String::new()); cases.len()];
        for (row, why) in cases.refused() {
            results[row] = Err(why.to_owned());
        }
        if problem.schema().described {
            let (rows, table) = sweep(problem, cases, stop, &|_| ())?;
            self.solved += rows.len() as u64;
            for (index, row) in rows.into_iter().enumerate() {
                let metrics: Vec<Option<f64>> = table.row(index).collect();
                results[row as usize] = match table.failure(index) {
                    Some(why) => Err(why.to_string()),
                    None => Ok(SolvedCase {
                        energy: of_structure(study, &metrics),
                        warnings: table.warnings(index),
                        metrics,
                    }),
                };
            }
            return Ok(results);
        }
        let each = all_of(cases);
        self.solved += each.len() as u64;
        let solve = |(row, result): (usize, &mut Solved)| {
            if cases.may_be_solved(row) && !stop.is_stopped() {
                *result = solve_one(study, &each[row]);
            }
        };
        results.par_iter_mut().enumerate().for_each(solve);
        if stop.is_stopped() {
            return Err(Stopped);
        }
        Ok(results)
    }
}

fn solve_one(study: &Study, case: &Case) -> Solved {
    let problem = &*study.problem;
    let solution = study.solve(case).map_err(|why| why.to_string())?;
    let energy = match problem.name() == FrictionOscillator.schema().name {
        true => EnergyChange {
            gain: energy_gain(&solution.computed, &solution.exact),
            loss: 0.0,
        },
        false => energy_change(case, &solution.computed).unwrap_or(EnergyChange::UNKNOWN),
    };
    Ok(SolvedCase {
        metrics: solution.metrics,
        energy,
        warnings: solution.warnings,
    })
}

/// The change of energy of a structure by its metrics. One that the study keeps itself has the tolerance that it gives.
fn of_structure(study: &Study, metrics: &[Option<f64>]) -> EnergyChange {
    let kept = |name: &str| {
        let tolerances = study
            .recommend
            .iter()
            .flat_map(|recommend| &recommend.within);
        tolerances
            .map(|(row, _)| &study.measures[*row])
            .any(|measure| measure.name == name)
    };
    let value = |name: &str| {
        let mut table = study.problem.metrics().iter();
        let row = table.position(|metric| metric.name == name);
        match kept(name) {
            true => 0.0,
            false => row.and_then(|row| metrics[row]).unwrap_or(f64::INFINITY),
        }
    };
    let [error, dissipation] = OF_ALL.map(value);
    EnergyChange {
        gain: error.max(-dissipation).max(0.0),
        loss: dissipation.max(0.0),
    }
}

/// The cases one by one.
pub(super) fn all_of(cases: &Cases) -> Vec<Case> {
    let mut shown = cases.shown();
    (0..cases.len()).map(|row| shown.at(row).clone()).collect()
}
