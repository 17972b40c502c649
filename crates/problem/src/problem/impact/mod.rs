//! The impact of two bars of `[I]`, or of a bar on a wall, in scales of the left bar's contact duration T_I = 2 L/C0.

pub mod case;
mod described;
mod law_of_case;
mod motions_between;
mod rules;
pub mod scaled;
mod scales;
mod second_impact;
mod single_pass;
mod snapshot;
mod tables;

use super::side_by_side::{Form, selected, sweep_cases};
use super::{
    Case, Described, Jumps, Problem, ProblemKind, Schema, Snapshot, Solution, Violation, Work,
    ends_early, method,
};
use crate::history::History;
use crate::lane::Lane;
use crate::metrics::budget::Norm;
use crate::metrics::cells;
use crate::metrics::convergence::FEWEST_HALVED;
use crate::metrics::impact::{Compared, Energy, Track, damping_work, reference};
use crate::problem::Textbook;
use crate::problem::numbers::parameter::Parameter;
use crate::problem::numbers::unit::Dimension;
use crate::problem::table::cases::Cases;
use crate::problem::table::metric_rows::Groups;
use crate::solve::sweep::LaneCase;
use crate::solve::{self, MetricTable, ToSystem, Unsolvable, Warning};
use crate::system::System;
use case::{ImpactCase, LANES};
use scaled::Scaled;
use scales::Scales;
use std::sync::Arc;
use tables::{METHOD, MassMatrix, ROWS, SCHEMA, Taken, of_exact, rows, values};

/// Two uniform bars that meet end to end, an impact spring between them `[I Fig. 2]`.
#[derive(Debug)]
pub struct Bars {
    /// The unit of velocity in m/s; `None` if it is not known.
    velocity: Option<f64>,
    /// The tables with the further parameters of a study; `None` without any.
    schema: Option<Arc<Schema>>,
}

/// The bars for parameters whose units are not known.
#[allow(
    non_upper_case_globals,
    reason = "the problem as a value, as `FrictionOscillator` is one"
)]
pub const BarImpact: Bars = Bars {
    velocity: None,
    schema: None,
};

impl Bars {
    /// The numbers of a case; `None` if a parameter is not given.
    fn of(&self, case: &Case) -> Option<ImpactCase> {
        let has_strange_bar = scales::strange_speed(case, self.velocity).is_some();
        ImpactCase::new(case).map(|impact| ImpactCase {
            has_strange_bar,
            ..impact
        })
    }
}

impl Problem for Bars {
    fn kind(&self) -> ProblemKind<'_> {
        ProblemKind::Textbook(self)
    }

    fn schema(&self) -> &Arc<Schema> {
        self.schema.as_ref().unwrap_or(&SCHEMA)
    }

    fn complete(&self, case: &mut Case) -> Vec<Violation> {
        rules::complete(case)
    }

    fn work(&self, case: &Case, wanted: &[usize]) -> Work {
        // A node without mass has no mode.
        let at_contact = u64::from(MassMatrix::of(case) != Some(MassMatrix::MasslessContact));
        let modes = |row| case.at(row).map_or(0, |n| n as u64 + at_contact);
        let count = modes(rows::N) + modes(rows::RIGHT_N);
        let parts = method::of_case(case, METHOD).map_or(1, |method| method.count_of_sub_steps());
        let steps = case.steps().saturating_mul(count * parts);
        // Measured: 1.3 s at n = 400 and 14 s at n = 1000 for the modes, and 45 to 65 ns for a mode at a step.
        let cube = |n: f64| 8.0 * n * n * n;
        let needs = |row: &usize| ROWS.parts.contains(row) || ROWS.errors.contains(row);
        let budget = wanted.iter().any(needs);
        let elements = case.at(rows::N).filter(|_| budget);
        let references = elements.map_or(0, |n| {
            let halved = match wanted.iter().any(|row| ROWS.errors.contains(row)) {
                true => FEWEST_HALVED,
                false => 0,
            };
            let at_steps = steps.saturating_mul(25 + halved);
            at_steps.saturating_add(cube(n) as u64)
        });
        Work { steps, references }
    }

    fn solve(&self, case: &Case, wanted: &[usize]) -> Result<Solution, Unsolvable> {
        let impact = self.of(case).ok_or(Unsolvable::ParameterMissing)?;
        let system = impact.system();
        let motion = solve::run::<Track<1>>(&system)?;
        let mut track = motion.track;
        case::condense(&[impact], &mut track);
        let energy = Energy::of_case(&track, &system, track.displacement.len());
        let Lane([first_mode]) = motion.first_mode;
        let run = Judged {
            track: &track,
            energy: &energy,
            restitution: 0.5 * first_mode,
            by_method: motion.taken.map(|taken| taken.by_method.0[0]),
        };
        judge(&impact, &run, wanted)
    }

    fn sweep(&self, cases: &Cases, rows: &[u32]) -> MetricTable {
        let form_of = |case: &Case| {
            let impact = self.of(case).ok_or(Unsolvable::ParameterMissing);
            impact.map(Form::<_, ImpactCase>::Plain)
        };
        sweep_cases::<LANES, _, _>(self, cases, rows, form_of)
    }

    fn doubts(&self, case: &Case) -> Vec<(Warning, String)> {
        let end = ImpactCase::new(case).and_then(|impact| impact.ends_early());
        let speed =
            scales::strange_speed(case, self.velocity).map(|text| (Warning::WaveSpeed, text));
        end.map(ends_early).into_iter().chain(speed).collect()
    }

    fn exact(&self, case: &Case, times: &[f64], jumps: Jumps) -> Option<History> {
        let wave = Scaled::new(case)?.bars.solve(*times.last()?);
        Some(match jumps {
            Jumps::RightLimit => wave.history(times),
            Jumps::BothSides => wave.line(times),
        })
    }
}

impl Textbook for Bars {
    fn with_parameters(&self, further: Vec<Parameter>) -> Arc<dyn Problem> {
        Arc::new(Bars {
            velocity: self.velocity,
            schema: Some(self.schema().with_parameters(further)),
        })
    }

    fn once_work(&self, case: &Case) -> u64 {
        let steps = case.steps();
        let modes = self.work(case, &[]).steps / steps.max(1);
        let matrix = modes.saturating_mul(modes).saturating_mul(10);
        steps.saturating_mul(matrix.saturating_add(600))
    }

    fn solve_once(&self, case: &Case, wanted: &[usize]) -> Result<Solution, Unsolvable> {
        let impact = self.of(case).ok_or(Unsolvable::ParameterMissing)?;
        let single_pass::Once {
            track,
            energy,
            restitution,
        } = single_pass::run(&impact.system(), &impact.scaled)?;
        let run = Judged {
            track: &track,
            energy: &energy,
            restitution,
            by_method: None,
        };
        judge(&impact, &run, wanted)
    }

    fn described(&self, case: &Case) -> Result<Described, String> {
        described::described(case)
    }

    fn judged(
        &self,
        case: &Case,
        channels: &[Vec<f64>],
        wanted: &[usize],
    ) -> Result<Solution, Unsolvable> {
        let impact = self.of(case).ok_or(Unsolvable::ParameterMissing)?;
        let read = described::read(&impact.scaled, channels);
        let (mut track, energy, restitution) = read.ok_or(Unsolvable::ParameterMissing)?;
        case::condense(&[impact], &mut track);
        let run = Judged {
            track: &track,
            energy: &Energy::of(&energy),
            restitution,
            by_method: None,
        };
        judge(&impact, &run, wanted)
    }

    fn system(&self, case: &Case) -> Option<System> {
        ImpactCase::new(case).map(|impact| impact.system())
    }

    fn in_units(&self, size: &dyn Fn(Dimension) -> Option<f64>) -> Option<Arc<dyn Problem>> {
        let velocity = Some(size(Dimension::Velocity)?);
        let schema = self.schema.clone();
        Some(Arc::new(Bars { velocity, schema }))
    }

    fn snapshots(&self, case: &Case, times: &[f64]) -> Vec<Snapshot> {
        match (Scaled::new(case), case.at(rows::DT)) {
            (Some(scaled), Some(dt)) => {
                let system = case::system(&scaled, dt, case.steps());
                snapshot::snapshots(&system, &scaled, times)
            }
            (None, _) | (_, None) => Vec::new(),
        }
    }

    fn after(&self, case: &Case, flight: f64) -> Vec<Option<f64>> {
        match (Scaled::new(case), case.at(rows::DT)) {
            (Some(scaled), Some(dt)) => second_impact::second(&scaled, dt, flight).to_vec(),
            (None, _) | (_, None) => Vec::new(),
        }
    }

    fn size(&self, case: &Case, dimension: Dimension) -> Option<f64> {
        Scales::new(case).map(|scales| scales.size(dimension))
    }
}

/// A run to be judged.
struct Judged<'a> {
    track: &'a Track<1>,
    energy: &'a Energy<1>,
    restitution: f64,
    /// Numerical dissipation; `None` if the method has none.
    by_method: Option<f64>,
}

/// The computed and the exact history, with the metrics.
fn judge(case: &ImpactCase, run: &Judged, wanted: &[usize]) -> Result<Solution, Unsolvable> {
    let Judged { track, energy, .. } = run;
    let computed = track.history(case.dt);
    if !computed.is_finite() {
        return Err(Unsolvable::OutOfRange);
    }
    let (wave, sampled) = case.exact_at_steps();
    let exact = wave.history(&computed.time);
    let restitution = Lane([run.restitution]);
    let default = values(&Compared::new(track, energy, restitution, &sampled));
    let warnings = case.warnings(|metric| default[metric].0[0]);
    let norm = Norm {
        channels: 2,
        size: 1.0,
        sum: &|channel, value| sampled.mean(channel, |i, e| Lane([value(i, e)])).0[0],
        count: 1.0,
    };
    let rows = [ROWS.parts, ROWS.errors];
    let of = (&computed, &norm);
    let [parts, errors] = case.preset().budget(rows, wanted, of, |with_errors| {
        motions_between::between(case, &computed.time, with_errors)
    });
    let wants_exact = wanted.iter().any(|row| ROWS.exact.contains(row));
    let exact_contact = wants_exact.then(|| reference(&wave, &sampled)).flatten();
    let groups = Groups {
        default: cells(default).to_vec(),
        parts,
        exact: selected(ROWS.exact, of_exact(exact_contact.as_ref()), wanted),
        taken: selected(ROWS.taken, tables::taken(&taken(case, run)), wanted),
        errors,
    };
    Ok(Solution {
        computed,
        exact,
        metrics: groups.in_order(),
        warnings,
    })
}

/// What damping of the contact and of the method took, and the cost.
fn taken(case: &ImpactCase, run: &Judged) -> Taken {
    let system = case.system();
    let Lane([start]) = run.energy.start;
    Taken {
        start,
        by_contact: damping_work(run.track, &system),
        by_method: run.by_method.unwrap_or(0.0),
        drift: run.energy.last.0[0] - start,
        cost: case.last * system.linear.len() as u64 * system.method.count_of_sub_steps(),
    }
}
