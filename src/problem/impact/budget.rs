//! The motions between the exact impact and the computed one, for the error budget.

use super::scaled::Scaled;
use crate::exact::chain::Chain;
use crate::exact::spring::Spring;
use crate::history::History;

/// Most elements of a bar: memory and time of the mesh in continuous time grow with the square of their number.
const MOST_ELEMENTS: u32 = 1000;

/// The bars as continua on their spring, and the mesh in continuous time, at rising times.
///
/// `None` for a wall, for bars that differ, for gamma n < 0.404 (see [`Spring::new`]), for more than 1000 elements, for
/// gamma n^2 > 10^20 (see [`Chain::new`]), and for a contact that chatters without end.
pub fn references(scaled: &Scaled, times: &[f64]) -> Option<[History; 2]> {
    if !scaled.pair.equal() || scaled.pair.left.elements > MOST_ELEMENTS {
        return None;
    }
    let gap = scaled.bars.gap;
    let continuum = Spring::new(0.5 * scaled.spring, gap)?;
    let mut elements = Chain::new(&scaled.pair.left, scaled.spring, gap)?;
    let mut spring = History::of_contact(times.len());
    let mut chain = History::of_contact(times.len());
    for &time in times {
        let state = continuum.at(time);
        spring.push(time, [state.displacement, state.velocity, state.force]);
        let state = elements.at(time)?;
        chain.push(time, [state.displacement, state.velocity, state.force]);
    }
    Some([spring, chain])
}
