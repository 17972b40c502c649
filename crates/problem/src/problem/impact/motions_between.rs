//! The motions between the exact impact and the computed one, for the error budget.

use super::case::ImpactCase;
use crate::contact::ClippedLine;
use crate::exact::adaptive;
use crate::exact::mesh::Mesh;
use crate::exact::spring::Spring;
use crate::history::History;
use crate::problem::preset::Between;

/// Most elements of a bar: memory and time of the mesh in continuous time grow with the square of their number.
const MOST_ELEMENTS: u32 = 1000;

/// The continuous bars with their law, and the mesh in continuous time, at times that increase.
///
/// `None` for bars that differ, for rigid contact, and for more than 1000 elements. For the impact spring `None` for a wall, for gamma n
/// < 0.404 (see [`Spring::new`]), for gamma n^2 > 10^20 (see [`Mesh::new`]), and for a contact with too many separations (see
/// [`Mesh::at`]); for another law where contact nodes have no mass, and where the integration takes too many steps.
pub fn between(case: &ImpactCase, times: &[f64], with_error: bool) -> Option<Between> {
    let scaled = &case.scaled;
    let (pair, gap) = (&scaled.pair, scaled.bars.gap);
    if pair.left.elements > MOST_ELEMENTS {
        return None;
    }
    if matches!(scaled.law.line(), Some(ClippedLine::Spring { .. })) {
        return in_closed_form(case, times);
    }
    let alike = pair.right.is_none() || pair.equal();
    if !alike || pair.contact_compliance() != 0.0 {
        return None;
    }
    Between::integrated(times, with_error, |times, tolerance| {
        let states = adaptive::bars::continuous(&scaled.law, gap, times, tolerance).ok()?;
        let timed = times.iter().zip(states);
        let bars = timed.map(|(time, state)| (*time, state.values())).collect();
        Some(vec![bars, case.preset().integrated(times, tolerance)?])
    })
}

fn in_closed_form(case: &ImpactCase, times: &[f64]) -> Option<Between> {
    let scaled = &case.scaled;
    if !scaled.pair.equal() {
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
    Some(Between::in_closed_form([spring, mesh]))
}

#[cfg(test)]
mod tests;
