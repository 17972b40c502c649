//! Supports with motions of their own.
//!
//! With rows f of free nodes and s of supports, u_s is given and
//!
//! ```text
//! M a + C v + K u + B S = p - (M_fs a_s + C_fs v_s + K_fs u_s)
//! ```
//!
//! The nodes of a [`Structure`] have w = u - R u_s, where R u_s is how the nodes follow slow supports: K R = -K_fs. Then no load
//! depends on the displacements of the supports, which may be large against w and against the gaps:
//!
//! ```text
//! M a_w + C v_w + K w + B S = p - (M R + M_fs) a_s - (C R + C_fs) v_s,   r = B^T w + gap + (B^T R + B_s^T) u_s
//! ```
//!
//! For equal motions of all supports R u_s is this motion at every node, and w is the displacement relative to the ground.
//!
//! Any R gives the same u. A support whose displacement is given has R = 0, so that w is u and the loads are -C_fs v_s - K_fs u_s: its
//! acceleration may be large and short against a step, which then would miss it.
//!
//! Where K is singular, because springs do not hold a part in some direction, the contacts that hold it at
//! rest say what it follows, or else all of its contacts, by weak springs in their places; without any, it follows nothing. What is
//! left of K R + K_fs is then a load by u_s.

use super::{Along, Contact, Load, Motion, Quantity, Reaction, Signal, Structure, Symmetric};
use crate::system::structure::sparse::factor::{Factor, NotPositive};
use std::sync::Arc;

/// A support that moves in a direction.
#[derive(Debug, Clone)]
pub struct Support {
    /// Its name, such as `left.x`.
    pub name: String,
    /// Its motion.
    pub motion: Arc<Motion>,
    /// u of each node beside w for a unit of its displacement: its column of R.
    pub carried: Vec<f64>,
    /// r of each contact beside B^T w for a unit of its displacement.
    pub gaps: Vec<f64>,
}

/// Pivots below this part of the diagonal are round-off: of a chain of n springs they are 1/n of it.
const SINGULAR: f64 = 1e-12;

/// Stiffness of the springs in the places of contacts, over the largest entry of K.
const WEAK: f64 = 1e-6;

/// Most directions in which a part that nothing holds may move.
const MOST_PINS: usize = 64;

/// Sums below this part of their terms are round-off.
const ROUND_OFF: f64 = 1e-12;

impl Structure {
    /// Adds a C that acts on the motion beside R u_s, K R = -K_fs, also if the equations have R = 0: then C R v_s is a load.
    pub fn damp_beside_supports(&mut self, damping: &Symmetric) {
        self.damping.add_matrix(damping, 1.0);
        let displacements = self.loads.iter().filter_map(|load| match &*load.signal {
            Signal::Motion(motion, Quantity::Displacement) if !motion.carries() => {
                Some((motion.clone(), load.pattern.clone()))
            }
            Signal::Motion(..) | Signal::Sine { .. } | Signal::Table(_) => None,
        });
        let displaced: Vec<_> = displacements.collect();
        if displaced.is_empty() {
            return;
        }
        let Some(factor) = pinned(&self.stiffness) else {
            return;
        };
        for (motion, of_displacement) in displaced {
            let mut r = vec![0.0; self.len()];
            of_displacement.iter().for_each(|(row, x)| r[*row] += x);
            factor.solve(&mut r);
            r.iter_mut().for_each(|x| *x = -*x);
            let pattern = pattern(damping, &r, &[]);
            if !pattern.is_empty() {
                let signal = Arc::new(Signal::Motion(motion, Quantity::Velocity));
                self.loads.push(Load { pattern, signal });
            }
        }
    }

    /// Takes the supports out of the equations. Before, rows of matrices and places of contacts from the number of nodes on are
    /// those of the supports in this order.
    pub fn prescribe(&mut self, motions: Vec<(String, Arc<Motion>)>) {
        if motions.is_empty() {
            return;
        }
        let n = self.len();
        let count = motions.len();
        let [mass, damping, stiffness] = [&self.coupled_mass, &self.damping, &self.stiffness]
            .map(|matrix| Split::new(matrix, n));
        let mut carried = carried(self, &stiffness, count);
        for (r, (_, motion)) in carried.iter_mut().zip(&motions) {
            if !motion.carries() {
                r.fill(0.0);
            }
        }
        if let Some(observed) = &mut self.observed {
            observed.reactions = (0..count)
                .map(|s| Reaction {
                    nodes: [&mass, &damping, &stiffness].map(|of| of.columns[s].clone()),
                    supports: [&mass, &damping, &stiffness].map(|of| of.own[s].clone()),
                    contacts: own_factors(&self.contacts, n + s),
                })
                .collect();
        }
        (self.coupled_mass, self.damping) = (mass.free, damping.free);
        self.stiffness = stiffness.free;
        let mass_of_nodes = self.mass();
        for (s, (name, motion)) in motions.into_iter().enumerate() {
            let r = &carried[s];
            for (quantity, matrix, column) in [
                (Quantity::Acceleration, &mass_of_nodes, &mass.columns),
                (Quantity::Velocity, &self.damping, &damping.columns),
                (Quantity::Displacement, &self.stiffness, &stiffness.columns),
            ] {
                let pattern = pattern(matrix, r, column.get(s).map_or(&[], |factors| &factors[..]));
                if !pattern.is_empty() {
                    let signal = Arc::new(Signal::Motion(motion.clone(), quantity));
                    self.loads.push(Load { pattern, signal });
                }
            }
            let contacts = self.contacts.iter();
            let gaps = contacts
                .map(|contact| gap(&contact.along, r, n, s))
                .collect();
            self.supports.push(Support {
                name,
                motion,
                carried: r.clone(),
                gaps,
            });
        }
        for contact in &mut self.contacts {
            contact.along.retain(|(node, _)| *node < n);
        }
    }
}

/// A matrix of nodes and supports.
struct Split {
    /// The rows and columns of the nodes.
    free: Symmetric,
    /// The columns of the supports in the rows of the nodes.
    columns: Vec<Along>,
    /// The columns of the supports in the rows of the supports.
    own: Vec<Along>,
}

impl Split {
    fn new(matrix: &Symmetric, n: usize) -> Split {
        let mut free = Symmetric::zeros(n);
        let count = matrix.size().saturating_sub(n);
        let (mut columns, mut among_supports) = (vec![Vec::new(); count], vec![Vec::new(); count]);
        for ((i, j), value) in matrix.entries() {
            // i >= j.
            if i < n {
                free.add(i, j, value);
            } else if j < n {
                columns[i - n].push((j, value));
            } else {
                among_supports[i - n].push((j - n, value));
                if i != j {
                    among_supports[j - n].push((i - n, value));
                }
            }
        }
        Split {
            free,
            columns,
            own: among_supports,
        }
    }
}

/// -(A r + column) without its round-off.
fn pattern(matrix: &Symmetric, r: &[f64], column: &[(usize, f64)]) -> Along {
    let n = r.len();
    let (mut sums, mut sizes) = (vec![0.0; n], vec![0.0; n]);
    let mut add = |row: usize, value: f64| {
        sums[row] -= value;
        sizes[row] += f64::abs(value);
    };
    for ((i, j), value) in matrix.entries() {
        add(i, value * r[j]);
        if i != j {
            add(j, value * r[i]);
        }
    }
    for (row, value) in column {
        add(*row, *value);
    }
    let sums_and_sizes = sums.into_iter().zip(sizes).enumerate();
    let kept = sums_and_sizes.filter(|(_, (sum, size))| sum.abs() > ROUND_OFF * size);
    kept.map(|(row, (sum, _))| (row, sum)).collect()
}

/// The factor of a place in r of each contact that has one.
fn own_factors(contacts: &[Contact], row: usize) -> Along {
    let factors = contacts.iter().enumerate().filter_map(|(c, contact)| {
        let entry = contact.along.iter().find(|(at, _)| *at == row)?;
        Some((c, entry.1))
    });
    factors.collect()
}

/// B^T r + B_s^T of support `s` for a contact, without its round-off.
fn gap(along: &[(usize, f64)], r: &[f64], n: usize, s: usize) -> f64 {
    let terms = along
        .iter()
        .map(|(node, factor)| match node.checked_sub(n) {
            None => factor * r[*node],
            Some(support) if support == s => *factor,
            Some(_) => 0.0,
        });
    let (sum, size) = terms.fold((0.0, 0.0), |(sum, size), x| (sum + x, size + f64::abs(x)));
    if f64::abs(sum) > ROUND_OFF * size {
        sum
    } else {
        0.0
    }
}

/// R by columns: from K, from K and the contacts that hold, from K and all contacts, until the matrix is regular.
fn carried(structure: &Structure, stiffness: &Split, count: usize) -> Vec<Vec<f64>> {
    let n = structure.len();
    let columns = |columns: &[Along]| -> Vec<Vec<f64>> {
        let dense = |column_of: &Along| {
            let mut column = vec![0.0; n];
            column_of
                .iter()
                .for_each(|(row, value)| column[*row] -= value);
            column
        };
        columns.iter().map(dense).collect()
    };
    if let Ok(factor) = Factor::regular(&stiffness.free, SINGULAR) {
        return solved(&factor, columns(&stiffness.columns));
    }
    let largest = stiffness.free.largest();
    let weak = if largest > 0.0 { WEAK * largest } else { 1.0 };
    let mut with_contacts = Split {
        free: stiffness.free.clone(),
        columns: stiffness.columns.clone(),
        own: Vec::new(),
    };
    for holds_none in [false, true] {
        let mut springs = Symmetric::zeros(n + count);
        for contact in structure
            .contacts
            .iter()
            .filter(|c| c.holds() != holds_none)
        {
            springs.add_along(&contact.along, weak);
        }
        let springs = Split::new(&springs, n);
        with_contacts.free.add_matrix(&springs.free, 1.0);
        for (list, more) in with_contacts.columns.iter_mut().zip(springs.columns) {
            list.extend(more);
        }
        if let Ok(factor) = Factor::regular(&with_contacts.free, SINGULAR) {
            return solved(&factor, columns(&with_contacts.columns));
        }
    }
    match pinned(&with_contacts.free) {
        Some(factor) => solved(&factor, columns(&with_contacts.columns)),
        // Then all is a load.
        None => vec![vec![0.0; n]; count],
    }
}

fn solved(factor: &Factor, mut columns: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    columns.iter_mut().for_each(|column| factor.solve(column));
    columns
}

/// The factor with springs that hold the nodes with which a part moves freely. No force of them is needed, so that the nodes stay.
fn pinned(matrix: &Symmetric) -> Option<Factor> {
    let mut matrix = matrix.clone();
    let largest = matrix.largest();
    for _ in 0..MOST_PINS {
        match Factor::regular(&matrix, SINGULAR) {
            Ok(factor) => return Some(factor),
            Err(NotPositive { row }) => {
                matrix.add(row, row, if largest > 0.0 { largest } else { 1.0 })
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::super::{Baseline, Direction, Node};
    use super::*;

    #[test]
    fn loads_of_supports_are_by_their_accelerations_and_velocities() {
        // A mass of 2 on springs of 6 and 2 to two supports, with a dashpot of 3 to the first one, one of 7 to the ground, and a mass of
        // 0.5 that it shares with the second one. It follows them by 6/8 and 2/8, so that they need no load by u.
        let mut coupled_mass = Symmetric::zeros(3);
        let (mut stiffness, mut damping) = (Symmetric::zeros(3), Symmetric::zeros(3));
        coupled_mass.add(2, 0, 0.5);
        stiffness.add_spring([Some(0), Some(1)], 6.0);
        stiffness.add_spring([Some(0), Some(2)], 2.0);
        damping.add_spring([Some(0), Some(1)], 3.0);
        damping.add_spring([Some(0), None], 7.0);
        let mut structure = Structure {
            nodes: vec![Node {
                name: "m".into(),
                mass: 2.0,
                direction: Direction::X,
            }],
            coupled_mass,
            stiffness,
            damping,
            contacts: Vec::new(),
            loads: Vec::new(),
            displacement: vec![0.0],
            velocity: vec![0.0],
            supports: Vec::new(),
            preload: Default::default(),
            observed: None,
        };
        let signal = Signal::Sine {
            amplitude: 1.0,
            omega: 1.0,
            phase: 0.0,
        };
        let motion = Arc::new(Motion::new(&signal, 1.0, 0.0, Baseline::None).unwrap());
        structure.prescribe(vec![("a".into(), motion.clone()), ("b".into(), motion)]);
        // M R + M_fs = 2 (3/4) and 2/4 + 0.5; C R + C_fs = 10 (3/4) - 3 and 10/4.
        let expected = [
            (Quantity::Acceleration, -1.5),
            (Quantity::Velocity, -4.5),
            (Quantity::Acceleration, -1.0),
            (Quantity::Velocity, -2.5),
        ];
        assert_eq!(structure.loads.len(), expected.len());
        for (load, (quantity, force)) in structure.loads.iter().zip(expected) {
            assert!(
                matches!(&*load.signal, Signal::Motion(_, quantity_of) if *quantity_of == quantity)
            );
            let [(0, found)] = load.pattern[..] else {
                panic!("{load:?}");
            };
            // Round-off.
            assert!((found - force).abs() < 1e-14, "{found} {force}");
        }
    }
}
