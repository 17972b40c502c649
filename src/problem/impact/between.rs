//! What stands between the exact solution of an impact and the computed one.

use super::scaled::Scaled;
use crate::exact::chain::Chain;
use crate::exact::spring::Spring;
use crate::history::History;

/// Most elements of a bar: the chain's modes take memory and time with the square of their number.
const MOST_ELEMENTS: u32 = 1000;

/// The bars on their spring as continua, and the chain of elements in continuous time, at rising times.
///
/// `None` for a wall, for bars that differ, for gamma n < 0.404 (see [`Spring::new`]), for more than 1000 elements, for
/// gamma n^2 > 10^20 (see [`Chain::new`]), and for a contact that chatters without end.
pub fn between(scaled: &Scaled, times: &[f64]) -> Option<[History; 2]> {
    let equal = scaled.right == Some(scaled.left);
    if !equal || scaled.left.elements > MOST_ELEMENTS {
        return None;
    }
    let gap = scaled.bars.gap;
    let continuum = Spring::new(0.5 * scaled.spring, gap)?;
    let mut elements = Chain::new(&scaled.left, scaled.spring, gap)?;
    let mut spring = History::with_capacity(times.len());
    let mut chain = History::with_capacity(times.len());
    for &time in times {
        let state = continuum.at(time);
        spring.push(time, state.displacement, state.velocity, state.force);
        let state = elements.at(time)?;
        chain.push(time, state.displacement, state.velocity, state.force);
    }
    Some([spring, chain])
}
