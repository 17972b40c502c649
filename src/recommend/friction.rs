//! Search space of a friction model: law, width and step.

use super::format::{is_positive_integer, plain};
use super::grid::{decades, integers};
use super::{CostLevel, SearchSpace};
use crate::exact::coulomb::Coulomb;
use crate::history::History;
use crate::problem::friction::FrictionOscillator;
use crate::problem::parameter::{Value, shortest};
use crate::problem::{Case, Problem};
use std::f64::consts::PI;

/// Relative difference of x0 of neighbours.
const X0_DIFFERENCE: f64 = 0.02;

/// Steps of a half-cycle: every integer below the first number, some integers up to the second.
const EVERY: u32 = 128;
const MOST: u32 = 640;

/// Smallest and largest width.
const WIDTHS: [f64; 2] = [1e-6, 10.0];

/// Widths and steps of one or more laws for one release.
#[derive(Debug)]
pub struct Friction {
    /// Names of the laws.
    pub laws: Vec<&'static str>,
    /// Displacement at release over Delta.
    pub x0: f64,
}

/// Numbers of steps of a half-cycle.
fn step_counts() -> Vec<u32> {
    let mut counts: Vec<u32> = (2..EVERY).collect();
    counts.extend(integers(EVERY, MOST, 1.05));
    counts
}

/// The parameter that is the width of a law.
fn width(law: &str) -> &'static str {
    match law {
        "velocity-control" => "beta",
        _ => "alpha",
    }
}

impl Friction {
    /// Until a cycle after the exact rest.
    fn duration(&self) -> f64 {
        Coulomb::new(self.x0).rest_time() + 2.0 * PI
    }

    fn case(&self, law: &'static str, width_value: f64, count: u32, x0: f64) -> Case {
        let given = [
            ("law", Value::Name(law)),
            (width(law), Value::Number(width_value)),
            ("dT", Value::Number(PI / f64::from(count))),
            ("duration", Value::Number(self.duration())),
            ("x0", Value::Number(x0)),
        ];
        // All values are in the ranges of the table, so that no rule is broken.
        Case::given(&FrictionOscillator, &given).0
    }

    fn widths(&self) -> Vec<&'static str> {
        let mut widths: Vec<_> = self.laws.iter().map(|law| width(law)).collect();
        widths.sort_unstable();
        widths
    }
}

impl SearchSpace for Friction {
    fn problem(&self) -> &'static dyn Problem {
        &FrictionOscillator
    }

    fn table_parameters(&self) -> Vec<&'static str> {
        [vec!["law"], self.widths(), vec!["dT"]].concat()
    }

    fn study_parameters(&self) -> Vec<&str> {
        vec!["law", "alpha", "beta", "dT", "duration", "x0"]
    }

    fn study_value(&self, case: &Case, name: &str) -> String {
        match (name, case.number(name)) {
            ("dT", Some(x)) if is_positive_integer(PI / x) => format!("pi/{}", (PI / x).round()),
            ("duration", Some(x)) if is_positive_integer(x / PI) => {
                format!("{}*pi", (x / PI).round())
            }
            _ => plain(case, name),
        }
    }

    fn notes(&self) -> Vec<String> {
        let ends = WIDTHS.map(shortest).join(" .. ");
        let widths = self.widths().join(" and ");
        vec![
            format!(
                "searched: {}; {widths} {ends}, 20 a decade; dT pi/2 .. pi/{EVERY} with every whole number, then in \
                 ratios of 1.05 to pi/{MOST}; duration {}*pi (a cycle after the exact rest)",
                self.laws.join(" and "),
                (self.duration() / PI).round()
            ),
            format!(
                "neighbours that must also reach the target: {widths} 12 % smaller and larger, x0 {} % smaller and larger",
                100.0 * X0_DIFFERENCE
            ),
            "not searched: other releases, initial_slip pulled and sliding, steps that do not divide a half-cycle"
                .into(),
        ]
    }

    fn cost_title(&self) -> &'static str {
        "steps"
    }

    fn costs(&self) -> Vec<u64> {
        let steps = |count| {
            let case = self.case(self.laws[0], 1.0, count, self.x0);
            FrictionOscillator.steps(&case)
        };
        step_counts().into_iter().map(steps).collect()
    }

    fn level(&self, index: usize) -> CostLevel {
        let steps = step_counts()[index];
        let widths = decades(WIDTHS[0], WIDTHS[1], 20.0);
        let mut level = CostLevel::default();
        for law in &self.laws {
            let first = level.cases.len();
            for x0 in [1.0, 1.0 - X0_DIFFERENCE, 1.0 + X0_DIFFERENCE] {
                let cases = widths
                    .iter()
                    .map(|width| self.case(law, *width, steps, x0 * self.x0));
                level.cases.extend(cases);
            }
            let count = widths.len();
            for i in first + 1..first + count - 1 {
                let cases = vec![i, i - 1, i + 1, i + count, i + 2 * count];
                level.candidates.push(cases);
            }
        }
        level
    }

    fn energy_drifts(&self) -> Option<[usize; 2]> {
        None
    }

    fn energy_gain(&self, _: &Case, _: &History) -> Option<f64> {
        None
    }
}
