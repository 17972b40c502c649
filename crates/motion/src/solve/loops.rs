//! The loops over steps: which of them are compiled.
//!
//! A loop is compiled for each method, law, record and number of lanes that it has, and each of these for several widths of
//! instructions. That is worth its time only for cases that people have by the million.

use super::{Motion, ToSystem, Track, advance_by};
use crate::contact::{AnyRunningLaw, ContactResponse};
use crate::lane::Lane;
use crate::methods::{AverageAcceleration, ContactWork, Method, ModeCount, Recursion, Scheme};
use std::ops::Range;

/// The laws that have a loop of their own.
pub trait Loops<const L: usize> {
    /// Moves by some steps.
    fn step<N: Recursion<L>, T: Track<L>>(law: &mut AnyRunningLaw<L>, steps: Steps<'_, L, N, T>);
}

/// One loop for all laws, by instructions that every processor has: for cases by themselves.
#[derive(Debug)]
pub struct OneLoop;

impl<const L: usize> Loops<L> for OneLoop {
    fn step<N: Recursion<L>, T: Track<L>>(law: &mut AnyRunningLaw<L>, steps: Steps<'_, L, N, T>) {
        steps.by(law);
    }
}

/// The methods for which loops are compiled.
pub trait EachMethod: Copy + Into<Method> {
    /// See [`super::advance`].
    fn advance<const L: usize, M: ModeCount, T: Track<L>, P: Loops<L>, S: ToSystem>(
        cases: &[S; L],
        motion: &mut Motion<L, T>,
    ) -> [bool; L];
}

impl EachMethod for Method {
    fn advance<const L: usize, M: ModeCount, T: Track<L>, P: Loops<L>, S: ToSystem>(
        cases: &[S; L],
        motion: &mut Motion<L, T>,
    ) -> [bool; L] {
        fn of<const L: usize, M: ModeCount, T: Track<L>, P: Loops<L>, S: ToSystem, D: Scheme>(
            _: &D,
            cases: &[S; L],
            motion: &mut Motion<L, T>,
        ) -> [bool; L] {
            advance_by::<L, D::Lanes<L, M>, T, P, S>(cases, motion)
        }
        slipgap_system::each_method!(&cases[0].system().method, method => of::<L, M, T, P, S, _>(method, cases, motion))
    }
}

impl EachMethod for AverageAcceleration {
    fn advance<const L: usize, M: ModeCount, T: Track<L>, P: Loops<L>, S: ToSystem>(
        cases: &[S; L],
        motion: &mut Motion<L, T>,
    ) -> [bool; L] {
        advance_by::<L, <Self as Scheme>::Lanes<L, M>, T, P, S>(cases, motion)
    }
}

/// Steps that are to be computed, with the rows of the track that record them.
#[derive(Debug)]
pub struct Steps<'a, const L: usize, N, T> {
    stepper: &'a mut N,
    track: &'a mut T,
    work: &'a mut Lane<L>,
    rows: Range<usize>,
}

impl<'a, const L: usize, N: Recursion<L>, T: Track<L>> Steps<'a, L, N, T> {
    pub(super) fn new(
        stepper: &'a mut N,
        track: &'a mut T,
        work: &'a mut Lane<L>,
        rows: Range<usize>,
    ) -> Self {
        Steps {
            stepper,
            track,
            work,
            rows,
        }
    }

    /// Computes them with this law.
    pub fn by(self, law: &mut (impl ContactResponse<L> + Copy)) {
        let sum = step_all(self.stepper, law, self.track, self.rows);
        *self.work = *self.work + sum;
    }

    /// The same by the processor's widest instructions.
    pub fn by_widest(self, law: &mut (impl ContactResponse<L> + Copy)) {
        let sum = step_widest::<L, N, T, _>(self.stepper, law, self.track, self.rows);
        *self.work = *self.work + sum;
    }
}

// A separate small function: with other code around it, its loop compiles to slower instructions.
slipgap_contact::for_widest! {
    fn step_widest<const L: usize, N: Recursion<L>, T: Track<L>, W: ContactResponse<L> + Copy>(
        stepper: &mut N,
        law: &mut W,
        track: &mut T,
        rows: Range<usize>,
    ) -> Lane<L> {
        step_all(stepper, law, track, rows)
    }
}

/// Returns the work on the contact, or zero in a method in which it is the energy that the modes lose.
#[inline(always)]
fn step_all<const L: usize, N: Recursion<L>, T: Track<L>, W: ContactResponse<L> + Copy>(
    stepper: &mut N,
    law: &mut W,
    track: &mut T,
    rows: Range<usize>,
) -> Lane<L> {
    let (mut next_stepper, mut own_law) = (stepper.take(), *law);
    let mut work = Lane::splat(0.0);
    let form = ContactWork::new(N::Scheme::FORCE_AT_END, next_stepper.flexibilities()[0].dt);
    for row in track.rows(rows.start, rows.len()) {
        let before = next_stepper.contact();
        let after = next_stepper.step(&mut own_law);
        T::write(row, &after);
        if !N::Scheme::CONSERVES {
            let force = form.force([before.force, after.force]);
            let r = [before.displacement, after.displacement];
            work = work + force * form.displacement(r, [before.velocity, after.velocity]);
        }
    }
    (*stepper, *law) = (next_stepper, own_law);
    work
}
