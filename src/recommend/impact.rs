//! Spring, mesh and step of an impact of two equal bars.

use super::{Candidate, Rung, Space, written};
use crate::problem::impact::BarImpact;
use crate::problem::parameter::{Default, Value};
use crate::problem::{Case, Problem};

/// Elements of a bar.
const ELEMENTS: [u32; 22] = [
    2, 3, 4, 5, 6, 8, 10, 12, 14, 17, 20, 24, 28, 34, 40, 48, 56, 68, 80, 100, 120, 140,
];

/// Steps while a wave passes an element.
const PASSES: [u32; 5] = [1, 2, 4, 8, 16];

const DURATION: f64 = 1.5;

/// gamma, n and dt.
#[derive(Debug)]
pub struct Impact;

impl Impact {
    /// The impact falls `into` a step, 0..1.
    fn case(gamma: f64, n: u32, passes: u32, into: f64) -> Case {
        let dt = 0.5 / f64::from(n * passes);
        let mut case = Case::new(BarImpact.parameters());
        let values = [
            ("gamma", Value::Number(gamma)),
            ("n", Value::Whole(u64::from(n))),
            ("dt", Value::Number(dt)),
            ("duration", Value::Number(DURATION)),
            ("gap", Value::Number(2.0 * into * dt)),
        ];
        for (row, parameter) in case.table.iter().enumerate() {
            let given = values.iter().find(|(name, _)| *name == parameter.name);
            case.values[row] = match (given, parameter.default) {
                (Some((_, value)), _) => Some(*value),
                (None, Default::Is(value)) => Some(value),
                _ => None,
            };
        }
        // A grid within the table's ranges breaks no rule.
        let _ = BarImpact.complete(&mut case);
        case
    }
}

impl Space for Impact {
    fn problem(&self) -> &'static dyn Problem {
        &BarImpact
    }

    fn free(&self) -> &'static [&'static str] {
        &["gamma", "n", "dt"]
    }

    fn said(&self) -> Vec<String> {
        vec![
            format!(
                "searched: gamma 0.05 .. 10, n 2 .. {}, dt of 1 .. 1/{} of the time in which a wave passes an element, over duration {DURATION}",
                ELEMENTS[ELEMENTS.len() - 1],
                PASSES[PASSES.len() - 1],
            ),
            "reached also with gamma 12 % up and down and with the impact 0.37 into a step".into(),
        ]
    }

    fn cost_title(&self) -> &'static str {
        "steps × modes"
    }

    fn rungs(&self) -> Vec<Rung> {
        let gammas = written(0.05, 10.0, 20.0);
        let rung = |(n, passes): (u32, u32)| {
            let modes = 2.0 * f64::from(n + 1);
            Rung {
                cost: BarImpact.steps(&Impact::case(1.0, n, passes, 0.0)) as f64 * modes,
                candidates: gammas
                    .windows(3)
                    .map(|near| Candidate {
                        case: Impact::case(near[1], n, passes, 0.0),
                        tried: [
                            (near[0], 0.0),
                            (near[1], 0.0),
                            (near[2], 0.0),
                            (near[1], 0.37),
                        ]
                        .map(|(gamma, into)| Impact::case(gamma, n, passes, into))
                        .to_vec(),
                    })
                    .collect(),
            }
        };
        let pairs = ELEMENTS
            .iter()
            .flat_map(|n| PASSES.iter().map(|passes| (*n, *passes)));
        let mut rungs: Vec<Rung> = pairs.map(rung).collect();
        rungs.sort_by(|a, b| a.cost.total_cmp(&b.cost));
        rungs
    }
}
