//! Metrics that compare with what was measured.

use super::recorded::{MetricContext, Recorded};
use super::sweep::Ready;
use crate::metrics::measured as reduce;
use crate::metrics::structure::peak;
use crate::problem::structure::StructureProblem;
use crate::problem::structure::channels::channel::Channel;
use crate::problem::structure::channels::measured_channels::{Compared, FEWEST, measured_loop};
use crate::problem::structure::metrics::against_measured::MeasuredFunction;
use crate::problem::structure::metrics::function::{Function, OfLoop};
use crate::problem::structure::metrics::metric::StructureMetric;
use crate::problem::{Case, Violation};
use crate::solve::Unsolvable;

impl StructureProblem {
    /// Enough measured times are within the motion of a case.
    pub(crate) fn check_measured(&self, case: &Case) -> Option<Violation> {
        let measured = self.template.measured.as_ref()?;
        let dt = case.at(self.schema.step)?;
        let compared = match measured.in_case(case, dt, case.steps()) {
            Ok(compared) => compared,
            Err(why) => return Some(why),
        };
        let times = compared.times();
        let mut windows = self.metrics.iter().filter(|metric| metric.measured);
        windows.find_map(|metric| metric.window.check_points(case, &times, FEWEST))
    }

    /// What was measured in a case, if a metric compares with it.
    pub(crate) fn compared(&self, ready: &Ready) -> Result<Option<Compared<'_>>, Unsolvable> {
        let compares = self.metrics.iter().any(|metric| metric.measured);
        let measured = self.template.measured.as_ref().filter(|_| compares);
        let compared =
            measured.map(|measured_file| measured_file.in_case(&ready.case, ready.dt, ready.last));
        let broken = |one| Unsolvable::BrokenRules(Violation::all(&[one]).unwrap_or_default());
        compared.transpose().map_err(broken)
    }
}

/// Ratio of measured values to those of the motion, from which one of them has another unit: cm for m, or mm for m, even where the
/// motion is twice as large.
const FAR: f64 = 50.0;

impl StructureProblem {
    /// Whether measured values are far from those of a motion with these values of the metrics.
    pub(crate) fn is_far_from_measured(
        &self,
        of: MetricContext,
        computed: &Recorded,
        values: &[Option<f64>],
    ) -> bool {
        let is_far = |c: f64, m: f64| c > 0.0 && m > 0.0 && !(1.0 / FAR..=FAR).contains(&(m / c));
        let of_channel = |channel: &Channel| {
            let compared = of.compared?;
            let steps = computed.channel(channel, of.numbering);
            let c = reduce::at_times(&steps, of.dt, &compared.times())?;
            Some(is_far(peak(&c), peak(compared.values(channel)?)))
        };
        let of_metric = |(row, metric): (usize, &StructureMetric)| {
            if metric.measured {
                let of_loop = metric.contact.map(measured_loop);
                let named_channels = metric.channel.iter().chain(&metric.second);
                let mut channels = named_channels.chain(of_loop.iter().flatten());
                return channels.any(|channel| of_channel(channel).unwrap_or(false));
            }
            let sample = self.in_tests(row).zip(values[row]);
            sample.is_some_and(|(mut tests, value)| {
                tests.sort_by(f64::total_cmp);
                let median = tests.get(tests.len() / 2).copied().unwrap_or_default();
                is_far(value.abs(), median.abs())
            })
        };
        self.metrics.iter().enumerate().any(of_metric)
    }
}

/// The value of a metric that compares with what was measured; `None` where it is undefined.
pub fn value(metric: &StructureMetric, of: MetricContext, computed: &Recorded) -> Option<f64> {
    let compared = of.compared?;
    let times = compared.times();
    let points = metric.window.points(of.case, &times)?;
    let times = &times[points.clone()];
    let pair = |channel: &Channel| {
        let steps = computed.channel(channel, of.numbering);
        let c = reduce::at_times(&steps, of.dt, times)?;
        Some((c, compared.values(channel)?.get(points.clone())?))
    };
    let of_channel = |function: fn(&[f64], [&[f64]; 2]) -> Option<f64>| {
        let (c, m) = pair(metric.channel.as_ref()?)?;
        function(times, [&c, m])
    };
    let of_loop = |channels: [&Channel; 2], function: OfLoop| {
        let ((first, m_first), (second, m_second)) = (pair(channels[0])?, pair(channels[1])?);
        function([&first, &second], [m_first, m_second])
    };
    match (
        metric.reduction.of_measured(),
        metric.reduction.row().function,
    ) {
        (Some(measured_row), _) => match measured_row.function {
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
            | Function::Ground(_)
            | Function::Told,
        ) => None,
    }
}
