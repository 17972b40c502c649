//! What computes a reduction, for the table of reductions: a function of the series that the motion of a case gives.

use crate::contact::ContactKind;
use crate::problem::structure::channels::channel::Quantity;
use crate::system::loads::measures::Measure;
use std::borrow::Cow;

/// A function of values and of the time at a place.
pub type OfValues = fn(&[f64], &dyn Fn(usize) -> f64) -> Option<f64>;

/// A function of a computed loop and of the measured one.
pub type OfLoop = fn([&[f64]; 2], [&[f64]; 2]) -> Option<f64>;

/// What computes a reduction.
#[derive(Clone, Copy)]
pub enum Function {
    /// Of the values of a channel, and of the time at their places.
    Values(OfValues),
    /// Of a channel in two motions: the size of a difference, which in a plane is that of a vector.
    Distance([Motion; 2], fn(&[f64], &[f64]) -> Option<f64>),
    /// Of a channel in two motions: another number.
    Pair([Motion; 2], fn(&[f64], &[f64]) -> Option<f64>),
    /// A distance between exact motions that is estimated together with them.
    Estimated,
    /// Of a channel in the computed motion and in that of the perturbed start.
    Perturbed(fn(&Perturbed) -> Option<f64>),
    /// Of these quantities of a contact.
    Contact(
        &'static [Quantity],
        Plane,
        fn(&ContactSeries) -> Option<f64>,
    ),
    /// Of the energy error and the numerical dissipation.
    Energies(fn([f64; 2]) -> f64),
    /// Of a channel and what was measured of it, at these times.
    Measured(fn(&[f64], [&[f64]; 2]) -> Option<f64>),
    /// Of two channels, and what was measured of both.
    Loop(OfLoop),
    /// Of the motion of the ground.
    Ground(OfGround),
    /// What a program of others tells of a case besides its motion.
    Told,
}

/// A motion of a case.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Motion {
    /// By the time steps.
    Computed,
    /// The exact one of `contacts_reference`.
    Reference,
    /// Exact, with the softened laws.
    Softened,
    /// Exact, with the rigid laws.
    Rigid,
    /// Exact, with the softened laws on a finer mesh.
    Finer,
    /// By the time steps with the whole matrices.
    Unreduced,
    /// By the time steps from the perturbed start.
    Perturbed,
}

impl Motion {
    /// Whether the motion is an exact one.
    pub fn is_exact(self) -> bool {
        match self {
            Motion::Reference | Motion::Softened | Motion::Rigid | Motion::Finer => true,
            Motion::Computed | Motion::Unreduced | Motion::Perturbed => false,
        }
    }
}

/// How a reduction is of both directions of a contact in a plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Plane {
    /// It is of one direction only.
    No,
    /// The sum of both.
    Sum,
    /// The same in both.
    Same,
    /// The length of a vector of both.
    Vector,
    /// Of the sizes of the quantities.
    OfSizes,
}

/// The series of a contact.
pub struct ContactSeries<'a> {
    /// The values of a quantity over the steps.
    pub of: &'a dyn Fn(Quantity) -> Cow<'a, [f64]>,
    /// Time step.
    pub dt: f64,
    /// The kind of its law.
    pub kind: ContactKind,
    /// Whether its force acts by impulses.
    pub by_impulses: bool,
}

impl<'a> ContactSeries<'a> {
    /// The force.
    pub fn force(&self) -> Cow<'a, [f64]> {
        (self.of)(Quantity::Force)
    }
}

/// A channel in a motion and in that of the perturbed start.
pub struct Perturbed<'a> {
    /// The computed values.
    pub values: &'a [f64],
    /// Those from the perturbed start.
    pub other: &'a [f64],
    /// The threshold of a divergence, over the peak.
    pub threshold: f64,
    /// Time step.
    pub dt: f64,
    /// Whether nothing but round-off moves the channel.
    pub is_still: &'a dyn Fn() -> bool,
    /// The impacts of all contacts in so many steps.
    pub impacts: &'a dyn Fn(usize) -> usize,
}

/// What of the ground a reduction is of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum OfGround {
    /// A measure of its motion.
    Measure(Measure),
    /// The pseudo-acceleration of an oscillator that the study gives.
    Oscillator,
    /// The factor of its motion.
    Factor,
    /// The factor of its set.
    SetFactor,
    /// The least ratio of the spectrum of its set to what its rule asks for.
    SetRatio,
}

impl OfGround {
    /// Whether it is of the set of the ground.
    pub fn of_set(self) -> bool {
        match self {
            OfGround::SetFactor | OfGround::SetRatio => true,
            OfGround::Measure(_) | OfGround::Oscillator | OfGround::Factor => false,
        }
    }
}

/// The unit of a reduction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UnitOf {
    /// That of its channel.
    Channel,
    /// Of time.
    Time,
    /// Of length.
    Length,
    /// Of velocity.
    Velocity,
    /// Of acceleration.
    Acceleration,
    /// Of force times time.
    Impulse,
    /// Of energy.
    Energy,
    /// A number or a ratio.
    None,
}
