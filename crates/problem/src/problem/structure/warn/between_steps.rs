//! What loads and motions do between steps that the steps do not have.

use super::doubt::Doubt;
use crate::problem::Case;
use crate::problem::numbers::short::short;
use crate::problem::structure::given::shape::Scaled;
use crate::problem::structure::given::source::{Kind, Source};
use crate::problem::structure::given::supports::{Course, Points};
use crate::problem::structure::metrics::computed_ground::{ENOUGH, Steps};
use crate::problem::structure::parts::contact::Normal;
use crate::problem::structure::parts::template::Template;
use crate::solve::Warning;
use crate::system::structure::Signal;

/// A function of time of a structure.
struct Function<'a> {
    name: String,
    source: &'a Source,
    /// Whether a part of it, from another time on, is chosen.
    is_cut: bool,
    /// Whether its records are looked at: [`computed_ground::cut`] has those of motions.
    ///
    /// [`computed_ground::cut`]: super::super::metrics::computed_ground::cut
    records: bool,
}

fn scaled(name: String, given: &Scaled, records: bool) -> Function<'_> {
    Function {
        name,
        source: &given.source,
        is_cut: given.shape.start.is_some(),
        records,
    }
}

/// The loads, motions and N that are functions of time.
fn functions(template: &Template) -> impl Iterator<Item = Function<'_>> {
    let given = template.loads.iter().enumerate();
    let loads = given.map(|(number, load)| scaled(format!("loads[{number}]"), &load.force, true));
    let motions = template.ground.iter();
    let ground =
        motions.map(|motion| scaled(format!("ground in {}", motion.0.name()), &motion.1, false));
    let accelerated = template.supports.iter().filter_map(|support| {
        let name = format!("support {}", support.full_name());
        Some(scaled(name, support.acceleration()?, false))
    });
    let normals = template.contacts.iter().filter_map(|contact| {
        let name = format!("N of contact {}", contact.name);
        match contact.normal.as_ref()? {
            Normal::Table(source) => Some(Function {
                name,
                source,
                is_cut: false,
                records: true,
            }),
            Normal::Weight { vertical, .. } => Some(scaled(name, vertical, false)),
            Normal::Constant(_) | Normal::Parts(_) => None,
        }
    });
    loads.chain(ground).chain(accelerated).chain(normals)
}

/// The first load, motion or N of which the steps have too little.
pub fn missed(template: &Template, case: &Case, steps: Steps) -> Option<Doubt> {
    let found = functions(template).find_map(|function| {
        let text = of_source(
            function.source,
            function.records,
            case,
            (template.metre, steps),
        )?;
        Some(format!("{}: {text}", function.name))
    });
    let text = found.or_else(|| displaced(template, case, steps))?;
    Some((Warning::MotionCut, text))
}

/// The first load, motion or N by points of the study that begins before t = 0; of files, notes of their reader tell it.
pub fn before(template: &Template, case: &Case) -> Option<Doubt> {
    let begins = |function: &Function| {
        let signal = function.source.signal(case, template.metre).ok()?;
        match &*signal {
            Signal::Table(table) if !function.is_cut => table.times().first().copied(),
            Signal::Table(_) | Signal::Sine { .. } | Signal::Motion(..) => None,
        }
    };
    let is_given = |function: &Function| matches!(function.source.kind(), Kind::Table { .. });
    let mut tables = functions(template).filter(is_given);
    let found =
        tables.find_map(|function| Some((begins(&function).filter(|t| *t < 0.0)?, function.name)));
    let displaced = || {
        template.supports.iter().find_map(|support| {
            let Course::Displacement(Points::List(..), _) = &support.course else {
                return None;
            };
            let motion = support.in_case(case, template.metre, true).ok()?;
            let first = motion.points().into_iter().next().filter(|t| *t < 0.0)?;
            Some((first, format!("support {}", support.full_name())))
        })
    };
    let (first, name) = found.or_else(displaced)?;
    Some((
        Warning::TimeBefore,
        format!("{name} begins at {}", short(first)),
    ))
}

fn of_source(
    source: &Source,
    records: bool,
    case: &Case,
    (metre, steps): (f64, Steps),
) -> Option<String> {
    let looked_at = match source.kind() {
        Kind::Record { .. } => records,
        Kind::Sine { .. } | Kind::Table { .. } | Kind::Pulse(..) => true,
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
    template.supports.iter().find_map(|support| {
        // The velocity of a file is mostly noise.
        let Course::Displacement(Points::List(..), _) = &support.course else {
            return None;
        };
        let motion = support.in_case(case, template.metre, true).ok()?;
        let end = steps.last as f64 * steps.dt;
        let points = motion.points().into_iter().filter(|time| *time <= end);
        let times: Vec<f64> = points.collect();
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
        Some(format!("support {}: {text}", support.full_name()))
    })
}

fn less(what: &str, [whole, part]: [f64; 2]) -> Option<String> {
    let little = part < ENOUGH * whole;
    little.then(|| format!("{what} {} of {} at the steps", short(part), short(whole)))
}
