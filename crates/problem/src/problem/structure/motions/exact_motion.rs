//! Exact motions as recorded quantities.

use super::derived;
use super::recorded::Recorded;
use crate::exact::adaptive::{self, AdaptiveFault, Linked};
use crate::exact::events::{self, EventsFault};
use crate::problem::structure::channels::channel::{Derived, Number, Quantity};
use crate::problem::structure::model::massless;
use crate::solve::Unsolvable;
use crate::system::structure::Structure;
use std::collections::BTreeSet;

/// The exact motion at these times: by events, or, with laws that are not of straight lines, integrated.
///
/// # Errors
/// [`Unsolvable::Reference`]: the motion has too many events, pieces or steps, its rigid contacts have no unique forces, or it has a
/// contact that neither knows.
pub fn exact(
    structure: &Structure,
    times: &[f64],
    numbers: &[Number],
) -> Result<Recorded, Unsolvable> {
    let in_series = massless::with_springs_in_series(structure);
    let held = in_series.as_ref().unwrap_or(structure);
    record(held, times, numbers, |nodes, visit| {
        let by_events = events::run_of(held, nodes, times, &mut *visit);
        match by_events {
            Err(EventsFault::Law { .. }) => {}
            ended => return ended.map_err(|why| why.to_string()),
        }
        let ended = integrate(
            [structure, held],
            nodes,
            (times, adaptive::TOLERANCE),
            visit,
        );
        ended.map_err(|why| why.to_string())
    })
}

/// The integrated motion of a structure, which has weak springs between contacts in series if these are not dampers behind elastic ones.
fn integrate(
    [given, held]: [&Structure; 2],
    nodes: &[usize],
    (times, tolerance): (&[f64], f64),
    visit: &mut dyn FnMut(usize, &events::State),
) -> Result<(), AdaptiveFault> {
    adaptive::refuse_large(given)?;
    let Some((structure, mut linked)) = Linked::new(given) else {
        return adaptive::run_of(held, nodes, times, tolerance, visit);
    };
    let nodes: Vec<usize> = nodes.iter().copied().chain(linked.nodes()).collect();
    adaptive::run_of(&structure, &nodes, times, tolerance, |i, state| {
        visit(i, &linked.given(state));
    })?;
    linked.end()
}

/// The integrated motion with a coarser tolerance, whose difference tells its error; `None` where the motion is one by events.
///
/// # Errors
/// Those of [`exact`].
pub fn coarse(
    structure: &Structure,
    times: &[f64],
    numbers: &[Number],
) -> Result<Option<Recorded>, Unsolvable> {
    if events::knows_laws(structure) {
        return Ok(None);
    }
    let times = adaptive::coarse_times(times);
    let recorded = record(structure, &times, numbers, |nodes, visit| {
        let ended = integrate([structure; 2], nodes, (&times, adaptive::COARSE), visit);
        ended.map_err(|why| why.to_string())
    });
    recorded.map(Some)
}

/// What a motion visits at these times.
pub(super) fn record(
    structure: &Structure,
    times: &[f64],
    numbers: &[Number],
    run: impl FnOnce(&[usize], &mut dyn FnMut(usize, &events::State)) -> Result<(), String>,
) -> Result<Recorded, Unsolvable> {
    let mut series = vec![Vec::with_capacity(times.len()); numbers.len()];
    let derived: Vec<Derived> = numbers.iter().filter_map(Number::derived).collect();
    let terms = derived::terms(structure, &derived)?;
    let mut visit = |i: usize, state: &events::State| {
        let mut terms = terms.iter();
        for (series, number) in series.iter_mut().zip(numbers) {
            let value = match number {
                Number::Derived(_) => terms.next().map(|sum| {
                    let force = |contact: usize| state.force[contact];
                    sum.value(|i| state.u[i], |i| state.v[i], force, sum.at(times[i]))
                }),
                // Its series stays empty.
                Number::Energy(_) => None,
                number @ (Number::Displacement(_)
                | Number::Velocity(_)
                | Number::Acceleration(_)
                | Number::Contact(..)) => Some(exact_value(structure, times[i], state, *number)),
            };
            series.extend(value);
        }
    };
    let of_terms = terms.iter().flat_map(|sum| sum.u.iter().chain(&sum.v));
    let contacts = structure.contacts.iter();
    let pressed = contacts.filter_map(|contact| contact.law.limit()?.pressed_by.as_ref());
    let springs = pressed.flat_map(|pressed_by| &pressed_by.springs);
    let wanted: BTreeSet<usize> = numbers
        .iter()
        .filter_map(Number::node)
        .chain(of_terms.map(|term| term.0))
        .chain(springs.flat_map(|pressing| pressing.spring.along.iter().map(|(node, _)| *node)))
        .collect();
    // Those behind the nodes are supports.
    let moving = wanted.into_iter().filter(|node| *node < structure.len());
    let nodes: Vec<usize> = moving.collect();
    run(&nodes, &mut visit).map_err(Unsolvable::Reference)?;
    Ok(Recorded::new(numbers, series, times.len()))
}

pub(super) fn exact_value(
    structure: &Structure,
    t: f64,
    state: &events::State,
    number: Number,
) -> f64 {
    match number {
        Number::Displacement(node) => structure.total(node, t, 0, state.u),
        Number::Velocity(node) => structure.total(node, t, 1, state.v),
        Number::Acceleration(support) => {
            structure.supports[support].motion.shown_acceleration_at(t)
        }
        Number::Derived(_) | Number::Energy(_) => f64::NAN,
        Number::Contact(contact, quantity) => match quantity {
            Quantity::Displacement => state.r[contact],
            Quantity::Velocity => state.rate[contact],
            Quantity::Force => state.force[contact],
            Quantity::Slip => state.slip[contact],
            Quantity::Limit => {
                let limit = structure.contacts[contact].law.limit();
                let motion = |node: usize| [state.u[node], state.v[node]];
                limit.map_or(0.0, |limit| limit.pressed_in(t, |c| state.force[c], motion))
            }
            Quantity::Distance | Quantity::Speed | Quantity::Size | Quantity::SlipDistance => {
                let directions = number.directions().into_iter().flatten();
                let both = directions.map(|number| exact_value(structure, t, state, number));
                both.fold(0.0, libm::hypot)
            }
        },
    }
}
