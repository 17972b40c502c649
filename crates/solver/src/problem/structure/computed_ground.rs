//! The part of the motion of the ground or of a support that a case computes: its accelerations at the steps up to `duration`.

use super::describe::short;
use super::loads::Kind;
use super::scale_to::{Goal, RATIO};
use super::template::{Scaled, Template};
use crate::problem::Case;
use crate::solve::Warning;
use crate::system::loads::STANDARD_GRAVITY;
use crate::system::loads::measures::Measure;
use crate::system::structure::Table;

/// Share of the peak, of the Arias intensity and of the target of a motion that is to be computed.
const ENOUGH: f64 = 0.95;

/// The steps of a case: their length and the number of the last one.
#[derive(Debug, Clone, Copy)]
pub struct Steps {
    /// dt.
    pub dt: f64,
    /// The number of the last step.
    pub last: usize,
}

/// The accelerations of a motion at the steps of a case; `None` if a number of it breaks a rule.
pub fn at_steps(motion: &Scaled, case: &Case, metre: f64, steps: Steps) -> Option<Table> {
    let (signal, scale) = motion.in_case(case, metre).ok()?;
    let times: Vec<f64> = (0..=steps.last).map(|i| i as f64 * steps.dt).collect();
    let values = times.iter().map(|t| scale * signal.at(*t)).collect();
    Table::new(times, values)
}

/// A measure of the computed part of a motion; `None` if it has none.
pub fn measured(
    motion: &Scaled,
    measure: Measure,
    case: &Case,
    metre: f64,
    steps: Steps,
) -> Option<f64> {
    measure.of(
        &at_steps(motion, case, metre, steps)?,
        STANDARD_GRAVITY / metre,
    )
}

/// A recorded or synthetic motion of which too little is computed.
pub fn cut(template: &Template, case: &Case, steps: Steps) -> Option<(Warning, String)> {
    let metre = template.metre;
    let ground = template.ground.iter();
    let ground =
        ground.map(|(direction, motion)| (format!("ground in {}", direction.name()), motion));
    let supports = template.supports.iter();
    let supports = supports
        .filter_map(|own| Some((format!("support {}", own.full_name()), own.acceleration()?)));
    ground.chain(supports).find_map(|(name, motion)| {
        if !matches!(
            motion.source.kind(),
            Kind::Record { .. } | Kind::Synthetic { .. }
        ) {
            return None;
        }
        let computed = at_steps(motion, case, metre, steps)?;
        let target = match motion.shape.scale_to.as_ref().map(|own| &own.goal) {
            Some(Goal::Spectral { period, ratio, .. }) => Some(Measure::Spectral {
                period: period.value(case).ok()?,
                ratio: ratio
                    .as_ref()
                    .map_or(Some(RATIO), |own| own.value(case).ok())?,
            }),
            _ => None,
        };
        let all = [
            ("pga", Some(Measure::PeakAcceleration)),
            ("Arias intensity", Some(Measure::Arias)),
            ("Sa", target),
        ];
        let parts = all.iter().filter_map(|(what, measure)| {
            let measure = (*measure)?;
            let whole = motion.measure(measure, case, metre).ok()??;
            let part = measure
                .of(&computed, STANDARD_GRAVITY / metre)
                .unwrap_or(0.0);
            (part < ENOUGH * whole).then(|| format!("{what} {} of {}", short(part), short(whole)))
        });
        let parts: Vec<String> = parts.collect();
        (!parts.is_empty()).then(|| (Warning::MotionCut, format!("{name}: {}", parts.join(", "))))
    })
}
