//! Metrics that compare with what was measured.

use super::channel::Channel;
use super::measured::measured_loop;
use super::metric::{Reduction, StructureMetric};
use super::metric_values::{MetricContext, Recorded};
use crate::metrics::measured as reduce;
use crate::metrics::structure::{peak, rms_error};

/// The value of a metric that compares with what was measured; `None` where it is undefined.
pub fn value(metric: &StructureMetric, of: MetricContext, computed: &Recorded) -> Option<f64> {
    let compared = of.compared?;
    let times = compared.times();
    let pair = |channel: &Channel| {
        let steps = computed.channel(channel, of.numbering);
        let c = reduce::at_times(&steps, of.dt, &times)?;
        Some((c, compared.values(channel)?))
    };
    if metric.reduction == Reduction::EnergyPerCycle {
        let [r, s] = measured_loop(metric.contact?);
        let ((r, m_r), (s, m_s)) = (pair(&r)?, pair(&s)?);
        return reduce::energy_per_cycle_error([&r, &s], [m_r, m_s]);
    }
    let (c, m) = pair(metric.channel.as_ref()?)?;
    let sprague_geers = || reduce::sprague_geers(&times, &c, m);
    match metric.reduction {
        Reduction::RmsError => Some(rms_error(&c, m)),
        Reduction::LastError => Some((c.last()? - m.last()?).abs()),
        Reduction::PeakError => Some((peak(&c) - peak(m)).abs()),
        Reduction::SpragueGeersMagnitude => Some(sprague_geers()?.magnitude),
        Reduction::SpragueGeersPhase => Some(sprague_geers()?.phase),
        Reduction::SpragueGeersCombined => Some(sprague_geers()?.combined),
        Reduction::LoopDistance => {
            let (second, m_second) = pair(metric.second.as_ref()?)?;
            reduce::loop_distance([&c, &second], [m, m_second])
        }
        _ => None,
    }
}
