//! The contact of bars over time, for cases side by side.

use crate::contact::{StoredEnergy, in_series};
use crate::history::History;
use crate::lane::Lane;
use crate::methods::ContactState;
use crate::solve;

/// The contact of L cases at the steps 0..=N, in the problem's scales.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Track<const L: usize> {
    /// r/(c T_I/2).
    pub displacement: Vec<Lane<L>>,
    /// rdot/c.
    pub velocity: Vec<Lane<L>>,
    /// F/F0.
    pub force: Vec<Lane<L>>,
    /// For rigid contact, r below zero where there is a force; empty for other laws, whose r says whether they touch.
    pub touching: Vec<Lane<L>>,
}

impl<const L: usize> Track<L> {
    #[inline(always)]
    fn columns(&mut self) -> [&mut Vec<Lane<L>>; 3] {
        [&mut self.displacement, &mut self.velocity, &mut self.force]
    }

    /// Changes the motion of the modes to that of the contact, the contact of each lane being in series with its `compliance`, see
    /// [`in_series`].
    #[inline(always)]
    pub fn condense<W: StoredEnergy>(&mut self, laws: &[W; L], compliance: &Lane<L>) {
        let [rows_r, rows_rdot, rows_force] = self.columns();
        for ((r, rdot), force) in rows_r.iter_mut().zip(rows_rdot).zip(rows_force) {
            for (l, law) in laws.iter().enumerate() {
                let modes = [r.0[l], rdot.0[l], -force.0[l]];
                let contact = in_series(|s| law.deflection(s), compliance.0[l], modes);
                [r.0[l], rdot.0[l], _] = contact;
            }
        }
    }

    /// The first `len` steps of one lane.
    pub fn lane(&self, l: usize, len: usize) -> Track<1> {
        let values = |of: &[Lane<L>]| of[..len].iter().map(|x| Lane([x.0[l]])).collect();
        Track {
            displacement: values(&self.displacement),
            velocity: values(&self.velocity),
            force: values(&self.force),
            touching: match self.touching.is_empty() {
                true => Vec::new(),
                false => values(&self.touching),
            },
        }
    }
}

impl<const L: usize> solve::Track<L> for Track<L> {
    type Row<'a> = [&'a mut Lane<L>; 3];

    fn resize(&mut self, len: usize) {
        for column in self.columns() {
            column.resize(len, Lane::splat(0.0));
        }
    }

    #[inline(always)]
    fn rows(&mut self, first: usize, count: usize) -> impl Iterator<Item = Self::Row<'_>> {
        let [r, rdot, force] = self.columns().map(|c| c[first..first + count].iter_mut());
        r.zip(rdot).zip(force).map(
            #[inline(always)]
            |((r, rdot), force)| [r, rdot, force],
        )
    }

    #[inline(always)]
    fn write([r, rdot, force]: Self::Row<'_>, contact: &ContactState<L>) {
        // dr/dt in c T_I/2 over T_I is 2 rdot/c; S resists, so the force that pushes is -S.
        *r = contact.displacement;
        *rdot = contact.velocity * 0.5;
        *force = Lane::splat(0.0) - contact.force;
    }
}

impl Track<1> {
    /// As a history with steps of `dt`.
    pub fn history(&self, dt: f64) -> History {
        let values = |of: &[Lane<1>]| of.iter().map(|x| x.0[0]).collect();
        History {
            time: (0..self.displacement.len())
                .map(|i| i as f64 * dt)
                .collect(),
            channels: vec![
                values(&self.displacement),
                values(&self.velocity),
                values(&self.force),
            ],
        }
    }
}
