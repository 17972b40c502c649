//! Metrics that compare with what was measured.

use super::channel::Channel;
use super::measured::Compared;
use super::metric::{Reduction, StructureMetric};
use super::metric_values::{MetricContext, Recorded};
use crate::metrics::structure as reduce;

/// The value of a metric that compares with what was measured; `None` where it is undefined.
pub fn value(metric: &StructureMetric, of: MetricContext, computed: &Recorded) -> Option<f64> {
    let compared = of.compared?;
    let channel = metric.channel.as_ref()?;
    let m = compared.values(channel)?;
    let c = sampled(channel, compared, of, computed);
    match metric.reduction {
        Reduction::RmsError => Some(reduce::rms_error(&c, m)),
        Reduction::LastError => Some((c.last()? - m.last()?).abs()),
        Reduction::PeakError => Some((reduce::peak(&c) - reduce::peak(m)).abs()),
        _ => None,
    }
}

/// The computed channel at the measured times, straight between the steps.
fn sampled(
    channel: &Channel,
    compared: &Compared,
    of: MetricContext,
    computed: &Recorded,
) -> Vec<f64> {
    let steps = computed.channel(channel, of.numbering);
    let times = compared.file_times().iter();
    let at = |t: &f64| {
        let place = ((t - compared.delay()) / of.dt).clamp(0.0, (steps.len() - 1) as f64);
        let i = (place as usize).min(steps.len() - 2);
        steps[i] + (place - i as f64) * (steps[i + 1] - steps[i])
    };
    times.map(at).collect()
}

/// Mean energy of the cycles of a contact; `None` without one.
pub fn energy_per_cycle(_r: &[f64], _force: &[f64]) -> Option<f64> {
    None
}
