//! The part of the motion of the ground or of a support that a case computes: its accelerations at the steps up to `duration`.

use super::describe::short;
use super::loads::Kind;
use super::scale_to::{Goal, RATIO};
use super::template::{Scaled, Template};
use crate::problem::Case;
use crate::solve::Warning;
use crate::system::loads::STANDARD_GRAVITY;
use crate::system::loads::measures::Measure;
use crate::system::structure::{Signal, Table};
use std::f64::consts::PI;

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

/// A recorded motion of which too little is computed.
pub fn cut(template: &Template, case: &Case, steps: Steps) -> Option<(Warning, String)> {
    let metre = template.metre;
    let ground = template.ground.iter();
    let ground = ground.map(|own| (format!("ground in {}", own.0.name()), &own.1));
    let supports = template.supports.iter();
    let supports = supports
        .filter_map(|own| Some((format!("support {}", own.full_name()), own.acceleration()?)));
    ground.chain(supports).find_map(|(name, motion)| {
        if !matches!(motion.source.kind(), Kind::Record { .. }) {
            return None;
        }
        let (signal, scale) = motion.in_case(case, metre).ok()?;
        let Signal::Table(table) = &*signal else {
            return None;
        };
        let whole = table.clone().scaled(scale)?;
        let part = at_steps(motion, case, metre, steps)?;
        let target = match motion.shape.scale_to.as_ref().map(|own| &own.goal) {
            Some(Goal::Spectral { period, ratio, .. }) => Some(Measure::Spectral {
                period: period.value(case).ok()?,
                ratio: ratio
                    .as_ref()
                    .map_or(Some(RATIO), |own| own.value(case).ok())?,
            }),
            _ => None,
        };
        let of = |measure: Measure, table: &Table| measure.of(table, STANDARD_GRAVITY / metre);
        let peak = |table: &Table| of(Measure::PeakAcceleration, table);
        let all = [
            ("pga", [&whole, &part].map(peak)),
            (
                "Arias intensity",
                [&whole, &part]
                    .map(|own| Some(intensity(own) * PI / 2.0 / STANDARD_GRAVITY * metre)),
            ),
            ("Sa", [&whole, &part].map(|own| of(target?, own))),
        ];
        let parts = all.iter().filter_map(|(what, [whole, part])| {
            let (whole, part) = ((*whole)?, part.unwrap_or(0.0));
            (part < ENOUGH * whole).then(|| format!("{what} {} of {}", short(part), short(whole)))
        });
        let parts: Vec<String> = parts.collect();
        (!parts.is_empty()).then(|| (Warning::MotionCut, format!("{name}: {}", parts.join(", "))))
    })
}

/// The integral of the square of straight lines, which does not depend on how many points a line has.
fn intensity(table: &Table) -> f64 {
    let (t, a) = (table.times(), table.values());
    let squares = |i: usize| a[i - 1] * a[i - 1] + a[i - 1] * a[i] + a[i] * a[i];
    (1..t.len())
        .map(|i| (t[i] - t[i - 1]) * squares(i) / 3.0)
        .sum()
}
