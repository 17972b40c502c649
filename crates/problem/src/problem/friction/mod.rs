//! The friction oscillator of [F (19)], dimensionless (reference: X'' + X + S = 0, X(0) = x0, X'(0) = 0).

mod case;
mod described;
mod law_of_case;
mod metric_table;
mod motion_of_law;
mod tables;

use super::method::{self, step_rules};
use super::side_by_side::{Form, selected, sweep_cases};
use super::{
    Case, Described, Jumps, Problem, ProblemKind, Schema, Solution, Violation, Work, ends_early,
    time_rules,
};
use crate::exact::coulomb::Coulomb;
use crate::history::History;
use crate::lane::Lane;
use crate::methods::ContactWork;
use crate::metrics::budget::Norm;
use crate::metrics::cells;
use crate::metrics::friction::{Compared, work_by_energy, work_by_steps};
use crate::problem::Textbook;
use crate::problem::numbers::parameter::Parameter;
use crate::problem::numbers::short::short;
use crate::problem::table::cases::Cases;
use crate::problem::table::metric_rows::Groups;
use crate::solve::{self, ContactTrack, MetricTable, ToSystem, Unsolvable, Warning};
use crate::system::System;
use case::{LANES, OscillatorCase, PlainCase};
use metric_table::{ROWS, Shared, Taken};
use std::f64::consts::PI;
use std::sync::Arc;
use tables::{SCHEMA, rows};

/// A mass on a spring that slides on a surface with Coulomb friction, released at rest from x0 [F Fig. 4].
#[derive(Debug)]
pub struct Oscillator {
    /// The tables with the further parameters of a study; `None` without any.
    schema: Option<Arc<Schema>>,
}

/// The oscillator with its own parameters.
#[allow(
    non_upper_case_globals,
    reason = "the problem as a value, as `BarImpact` is one"
)]
pub const FrictionOscillator: Oscillator = Oscillator { schema: None };

impl Problem for Oscillator {
    fn kind(&self) -> ProblemKind<'_> {
        ProblemKind::Textbook(self)
    }

    fn schema(&self) -> &Arc<Schema> {
        self.schema.as_ref().unwrap_or(&SCHEMA)
    }

    fn complete(&self, case: &mut Case) -> Vec<Violation> {
        let (Some(step), Some(duration)) = (case.at(rows::DT), case.at(rows::DURATION)) else {
            return Vec::new();
        };
        let rules = time_rules("dT", step, duration);
        let falls = case.at(rows::STATIC_RATIO).is_some_and(|ratio| ratio > 1.0);
        if !rules.is_empty() || !(falls || method::has_rules(case, rows::METHOD)) {
            return rules;
        }
        OscillatorCase::new(case).map_or(rules, |oscillator| {
            step_rules("dT", &oscillator.system(), 0.0)
        })
    }

    fn work(&self, case: &Case, wanted: &[usize]) -> Work {
        let in_closed_form = || {
            let law = OscillatorCase::new(case).map(|oscillator| oscillator.law);
            law.is_none_or(|law| motion_of_law::in_closed_form(&law))
        };
        let steps = case.steps();
        let references = match needs_reference(wanted) {
            // Measured: 0.4 us for the motion with a law of the papers at a step.
            true if in_closed_form() => steps.saturating_mul(200),
            // The evaluations of 12 stages, and a third of that for the error.
            true => steps.saturating_mul(1200),
            false => 0,
        };
        Work { steps, references }
    }

    fn solve(&self, case: &Case, wanted: &[usize]) -> Result<Solution, Unsolvable> {
        let oscillator = self.lane_case(case)?;
        let motion = solve::run::<ContactTrack>(&oscillator.system())?;
        self.judge(
            &oscillator,
            &motion.track,
            oscillator.work(&motion, 0),
            wanted,
        )
    }

    fn sweep(&self, cases: &Cases, rows: &[u32]) -> MetricTable {
        // Names are compared once, if all cases have the same.
        let common = cases
            .common(PlainCase::deciding())
            .map(|case| PlainCase::law_name(&case));
        let form_of = |case: &Case| {
            let name = common.unwrap_or_else(|| PlainCase::law_name(case));
            match name.and_then(|name| PlainCase::plain(case, name)) {
                Some(plain) => Ok(Form::Plain(plain)),
                None => self.lane_case(case).map(Form::Other),
            }
        };
        sweep_cases::<LANES, _, _>(self, cases, rows, form_of)
    }

    fn doubts(&self, case: &Case) -> Vec<(Warning, String)> {
        let Some(oscillator) = OscillatorCase::new(case) else {
            return Vec::new();
        };
        let count = 2.0 * PI / oscillator.step;
        let warning = || {
            (
                Warning::LongStep,
                format!("a period of 2 pi has {count:.1} steps"),
            )
        };
        let long = oscillator.has_long_step().then(warning);
        let sticks = |share| {
            let text = format!(
                "its force stays below {} of the limit: x0 is in nu N/k",
                short(share)
            );
            (Warning::NeverSlides, text)
        };
        long.into_iter()
            .chain(oscillator.share_without_sliding().map(sticks))
            .chain(oscillator.ends_early().map(ends_early))
            .collect()
    }

    fn exact(&self, case: &Case, times: &[f64], _: Jumps) -> Option<History> {
        Some(coulomb(case.at(rows::X0)?, times))
    }
}

impl Textbook for Oscillator {
    fn with_parameters(&self, further: Vec<Parameter>) -> Arc<dyn Problem> {
        let schema = Some(self.schema().with_parameters(further));
        Arc::new(Oscillator { schema })
    }

    fn solve_once(&self, case: &Case, wanted: &[usize]) -> Result<Solution, Unsolvable> {
        let oscillator = self.lane_case(case)?;
        let mut track = ContactTrack::default();
        solve::single_pass::run(&oscillator.system(), |structure| {
            track.0.push(structure.contact())
        })?;
        let work = work_by_steps(&track.0, oscillator.x0, &ContactWork::Trapezoids);
        self.judge(&oscillator, &track, work, wanted)
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
        let oscillator = self.lane_case(case)?;
        let [x, v, s] = channels else {
            return Err(Unsolvable::ParameterMissing);
        };
        let steps = x.iter().zip(v).zip(s);
        let track = ContactTrack(steps.map(|((x, v), s)| [*x, *v, *s]).collect());
        let work = work_by_steps(&track.0, oscillator.x0, &ContactWork::Trapezoids);
        self.judge(&oscillator, &track, work, wanted)
    }

    fn system(&self, case: &Case) -> Option<System> {
        OscillatorCase::new(case).map(|oscillator| oscillator.system())
    }

    fn exact_of_law(&self, case: &Case, times: &[f64]) -> Option<History> {
        let case = OscillatorCase::new(case)?;
        motion_of_law::between(&case, times, false)?.motions.pop()
    }

    fn cost_rows(&self, wanted: &[usize]) -> Option<[usize; 2]> {
        (!needs_reference(wanted)).then_some([rows::DT, rows::DURATION])
    }
}

impl Oscillator {
    fn lane_case(&self, case: &Case) -> Result<OscillatorCase, Unsolvable> {
        OscillatorCase::new(case).ok_or(Unsolvable::ParameterMissing)
    }

    /// The computed and the exact history, with the metrics; `work` over |x0|.
    fn judge(
        &self,
        case: &OscillatorCase,
        track: &ContactTrack,
        work: f64,
        wanted: &[usize],
    ) -> Result<Solution, Unsolvable> {
        let steps = track.0.iter().enumerate();
        let computed: History = steps
            .map(|(i, contact)| (i as f64 * case.step, *contact))
            .collect();
        if !computed.is_finite() {
            return Err(Unsolvable::OutOfRange);
        }
        let x: Vec<_> = computed.displacement().iter().map(|x| Lane([*x])).collect();
        let sampled = case.exact_at_steps();
        let default = metric_table::values(&Shared {
            compared: Compared::new(&x, &sampled),
            work: Lane([work]),
        });
        let exact = coulomb(case.x0, &computed.time);
        let steps = exact.displacement().iter().enumerate();
        let norm = Norm {
            channels: 1,
            size: case.x0.abs(),
            sum: &|_, value| steps.clone().map(|(i, e)| value(i, *e)).sum(),
            count: computed.len() as f64,
        };
        let rows = [ROWS.parts, ROWS.errors];
        let of = (&computed, &norm);
        let [parts, errors] = case.preset().budget(rows, wanted, of, |with_errors| {
            motion_of_law::between(case, &computed.time, with_errors)
        });
        let groups = Groups {
            default: cells(default).to_vec(),
            parts,
            exact: Vec::new(),
            taken: selected(ROWS.taken, metric_table::taken(&taken(case, track)), wanted),
            errors,
        };
        Ok(Solution {
            computed,
            exact,
            metrics: groups.in_order(),
            warnings: case.own_warnings(),
        })
    }
}

/// Whether one of these metrics needs the motion with the law of the case.
fn needs_reference(wanted: &[usize]) -> bool {
    let needs = |row: &usize| ROWS.parts.contains(row) || ROWS.errors.contains(row);
    wanted.iter().any(needs)
}

/// What the method takes and costs.
fn taken(case: &OscillatorCase, track: &ContactTrack) -> Taken {
    let end = track.0.last().map(|[x, v, _]| [*x, *v]);
    let form = ContactWork::new(case.method.has_force_at_end(), Lane([case.step]));
    let work = work_by_steps(&track.0, case.x0, &form);
    Taken {
        x0: case.x0,
        steps: case.last * case.method.count_of_sub_steps(),
        by_method: end.map(|end| work_by_energy(case.x0, end) - work),
        step: case.method.amplification(case.step),
    }
}

/// The exact motion at these times.
fn coulomb(x0: f64, times: &[f64]) -> History {
    let coulomb = Coulomb::new(x0);
    History::sample(times, |time| coulomb.at(time).values())
}
