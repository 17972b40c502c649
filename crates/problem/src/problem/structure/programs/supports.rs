//! Supports that move, in a request.
//!
//! The nodes of a structure have w = u - R u_s, and its loads are those for w. In a request u is absolute, so that a support pulls by
//!
//! ```text
//! M u'' + C u' + K u + M_s a_s + C_s v_s + K_s u_s = p + forces of the contacts,   K_s = -(K R + load for w by u_s), ...
//! ```

use super::json::{Members, numbers};
use crate::system::structure::{Along, Quantity, Signal, Structure, Support};
use std::sync::Arc;

/// Sums below this part of their terms are round-off.
const ROUND_OFF: f64 = 1e-12;

/// The motions of all supports, each with its columns of K, C and M; those of zeros are left out, but that of K.
pub(super) fn of_supports(
    members: &mut Members,
    structure: &Structure,
    (dt, steps): (f64, usize),
    base64: bool,
) {
    let supports = || structure.supports.iter();
    let split = |support: &'_ Support| -> [String; 2] {
        let (name, direction) = support
            .name
            .rsplit_once('.')
            .unwrap_or((&support.name, "x"));
        [name.to_owned(), direction.to_owned()]
    };
    let mut names: Vec<String> = Vec::new();
    for support in supports() {
        let [name, _] = split(support);
        if !names.contains(&name) {
            names.push(name);
        }
    }
    for name in names {
        members.object(&name, |members| {
            for support in supports().filter(|support| split(support)[0] == name) {
                members.object(&split(support)[1], |members| {
                    let at = |which: usize| -> Vec<f64> {
                        let times = (0..=steps).map(|i| i as f64 * dt);
                        times.map(|t| support.motion.at(t)[which]).collect()
                    };
                    for (key, which) in [("u", 0), ("v", 1), ("a", 2)] {
                        members.add(key, |text| numbers(text, &at(which), base64));
                    }
                    for (key, quantity) in [
                        ("K", Quantity::Displacement),
                        ("C", Quantity::Velocity),
                        ("M", Quantity::Acceleration),
                    ] {
                        let column = column(structure, support, quantity);
                        if key == "K" || !column.is_empty() {
                            members.put(key, column);
                        }
                    }
                });
            }
        });
    }
}

/// The column of a support for its u, v or a.
fn column(structure: &Structure, support: &Support, quantity: Quantity) -> Along {
    let n = structure.len();
    let (mut sums, mut sizes) = (vec![0.0; n], vec![0.0; n]);
    let mut add = |row: usize, x: f64| {
        sums[row] -= x;
        sizes[row] += f64::abs(x);
    };
    let mass = structure.mass();
    let matrix = match quantity {
        Quantity::Displacement => &structure.stiffness,
        Quantity::Velocity => &structure.damping,
        Quantity::Acceleration => &mass,
    };
    for ((i, j), value) in matrix.entries() {
        add(i, value * support.carried[j]);
        if i != j {
            add(j, value * support.carried[i]);
        }
    }
    for load in &structure.loads {
        let Signal::Motion(motion, of) = &*load.signal else {
            continue;
        };
        if Arc::ptr_eq(motion, &support.motion) && *of == quantity {
            load.pattern.iter().for_each(|(row, x)| add(*row, *x));
        }
    }
    let rows = sums.into_iter().zip(sizes).enumerate();
    let kept = rows.filter(|(_, (sum, size))| sum.abs() > ROUND_OFF * size);
    kept.map(|(row, (sum, _))| (row, sum)).collect()
}
