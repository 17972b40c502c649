//! Width and step of a friction model.

use super::{Candidate, Rung, Space, written};
use crate::exact::coulomb::Coulomb;
use crate::problem::friction::FrictionOscillator;
use crate::problem::parameter::{Default, Value};
use crate::problem::{Case, Problem};
use std::f64::consts::PI;

/// Steps of a half-cycle.
const PARTS: [u32; 34] = [
    2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 16, 18, 20, 24, 28, 32, 36, 40, 48, 56, 64, 80, 96, 112,
    128, 160, 192, 224, 256, 320, 384, 512, 640,
];

/// Part by which x0 is not known: neighbours.
const UNSURE: f64 = 0.02;

/// Widths and steps for one law and one release.
#[derive(Debug)]
pub struct Friction {
    /// Name of the law.
    pub law: &'static str,
    /// Release.
    pub x0: f64,
}

impl Friction {
    fn width(&self) -> &'static str {
        match self.law {
            "velocity-control" => "beta",
            _ => "alpha",
        }
    }

    /// Until a cycle after the exact rest: all that can be judged.
    fn duration(&self) -> f64 {
        Coulomb::new(self.x0).rest_time() + 2.0 * PI
    }

    fn case(&self, width: f64, parts: u32, x0: f64) -> Case {
        let mut case = Case::new(FrictionOscillator.parameters());
        let values = [
            ("law", Value::Name(self.law)),
            (self.width(), Value::Number(width)),
            ("dT", Value::Number(PI / f64::from(parts))),
            ("duration", Value::Number(self.duration())),
            ("x0", Value::Number(x0)),
        ];
        for (row, parameter) in case.table.iter().enumerate() {
            let given = values.iter().find(|(name, _)| *name == parameter.name);
            case.values[row] = match (given, parameter.default, parameter.applies) {
                (Some((_, value)), ..) => Some(*value),
                (None, Default::Is(value), Some((_, law))) if law == self.law => Some(value),
                _ => None,
            };
        }
        case
    }
}

impl Space for Friction {
    fn problem(&self) -> &'static dyn Problem {
        &FrictionOscillator
    }

    fn free(&self) -> &'static [&'static str] {
        match self.law {
            "velocity-control" => &["beta", "dT"],
            _ => &["alpha", "dT"],
        }
    }

    fn said(&self) -> Vec<String> {
        vec![
            format!(
                "searched: {} 0.001 .. 10, dT pi/2 .. pi/{}, over duration {}*pi (a cycle after the exact rest)",
                self.width(),
                PARTS[PARTS.len() - 1],
                (self.duration() / PI).round()
            ),
            format!(
                "reached also with {} 12 % up and down and with x0 {} % up and down",
                self.width(),
                100.0 * UNSURE
            ),
        ]
    }

    fn cost_title(&self) -> &'static str {
        "steps"
    }

    fn rungs(&self) -> Vec<Rung> {
        let widths = written(0.001, 10.0, 20.0);
        let rung = |parts: u32| Rung {
            cost: FrictionOscillator.steps(&self.case(1.0, parts, self.x0)) as f64,
            candidates: widths
                .windows(3)
                .map(|near| Candidate {
                    case: self.case(near[1], parts, self.x0),
                    tried: [
                        (near[0], 1.0),
                        (near[1], 1.0),
                        (near[2], 1.0),
                        (near[1], 1.0 - UNSURE),
                        (near[1], 1.0 + UNSURE),
                    ]
                    .map(|(width, x0)| self.case(width, parts, x0 * self.x0))
                    .to_vec(),
                })
                .collect(),
        };
        PARTS.into_iter().map(rung).collect()
    }
}
