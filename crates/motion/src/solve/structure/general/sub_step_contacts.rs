//! The contacts of a structure over a sub-step.

use crate::contact::ClippedLine;
use crate::lane::Lane;
use crate::methods::{Method, SubStep};
use crate::solve::structure::start::initial::bounds_at_start;
use crate::system::structure::{Contact, Structure, StructureLaw};

/// A contact of L structures.
#[derive(Debug, Clone, Copy)]
pub(super) struct LaneContact<const L: usize> {
    pub(super) gap: Lane<L>,
    /// The bounds of S.
    pub(super) bounds: [Lane<L>; 2],
    /// S/k is what r contains of the deflection of a spring; 0 for laws without one.
    pub(super) softness: Lane<L>,
    /// S/k^C of the displacement-control model.
    pub(super) by_force: Lane<L>,
    /// Whether it is a rigid stop that impulses act on.
    pub(super) stop: [bool; L],
    /// Whether it is a rigid stop or Coulomb friction that impulses act on.
    pub(super) by_impulse: [bool; L],
    /// Whether its work is that of S' on the mean velocity.
    pub(super) by_velocity: [bool; L],
    /// Whether the law gives S' before r' is known.
    pub(super) known: [bool; L],
    /// B^T (u* - u), and B^T v*, both without the forces of this sub-step but with everything else.
    pub(super) change: Lane<L>,
    pub(super) rate: Lane<L>,
    /// The size of the terms of d.
    pub(super) size: Lane<L>,
}

/// A law over a sub-step as a clipped line S' = clip(d/g, low, high) with
/// d = by_displacement r + by_change (r* - r) + by_rate rdot* + by_force S + by_bounce rdot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Line<T> {
    /// g.
    pub(super) compliance: T,
    pub(super) by_displacement: T,
    pub(super) by_change: T,
    pub(super) by_rate: T,
    pub(super) by_force: T,
    pub(super) by_bounce: T,
}

/// A line in every lane.
pub(super) type LaneLine<const L: usize> = Line<Lane<L>>;

impl Line<f64> {
    /// The law of a contact at a node without mass, whose rdot' is (r' - r)/h.
    pub(super) fn without_mass(
        law: &StructureLaw,
        sub_step: &SubStep,
        impulses: bool,
    ) -> Line<f64> {
        let line = Line::new(law, sub_step, impulses);
        match law.line() {
            Some(ClippedLine::Viscous { viscosity }) => Line {
                compliance: sub_step.length / viscosity,
                by_change: 1.0,
                by_rate: 0.0,
                ..line
            },
            Some(ClippedLine::Coulomb) => Line {
                by_change: 1.0,
                by_rate: 0.0,
                ..line
            },
            _ => line,
        }
    }

    pub(super) fn new(law: &StructureLaw, sub_step: &SubStep, impulses: bool) -> Line<f64> {
        let none = Line {
            compliance: 0.0,
            by_displacement: 0.0,
            by_change: 0.0,
            by_rate: 0.0,
            by_force: 0.0,
            by_bounce: 0.0,
        };
        let of_velocity = sub_step.of_velocity();
        let impact = |compliance| Line {
            compliance,
            by_displacement: 1.0,
            by_change: 1.0,
            ..none
        };
        match law.line() {
            Some(ClippedLine::Spring { stiffness }) => impact(1.0 / stiffness),
            // rdot' = -e rdot while S' < 0.
            Some(ClippedLine::Stop { restitution }) if impulses => Line {
                by_rate: of_velocity,
                by_bounce: of_velocity * restitution,
                ..none
            },
            Some(ClippedLine::Stop { .. }) => impact(0.0),
            // S' = S + k^C (r' - r).
            Some(ClippedLine::Elastic { stiffness }) => Line {
                compliance: 1.0 / stiffness,
                by_change: 1.0,
                by_force: 1.0 / stiffness,
                ..none
            },
            Some(ClippedLine::Viscous { viscosity }) => Line {
                compliance: of_velocity / viscosity,
                by_rate: of_velocity,
                ..none
            },
            Some(ClippedLine::Coulomb) => Line {
                by_rate: of_velocity,
                ..none
            },
            // Not a line; its lanes have forces of their own.
            None => impact(1.0),
        }
    }
}

/// A number of every structure.
pub(super) fn lanes<const L: usize>(
    cases: &[&Structure; L],
    number: impl Fn(&Structure) -> f64,
) -> Lane<L> {
    let mut lane = Lane::splat(0.0);
    for (x, case) in lane.0.iter_mut().zip(cases) {
        *x = number(case);
    }
    lane
}

impl<const L: usize> LaneLine<L> {
    /// The line of contact `c`.
    pub(super) fn of(
        cases: &[&Structure; L],
        c: usize,
        sub_step: &SubStep,
        impulses: bool,
        massless: bool,
    ) -> LaneLine<L> {
        let line = match massless {
            false => Line::new,
            true => Line::without_mass,
        };
        let of = |number: fn(&Line<f64>) -> f64| {
            lanes(cases, |case| {
                number(&line(&case.contacts[c].law, sub_step, impulses))
            })
        };
        Line {
            compliance: of(|line| line.compliance),
            by_displacement: of(|line| line.by_displacement),
            by_change: of(|line| line.by_change),
            by_rate: of(|line| line.by_rate),
            by_force: of(|line| line.by_force),
            by_bounce: of(|line| line.by_bounce),
        }
    }
}

impl<const L: usize> LaneContact<L> {
    /// Contact `c` at t = 0.
    pub(super) fn new(
        cases: &[&Structure; L],
        c: usize,
        explicit: bool,
        method: &Method,
    ) -> LaneContact<L> {
        let (impulses, at_end) = (method.has_impulses(), method.has_force_at_end());
        let zero = Lane::splat(0.0);
        let of = |number: fn(&Contact) -> f64| lanes(cases, |case| number(&case.contacts[c]));
        let is =
            |rule: &dyn Fn(&StructureLaw) -> bool| cases.map(|case| rule(&case.contacts[c].law));
        let rigid = |law: &StructureLaw| law.line().is_some_and(ClippedLine::is_rigid);
        LaneContact {
            gap: of(|contact| contact.gap),
            bounds: [0, 1].map(|side| lanes(cases, |case| bounds_at_start(case, c)[side])),
            softness: of(|contact| softness(&contact.law)),
            by_force: of(|contact| match contact.law.line() {
                Some(ClippedLine::Elastic { .. }) => softness(&contact.law),
                _ => 0.0,
            }),
            stop: is(&|law| impulses && law.is_stop()),
            by_impulse: is(&|law| impulses && rigid(law)),
            by_velocity: is(&|law| at_end && rigid(law)),
            known: is(&|law| explicit && law.spring().is_some()),
            change: zero,
            rate: zero,
            size: zero,
        }
    }
}

impl<const L: usize> LaneContact<L> {
    /// Changes the bounds of a lane.
    pub(super) fn bound_lane(&mut self, l: usize, bounds: [f64; 2]) {
        for (bound, new) in self.bounds.iter_mut().zip(bounds) {
            bound.0[l] = new;
        }
    }
}

/// 1/k of the spring of a law; 0 without one.
fn softness(law: &StructureLaw) -> f64 {
    law.spring().map_or(0.0, |stiffness| 1.0 / stiffness)
}
