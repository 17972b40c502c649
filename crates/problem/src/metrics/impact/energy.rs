//! The energy of bars and spring over a run.

use super::Track;
use crate::contact::StoredEnergy;
use crate::lane::Lane;
use crate::methods::ContactWork;
use crate::solve::ToSystem;
use crate::system::System;

/// Energy with the spring, in the frame of the common mass centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Energy<const L: usize> {
    /// At t = 0.
    pub start: Lane<L>,
    /// Smallest at a step.
    pub smallest: Lane<L>,
    /// Largest at a step.
    pub largest: Lane<L>,
    /// At the last step.
    pub last: Lane<L>,
}

impl<const L: usize> Energy<L> {
    fn new(start: Lane<L>) -> Self {
        Energy {
            start,
            smallest: start,
            largest: start,
            last: start,
        }
    }

    #[inline(always)]
    fn update(&mut self, energy: Lane<L>) {
        self.smallest = self.smallest.smaller(energy);
        self.largest = self.largest.larger(energy);
        self.last = energy;
    }
}

impl Energy<1> {
    /// From the work of the contact of a case, see [`energy_of_books`].
    pub fn of_case(track: &Track<1>, system: &System, count: usize) -> Energy<1> {
        let start = Lane([system.linear.energy()]);
        let law = &system.law;
        let books = |Lane([r]): Lane<1>, Lane([s]): Lane<1>| {
            let [stored, force] = [law.stored_energy(r, s), law.conservative_force(r, s)];
            [Lane([stored]), Lane([force])]
        };
        energy_of_books(track, start, &step_work(&[*system]), books, count)
    }

    /// From the energies at the steps; there must be at least one.
    pub fn of(steps: &[f64]) -> Energy<1> {
        let mut energy = Energy::new(Lane([steps.first().copied().unwrap_or(f64::NAN)]));
        for step in steps {
            energy.update(Lane([*step]));
        }
        energy
    }
}

/// The energy over the first `count` steps from the force and the displacement of the contact alone; `start` is the energy of
/// the bars at t = 0. What a damped contact or a method dissipates is left in it, so that it changes by errors only.
///
/// Constant average acceleration satisfies E(i+1) - E(i) = -(S(i) + S(i+1))/2 (r(i+1) - r(i)) exactly for the bars (reference:
/// section 5); other methods have other forms of [`ContactWork`]. `books` gives the energy that the contacts store at r under S, and the part of S that does its work on it; S = -F.
/// The sum changes only in steps in which the contact opens or closes, and with a spring that is not linear.
#[inline(always)]
pub fn energy_of_books<const L: usize>(
    track: &Track<L>,
    start: Lane<L>,
    work: &ContactWork<L>,
    books: impl Fn(Lane<L>, Lane<L>) -> [Lane<L>; 2],
    count: usize,
) -> Energy<L> {
    // A loop for each form: most runs are by trapezoids.
    match work {
        ContactWork::Trapezoids => sum(track, start, ContactWork::Trapezoids, books, count),
        ContactWork::Impulses(dt) => sum(track, start, ContactWork::Impulses(*dt), books, count),
    }
}

#[inline(always)]
fn sum<const L: usize>(
    track: &Track<L>,
    start: Lane<L>,
    work: ContactWork<L>,
    books: impl Fn(Lane<L>, Lane<L>) -> [Lane<L>; 2],
    count: usize,
) -> Energy<L> {
    let (r, force) = (&track.displacement[..count], &track.force[..count]);
    let (Some(r0), Some(f0)) = (r.first(), force.first()) else {
        return Energy::new(start);
    };
    let rdot = &track.velocity[..count];
    let mut r_before = *r0;
    let [stored, mut s_before] = books(*r0, -*f0);
    let mut bars = start;
    let mut energy = Energy::new(start + stored);
    let steps = r.iter().zip(force).skip(1);
    for ((r, f), rdot) in steps.zip(rdot.windows(2)) {
        let [stored, s] = books(*r, -*f);
        let moved = work.displacement([r_before, *r], rates([rdot[0], rdot[1]]));
        bars = bars - work.force([s_before, s]) * moved;
        energy.update(bars + stored);
        (r_before, s_before) = (*r, s);
    }
    energy
}

/// rdot in c as the rate of r in c T_I/2.
#[inline(always)]
fn rates<const L: usize>(rdot: [Lane<L>; 2]) -> [Lane<L>; 2] {
    [rdot[0] * 2.0, rdot[1] * 2.0]
}

/// The form of the contact's work in a step of systems with methods of one scheme.
pub fn step_work<const L: usize>(systems: &[impl ToSystem; L]) -> ContactWork<L> {
    let at_end = systems[0].system().method.has_force_at_end();
    let mut dt = Lane::splat(0.0);
    // Most runs are by trapezoids, which need no time step.
    if at_end {
        for (dt, system) in dt.0.iter_mut().zip(systems) {
            *dt = system.system().step;
        }
    }
    ContactWork::new(at_end, dt)
}

/// Energy that the damping of the contact of a case takes: the work of the part of S that does none on the stored energy.
pub fn damping_work(track: &Track<1>, system: &System) -> f64 {
    let form = step_work(&[*system]);
    let force =
        |Lane([r]): Lane<1>, Lane([f]): Lane<1>| Lane([-f - system.law.conservative_force(r, -f)]);
    let loop_points = track.displacement.iter().zip(&track.force);
    let states: Vec<[Lane<1>; 3]> = loop_points
        .zip(&track.velocity)
        .map(|((r, f), rdot)| [*r, *rdot, force(*r, *f)])
        .collect();
    let work = |step: &[[Lane<1>; 3]]| {
        let ends = |i: usize| [step[0][i], step[1][i]];
        let Lane([work]) = form.force(ends(2)) * form.displacement(ends(0), rates(ends(1)));
        work
    };
    states.windows(2).map(work).sum()
}
