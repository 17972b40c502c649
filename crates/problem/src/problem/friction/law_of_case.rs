//! The friction law of a case.

use super::tables::{InitialSlip, SCHEMA, rows};
use crate::contact::offer::Place;
use crate::contact::{ContactLaw, Described, DisplacementControl, GivenNumbers, VelocityControl};
use crate::problem::Case;
use crate::problem::offered_laws::Own;
use std::sync::LazyLock;

/// The friction limit nu N in the problem's scales.
const LIMIT: f64 = 1.0;

static OWN: LazyLock<Vec<Own>> = LazyLock::new(|| Own::all(Place::Oscillator, &SCHEMA.parameters));

/// The law of a case, and S(0); `None` if a parameter is not given.
pub fn law(case: &Case) -> Option<(ContactLaw, f64)> {
    // The same without the detour by the names of numbers, which costs a case as much as ten of its steps.
    if let Some(name) = PlainLawName::of(case) {
        let (law, force) = plain_law(name, case)?;
        return Some((law.into(), force));
    }
    let law = Own::named(&OWN, case.name_at(rows::LAW))?;
    let force = match law.offered.of_velocity {
        true => 0.0,
        false => {
            let slip = InitialSlip::parse(case.name_at(rows::INITIAL_SLIP))?;
            release_force(slip, case.at(rows::X0)?)
        }
    };
    let form_of = |given: &GivenNumbers| (law.offered.offer.form)(given).ok();
    let form = law.make(|_, row| case.at(row), &[("limit", LIMIT)], form_of)?;
    Some((form.given.law().at_limit(LIMIT), force))
}

/// Which law of `[F]` a case has.
#[derive(Debug, Clone, Copy)]
pub enum PlainLawName {
    Displacement(InitialSlip),
    Velocity,
}

impl PlainLawName {
    /// The parameters that it depends on.
    pub const ROWS: [usize; 3] = [rows::LAW, rows::INITIAL_SLIP, rows::NU_RATIO];

    /// `None` for another law.
    pub fn of(case: &Case) -> Option<PlainLawName> {
        match case.name_at(rows::LAW) {
            DisplacementControl::NAME => {
                let slip = InitialSlip::parse(case.name_at(rows::INITIAL_SLIP))?;
                Some(PlainLawName::Displacement(slip))
            }
            // With another ratio it is the law of a bearing.
            VelocityControl::NAME if case.at(rows::NU_RATIO)? == 1.0 => {
                Some(PlainLawName::Velocity)
            }
            _ => None,
        }
    }
}

/// This law of `[F]` with S(0); `None` if a parameter is not given.
#[inline(always)]
pub fn plain_law(name: PlainLawName, case: &Case) -> Option<(PlainLaw, f64)> {
    let limit = LIMIT;
    match name {
        PlainLawName::Displacement(slip) => {
            let compliance = case.at(rows::ALPHA)?;
            let law = DisplacementControl { compliance, limit };
            let force = release_force(slip, case.at(rows::X0)?);
            Some((PlainLaw::Displacement(law), force))
        }
        PlainLawName::Velocity => {
            let compliance = case.at(rows::BETA)?;
            let law = VelocityControl { compliance, limit };
            Some((PlainLaw::Velocity(law), 0.0))
        }
    }
}

/// Force S(0) at release.
fn release_force(initial_slip: InitialSlip, x0: f64) -> f64 {
    match initial_slip {
        InitialSlip::Unloaded => 0.0,
        InitialSlip::Pulled => x0.signum(),
        InitialSlip::Sliding => -x0.signum(),
    }
}

/// A law of `[F]`.
#[derive(Debug, Clone, Copy)]
pub enum PlainLaw {
    Displacement(DisplacementControl),
    Velocity(VelocityControl),
}

impl From<PlainLaw> for ContactLaw {
    #[inline(always)]
    fn from(law: PlainLaw) -> ContactLaw {
        match law {
            PlainLaw::Displacement(law) => law.into(),
            PlainLaw::Velocity(law) => law.into(),
        }
    }
}

impl PlainLaw {
    /// The same of any law; `None` for one that is not of `[F]`.
    pub fn of(law: &ContactLaw) -> Option<PlainLaw> {
        if let ContactLaw::DisplacementControl(law) = *law {
            return Some(PlainLaw::Displacement(law));
        }
        let ContactLaw::VelocityControl(law) = *law else {
            return None;
        };
        Some(PlainLaw::Velocity(law))
    }
}
