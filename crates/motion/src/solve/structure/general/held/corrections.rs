//! What the projection of overlaps needs.

use crate::lane::Lane;
use crate::solve::structure::Prepared;
use crate::solve::structure::contacts::forces::Forces;
use crate::solve::structure::general::sub_step_contacts::LaneContact;
use crate::solve::structure::linear_part::block_matrix::BlockMatrix;
use crate::system::structure::Structure;

/// What the corrections need.
#[derive(Debug, Clone)]
pub(crate) struct Corrections<const L: usize> {
    /// dt^2 M^-1 B by columns: places and values.
    pub(crate) columns: Vec<Vec<(usize, f64)>>,
    pub(crate) forces: Forces<L>,
    /// u + dt v at the contacts, and Lambda.
    pub(crate) trial: Vec<Lane<L>>,
    pub(crate) lambda: Vec<Lane<L>>,
    pub(crate) size: Vec<Lane<L>>,
    /// s by place.
    pub(crate) moved: Vec<Lane<L>>,
}

impl<const L: usize> Corrections<L> {
    /// `None` for a method without corrections, or without rigid stops.
    pub(crate) fn new(
        cases: &[&Structure; L],
        contacts: &[LaneContact<L>],
        prepared: &Prepared,
    ) -> Option<Corrections<L>> {
        let stop = |c: usize| cases.map(|case| case.contacts[c].law.is_stop());
        let stops: Vec<[bool; L]> = (0..contacts.len()).map(stop).collect();
        if !prepared.method.corrects() || stops.iter().all(|stop| *stop == [false; L]) {
            return None;
        }
        let (n, m, zero) = (prepared.nodes(), contacts.len(), Lane::splat(0.0));
        let columns: Vec<Vec<(usize, f64)>> =
            (0..m).map(|c| column(prepared, c, &stops[c])).collect();
        let mut flexibility = vec![0.0; m * m];
        for (i, row) in flexibility.chunks_mut(m).enumerate() {
            for (entry, column) in row.iter_mut().zip(&columns) {
                for (at, factor) in prepared.along.list(i) {
                    let moved = column.iter().filter(|(node, _)| node == at);
                    *entry += moved.map(|(_, value)| factor * value).sum::<f64>();
                }
            }
        }
        let bounds = stops.iter().map(|stop| {
            let mut low = zero;
            for (low, stop) in low.0.iter_mut().zip(stop) {
                *low = if *stop { f64::NEG_INFINITY } else { 0.0 };
            }
            (zero, [low, zero])
        });
        Some(Corrections {
            forces: Forces::new(&BlockMatrix::dense(flexibility, m), bounds),
            columns,
            trial: vec![zero; m],
            lambda: vec![zero; m],
            size: vec![zero; m],
            moved: vec![zero; n + 1],
        })
    }
}

/// dt^2 M^-1 b of a contact that is a stop in any lane; empty for another.
pub(crate) fn column(prepared: &Prepared, c: usize, stop: &[bool]) -> Vec<(usize, f64)> {
    if !stop.contains(&true) {
        return Vec::new();
    }
    let dt2 = prepared.dt * prepared.dt;
    let along = prepared.along.list(c).iter();
    let Some(inertia) = &prepared.inertia_factor else {
        let mass = |at: &usize| prepared.mass.get(*at).copied().filter(|mass| *mass > 0.0);
        return along
            .filter_map(|(at, factor)| Some((*at, dt2 * factor / mass(at)?)))
            .collect();
    };
    let mut by_place = vec![0.0; prepared.nodes() + 1];
    for (at, factor) in along {
        by_place[*at] += dt2 * factor;
    }
    let mut forces: Vec<f64> = prepared.place.iter().map(|node| by_place[*node]).collect();
    inertia.divide(&mut forces);
    prepared.place.iter().copied().zip(forces).collect()
}
