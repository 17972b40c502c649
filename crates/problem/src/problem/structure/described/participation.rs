//! The parts of the mass that move in the modes, for `explain`.

use super::lists::lines;
use crate::problem::numbers::short::short;
use crate::problem::structure::model::damping::modes;
use crate::problem::structure::parts::damping::vibrating;
use crate::system::structure::{Direction, Structure};
use std::f64::consts::PI;

/// Most modes that are shown, and the part of the mass in each direction that ends the list.
const MOST_MODES: usize = 10;
const ENOUGH: f64 = 0.95;

/// Part of the mass from which a mode moves in a direction.
const LEAST: f64 = 1e-4;

/// The lowest modes without contacts, with the part of the mass in each direction that an acceleration of the ground moves in them:
/// (phi^T M 1)^2 over the mass, phi^T M phi = 1. `shaken` has M 1 and the mass of each direction.
pub fn described(structure: &Structure, shaken: &[(Direction, Vec<f64>, f64)]) -> String {
    let Some(modes) = modes(structure, &structure.stiffness) else {
        return String::new();
    };
    let held = vibrating(&modes.omega2);
    let of_directions = shaken.iter().map(|(direction, inertia, mass)| {
        let along: Vec<(usize, f64)> = inertia.iter().copied().enumerate().collect();
        let components = modes.components(structure, &along).into_iter();
        let parts: Vec<f64> = components
            .map(|component| component * component / mass)
            .collect();
        (direction.name(), parts)
    });
    let parts: Vec<(&str, Vec<f64>)> = of_directions.collect();
    // Nodes of reduced matrices carry others.
    let mut nodes = structure.nodes.iter();
    let is_reduced = nodes.any(|node| node.direction == Direction::Modal);
    let mut sums = vec![0.0; parts.len()];
    let mut shown = Vec::new();
    for mode in held.into_iter().take(MOST_MODES) {
        let mut texts = Vec::new();
        for ((direction, parts), sum) in parts.iter().zip(&mut sums) {
            *sum += parts[mode];
            if parts[mode] >= LEAST {
                texts.push(format!("{direction} {:.4}", parts[mode]));
            }
        }
        if !is_reduced {
            let node = &structure.nodes[modes.most_moved(mode)].name;
            texts.push(format!("mostly {node}"));
        }
        let period = short(2.0 * PI / modes.omega2[mode].sqrt());
        shown.push(format!("{period}: {}", texts.join(", ")));
        if sums.iter().all(|sum| *sum >= ENOUGH) {
            break;
        }
    }
    let pairs = parts.iter().zip(&sums);
    let totals = pairs.map(|((direction, _), sum)| format!("{direction} {sum:.4}"));
    if !shown.is_empty() {
        shown.push(format!("sum: {}", totals.collect::<Vec<_>>().join(", ")));
    }
    lines(
        "periods without contacts, with the participating part of the mass",
        shown,
    )
}
