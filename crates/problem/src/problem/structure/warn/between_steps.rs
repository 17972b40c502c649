//! What loads and motions do between steps that the steps do not have.

use super::doubt::Doubt;
use crate::problem::Case;
use crate::problem::structure::given::loads::{Kind, Source};
use crate::problem::structure::given::short::short;
use crate::problem::structure::given::supports::{Course, Points};
use crate::problem::structure::metrics::computed_ground::{ENOUGH, Steps};
use crate::problem::structure::parts::contact::Normal;
use crate::problem::structure::parts::template::Template;
use crate::solve::Warning;
use crate::system::structure::Signal;

/// The first load, motion or N of which the steps have too little. [`computed_ground::cut`] has the records of motions.
///
/// [`computed_ground::cut`]: super::super::metrics::computed_ground::cut
pub fn missed(template: &Template, case: &Case, steps: Steps) -> Option<Doubt> {
    let loads = template.loads.iter().enumerate();
    let loads = loads.map(|(number, load)| (format!("loads[{number}]"), &load.force.source, true));
    let ground = template.ground.iter();
    let ground = ground.map(|own| (format!("ground in {}", own.0.name()), &own.1.source, false));
    let accelerated = template.supports.iter().filter_map(|own| {
        let name = format!("support {}", own.full_name());
        Some((name, &own.acceleration()?.source, false))
    });
    let normals = template.contacts.iter().filter_map(|own| {
        let (source, records) = match own.normal.as_ref()? {
            Normal::Table(source) => (source, true),
            Normal::Weight { vertical, .. } => (&vertical.source, false),
            Normal::Constant(_) | Normal::Parts(_) => return None,
        };
        Some((format!("N of contact {}", own.name), source, records))
    });
    let mut all = loads.chain(ground).chain(accelerated).chain(normals);
    let found = all.find_map(|(name, source, records)| {
        let text = of_source(source, records, case, (template.metre, steps))?;
        Some(format!("{name}: {text}"))
    });
    let text = found.or_else(|| displaced(template, case, steps))?;
    Some((Warning::MotionCut, text))
}

fn of_source(
    source: &Source,
    records: bool,
    case: &Case,
    (metre, steps): (f64, Steps),
) -> Option<String> {
    let looked_at = match source.kind() {
        Kind::Record { .. } => records,
        Kind::Sine { .. } | Kind::Table { .. } | Kind::Ricker { .. } | Kind::Cosine { .. } => true,
        Kind::Synthetic { .. } => false,
    };
    if !looked_at {
        return None;
    }
    match &*source.signal(case, metre).ok()? {
        Signal::Sine { omega, .. } => {
            // The mean of both ends over the mean of the step.
            let half = 0.5 * omega.abs() * steps.dt;
            let resolved = half == 0.0 || (half < 1.5 && half / libm::tan(half) >= ENOUGH);
            let count = std::f64::consts::PI / half;
            (!resolved).then(|| format!("{} steps in a period of its sine", short(count)))
        }
        Signal::Table(table) => {
            let end = steps.last as f64 * steps.dt;
            let points = table.times().iter().zip(table.values());
            let within = points.filter(|(time, _)| (0.0..=end).contains(*time));
            let whole = within.fold(0.0, |most: f64, (_, value)| most.max(value.abs()));
            let part = steps.times().map(|t| table.at(t).abs());
            less("largest value", [whole, part.fold(0.0, f64::max)])
        }
        Signal::Motion(..) => None,
    }
}

/// A support whose given displacement has a larger value or velocity between steps.
fn displaced(template: &Template, case: &Case, steps: Steps) -> Option<String> {
    template.supports.iter().find_map(|own| {
        // The velocity of a file is mostly noise.
        let Course::Displacement(Points::List(_), _) = &own.course else {
            return None;
        };
        let motion = own.in_case(case, template.metre, true).ok()?;
        let end = steps.last as f64 * steps.dt;
        let times = motion.points().into_iter().filter(|time| *time <= end);
        let times: Vec<f64> = times.collect();
        // The velocity of a cubic is largest in its middle or at an end.
        let middles = times.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
        let largest = |which: usize, times: &mut dyn Iterator<Item = f64>| {
            times.fold(0.0, |most: f64, t| most.max(motion.at(t)[which].abs()))
        };
        let names = ["largest displacement", "largest velocity"];
        let text = names.into_iter().enumerate().find_map(|(which, name)| {
            let whole = largest(which, &mut times.iter().copied().chain(middles.clone()));
            less(name, [whole, largest(which, &mut steps.times())])
        })?;
        Some(format!("support {}: {text}", own.full_name()))
    })
}

fn less(what: &str, [whole, part]: [f64; 2]) -> Option<String> {
    let little = part < ENOUGH * whole;
    little.then(|| format!("{what} {} of {} at the steps", short(part), short(whole)))
}
