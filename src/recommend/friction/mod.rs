//! Search space of a friction model: law, method, width and step.

mod laws;
mod space;
mod task;

pub use laws::names as law_names;
pub use task::{ENERGY_GAIN, FrictionTask, X0, check_release};

use super::grid::integers;
use super::{Fixed, Grid, Variant, setting};
use crate::exact::coulomb::Coulomb;
use crate::history::History;
use crate::problem::friction::FrictionOscillator;
use crate::problem::parameter::Value;
use crate::problem::{Case, Problem, Violation};
use std::f64::consts::PI;

/// Relative difference of x0 of neighbours.
const X0_DIFFERENCE: f64 = 0.02;

/// Steps of a half-cycle: every integer below the first number, some integers up to the second.
const EVERY: u32 = 128;
const MOST: u32 = 640;

/// Ratio of the steps of a half-cycle on the coarse grid.
const COARSE: f64 = 1.2;

/// Smallest and largest width.
const WIDTHS: [f64; 2] = [1e-6, 10.0];

/// Laws, methods, widths and steps for one release.
#[derive(Debug, Clone)]
pub struct Friction {
    variants: Vec<Variant>,
    grid: Grid,
    /// Displacement at release over Delta.
    x0: f64,
}

impl Friction {
    /// All laws with all methods, or those that the user fixes.
    pub fn new(fixed: Fixed, x0: f64) -> Friction {
        let laws = laws::names().into_iter();
        let laws = laws.filter(|name| fixed.law.is_none_or(|only| only == *name));
        let mut variants = Vec::new();
        for law in laws.flat_map(laws::law) {
            for method in setting::methods(&FrictionOscillator, fixed.method) {
                let law = law.clone();
                variants.push(Variant {
                    law,
                    method,
                    mass: None,
                });
            }
        }
        let grid = Grid::Fine;
        let all = Friction { variants, grid, x0 };
        let suitable = |variant: &&Variant| {
            // The smallest step, and the largest width.
            let (_, broken) = all.case(variant, WIDTHS[1], MOST, x0);
            broken.is_empty()
        };
        let variants = all.variants.iter().filter(suitable).cloned().collect();
        Friction { variants, ..all }
    }

    /// Until a cycle after the exact rest.
    fn duration(&self) -> f64 {
        Coulomb::new(self.x0).rest_time() + 2.0 * PI
    }

    /// Numbers of steps of a half-cycle.
    fn step_counts(&self) -> Vec<u32> {
        match self.grid {
            Grid::Coarse => integers(2, MOST, COARSE),
            Grid::Fine => {
                let mut counts: Vec<u32> = (2..EVERY).collect();
                counts.extend(integers(EVERY, MOST, 1.05));
                counts
            }
        }
    }

    /// A case, and the rules that it breaks.
    fn case(&self, variant: &Variant, width: f64, count: u32, x0: f64) -> (Case, Vec<Violation>) {
        let mut given = vec![
            ("dT", Value::Number(PI / f64::from(count))),
            ("duration", Value::Number(self.duration())),
            ("x0", Value::Number(x0)),
        ];
        given.extend(variant.law.given("law"));
        given.extend(variant.method.given("method"));
        given.extend(laws::of_width(variant.law.name, width));
        Case::given(&FrictionOscillator, &given)
    }

    /// Steps times sub-steps.
    fn cost(&self, variant: &Variant, count: u32) -> u64 {
        let (case, _) = self.case(variant, WIDTHS[1], count, self.x0);
        let system = FrictionOscillator.system(&case);
        let parts = system.map_or(1, |system| system.method.sub_steps());
        FrictionOscillator.steps(&case) * parts
    }
}

/// The largest excess of the mechanical energy (X^2 + V^2)/2 over that of the exact motion at a step, over the energy at release: what
/// the motion has more than the energy at release minus the exact work of friction. It is not negative, because both begin alike.
pub fn energy_gain(computed: &History, exact: &History) -> f64 {
    let energies = |of: &History| -> Vec<f64> {
        let states = of.displacement().iter().zip(of.velocity());
        states.map(|(x, v)| 0.5 * (x * x + v * v)).collect()
    };
    let (computed, exact) = (energies(computed), energies(exact));
    let Some(start) = exact.first().copied() else {
        return f64::INFINITY;
    };
    let excess = computed.iter().zip(&exact).map(|(c, e)| (c - e) / start);
    excess.fold(0.0, f64::max)
}
