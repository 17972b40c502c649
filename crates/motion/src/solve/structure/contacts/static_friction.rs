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
//!
//! At a node without mass S is the force at the end of a step. There a contact that breaks loose slides for no time: a small mass turns
//! the energy of its springs into motion and back, until S has fallen by twice Ls - L. It sticks there, at S = 2 L - Ls. So S has
//! distant bounds, and falls by this as often as it would be beyond Ls.

use super::static_in_plane::{Admissible, Admit, Disc, PlaneLimits, ROUND_OFF};
use crate::contact::plane::Pair;
use crate::lane::Lane;
use crate::system::structure::Structure;

/// Bounds of S over the static limit at a node without mass, before it is known how often the contact breaks loose.
const REACH: f64 = 1e4;

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
    /// Whether a node of the contact has no mass, and S after the contact broke loose in this step.
    is_massless: bool,
    loose: Option<f64>,
}

/// The contacts with two limits of L structures; no item without any.
#[derive(Debug, Clone)]
pub(crate) struct StaticFriction {
    contacts: Vec<TwoLimits>,
    planes: Vec<PlaneLimits>,
}

impl StaticFriction {
    /// `None` if no contact has two limits.
    pub(crate) fn new<const L: usize>(cases: &[&Structure; L]) -> Option<StaticFriction> {
        let (mut two_limits, mut planes) = (Vec::new(), Vec::new());
        for (lane, case) in cases.iter().enumerate() {
            for (contact, given) in case.contacts.iter().enumerate() {
                let ratio = given.law.static_ratio();
                if given.law.row().is_some() {
                    planes.extend(PlaneLimits::new(case, contact, lane));
                } else if ratio > 1.0 {
                    let limit = given.law.limit().map_or(0.0, |limit| limit.at(0.0));
                    let rate = case.rate_at_start(contact);
                    let massless = case.massless();
                    two_limits.push(TwoLimits {
                        contact,
                        lane,
                        ratio,
                        limit,
                        mean: limit,
                        kinetic: [rate < 0.0, rate > 0.0],
                        start: None,
                        is_massless: case.column(contact).any(|(node, _)| massless[node]),
                        loose: None,
                    });
                }
            }
        }
        let has_none = two_limits.is_empty() && planes.is_empty();
        (!has_none).then_some(StaticFriction {
            contacts: two_limits,
            planes,
        })
    }

    /// Takes the limit of a contact at the end of a step.
    pub(crate) fn limit<const L: usize>(&mut self, contact: usize, limit: Lane<L>) {
        let contacts = self.contacts.iter_mut();
        for limits in contacts.filter(|limits| limits.contact == contact) {
            let limit = limit.0[limits.lane];
            limits.mean = 0.5 * (limits.limit + limit);
            limits.limit = limit;
        }
        let planes = self.planes.iter_mut();
        for limits in planes.filter(|limits| limits.first == contact) {
            limits.limit(limit);
        }
    }

    /// The contacts, at the start of a step.
    pub(crate) fn all(&mut self) -> &mut [TwoLimits] {
        &mut self.contacts
    }

    /// The same in a plane.
    pub(crate) fn planes(&mut self) -> &mut [PlaneLimits] {
        &mut self.planes
    }

    /// Gives the bounds of the contacts of a lane that break loose with these forces at the end of the step; whether there are any.
    pub(crate) fn break_loose(
        &mut self,
        lane: usize,
        force: impl Fn(usize) -> f64,
        mut bound: impl FnMut(usize, [f64; 2]),
    ) -> bool {
        let mut any = false;
        let contacts = self.contacts.iter_mut();
        for limits in contacts.filter(|limits| limits.lane == lane) {
            if let Some(bounds) = limits.breaks(force(limits.contact)) {
                bound(limits.contact, bounds);
                any = true;
            }
        }
        any
    }

    /// Changes the discs of contacts in a plane of a lane that these forces change so; whether there are any.
    fn change_discs(
        &mut self,
        lane: usize,
        change: fn(&mut PlaneLimits, Pair) -> Option<Disc>,
        forces: &[f64],
        admit: &mut Admit,
    ) -> bool {
        let mut any = false;
        let planes = self.planes.iter_mut();
        for limits in planes.filter(|limits| limits.lane == lane) {
            let first = limits.first;
            if let Some(disc) = change(limits, [forces[first], forces[first + 1]]) {
                admit(first, Admissible::Disc(disc));
                any = true;
            }
        }
        any
    }

    /// The kinetic limit of a contact, in the lanes where it has two.
    pub(crate) fn show<const L: usize>(&self, contact: usize, limit: &mut Lane<L>) {
        let contacts = self.contacts.iter();
        for limits in contacts.filter(|limits| limits.contact == contact) {
            limit.0[limits.lane] = limits.limit;
        }
        for limits in self.planes.iter().filter(|limits| limits.has(contact)) {
            limit.0[limits.lane] = limits.kinetic();
        }
    }

    /// The part of the static limit that a contact has used, 1 if it slides, in the lanes where it has two limits.
    pub(crate) fn show_share<const L: usize>(&self, contact: usize, share: &mut Lane<L>) {
        let contacts = self.contacts.iter();
        for limits in contacts.filter(|limits| limits.contact == contact) {
            let l = limits.lane;
            share.0[l] = match limits.kinetic {
                [false, false] => share.0[l] / limits.ratio,
                _ => 1.0,
            };
        }
        for limits in self.planes.iter().filter(|limits| limits.has(contact)) {
            let share = &mut share.0[limits.lane];
            *share = limits.share(*share);
        }
    }

    /// The mean force of a contact over a step that ended with `force`, in the lanes where it has two limits.
    pub(crate) fn show_mean<const L: usize>(
        &self,
        contact: usize,
        force: Lane<L>,
        mean: &mut Lane<L>,
    ) {
        let with_mean = |limits: &&TwoLimits| limits.contact == contact && !limits.is_massless;
        for limits in self.contacts.iter().filter(with_mean) {
            mean.0[limits.lane] = force.0[limits.lane];
        }
        for limits in self.planes.iter().filter(|limits| limits.has(contact)) {
            mean.0[limits.lane] = force.0[limits.lane];
        }
    }
}

/// The bounds of contacts of a lane that break loose with these forces, if there are any.
pub(crate) fn breaks(
    friction: &mut Option<StaticFriction>,
    lane: usize,
) -> impl FnMut(&[f64], &mut Admit) -> bool {
    move |forces, admit| {
        let Some(friction) = friction else {
            return false;
        };
        if friction.change_discs(lane, PlaneLimits::turns_back, forces, admit) {
            return true;
        }
        let in_plane = friction.change_discs(lane, PlaneLimits::breaks, forces, admit);
        let between = |c: usize, bounds: [f64; 2]| admit(c, Admissible::Between(bounds));
        friction.break_loose(lane, |c| forces[c], between) || in_plane
    }
}

impl TwoLimits {
    /// Starts a step: S is its force at the end, or the mean with this one at the start. The bounds of the force at the end.
    pub(crate) fn begin(&mut self, start: Option<f64>) -> [f64; 2] {
        self.start = start.filter(|_| !self.is_massless);
        self.loose = None;
        if self.is_massless {
            self.kinetic = [false; 2];
            self.mean = self.limit;
        }
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
        match self.loose {
            Some(force) => return [force; 2],
            None if self.is_massless => {
                return [-REACH, REACH].map(|reach| reach * self.ratio * self.mean);
            }
            None => {}
        }
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
        if self.is_massless {
            return self.falls(force);
        }
        let at = self.at(force);
        let breaks = (0..2).any(|end| at[end] && !self.kinetic[end]);
        for (kinetic, at) in self.kinetic.iter_mut().zip(at) {
            *kinetic |= at;
        }
        breaks.then(|| self.bounds())
    }

    /// The same at a node without mass.
    fn falls(&mut self, force: f64) -> Option<[f64; 2]> {
        let (held, step) = (self.ratio * self.mean, 2.0 * (self.ratio - 1.0) * self.mean);
        let beyond = force.abs() - held;
        if self.loose.is_some() || beyond <= ROUND_OFF * held {
            return None;
        }
        let after = match step > 0.0 {
            true => force.abs() - step * (beyond / step).ceil(),
            false => 0.0,
        };
        self.loose = Some(force.signum() * after);
        Some(self.bounds())
    }

    /// Ends a step with this force at its end; returns S.
    pub(crate) fn end(&mut self, force: f64) -> f64 {
        if self.is_massless {
            return force;
        }
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
