//! Coulomb friction with a static limit above the kinetic one in a plane, over a step.
//!
//! As in one direction the force over a step is its mean S. S is in a disc of radius R about 0, so that the force at the end of the step,
//! S' = 2 S - S(start), is in the disc of radius 2 R about -S(start). At the rim S is along rdot'. For given radii the forces of all
//! contacts are one convex problem. The radius tells what the contact does:
//!
//! ```text
//! sticks at the start   R = Ls     S at the rim: it breaks loose,                        R = L to the end of the step
//! slides along e        R = L      S at the rim with S.e < 0: it would turn back,        R = Ls, as a contact that sticks
//! ```
//!
//! A contact turns back where its velocity turns by more than a right angle in a step. It stops there if Ls holds it, as in one direction,
//! where these are the intervals [-Ls, Ls] and [-L, Ls]. Contacts that turn back go first, so that no force is cut to L that a contact
//! holds. Then all contacts at Ls break loose together. A radius changes at most twice in a step: at most 2 m + 1 problems.
//!
//! A contact under a load p with L < p < Ls stops in continuous time only on a line, against p: elsewhere the velocity turns to p while it
//! falls, and never is 0. So the motion is not continuous in its start there, and a step stops the contact also where its velocity
//! would have turned by more than a right angle within the step. These starts are fewer, the shorter the step is.

use crate::contact::plane::{Pair, dot, length};
use crate::lane::Lane;
use crate::system::structure::{PlaneRow, Structure};

/// Round-off of a force at a bound over both bounds: some multiples of the unit round-off.
pub(crate) const ROUND_OFF: f64 = 1e-14;

/// Where the force of a contact may be.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Admissible {
    /// Within these bounds.
    Between([f64; 2]),
    /// In this disc, of a contact in a plane by its first direction.
    Disc(Disc),
}

/// Takes where the force of a contact may be from now on.
pub(crate) type Admit<'a> = dyn FnMut(usize, Admissible) + 'a;

/// Where the force of both directions may be at the end of a step.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Disc {
    pub(crate) centre: Pair,
    pub(crate) radius: f64,
}

impl Disc {
    /// The nearest force.
    pub(crate) fn nearest(&self, force: Pair) -> Pair {
        let from = self.centred(force);
        match length(from) {
            size if size > self.radius => {
                std::array::from_fn(|i| self.centre[i] + from[i] * (self.radius / size))
            }
            _ => force,
        }
    }

    pub(crate) fn centred(&self, force: Pair) -> Pair {
        std::array::from_fn(|i| force[i] - self.centre[i])
    }

    /// Whether a force is at the rim.
    fn ends_at(&self, force: Pair) -> bool {
        let near = ROUND_OFF * (length(self.centre) + self.radius);
        length(self.centred(force)) >= self.radius - near
    }
}

/// What a contact does in a step.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Doing {
    /// Up to Ls.
    Sticks,
    /// At L, with S along this at the start.
    Slides(Pair),
    /// At L, after it broke loose in this step.
    IsLoose,
}

/// A contact in a plane with two limits in a lane.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PlaneLimits {
    /// Its first direction.
    pub(crate) first: usize,
    pub(crate) lane: usize,
    /// Ls/L > 1.
    ratio: f64,
    /// L at the end of the step, and the mean of both ends.
    limit: f64,
    mean: f64,
    doing: Doing,
    /// The force at the start of the step, if S is the mean with it.
    start: Option<Pair>,
}

impl PlaneLimits {
    /// `None` of other contacts.
    pub(super) fn new(case: &Structure, contact: usize, lane: usize) -> Option<PlaneLimits> {
        let law = &case.contacts[contact].law;
        let ratio = law.static_ratio();
        if ratio == 1.0 || law.row() != Some(PlaneRow::First) {
            return None;
        }
        let limit = law.limit().map_or(0.0, |limit| limit.at(0.0));
        let rate = [contact, contact + 1].map(|row| case.rate_at_start(row));
        Some(PlaneLimits {
            first: contact,
            lane,
            ratio,
            limit,
            mean: limit,
            doing: match rate {
                [0.0, 0.0] => Doing::Sticks,
                rate => Doing::Slides(rate),
            },
            start: None,
        })
    }

    /// Whether this is one of its directions.
    pub(super) fn has(&self, contact: usize) -> bool {
        contact == self.first || contact == self.first + 1
    }

    /// Takes L at the end of a step.
    pub(super) fn limit<const L: usize>(&mut self, limit: Lane<L>) {
        let limit = limit.0[self.lane];
        self.mean = 0.5 * (self.limit + limit);
        self.limit = limit;
    }

    /// L.
    pub(super) fn kinetic(&self) -> f64 {
        self.limit
    }

    /// The part of the static limit that is used by a force with this part of L; 1 if the contact slides.
    pub(super) fn share(&self, of_kinetic: f64) -> f64 {
        match self.doing {
            Doing::Sticks => of_kinetic / self.ratio,
            Doing::Slides(_) | Doing::IsLoose => 1.0,
        }
    }

    /// Starts a step: S is its force at the end, or the mean with this one at the start.
    pub(crate) fn begin(&mut self, start: Option<Pair>) -> Disc {
        self.start = start;
        self.disc()
    }

    /// Of S.
    fn radius(&self) -> f64 {
        match self.doing {
            Doing::Sticks => self.ratio * self.mean,
            Doing::Slides(_) | Doing::IsLoose => self.mean,
        }
    }

    /// Of the force at the end.
    fn disc(&self) -> Disc {
        let radius = self.radius();
        match self.start {
            Some(start) => Disc {
                centre: start.map(|s| -s),
                radius: 2.0 * radius,
            },
            None => Disc {
                centre: [0.0; 2],
                radius,
            },
        }
    }

    /// The new disc of a contact that would turn back with this force at the end of the step.
    pub(super) fn turns_back(&mut self, force: Pair) -> Option<Disc> {
        let Doing::Slides(along) = self.doing else {
            return None;
        };
        let disc = self.disc();
        let turns = disc.ends_at(force) && dot(disc.centred(force), along) < 0.0;
        self.becomes(turns, Doing::Sticks)
    }

    /// The new disc of a contact that breaks loose with this force.
    pub(super) fn breaks(&mut self, force: Pair) -> Option<Disc> {
        let breaks = self.doing == Doing::Sticks && self.disc().ends_at(force);
        self.becomes(breaks, Doing::IsLoose)
    }

    fn becomes(&mut self, does: bool, doing: Doing) -> Option<Disc> {
        does.then(|| {
            self.doing = doing;
            self.disc()
        })
    }

    /// Ends a step with this force at its end; returns S.
    pub(crate) fn end(&mut self, force: Pair) -> Pair {
        let (disc, radius) = (self.disc(), self.radius());
        let from = disc.centred(force);
        let slides = disc.ends_at(force);
        self.mean = self.limit;
        let size = length(from);
        if !slides {
            self.doing = Doing::Sticks;
            return from.map(|s| s * (radius / disc.radius));
        }
        // At a limit of 0 the contact slides in no direction.
        let force = from.map(|s| if size > 0.0 { s / size * radius } else { 0.0 });
        self.doing = Doing::Slides(force);
        force
    }
}
