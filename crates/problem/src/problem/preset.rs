//! A textbook problem as a preset: a linear system with one contact, whose r, rdot and S are the channels of the problem, and the
//! structure that it is.

use crate::exact::adaptive;
use crate::history::History;
use crate::metrics::budget::{Norm, parts};
use crate::metrics::convergence::{Halved, Referred, difference, reference_errors};
use crate::metrics::structure::peak;
use crate::solve::{self, ContactTrack};
use crate::system::System;
use crate::system::structure::{Contact, Limit, Node, Structure, StructureLaw, Symmetric};
use std::ops::Range;

/// The friction limit of a textbook problem, its unit of force.
const LIMIT: f64 = 1.0;

/// A system, and what its r, rdot and S are multiplied by in the channels of its problem.
#[derive(Debug, Clone, Copy)]
pub struct Preset {
    /// The system.
    pub system: System,
    /// The factors.
    pub factors: [f64; 3],
}

/// Motions in continuous time between the exact and the computed one.
pub struct Between {
    /// The motions, from the exact one to the computed one.
    pub motions: Vec<History>,
    /// The same at [`adaptive::coarse_times`] with a coarser tolerance; none of motions in closed form.
    pub coarse: Vec<History>,
}

/// The system as a structure: its modes are masses that the contact joins, each scaled by its share of r. `None` if contact nodes have
/// no mass: their elements are in series with the law.
pub fn structure(system: &System) -> Option<Structure> {
    let linear = &system.linear;
    let count = linear.len();
    let modes: Vec<_> = (0..count).map(|j| linear.mode(j)).collect();
    let mut stiffness = Symmetric::zeros(count);
    for (j, modal) in modes.iter().enumerate() {
        stiffness.add(j, j, modal.mode.omega2 / modal.mode.phi2);
    }
    let node = |(j, phi2): (usize, f64)| Node {
        name: format!("mode {j}"),
        mass: 1.0 / phi2,
        direction: Default::default(),
    };
    let has_mass = linear.contact_compliance() == 0.0;
    has_mass.then(|| {
        let phi2 = modes.iter().map(|modal| modal.mode.phi2);
        let mut structure = Structure::new(phi2.enumerate().map(node).collect());
        structure.stiffness = stiffness;
        structure.contacts.push(Contact {
            name: "contact".into(),
            along: (0..count).map(|j| (j, 1.0)).collect(),
            gap: system.gap,
            law: StructureLaw::new(system.law, Limit::constant(LIMIT)),
        });
        structure.displacement = modes.iter().map(|modal| modal.displacement).collect();
        structure.velocity = modes.iter().map(|modal| modal.velocity).collect();
        structure.preload.forces = vec![Some(system.force)];
        structure
    })
}

impl Preset {
    fn values(&self, contact: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| contact[i] * self.factors[i])
    }

    /// The motion of its structure in continuous time by integration at these times, which rise; `None` without a structure, and where
    /// the integration does not get to its end ([`adaptive::AdaptiveFault`]).
    pub fn integrated(&self, times: &[f64], tolerance: f64) -> Option<History> {
        let mut states = Vec::with_capacity(times.len());
        adaptive::run_of_modes(&structure(&self.system)?, times, tolerance, |i, state| {
            let contact = [state.r[0], state.rate[0], state.force[0]];
            states.push((times[i], self.values(contact)));
        })
        .ok()?;
        Some(states.into_iter().collect())
    }

    /// The parts of the error of a motion in the first rows, and the errors of the references in the second ones; those without a value
    /// that are not `wanted` or not known. `between` gives the motions, with coarse ones if their errors are wanted.
    pub fn budget(
        &self,
        rows: [Range<usize>; 2],
        wanted: &[usize],
        (computed, norm): (&History, &Norm),
        between: impl FnOnce(bool) -> Option<Between>,
    ) -> [Vec<Option<f64>>; 2] {
        let wants = |rows: &Range<usize>| wanted.iter().any(|row| rows.contains(row));
        let [with_parts, with_errors] = rows.each_ref().map(wants);
        let mut values = rows.map(|rows| vec![None; rows.len()]);
        let found = (with_parts || with_errors).then(|| between(with_errors));
        if let Some(budget) = found.flatten() {
            if with_parts {
                values[0] = parts(&budget.motions, computed, norm);
            }
            if !budget.coarse.is_empty() {
                values[1] = budget.errors(self, computed, norm);
            }
        }
        values
    }

    /// The first channels with steps of dt/2^k, at the steps of dt.
    fn halved(&self, halvings: u32, channels: usize) -> Option<Vec<Vec<f64>>> {
        let every = 1_u64 << halvings;
        let halved = System {
            step: self.system.step / every as f64,
            last: self.system.last.checked_mul(every)?,
            ..self.system
        };
        let track = solve::run::<ContactTrack>(&halved).ok()?.track;
        let steps = track.0.iter().step_by(every as usize);
        let values: Vec<_> = steps
            .map(|modes| self.values(self.system.at_contact(*modes)))
            .collect();
        let channel = |channel: usize| values.iter().map(|row| row[channel]).collect();
        Some((0..channels).map(channel).collect())
    }
}

impl Between {
    /// Motions in closed form.
    pub fn in_closed_form(motions: impl Into<Vec<History>>) -> Between {
        Between {
            motions: motions.into(),
            coarse: Vec::new(),
        }
    }

    /// Motions by integration at these times with a tolerance, twice if their error is wanted.
    pub fn integrated(
        times: &[f64],
        with_error: bool,
        at: impl Fn(&[f64], f64) -> Option<Vec<History>>,
    ) -> Option<Between> {
        let coarse = match with_error {
            true => at(&adaptive::coarse_times(times), adaptive::COARSE)?,
            false => Vec::new(),
        };
        Some(Between {
            motions: at(times, adaptive::TOLERANCE)?,
            coarse,
        })
    }

    /// The errors of the motions: against the coarse ones, and of the last one as the convergence of the `computed` motion shows it.
    pub fn errors(&self, preset: &Preset, computed: &History, norm: &Norm) -> Vec<Option<f64>> {
        let (channels, size) = (norm.channels, norm.size);
        let over = |channel: &[f64]| -> Vec<f64> { channel.iter().map(|x| x / size).collect() };
        let of_channel = |channel: usize| {
            let scaled = |motion: &History| over(motion.channel(channel));
            let pairs = self.motions.iter().zip(&self.coarse);
            let estimates = pairs.map(|(fine, coarse)| {
                difference(fine.channel(channel), coarse.channel(channel), size)
            });
            Referred {
                estimate: estimates.fold(0.0, f64::max),
                exact: self.motions.last().map(scaled).unwrap_or_default(),
                size: peak(&scaled(computed)),
                computed: scaled(computed),
            }
        };
        let referred: Vec<Referred> = (0..channels).map(of_channel).collect();
        let errors = reference_errors(&referred, |halvings| {
            let halved = preset.halved(halvings, channels)?;
            Some(Halved {
                channels: halved.iter().map(|channel| over(channel)).collect(),
                resolved: true,
            })
        });
        errors
            .into_iter()
            .map(|x| Some(x).filter(|x| x.is_finite()))
            .collect()
    }
}
