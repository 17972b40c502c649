//! Several cases side by side: L numbers that go through the same operations, with the same bits for every L.

use std::array;
use std::ops::{Add, Mul, Neg, Sub};

/// One number for each of L cases.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lane<const L: usize>(pub [f64; L]);

impl<const L: usize> Lane<L> {
    /// The same number in every lane.
    pub fn splat(x: f64) -> Self {
        Lane([x; L])
    }

    /// `f` of every lane.
    #[inline(always)]
    pub fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Lane(array::from_fn(|l| f(self.0[l])))
    }

    /// `f` of every pair of lanes.
    #[inline(always)]
    pub fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Lane(array::from_fn(|l| f(self.0[l], other.0[l])))
    }

    /// Cut to -limit..=limit, by comparisons alone (they compile to one instruction each; f64::min does not).
    #[inline(always)]
    pub fn cut(self, limit: Self) -> Self {
        self.zip(limit, |x, m| if x > m { m } else { x })
            .zip(limit, |x, m| if x < -m { -m } else { x })
    }

    /// In each lane `yes` where `self` was cut by `limit`, else `no`.
    #[inline(always)]
    pub fn where_beyond(self, limit: Self, yes: Self, no: Self) -> Self {
        Lane(array::from_fn(|l| {
            if self.0[l] > limit.0[l] || self.0[l] < -limit.0[l] {
                yes.0[l]
            } else {
                no.0[l]
            }
        }))
    }
}

impl<const L: usize> Add for Lane<L> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
}

impl<const L: usize> Sub for Lane<L> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
}

impl<const L: usize> Mul for Lane<L> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.zip(other, |a, b| a * b)
    }
}

impl<const L: usize> Mul<f64> for Lane<L> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: f64) -> Self {
        self.map(|a| a * factor)
    }
}

impl<const L: usize> Neg for Lane<L> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|a| -a)
    }
}
