//! The cycles of the excitation of a case, at which figures sample its motion.

use crate::problem::Case;
use crate::problem::structure::parts::template::Template;
use crate::system::loads::cycles::Cycles;

/// Fewest steps in a cycle that a figure samples.
const FEWEST: f64 = 4.0;

/// The whole cycles of the loads and motions of a case before its end, from the first one of them.
///
/// # Errors
/// Why they are not known.
pub fn cycles(
    template: &Template,
    case: &Case,
    [dt, end]: [f64; 2],
) -> Result<Vec<Cycles>, String> {
    let loads = template.loads.iter().map(|load| load.force.cycles(case));
    let ground = template.ground.iter().map(|motion| motion.1.cycles(case));
    let supports = template.supports.iter().map(|support| support.cycles(case));
    let mut known: Vec<Vec<Cycles>> = Vec::new();
    for cycles in loads.chain(ground).chain(supports) {
        let cycles = cycles.map_err(|violation| violation.message.to_string())?;
        let within = cycles.into_iter().map(|cycles| cycles.within([0.0, end]));
        let whole: Vec<Cycles> = within.filter(|cycles| cycles.count > 0).collect();
        if !whole.is_empty() {
            known.push(whole);
        }
    }
    let mut others = known.into_iter();
    let Some(first) = others.next() else {
        return Err(
            "needs a sine, sweep or stepped_sweep with a whole cycle before the end".into(),
        );
    };
    let frequencies = |cycles: &[Cycles]| -> Vec<u64> {
        cycles
            .iter()
            .map(|cycles| cycles.frequency.to_bits())
            .collect()
    };
    if others.any(|other| frequencies(&other) != frequencies(&first)) {
        return Err("needs loads and motions of one frequency, or only one that oscillates".into());
    }
    match first
        .iter()
        .all(|cycles| cycles.frequency * dt * FEWEST <= 1.0)
    {
        true => Ok(first),
        false => Err(format!("needs at least {FEWEST} steps in a cycle")),
    }
}
