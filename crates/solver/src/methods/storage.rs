//! Storage of the modes of a method.

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

/// N sums over all modes, of the numbers that `of` gives for a mode. From the first term on, so that the sum over one mode is
/// that mode.
#[inline(always)]
pub(super) fn sums<T, const L: usize, const N: usize>(
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
