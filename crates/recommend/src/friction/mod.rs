//! Search space of a friction model: law, method, width and step.

mod laws;
mod releases;
mod space;
mod task;

pub use laws::names as law_names;
pub use releases::{Releases, ReleasesFault};
pub use task::{ENERGY_GAIN, FrictionTask, X0};

use super::grid::integers;
use super::{Fixed, Grid, Variant, cost, setting};
use slipgap_motion::exact::coulomb::Coulomb;
use slipgap_motion::history::History;
use slipgap_problem::problem::friction::FrictionOscillator;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_problem::problem::{Case, Problem, Violation};
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

/// Laws, methods, widths and steps for one release or a range of them.
#[derive(Debug, Clone)]
pub struct Friction {
    variants: Vec<Variant>,
    grid: Grid,
    /// Displacements at release over Delta.
    releases: Releases,
}

impl Friction {
    /// All laws with all methods, or those that the user fixes.
    pub fn new(fixed: Fixed, releases: impl Into<Releases>) -> Friction {
        let releases = releases.into();
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
        let all = Friction {
            variants,
            grid,
            releases,
        };
        let suitable = |variant: &&Variant| {
            // The smallest step, and the largest width.
            let (_, broken) = all.case(variant, WIDTHS[1], MOST, releases.longest());
            broken.is_empty()
        };
        let variants = all.variants.iter().filter(suitable).cloned().collect();
        Friction { variants, ..all }
    }

    /// Until a cycle after the exact rest. The neighbours of one release have its duration.
    fn duration(&self, x0: f64) -> f64 {
        let x0 = match self.releases {
            Releases::One(one) => one,
            Releases::Range(..) => x0,
        };
        duration(x0)
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
            ("duration", Value::Number(self.duration(x0))),
            ("x0", Value::Number(x0)),
        ];
        given.extend(variant.law.given("law"));
        given.extend(variant.method.given("method"));
        given.extend(laws::of_width(variant.law.name, width));
        Case::given(&FrictionOscillator, &given)
    }

    /// Steps times sub-steps.
    fn cost(&self, variant: &Variant, count: u32) -> u64 {
        let (case, _) = self.case(variant, WIDTHS[1], count, self.releases.longest());
        cost(&FrictionOscillator, &case)
    }
}

/// Until a cycle after the exact rest.
fn duration(x0: f64) -> f64 {
    Coulomb::new(x0).rest_time() + 2.0 * PI
}

/// The same case released elsewhere, until a cycle after its exact rest.
fn released(case: &Case, x0: f64) -> Case {
    let mut released = case.clone();
    let rows = FrictionOscillator.parameters().iter();
    for (row, parameter) in rows.enumerate() {
        match &*parameter.name {
            "x0" => released.values[row] = Some(Value::Number(x0)),
            "duration" => released.values[row] = Some(Value::Number(duration(x0))),
            _ => {}
        }
    }
    released
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
