//! Metrics that compare with what was measured.

use super::recorded::{MetricContext, Recorded};
use super::sweep::Ready;
use crate::metrics::measured as reduce;
use crate::metrics::structure::{peak, rms_error};
use crate::problem::structure::StructureProblem;
use crate::problem::structure::channels::channel::Channel;
use crate::problem::structure::channels::measured::{Compared, measured_loop};
use crate::problem::structure::metrics::metric::StructureMetric;
use crate::problem::structure::metrics::reduction::Reduction;
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
