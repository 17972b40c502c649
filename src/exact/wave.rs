//! Impact of two bars by characteristics: d'Alembert's solution for any impedances, lengths and gap, and for a wall.
//!
//! Time is in T_I of the left bar, velocity in the closing speed c, force in F0 = c Z1 Z2/(Z1 + Z2), displacement in
//! c T_I/2. A free end would move with f_i(t); a contact force F takes its share d_i F off it, d_1 + d_2 = 1:
//!
//! ```text
//! v_1 = f_1 - d_1 F,   v_2 = f_2 + d_2 F,   rdot = f_2 - f_1 + F
//! f_1(t) = f_1(t - T_1) - 2 d_1 F(t - T_1),   f_2(t) = f_2(t - T_2) + 2 d_2 F(t - T_2)
//! ```
//!
//! with T_i the time to the free end and back. While the ends touch, F = f_1 - f_2 where that pushes, and rdot = 0.
//! Everything is constant between events, so events are found exactly: a front that arrives, or r reaching 0.

use crate::history::History;
use std::collections::VecDeque;

/// Two instants closer than this are one: the round-off of sums of travel times.
const INSTANT: f64 = 1e-12;

/// What decides the motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bars {
    /// Z1/Z2, left over right; zero for a wall.
    pub impedance_ratio: f64,
    /// T_2/T_1, the right bar's travel time over the left's; of no account for a wall.
    pub time_ratio: f64,
    /// Gap at t = 0 over c T_I/2, >= 0.
    pub gap: f64,
}

/// The contact from one event to the next.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Piece {
    start: f64,
    displacement: f64,
    velocity: f64,
    force: f64,
    /// f_1 and f_2.
    free: [f64; 2],
}

/// A front on its way to the free end and back to the contact, where it changes f_i by `jump`.
#[derive(Debug, Clone, Copy)]
struct Front {
    arrival: f64,
    jump: f64,
}

/// The motion of the contact, and through it of the bars, from t = 0 to a given end.
#[derive(Debug, Clone)]
pub struct Wave {
    bars: Bars,
    pieces: Vec<Piece>,
}

/// The contact at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// r over c T_I/2.
    pub displacement: f64,
    /// rdot over c.
    pub velocity: f64,
    /// F over F0, >= 0.
    pub force: f64,
}

impl Bars {
    /// Whether there is no right bar.
    pub fn wall(&self) -> bool {
        self.impedance_ratio == 0.0
    }

    /// Velocities at t = 0 in the frame of their mean; of the wall for a wall.
    fn start(&self) -> [f64; 2] {
        if self.wall() { [1.0, 0.0] } else { [0.5, -0.5] }
    }

    /// d_i, the velocity that a force F0 takes from or gives to bar i.
    fn share(&self) -> [f64; 2] {
        let z = self.impedance_ratio;
        [1.0 / (1.0 + z), z / (1.0 + z)]
    }

    /// T_i, there and back.
    fn trip(&self) -> [f64; 2] {
        [1.0, self.time_ratio]
    }

    /// The motion up to t = `end`.
    pub fn solve(&self, end: f64) -> Wave {
        let (share, trip) = (self.share(), self.trip());
        // Profiles ask for fronts that are still to arrive: half a trip more.
        let end = end + 0.5 * trip[0].max(if self.wall() { 0.0 } else { trip[1] }) + INSTANT;
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
                // What has come in goes out again, with the force's share on it.
                let jump = arrived[i] + sign * share[i] * (now.force - before);
                if jump.abs() > INSTANT {
                    fronts[i].push_back(Front {
                        arrival: now.start + trip[i],
                        jump,
                    });
                }
            }
            pieces.push(now);
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
                break;
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
        Wave {
            bars: *self,
            pieces,
        }
    }
}

/// F and rdot for ends at distance `r` that would move with `free`.
fn contact(r: f64, free: [f64; 2]) -> (f64, f64) {
    let closing = free[0] - free[1];
    // What is left of sums of order 1 that cancel is round-off: ends that touch and move together.
    if r <= 0.0 && closing > INSTANT {
        (closing, 0.0)
    } else if r <= 0.0 && closing.abs() <= INSTANT {
        (0.0, 0.0)
    } else {
        (0.0, -closing)
    }
}

impl Wave {
    /// The contact at `t`, at a jump its right-hand limit.
    pub fn at(&self, t: f64) -> State {
        self.piece(t).state(t)
    }

    /// The contact at `t`, at a jump its left-hand limit.
    pub fn before(&self, t: f64) -> State {
        let after = self
            .pieces
            .partition_point(|piece| piece.start < t - INSTANT);
        match after.checked_sub(1) {
            Some(piece) => self.pieces[piece].state(t),
            // Before t = 0 the bars fly.
            None => State {
                displacement: self.bars.gap,
                velocity: -1.0,
                force: 0.0,
            },
        }
    }

    fn piece(&self, t: f64) -> &Piece {
        let after = self
            .pieces
            .partition_point(|piece| piece.start <= t + INSTANT);
        &self.pieces[after.max(1) - 1]
    }

    /// The contact at these times, at a jump its right-hand limit.
    pub fn history(&self, times: &[f64]) -> History {
        let mut history = History::with_capacity(times.len());
        for &t in times {
            let state = self.at(t);
            history.push(t, state.displacement, state.velocity, state.force);
        }
        history
    }

    /// The contact as a line to draw: at these times, rising, and on both sides of every jump between them.
    pub fn line(&self, times: &[f64]) -> History {
        let mut line = History::with_capacity(times.len() + 2 * self.pieces.len());
        let mut push = |t: f64, state: State| {
            line.push(t, state.displacement, state.velocity, state.force);
        };
        let mut pieces = self.pieces.iter().peekable();
        for &t in times {
            while let Some(piece) = pieces.next_if(|piece| piece.start <= t) {
                push(piece.start, self.before(piece.start));
                push(piece.start, piece.state(piece.start));
            }
            push(t, self.at(t));
        }
        line
    }

    /// When the ends first touch.
    pub fn first_touch(&self) -> f64 {
        self.bars.gap * 0.5
    }

    /// When the force first ends, and when the ends first part; `None` where the run ends before.
    pub fn durations(&self) -> [Option<f64>; 2] {
        let first = |from: f64, what: &dyn Fn(&Piece) -> bool| {
            let found = self.pieces.iter().find(|p| p.start >= from && what(p));
            found.map(|piece| piece.start)
        };
        let touch = self.first_touch();
        [
            first(touch, &|p| p.displacement <= 0.0 && p.force == 0.0),
            first(touch, &|p| p.velocity > 0.0),
        ]
    }

    /// Impulse of the contact force from 0 to `t` over F0 T_I.
    pub fn impulse(&self, t: f64) -> f64 {
        let ends = self.pieces.iter().skip(1).map(|piece| piece.start);
        self.pieces
            .iter()
            .zip(ends.chain([f64::INFINITY]))
            .filter(|(piece, _)| piece.start < t)
            .map(|(piece, end)| piece.force * (end.min(t) - piece.start))
            .sum()
    }

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

impl Piece {
    fn state(&self, t: f64) -> State {
        State {
            displacement: self.displacement + 2.0 * self.velocity * (t - self.start),
            velocity: self.velocity,
            force: self.force,
        }
    }
}
