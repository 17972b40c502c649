//! Cases through the stepper, side by side, with the energy and the mass centres on the way.

use super::scaled::Scaled;
use crate::lane::Lane;
use crate::law::ImpactSpring;
use crate::metrics::impact::{Row, Track};
use crate::stepper::{Contact, Start, Stepper};

/// Velocity at which the rigid-body mode closes the gap: c in units of c/2.
pub const CLOSING: f64 = -2.0;

/// The modes of both bars and the spring between them, at t = 0, for cases of as many modes each.
pub fn start<const L: usize>(cases: &[Scaled; L], dt: Lane<L>) -> (Stepper<L>, ImpactSpring<L>) {
    let first = cases[0].modes();
    let modes = cases.each_ref().map(|case| {
        // Sines and all, modes cost as much as some steps; most cases of a sweep share them.
        let same = case.left == cases[0].left && case.right == cases[0].right;
        if same { None } else { Some(case.modes()) }
    });
    let start: Vec<Start<L>> = (0..first.len())
        .map(|j| Start {
            mode: modes
                .each_ref()
                .map(|own| own.as_ref().unwrap_or(&first)[j]),
            displacement: Lane::splat(0.0),
            velocity: Lane::splat(if j == 0 { CLOSING } else { 0.0 }),
        })
        .collect();
    let gap = Lane(cases.each_ref().map(|case| case.bars.gap));
    // Ends that touch at t = 0 do not press yet: r = 0, F = 0.
    let stepper = Stepper::new(dt, &start, gap, Lane::splat(0.0));
    let compliance = Lane(cases.each_ref().map(|case| 1.0 / case.spring));
    let law = ImpactSpring::new(compliance, stepper.flexibility());
    (stepper, law)
}

/// `last` steps of one case.
pub fn run(case: &Scaled, dt: f64, last: u64) -> Track<1> {
    let (mut stepper, law) = start(&[*case], Lane([dt]));
    let mut track = Track::default();
    track.resize(last as usize + 1);
    note(track.rows(0, 1).next(), &stepper.contact());
    walk(&mut stepper, &law, track.rows(1, last as usize));
    if let Some((_, rigid)) = stepper.modes().next() {
        track.restitution = rigid * 0.5;
    }
    track
}

/// A step for each row, and what the contact is then.
#[inline(always)]
pub fn walk<'a, const L: usize>(
    stepper: &mut Stepper<L>,
    law: &ImpactSpring<L>,
    rows: impl Iterator<Item = Row<'a, L>>,
) {
    for row in rows {
        note(Some(row), &stepper.step(law));
    }
}

/// Puts the contact in a row.
#[inline(always)]
pub fn note<const L: usize>(row: Option<Row<L>>, contact: &Contact<L>) {
    let Some([displacement, velocity, force, energy]) = row else {
        return;
    };
    // dr/dt in c T_I/2 over T_I is 2 rdot/c; S resists, so the force that pushes is -S. The spring has S r/2.
    let (r, s) = (contact.displacement, contact.force);
    *displacement = r;
    *velocity = contact.velocity * 0.5;
    *force = Lane::splat(0.0) - s;
    *energy = contact.energy + s * r * 0.5;
}
