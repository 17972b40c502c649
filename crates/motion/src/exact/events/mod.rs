//! The exact motion of a structure with contacts, from event to event.
//!
//! Between events the motion is linear, with loads that are polynomials or sines in time. Its Taylor series are exact to
//! round-off on pieces that are short against the shortest period (`series`), for any C. Their coordinates are nodes or modes
//! (`model`). Event functions are polynomials of a piece; their Bernstein coefficients prove that no event is missed (`bernstein`,
//! `watch`). Forces of softened laws are continuous, so that simultaneous events need no order (`softened_phases`). Which rigid
//! contacts stick or stay shut, and impulses, are the problem that a step has, too (`rigid_phases`, `rigid`,
//! [`crate::contact::CoupledForces`]). Contacts at nodes without mass have compliance, and may share it (`flexible`).

mod coordinates;
mod fault;
mod motion;
pub(super) mod numerics;
mod phases;
mod pieces;
mod settle;
#[cfg(test)]
mod tests;
mod transitions;

pub(super) use crate::exact::events::coordinates::model::Model;
pub use crate::exact::events::phases::contact_phase::Phase;
pub use crate::exact::events::pieces::book::Book;
pub(super) use crate::exact::events::pieces::state_buffers::StateBuffers;
pub use fault::EventsFault;
pub use motion::{MOST_EVENTS, MOST_PIECES};

use crate::contact::{ClippedLine, ContactKind};
use crate::exact::events::phases::contact_state::ContactState;
use crate::system::structure::{Along, Contact, Limit, PressedBy, Structure};
use motion::Motion;

/// The motion at one time; at an event, after it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State<'a> {
    /// u of each node; with supports that move, the rest w.
    pub u: &'a [f64],
    /// u' of each node.
    pub v: &'a [f64],
    /// r of each contact, with its gap.
    pub r: &'a [f64],
    /// rdot of each contact.
    pub rate: &'a [f64],
    /// S of each contact.
    pub force: &'a [f64],
    /// r - S/k^C for displacement-control, r for other laws.
    pub slip: &'a [f64],
}

/// An event of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// Its time.
    pub time: f64,
    /// The contact.
    pub contact: usize,
    /// What happens.
    pub kind: EventKind,
}

/// What happens at an event.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum EventKind {
    /// The contact changes to this phase.
    Phase(Phase),
    /// A rigid stop closes.
    Impact {
        /// rdot before it, < 0.
        rate: f64,
    },
}

/// What a motion had.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    /// The events in time.
    pub events: Vec<Event>,
    /// Number of pieces.
    pub pieces: usize,
    /// Smallest |rdot| of an impact contact that closes, impacts that accumulate included. Errors grow as its inverse.
    pub least_impact_rate: Option<f64>,
    /// The energy book.
    pub book: Book,
}

/// Computes the exact motion from t = 0. Calls `visit(i, state)` at `times[i]`, finite numbers that rise from a number >= 0.
///
/// A mass slides with 2, is slowed down by a limit of 1, and rests from t = 2 on at u = 2^2/2:
///
/// ```
/// use slipgap_contact::contact::ClippedLine;
/// use slipgap_motion::exact::events::run;
/// use slipgap_system::system::structure::{Limit, Structure, StructureLaw};
///
/// let coulomb = StructureLaw::new(ClippedLine::Coulomb, Limit::constant(1.0));
/// let mass = Structure::builder()
///     .mass("mass", 1.0)
///     .contact("floor", ["ground", "mass"], 0.0, coulomb)
///     .start("mass", [0.0, 2.0])
///     .build()
///     .expect("names of its masses");
/// let mut u = 0.0;
/// let summary = run(&mass, &[1.0, 5.0], |_, state| u = state.u[0])?;
/// assert_eq!((u, summary.events[1].time), (2.0, 2.0));
/// assert_eq!(summary.book.dissipated, 2.0);
/// # Ok::<(), slipgap_motion::exact::events::EventsFault>(())
/// ```
pub fn run(
    structure: &Structure,
    times: &[f64],
    visit: impl FnMut(usize, &State),
) -> Result<Summary, EventsFault> {
    let nodes: Vec<usize> = (0..structure.len()).collect();
    refuse_laws(structure)?;
    run_model(Model::new(structure)?, (&nodes, true), times, visit)
}

/// The same without the energy book, where only these nodes matter: u and u' of others have no meaning. Both save time for many
/// nodes.
pub fn run_of(
    structure: &Structure,
    nodes: &[usize],
    times: &[f64],
    visit: impl FnMut(usize, &State),
) -> Result<(), EventsFault> {
    refuse_laws(structure)?;
    run_model(Model::new(structure)?, (nodes, false), times, visit).map(|_| ())
}

fn run_model(
    model: Model,
    (nodes, book): (&[usize], bool),
    times: &[f64],
    mut visit: impl FnMut(usize, &State),
) -> Result<Summary, EventsFault> {
    let end = times.last().copied().unwrap_or(0.0);
    let mut room = StateBuffers::new(&model);
    let mut motion = Motion::start(model, end, book)?;
    let mut times = times.iter().enumerate().peekable();
    loop {
        motion.advance()?;
        let reached = motion.reached();
        while let Some((i, time)) = times.next_if(|(_, time)| **time < reached || reached >= end) {
            motion.at(*time, nodes, &mut room);
            visit(i, &room.state());
        }
        if reached >= end {
            break;
        }
        motion.finish()?;
    }
    motion.finish()?;
    Ok(Summary {
        events: motion.events,
        pieces: motion.pieces,
        least_impact_rate: motion.least_impact_rate,
        book: motion.book,
    })
}

/// About how much work the motion up to `end` is, with pieces that start at `points` points of tables at least: friction sticks,
/// impact contacts are open. In units of 2 ns, as measured; 0 for a motion that is refused.
pub fn work(structure: &Structure, end: f64, points: usize) -> f64 {
    let pieces = pieces(structure, end).max(points as f64);
    let [n, contacts] = [structure.len(), structure.contacts.len()].map(|count| count as f64);
    match crate::exact::events::coordinates::modal::uses_modes(structure) {
        // 3 us for a piece of one node, and about 1 us for each further node or contact.
        false => pieces * (1500.0 + 500.0 * (n + contacts)),
        // 2.5 s for 1000 modes, and 12 us for a piece of them with one contact.
        true => {
            1.25 * n * n * n + pieces * (1500.0 + 500.0 * contacts + 2.0 * n * (1.0 + contacts))
        }
    }
}

/// About how many pieces the motion up to `end` has: friction sticks, impact contacts are open. 0 for a motion that is refused.
pub fn pieces(structure: &Structure, end: f64) -> f64 {
    let states = structure
        .contacts
        .iter()
        .map(|contact| match contact.law.kind() {
            ContactKind::Impact => ContactState::in_phase(Phase::Open),
            ContactKind::Friction | ContactKind::Link => ContactState::in_phase(Phase::Closed),
        });
    let phased = states.zip(&structure.contacts).map(|(state, contact)| {
        let line = crate::exact::events::phases::lines::of(&contact.law)
            .map(|law| law.start(contact.gap, None));
        ContactState { line, ..state }
    });
    let phases: Vec<ContactState> = phased.collect();
    let pieces = Model::of_nodes(structure).pieces(&phases, end) * coupling(structure);
    match refuse_laws(structure).is_ok() && pieces <= MOST_PIECES as f64 {
        true => pieces,
        false => 0.0,
    }
}

/// A bound of the frequencies with coupled masses over those with the diagonal of M (Gershgorin), where it is one; not more than
/// for solid elements, where it is none.
fn coupling(structure: &Structure) -> f64 {
    let mut coupled = vec![0.0; structure.len()];
    for ((i, j), value) in structure.coupled_mass.entries() {
        coupled[i] += value.abs();
        coupled[j] += value.abs();
    }
    let parts = coupled
        .iter()
        .zip(&structure.nodes)
        .filter(|(_, node)| node.mass > 0.0);
    let largest = parts
        .map(|(coupled, node)| coupled / node.mass)
        .fold(0.0, f64::max);
    1.0 / (1.0 - largest).max(0.125).sqrt()
}

/// Whether every law is one of straight lines, so that the motion is known between events.
pub fn knows_laws(structure: &Structure) -> bool {
    refuse_laws(structure).is_ok()
}

/// Between events every law has to be linear, and every limit the sum of a constant and a signal. Laws of lines and of velocity are
/// not known at nodes without mass, nor from a state that static loads leave and r and S do not tell.
fn refuse_laws(structure: &Structure) -> Result<(), EventsFault> {
    let has_masses = |along: &Along| {
        let mut nodes = along.iter();
        nodes.all(|(node, _)| structure.nodes.get(*node).is_none_or(|n| n.mass > 0.0))
    };
    let has_mass = |contact: &Contact| has_masses(&contact.along);
    let has_lines = |(i, contact): (usize, &Contact)| {
        let r = structure.relative(i, &structure.displacement) + contact.gap;
        let knows = |law: crate::exact::events::phases::lines::Lines| {
            law.knows(r, structure.preload.force(i))
        };
        has_mass(contact)
            && crate::exact::events::phases::lines::of(&contact.law).is_some_and(knows)
    };
    // Forces at nodes without mass are those of friction, too. A coefficient that falls with them makes friction curved.
    let not_known = |by: &PressedBy| {
        let contacts = by.contacts.iter().map(|i| &structure.contacts[*i].along);
        let springs = by.springs.iter().map(|pressing| &pressing.spring.along);
        !contacts.chain(springs).all(has_masses)
    };
    let unknown = |(i, contact): &(usize, &Contact)| {
        let law = &contact.law;
        let falls = |limit: &Limit| {
            limit.pressure.is_some() && (limit.varying.is_some() || limit.pressed_by.is_some())
        };
        let refused =
            |limit: &Limit| falls(limit) || limit.pressed_by.as_ref().is_some_and(not_known);
        let is_viscous = matches!(law.line(), Some(ClippedLine::Viscous { .. }));
        is_viscous && !has_mass(contact)
            || law.is_curved() && !has_lines((*i, contact))
            || law.limit().is_some_and(refused)
    };
    let found = structure.contacts.iter().enumerate().find(unknown);
    let contact = found.map(|(_, contact)| contact);
    match contact.map(|contact| contact.name.clone()) {
        Some(contact) => Err(EventsFault::Law { contact }),
        None => Ok(()),
    }
}
