//! Records of the steps.

use crate::lane::Lane;
use crate::methods::ContactState;

/// A record of the steps of L cases.
pub trait Track<const L: usize>: Default {
    /// The values of one step.
    type Row<'a>
    where
        Self: 'a;

    /// Makes room for `len` steps.
    fn resize(&mut self, len: usize);

    /// The values of `count` steps from `first` on.
    fn rows(&mut self, first: usize, count: usize) -> impl Iterator<Item = Self::Row<'_>>;

    /// Records a step.
    fn write(row: Self::Row<'_>, contact: &ContactState<L>);
}

/// The relative displacement alone.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Displacements<const L: usize>(pub Vec<Lane<L>>);

impl<const L: usize> Track<L> for Displacements<L> {
    type Row<'a> = &'a mut Lane<L>;

    fn resize(&mut self, len: usize) {
        self.0.resize(len, Lane::splat(0.0));
    }

    #[inline(always)]
    fn rows(&mut self, first: usize, count: usize) -> impl Iterator<Item = &mut Lane<L>> {
        self.0[first..first + count].iter_mut()
    }

    #[inline(always)]
    fn write(row: &mut Lane<L>, contact: &ContactState<L>) {
        *row = contact.displacement;
    }
}

/// r, rdot and S of the contact, step by step.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ContactTrack(pub Vec<[f64; 3]>);

impl Track<1> for ContactTrack {
    type Row<'a> = &'a mut [f64; 3];

    fn resize(&mut self, len: usize) {
        self.0.resize(len, [0.0; 3]);
    }

    fn rows(&mut self, first: usize, count: usize) -> impl Iterator<Item = &mut [f64; 3]> {
        self.0[first..first + count].iter_mut()
    }

    fn write(row: &mut [f64; 3], contact: &ContactState<1>) {
        let ContactState {
            displacement: Lane([r]),
            velocity: Lane([v]),
            force: Lane([s]),
        } = *contact;
        *row = [r, v, s];
    }
}
