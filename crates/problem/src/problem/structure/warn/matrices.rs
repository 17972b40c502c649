//! Natural periods of matrices that no structure has.

use super::doubt::Doubt;
use crate::problem::numbers::short::short;
use crate::problem::numbers::unit::Dimension;
use crate::problem::structure::metrics::unit_consistency::size_of;
use crate::problem::structure::metrics::unit_names::UnitNames;
use crate::problem::structure::parts::template::Template;
use crate::solve::Warning;
use crate::system::structure::Structure;
use crate::system::structure::sparse::factor::Factor;
use std::f64::consts::PI;

/// Longest periods of structures in s: of a stiff part, of a bridge with a long span.
const PERIODS: [f64; 2] = [0.05, 10.0];

/// Smallest pivot over its diagonal: below it a part is free but for round-off.
const SMALLEST: f64 = 1e-10;

/// Steps of the inverse iteration: Rayleigh's quotient then has some percent, and the limits are farther from every structure.
const STEPS: usize = 8;

/// A structure with matrices whose longest period is out of all bounds, if the units say so.
pub fn periods(template: &Template, structure: &Structure) -> Option<Doubt> {
    let units = UnitNames::of(&template.units).filter(|_| !template.matrices.is_empty())?;
    let second = size_of(units.time, Dimension::Time)?;
    let period = longest(structure)? * second;
    let text = format!(
        "the longest period is {} s",
        short((period * 1e4).round() / 1e4)
    );
    let fits = (PERIODS[0]..=PERIODS[1]).contains(&period);
    (!fits).then_some((Warning::MatrixPeriods, text))
}

/// The longest period without contacts; `None` with a rigid-body mode.
fn longest(structure: &Structure) -> Option<f64> {
    let factor = Factor::regular(&structure.stiffness, SMALLEST).ok()?;
    let product = |x: &[f64]| {
        let products = structure.nodes.iter().zip(x).map(|(node, x)| node.mass * x);
        let mut sum: Vec<f64> = products.collect();
        structure.coupled_mass.add_product(x, &mut sum);
        sum
    };
    // No symmetry of a structure is one of these displacements.
    let mut u: Vec<f64> = (0..structure.len())
        .map(|i| 1.0 + (i % 7) as f64 / 7.0)
        .collect();
    let mut omega2 = f64::NAN;
    for _ in 0..STEPS {
        let inertia = product(&u);
        u.clone_from(&inertia);
        factor.solve(&mut u);
        // u^T K u over u^T M u.
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let mass = dot(&u, &product(&u));
        omega2 = dot(&u, &inertia) / mass;
        let size = mass.sqrt();
        u.iter_mut().for_each(|u| *u /= size);
    }
    (omega2 > 0.0 && omega2.is_finite()).then(|| 2.0 * PI / omega2.sqrt())
}
