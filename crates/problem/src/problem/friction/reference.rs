//! The motion of the oscillator with the law of a case in continuous time.

use super::case::OscillatorCase;
use super::coulomb;
use super::law::PlainLaw;
use crate::contact::ContactLaw;
use crate::exact::adaptive;
use crate::exact::regularised::{self, Regularised};
use crate::history::History;
use crate::metrics::{
    self,
    convergence::{Halved, Referred, reference_errors},
};
use crate::solve::{self, ContactTrack, ToSystem};
use crate::system::structure::{
    Contact, Limit, Node, Preload, Structure, StructureLaw, Symmetric, between,
};

/// A motion in continuous time.
pub struct Softened {
    /// The motion.
    pub motion: History,
    /// The same at every third time and the last one, with a coarser tolerance; `None` of a motion in closed form.
    pub coarse: Option<History>,
}

/// Whether the motion with a law has a closed form.
pub fn in_closed_form(law: &ContactLaw) -> bool {
    PlainLaw::of(law).is_some()
}

/// The motion at these times; `None` outside the range of [`regularised::holds`], and where the integration does not get to its end
/// ([`adaptive::AdaptiveFault`]).
pub fn softened(case: &OscillatorCase, times: &[f64], with_error: bool) -> Option<Softened> {
    let (x0, force, end) = (case.x0, case.force, *times.last()?);
    let Some(law) = PlainLaw::of(&case.law) else {
        return integrated(case, times, with_error);
    };
    let mut motion = match law {
        PlainLaw::Velocity(law) if law.compliance == 0.0 => {
            let motion = coulomb(x0, times);
            return Some(Softened {
                motion,
                coarse: None,
            });
        }
        PlainLaw::Displacement(law) => regularised::holds(x0, law.compliance, force, end)
            .then(|| Regularised::displacement(x0, law.compliance, force))?,
        PlainLaw::Velocity(law) => regularised::holds(x0, law.compliance, 0.0, end)
            .then(|| Regularised::velocity(x0, law.compliance))?,
    };
    Some(Softened {
        motion: History::sample(times, |time| motion.at(time).values()),
        coarse: None,
    })
}

/// The same by integration.
fn integrated(case: &OscillatorCase, times: &[f64], with_error: bool) -> Option<Softened> {
    let structure = structure(case);
    let at = |times: &[f64], tolerance: f64| -> Option<History> {
        let mut states = Vec::with_capacity(times.len());
        adaptive::run_of(&structure, &[0], times, tolerance, |i, state| {
            states.push((times[i], [state.u[0], state.v[0], state.force[0]]));
        })
        .ok()?;
        Some(states.into_iter().collect())
    };
    let coarse = match with_error {
        true => Some(at(&adaptive::coarse_times(times), adaptive::COARSE)?),
        false => None,
    };
    Some(Softened {
        motion: at(times, adaptive::TOLERANCE)?,
        coarse,
    })
}

/// The error of a motion in continuous time: against a `coarse` one, and as the convergence of the computed one shows it.
pub fn error(
    case: &OscillatorCase,
    computed: &History,
    motion: &History,
    coarse: &History,
) -> Option<f64> {
    let scaled = |x: &[f64]| -> Vec<f64> { x.iter().map(|x| x / case.x0.abs()).collect() };
    let channel = Referred {
        exact: scaled(motion.displacement()),
        computed: scaled(computed.displacement()),
        size: 1.0,
        estimate: metrics::friction::reference(case.x0, motion, coarse),
    };
    let errors = reference_errors(&[channel], |halvings| {
        let every = 1_u64 << halvings;
        let halved = OscillatorCase {
            step: case.step / every as f64,
            last: case.last.checked_mul(every)?,
            ..*case
        };
        let track = solve::run::<ContactTrack>(&halved.system()).ok()?.track;
        let states = track.0.iter().step_by(every as usize);
        let x: Vec<f64> = states.map(|state| state[0]).collect();
        Some(Halved {
            channels: vec![scaled(&x)],
            resolved: true,
        })
    });
    errors.first().copied()
}

/// The oscillator as a structure: a mass of 1 on a spring of 1.
fn structure(case: &OscillatorCase) -> Structure {
    let mut stiffness = Symmetric::zeros(1);
    stiffness.add(0, 0, 1.0);
    Structure {
        nodes: vec![Node {
            name: String::new(),
            mass: 1.0,
            direction: Default::default(),
        }],
        coupled_mass: Symmetric::zeros(1),
        stiffness,
        damping: Symmetric::zeros(1),
        contacts: vec![Contact {
            name: String::new(),
            along: between([None, Some(0)]),
            gap: 0.0,
            law: StructureLaw::new(case.law, Limit::constant(1.0)).from_its_answer(),
        }],
        loads: Vec::new(),
        displacement: vec![case.x0],
        velocity: vec![0.0],
        supports: Vec::new(),
        observed: None,
        // S at release.
        preload: Preload {
            forces: vec![Some(case.force)],
            ..Preload::default()
        },
    }
}

#[cfg(test)]
mod tests;
