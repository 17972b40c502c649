//! The candidates of a friction model, and their values in tables and studies.

use super::laws::width;
use super::{EVERY, Friction, MOST, WIDTHS, X0_DIFFERENCE, energy_gain};
use crate::problem::friction::FrictionOscillator;
use crate::problem::parameter::shortest;
use crate::problem::{Case, Problem, Solution};
use crate::recommend::format::{is_positive_integer, plain};
use crate::recommend::grid::decades;
use crate::recommend::setting::{METHOD_PARAMETERS, sentence};
use crate::recommend::{CostLevel, EnergyChange, Grid, SearchSpace, Variant, Variants};
use std::f64::consts::PI;

/// Widths of a decade.
const DECADE: f64 = 20.0;

/// One of so many widths is a candidate of the coarse grid.
const COARSE: usize = 4;

impl Friction {
    /// Names of the widths, each once.
    fn widths(&self) -> Vec<&'static str> {
        let laws = self.variants.iter();
        let mut widths: Vec<_> = laws.filter_map(|v| width(v.law.name)).collect();
        widths.sort_unstable();
        widths.dedup();
        widths
    }
}

impl SearchSpace for Friction {
    fn problem(&self) -> &'static dyn Problem {
        &FrictionOscillator
    }

    fn table_parameters(&self) -> Vec<&'static str> {
        let law = [
            "law", "exponent", "alpha", "beta", "sigma0", "sigma1", "dT", "method",
        ];
        [&law[..], &METHOD_PARAMETERS].concat()
    }

    fn study_parameters(&self) -> Vec<&str> {
        let law = [
            "law", "alpha", "beta", "exponent", "sigma0", "sigma1", "dT", "duration", "x0",
            "method",
        ];
        [&law[..], &METHOD_PARAMETERS].concat()
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
        let lugre = self.variants.iter().any(|v| v.law.name == "lugre");
        let bristles = match lugre {
            true => " (lugre: 1/sigma0, with sigma1 = sqrt(sigma0))",
            false => "",
        };
        vec![
            format!(
                "searched: {}; {}",
                sentence(self.variants.iter().map(|v| &v.law)),
                sentence(self.variants.iter().map(|v| &v.method)),
            ),
            format!(
                "widths {ends}, {DECADE} a decade{bristles}; dT pi/2 .. pi/{EVERY} with every whole number, then in ratios of \
                 1.05 to pi/{MOST}; duration {}*pi (a cycle after the exact rest)",
                (self.duration() / PI).round()
            ),
            format!(
                "neighbours that must also reach the target: {} 12 % smaller and larger, x0 {} % smaller and larger",
                match self.widths().as_slice() {
                    [one] => one,
                    _ => "width",
                },
                100.0 * X0_DIFFERENCE
            ),
            "not searched: stribeck, static_ratio and nu_ratio (other physics than the exact motion), other exponents and damping, \
             other releases, initial_slip pulled and sliding, steps that do not divide a half-cycle or break a rule"
                .into(),
        ]
    }

    fn cost_title(&self) -> &'static str {
        let halves = self.variants.iter().any(|v| v.method.name == "bathe");
        if halves {
            "steps × sub-steps"
        } else {
            "steps"
        }
    }

    fn costs(&self) -> Vec<u64> {
        let of_count = |count: u32| {
            let variants = self.variants.iter();
            variants.map(move |variant| self.cost(variant, count))
        };
        self.step_counts().into_iter().flat_map(of_count).collect()
    }

    fn level(&self, index: usize) -> CostLevel {
        let variant = &self.variants[self.variant_of(index)];
        let steps = self.step_counts()[index / self.variants.len()];
        let widths = match width(variant.law.name) {
            Some(_) => decades(WIDTHS[0], WIDTHS[1], DECADE),
            None => vec![1.0],
        };
        let every = match self.grid {
            Grid::Coarse => COARSE,
            Grid::Fine => 1,
        };
        let count = widths.len();
        let mut level = CostLevel::default();
        let mut allowed = vec![true; count];
        for x0 in [1.0, 1.0 - X0_DIFFERENCE, 1.0 + X0_DIFFERENCE] {
            for (width, allowed) in widths.iter().zip(&mut allowed) {
                let (case, broken) = self.case(variant, *width, steps, x0 * self.x0);
                *allowed &= broken.is_empty();
                level.cases.push(case);
            }
        }
        if count == 1 {
            level.candidates.extend(allowed[0].then(|| vec![0, 1, 2]));
            return level;
        }
        let inner = (1..count - 1).step_by(every);
        level.candidates = inner
            .filter(|i| allowed[i - 1..=i + 1].iter().all(|allowed| *allowed))
            .map(|i| vec![i, i - 1, i + 1, i + count, i + 2 * count])
            .collect();
        level
    }

    fn energy_change(&self, _: &Case, solution: &Solution) -> EnergyChange {
        EnergyChange {
            gain: energy_gain(&solution.computed, &solution.exact),
            loss: 0.0,
        }
    }
}

impl Variants for Friction {
    fn variants(&self) -> &[Variant] {
        &self.variants
    }

    fn variant_of(&self, level: usize) -> usize {
        level % self.variants.len().max(1)
    }

    fn with(&self, variants: &[usize], grid: Grid) -> Box<dyn Variants> {
        let variants = variants.iter().map(|at| self.variants[*at].clone());
        Box::new(Friction {
            variants: variants.collect(),
            grid,
            x0: self.x0,
        })
    }

    fn space(&self) -> &dyn SearchSpace {
        self
    }
}
