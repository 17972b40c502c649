//! What the contact of bars does over time, for cases side by side.

use crate::history::History;
use crate::lane::Lane;

/// The contact of L cases at the steps 0..=N, in the problem's scales.
#[derive(Debug, Clone, PartialEq)]
pub struct Track<const L: usize> {
    /// r/(c T_I/2).
    pub displacement: Vec<Lane<L>>,
    /// rdot/c.
    pub velocity: Vec<Lane<L>>,
    /// F/F0.
    pub force: Vec<Lane<L>>,
    /// Energy, with the spring, in the frame of the common mass centre.
    pub energy: Vec<Lane<L>>,
    /// Relative velocity of the mass centres at the end over c.
    pub restitution: Lane<L>,
}

/// r, rdot, force and energy of one step.
pub type Row<'a, const L: usize> = [&'a mut Lane<L>; 4];

impl<const L: usize> Default for Track<L> {
    fn default() -> Self {
        Track {
            displacement: Vec::new(),
            velocity: Vec::new(),
            force: Vec::new(),
            energy: Vec::new(),
            restitution: Lane::splat(0.0),
        }
    }
}

impl<const L: usize> Track<L> {
    /// Room for `len` steps; what they hold is still to be noted.
    pub fn resize(&mut self, len: usize) {
        for column in self.columns() {
            column.resize(len, Lane::splat(0.0));
        }
    }

    /// `count` steps from `first` on, to be written.
    #[inline(always)]
    pub fn rows(&mut self, first: usize, count: usize) -> impl Iterator<Item = Row<'_, L>> {
        let [r, rdot, force, energy] = self.columns().map(|c| c[first..first + count].iter_mut());
        let rows = r.zip(rdot).zip(force).zip(energy);
        rows.map(
            #[inline(always)]
            |(((r, rdot), force), energy)| [r, rdot, force, energy],
        )
    }

    #[inline(always)]
    fn columns(&mut self) -> [&mut Vec<Lane<L>>; 4] {
        [
            &mut self.displacement,
            &mut self.velocity,
            &mut self.force,
            &mut self.energy,
        ]
    }

    /// The first `len` steps of one lane.
    pub fn lane(&self, l: usize, len: usize) -> Track<1> {
        let alone = |of: &[Lane<L>]| of[..len].iter().map(|x| Lane([x.0[l]])).collect();
        Track {
            displacement: alone(&self.displacement),
            velocity: alone(&self.velocity),
            force: alone(&self.force),
            energy: alone(&self.energy),
            restitution: Lane([self.restitution.0[l]]),
        }
    }
}

impl Track<1> {
    /// As a history with steps of `dt`.
    pub fn history(&self, dt: f64) -> History {
        let alone = |of: &[Lane<1>]| of.iter().map(|x| x.0[0]).collect();
        History {
            time: (0..self.displacement.len())
                .map(|i| i as f64 * dt)
                .collect(),
            displacement: alone(&self.displacement),
            velocity: alone(&self.velocity),
            force: alone(&self.force),
        }
    }
}
