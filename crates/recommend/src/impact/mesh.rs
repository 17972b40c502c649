//! Meshes and steps of a search.

use crate::Grid;
use crate::grid::integers;

/// Largest number of elements of a bar.
pub const MOST_ELEMENTS: u32 = 140;

/// Numbers of elements that a wave passes in a step. The first ones are searched with every mesh, the others with some. Explicit methods
/// are most accurate just below one element, so that the numbers are close there.
pub const PASSES: [f64; 27] = [
    4.0, 3.0, 2.5, 2.0, 1.75, 1.5, 1.25, 1.0, 0.75, 0.5, 0.98, 0.96, 0.94, 0.92, 0.9, 0.85, 0.8,
    0.7, 0.65, 0.6, 0.55, 0.45, 0.4, 0.375, 0.25, 0.125, 0.0625,
];

/// Number of entries of [`PASSES`] that are searched with every mesh.
pub const WITH_EVERY_MESH: usize = 10;

/// Those of the coarse grid, and the ratio of its meshes.
const COARSE_PASSES: [f64; 10] = [3.0, 2.0, 1.5, 1.0, 0.96, 0.8, 0.5, 0.25, 0.125, 0.0625];
const COARSE_RATIO: f64 = 1.25;

/// The step of a mesh, in T_I: these elements passed by a wave, in bars of n. All numbers of elements have four digits, and the quotient
/// of whole numbers is the nearest number to the fraction that a study shows.
pub fn step((n, passes): Mesh) -> f64 {
    (passes * 1e4).round() / (2e4 * f64::from(n))
}

/// Largest number of steps times modes of a case if n is searched.
const MOST_COST: u64 = 2_000_000;

/// Largest number of steps times modes of a case if n is given.
const MOST_COST_GIVEN: u64 = 200_000_000;

/// Elements of the left bar, and elements that a wave passes in a step.
pub type Mesh = (u32, f64);

/// The meshes and steps to search.
pub fn meshes(n: Option<u32>, grid: Grid) -> Vec<Mesh> {
    let passes: &[f64] = match grid {
        Grid::Coarse => &COARSE_PASSES,
        Grid::Fine => &PASSES,
    };
    let mut meshes = Vec::new();
    for (at, passes) in passes.iter().enumerate() {
        let ratio = match grid {
            Grid::Coarse => COARSE_RATIO,
            Grid::Fine if at < WITH_EVERY_MESH => 1.0,
            Grid::Fine => 1.05,
        };
        let elements = n.map_or_else(|| integers(2, MOST_ELEMENTS, ratio), |n| vec![n]);
        meshes.extend(elements.into_iter().map(|n| (n, *passes)));
    }
    meshes
}

/// Largest cost of a case.
pub fn most_cost(n: Option<u32>) -> u64 {
    n.map_or(MOST_COST, |_| MOST_COST_GIVEN)
}
