//! The motions between the exact impact and the computed one, for the error budget.

use super::scaled::Scaled;
use crate::contact::WhichLaw;
use crate::exact::mesh::Mesh;
use crate::exact::spring::Spring;
use crate::history::History;

/// Most elements of a bar: memory and time of the mesh in continuous time grow with the square of their number.
const MOST_ELEMENTS: u32 = 1000;

/// The continuous bars on their spring, and the mesh in continuous time, at times that increase.
///
/// `None` for another law than the impact spring, for a wall, for bars that differ, for gamma n < 0.404 (see [`Spring::new`]), for more than 1000 elements, for
/// gamma n^2 > 10^20 (see [`Mesh::new`]), and for a contact with too many separations (see [`Mesh::at`]).
pub fn references(scaled: &Scaled, times: &[f64]) -> Option<[History; 2]> {
    let linear = scaled.law.which() == WhichLaw::ImpactSpring;
    if !linear || !scaled.pair.equal() || scaled.pair.left.elements > MOST_ELEMENTS {
        return None;
    }
    let gap = scaled.bars.gap;
    let spring = Spring::new(0.5 * scaled.spring, gap)?;
    let mut mesh = Mesh::new(&scaled.pair.left, scaled.spring, gap)?;
    let states = times
        .iter()
        .map(|&time| Some((time, mesh.at(time)?.values())));
    let mesh = states.collect::<Option<History>>()?;
    let spring = History::sample(times, |time| spring.at(time).values());
    Some([spring, mesh])
}
