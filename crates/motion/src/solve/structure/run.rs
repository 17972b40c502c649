//! Steps of structures in lanes.

use super::general::General;
use super::{Prepared, State};
use crate::solve::Unsolvable;
use crate::solve::structure::average::lane_state::Average;
use crate::solve::structure::inputs::loads_at_steps::Inputs;
use crate::solve::structure::seen::step_view::Kind;
use crate::system::structure::Structure;

/// Steps L structures to step `steps`, by the method that they are prepared for; `visit` gets the number of each step, from 0 on, and
/// the state.
///
/// All structures must fit `prepared` ([`Prepared::fits`]). The bits of each do not depend on the others, on L, or on its place.
///
/// # Errors
/// For each lane: [`Unsolvable::NoForces`] if the forces of a step are not unique, [`Unsolvable::OutOfRange`] if the motion does not
/// remain finite, [`Unsolvable::BrokenRules`] if the method cannot step this structure: an explicit one above its critical step, or
/// with a rigid impact. What `visit` gets of such a lane has no meaning.
pub fn run<const L: usize>(
    cases: &[&Structure; L],
    prepared: &Prepared,
    steps: usize,
    mut visit: impl FnMut(usize, &State<L>),
) -> [Result<(), Unsolvable>; L] {
    let mut state = State(if prepared.has_increments() {
        let inputs = Inputs::new(cases, prepared, steps);
        Kind::Average(Average::new(cases, prepared, inputs))
    } else {
        Kind::General(General::new(cases, prepared, steps))
    });
    visit(0, &state);
    for step in 1..=steps {
        match &mut state.0 {
            Kind::Average(average) => average.step(step),
            Kind::General(general) => general.step(step),
        }
        visit(step, &state);
    }
    let (finite, failures) = match &state.0 {
        Kind::Average(state) => {
            let no_forces = |(step, why)| Unsolvable::NoForces { step, why };
            let failures = state
                .forces
                .failures()
                .map(|failure| failure.map(no_forces));
            (state.finite(), failures)
        }
        Kind::General(state) => (state.finite(), state.failures()),
    };
    let mut failures = failures.into_iter().zip(finite);
    std::array::from_fn(|l| match failures.next() {
        Some((Some(why), _)) => Err(why.with_name(|contact| &cases[l].contacts[contact].name)),
        Some((None, true)) => Ok(()),
        _ => Err(Unsolvable::OutOfRange),
    })
}
