//! Steps in which contacts in a plane without compliance begin to slide.
//!
//! From rest |rdot| grows as the square of the time or slower, while the direction of sliding turns to that of the forces at the rate
//! nu N b^T M^-1 b/|rdot|: explicit steps would have to be much shorter than this time. Here the forces of these contacts at the points
//! of Radau are the unknowns, S = nu N rdot/|rdot| there. The other forces change slowly: they follow by substitution. A step in two
//! parts tells the error.

use super::structure::Moving;
use super::substitute::{Points, combine};
use crate::contact::plane::{Pair, dot, length};
use crate::exact::adaptive::Flow;
use crate::exact::adaptive::plane::{Imposed, Phase};
use crate::exact::adaptive::radau::{NODES, POINTS, eliminate, weights};

/// Difference of S over its limit, up to which it is sought.
const TARGET: f64 = 1e-13;

/// Most corrections.
const CORRECTIONS: usize = 30;

/// Substitutions with the forces along those that would hold.
const SUBSTITUTIONS: usize = 4;

/// Turns in a step, as exponents of e, from which on explicit steps are as long.
const FAST: f64 = 2.0;

/// Round-off of a relative velocity over the velocities.
const ROUND_OFF: f64 = 1e-14;

impl Moving<'_> {
    /// The contacts that begin to slide, by their first rows.
    pub(crate) fn beginning(&self) -> Vec<usize> {
        let begins = |phase| matches!(phase, Some(Phase::Begins { .. }));
        let planes = self.planes().filter(|(_, plane)| begins(plane.phase));
        planes.map(|(first, _)| first).collect()
    }

    /// A step of h in one part and in two; the largest difference of their directions at the end, and its round-off.
    pub(crate) fn begin_to_slide(
        &mut self,
        t: f64,
        h: f64,
        y: &[f64],
        [whole, end]: [&mut [f64]; 2],
    ) -> [f64; 2] {
        let firsts = self.beginning();
        let half = 0.5 * h;
        let found = self.slide(t, h, y, &firsts, whole).and_then(|stiffness| {
            let mut middle = vec![0.0; y.len()];
            self.slide(t, half, y, &firsts, &mut middle)?;
            self.slide(t + half, half, &middle, &firsts, end)?;
            Some(stiffness)
        });
        let Some(stiffness) = found else {
            return [f64::INFINITY, 1.0];
        };
        let n = self.model.len();
        let [mut error, mut round_off] = [0.0, 0.0];
        for (i, first) in firsts.iter().enumerate() {
            let rdot = |y: &[f64]| self.in_plane(*first, t + h, y, [0.0; 2]).rdot;
            let [one, two] = [rdot(whole), rdot(end)];
            let speed = length(two);
            error = f64::max(error, length([one[0] - two[0], one[1] - two[1]]) / speed);
            let columns = &self.model.columns;
            let size =
                columns[*first].size(&end[n..2 * n]) + columns[first + 1].size(&end[n..2 * n]);
            // Of velocities, and of the forces whose difference moves the contact.
            round_off = f64::max(round_off, ROUND_OFF * (size + h * stiffness[i]) / speed);
            let before = length(self.in_plane(*first, t, y, [0.0; 2]).rdot);
            if let Some(plane) = &mut self.planes[*first] {
                plane.is_fast = stiffness[i] * h < FAST * speed || speed < before;
            }
        }
        [error, round_off]
    }

    pub(crate) fn impose(&mut self, firsts: &[usize], force: impl Fn(usize) -> Option<Imposed>) {
        for (i, first) in firsts.iter().enumerate() {
            if let Some(plane) = &mut self.planes[*first] {
                plane.imposed = force(i);
            }
        }
    }

    /// The end of a step, and nu N b^T M^-1 b of each contact there; `None` if no forces are found.
    fn slide(
        &mut self,
        t: f64,
        h: f64,
        y: &[f64],
        firsts: &[usize],
        end: &mut [f64],
    ) -> Option<Vec<f64>> {
        // Soon after the begin the forces that would hold are near, later the last direction.
        let found = self
            .search([t, h], y, firsts, true)
            .or_else(|| self.search([t, h], y, firsts, false));
        self.impose(firsts, |_| None);
        let (points, stiffness) = found?;
        end.copy_from_slice(&points.states[POINTS - 1]);
        Some(stiffness)
    }

    fn search(
        &mut self,
        [t, h]: [f64; 2],
        y: &[f64],
        firsts: &[usize],
        along_held: bool,
    ) -> Option<(Points, Vec<f64>)> {
        let weights = weights();
        let times = NODES.map(|x| t + x * h);
        let mut points = self.guess(h, times, y, firsts, &weights);
        if !along_held && !self.turn_back(t, y, firsts, &mut points) {
            return None;
        }
        let influence = self.influence(times[POINTS - 1], &points, firsts);
        let p = firsts.len();
        let m = 2 * p * POINTS;
        let mut good = 0;
        for _ in 0..CORRECTIONS {
            self.substitute(times, h, y, firsts, &weights, &mut points);
            let mut matrix = vec![0.0; m * m];
            let mut rest = vec![0.0; m];
            let [mut largest, mut allowed] = [0.0, TARGET];
            for i in 0..POINTS {
                for (c, first) in firsts.iter().enumerate() {
                    let state = self.in_plane(*first, times[i], &points.states[i], [0.0; 2]);
                    let speed = length(state.rdot);
                    let plane = self.planes[*first].as_ref()?;
                    let limit = plane.limit(self.limit(*first, times[i], &points.states[i]));
                    if speed.is_nan() || speed <= 0.0 {
                        return None;
                    }
                    let unit = state.rdot.map(|v| v / speed);
                    let n = self.model.len();
                    let columns = &self.model.columns;
                    let v = &points.states[i][n..2 * n];
                    let size = columns[*first].size(v) + columns[first + 1].size(v);
                    // Forces that nearly hold leave differences: their round-off moves the direction by so much.
                    let trace =
                        influence[4 * c * p + 2 * c] + influence[(2 * c + 1) * 2 * p + 2 * c + 1];
                    let size = size + h * trace * limit;
                    allowed = f64::max(allowed, 0.1 * ROUND_OFF * size / speed);
                    for a in 0..2 {
                        let row = 2 * (i * p + c) + a;
                        rest[row] = limit * unit[a] - points.forces[i][c][a];
                        largest = f64::max(largest, rest[row].abs() / limit.max(f64::MIN_POSITIVE));
                        // nu N (I - n n^T)/|rdot| times the change of rdot with all forces.
                        let turn: Pair = std::array::from_fn(|b| {
                            let identity = if a == b { 1.0 } else { 0.0 };
                            limit / speed * (identity - unit[a] * unit[b])
                        });
                        for (j, weight) in weights[i].iter().enumerate() {
                            for other in 0..2 * p {
                                let of = |b: usize| influence[(2 * c + b) * 2 * p + other];
                                let column = 2 * j * p + other;
                                matrix[row * m + column] += h * weight * dot(turn, [of(0), of(1)]);
                            }
                        }
                        matrix[row * m + row] += 1.0;
                    }
                }
            }
            good = if largest <= allowed { good + 1 } else { 0 };
            if good == 2 {
                let of_columns = (0..p).map(|c| {
                    let trace =
                        influence[4 * c * p + 2 * c] + influence[(2 * c + 1) * 2 * p + 2 * c + 1];
                    0.5 * trace * length(points.forces[POINTS - 1][c])
                });
                let stiffness = of_columns.collect();
                return Some((points, stiffness));
            }
            if !eliminate(&mut matrix, &mut rest) {
                return None;
            }
            for (i, forces) in points.forces.iter_mut().enumerate() {
                for (c, force) in forces.iter_mut().enumerate() {
                    for (a, force) in force.iter_mut().enumerate() {
                        *force += rest[2 * (i * p + c) + a];
                    }
                }
            }
        }
        None
    }

    /// States with the forces along those that would hold.
    fn guess(
        &mut self,
        h: f64,
        times: [f64; POINTS],
        y: &[f64],
        firsts: &[usize],
        weights: &[[f64; POINTS]; POINTS],
    ) -> Points {
        let mut points = Points {
            states: vec![y.to_vec(); POINTS],
            forces: vec![vec![[0.0; 2]; firsts.len()]; POINTS],
        };
        let rates = |moving: &mut Self, points: &mut Points, imposed: bool| {
            let mut stage_rates = vec![vec![0.0; y.len()]; POINTS];
            for i in 0..POINTS {
                if imposed {
                    moving.impose(firsts, |_| Some(Imposed::AlongHeld));
                }
                let state = &points.states[i];
                let [forces, _] = moving.sums(times[i], state, &mut vec![0.0; moving.model.len()]);
                for (c, first) in firsts.iter().enumerate() {
                    points.forces[i][c] = [forces[*first], forces[first + 1]];
                }
                moving.rates(times[i], state, &mut stage_rates[i]);
            }
            stage_rates
        };
        for _ in 0..SUBSTITUTIONS {
            let stage_rates = rates(self, &mut points, true);
            combine(&mut points.states, y, h, weights, &stage_rates);
        }
        points
    }

    /// Forces along rdot at the start; false where all rest there but for round-off.
    fn turn_back(&self, t: f64, y: &[f64], firsts: &[usize], points: &mut Points) -> bool {
        let mut any = false;
        for (c, first) in firsts.iter().enumerate() {
            let start = self.in_plane(*first, t, y, [0.0; 2]).rdot;
            let speed = length(start);
            let phase = self.planes[*first].as_ref().and_then(|plane| plane.phase);
            if matches!(phase, Some(Phase::Begins { since }) if t > since) && speed > 0.0 {
                any = true;
                for forces in &mut points.forces {
                    let limit = length(forces[c]);
                    forces[c] = start.map(|v| limit * v / speed);
                }
            }
        }
        any
    }
}
