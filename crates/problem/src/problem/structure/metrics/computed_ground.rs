//! The part of the motion of the ground or of a support that a case computes: its accelerations at the steps up to `duration`.

use crate::problem::Case;
use crate::problem::numbers::short::short;
use crate::problem::structure::given::scale_to::RATIO;
use crate::problem::structure::given::shape::Scaled;
use crate::problem::structure::given::source::Kind;
use crate::problem::structure::given::supports::{Course, Points, Support};
use crate::problem::structure::parts::contact::Normal;
use crate::problem::structure::parts::template::Template;
use crate::solve::Warning;
use crate::system::loads::STANDARD_GRAVITY;
use crate::system::loads::measures::Measure;
use crate::system::loads::spectrum::{Ordinate, spectrum};
use crate::system::structure::{Quantity, Signal, Table};
use std::f64::consts::PI;

/// Share of the peak, of the Arias intensity and of the target of a motion that is to be computed.
pub const ENOUGH: f64 = 0.95;

/// The steps of a case: their length and the number of the last one.
#[derive(Debug, Clone, Copy)]
pub struct Steps {
    /// dt.
    pub dt: f64,
    /// The number of the last step.
    pub last: usize,
}

impl Steps {
    /// The times of all steps, 0 included.
    pub fn times(self) -> impl Iterator<Item = f64> {
        (0..=self.last).map(move |i| i as f64 * self.dt)
    }
}

/// The accelerations of a motion at the steps of a case; `None` if a number of it breaks a rule.
pub fn at_steps(motion: &Scaled, case: &Case, metre: f64, steps: Steps) -> Option<Table> {
    later(motion, case, metre, (0.0, steps))
}

/// The accelerations of a motion that comes later by `delay`, at the steps of a case.
fn later(motion: &Scaled, case: &Case, metre: f64, (delay, steps): (f64, Steps)) -> Option<Table> {
    let (signal, scale) = motion.in_case(case, metre).ok()?;
    let mut times: Vec<f64> = steps.times().collect();
    let value = |t: &f64| match *t < delay {
        true => 0.0,
        false => scale * signal.at(t - delay),
    };
    let mut values: Vec<f64> = times.iter().map(value).collect();
    // The motion stops: a table goes on with its last value, and an oscillator would feel that for ever.
    times.push(*times.last()?);
    values.push(0.0);
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

/// A motion of which too little is computed: a recorded one, or one with a strength that it then has not.
pub fn cut(template: &Template, case: &Case, steps: Steps) -> Option<(Warning, String)> {
    let motions = template.ground.iter();
    let ground = motions.map(|motion| (format!("ground in {}", motion.0.name()), &motion.1, 0.0));
    let supports = template.supports.iter().filter_map(|support| {
        let amount = support.delay.as_ref();
        let delay = amount.map_or(Some(0.0), |amount| amount.value(case).ok())?;
        let name = format!("support {}", support.full_name());
        Some((name, support.acceleration()?, delay))
    });
    let contacts = template.contacts.iter();
    let vertical = contacts.filter_map(|contact| match &contact.normal {
        Some(Normal::Weight { vertical, .. }) => {
            Some((format!("N of contact {}", contact.name), vertical, 0.0))
        }
        _ => None,
    });
    let mut motions = ground.chain(supports).chain(vertical);
    let accelerations = motions.find_map(|(name, motion, delay)| {
        let parts = lost(motion, case, template.metre, (delay, steps))?;
        Some(format!("{name}: {parts}"))
    });
    let displacements = || {
        let mut supports = template.supports.iter();
        supports.find_map(|support| {
            let parts = lost_displacement(support, case, template.metre, steps)?;
            Some(format!("support {}: {parts}", support.full_name()))
        })
    };
    let text = accelerations.or_else(displacements)?;
    Some((Warning::MotionCut, text))
}

/// What a recorded acceleration has lost, and another one of the strength that it is scaled to; `None` if it is little.
fn lost(motion: &Scaled, case: &Case, metre: f64, (delay, steps): (f64, Steps)) -> Option<String> {
    let is_record = matches!(motion.source.kind(), Kind::Record { .. });
    let goal = motion.shape.scale_to.as_ref();
    if !is_record && goal.is_none() {
        return None;
    }
    let (signal, scale) = motion.in_case(case, metre).ok()?;
    let Signal::Table(table) = &*signal else {
        return None;
    };
    let whole = table.clone().scaled(scale)?;
    let part = later(motion, case, metre, (delay, steps))?;
    let both = [&whole, &part];
    let gravity = STANDARD_GRAVITY / metre;
    let peak = |table: &Table| Measure::PeakAcceleration.of(table, gravity);
    let arias = |table: &Table| Some(intensity(table) * PI / 2.0 / gravity);
    let (periods, ratio) = goal.map_or(Some((Vec::new(), RATIO)), |goal| goal.periods(case))?;
    let spectral = |table: &Table| {
        let ordinates = spectrum(table, &periods, ratio).filter(|found| !found.is_empty())?;
        let sum: f64 = ordinates.iter().map(Ordinate::pseudo_acceleration).sum();
        Some(sum / ordinates.len() as f64)
    };
    let strengths = [
        ("pga", is_record || periods.is_empty(), both.map(peak)),
        ("Arias intensity", is_record, both.map(arias)),
        ("Sa", true, both.map(spectral)),
    ];
    let wanted = strengths.into_iter().filter(|row| row.1);
    compared(&wanted.map(|row| (row.0, row.2)).collect::<Vec<_>>())
}

/// What a recorded displacement of a support has lost; `None` if it is little.
fn lost_displacement(support: &Support, case: &Case, metre: f64, steps: Steps) -> Option<String> {
    let Course::Displacement(Points::File(file, files, _), _) = &support.course else {
        return None;
    };
    let name = file.name(case);
    let [times, _] = &*files.iter().find(|file| file.0 == name)?.1;
    let amount = support.delay.as_ref();
    let delay = amount.map_or(Some(0.0), |amount| amount.value(case).ok())?;
    let motion = support.in_case(case, metre, true).ok()?;
    let size = |t: f64| motion.quantity(Quantity::Displacement, t).abs();
    let both = [
        times
            .iter()
            .fold(0.0, |most: f64, t| most.max(size(t + delay))),
        steps.times().fold(0.0, |most: f64, t| most.max(size(t))),
    ];
    compared(&[("largest displacement", both.map(Some))])
}

/// The measures of which the part has too little of the whole.
fn compared(all: &[(&str, [Option<f64>; 2])]) -> Option<String> {
    let small_parts = all.iter().filter_map(|(what, [whole, part])| {
        let (whole, part) = ((*whole)?, part.unwrap_or(0.0));
        (part < ENOUGH * whole).then(|| format!("{what} {} of {}", short(part), short(whole)))
    });
    let parts: Vec<String> = small_parts.collect();
    (!parts.is_empty()).then(|| parts.join(", "))
}

/// The integral of the square of straight lines, which does not depend on how many points a line has.
fn intensity(table: &Table) -> f64 {
    let (t, a) = (table.times(), table.values());
    let squares = |i: usize| a[i - 1] * a[i - 1] + a[i - 1] * a[i] + a[i] * a[i];
    (1..t.len())
        .map(|i| (t[i] - t[i - 1]) * squares(i) / 3.0)
        .sum()
}
