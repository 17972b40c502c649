//! The acceleration of the ground in a case, for response spectra.

use crate::problem::Case;
use crate::problem::numbers::short::short;
use crate::problem::structure::given::motion_set::SetSpectra;
use crate::problem::structure::given::shape::Scaled;
use crate::problem::structure::given::source::Kind;
use crate::problem::structure::metrics::computed_ground::{Steps, measured};
use crate::problem::structure::metrics::unit_names::UnitNames;
use crate::problem::structure::parts::template::Template;
use crate::system::loads::measures::Measure;
use crate::system::structure::{Direction, Signal, Table};
use std::f64::consts::PI;

/// The acceleration of the ground in a case.
#[derive(Debug, Clone, PartialEq)]
pub struct GroundMotion {
    /// The acceleration: straight between its points.
    pub acceleration: Table,
    /// Units of length and time, as the study writes them; empty if it does not.
    pub units: [String; 2],
}

/// Points of a sine in a period: chords are below the curve by at most (2 pi/400)^2/8 = 3e-5 of the amplitude.
const POINTS: f64 = 400.0;

/// Most points of a sine.
const MOST: f64 = 1e6;

/// The recorded and changed motions of the ground in a case, one line each: the file, the factor of its strength, and the measures of
/// its computed part.
pub fn described(template: &Template, case: &Case, steps: Steps) -> String {
    let line = |(direction, ground): &(Direction, Scaled)| {
        let file = match ground.source.kind() {
            Kind::Record { name, .. } => format!(" {},", name.name(case)),
            _ if ground.shape.is_plain() => return None,
            Kind::Sine { .. } | Kind::Table { .. } | Kind::Pulse(..) | Kind::Synthetic { .. } => {
                String::new()
            }
        };
        let (_, factor) = ground.in_case(case, template.metre).ok()?;
        let measure = |measure| measured(ground, measure, case, template.metre, steps);
        let pga = measure(Measure::PeakAcceleration)?;
        let pgv = measure(Measure::PeakVelocity)?;
        let duration = measure(Measure::Duration)?;
        Some(format!(
            "ground in {}:{file} factor {}, pga {}, pgv {}, d5_95 {}\n",
            direction.name(),
            short(factor),
            short(pga),
            short(pgv),
            short(duration)
        ))
    };
    let motions = template.ground.iter().filter_map(line);
    motions.chain(described_set(template, case)).collect()
}

/// The set of the ground in a case, in a line.
fn described_set(template: &Template, case: &Case) -> Option<String> {
    let (motion, set) = template.set()?;
    let state = motion.set_state(case, template.metre)?;
    let rule = set.rule.map_or(String::new(), |rule| format!(" {rule},"));
    Some(format!(
        "set of {} motions:{rule} factor {}, least ratio {} at T = {}\n",
        set.members.len(),
        short(state.factor),
        short(state.ratio),
        short(state.period)
    ))
}

/// The spectra of the set of the ground at these periods in a case.
pub fn set_spectra(template: &Template, case: &Case, periods: &[f64]) -> Option<SetSpectra> {
    let (motion, _) = template.set()?;
    motion.set_spectra(periods, case, template.metre)
}

/// Units of length and time, as the study writes them; empty if it does not.
pub fn units(template: &Template) -> [String; 2] {
    let names = UnitNames::of(&template.units);
    let units = names.map(|units| [units.length, units.time].map(str::to_owned));
    units.unwrap_or_default()
}

/// The ground motion of a case; `None` without one, or if a number of it breaks a rule. A sine acts until the end of the case.
pub fn ground_motion(template: &Template, case: &Case, duration: f64) -> Option<GroundMotion> {
    // Of several directions the first.
    let (_, ground) = template.ground.first()?;
    let (signal, scale) = ground.in_case(case, template.metre).ok()?;
    let acceleration = match &*signal {
        Signal::Table(table) => table.clone().scaled(scale)?,
        Signal::Motion(..) => return None,
        Signal::Sine { omega, .. } => {
            let points = (duration * omega.abs() / (2.0 * PI) * POINTS)
                .ceil()
                .max(POINTS);
            if points.is_nan() || points > MOST {
                return None;
            }
            let time = |i: usize| duration * i as f64 / points;
            let mut times: Vec<f64> = (0..=points as usize).map(time).collect();
            let mut values: Vec<f64> = times.iter().map(|t| scale * signal.at(*t)).collect();
            // The ground stops.
            times.push(duration);
            values.push(0.0);
            Table::new(times, values)?
        }
    };
    Some(GroundMotion {
        acceleration,
        units: units(template),
    })
}
