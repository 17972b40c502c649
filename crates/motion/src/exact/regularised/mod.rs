//! Exact free vibration with the softened friction laws in continuous time: X'' + X + S = 0. S is linear in X within alpha of the
//! slip (displacement-control [F (9)]), or linear in V up to beta (velocity-control [F (16)]).
//!
//! Between events the motion is linear and has a closed form. A piece starts with the final state of the piece before it, so an
//! error in the time of an event changes the motion only by the error of the force during this time.

mod displacement;
mod velocity;

use super::State;
use std::ops::RangeInclusive;

/// Latest time with a useful accuracy: there are up to four events in a period, and here the round-off of the time itself is
/// 1e-9.
pub const LATEST: f64 = 1e7;

/// Widths alpha and beta, and largest |X|, for which no product of a piece leaves the range of double precision. Below alpha =
/// 1e-32 and beta = 1e-16 the motions are those of Coulomb friction within round-off.
const WIDTHS: RangeInclusive<f64> = 1e-100..=1e100;

/// Smallest |x0| of a release with a force: below it the motion has the round-off of the force, which is at most 1.
const SMALLEST: f64 = 1e-6;

/// Whether the motion after release at `x0` with the force `force` has 10 correct digits up to the time `end`.
pub fn holds(x0: f64, width: f64, force: f64, end: f64) -> bool {
    let far = x0.abs() <= *WIDTHS.end();
    let near = force == 0.0 || x0.abs() >= SMALLEST;
    far && near && WIDTHS.contains(&width) && end <= LATEST
}

/// A motion after release at rest, from piece to piece; in T = omega_n t, X = x/Delta, S in units of nu N.
///
/// Its error is round-off of the largest |X| times the number of pieces passed.
///
/// The energy gives the peaks: with S at its limit, the peak P is followed by sqrt((P - 1)^2 + 4 alpha) - 1 on the other side.
/// For P = 12 and alpha = 5.75 this is sqrt(144) - 1 = 11:
///
/// ```
/// use slipgap_motion::exact::regularised::Regularised;
///
/// let mut motion = Regularised::displacement(12.0, 5.75, 1.0);
/// let sliding = motion.next_event();
/// assert!((motion.at(sliding).force + 1.0).abs() < 1e-14);
/// // The next event is the end of sliding, at the peak.
/// motion.at(sliding + 1e-6);
/// let peak = motion.at(motion.next_event());
/// assert!((peak.displacement + 11.0).abs() < 1e-13 && peak.velocity.abs() < 1e-13);
/// ```
#[derive(Debug, Clone)]
pub struct Regularised(Model);

#[derive(Debug, Clone)]
enum Model {
    Displacement(Motion<displacement::Piece>),
    Velocity(Motion<velocity::Piece>),
}

impl Regularised {
    /// The displacement-control model of width `alpha` > 0, released at `x0` with the force `force` within -1..=1.
    pub fn displacement(x0: f64, alpha: f64, force: f64) -> Regularised {
        let first = displacement::Piece::release(x0, alpha, force);
        Regularised(Model::Displacement(Motion::new(first)))
    }

    /// The velocity-control model of width `beta` > 0, released at `x0`.
    pub fn velocity(x0: f64, beta: f64) -> Regularised {
        let first = velocity::Piece::release(x0, beta);
        Regularised(Model::Velocity(Motion::new(first)))
    }

    /// The state at `time` >= 0; times must not decrease from call to call.
    pub fn at(&mut self, time: f64) -> State {
        match &mut self.0 {
            Model::Displacement(motion) => motion.at(time),
            Model::Velocity(motion) => motion.at(time),
        }
    }

    /// The time of the next event; infinite if there is none.
    pub fn next_event(&self) -> f64 {
        match &self.0 {
            Model::Displacement(motion) => motion.start + motion.length,
            Model::Velocity(motion) => motion.start + motion.length,
        }
    }
}

/// The motion between two events; times count from its start.
trait Piece: Sized {
    fn at(&self, time: f64) -> State;
    /// Time of the event that ends it; infinite if none does.
    fn length(&self) -> f64;
    /// The piece after that event.
    fn next(&self, length: f64) -> Self;
}

#[derive(Debug, Clone)]
struct Motion<P> {
    piece: P,
    start: f64,
    length: f64,
}

impl<P: Piece> Motion<P> {
    fn new(piece: P) -> Motion<P> {
        Motion {
            start: 0.0,
            length: piece.length(),
            piece,
        }
    }

    fn at(&mut self, time: f64) -> State {
        while time > self.start + self.length {
            self.piece = self.piece.next(self.length);
            self.start += self.length;
            self.length = self.piece.length();
        }
        self.piece.at(time - self.start)
    }
}
