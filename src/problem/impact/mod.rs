//! The impact of two bars of `[I]`, or of a bar on a wall, in scales of the left bar's contact duration T_I = 2 L/C0.

mod between;
mod once;
mod rules;
pub mod run;
pub mod scaled;
mod scales;
mod second;
mod snapshot;
mod sweep;
mod tables;

use super::parameter::Parameter;
use super::sweep::sweep;
use super::unit::{Dimension, Unit};
use super::{
    Budget, Case, Cases, Found, Metric, NOT_GIVEN, OUT_OF_RANGE, Problem, Profile, Quantity,
    Snapshot, Solution, Violation,
};
use crate::exact::wave::Wave;
use crate::history::History;
use crate::metrics::impact::{Sampled, Track};
use crate::metrics::{self, cells, steps};
use scaled::Scaled;
use scales::Scales;
use std::ops::Range;
use tables::{
    BUDGET, BUDGETS, MAX_OVERLAP, METRICS, PARAMETERS, PROFILES, QUANTITIES, REFERENCE, SCALES,
    UNITS, rows,
};

/// Two uniform bars that meet end to end, an impact spring between them `[I Fig. 2]`.
#[derive(Debug)]
pub struct BarImpact;

impl Problem for BarImpact {
    fn name(&self) -> &'static str {
        "bar-impact"
    }

    fn meaning(&self) -> &'static str {
        "longitudinal impact of two uniform bars, or of a bar on a wall, with an impact spring [I]"
    }

    fn parameters(&self) -> &'static [Parameter] {
        &PARAMETERS
    }

    fn metrics(&self) -> &'static [Metric] {
        &METRICS
    }

    fn contact(&self) -> Option<usize> {
        Some(MAX_OVERLAP)
    }

    fn quantities(&self) -> &'static [Quantity] {
        &QUANTITIES
    }

    fn budgets(&self) -> &'static [Budget] {
        &BUDGETS
    }

    fn step(&self) -> &'static str {
        "dt"
    }

    fn scales(&self) -> &'static [[&'static str; 2]] {
        &SCALES
    }

    fn units(&self) -> &'static [Unit] {
        &UNITS
    }

    fn size(&self, case: &Case, dimension: Dimension) -> Option<f64> {
        Scales::new(case).map(|scales| scales.size(dimension))
    }

    fn time_title(&self) -> &'static str {
        "Time *t*/*T*_I_"
    }

    fn time_in_pi(&self) -> bool {
        false
    }

    fn history_columns(&self) -> [&'static str; 6] {
        ["t", "r", "rdot", "force", "r_exact", "rdot_exact"]
    }

    fn alternatives(&self) -> &'static [[&'static str; 2]] {
        &[["gamma", "k_I"]]
    }

    fn complete(&self, case: &mut Case) -> Vec<Violation> {
        rules::complete(case)
    }

    fn steps(&self, case: &Case) -> u64 {
        let number = |row| case.at(row).unwrap_or(f64::NAN);
        steps(number(rows::DURATION), number(rows::DT))
    }

    fn work(&self, case: &Case) -> u64 {
        let modes = |row| case.at(row).map_or(0, |n| n as u64 + 1);
        let all = modes(rows::N) + modes(rows::RIGHT_N);
        self.steps(case).saturating_mul(all)
    }

    fn reference_work(&self, case: &Case, wanted: &[usize]) -> u64 {
        // Measured: 1.3 s at n = 400 and 14 s at n = 1000, where a core does some 5e8 steps times modes in a second.
        let cube = |n: f64| 8.0 * n * n * n;
        let budget = wanted.iter().any(|row| BUDGET.contains(row));
        let elements = case.at(rows::N).filter(|_| budget);
        elements.map_or(0, |n| cube(n) as u64)
    }

    fn solve(&self, case: &Case, wanted: &[usize]) -> Result<Solution, String> {
        let parameters = Given::of(case).ok_or(NOT_GIVEN)?;
        let track = run::run(&parameters.scaled, parameters.dt, parameters.last);
        judged(&parameters, track, wanted)
    }

    fn sweep(&self, cases: &Cases, rows: &[u32]) -> Found {
        sweep(self, cases, rows, Given::of)
    }

    fn solve_once(&self, case: &Case, wanted: &[usize]) -> Result<Solution, String> {
        let parameters = Given::of(case).ok_or(NOT_GIVEN)?;
        let track = once::run(&parameters.scaled, parameters.dt, parameters.last)?;
        judged(&parameters, track, wanted)
    }

    fn profiles(&self) -> &'static [Profile] {
        &PROFILES
    }

    fn place_title(&self) -> &'static str {
        "*x*/*L*"
    }

    fn snapshots(&self, case: &Case, times: &[f64]) -> Vec<Snapshot> {
        match (Scaled::new(case), case.at(rows::DT)) {
            (Some(scaled), Some(dt)) => snapshot::snapshots(&scaled, dt, self.steps(case), times),
            _ => Vec::new(),
        }
    }

    fn later(&self) -> &'static [&'static str] {
        &second::QUANTITIES
    }

    fn after(&self, case: &Case, flight: f64) -> Vec<Option<f64>> {
        match (Scaled::new(case), case.at(rows::DT)) {
            (Some(scaled), Some(dt)) => second::second(&scaled, dt, flight).to_vec(),
            _ => Vec::new(),
        }
    }

    fn exact(&self, case: &Case, times: &[f64]) -> Option<History> {
        let wave = Scaled::new(case)?.bars.solve(*times.last()?);
        Some(wave.line(times))
    }
}

/// What a case is solved by.
#[derive(Debug, Clone, Copy)]
struct Given {
    scaled: Scaled,
    dt: f64,
    duration: f64,
    last: u64,
}

impl Given {
    fn of(case: &Case) -> Option<Given> {
        Some(Given {
            scaled: Scaled::new(case)?,
            dt: case.at(rows::DT)?,
            duration: case.at(rows::DURATION)?,
            last: BarImpact.steps(case),
        })
    }

    /// The exact solution, and what it is at the case's steps.
    fn exact_at_steps(&self) -> (Wave, Sampled) {
        let wave = self.scaled.bars.solve(self.duration);
        let sampled = Sampled::new(&wave, self.dt, self.last, self.duration);
        (wave, sampled)
    }
}

/// A computed history beside the exact one, with its metrics.
fn judged(given: &Given, track: Track<1>, wanted: &[usize]) -> Result<Solution, String> {
    let computed = track.history(given.dt);
    if !computed.is_finite() {
        return Err(OUT_OF_RANGE.into());
    }
    let (wave, sampled) = given.exact_at_steps();
    let exact = wave.history(&computed.time);
    let own = metrics::impact::evaluate(&track, &sampled);
    let wants = |rows: Range<usize>| wanted.iter().any(|row| rows.contains(row));
    let budget = wants(BUDGET)
        .then(|| between::between(&given.scaled, &computed.time))
        .flatten()
        .map(|[spring, chain]| metrics::impact::budget(&track, &sampled, &spring, &chain));
    let reference = wants(REFERENCE).then(|| metrics::impact::reference(&wave, &sampled));
    let metrics = cells(own)
        .into_iter()
        .chain(budget.unwrap_or([None; BUDGET.end - BUDGET.start]))
        .chain(reference.unwrap_or([None; REFERENCE.end - REFERENCE.start]))
        .collect();
    Ok(Solution {
        computed,
        exact,
        metrics,
    })
}
