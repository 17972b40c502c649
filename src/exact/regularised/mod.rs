//! Free vibration with the regularised friction models in continuous time, exactly: X'' + X + S = 0, where S follows
//! X within alpha of the slip (displacement-control [F (9)]) or V up to beta (velocity-control [F (16)]).
//!
//! Between events the motion is linear and stands in closed form. A piece starts with the state in which the one
//! before it ended, so an error in the time of an event moves the motion by the force that it misjudges, not by more.

mod displacement;
mod velocity;

use super::coulomb::State;
use std::ops::RangeInclusive;

/// Latest time for which it is worth asking: a run has up to four events a period, and by then round-off of the time
/// itself is 1e-9.
pub const LATEST: f64 = 1e7;

/// Widths alpha and beta, and largest |X|, for which no product of a piece leaves the range of numbers. From 1e-32 and
/// 1e-16 on the motions are Coulomb's within round-off, as far as it goes.
const WIDTHS: RangeInclusive<f64> = 1e-100..=1e100;

/// Least |x0| of a release with a force: from there on the motion is round-off of that, which is 1 or less.
const LEAST: f64 = 1e-6;

/// Whether the motions here are right to 10 digits, released at `x0` with the force `force`, up to the time `end`.
pub fn holds(x0: f64, width: f64, force: f64, end: f64) -> bool {
    let far = x0.abs() <= *WIDTHS.end();
    let near = force == 0.0 || x0.abs() >= LEAST;
    far && near && WIDTHS.contains(&width) && end <= LATEST
}

/// A motion after release at rest, from piece to piece; in T = omega_n t, X = x/Delta, S in units of nu N.
///
/// Within round-off of the motion's largest X, times the number of pieces passed.
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

    /// The state at `time` >= 0, no less than any asked for before.
    pub fn at(&mut self, time: f64) -> State {
        match &mut self.0 {
            Model::Displacement(motion) => motion.at(time),
            Model::Velocity(motion) => motion.at(time),
        }
    }

    /// The time of the next event after those passed so far; infinite when there is none.
    pub fn next_event(&self) -> f64 {
        match &self.0 {
            Model::Displacement(motion) => motion.start + motion.length,
            Model::Velocity(motion) => motion.start + motion.length,
        }
    }
}

/// A stretch of the motion between two events; times count from its start.
trait Piece: Sized {
    fn at(&self, time: f64) -> State;
    /// Time of the event that ends it; infinite if none does.
    fn length(&self) -> f64;
    /// What follows that event.
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
