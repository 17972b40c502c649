//! Coulomb friction with a static limit above the kinetic one, over a step.
//!
//! The force falls from Ls to L where a contact breaks loose, so that a step is no convex problem. It is a row of convex problems
//! instead. The force of such a contact over a step is one number, its mean S: the force at the end of a step would alternate about
//! the force that holds, and break loose where that one does not. S is in an interval with a static and a kinetic end:
//!
//! ```text
//! stuck at the start  [-Ls, Ls]        slides with rdot > 0  [-Ls, L]        with rdot < 0  [-L, Ls]
//! ```
//!
//! A sliding contact that stops in the step therefore sticks if Ls holds it. All contacts whose S is at a static end break loose: this
//! end becomes the kinetic one, and the forces are found again. Each problem has one answer, ends change at once and only in this
//! direction, so that the result is unique, does not depend on the order of the contacts, and takes at most 2 m + 1 problems.

use crate::lane::Lane;
use crate::methods::Method;
use crate::system::structure::Structure;

/// Round-off of a force at a bound over both bounds: some multiples of the unit round-off.
const ROUND_OFF: f64 = 1e-14;

/// A contact with two limits in a lane.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TwoLimits {
    pub(crate) contact: usize,
    pub(crate) lane: usize,
    /// Ls/L > 1.
    ratio: f64,
    /// L at the end of the step, and the mean of both ends.
    limit: f64,
    mean: f64,
    /// Whether the lower end and the upper one are kinetic.
    kinetic: [bool; 2],
    /// The force at the start of the step in the balance: what S is the mean with.
    start: Option<f64>,
}

/// The contacts with two limits of L structures; no item without any.
#[derive(Debug, Clone)]
pub(crate) struct StaticFriction(Vec<TwoLimits>);

impl StaticFriction {
    /// `None` if no contact has two limits.
    pub(crate) fn new<const L: usize>(cases: &[&Structure; L]) -> Option<StaticFriction> {
        let mut two_limits = Vec::new();
        for (lane, case) in cases.iter().enumerate() {
            for (contact, given) in case.contacts.iter().enumerate() {
                let ratio = given.law.static_ratio();
                if ratio > 1.0 {
                    let limit = given.law.limit().map_or(0.0, |limit| limit.at(0.0));
                    let rate = case.rate_at_start(contact);
                    two_limits.push(TwoLimits {
                        contact,
                        lane,
                        ratio,
                        limit,
                        mean: limit,
                        kinetic: [rate < 0.0, rate > 0.0],
                        start: None,
                    });
                }
            }
        }
        (!two_limits.is_empty()).then_some(StaticFriction(two_limits))
    }

    /// Takes the limit of a contact at the end of a step.
    pub(crate) fn limit<const L: usize>(&mut self, contact: usize, limit: Lane<L>) {
        for limits in self.0.iter_mut().filter(|limits| limits.contact == contact) {
            let limit = limit.0[limits.lane];
            limits.mean = 0.5 * (limits.limit + limit);
            limits.limit = limit;
        }
    }

    /// The contacts, at the start of a step.
    pub(crate) fn all(&mut self) -> &mut [TwoLimits] {
        &mut self.0
    }

    /// Gives the bounds of the contacts of a lane that break loose with these forces at the end of the step; whether there are any.
    pub(crate) fn break_loose(
        &mut self,
        lane: usize,
        force: impl Fn(usize) -> f64,
        mut bound: impl FnMut(usize, [f64; 2]),
    ) -> bool {
        let mut any = false;
        for limits in self.0.iter_mut().filter(|limits| limits.lane == lane) {
            if let Some(bounds) = limits.breaks(force(limits.contact)) {
                bound(limits.contact, bounds);
                any = true;
            }
        }
        any
    }

    /// The kinetic limit of a contact, in the lanes where it has two.
    pub(crate) fn show<const L: usize>(&self, contact: usize, limit: &mut Lane<L>) {
        for limits in self.0.iter().filter(|limits| limits.contact == contact) {
            limit.0[limits.lane] = limits.limit;
        }
    }

    /// The part of the static limit that a contact has used, 1 if it slides, in the lanes where it has two limits.
    pub(crate) fn show_share<const L: usize>(&self, contact: usize, share: &mut Lane<L>) {
        for limits in self.0.iter().filter(|limits| limits.contact == contact) {
            let l = limits.lane;
            share.0[l] = match limits.kinetic {
                [false, false] => share.0[l] / limits.ratio,
                _ => 1.0,
            };
        }
    }

    /// The mean force of a contact over a step that ended with `force`, in the lanes where it has two limits.
    pub(crate) fn show_mean<const L: usize>(
        &self,
        contact: usize,
        force: Lane<L>,
        mean: &mut Lane<L>,
    ) {
        for limits in self.0.iter().filter(|limits| limits.contact == contact) {
            mean.0[limits.lane] = force.0[limits.lane];
        }
    }
}

/// Takes new bounds of the force of a contact.
pub(crate) type Bound<'a> = dyn FnMut(usize, [f64; 2]) + 'a;

/// The bounds of contacts of a lane that break loose with these forces, if there are any.
pub(crate) fn breaks(
    friction: &mut Option<StaticFriction>,
    lane: usize,
) -> impl FnMut(&[f64], &mut Bound) -> bool {
    move |forces, bound| match friction {
        Some(friction) => friction.break_loose(lane, |c| forces[c], bound),
        None => false,
    }
}

impl TwoLimits {
    /// Starts a step: S is its force at the end, or the mean with this one at the start. The bounds of the force at the end.
    pub(crate) fn begin(&mut self, start: Option<f64>) -> [f64; 2] {
        self.start = start;
        self.bounds()
    }

    /// The interval of S.
    fn interval(&self) -> [f64; 2] {
        let limit = |kinetic| match kinetic {
            true => self.mean,
            false => self.ratio * self.mean,
        };
        let [low, high] = self.kinetic.map(limit);
        [-low, high]
    }

    fn bounds(&self) -> [f64; 2] {
        let interval = self.interval();
        match self.start {
            Some(start) => interval.map(|bound| 2.0 * bound - start),
            None => interval,
        }
    }

    /// Whether this force at the end of the step is at the lower bound, and at the upper one.
    fn at(&self, force: f64) -> [bool; 2] {
        let [low, high] = self.bounds();
        let near = ROUND_OFF * (low.abs() + high.abs());
        [force <= low + near, force >= high - near]
    }

    /// The new bounds if this force at the end of the step is at a static end: the contact breaks loose.
    pub(crate) fn breaks(&mut self, force: f64) -> Option<[f64; 2]> {
        let at = self.at(force);
        let breaks = (0..2).any(|end| at[end] && !self.kinetic[end]);
        for (kinetic, at) in self.kinetic.iter_mut().zip(at) {
            *kinetic |= at;
        }
        breaks.then(|| self.bounds())
    }

    /// Ends a step with this force at its end; returns S.
    pub(crate) fn end(&mut self, force: f64) -> f64 {
        let [least, most] = self.interval();
        self.kinetic = self.at(force);
        self.mean = self.limit;
        match (self.kinetic, self.start) {
            ([true, _], _) => least,
            ([_, true], _) => most,
            (_, Some(start)) => 0.5 * (start + force),
            (_, None) => force,
        }
    }
}

/// The first contact with two limits that a method or a structure cannot have: its index, and why.
pub fn static_ratio_fault(structure: &Structure, method: &Method) -> Option<(usize, String)> {
    let massless = structure.massless();
    let mut contacts = structure.contacts.iter().enumerate();
    contacts.find_map(|(i, contact)| {
        if contact.law.static_ratio() == 1.0 {
            return None;
        }
        let has_static = matches!(method, Method::AverageAcceleration(_)) || method.has_impulses();
        let has_massless = || structure.column(i).any(|(node, _)| massless[node]);
        let why = match has_static {
            false => {
                "static_ratio above 1: the force of a contact that sticks alternates from step to step in this method, and would break it loose; allowed: average-acceleration or moreau-jean"
            }
            true if has_massless() => {
                "static_ratio above 1 needs nodes with mass: the force at a node without mass jumps; give it a mass"
            }
            true => return None,
        };
        Some((i, why.into()))
    })
}
