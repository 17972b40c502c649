//! K and C as springs, dashpots and couplings, and the rows of Khat with its factor.

use crate::system::structure::Structure;
use crate::system::structure::factor::{Columns, Entry, Factor};
use std::collections::BTreeMap;

/// A row of Khat/4. Most nodes have one neighbour that is eliminated later, in trees all of them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Row {
    /// The first neighbour that is eliminated later; the ground if there is none.
    pub(super) to: usize,
    /// Stiffness between both.
    pub(super) k: f64,
    /// c/dt between both.
    pub(super) c: f64,
    /// Entry of L in row `to`.
    pub(super) l: f64,
    /// 1/D.
    pub(super) reciprocal: f64,
    /// Whether L has more entries in this column.
    pub(super) more: bool,
}

/// Spring and dashpot between two places.
#[derive(Debug, Clone, Copy)]
pub(super) struct Link {
    pub(super) from: usize,
    pub(super) to: usize,
    /// Stiffness.
    pub(super) k: f64,
    /// c/dt.
    pub(super) c: f64,
}

/// K and C as springs and dashpots between places of one direction and to the ground, and as couplings of different directions,
/// whose k and c are entries of K and C.
///
/// Differences of displacements are exact where neighbours move alike, while the terms of a row of K cancel. Between a
/// displacement and a rotation there is no such difference: their sizes depend on the units.
pub(super) fn links(structure: &Structure, place: &[usize], dt: f64) -> [Vec<Link>; 2] {
    let n = structure.len();
    let mut links: BTreeMap<(usize, usize), [f64; 2]> = BTreeMap::new();
    let mut couplings: BTreeMap<(usize, usize), [f64; 2]> = BTreeMap::new();
    let direction = |node: usize| structure.nodes[node].direction;
    for (which, matrix, factor) in [
        (0, &structure.stiffness, 1.0),
        (1, &structure.damping, 1.0 / dt),
    ] {
        let mut add = |i: usize, j: usize, value: f64| {
            links.entry((i.min(j), i.max(j))).or_default()[which] += value * factor;
        };
        // The sum of a row is the spring to the ground. For a row without ground it is round-off.
        let (mut sums, mut sizes) = (vec![0.0; n], vec![0.0; n]);
        for ((i, j), value) in matrix.entries() {
            if direction(i) != direction(j) {
                if value != 0.0 {
                    let (i, j) = (place[i], place[j]);
                    couplings.entry((i.min(j), i.max(j))).or_default()[which] += value * factor;
                }
                continue;
            }
            for row in [Some(i), (i != j).then_some(j)].into_iter().flatten() {
                sums[row] += value;
                sizes[row] += value.abs();
            }
            if i != j && value != 0.0 {
                add(place[i], place[j], -value);
            }
        }
        for (i, (sum, size)) in sums.into_iter().zip(sizes).enumerate() {
            if f64::abs(sum) > 4.0 * f64::EPSILON * size {
                add(place[i], n, sum);
            }
        }
    }
    let link = |((from, to), [k, c]): ((usize, usize), [f64; 2])| Link { from, to, k, c };
    [links, couplings].map(|all| all.into_iter().map(link).collect())
}

/// The rows of a factor, the entries of L that are in none, and the links that are in none.
pub(super) fn rows(factor: Factor, mut links: Vec<Link>) -> (Vec<Row>, Columns, Vec<Link>) {
    let n = factor.order().len();
    let row = |(i, reciprocal): (usize, &f64)| {
        let (first, others) = match factor.column(i) {
            [first, others @ ..] => (*first, others),
            [] => (Entry { at: n, value: 0.0 }, &[][..]),
        };
        Row {
            to: first.at,
            k: 0.0,
            c: 0.0,
            l: first.value,
            reciprocal: *reciprocal,
            more: !others.is_empty(),
        }
    };
    let mut rows: Vec<Row> = factor.reciprocals().iter().enumerate().map(row).collect();
    links.retain(|link| {
        let row = &mut rows[link.from];
        let own = row.to == link.to;
        if own {
            (row.k, row.c) = (link.k, link.c);
        }
        !own
    });
    (rows, factor.into_columns().without_first(), links)
}
