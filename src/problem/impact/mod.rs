//! The impact of two bars of `[I]`, or of a bar on a wall, in scales of the left bar's contact duration T_I = 2 L/C0.

mod budget;
pub mod case;
mod law;
mod once;
mod rules;
pub mod scaled;
mod scales;
mod second;
mod snapshot;
mod tables;

use super::cases::Cases;
use super::unit::Dimension;
use super::{Case, Problem, Schema, Snapshot, Solution, Violation, sweep_cases};
use crate::history::History;
use crate::lane::Lane;
use crate::metrics::impact::{Energy, Track};
use crate::metrics::{self, cells};
use crate::solve::{self, MetricTable, ToSystem, Unsolvable};
use crate::system::System;
use case::{ImpactCase, LANES};
use scaled::Scaled;
use scales::Scales;
use std::ops::Range;
use std::sync::Arc;
use tables::{BUDGET, MassMatrix, REFERENCE, SCHEMA, rows};

/// Two uniform bars that meet end to end, an impact spring between them `[I Fig. 2]`.
#[derive(Debug)]
pub struct BarImpact;

impl BarImpact {
    /// The system of a completed case, ready to be solved.
    pub fn system(&self, case: &Case) -> Result<System, Unsolvable> {
        let own = ImpactCase::new(case).ok_or(Unsolvable::ParameterMissing)?;
        Ok(own.system())
    }
}

impl Problem for BarImpact {
    fn schema(&self) -> &Arc<Schema> {
        &SCHEMA
    }

    fn size(&self, case: &Case, dimension: Dimension) -> Option<f64> {
        Scales::new(case).map(|scales| scales.size(dimension))
    }

    fn complete(&self, case: &mut Case) -> Vec<Violation> {
        rules::complete(case)
    }

    fn work(&self, case: &Case) -> u64 {
        // A node without mass has no mode.
        let own = u64::from(MassMatrix::of(case) != Some(MassMatrix::MasslessContact));
        let modes = |row| case.at(row).map_or(0, |n| n as u64 + own);
        let all = modes(rows::N) + modes(rows::RIGHT_N);
        self.steps(case).saturating_mul(all)
    }

    fn reference_work(&self, case: &Case, wanted: &[usize]) -> u64 {
        // Measured: 1.3 s at n = 400 and 14 s at n = 1000; a core computes about 5e8 steps times modes in a second.
        let cube = |n: f64| 8.0 * n * n * n;
        let budget = wanted.iter().any(|row| BUDGET.contains(row));
        let elements = case.at(rows::N).filter(|_| budget);
        elements.map_or(0, |n| cube(n) as u64)
    }

    fn solve(&self, case: &Case, wanted: &[usize]) -> Result<Solution, Unsolvable> {
        let own = ImpactCase::new(case).ok_or(Unsolvable::ParameterMissing)?;
        let system = own.system();
        let motion = solve::run::<Track<1>>(&system)?;
        let mut track = motion.track;
        case::condense(&[own], &mut track);
        let energy = Energy::of_case(&track, &system, track.displacement.len());
        let Lane([first_mode]) = motion.first_mode;
        judge(&own, &track, &energy, 0.5 * first_mode, wanted)
    }

    fn sweep(&self, cases: &Cases, rows: &[u32]) -> MetricTable {
        let own = |case: &Case| ImpactCase::new(case).ok_or(Unsolvable::ParameterMissing);
        sweep_cases::<LANES, _>(self, cases, rows, own)
    }

    fn solve_once(&self, case: &Case, wanted: &[usize]) -> Result<Solution, Unsolvable> {
        let own = ImpactCase::new(case).ok_or(Unsolvable::ParameterMissing)?;
        let once::Once {
            track,
            energy,
            restitution,
        } = once::run(&own.system(), &own.scaled)?;
        judge(&own, &track, &energy, restitution, wanted)
    }

    fn snapshots(&self, case: &Case, times: &[f64]) -> Vec<Snapshot> {
        match (Scaled::new(case), case.at(rows::DT)) {
            (Some(scaled), Some(dt)) => {
                let system = case::system(&scaled, dt, self.steps(case));
                snapshot::snapshots(&system, &scaled, times)
            }
            (None, _) | (_, None) => Vec::new(),
        }
    }

    fn after(&self, case: &Case, flight: f64) -> Vec<Option<f64>> {
        match (Scaled::new(case), case.at(rows::DT)) {
            (Some(scaled), Some(dt)) => second::second(&scaled, dt, flight).to_vec(),
            (None, _) | (_, None) => Vec::new(),
        }
    }

    fn exact(&self, case: &Case, times: &[f64]) -> Option<History> {
        let wave = Scaled::new(case)?.bars.solve(*times.last()?);
        Some(wave.line(times))
    }
}

/// The computed and the exact history, with the metrics.
fn judge(
    case: &ImpactCase,
    track: &Track<1>,
    energy: &Energy<1>,
    restitution: f64,
    wanted: &[usize],
) -> Result<Solution, Unsolvable> {
    let computed = track.history(case.dt);
    if !computed.is_finite() {
        return Err(Unsolvable::OutOfRange);
    }
    let (wave, sampled) = case.exact_at_steps();
    let exact = wave.history(&computed.time);
    let own = metrics::impact::evaluate(track, energy, Lane([restitution]), &sampled);
    let wants = |rows: Range<usize>| wanted.iter().any(|row| rows.contains(row));
    let budget = wants(BUDGET)
        .then(|| budget::references(&case.scaled, &computed.time))
        .flatten()
        .map(|[spring, mesh]| metrics::impact::budget(track, &sampled, &spring, &mesh));
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
