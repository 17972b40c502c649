//! Two bars end to end, or a bar and a wall, as one set of modes.

use super::bar::Bar;
use super::{Mode, ModeAtStart};

/// Two bars that approach one another, or a bar that approaches a wall. The contact is between their facing ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BarPair {
    /// The left bar.
    pub left: Bar,
    /// The right bar; `None` for a wall.
    pub right: Option<Bar>,
    /// rdot(0) of the rigid-body motion; negative if the gap closes.
    pub velocity: f64,
}

impl BarPair {
    /// The bars, left first.
    pub fn each(&self) -> impl Iterator<Item = Bar> {
        [Some(self.left), self.right].into_iter().flatten()
    }

    /// Whether both bars are equal.
    pub fn equal(&self) -> bool {
        self.right == Some(self.left)
    }

    /// Number of modes, see [`BarPair::mode`].
    pub fn len(&self) -> usize {
        let left = self.left.mode_count() as usize;
        match self.right {
            Some(right) if right != self.left => left + right.mode_count() as usize - 1,
            Some(_) | None => left,
        }
    }

    /// Compliance between the modes and the contact, see [`Bar::contact_compliance`].
    pub fn contact_compliance(&self) -> f64 {
        self.each().map(|bar| bar.contact_compliance()).sum()
    }

    /// Whether there is no mode; always false.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Mode `j`, scaled by its share of r, the rigid-body mode first. Modes of one frequency are one mode, and its share of r is
    /// the sum of their shares: the rigid-body modes of both bars, and all pairs of modes of equal bars.
    #[inline(always)]
    pub fn mode(&self, j: usize) -> Mode {
        let first = self.left.mode_count() as usize;
        match self.right {
            Some(right) if right == self.left => {
                let mut mode = self.left.mode(j as u32);
                mode.phi2 *= 2.0;
                mode
            }
            Some(right) if j >= first => right.mode((j + 1 - first) as u32),
            Some(right) if j == 0 => {
                let mut rigid = self.left.mode(0);
                rigid.phi2 += right.mode(0).phi2;
                rigid
            }
            Some(_) | None => self.left.mode(j as u32),
        }
    }

    /// Kinetic energy at t = 0. Only the rigid-body mode moves then.
    pub(super) fn energy_at_start(&self) -> f64 {
        self.mode(0).energy(0.0, self.velocity)
    }

    /// The same with its state at t = 0.
    #[inline(always)]
    pub(super) fn mode_at_start(&self, j: usize) -> ModeAtStart {
        ModeAtStart {
            mode: self.mode(j),
            displacement: 0.0,
            velocity: if j == 0 { self.velocity } else { 0.0 },
        }
    }

    /// Displacement and velocity of each bar's own modes at `time`, left bar first, from those of [`BarPair::mode`].
    ///
    /// Modes of one frequency share a force in proportion to their phi2. Half of the approach belongs to each bar, in the frame
    /// of the mean of both initial velocities.
    pub fn separate(&self, time: f64, together: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let Some(right) = self.right else {
            return together.to_vec();
        };
        let (left, other) = (self.left.mass, right.mass);
        // phi2 of a rigid-body mode is the inverse of the mass.
        let rigid = |share: f64| {
            let [x, v] = together[0];
            let free = [self.velocity * time, self.velocity];
            [
                0.5 * free[0] + share * (x - free[0]),
                0.5 * free[1] + share * (v - free[1]),
            ]
        };
        let elastic = |modes: &[[f64; 2]]| -> Vec<[f64; 2]> {
            let share = if self.equal() { 0.5 } else { 1.0 };
            modes.iter().map(|mode| mode.map(|x| share * x)).collect()
        };
        let first = self.left.mode_count() as usize;
        let (first_modes, rest) = together.split_at(first);
        let rest = if self.equal() {
            &first_modes[1..]
        } else {
            rest
        };
        let mut modes = vec![rigid(other / (left + other))];
        modes.extend(elastic(&first_modes[1..]));
        modes.push(rigid(left / (left + other)));
        modes.extend(elastic(rest));
        modes
    }
}
