//! Solving: integration of systems in time, one at a time or several together. Written once for all problems.

pub mod once;
pub mod structure;
pub mod sweep;
mod table;
mod track;
mod unsolvable;

pub use table::MetricTable;
pub use track::{ContactTrack, Displacements, Track};
pub use unsolvable::Unsolvable;

use crate::contact::{AnyStep, ContactLaw, StepLaw, Visitor};
use crate::lane::Lane;
use crate::methods::average_acceleration::{AverageAcceleration, ModeStart, Modes};
use crate::system::System;
use multiversion::multiversion;

/// The motion of L cases.
#[derive(Debug, Clone)]
pub struct Motion<const L: usize, T> {
    /// The contact at all steps.
    pub track: T,
    /// Relative displacement, velocity and force of the contact at the last step of each case.
    pub end: [Lane<L>; 3],
    /// Velocity of the first mode at the last step of each case.
    pub first_mode: Lane<L>,
}

impl<const L: usize, T: Default> Default for Motion<L, T> {
    fn default() -> Self {
        Motion {
            track: T::default(),
            end: [Lane::splat(0.0); 3],
            first_mode: Lane::splat(0.0),
        }
    }
}

/// A description of a system.
pub trait ToSystem: Copy {
    /// The system.
    fn system(&self) -> System;
}

impl ToSystem for System {
    fn system(&self) -> System {
        *self
    }
}

/// L systems at t = 0 with equal numbers of modes, and their laws over a step; `None` without a mode. All laws have the kind of
/// the first one.
///
/// The motion is that of the modes. That of a contact without mass follows from it, see [`System::at_contact`].
// Arrays are filled by loops: with more than 16 lanes, maps of arrays are not inlined.
pub fn start<const L: usize, M: Modes<L>, S: ToSystem>(
    cases: &[S; L],
) -> Option<(AverageAcceleration<L, M>, AnyStep<L>)> {
    let of = |number: fn(&System) -> f64| {
        let mut lane = Lane::splat(0.0);
        for (x, case) in lane.0.iter_mut().zip(cases) {
            *x = number(&case.system());
        }
        lane
    };
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
                let own = cases[l].system().linear.mode(j);
                start.mode[l] = own.mode;
                start.displacement.0[l] = own.displacement;
                start.velocity.0[l] = own.velocity;
            }
        }
        start
    });
    let stepper = AverageAcceleration::new(of(|s| s.step), modes, of(|s| s.gap), of(|s| s.force))?;
    let mut laws = [first.law; L];
    for (law, case) in laws.iter_mut().zip(cases) {
        *law = case.system().law;
    }
    // Without the compliance c0 the modes move to r(i+1) + c0 S(i+1).
    let mut on = stepper.flexibility();
    on.end.h = on.end.h + of(|s| s.linear.contact_compliance());
    let law = ContactLaw::step(&laws, &on);
    Some((stepper, law))
}

/// Integrates L systems with equal numbers of modes and laws of one kind to their last steps. Returns for each whether its motion
/// is finite.
pub fn advance<const L: usize, M: Modes<L>, T: Track<L>, S: ToSystem>(
    cases: &[S; L],
    motion: &mut Motion<L, T>,
) -> [bool; L] {
    let Some((mut stepper, law)) = start::<L, M, S>(cases) else {
        return [false; L];
    };
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
    let (mut first_mode, mut from) = (Lane::splat(0.0), 1);
    let end = stepper.run(
        &last,
        |stepper, steps| {
            law.accept(Steps {
                stepper,
                track,
                from,
                steps,
            });
            from += steps;
        },
        |velocity, ending| first_mode = ending.select(velocity, first_mode),
    );
    motion.first_mode = first_mode;
    motion.end = [end.displacement, end.velocity, end.force];
    end.finite()
}

/// Integrates one system to its last step.
///
/// # Errors
/// [`Unsolvable::OutOfRange`] if the motion does not remain finite.
pub fn run<T: Track<1>>(system: &System) -> Result<Motion<1, T>, Unsolvable> {
    let mut motion = Motion::default();
    match advance::<1, Vec<_>, T, _>(&[*system], &mut motion) {
        [true] => Ok(motion),
        [false] => Err(Unsolvable::OutOfRange),
    }
}

/// The constant average acceleration method for one system.
pub type Stepper = AverageAcceleration<1>;

/// Integrates one system to its last step; `visit` gets the number of each step, from 0 on, and the state of the structure.
pub fn visit(system: &System, mut visit: impl FnMut(u64, &Stepper)) {
    let Some((mut stepper, law)) = start::<1, Vec<_>, _>(&[*system]) else {
        return;
    };
    visit(0, &stepper);
    for step in 1..=system.last {
        stepper.step(&law);
        visit(step, &stepper);
    }
}

/// Some steps, recorded from row `from` on.
struct Steps<'a, const L: usize, M, T> {
    stepper: &'a mut AverageAcceleration<L, M>,
    track: &'a mut T,
    from: usize,
    steps: usize,
}

impl<const L: usize, M: Modes<L>, T: Track<L>> Visitor<L> for Steps<'_, L, M, T> {
    fn visit(self, law: &impl StepLaw<L>) {
        step_all::<L, M, T, _>(self.stepper, *law, self.track, self.from, self.steps);
    }
}

// A separate small function: with other code around it, its loop compiles to slower instructions.
#[multiversion(targets("x86_64+avx512f+avx512bw+avx512cd+avx512dq+avx512vl", "x86_64+avx2"))]
fn step_all<const L: usize, M: Modes<L>, T: Track<L>, W: StepLaw<L>>(
    stepper: &mut AverageAcceleration<L, M>,
    law: W,
    track: &mut T,
    from: usize,
    steps: usize,
) {
    let mut own = stepper.take();
    for row in track.rows(from, steps) {
        T::write(row, &own.step(&law));
    }
    *stepper = own;
}
