//! The impact of two bars of `[I]`, or of a bar on a wall, in scales of the left bar's contact duration T_I = 2 L/C0.

mod between;
mod once;
mod rules;
pub mod run;
pub mod scaled;
mod snapshot;
mod tables;

use super::parameter::Parameter;
use super::{Budget, Case, Metric, Problem, Profile, Quantity, Snapshot, Solution, Violation};
use crate::history::History;
use crate::metrics::{self, steps};
use scaled::Scaled;
use tables::{BUDGETS, METRICS, PARAMETERS, PROFILES, QUANTITIES};

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

    fn quantities(&self) -> &'static [Quantity] {
        &QUANTITIES
    }

    fn budgets(&self) -> &'static [Budget] {
        &BUDGETS
    }

    fn step(&self) -> &'static str {
        "dt"
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
        let number = |name| case.number(name).unwrap_or(f64::NAN);
        steps(number("duration"), number("dt"))
    }

    fn work(&self, case: &Case) -> u64 {
        let modes = |name| case.number(name).map_or(0, |n| n as u64 + 1);
        let all = modes("n") + modes("right.n");
        self.steps(case).saturating_mul(all)
    }

    fn solve(&self, case: &Case, wanted: &[usize]) -> Result<Solution, String> {
        let number = |name: &str| {
            case.number(name)
                .ok_or_else(|| format!("{name} is not given"))
        };
        let (dt, duration) = (number("dt")?, number("duration")?);
        let scaled = Scaled::new(case).ok_or("a parameter is not given")?;
        let done = run::run(&scaled, dt, self.steps(case));
        judged(&scaled, done, duration, wanted)
    }

    fn solve_once(&self, case: &Case, wanted: &[usize]) -> Result<Solution, String> {
        let given = case.number("dt").zip(case.number("duration"));
        let (dt, duration) = given.ok_or("dt or duration is not given")?;
        let scaled = Scaled::new(case).ok_or("a parameter is not given")?;
        let done = once::run(&scaled, dt, self.steps(case))?;
        judged(&scaled, done, duration, wanted)
    }

    fn profiles(&self) -> &'static [Profile] {
        &PROFILES
    }

    fn place_title(&self) -> &'static str {
        "*x*/*L*"
    }

    fn snapshots(&self, case: &Case, times: &[f64]) -> Vec<Snapshot> {
        match (Scaled::new(case), case.number("dt")) {
            (Some(scaled), Some(dt)) => snapshot::snapshots(&scaled, dt, self.steps(case), times),
            _ => Vec::new(),
        }
    }

    fn exact(&self, case: &Case, times: &[f64]) -> Option<History> {
        let wave = Scaled::new(case)?.bars.solve(*times.last()?);
        Some(wave.line(times))
    }
}

/// A run beside the exact solution, with its metrics.
fn judged(
    scaled: &Scaled,
    done: run::Run,
    duration: f64,
    wanted: &[usize],
) -> Result<Solution, String> {
    if !done.history.is_finite() {
        return Err("the motion leaves the range of double precision".into());
    }
    let wave = scaled.bars.solve(duration);
    let exact = wave.history(&done.history.time);
    let mut metrics = metrics::impact::evaluate(
        &done.history,
        &wave,
        duration,
        &done.energy,
        done.restitution,
    );
    let budget = wanted
        .iter()
        .any(|&row| !METRICS[row].default)
        .then(|| between::between(scaled, &done.history.time))
        .flatten()
        .map(|[spring, chain]| {
            metrics::impact::budget(&done.history, &wave, &spring, &chain, duration)
        });
    metrics.extend(budget.unwrap_or([None; 12]));
    Ok(Solution {
        computed: done.history,
        exact,
        metrics,
    })
}
