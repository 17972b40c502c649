//! Numbers of a study that are allowed and unlikely.

use super::doubt::Doubt;
use super::masses::Masses;
use crate::problem::Case;
use crate::problem::numbers::short::short;
use crate::problem::numbers::unit::{Dimension, WAVE_SPEEDS};
use crate::problem::structure::given::amount::Amount;
use crate::problem::structure::metrics::unit_consistency::size_of;
use crate::problem::structure::metrics::unit_names::UnitNames;
use crate::problem::structure::parts::contact_law::law_named;
use crate::problem::structure::parts::damping::{ModalDamping, Rayleigh};
use crate::problem::structure::parts::template::{SpringNumbers, Template};
use crate::solve::Warning;
use crate::system::structure::{Baseline, Direction, Signal};

/// Part of a mass by which a spring's may differ from it: masses are rounded.
const ROUNDED: f64 = 0.01;

/// Factor by which `colliding_mass` is far from a mass.
const FAR: f64 = 2.0;

/// Above it, a coefficient of friction is one in percent.
const COEFFICIENT: f64 = 2.0;

/// Radius of a pendulum in m: those of bearings are below 10 m, those of domes below 100 m.
const RADIUS: f64 = 100.0;

/// Period of a spring in s, below which it is one in another unit.
const SHORT: f64 = 0.01;

/// A spring with a period below 0.01 s, if the units say so.
pub fn spring_period(template: &Template, case: &Case) -> Option<Doubt> {
    if template.units.is_empty() {
        return None;
    }
    template.springs.iter().find_map(|spring| {
        let SpringNumbers::Period { period, .. } = &spring.numbers else {
            return None;
        };
        let seconds = period
            .value(case)
            .ok()
            .filter(|period| (0.0..SHORT).contains(period))?;
        let text = format!("{} is {} s", period.path, short(seconds));
        Some((Warning::SpringPeriod, text))
    })
}

/// A spring whose mass is not that of its nodes.
pub fn spring_mass(template: &Template, case: &Case, masses: &Masses) -> Option<Doubt> {
    let mut springs = template.springs.iter();
    springs.find_map(|spring| {
        let SpringNumbers::Period { mass, .. } = &spring.numbers else {
            return None;
        };
        let m = mass.value(case).ok()?;
        let [low, _, high] = masses.along(&spring.along, case)?;
        let fits = ((1.0 - ROUNDED) * low..=(1.0 + ROUNDED) * high).contains(&m);
        let text = || format!("{} is {}, {}", mass.path, short(m), between([low, high]));
        (!fits).then(|| (Warning::SpringMass, text()))
    })
}

/// `the nodes have 5` or `the nodes have 5 to 7`.
fn between([low, high]: [f64; 2]) -> String {
    match short(low) == short(high) {
        true => format!("the nodes have {}", short(low)),
        false => format!("the nodes have {} to {}", short(low), short(high)),
    }
}

/// A damping ratio above 1.
pub fn damping_ratio(template: &Template, case: &Case) -> Option<Doubt> {
    let ratios = template
        .springs
        .iter()
        .filter_map(|spring| match &spring.numbers {
            SpringNumbers::Period { ratio, .. } => ratio.as_ref(),
            SpringNumbers::Stiffness { .. } => None,
        });
    let modal = template.modal_damping.iter();
    let with_modal = ratios.chain(modal.flat_map(ModalDamping::amounts));
    let mut ratios = with_modal.chain(match &template.rayleigh {
        Rayleigh::Factors(_) => &[][..],
        Rayleigh::Ratios { ratios, .. } => ratios,
    });
    ratios.find_map(|ratio| {
        let value = ratio.value(case).ok().filter(|x| *x > 1.0)?;
        let text = format!("{} is {}", ratio.path, short(value));
        Some((Warning::DampingRatio, text))
    })
}

/// A pendulum with a radius above 100 m, if the units say so.
pub fn radius(template: &Template, case: &Case) -> Option<Doubt> {
    if template.units.is_empty() {
        return None;
    }
    template.contacts.iter().find_map(|contact| {
        law_named(contact.law.name(case)).filter(|law| law.has("R"))?;
        let radius = contact.number("R")?;
        let metres = radius.value(case).ok()? * template.metre;
        let text = || format!("{} is {} m", radius.path, short(metres));
        (metres > RADIUS).then(|| (Warning::LargeRadius, text()))
    })
}

/// A support with a sine acceleration from rest, whose velocity has a mean.
pub fn support_drift(template: &Template, case: &Case, end: f64) -> Option<Doubt> {
    template.supports.iter().find_map(|support| {
        let acceleration = support.acceleration()?;
        let signal = acceleration.source.signal(case, template.metre).ok()?;
        let Signal::Sine {
            omega,
            phase,
            amplitude,
        } = *signal
        else {
            return None;
        };
        // v(t) = (cos(phase) - cos(omega t + phase)) amplitude/omega; u oscillates by amplitude/omega^2.
        let drift = (libm::cos(phase) * omega * end).abs();
        let is_removed = support.baseline != Baseline::None;
        (amplitude != 0.0 && drift > 1.0 && !is_removed).then(|| {
            let text = format!(
                "support {} drifts by {} times the amplitude of its displacement",
                support.full_name(),
                short((drift * 10.0).round() / 10.0)
            );
            (Warning::SupportDrift, text)
        })
    })
}

/// A coefficient of friction above 2.
pub fn friction_coefficient(template: &Template, case: &Case) -> Option<Doubt> {
    let mut contacts = template.contacts.iter();
    contacts.find_map(|contact| {
        law_named(contact.law.name(case)).filter(|law| law.has("nu"))?;
        let nu = contact.number("nu")?;
        let value = nu.value(case).ok().filter(|x| *x > COEFFICIENT)?;
        let text = format!("{} is {}", nu.path, short(value));
        Some((Warning::FrictionCoefficient, text))
    })
}

/// A colliding mass that is far from that of the nodes.
pub fn colliding_mass(template: &Template, case: &Case, masses: &Masses) -> Option<Doubt> {
    let mut contacts = template.contacts.iter();
    contacts.find_map(|contact| {
        law_named(contact.law.name(case)).filter(|law| law.has("colliding_mass"))?;
        let mass = contact.number("colliding_mass")?;
        let m = mass.value(case).ok()?;
        let [low, high, _] = masses.along(&contact.along, case)?;
        let fits = (low / FAR..=high * FAR).contains(&m);
        let text = || format!("{} is {}, {}", mass.path, short(m), between([low, high]));
        (!fits).then(|| (Warning::CollidingMass, text()))
    })
}

/// Gravity in a direction in which no node moves.
pub fn idle_gravity(template: &Template, case: &Case) -> Option<Doubt> {
    let moves = |direction: Direction| {
        let masses = template.masses.iter().map(|mass| mass.direction);
        let bars = template.bars.iter().map(|bar| bar.direction);
        let blocks = template.matrices.iter();
        let rows =
            blocks.flat_map(|block| block.imported.dofs.rows().iter().map(|dof| dof.direction));
        masses
            .chain(bars)
            .chain(rows)
            .any(|moving| moving == direction)
    };
    template.gravities().find_map(|(direction, amount)| {
        let acts = amount.value(case).is_ok_and(|value| value != 0.0);
        let text = || format!("no node moves in {}", direction.name());
        (acts && !moves(direction)).then(|| (Warning::IdleGravity, text()))
    })
}

/// A bar of no known material, if the units say so.
pub fn wave_speed(template: &Template, case: &Case) -> Option<Doubt> {
    let units = UnitNames::of(&template.units)?;
    let unit = size_of(
        &units.of_dimension(Dimension::Velocity),
        Dimension::Velocity,
    )?;
    let mut bars = template.bars.iter();
    bars.find_map(|bar| {
        let value = |amount: &Amount| amount.value(case).ok();
        let (stiffness, mass) = (value(&bar.stiffness)?, value(&bar.mass)?);
        let speed = (stiffness * value(&bar.length)? / mass).sqrt() * unit;
        let text = || format!("bar {} has {} m/s", bar.name, short(speed));
        // A rigid bar is one stiff element.
        let is_rigid = value(&bar.elements)? == 1.0 && speed > WAVE_SPEEDS[1];
        let fits = is_rigid || (WAVE_SPEEDS[0]..=WAVE_SPEEDS[1]).contains(&speed);
        (!fits).then(|| (Warning::WaveSpeed, text()))
    })
}
