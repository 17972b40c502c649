//! The friction law of a case.

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
    Some(match LawName::parse(case.name_at(rows::LAW))? {
        LawName::DisplacementControl => {
            let compliance = number(rows::ALPHA)?;
            let law = DisplacementControl { compliance, limit };
            (ContactLaw::DisplacementControl(law), start()?)
        }
        LawName::VelocityControl => {
            let compliance = number(rows::BETA)?;
            let (ratio, rate) = (number(rows::NU_RATIO)?, number(rows::NU_RATE)?);
            let law = match ratio < 1.0 {
                true => ContactLaw::Bearing(Bearing {
                    compliance,
                    limit,
                    ratio,
                    rate,
                }),
                false => ContactLaw::VelocityControl(VelocityControl { compliance, limit }),
            };
            (law, 0.0)
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

/// Force S(0) at release.
fn release_force(initial_slip: InitialSlip, x0: f64) -> f64 {
    match initial_slip {
        InitialSlip::Unloaded => 0.0,
        InitialSlip::Pulled => x0.signum(),
        InitialSlip::Sliding => -x0.signum(),
    }
}
