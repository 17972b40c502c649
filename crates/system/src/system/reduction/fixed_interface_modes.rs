//! The lowest modes of a structure whose kept degrees of freedom are held.

use super::held::Held;
use super::mode::Mode;
use super::{ReductionFault, dense, lanczos};

/// Most rows with mass whose modes are computed all at once.
const SMALL: usize = 300;

/// Fewest modes that are computed of a large structure.
const FEWEST: usize = 16;

/// Most modes of a large structure.
pub const MOST_MODES: usize = 1000;

/// How many modes are computed at once where `wanted` and the next one are needed, of `all`.
///
/// It depends on nothing else, so that the modes of a case do not depend on other cases.
pub(super) fn stage(wanted: usize, most: usize) -> usize {
    if most <= SMALL || wanted >= most {
        return most;
    }
    let mut stage = FEWEST;
    while stage <= wanted {
        stage *= 2;
    }
    match is_dense(stage, most) {
        true => most,
        false => stage,
    }
}

/// Whether full matrices are faster than a subspace of about twice the number of modes.
fn is_dense(modes: usize, most: usize) -> bool {
    most <= SMALL || 2 * modes + 100 > most
}

/// The first modes in the order of their frequencies, as many as [`stage`] says.
pub(super) fn lowest(of: &Held, stage: usize) -> Result<Vec<Mode>, ReductionFault> {
    match is_dense(stage, of.massive.len()) {
        true => dense::all_modes(of),
        false => lanczos::lowest(of, stage),
    }
}
