//! What stands along the bars, from what has left and what will reach the contact.

use super::{INSTANT, Wave};

impl Wave {
    /// Velocity and stress along bar `i` (0 left, 1 right) at `t`, as corners (s, v, sigma) of a line with jumps:
    /// s from 0 at the contact to 1 at the free end, v over c in the frame of the start, sigma over F0/A.
    pub fn profile(&self, i: usize, t: f64) -> Vec<[f64; 3]> {
        let half = 0.5 * self.bars.trip()[i];
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

    /// Where fronts stand on bar `i` at `t`, as s from 0 at the contact to 1 at the free end, both ends included.
    ///
    /// A front at an end has no jump inside the bar at that instant, so the lines of [`Wave::profile`] do not show it.
    pub fn fronts(&self, i: usize, t: f64) -> Vec<f64> {
        let half = 0.5 * self.bars.trip()[i];
        let share = self.bars.share()[i];
        let sign = [-1.0, 1.0][i];
        // What comes in and what leaves at the contact end, as in `inside`.
        let start = 0.5 * self.bars.start()[i];
        let mut before = [start, start];
        let mut places = Vec::new();
        for piece in &self.pieces {
            let incoming = 0.5 * piece.free[i];
            let after = [incoming, incoming + sign * share * piece.force];
            for (way, jump) in [
                (piece.start - t, after[0] - before[0]),
                (t - piece.start, after[1] - before[1]),
            ] {
                let s = way / half;
                if jump.abs() > INSTANT && (-INSTANT..=1.0 + INSTANT).contains(&s) {
                    places.push(s.clamp(0.0, 1.0));
                }
            }
            before = after;
        }
        places
    }

    /// Velocity and stress of bar `i` at s and t, away from fronts.
    pub fn inside(&self, i: usize, s: f64, t: f64) -> [f64; 2] {
        let way = s * 0.5 * self.bars.trip()[i];
        let share = self.bars.share()[i];
        let sign = [-1.0, 1.0][i];
        // Half of f comes in; what leaves has the force's share on it. Before t = 0 both are the start's.
        let incoming = 0.5 * self.piece(t + way).free[i];
        let outgoing = if t < way {
            0.5 * self.bars.start()[i]
        } else {
            let piece = self.piece(t - way);
            0.5 * piece.free[i] + sign * share * piece.force
        };
        [incoming + outgoing, -sign * (outgoing - incoming) / share]
    }
}
