//! What all cases with equal masses, stiffness, damping, time step, and equal nodes of contacts and loads share.

use super::general::Linear;
use super::links::{Link, Row, links, rows};
use crate::methods::{AverageAcceleration, Method};
use crate::solve::Unsolvable;
use crate::system::structure::factor::{Columns, Factor, NotPositive};
use crate::system::structure::lists::Lists;
use crate::system::structure::{Load, Structure, Symmetric};

/// The linear part of a step, in the order of elimination of its matrix.
///
/// The rows and what follows from them are those of the constant average acceleration method. For the other methods they are empty,
/// and each sub-step has its own linear part.
#[derive(Debug, Clone)]
pub struct Prepared {
    pub(super) dt: f64,
    pub(super) method: Method,
    /// The sub-steps of a method other than constant average acceleration.
    pub(super) sub_steps: Vec<Linear>,
    /// m by place, for these methods.
    pub(super) mass: Vec<f64>,
    /// Place of each node in the order of elimination.
    pub(super) place: Vec<usize>,
    /// Rows of Khat/4 = L D L^T in the order of elimination.
    pub(super) rows: Vec<Row>,
    /// Entries of L in the column of each place, without the one in its [`Row`].
    pub(super) more: Columns,
    /// Links that are in no [`Row`]. The place behind the last one is the ground.
    pub(super) links: Vec<Link>,
    /// m/dt^2 by place.
    pub(super) inertia: Vec<f64>,
    /// Places I and J of each contact.
    pub(super) between: Vec<[usize; 2]>,
    /// L^-1 B by columns, without zeros.
    pub(super) reduced: Lists<Reduced>,
    /// H = B^T Khat^-1 B by rows.
    pub(super) flexibility: Vec<f64>,
    key: Key,
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
    /// Prepares steps of `dt` by the constant average acceleration method.
    ///
    /// # Errors
    /// [`Unsolvable::Indefinite`] with the name of a node if Khat is not positive definite.
    pub fn new(structure: &Structure, dt: f64) -> Result<Prepared, Unsolvable> {
        let n = structure.len();
        let mut matrix = Symmetric::zeros(n);
        let inertia = |node: usize| structure.nodes[node].mass / (dt * dt);
        for i in 0..n {
            matrix.add(i, i, inertia(i));
        }
        matrix.add_matrix(&structure.damping, 0.5 / dt);
        matrix.add_matrix(&structure.stiffness, 0.25);
        let factor = Factor::new(&matrix, &touches(structure)).map_err(|NotPositive { row }| {
            let node = structure.nodes[row].name.clone();
            Unsolvable::Indefinite { node }
        })?;
        let place = place_of(&factor);
        let places = places(structure, &place);
        let reduced: Vec<_> = places.iter().map(|ends| reduce(&factor, *ends)).collect();
        let inertia = factor.order().iter().map(|node| inertia(*node)).collect();
        let (rows, more, links) = rows(factor, links(structure, &place, dt));
        Ok(Prepared {
            dt,
            method: AverageAcceleration.into(),
            sub_steps: Vec::new(),
            mass: Vec::new(),
            rows,
            more,
            links,
            inertia,
            // L D L^T is Khat/4.
            flexibility: flexibility(&reduced, 0.25),
            between: places,
            reduced: Lists::new(&reduced),
            place,
            key: Key::new(structure),
        })
    }

    /// Prepares steps of `dt` by a method.
    ///
    /// # Errors
    /// As [`Prepared::new`]; for other methods in the words of their own matrix.
    pub fn by(method: &Method, structure: &Structure, dt: f64) -> Result<Prepared, Unsolvable> {
        if matches!(method, Method::AverageAcceleration(_)) {
            return Prepared::new(structure, dt);
        }
        let touches = touches(structure);
        let mut place = Vec::new();
        let mut linear = Vec::new();
        for sub_step in method.sub_steps(dt) {
            let (next, order) = Linear::new(structure, &touches, sub_step)?;
            linear.push(next);
            place = order;
        }
        let mut mass = vec![0.0; structure.len()];
        for (node, place) in structure.nodes.iter().zip(&place) {
            mass[*place] = node.mass;
        }
        Ok(Prepared {
            dt,
            method: *method,
            sub_steps: linear,
            mass,
            rows: Vec::new(),
            more: Columns::none(),
            links: Vec::new(),
            inertia: Vec::new(),
            between: places(structure, &place),
            reduced: Lists::new(&[]),
            flexibility: Vec::new(),
            place,
            key: Key::new(structure),
        })
    }

    /// Whether a structure with steps of `dt` by a method has the same linear part, and loads on the same nodes.
    pub fn fits(&self, method: &Method, structure: &Structure, dt: f64) -> bool {
        let nodes = structure.nodes.iter().map(|node| &node.mass);
        let between = structure.contacts.iter().map(|contact| &contact.between);
        let same_nodes = |(a, b): (&Vec<usize>, _)| a.iter().copied().eq(loaded(b));
        self.dt == dt
            && self.method == *method
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

    /// The method.
    pub fn method(&self) -> &Method {
        &self.method
    }

    /// Whether the steps are those of constant average acceleration in increments, which have a form of their own.
    pub(super) fn has_increments(&self) -> bool {
        self.sub_steps.is_empty()
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.place.len()
    }

    /// Number of contacts.
    pub fn contacts(&self) -> usize {
        self.between.len()
    }

    /// All springs and dashpots.
    pub(super) fn all_links(&self) -> impl Iterator<Item = Link> + '_ {
        let link = |(from, row): (usize, &Row)| Link {
            from,
            to: row.to,
            k: row.k,
            c: row.c,
        };
        let of_rows = self.rows.iter().enumerate().map(link);
        of_rows.chain(self.links.iter().copied())
    }
}

impl Key {
    fn new(structure: &Structure) -> Key {
        Key {
            masses: structure.nodes.iter().map(|node| node.mass).collect(),
            stiffness: structure.stiffness.clone(),
            damping: structure.damping.clone(),
            between: structure.contacts.iter().map(|c| c.between).collect(),
            loads: structure
                .loads
                .iter()
                .map(loaded)
                .map(Vec::from_iter)
                .collect(),
        }
    }
}

/// Whether each node has a contact.
fn touches(structure: &Structure) -> Vec<bool> {
    let mut touches = vec![false; structure.len()];
    for node in structure.contacts.iter().flat_map(|c| c.between).flatten() {
        touches[node] = true;
    }
    touches
}

/// The place of each node in the order of elimination.
pub(super) fn place_of(factor: &Factor) -> Vec<usize> {
    let mut place = vec![0; factor.order().len()];
    for (k, node) in factor.order().iter().enumerate() {
        place[*node] = k;
    }
    place
}

/// Places I and J of each contact; the place behind the last one is the ground.
fn places(structure: &Structure, place: &[usize]) -> Vec<[usize; 2]> {
    let at = |node: Option<usize>| node.map_or(place.len(), |node| place[node]);
    let contacts = structure.contacts.iter();
    contacts.map(|contact| contact.between.map(at)).collect()
}

/// The nodes of a load.
fn loaded(load: &Load) -> impl Iterator<Item = usize> + '_ {
    load.pattern.iter().map(|(node, _)| *node)
}

/// L^-1 B of a contact between two places; the place behind the last one is the ground.
pub(super) fn reduce(factor: &Factor, [i, j]: [usize; 2]) -> Vec<Reduced> {
    let n = factor.order().len();
    let mut column = vec![0.0; n + 1];
    column[i] -= 1.0;
    column[j] += 1.0;
    for k in 0..n {
        for entry in factor.column(k) {
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

/// A factor times B^T (L D L^T)^-1 B = (L^-1 B)^T D^-1 (L^-1 B).
pub(super) fn flexibility(reduced: &[Vec<Reduced>], factor: f64) -> Vec<f64> {
    let product = |a: &[Reduced], b: &[Reduced]| {
        let (mut sum, mut b) = (0.0, b.iter().peekable());
        for x in a {
            while b.next_if(|y| y.at < x.at).is_some() {}
            if let Some(y) = b.next_if(|y| y.at == x.at) {
                sum += x.by_pivot * y.value;
            }
        }
        factor * sum
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
