//! Motions in continuous time with any law, by an adaptive integration.
//!
//! [`crate::exact::events`] knows laws of straight lines. The equations of the others have no closed form between events. Here the
//! method of order 8 of Dormand and Prince integrates them (`tableau`, `step`), with an error of 1e-12 of the largest value in a step.
//! A step ends where a law has a corner: at a first touch and the end of a contact, a reversal, a bound of the force or of its state,
//! and at the points of all tables (`drive`), so that the order is kept. Corners that are not watched, such as the yield of a spring,
//! make short steps.
//!
//! The equations of a contact are the law's own: its answer to a given motion, or the rate of its state
//! ([`crate::contact::Evolution`]; `contact`). Nothing of the methods of integration is used.
//!
//! A second integration with a tolerance of 1e-10, which stops at every third time, tells the error of both ([`COARSE`], [`coarse_times`]).
//! Faults that both have, such as a wrong start, show in the convergence of the steps (`metrics::convergence`).

pub mod bars;
mod contact;
mod drive;
mod law_of_contact;
mod linked;
mod moving;
mod on_line;
mod plane;
mod radau;
mod step;
mod tableau;
#[cfg(test)]
mod tests;
mod watched;
mod widened;

use super::events::{EventsFault, Model, State, StateBuffers};
use crate::contact::ContactLaw;
use crate::exact::adaptive::moving::braced::{MASSLESS, compliances, may_be_braced};
use crate::exact::adaptive::moving::structure::Moving;
use crate::exact::adaptive::watched::Watched;
use crate::system::structure::Structure;
use drive::Drive;
pub use linked::Linked;
use std::fmt;
use widened::Widened;

/// Most degrees of freedom.
pub const MOST_NODES: usize = 100;

/// Tolerance of a step over the largest displacement, velocity or state so far.
pub const TOLERANCE: f64 = 1e-12;

/// The same of the integration that tells the error.
pub const COARSE: f64 = 1e-10;

/// Every how many times the integration that tells the error stops.
const STRIDE: usize = 3;

/// Most products of an integration: about a million steps of one mass, or 3 s.
const MOST_WORK: f64 = 1e9;

/// Equations of the first order, y' = f(t, y), whose parts are smooth up to what is watched.
trait Flow {
    /// The group of each component: components of a group have one scale.
    fn groups(&self) -> &[usize];

    /// Products in a step.
    fn work(&self) -> f64;

    /// Raises the largest values of groups whose components are round-off below a value in a step of length h.
    fn raise(&self, _h: f64, _largest: &mut [f64]) {}

    /// Whether a part of the motion begins, so slowly that other parts of its equations are fast.
    fn begins(&self) -> bool {
        false
    }

    /// Then: the ends of a step in one and in two parts, the latter last, and the error of the directions and its tolerance.
    fn begin(&mut self, _t: f64, _h: f64, _y: &[f64], _ends: [&mut [f64]; 2]) -> [f64; 2] {
        [0.0, 1.0]
    }

    /// Begins a part in which all signals are smooth.
    fn enter(&mut self, part: [f64; 2]);

    /// f.
    fn rates(&mut self, t: f64, y: &[f64], to: &mut [f64]);

    /// The numbers whose sign changes where f has a corner, always as many.
    fn watch(&mut self, t: f64, y: &[f64]) -> &[Watched];

    /// Takes a state as the end of a step. States at their bounds are put there.
    fn commit(&mut self, t: f64, y: &mut [f64]);
}

/// Why there is no motion.
#[derive(Debug, Clone, PartialEq)]
pub enum AdaptiveFault {
    /// The structure is too large.
    TooManyNodes {
        /// Its number of degrees of freedom.
        count: usize,
    },
    /// A contact is at a node without mass, or it is rigid.
    Contact {
        /// Its name.
        name: String,
        /// What the integration does not know.
        what: &'static str,
    },
    /// The structure has no model.
    Model(EventsFault),
    /// The integration takes too many steps.
    Work {
        /// The time reached.
        time: f64,
    },
}

impl fmt::Display for AdaptiveFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            AdaptiveFault::TooManyNodes { count } => write!(
                f,
                "the exact motion of laws that are curved or damped takes at most {MOST_NODES} degrees of freedom, this structure has {count}; compare runs with dt and dt/2 instead"
            ),
            AdaptiveFault::Contact { name, what } => write!(
                f,
                "contact {name} {what}, which the exact motion of laws that are curved or damped does not know; compare runs with dt and dt/2 instead, or, for friction and impacts that do not yield, with rigid laws by \"contacts_reference\": \"rigid\""
            ),
            AdaptiveFault::Model(why) => why.fmt(f),
            AdaptiveFault::Work { time } => write!(
                f,
                "the exact motion needs too many steps from t = {time:?} on; a contact is too stiff or too viscous for it, or the motion too long"
            ),
        }
    }
}

impl std::error::Error for AdaptiveFault {}

/// Computes the motion from t = 0 with a tolerance. Calls `visit(i, state)` at `times[i]`, finite numbers that rise from a number
/// >= 0. Only these nodes matter: u and u' of others have no meaning.
pub fn run_of(
    structure: &Structure,
    nodes: &[usize],
    times: &[f64],
    tolerance: f64,
    mut visit: impl FnMut(usize, &State),
) -> Result<(), AdaptiveFault> {
    let Some((planes, mut widened)) = Widened::new(structure) else {
        return run_planes(structure, nodes, times, tolerance, visit);
    };
    run_planes(&planes, nodes, times, tolerance, |i, state| {
        visit(i, &widened.given(state));
    })
}

/// The same for friction without compliance in planes only.
fn run_planes(
    structure: &Structure,
    nodes: &[usize],
    times: &[f64],
    tolerance: f64,
    visit: impl FnMut(usize, &State),
) -> Result<(), AdaptiveFault> {
    refuse(structure)?;
    let model = Model::new(structure).map_err(AdaptiveFault::Model)?;
    run_model(model, nodes, times, [tolerance, MOST_WORK], visit)
}

/// The same for a structure whose nodes are modes: their matrices are diagonal, and their number is not limited.
pub fn run_of_modes(
    structure: &Structure,
    times: &[f64],
    tolerance: f64,
    visit: impl FnMut(usize, &State),
) -> Result<(), AdaptiveFault> {
    refuse(structure)?;
    let model = Model::of_nodes(structure);
    run_model(model, &[], times, [tolerance, MOST_WORK], visit)
}

fn run_model(
    model: Model,
    nodes: &[usize],
    times: &[f64],
    [tolerance, work]: [f64; 2],
    mut visit: impl FnMut(usize, &State),
) -> Result<(), AdaptiveFault> {
    let mut room = StateBuffers::new(&model);
    let braces = compliances(&model)?;
    let (mut moving, start) = Moving::new(model, braces);
    let length = times.last().copied().unwrap_or(0.0);
    moving.measure(length);
    let mut points = moving.points().to_vec();
    points.reverse();
    let mut drive = Drive::new(&mut moving, start, length, tolerance, work);
    for (i, time) in times.iter().enumerate() {
        while let Some(point) = points.pop_if(|point| *point < *time) {
            drive.advance(point)?;
        }
        drive.advance(*time)?;
        visit(i, &drive.flow.record(&drive.y, nodes, &mut room));
    }
    Ok(())
}

/// The times at which the integration that tells the error stops: every third one, and the last one.
pub fn coarse_times(times: &[f64]) -> Vec<f64> {
    let last = times.len().saturating_sub(1);
    let chosen = times
        .iter()
        .enumerate()
        .filter(|(i, _)| i % STRIDE == 0 || *i == last);
    chosen.map(|(_, time)| *time).collect()
}

/// The integration needs forces that follow from the motion of their own contact.
fn refuse(structure: &Structure) -> Result<(), AdaptiveFault> {
    for contact in &structure.contacts {
        let mut nodes = contact.along.iter();
        let what = match &contact.law {
            law if law.row().is_none() && law.is_rigid() => "is rigid",
            law if law.row().is_some() && !law.is_rigid() && is_vertical(&law.law(1.0)) => {
                "is rigid at rest"
            }
            law if law.row().is_none() && is_vertical(&law.law(1.0)) => "is rigid at rest",
            law if nodes.any(|(node, _)| structure.nodes[*node].mass <= 0.0)
                && !may_be_braced(law) =>
            {
                MASSLESS
            }
            law => match law.as_given().properties().only_in_steps() {
                Some(what) => what,
                None => continue,
            },
        };
        let name = contact.name.clone();
        return Err(AdaptiveFault::Contact { name, what });
    }
    Ok(())
}

/// Refuses structures with many degrees of freedom.
pub fn refuse_large(structure: &Structure) -> Result<(), AdaptiveFault> {
    let count = structure.len();
    match count > MOST_NODES {
        true => Err(AdaptiveFault::TooManyNodes { count }),
        false => Ok(()),
    }
}

/// Whether S is not a function of the motion: it may have any value within bounds at rest.
pub fn is_vertical(law: &ContactLaw) -> bool {
    law.properties().is_vertical()
}
