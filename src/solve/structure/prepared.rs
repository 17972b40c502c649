//! What all cases with equal masses, stiffness, damping, time step, and equal nodes of contacts and loads share.

use crate::solve::Unsolvable;
use crate::system::structure::factor::{Factor, NotPositive};
use crate::system::structure::lists::Lists;
use crate::system::structure::{Load, Structure, Symmetric};

/// The linear part of a step, in the order of elimination of Khat.
#[derive(Debug, Clone)]
pub struct Prepared {
    pub(super) dt: f64,
    /// Of Khat/4.
    pub(super) factor: Factor,
    /// Place of each node in the order of elimination.
    pub(super) place: Vec<usize>,
    /// Neighbours of each place; the place behind the last one is the ground.
    pub(super) links: Lists<Link>,
    /// Places I and J of each contact.
    pub(super) between: Vec<[usize; 2]>,
    /// L^-1 B by columns, without zeros.
    pub(super) reduced: Lists<Reduced>,
    /// H = B^T Khat^-1 B by rows.
    pub(super) flexibility: Vec<f64>,
    key: Key,
}

/// Spring and dashpot between a node and a neighbour.
#[derive(Debug, Clone, Copy)]
pub(super) struct Link {
    pub(super) to: usize,
    /// Stiffness.
    pub(super) k: f64,
    /// c/dt.
    pub(super) c: f64,
}

/// An entry of L^-1 B.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reduced {
    pub(super) at: usize,
    pub(super) value: f64,
    /// value/D.
    pub(super) by_pivot: f64,
}

/// What a prepared structure depends on.
#[derive(Debug, Clone, PartialEq)]
struct Key {
    masses: Vec<f64>,
    stiffness: Symmetric,
    damping: Symmetric,
    between: Vec<[Option<usize>; 2]>,
    /// Nodes with loads.
    loads: Vec<Vec<usize>>,
}

impl Prepared {
    /// Prepares steps of `dt`.
    ///
    /// # Errors
    /// [`Unsolvable::Indefinite`] with the name of a node if Khat is not positive definite.
    pub fn new(structure: &Structure, dt: f64) -> Result<Prepared, Unsolvable> {
        let n = structure.len();
        let mut matrix = Symmetric::zeros(n);
        for (i, node) in structure.nodes.iter().enumerate() {
            matrix.add(i, i, node.mass / (dt * dt));
        }
        matrix.add_matrix(&structure.damping, 0.5 / dt);
        matrix.add_matrix(&structure.stiffness, 0.25);
        let mut touches = vec![false; n];
        let between: Vec<_> = structure.contacts.iter().map(|c| c.between).collect();
        for node in between.iter().flatten().flatten() {
            touches[*node] = true;
        }
        let factor = Factor::new(&matrix, &touches).map_err(|NotPositive { row }| {
            let node = structure.nodes[row].name.clone();
            Unsolvable::Indefinite { node }
        })?;
        let mut place = vec![0; n];
        for (k, node) in factor.order().iter().enumerate() {
            place[*node] = k;
        }
        let links = links(structure, &place, dt);
        let at = |node: Option<usize>| node.map_or(n, |node| place[node]);
        let places: Vec<_> = between.iter().map(|ends| ends.map(at)).collect();
        let reduced: Vec<_> = places.iter().map(|ends| reduce(&factor, *ends)).collect();
        Ok(Prepared {
            dt,
            links: Lists::new(&links),
            flexibility: flexibility(&reduced),
            between: places,
            reduced: Lists::new(&reduced),
            factor,
            place,
            key: Key {
                masses: structure.nodes.iter().map(|node| node.mass).collect(),
                stiffness: structure.stiffness.clone(),
                damping: structure.damping.clone(),
                between,
                loads: structure
                    .loads
                    .iter()
                    .map(loaded)
                    .map(Vec::from_iter)
                    .collect(),
            },
        })
    }

    /// Whether a structure with steps of `dt` has the same linear part, and loads on the same nodes.
    pub fn fits(&self, structure: &Structure, dt: f64) -> bool {
        let nodes = structure.nodes.iter().map(|node| &node.mass);
        let between = structure.contacts.iter().map(|contact| &contact.between);
        let same_nodes = |(a, b): (&Vec<usize>, _)| a.iter().copied().eq(loaded(b));
        self.dt == dt
            && self.key.loads.len() == structure.loads.len()
            && self.key.loads.iter().zip(&structure.loads).all(same_nodes)
            && self.key.masses.iter().eq(nodes)
            && self.key.between.iter().eq(between)
            && self.key.stiffness == structure.stiffness
            && self.key.damping == structure.damping
    }

    /// The time step.
    pub fn dt(&self) -> f64 {
        self.dt
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.place.len()
    }

    /// Number of contacts.
    pub fn contacts(&self) -> usize {
        self.between.len()
    }

    /// m/dt^2 of the node at place `i`.
    #[inline(always)]
    pub(super) fn inertia(&self, i: usize) -> f64 {
        self.key.masses[self.factor.order()[i]] / (self.dt * self.dt)
    }
}

/// The nodes of a load.
fn loaded(load: &Load) -> impl Iterator<Item = usize> + '_ {
    load.pattern.iter().map(|(node, _)| *node)
}

/// K and C as springs and dashpots between nodes, and to the ground.
///
/// Differences of displacements are exact where neighbours move alike, while the terms of a row of K cancel.
fn links(structure: &Structure, place: &[usize], dt: f64) -> Vec<Vec<Link>> {
    let n = structure.len();
    let mut links: Vec<Vec<Link>> = vec![Vec::new(); n];
    let mut add = |i: usize, to: usize, [k, c]: [f64; 2]| {
        let links = &mut links[place[i]];
        match links.iter_mut().find(|link| link.to == to) {
            Some(link) => (link.k, link.c) = (link.k + k, link.c + c),
            None => links.push(Link { to, k, c }),
        }
    };
    for (matrix, [k, c]) in [
        (&structure.stiffness, [1.0, 0.0]),
        (&structure.damping, [0.0, 1.0 / dt]),
    ] {
        // Row sums are forces to the ground. The sum of a row without ground is round-off.
        let mut sums = vec![0.0; n];
        let mut sizes = vec![0.0; n];
        for ((i, j), value) in matrix.entries() {
            for i in if i == j { vec![i] } else { vec![i, j] } {
                sums[i] += value;
                sizes[i] += value.abs();
            }
            if i != j && value != 0.0 {
                add(i, place[j], [-value * k, -value * c]);
                add(j, place[i], [-value * k, -value * c]);
            }
        }
        for (i, (sum, size)) in sums.into_iter().zip(sizes).enumerate() {
            if f64::abs(sum) > 4.0 * f64::EPSILON * size {
                add(i, n, [sum * k, sum * c]);
            }
        }
    }
    links
}

/// L^-1 B of a contact between two places; the place behind the last one is the ground.
fn reduce(factor: &Factor, [i, j]: [usize; 2]) -> Vec<Reduced> {
    let n = factor.order().len();
    let mut column = vec![0.0; n + 1];
    column[i] -= 1.0;
    column[j] += 1.0;
    for (k, below) in factor.columns().enumerate() {
        for entry in below {
            column[entry.at] -= entry.value * column[k];
        }
    }
    let entry = |(at, value): (usize, f64)| Reduced {
        at,
        value,
        by_pivot: value * factor.reciprocals()[at],
    };
    let entries = column[..n].iter().copied().enumerate();
    entries.filter(|(_, x)| *x != 0.0).map(entry).collect()
}

/// H = (L^-1 B)^T D^-1 (L^-1 B)/4, where L D L^T is Khat/4.
fn flexibility(reduced: &[Vec<Reduced>]) -> Vec<f64> {
    let product = |a: &[Reduced], b: &[Reduced]| {
        let (mut sum, mut b) = (0.0, b.iter().peekable());
        for x in a {
            while b.next_if(|y| y.at < x.at).is_some() {}
            if let Some(y) = b.next_if(|y| y.at == x.at) {
                sum += x.by_pivot * y.value;
            }
        }
        0.25 * sum
    };
    let m = reduced.len();
    let mut h = vec![0.0; m * m];
    for i in 0..m {
        for j in 0..=i {
            let value = product(&reduced[i], &reduced[j]);
            (h[i * m + j], h[j * m + i]) = (value, value);
        }
    }
    h
}
