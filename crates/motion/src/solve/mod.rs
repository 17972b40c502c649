//! Solving: integration of systems in time, one at a time or several together. Written once for all problems.

mod loops;
mod metric_table;
pub mod single_pass;
pub mod structure;
pub mod sweep;
mod track;
mod unsolvable;
pub mod visited;
mod warning;

use crate::contact::{AnyRunningLaw, ContactLaw};
use crate::lane::Lane;
use crate::methods::{ManyModes, Method, ModeCount, ModeStart, Recursion, Scheme, Start};
use crate::system::System;
pub use loops::{EachMethod, Loops, OneLoop, Steps};
pub use metric_table::MetricTable;
use std::cell::Cell;
pub use track::{ContactTrack, Displacements, Track};
pub use unsolvable::Unsolvable;
pub use visited::{flexibilities, visit};
pub use warning::{FEWEST_STEPS, TOO_FEW_STEPS, WARNINGS, Warning, Warnings};

/// The motion of L cases.
#[derive(Debug, Clone)]
pub struct Motion<const L: usize, T> {
    /// The contact at all steps.
    pub track: T,
    /// Relative displacement, velocity and force of the contact at the last step of each case.
    pub end: [Lane<L>; 3],
    /// Velocity of the first mode at the last step of each case.
    pub first_mode: Lane<L>,
    /// What the contact and the method took from the energy of the modes; `None` for a method in which the contact takes all.
    pub taken: Option<EnergyLosses<L>>,
}

/// What a run took from the energy of the modes, up to the last step of each case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EnergyLosses<const L: usize> {
    /// Work on the contact.
    pub by_contact: Lane<L>,
    /// Numerical dissipation of the method; below 0 where it adds energy.
    pub by_method: Lane<L>,
}

impl<const L: usize, T: Default> Default for Motion<L, T> {
    fn default() -> Self {
        Motion {
            track: T::default(),
            end: [Lane::splat(0.0); 3],
            first_mode: Lane::splat(0.0),
            taken: None,
        }
    }
}

/// A description of a system.
pub trait ToSystem: Copy {
    /// The methods that such systems have: one, or [`Method`] for any.
    type Methods: EachMethod;

    /// The system.
    fn system(&self) -> System;
}

impl ToSystem for System {
    type Methods = Method;

    fn system(&self) -> System {
        *self
    }
}

/// L systems at t = 0 with equal numbers of modes, and their laws over the run; `None` without a mode. All laws have the kind,
/// and all methods the scheme of the first one.
///
/// The motion is that of the modes. That of a contact without mass follows from it, see [`System::at_contact`].
pub fn start<const L: usize, N: Recursion<L>, S: ToSystem>(
    cases: &[S; L],
) -> Option<(N, AnyRunningLaw<L>)> {
    let stepper: N = stepper(cases)?;
    let law = running_law(cases, &stepper);
    Some((stepper, law))
}

/// One number of each system.
// Arrays are filled by loops: with more than 16 lanes, maps of arrays are not inlined.
#[inline(always)]
pub(super) fn of<const L: usize, S: ToSystem>(
    cases: &[S; L],
    number: fn(&System) -> f64,
) -> Lane<L> {
    let mut lane = Lane::splat(0.0);
    for (x, case) in lane.0.iter_mut().zip(cases) {
        *x = number(&case.system());
    }
    lane
}

/// The systems at t = 0; `None` without a mode.
pub(super) fn stepper<const L: usize, N: Recursion<L>, S: ToSystem>(cases: &[S; L]) -> Option<N> {
    let first = cases[0].system();
    let mut same = [true; L];
    for (same, case) in same.iter_mut().zip(cases) {
        *same = case.system().linear == first.linear;
    }
    // A mode of a bar needs sines, as much time as some steps. Most cases of a sweep have the same modes.
    let modes = (0..first.linear.len()).map(|j| {
        let shared = first.linear.mode(j);
        let mut start = ModeStart {
            mode: [shared.mode; L],
            displacement: Lane::splat(shared.displacement),
            velocity: Lane::splat(shared.velocity),
        };
        for l in 0..L {
            if !same[l] {
                let mode_start = cases[l].system().linear.mode(j);
                start.mode[l] = mode_start.mode;
                start.displacement.0[l] = mode_start.displacement;
                start.velocity.0[l] = mode_start.velocity;
            }
        }
        start
    });
    let mut method = [first.method; L];
    if !matches!(first.method, Method::AverageAcceleration(_)) {
        for (l, case) in cases.iter().enumerate() {
            method[l] = case.system().method;
        }
    }
    let start = Start {
        method,
        dt: of(cases, |s| s.step),
        gap: of(cases, |s| s.gap),
        force: of(cases, |s| s.force),
    };
    N::new(&start, modes)
}

/// The laws of the systems over the run.
// A function of its own: the law is large, and a tuple of it and the stepper would be copied.
fn running_law<const L: usize, N: Recursion<L>, S: ToSystem>(
    cases: &[S; L],
    stepper: &N,
) -> AnyRunningLaw<L> {
    let mut laws = [cases[0].system().law; L];
    for (law, case) in laws.iter_mut().zip(cases) {
        *law = case.system().law;
    }
    let mut on = stepper.flexibilities();
    for part in &mut on {
        // Without the compliance c0 the modes move to r(i+1) + c0 S(i+1).
        part.end.h = part.end.h + of(cases, |s| s.linear.contact_compliance());
    }
    ContactLaw::running(&laws, &on)
}

/// Integrates L systems with equal numbers of modes, laws of one kind and methods of one scheme, to their last steps. Returns for each
/// whether its motion is finite.
pub fn advance<const L: usize, M: ModeCount, T: Track<L>, P: Loops<L>, S: ToSystem>(
    cases: &[S; L],
    motion: &mut Motion<L, T>,
) -> [bool; L] {
    S::Methods::advance::<L, M, T, P, S>(cases, motion)
}

/// The same with one method.
fn advance_by<const L: usize, N: Recursion<L>, T: Track<L>, P: Loops<L>, S: ToSystem>(
    cases: &[S; L],
    motion: &mut Motion<L, T>,
) -> [bool; L] {
    let Some(mut stepper) = stepper::<L, N, S>(cases) else {
        return [false; L];
    };
    let mut law = running_law(cases, &stepper);
    let mut last = [0; L];
    for (last, case) in last.iter_mut().zip(cases) {
        *last = case.system().last;
    }
    let longest = last.iter().copied().max().unwrap_or(0) as usize;
    let track = &mut motion.track;
    track.resize(longest + 1);
    if let Some(row) = track.rows(0, 1).next() {
        T::write(row, &stepper.contact());
    }
    let zero = Lane::splat(0.0);
    let (mut first_mode, mut from) = (zero, 1);
    let work = Cell::new(zero);
    let (mut by_contact, mut energy) = (zero, zero);
    let end = stepper.run(
        &last,
        |stepper, steps| {
            let mut sum = work.get();
            let next = Steps::new(stepper, track, &mut sum, from..from + steps);
            P::step(&mut law, next);
            work.set(sum);
            from += steps;
        },
        |stepper, ending| {
            let velocity = stepper.first_velocity().unwrap_or(zero);
            first_mode = ending.select(velocity, first_mode);
            if !N::Scheme::CONSERVES {
                by_contact = ending.select(work.get(), by_contact);
                energy = ending.select(modal_energy(cases, stepper), energy);
            }
        },
    );
    motion.first_mode = first_mode;
    motion.end = [end.displacement, end.velocity, end.force];
    motion.taken = (!N::Scheme::CONSERVES).then(|| {
        let mut by_method = -energy - by_contact;
        for (taken, case) in by_method.0.iter_mut().zip(cases) {
            *taken += case.system().linear.energy();
        }
        EnergyLosses {
            by_contact,
            by_method,
        }
    });
    end.finite()
}

/// Kinetic and strain energy of the modes.
fn modal_energy<const L: usize, N: Recursion<L>, S: ToSystem>(
    cases: &[S; L],
    stepper: &N,
) -> Lane<L> {
    let mut energy = Lane::splat(0.0);
    for (j, (x, v)) in stepper.modes().enumerate() {
        for (l, case) in cases.iter().enumerate() {
            let mode = case.system().linear.mode(j).mode;
            energy.0[l] += mode.energy(x.0[l], v.0[l]);
        }
    }
    energy
}

/// Integrates one system to its last step.
///
/// # Errors
/// [`Unsolvable::OutOfRange`] if the motion does not remain finite.
pub fn run<T: Track<1>>(system: &System) -> Result<Motion<1, T>, Unsolvable> {
    let mut motion = Motion::default();
    match advance::<1, ManyModes, T, OneLoop, _>(&[*system], &mut motion) {
        [true] => Ok(motion),
        [false] => Err(Unsolvable::OutOfRange),
    }
}
