//! What the rest of the program asks of a law besides its step: everything but the list of laws stands in the file of the law.

use super::element::Element;
use super::{ClippedLine, ContactKind, Evolution, Family};
use crate::contact::impact::RigidImpact;
use crate::contact::offer::Offer;
use crate::contact::{ContactLaw, InPlane, StepFlexibility, StoredEnergy, Straight};

/// What is the same for all contacts with a law.
pub trait Described: StoredEnergy {
    /// What its contact can do, unless [`Described::kind`] says otherwise.
    const KIND: ContactKind;
    /// Its name in text.
    const NAME: &'static str;
    /// Whether S follows from rdot alone.
    const OF_VELOCITY: bool = false;
    /// The names by which studies have it; none of a law that is a form of another one.
    const OFFERS: &'static [Offer];
    /// A motion whose force is known in closed form.
    const CLOSED_FORM: ClosedForm<Self>;
    /// How it acts in a plane; `None` for a law that does not slide in one.
    const IN_PLANE: InPlane<Self> = None;

    /// What its contact can do.
    fn kind(&self) -> ContactKind {
        Self::KIND
    }
}

/// A motion whose force is known in closed form, for tests.
#[derive(Debug, Clone, Copy)]
pub enum ClosedForm<W> {
    /// Two rigid masses that collide: of m = m1 m2/(m1 + m2) and the closing speed.
    Collision(fn(&W, f64, f64) -> RigidImpact),
    /// S after a motion from rest with S = 0 at this rdot > 0 for this time; `None` for numbers without a closed form.
    Driven(fn(&W, f64, f64) -> Option<f64>),
    /// None is known, for this reason; tests integrate the motion instead.
    None(&'static str),
}

/// What the numbers of a contact tell. The default is the answer of the law's family, or what most laws do not have; the table of all
/// laws in `properties.txt` shows it.
pub trait Properties {
    /// The laws that it is like.
    fn family(&self) -> Family {
        Family::Alone
    }

    /// Numbers that tell one contact from another, each after its name.
    fn shown(&self) -> Vec<(&'static str, f64)> {
        self.family().shown()
    }

    /// The largest dS/dr; of a law with delta^1.5 that at this overlap. A viscous law has none, rigid contact an infinite one.
    fn largest_stiffness(&self, overlap: f64) -> f64 {
        self.family().largest_stiffness(overlap)
    }

    /// dS/dr at rest: of an impact with this overlap, of friction with a limit at S = 0; 0 for a law that is not elastic there.
    fn initial_stiffness(&self, overlap: f64) -> f64 {
        self.family().initial_stiffness(overlap)
    }

    /// A displacement or velocity that shows the law in a figure: some widths of a friction law, the overlap of an impact law under
    /// a force of 1.
    fn reach(&self) -> f64 {
        self.family().reach()
    }

    /// The bounds of S.
    fn bounds(&self) -> [f64; 2] {
        self.family().bounds()
    }

    /// Whether figures draw the law over velocity: it depends on velocity alone, or its loop over velocity shows it better.
    fn over_velocity(&self) -> bool {
        self.family().over_velocity()
    }

    /// Whether a step may have several roots.
    fn falls(&self) -> bool {
        false
    }

    /// Whether every step with these flexibilities has one root; false for a law that falls, where a step may have several. The default
    /// is on the safe side: a law that falls and does not say which steps have one root is refused.
    fn has_one_root(&self, _on: &StepFlexibility<1>) -> bool {
        !self.falls()
    }

    /// Whether Coulomb friction, or an impact without compliance, is what the law tends to: not of one that yields, or that has a
    /// force besides, nor of a link.
    fn has_rigid_form(&self) -> bool {
        self.family().has_rigid_form()
    }

    /// Whether S has the closing speed of the first touch as a divisor.
    fn divides_by_closing_speed(&self) -> bool {
        false
    }

    /// S(0) at a velocity of a law with a state, which is unbent; `None` where S follows from r and rdot.
    fn unbent_force(&self, _rdot: f64) -> Option<f64> {
        None
    }

    /// Time for which two free masses touch, of 1/m = 1/m1 + 1/m2 and, where the time depends on it, the largest overlap; `None`
    /// without compliance, without this overlap, and for what is no impact.
    fn touching_time(&self, inverse_mass: f64, overlap: Option<f64>) -> Option<f64> {
        self.family().touching_time(inverse_mass, overlap)
    }

    /// Whether S is not a function of the motion: it may have any value within bounds at rest.
    fn is_vertical(&self) -> bool {
        self.family().is_vertical()
    }

    /// The clipped line that the law is.
    fn line(&self) -> Option<ClippedLine> {
        None
    }

    /// Its straight lines, if S follows r on such and its friction limit is constant.
    fn straight(&self) -> Option<Straight> {
        None
    }

    /// The law of its spring alone, if an impact has a damper.
    fn undamped(&self) -> Option<ContactLaw> {
        None
    }

    /// The law in continuous time, if it has a state; `None` where S follows from r and rdot, and from r and S at the last reversal.
    fn evolution(&self) -> Option<&dyn Evolution> {
        None
    }

    /// rdot of a law of velocity alone under a force within its bounds, and how it changes with the force; `None` where it is not known in
    /// closed form, or steep.
    fn rate_under(&self, _force: f64) -> Option<[f64; 2]> {
        None
    }

    /// A number that changes its sign where S has a corner at this rdot, besides rdot = 0 and the bounds of S; 0 for a law without one.
    fn corner(&self, _rdot: f64) -> f64 {
        0.0
    }

    /// What the law does that has a meaning in time steps only; `None` if its steps tend to a motion in continuous time that is known.
    fn only_in_steps(&self) -> Option<&'static str> {
        None
    }

    /// The law as the papers print it, at r under S; `None` if they do not.
    fn element(&self, _r: f64, _s: f64) -> Option<Box<dyn Element>> {
        None
    }
}
