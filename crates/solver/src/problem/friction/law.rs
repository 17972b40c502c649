//! The friction law of a case.

use super::case::PlainLaw;
use super::tables::{InitialSlip, LawName, rows};
use crate::contact::{
    Bearing, BoucWen, ContactLaw, Dahl, DisplacementControl, Lugre, Stribeck, Tanh, VelocityControl,
};
use crate::problem::Case;

/// The friction limit nu N in the problem's scales.
const LIMIT: f64 = 1.0;

/// The law of a case, and S(0); `None` if a parameter is not given.
pub fn law(case: &Case) -> Option<(ContactLaw, f64)> {
    let limit = LIMIT;
    let number = |row| case.at(row);
    let start = || {
        let slip = InitialSlip::parse(case.name_at(rows::INITIAL_SLIP))?;
        Some(release_force(slip, number(rows::X0)?))
    };
    if let Some((law, force)) = PlainLawName::of(case).and_then(|name| plain_law(name, case)) {
        return Some((law.into(), force));
    }
    Some(match LawName::parse(case.name_at(rows::LAW))? {
        LawName::DisplacementControl => return None,
        LawName::VelocityControl => {
            let law = Bearing {
                compliance: number(rows::BETA)?,
                limit,
                ratio: number(rows::NU_RATIO)?,
                rate: number(rows::NU_RATE)?,
            };
            (ContactLaw::Bearing(law), 0.0)
        }
        LawName::Coulomb => {
            let compliance = 0.0;
            let law = VelocityControl { compliance, limit };
            (ContactLaw::VelocityControl(law), 0.0)
        }
        LawName::Tanh => {
            let law = Tanh {
                compliance: number(rows::BETA)?,
                limit,
                ratio: number(rows::NU_RATIO)?,
                rate: number(rows::NU_RATE)?,
            };
            (ContactLaw::Tanh(law), 0.0)
        }
        LawName::Stribeck => {
            // rdot^E is that of the static limit.
            let static_limit = limit * number(rows::STATIC_RATIO)?;
            let law = Stribeck {
                compliance: number(rows::BETA)? / static_limit,
                limit,
                static_limit,
                stribeck_velocity: number(rows::STRIBECK_VELOCITY)?,
            };
            (ContactLaw::Stribeck(law), 0.0)
        }
        LawName::BoucWen => {
            let law = BoucWen {
                compliance: number(rows::ALPHA)?,
                limit,
                exponent: number(rows::EXPONENT)?,
            };
            (ContactLaw::BoucWen(law), start()?)
        }
        LawName::Dahl => {
            let law = Dahl {
                compliance: number(rows::ALPHA)?,
                limit,
                exponent: number(rows::EXPONENT)?,
            };
            (ContactLaw::Dahl(law), start()?)
        }
        LawName::Lugre => {
            let law = Lugre {
                sigma0: number(rows::SIGMA0)?,
                sigma1: number(rows::SIGMA1)?,
                sigma2: number(rows::SIGMA2)?,
                limit,
                static_limit: limit * number(rows::STATIC_RATIO)?,
                stribeck_velocity: number(rows::STRIBECK_VELOCITY)?,
            };
            (ContactLaw::Lugre(law), start()?)
        }
    })
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
        match LawName::parse(case.name_at(rows::LAW))? {
            LawName::DisplacementControl => {
                let slip = InitialSlip::parse(case.name_at(rows::INITIAL_SLIP))?;
                Some(PlainLawName::Displacement(slip))
            }
            // With another ratio it is the law of a bearing.
            LawName::VelocityControl if case.at(rows::NU_RATIO)? == 1.0 => {
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
