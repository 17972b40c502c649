//! Whether a change of 1e-10 in start and loads reaches 1 % of the motion.

use crate::metrics::structure as reduce;
use crate::problem::Case;
use crate::problem::structure::StructureProblem;
use crate::problem::structure::channels::channel::{Number, Quantity};
use crate::problem::structure::given::node::Numbering;
use crate::problem::structure::metrics::metric::StructureMetric;
use crate::problem::structure::metrics::reduction::Reduction;
use crate::problem::structure::motions::motion::{self, Recording};
use crate::problem::structure::motions::recorded::{Motions, Recorded, distinct};
use crate::problem::structure::motions::still::Still;
use crate::problem::structure::motions::sweep::Ready;

/// The share of the peak from which two motions are different ones.
const DIFFERENT: f64 = 0.01;

impl StructureProblem {
    /// Whether a change of 1e-10 in start and loads reaches 1 % of the peak of a channel that metrics are of; `None` if not known.
    pub fn diverges(&self, case: &Case) -> Option<bool> {
        if self.program_of(case).is_some() {
            return None;
        }
        let Ready {
            structure,
            numbering,
            method,
            dt,
            last,
            ..
        } = self.ready(0, case).ok()?;
        let prepared = motion::prepare(&structure, &method, dt).ok()?;
        let numbers = self.watched(&numbering);
        let recording = Recording {
            last,
            numbers: &numbers,
            energy: false,
            watch: None,
        };
        let other = motion::perturbed(&structure);
        let [run] = motion::steps(&[&structure], &prepared, recording);
        let [other] = motion::steps(&[&other], &prepared, recording);
        let motions = Motions {
            computed: run.ok()?.0,
            perturbed: Some(other.ok()?.0),
            ..Motions::default()
        };
        let still = Still::of(&structure, dt, last as usize);
        Some(self.channels_part(&motions, &numbering, still))
    }

    /// Whether a quantity that is watched parts.
    fn channels_part(&self, motions: &Motions, numbering: &Numbering, still: Still) -> bool {
        let Some(other) = &motions.perturbed else {
            return false;
        };
        let part = |a: &[f64], b: &[f64]| reduce::divergence(a, b, DIFFERENT).is_some();
        let mut channels = self.metrics.iter().filter_map(|m| m.channel.as_ref());
        let of = |motion: &Recorded, channel| motion.channel(channel, numbering);
        let computed = &motions.computed;
        channels.any(|channel| {
            let values = of(computed, channel);
            !still.is_channel(channel, (computed, numbering), &values)
                && part(&values, &of(other, channel))
        }) || self
            .plain(numbering)
            .into_iter()
            .filter(|number| !still.is(*number, computed))
            .any(|number| part(computed.of(number), other.of(number)))
    }

    /// The relative displacements of the contacts that metrics are of; the displacements of all nodes if no metric has a channel or
    /// a contact.
    fn plain(&self, numbering: &Numbering) -> Vec<Number> {
        let has_part =
            |metric: &StructureMetric| metric.channel.is_some() || metric.contact.is_some();
        if !self.metrics.iter().any(has_part) {
            return (0..numbering.nodes()).map(Number::Displacement).collect();
        }
        let contacts = self.metrics.iter().filter_map(|metric| metric.contact);
        contacts
            .map(|contact| Number::Contact(contact, Quantity::Displacement))
            .collect()
    }

    /// The quantities of the channels of the metrics, and those of [`Self::plain`].
    fn watched(&self, numbering: &Numbering) -> Vec<Number> {
        let channels = self.metrics.iter().filter_map(|m| m.channel.as_ref());
        let numbers = channels.flat_map(|channel| channel.numbers(numbering));
        distinct(numbers.chain(self.plain(numbering)))
    }

    /// The same from the metrics of a case, in the order of the table; `None` if no metric says it.
    pub fn diverges_by(&self, values: &[Option<f64>]) -> Option<bool> {
        let says = |(row, value): (usize, &Option<f64>)| {
            let metric = self.metrics.get(row)?;
            let is = |reduction| metric.reduction == reduction;
            if is(Reduction::Divergence) && metric.threshold == DIFFERENT {
                return Some(value.is_some());
            }
            is(Reduction::Difference).then(|| value.is_some_and(|value| value > DIFFERENT))
        };
        let said: Vec<bool> = values.iter().enumerate().filter_map(says).collect();
        (!said.is_empty()).then(|| said.contains(&true))
    }
}
