//! The events of an impact: fronts that arrive at the contact, and the first touch.
//!
//! Everything is constant between events.

use super::{Bars, INSTANT, Piece, Wave};
use std::collections::VecDeque;

/// A front that travels to the free end and back to the contact, where it changes f_i by `jump`.
#[derive(Debug, Clone, Copy)]
struct Front {
    arrival: f64,
    jump: f64,
}

impl Bars {
    /// The motion up to t = `end` in T_I.
    pub fn solve(&self, end: f64) -> Wave {
        let travel = self.travel_times();
        // Profiles need the fronts that arrive up to half a travel time later.
        let margin = 0.5 * travel[0].max(if self.wall() { 0.0 } else { travel[1] });
        let end = end + margin + INSTANT;
        Wave {
            bars: *self,
            pieces: self.pieces(end, |_| false),
        }
    }

    /// Time from the first touch until the ends separate, in T_I; it does not depend on the gap. `None` if it is more than
    /// `most`.
    ///
    /// It may be longer than the force acts: equal bars with lengths 1 : 2 separate a T_I after the end of the force.
    pub fn contact_duration(&self, most: f64) -> Option<f64> {
        let touching = Bars { gap: 0.0, ..*self };
        let separates = |piece: &Piece| piece.velocity > 0.0;
        let last = touching.pieces(most + INSTANT, separates).pop()?;
        separates(&last).then_some(last.start)
    }

    /// The pieces up to t = `end`, or to the first for which `last` holds.
    fn pieces(&self, end: f64, last: impl Fn(&Piece) -> bool) -> Vec<Piece> {
        let (share, travel) = (self.share(), self.travel_times());
        let mut fronts: [VecDeque<Front>; 2] = Default::default();
        let mut now = Piece {
            start: 0.0,
            displacement: self.gap,
            velocity: 0.0,
            force: 0.0,
            free: self.start(),
        };
        let mut pieces: Vec<Piece> = Vec::new();
        let mut arrived = [0.0; 2];
        loop {
            let before = pieces.last().map_or(0.0, |piece| piece.force);
            (now.force, now.velocity) = contact(now.displacement, now.free);
            for (i, sign) in [(0, -2.0), (1, 2.0)] {
                // The arrived front leaves again, with the share of the force.
                let jump = arrived[i] + sign * share[i] * (now.force - before);
                if jump.abs() > INSTANT {
                    fronts[i].push_back(Front {
                        arrival: now.start + travel[i],
                        jump,
                    });
                }
            }
            pieces.push(now);
            if last(&now) {
                return pieces;
            }
            let arrival = fronts
                .iter()
                .filter_map(|queue| queue.front())
                .map(|front| front.arrival)
                .fold(f64::INFINITY, f64::min);
            let touch = if now.velocity < 0.0 {
                now.start - now.displacement / (2.0 * now.velocity)
            } else {
                f64::INFINITY
            };
            let next = arrival.min(touch);
            if next >= end {
                return pieces;
            }
            now.displacement = if touch <= arrival + INSTANT {
                0.0
            } else {
                now.displacement + 2.0 * now.velocity * (next - now.start)
            };
            now.start = next;
            for (i, queue) in fronts.iter_mut().enumerate() {
                arrived[i] = 0.0;
                let count = queue.partition_point(|front| front.arrival <= next + INSTANT);
                for front in queue.drain(..count) {
                    arrived[i] += front.jump;
                }
                now.free[i] += arrived[i];
            }
        }
    }
}

/// F and rdot of ends at the distance `r` that would move freely with `free`.
fn contact(r: f64, free: [f64; 2]) -> (f64, f64) {
    let closing = free[0] - free[1];
    // A difference of sums of order 1 within INSTANT is round-off: the ends touch and move together.
    if r <= 0.0 && closing > INSTANT {
        (closing, 0.0)
    } else if r <= 0.0 && closing.abs() <= INSTANT {
        (0.0, 0.0)
    } else {
        (0.0, -closing)
    }
}
