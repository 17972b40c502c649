//! Solves cases and judges them: how far each metric is from its reference, and how much energy the case gains or loses.

use super::errors::errors;
use super::sweep::sweep;
use crate::calibrate::Stopped;
use crate::friction::{self, energy_gain};
use crate::impact::{self, energy_change};
use crate::{EnergyChange, Stop};
use rayon::prelude::*;
use slipgap_problem::problem::friction::FrictionOscillator;
use slipgap_problem::problem::structure::metrics::metric::OF_ALL;
use slipgap_problem::problem::table::cases::Cases;
use slipgap_problem::problem::{Case, Problem};
use slipgap_study::alike::{Identity, identity};
use slipgap_study::{Recommend, Study};
use std::collections::HashMap;

/// A solved case: its metrics in the order of the problem's table, and its change of energy; or why it has none.
pub type Solved = Result<(Vec<Option<f64>>, EnergyChange), String>;

/// A case as it was judged.
#[derive(Debug)]
pub struct Judged {
    /// The error of each metric to keep; infinite without a value.
    pub errors: Vec<f64>,
    /// The change of its energy.
    pub energy: EnergyChange,
    /// Why it was not solved.
    pub why: Option<String>,
}

/// Judges the cases of a study.
pub struct Judge<'a> {
    pub study: &'a Study,
    pub recommend: &'a Recommend,
    /// The numbers of the physical cases, by the values of `kept`.
    pub conditions: HashMap<Identity, usize>,
    /// Largest changes of energy allowed.
    pub limits: EnergyChange,
    /// Number of cases solved so far.
    pub solved: u64,
    /// The reference of each metric in each physical case.
    pub references: Vec<Vec<Option<f64>>>,
    /// Rows of the parameters that distinguish physical cases.
    kept: Vec<usize>,
    stop: &'a Stop,
}

impl<'a> Judge<'a> {
    pub fn new(study: &'a Study, recommend: &'a Recommend, stop: &'a Stop) -> Judge<'a> {
        let free = recommend.free.iter().map(|free| free.parameter);
        let chosen: Vec<usize> = recommend.over.iter().copied().chain(free).collect();
        let friction = study.problem.name() == FrictionOscillator.name();
        let limits = match friction {
            true => [friction::ENERGY_GAIN, f64::INFINITY],
            false => [impact::ENERGY_GAIN, impact::ENERGY_LOSS],
        };
        Judge {
            kept: study.outside_choice(&chosen),
            study,
            recommend,
            conditions: HashMap::new(),
            limits: EnergyChange {
                gain: limits[0],
                loss: limits[1],
            },
            solved: 0,
            references: Vec::new(),
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

    /// The errors of cases, and their changes of energy.
    pub fn judged(&mut self, cases: &Cases) -> Result<Vec<Judged>, Stopped> {
        let solved = self.solve(cases)?;
        let mut shown = cases.shown();
        let judged = solved.into_iter().enumerate().map(|(row, solved)| {
            let case = shown.at(row);
            let at = self.conditions.get(&self.condition(case));
            let reference = at.and_then(|at| self.references.get(*at));
            let (Ok((metrics, energy)), Some(reference)) = (&solved, reference) else {
                return Judged {
                    errors: vec![f64::INFINITY; self.recommend.within.len()],
                    energy: EnergyChange::UNKNOWN,
                    why: solved.err(),
                };
            };
            Judged {
                errors: errors((self.study, self.recommend), case, metrics, reference),
                energy: *energy,
                why: None,
            }
        });
        Ok(judged.collect())
    }

    /// The metrics of cases and their changes of energy: those of structures side by side.
    pub fn solve(&mut self, cases: &Cases) -> Result<Vec<Solved>, Stopped> {
        let (study, stop) = (self.study, self.stop);
        let problem = &*study.problem;
        let mut all: Vec<Solved> = vec![Err(String::new()); cases.len()];
        for (row, why) in cases.refused() {
            all[row] = Err(why.to_owned());
        }
        if problem.schema().described {
            let (rows, table) = sweep(problem, cases, stop, &|_| ())?;
            self.solved += rows.len() as u64;
            for (place, row) in rows.into_iter().enumerate() {
                let metrics: Vec<Option<f64>> = table.row(place).collect();
                let energy = of_structure(study, &metrics);
                all[row as usize] = match table.failure(place) {
                    Some(why) => Err(why.to_string()),
                    None => Ok((metrics, energy)),
                };
            }
            return Ok(all);
        }
        let each = all_of(cases);
        self.solved += each.len() as u64;
        let solve = |(row, own): (usize, &mut Solved)| {
            if cases.may_be_solved(row) && !stop.is_stopped() {
                *own = solve_one(study, &each[row]);
            }
        };
        all.par_iter_mut().enumerate().for_each(solve);
        if stop.is_stopped() {
            return Err(Stopped);
        }
        Ok(all)
    }
}

fn solve_one(study: &Study, case: &Case) -> Solved {
    let problem = &*study.problem;
    let solution = match study.once {
        true => problem.solve_once(case, &study.metrics),
        false => problem.solve(case, &study.metrics),
    };
    let solution = solution.map_err(|why| why.to_string())?;
    let energy = match problem.name() == FrictionOscillator.name() {
        true => EnergyChange {
            gain: energy_gain(&solution.computed, &solution.exact),
            loss: 0.0,
        },
        false => energy_change(case, &solution.computed).unwrap_or(EnergyChange::UNKNOWN),
    };
    Ok((solution.metrics, energy))
}

/// The change of energy of a structure by its metrics. One that the study keeps itself has the tolerance that it gives.
fn of_structure(study: &Study, metrics: &[Option<f64>]) -> EnergyChange {
    let kept = |name: &str| {
        let own = study.recommend.iter().flat_map(|own| &own.within);
        own.map(|(row, _)| &study.measures[*row])
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
