//! Meshes and steps of a search.

use crate::recommend::grid::integers;

/// Largest number of elements of a bar.
pub const MOST_ELEMENTS: u32 = 140;

/// Numbers of elements that a wave passes in a step. The first ones are searched with every mesh, the others with some.
pub const PASSES: [f64; 14] = [
    4.0, 3.0, 2.5, 2.0, 1.75, 1.5, 1.25, 1.0, 0.75, 0.5, 0.375, 0.25, 0.125, 0.0625,
];

/// Number of entries of [`PASSES`] that are searched with every mesh.
pub const WITH_EVERY_MESH: usize = 10;

/// Largest number of steps times modes of a case if n is searched.
const MOST_COST: u64 = 2_000_000;

/// Largest number of steps times modes of a case if n is given.
const MOST_COST_GIVEN: u64 = 200_000_000;

/// Elements of the left bar, elements that a wave passes in a step, and mass matrix.
pub type Mesh = (u32, f64, &'static str);

/// The meshes and steps to search, with their costs. `cost` is `None` for a mesh that is not searched.
pub fn affordable(
    n: Option<u32>,
    masses: &[&'static str],
    cost: impl Fn(Mesh) -> Option<u64>,
) -> Vec<(Mesh, u64)> {
    let most = n.map_or(MOST_COST, |_| MOST_COST_GIVEN);
    let mut meshes = Vec::new();
    for (at, passes) in PASSES.into_iter().enumerate() {
        let ratio = if at < WITH_EVERY_MESH { 1.0 } else { 1.05 };
        let elements = n.map_or_else(|| integers(2, MOST_ELEMENTS, ratio), |n| vec![n]);
        for n in elements {
            for mass in masses {
                let mesh = (n, passes, *mass);
                let cost = cost(mesh).filter(|cost| *cost <= most);
                meshes.extend(cost.map(|cost| (mesh, cost)));
            }
        }
    }
    meshes
}
