//! The errors of the exact motion of a case: by two tolerances, and by the convergence of the steps.

use crate::methods::Method;
use crate::metrics::convergence::{
    ENOUGH_HALVINGS, FEWEST_HALVED, Halved, Referred, difference, reference_errors,
};
use crate::metrics::structure as reduce;
use crate::problem::structure::StructureProblem;
use crate::problem::structure::channels::channel::{Channel, Number};
use crate::problem::structure::given::node::Numbering;
use crate::problem::structure::metrics::metric::StructureMetric;
use crate::problem::structure::metrics::reduction::Reduction;
use crate::problem::structure::model::contact_duration;
use crate::problem::structure::motions::motion::{self, Recording};
use crate::problem::structure::motions::recorded::{Motions, Recorded, distinct};
use crate::problem::structure::motions::sweep::Ready;
use crate::system::structure::Structure;
use std::ops::Range;

/// Steps times nodes up to which steps are halved more often than is needed to see an error twice: some seconds.
const MOST_WORK: u64 = 20_000_000;

/// The steps of a motion.
pub struct Stepped<'a> {
    /// The structure.
    pub structure: &'a Structure,
    /// Numbers of its nodes.
    pub numbering: &'a Numbering,
    /// Method of integration.
    pub method: &'a Method,
    /// Time step.
    pub dt: f64,
    /// Number of steps N.
    pub last: u64,
}

impl StructureProblem {
    /// Halved steps in place of a step; 0 if no metric needs them.
    pub(crate) fn halved_steps(&self) -> u64 {
        let mut metrics = self.metrics.iter();
        match metrics.any(|metric| metric.is_exact(Reduction::ReferenceError)) {
            true => FEWEST_HALVED,
            false => 0,
        }
    }

    /// The metrics `reference_error` with their values; none where the exact motion is not integrated.
    pub(crate) fn reference_errors(&self, ready: &Ready, motions: &Motions) -> Vec<(String, f64)> {
        let (Some(exact), Some(coarse)) = (&motions.softened, &motions.coarse) else {
            return Vec::new();
        };
        let is_own = |metric: &&StructureMetric| metric.is_exact(Reduction::ReferenceError);
        let metrics: Vec<_> = self.metrics.iter().filter(is_own).collect();
        let count = ready.last as usize + 1;
        let with_steps = metrics.iter().filter_map(|metric| {
            let steps = metric.window.steps(&ready.case, ready.dt, count)?;
            Some((metric.channel.as_ref()?, steps))
        });
        let channels: Vec<_> = with_steps.collect();
        let steps = Stepped {
            structure: &ready.structure,
            numbering: &ready.numbering,
            method: &ready.method,
            dt: ready.dt,
            last: ready.last,
        };
        let errors = steps.reference_errors(&channels, &motions.computed, [exact, coarse]);
        let names = metrics.iter().map(|metric| metric.name.clone());
        names.zip(errors).collect()
    }
}

impl Stepped<'_> {
    /// The errors of channels, each in these steps, of an exact motion and the same with a coarse tolerance, which the computed motion tends to.
    pub fn reference_errors(
        &self,
        channels: &[(&Channel, Range<usize>)],
        computed: &Recorded,
        [exact, coarse]: [&Recorded; 2],
    ) -> Vec<f64> {
        let of = |motion: &Recorded, (channel, steps): &(&Channel, Range<usize>)| {
            let mut values = motion.channel(channel, self.numbering);
            values.truncate(steps.end);
            values.drain(..steps.start.min(values.len()));
            values
        };
        let of_channel = |channel: &(&Channel, Range<usize>)| {
            let values = of(exact, channel);
            let terms = channel.0.numbers(self.numbering);
            Referred {
                estimate: difference(&values, &of(coarse, channel), 1.0),
                exact: values,
                computed: of(computed, channel),
                size: terms.map(|term| reduce::peak(computed.of(term))).sum(),
            }
        };
        let referred: Vec<Referred> = channels.iter().map(of_channel).collect();
        let of_channels = channels
            .iter()
            .flat_map(|channel| channel.0.numbers(self.numbering));
        let numbers = distinct(of_channels);
        reference_errors(&referred, |halvings| {
            let (motion, resolved) = self.halved(halvings, &numbers)?;
            let channels = channels.iter().map(|channel| of(&motion, channel));
            Some(Halved {
                channels: channels.collect(),
                resolved,
            })
        })
    }

    /// The motion with steps of dt/2^k at the steps of dt, and whether these steps resolve its impacts; `None` if it takes too long or
    /// has no forces.
    fn halved(&self, halvings: u32, numbers: &[Number]) -> Option<(Recorded, bool)> {
        let every = 1_u64 << halvings;
        let last = self.last.checked_mul(every)?;
        let work = last.saturating_mul(self.structure.len() as u64);
        if halvings > ENOUGH_HALVINGS && work > MOST_WORK {
            return None;
        }
        let dt = self.dt / every as f64;
        let prepared = motion::prepare(self.structure, self.method, dt).ok()?;
        let recording = Recording {
            last,
            numbers,
            energy: false,
            watch: Some(motion::EVERY),
        };
        let [run] = motion::steps_every(&[self.structure], &prepared, recording, every as usize);
        let (recorded, _, watched) = run.ok()?;
        let short = contact_duration::has_short_contact(self.structure, watched.as_ref(), dt);
        Some((recorded, !short))
    }
}

#[cfg(test)]
mod tests;
