//! Velocity and stress along the bars, from the waves that left the contact and those that will reach it.

use super::{INSTANT, Wave};

impl Wave {
    /// Velocity and stress along bar `i` (0 left, 1 right) at `t`, as corners (s, v, sigma) of a line with jumps.
    ///
    /// s is 0 at the contact and 1 at the free end; v is over c, in the frame of the start; sigma is over F0/A.
    pub fn profile(&self, i: usize, t: f64) -> Vec<[f64; 3]> {
        let half = 0.5 * self.bars.travel_times()[i];
        let mut corners = vec![0.0, 1.0];
        for piece in &self.pieces {
            for s in [(piece.start - t) / half, (t - piece.start) / half] {
                if s > INSTANT && s < 1.0 - INSTANT {
                    corners.push(s);
                }
            }
        }
        corners.sort_by(f64::total_cmp);
        corners.dedup_by(|a, b| (*a - *b).abs() <= INSTANT);
        let mut line = Vec::new();
        for pair in corners.windows(2) {
            let [v, sigma] = self.inside(i, 0.5 * (pair[0] + pair[1]), t);
            line.push([pair[0], v, sigma]);
            line.push([pair[1], v, sigma]);
        }
        line
    }

    /// Displacement since t = 0 of bar `i` at `t`, as corners (s, u) of a line, from the corners of [`Wave::profile`] at this time.
    ///
    /// u is over c T_I/2, in the frame of the start. The end at the contact has moved by the integral of its velocity; along the bar
    /// du/ds = -d_1 sigma in the left bar and d_2 theta sigma in the right one.
    pub fn displacement(&self, i: usize, t: f64, corners: &[[f64; 3]]) -> Vec<[f64; 2]> {
        let share = self.bars.share()[i];
        let sign = [-1.0, 1.0][i];
        let ends = self.pieces.iter().skip(1).map(|piece| piece.start);
        let pieces = self.pieces.iter().zip(ends.chain([f64::INFINITY]));
        let mut u = 0.0;
        for (piece, end) in pieces.filter(|(piece, _)| piece.start < t) {
            let velocity = piece.free[i] + sign * share * piece.force;
            u += 2.0 * velocity * (end.min(t) - piece.start.max(0.0));
        }
        let slope = sign * share * self.bars.travel_times()[i];
        let mut line = Vec::with_capacity(corners.len());
        let mut before: Option<[f64; 3]> = None;
        for corner in corners {
            if let Some([s, _, sigma]) = before {
                u += slope * sigma * (corner[0] - s);
            }
            line.push([corner[0], u]);
            before = Some(*corner);
        }
        line
    }

    /// Positions of the fronts on bar `i` at `t`, as s from 0 at the contact to 1 at the free end, both ends included.
    ///
    /// A front at an end has no jump inside the bar at that time, so the lines of [`Wave::profile`] do not show it.
    pub fn fronts(&self, i: usize, t: f64) -> Vec<f64> {
        let half = 0.5 * self.bars.travel_times()[i];
        let share = self.bars.share()[i];
        let sign = [-1.0, 1.0][i];
        // The incoming and the outgoing wave at the contact end, as in `inside`.
        let start = 0.5 * self.bars.start()[i];
        let mut before = [start, start];
        let mut positions = Vec::new();
        for piece in &self.pieces {
            let incoming = 0.5 * piece.free[i];
            let after = [incoming, incoming + sign * share * piece.force];
            for (time, jump) in [
                (piece.start - t, after[0] - before[0]),
                (t - piece.start, after[1] - before[1]),
            ] {
                let s = time / half;
                if jump.abs() > INSTANT && (-INSTANT..=1.0 + INSTANT).contains(&s) {
                    positions.push(s.clamp(0.0, 1.0));
                }
            }
            before = after;
        }
        positions
    }

    /// Velocity and stress of bar `i` at s and t, away from fronts, in the units of [`Wave::profile`].
    pub fn inside(&self, i: usize, s: f64, t: f64) -> [f64; 2] {
        let travel = s * 0.5 * self.bars.travel_times()[i];
        let share = self.bars.share()[i];
        let sign = [-1.0, 1.0][i];
        // Half of f comes in; the outgoing wave has the share of the force. Before t = 0 both are those of the start.
        let incoming = 0.5 * self.piece(t + travel).free[i];
        let outgoing = if t < travel {
            0.5 * self.bars.start()[i]
        } else {
            let piece = self.piece(t - travel);
            0.5 * piece.free[i] + sign * share * piece.force
        };
        [incoming + outgoing, -sign * (outgoing - incoming) / share]
    }
}
