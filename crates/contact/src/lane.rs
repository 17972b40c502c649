//! Numbers of several cases that pass through the same operations, with the same bits for every number L of cases.

use std::ops::{Add, Mul, Neg, Sub};

/// One number for each of L cases.
///
/// ```
/// use slipgap_contact::lane::{Lane, largest};
///
/// let x = Lane([3.0, -4.0]);
/// assert_eq!(x * x + Lane::splat(1.0), Lane([10.0, 17.0]));
/// // A law cuts a force to its limit.
/// assert_eq!(x.cut(Lane([5.0, 1.0])), Lane([3.0, -1.0]));
/// assert_eq!(largest(&[x, -x]), Lane([3.0, 4.0]));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lane<const L: usize>(pub [f64; L]);

impl<const L: usize> Default for Lane<L> {
    fn default() -> Self {
        Lane::splat(0.0)
    }
}

impl<const L: usize> Lane<L> {
    /// The same number in every lane.
    #[inline(always)]
    pub fn splat(x: f64) -> Self {
        Lane([x; L])
    }

    /// `f` of every lane.
    // Loops, not array::from_fn: with more than 16 lanes that is not inlined.
    #[inline(always)]
    pub fn map(mut self, f: impl Fn(f64) -> f64) -> Self {
        for x in &mut self.0 {
            *x = f(*x);
        }
        self
    }

    /// `f` of every pair of lanes.
    #[inline(always)]
    pub fn zip(mut self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        for (x, y) in self.0.iter_mut().zip(other.0) {
            *x = f(*x, y);
        }
        self
    }

    /// The larger of two, by a comparison (it compiles to one instruction; f64::max does not).
    #[inline(always)]
    pub fn larger(self, other: Self) -> Self {
        self.zip(other, |x, y| if y > x { y } else { x })
    }

    /// The smaller of two.
    #[inline(always)]
    pub fn smaller(self, other: Self) -> Self {
        self.zip(other, |x, y| if y < x { y } else { x })
    }

    /// Cut to -limit..=limit.
    #[inline(always)]
    pub fn cut(self, limit: Self) -> Self {
        self.smaller(limit).larger(-limit)
    }
}

/// The largest number of each lane; zero if `of` is empty.
#[inline(always)]
pub fn largest<const L: usize>(of: &[Lane<L>]) -> Lane<L> {
    let mut largest = of.first().copied().unwrap_or(Lane::splat(0.0));
    for x in of {
        largest = largest.larger(*x);
    }
    largest
}

/// The smallest number of each lane; zero if `of` is empty.
#[inline(always)]
pub fn smallest<const L: usize>(of: &[Lane<L>]) -> Lane<L> {
    let mut smallest = of.first().copied().unwrap_or(Lane::splat(0.0));
    for x in of {
        smallest = smallest.smaller(*x);
    }
    smallest
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

/// A function that is compiled for several widths of instructions, of which the processor's widest is taken at run time. Builds for
/// tests have one form, since three take three times as long to compile; the arithmetic is the same.
#[macro_export]
macro_rules! for_widest {
    ($($function:tt)*) => {
        #[cfg_attr(
            not(debug_assertions),
            multiversion::multiversion(targets(
                "x86_64+avx512f+avx512bw+avx512cd+avx512dq+avx512vl",
                "x86_64+avx2"
            ))
        )]
        $($function)*
    };
}

/// The same without AVX-512, which makes steps of structures up to 8 % slower and takes a third of their time to compile.
#[macro_export]
macro_rules! for_wide {
    ($($function:tt)*) => {
        #[cfg_attr(
            not(debug_assertions),
            multiversion::multiversion(targets("x86_64+avx2"))
        )]
        $($function)*
    };
}
