//! Metrics that compare with what was measured.

use super::recorded::{MetricContext, Recorded};
use super::sweep::Ready;
use crate::metrics::measured as reduce;
use crate::problem::structure::StructureProblem;
use crate::problem::structure::channels::channel::Channel;
use crate::problem::structure::channels::measured::{Compared, measured_loop};
use crate::problem::structure::metrics::against_measured::MeasuredFunction;
use crate::problem::structure::metrics::function::{Function, OfLoop};
use crate::problem::structure::metrics::metric::StructureMetric;
use crate::problem::{Case, Problem, Violation};
use crate::solve::Unsolvable;

impl StructureProblem {
    /// Enough measured times are within the motion of a case.
    pub(crate) fn check_measured(&self, case: &Case) -> Option<Violation> {
        let measured = self.template.measured.as_ref()?;
        let dt = case.at(self.schema.step)?;
        measured.in_case(case, dt, self.steps(case)).err()
    }

    /// What was measured in a case, if a metric compares with it.
    pub(crate) fn compared(&self, ready: &Ready) -> Result<Option<Compared<'_>>, Unsolvable> {
        let compares = self.metrics.iter().any(|metric| metric.measured);
        let measured = self.template.measured.as_ref().filter(|_| compares);
        let compared = measured.map(|own| own.in_case(&ready.case, ready.dt, ready.last));
        let broken = |one| Unsolvable::BrokenRules(Violation::all(&[one]).unwrap_or_default());
        compared.transpose().map_err(broken)
    }
}

/// The value of a metric that compares with what was measured; `None` where it is undefined.
pub fn value(metric: &StructureMetric, of: MetricContext, computed: &Recorded) -> Option<f64> {
    let compared = of.compared?;
    let times = compared.times();
    let pair = |channel: &Channel| {
        let steps = computed.channel(channel, of.numbering);
        let c = reduce::at_times(&steps, of.dt, &times)?;
        Some((c, compared.values(channel)?))
    };
    let of_channel = |function: fn(&[f64], [&[f64]; 2]) -> Option<f64>| {
        let (c, m) = pair(metric.channel.as_ref()?)?;
        function(&times, [&c, m])
    };
    let of_loop = |channels: [&Channel; 2], function: OfLoop| {
        let ((first, m_first), (second, m_second)) = (pair(channels[0])?, pair(channels[1])?);
        function([&first, &second], [m_first, m_second])
    };
    match (
        metric.reduction.of_measured(),
        metric.reduction.row().function,
    ) {
        (Some(own), _) => match own.function {
            MeasuredFunction::Channel(function) => of_channel(function),
            MeasuredFunction::Contact(function) => {
                let [r, s] = measured_loop(metric.contact?);
                of_loop([&r, &s], function)
            }
        },
        (None, Function::Measured(function)) => of_channel(function),
        (None, Function::Loop(function)) => {
            let channels = [metric.channel.as_ref()?, metric.second.as_ref()?];
            of_loop(channels, function)
        }
        // A text of these does not say `measured`.
        (
            None,
            Function::Values(_)
            | Function::Distance(..)
            | Function::Pair(..)
            | Function::Estimated
            | Function::Perturbed(_)
            | Function::Contact(..)
            | Function::Energies(_)
            | Function::Ground(_),
        ) => None,
    }
}
