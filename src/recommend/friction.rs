//! Law, width and step of a friction model.

use super::{Rung, Space, wholes, written};
use crate::exact::coulomb::Coulomb;
use crate::history::History;
use crate::problem::friction::FrictionOscillator;
use crate::problem::parameter::{Value, shortest};
use crate::problem::{Case, Problem};
use std::f64::consts::PI;

/// Part by which x0 is not known: neighbours.
const UNSURE: f64 = 0.02;

/// Steps of a half-cycle up to which every whole number is searched, and the most.
const EVERY: u32 = 128;
const MOST: u32 = 640;

/// Widths searched.
const WIDTHS: [f64; 2] = [1e-6, 10.0];

/// Widths and steps for one or more laws and one release.
#[derive(Debug)]
pub struct Friction {
    /// Names of the laws.
    pub laws: Vec<&'static str>,
    /// Release.
    pub x0: f64,
}

/// Steps of a half-cycle.
fn parts() -> Vec<u32> {
    let mut parts: Vec<u32> = (2..EVERY).collect();
    parts.extend(wholes(EVERY, MOST, 1.05));
    parts
}

fn width(law: &str) -> &'static str {
    match law {
        "velocity-control" => "beta",
        _ => "alpha",
    }
}

impl Friction {
    /// Until a cycle after the exact rest: all that can be judged.
    fn duration(&self) -> f64 {
        Coulomb::new(self.x0).rest_time() + 2.0 * PI
    }

    fn case(&self, law: &'static str, own: f64, parts: u32, x0: f64) -> Case {
        let given = [
            ("law", Value::Name(law)),
            (width(law), Value::Number(own)),
            ("dT", Value::Number(PI / f64::from(parts))),
            ("duration", Value::Number(self.duration())),
            ("x0", Value::Number(x0)),
        ];
        // A grid within the table's ranges breaks no rule.
        Case::given(&FrictionOscillator, &given).0
    }

    fn widths(&self) -> Vec<&'static str> {
        let mut widths: Vec<_> = self.laws.iter().map(|law| width(law)).collect();
        widths.sort_unstable();
        widths
    }
}

impl Space for Friction {
    fn problem(&self) -> &'static dyn Problem {
        &FrictionOscillator
    }

    fn shown(&self) -> Vec<&'static str> {
        [vec!["law"], self.widths(), vec!["dT"]].concat()
    }

    fn stated(&self) -> Vec<&str> {
        vec!["law", "alpha", "beta", "dT", "duration", "x0"]
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
                100.0 * UNSURE
            ),
            "not searched: other releases, initial_slip pulled and sliding, steps that do not divide a half-cycle"
                .into(),
        ]
    }

    fn cost_title(&self) -> &'static str {
        "steps"
    }

    fn costs(&self) -> Vec<u64> {
        let steps = |parts| {
            let case = self.case(self.laws[0], 1.0, parts, self.x0);
            FrictionOscillator.steps(&case)
        };
        parts().into_iter().map(steps).collect()
    }

    fn rung(&self, at: usize) -> Rung {
        let parts = parts()[at];
        let widths = written(WIDTHS[0], WIDTHS[1], 20.0);
        let mut rung = Rung::default();
        for law in &self.laws {
            let first = rung.cases.len();
            for x0 in [1.0, 1.0 - UNSURE, 1.0 + UNSURE] {
                let cases = widths
                    .iter()
                    .map(|own| self.case(law, *own, parts, x0 * self.x0));
                rung.cases.extend(cases);
            }
            let count = widths.len();
            for i in first + 1..first + count - 1 {
                let tried = vec![i, i - 1, i + 1, i + count, i + 2 * count];
                rung.candidates.push(tried);
            }
        }
        rung
    }

    fn energy_drifts(&self) -> Option<[usize; 2]> {
        None
    }

    fn energy_gain(&self, _: &Case, _: &History) -> Option<f64> {
        None
    }
}
