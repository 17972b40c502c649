//! Metrics of the exact motion of a case, with which computed ones are compared.

use crate::contact::ContactKind;
use crate::problem::structure::StructureProblem;
use crate::problem::structure::metrics::metric::StructureMetric;
use crate::problem::structure::metrics::reduction::Reduction;
use crate::problem::structure::motions::recorded::{MetricContext, Motions, distinct};
use crate::problem::structure::motions::sweep::Ready;
use crate::problem::structure::motions::{exact_motion, metric_values, motion};
use crate::solve::Unsolvable;

impl StructureProblem {
    /// The metrics in these rows of the exact motion at the steps, if they are of a channel that it has, or the energy of a loop.
    pub(crate) fn exact_values(
        &self,
        ready: &Ready,
        rows: &[usize],
    ) -> Result<Vec<Option<f64>>, Unsolvable> {
        let metrics: Vec<&StructureMetric> = rows.iter().map(|row| &self.metrics[*row]).collect();
        let rigid = self.against_rigid();
        // The exact force of a rigid impact has no impulses.
        let has_force = |contact: usize| {
            let contact = ready.structure.contacts.get(contact);
            contact.is_some_and(|contact| !rigid || contact.law.kind() != ContactKind::Impact)
        };
        let of_loop = |metric: &StructureMetric| {
            metric.reduction == Reduction::EnergyPerCycle && metric.contact.is_some_and(has_force)
        };
        let of_motion = |metric: &StructureMetric| {
            !metric.measured && (metric.reduction.is_of_values() || of_loop(metric))
        };
        let numbers = |metric: &StructureMetric| {
            metric_values::needed(metric, &ready.numbering, self.template.contacts.len())
        };
        let known = metrics.iter().filter(|metric| of_motion(metric));
        let wanted = distinct(known.flat_map(|metric| numbers(metric)));
        if wanted.is_empty() {
            return Ok(vec![None; rows.len()]);
        }
        let structure = match rigid {
            true => &motion::rigid(&ready.structure)?,
            false => &ready.structure,
        };
        let times: Vec<f64> = (0..=ready.last).map(|i| i as f64 * ready.dt).collect();
        let motions = Motions {
            computed: exact_motion::exact(structure, &times, &wanted)?,
            ..Motions::default()
        };
        let of = MetricContext {
            case: &ready.case,
            structure: &ready.structure,
            numbering: &ready.numbering,
            compared: None,
            dt: ready.dt,
            against_rigid: rigid,
            impulses: ready.method.has_impulses(),
        };
        let value = |metric: &&StructureMetric| {
            let recorded = |number| motions.computed.of(number).iter().all(|x| x.is_finite());
            let known = of_motion(metric) && numbers(metric).into_iter().all(recorded);
            metric_values::value(metric, of, &motions).filter(|x| known && x.is_finite())
        };
        Ok(metrics.iter().map(value).collect())
    }
}
