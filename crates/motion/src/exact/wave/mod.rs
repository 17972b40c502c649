//! Impact of two bars by characteristics: d'Alembert's solution for any impedances, lengths and gap, and for a wall.
//!
//! Time is in T_I of the left bar, velocity in the closing speed c, force in F0 = c Z1 Z2/(Z1 + Z2), displacement in
//! c T_I/2. Without a contact force the end of bar i would move with f_i(t). A contact force F takes its share d_i F from it,
//! with d_1 + d_2 = 1:
//!
//! ```text
//! v_1 = f_1 - d_1 F,   v_2 = f_2 + d_2 F,   rdot = f_2 - f_1 + F
//! f_1(t) = f_1(t - T_1) - 2 d_1 F(t - T_1),   f_2(t) = f_2(t - T_2) + 2 d_2 F(t - T_2)
//! ```
//!
//! T_i is the time to the free end and back. While the ends touch, F = f_1 - f_2 if this pushes, and rdot = 0. Everything is
//! constant between events, so events are computed without iteration: a front that arrives, or r that becomes 0.

mod events;
mod profile;
#[cfg(test)]
mod tests;

use super::State;
use crate::history::History;

/// Two times closer than this are equal: the round-off of sums of travel times.
const INSTANT: f64 = 1e-12;

/// The numbers that the motion depends on.
///
/// Two equal bars are in contact for T_I under the force F0, then they separate with the closing speed:
///
/// ```
/// use slipgap_motion::exact::State;
/// use slipgap_motion::exact::wave::Bars;
///
/// let bars = Bars { impedance_ratio: 1.0, time_ratio: 1.0, gap: 0.0 };
/// let wave = bars.solve(2.0);
/// assert_eq!(wave.durations(), [Some(1.0); 2]);
/// assert_eq!(wave.at(0.5), State { displacement: 0.0, velocity: 0.0, force: 1.0 });
/// assert_eq!(wave.at(1.5), State { displacement: 1.0, velocity: 1.0, force: 0.0 });
/// assert_eq!(wave.restitution(2.0), 1.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bars {
    /// Z1/Z2, left over right; zero for a wall.
    pub impedance_ratio: f64,
    /// T_2/T_1, the travel time of the right bar over that of the left one; without effect for a wall.
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

/// The motion of the contact from t = 0 to a given end. The motion of the bars follows from it.
///
/// States have r over c T_I/2, rdot over c, and F over F0, which is never negative.
#[derive(Debug, Clone)]
pub struct Wave {
    bars: Bars,
    pieces: Vec<Piece>,
}

impl Bars {
    /// Whether there is no right bar.
    pub fn wall(&self) -> bool {
        self.impedance_ratio == 0.0
    }

    /// Velocities at t = 0 in the frame of their mean, or of the wall.
    fn start(&self) -> [f64; 2] {
        if self.wall() { [1.0, 0.0] } else { [0.5, -0.5] }
    }

    /// d_i, the change of velocity of the end of bar i under a force F0.
    fn share(&self) -> [f64; 2] {
        let z = self.impedance_ratio;
        [1.0 / (1.0 + z), z / (1.0 + z)]
    }

    /// T_i, there and back.
    fn travel_times(&self) -> [f64; 2] {
        [1.0, self.time_ratio]
    }
}

impl Wave {
    /// The numbers that the motion depends on.
    pub fn bars(&self) -> &Bars {
        &self.bars
    }

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
            // Before t = 0 the bars are in flight.
            None => State::flight(self.bars.gap),
        }
    }

    fn piece(&self, t: f64) -> &Piece {
        let after = self
            .pieces
            .partition_point(|piece| piece.start <= t + INSTANT);
        &self.pieces[after.max(1) - 1]
    }

    /// Calls `visit` at each of the times, which increase, with the index of the time, the state of [`Wave::at`] and, if a piece
    /// begins at that time, the state of [`Wave::before`].
    pub fn walk(
        &self,
        times: impl Iterator<Item = f64>,
        mut visit: impl FnMut(usize, State, Option<State>),
    ) {
        let mut begun = 0;
        for (i, t) in times.enumerate() {
            let later = &self.pieces[begun..];
            begun += later
                .iter()
                .take_while(|piece| piece.start <= t + INSTANT)
                .count();
            let piece = &self.pieces[begun.max(1) - 1];
            let jumps = piece.start >= t - INSTANT;
            visit(i, piece.state(t), jumps.then(|| self.before(t)));
        }
    }

    /// The contact at these times, at a jump its right-hand limit.
    pub fn history(&self, times: &[f64]) -> History {
        History::sample(times, |t| self.at(t).values())
    }

    /// The contact as a line to draw: at these times, which increase, and on both sides of every jump between them.
    pub fn line(&self, times: &[f64]) -> History {
        let mut rows = Vec::with_capacity(times.len() + 2 * self.pieces.len());
        let mut pieces = self.pieces.iter().peekable();
        for &t in times {
            while let Some(piece) = pieces.next_if(|piece| piece.start <= t) {
                rows.push((piece.start, self.before(piece.start).values()));
                rows.push((piece.start, piece.state(piece.start).values()));
            }
            rows.push((t, self.at(t).values()));
        }
        rows.into_iter().collect()
    }

    /// Time of the first touch.
    pub fn first_touch(&self) -> f64 {
        self.bars.gap * 0.5
    }

    /// Times at which the force first ends, and at which the ends first separate; `None` if the run ends before.
    pub fn durations(&self) -> [Option<f64>; 2] {
        let touch = self.first_touch();
        let first = |holds: &dyn Fn(&Piece) -> bool| {
            let mut pieces = self.pieces.iter().filter(|piece| piece.start >= touch);
            pieces.find(|piece| holds(piece)).map(|piece| piece.start)
        };
        [
            first(&|p| p.displacement <= 0.0 && p.force == 0.0),
            first(&|p| p.velocity > 0.0),
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

    /// The largest contact force before `t` over F0.
    pub fn peak_force(&self, t: f64) -> f64 {
        let before = self.pieces.iter().take_while(|piece| piece.start < t);
        before.map(|piece| piece.force).fold(0.0, f64::max)
    }

    /// Relative velocity of the mass centres at `t` over c, positive if they move apart. The impulse F0 T_I J reduces the
    /// velocity of the left bar by 2 d_1 J and increases that of the right bar by 2 d_2 J/theta. The mass of the right bar is
    /// theta d_1/d_2 of that of the left one.
    pub fn restitution(&self, t: f64) -> f64 {
        let [left, right] = self.bars.share();
        let right = if self.bars.wall() {
            0.0
        } else {
            right / self.bars.time_ratio
        };
        2.0 * (left + right) * self.impulse(t) - 1.0
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
