//! Storage of the modes of a structure.

use crate::lane::Lane;

/// A list, or an array of one, which the compiler keeps in registers.
pub trait Storage<T>: AsRef<[T]> + AsMut<[T]> + Clone {
    /// Stores the modes; `None` without a mode.
    fn collect(modes: impl Iterator<Item = T>) -> Option<Self>;

    /// Moves the modes out, without a copy of a list.
    fn take(&mut self) -> Self;
}

impl<T: Clone> Storage<T> for Vec<T> {
    fn collect(modes: impl Iterator<Item = T>) -> Option<Self> {
        let modes: Vec<T> = Iterator::collect(modes);
        (!modes.is_empty()).then_some(modes)
    }

    fn take(&mut self) -> Self {
        std::mem::take(self)
    }
}

impl<T: Copy> Storage<T> for [T; 1] {
    #[inline(always)]
    fn collect(mut modes: impl Iterator<Item = T>) -> Option<Self> {
        modes.next().map(|mode| [mode])
    }

    #[inline(always)]
    fn take(&mut self) -> Self {
        *self
    }
}

/// How many modes structures have, which decides how they are stored.
pub trait ModeCount {
    /// Storage of the modes.
    type Of<T: Copy>: Storage<T>;
}

/// Any number of modes.
#[derive(Debug, Clone, Copy)]
pub struct ManyModes;

impl ModeCount for ManyModes {
    type Of<T: Copy> = Vec<T>;
}

/// One mode.
#[derive(Debug, Clone, Copy)]
pub struct OneMode;

impl ModeCount for OneMode {
    type Of<T: Copy> = [T; 1];
}

/// N sums over all modes, of the numbers that `of` gives for a mode. From the first term on, so that the sum over one mode is
/// that mode.
#[inline(always)]
pub(in crate::methods) fn sums<T, const L: usize, const N: usize>(
    modes: &mut [T],
    mut of: impl FnMut(&mut T) -> [Lane<L>; N],
) -> [Lane<L>; N] {
    let [first, others @ ..] = modes else {
        return [Lane::splat(0.0); N];
    };
    let mut sums = of(first);
    for mode in others {
        let terms = of(mode);
        for (sum, term) in sums.iter_mut().zip(terms) {
            *sum = *sum + term;
        }
    }
    sums
}
