//! Structures with one contact by their modes, many at a time: the recursion of a method.
//!
//! This is the second form of every method, for speed: a mode takes three to ten operations in a step and no matrix.

mod mode;
mod storage;
mod work;

pub use mode::Mode;
pub(super) use storage::sums;
pub use storage::{ManyModes, ModeCount, OneMode, Storage};
pub use work::ContactWork;

use super::{Method, Scheme};
use crate::contact::{ContactResponse, StepFlexibility};
use crate::lane::Lane;

/// Structures at t = 0, from which a method starts.
#[derive(Debug, Clone, Copy)]
pub struct Start<const L: usize> {
    /// The method of each case; all have the scheme of the first one.
    pub method: [Method; L],
    /// Time step.
    pub dt: Lane<L>,
    /// r at rest.
    pub gap: Lane<L>,
    /// S(0).
    pub force: Lane<L>,
}

/// A mode at t = 0, the same mode of each structure.
#[derive(Debug, Clone, Copy)]
pub struct ModeStart<const L: usize> {
    /// The mode of each structure.
    pub mode: [Mode; L],
    /// Coordinate x.
    pub displacement: Lane<L>,
    /// Its velocity.
    pub velocity: Lane<L>,
}

/// A method for the modes of L structures with one contact each. For a mode x'' + omega2 x = -phi2 S, and r = gap + sum x.
pub trait Recursion<const L: usize>: Clone {
    /// The method's description, which it has its coefficients from.
    type Scheme: Scheme;

    /// Modes at t = 0; equilibrium with S(0) gives a(0). `None` without a mode, or for methods of another scheme.
    fn new(start: &Start<L>, modes: impl Iterator<Item = ModeStart<L>>) -> Option<Self>;

    /// The contact after the last step.
    fn contact(&self) -> ContactState<L>;

    /// Reduction of the motion of the contact by contact forces, for each of the sub-steps; the same twice in a method without
    /// sub-steps.
    fn flexibilities(&self) -> [StepFlexibility<L>; 2];

    /// One step; `law` gives the force at the end of each sub-step.
    fn step(&mut self, law: &mut impl ContactResponse<L>) -> ContactState<L>;

    /// Moves the state out. A loop over steps works on a local state: the compiler keeps it in registers, since what the loop
    /// writes elsewhere cannot change it.
    fn take(&mut self) -> Self;

    /// Velocity of the first mode.
    fn first_velocity(&self) -> Option<Lane<L>>;

    /// Coordinates and velocities of the modes.
    fn modes(&self) -> impl Iterator<Item = (Lane<L>, Lane<L>)> + '_;

    /// Steps 0..=`last` of each lane. `advance` moves by a number of steps. `end` gets the state whenever lanes end, and which of
    /// them end. Gives the contact of each lane at its own last step.
    ///
    /// A lane that has ended moves on with the others and changes none of them.
    fn run(
        &mut self,
        last: &[u64; L],
        mut advance: impl FnMut(&mut Self, usize),
        mut end: impl FnMut(&Self, &EndingLanes<L>),
    ) -> ContactState<L> {
        let mut ends = self.contact();
        let (mut at, mut from) = (0, 0);
        while let Some(next) = last.iter().copied().filter(|n| *n >= from).min() {
            advance(self, (next - at) as usize);
            let ending = EndingLanes::new(last, next);
            let now = self.contact();
            ends = ContactState {
                displacement: ending.select(now.displacement, ends.displacement),
                velocity: ending.select(now.velocity, ends.velocity),
                force: ending.select(now.force, ends.force),
            };
            end(self, &ending);
            (at, from) = (next, next + 1);
        }
        ends
    }
}

/// The contact at the end of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactState<const L: usize> {
    /// Relative displacement r.
    pub displacement: Lane<L>,
    /// Relative velocity rdot.
    pub velocity: Lane<L>,
    /// Force S.
    pub force: Lane<L>,
}

impl<const L: usize> ContactState<L> {
    /// Whether the motion of each lane is finite. A motion that is not finite at a step is not finite at any later step.
    pub fn finite(&self) -> [bool; L] {
        let numbers = [self.displacement, self.velocity, self.force];
        std::array::from_fn(|l| numbers.iter().all(|x| x.0[l].is_finite()))
    }
}

/// The lanes that end at a step.
#[derive(Debug, Clone, Copy)]
pub struct EndingLanes<const L: usize>([bool; L]);

impl<const L: usize> EndingLanes<L> {
    #[inline(always)]
    fn new(last: &[u64; L], step: u64) -> Self {
        let mut ending = [false; L];
        for (ending, last) in ending.iter_mut().zip(last) {
            *ending = *last == step;
        }
        EndingLanes(ending)
    }

    /// `now` in the lanes that end, `before` in the others.
    #[inline(always)]
    pub fn select(&self, now: Lane<L>, mut before: Lane<L>) -> Lane<L> {
        for ((before, now), ending) in before.0.iter_mut().zip(now.0).zip(self.0) {
            *before = if ending { now } else { *before };
        }
        before
    }
}
