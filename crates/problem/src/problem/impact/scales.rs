//! The scales of a case in the units of its parameters, the reverse of `scaled`.

use super::tables::{Opposite, rows};
use crate::problem::Case;
use crate::problem::numbers::short::short;
use crate::problem::numbers::unit::{Dimension, WAVE_SPEEDS};

/// T_I, c and F0 of a case.
pub struct Scales {
    time: f64,
    speed: f64,
    force: f64,
}

impl Scales {
    /// The scales of a completed case; `None` if a parameter is not given.
    pub fn new(case: &Case) -> Option<Scales> {
        let (e, rho) = (case.at(rows::E)?.sqrt(), case.at(rows::RHO)?.sqrt());
        let left = case.at(rows::A)? * e * rho;
        let (speed, impedance) = match Opposite::of(case) {
            Some(Opposite::Wall) => (case.at(rows::V0)?, left),
            None => {
                let (e, rho) = (case.at(rows::RIGHT_E)?, case.at(rows::RIGHT_RHO)?);
                let right = case.at(rows::RIGHT_A)? * e.sqrt() * rho.sqrt();
                let speed = case.at(rows::V0)? - case.at(rows::RIGHT_V0)?;
                // Z1 Z2/(Z1 + Z2) without a product that could leave the range of double precision.
                (speed, left / (1.0 + left / right))
            }
        };
        Some(Scales {
            time: 2.0 * case.at(rows::L)? * rho / e,
            speed,
            force: speed * impedance,
        })
    }

    /// The scale of a dimension.
    pub fn size(&self, dimension: Dimension) -> f64 {
        match dimension {
            Dimension::Time => self.time,
            Dimension::Length => 0.5 * self.speed * self.time,
            Dimension::Velocity => self.speed,
            Dimension::Acceleration => self.speed / self.time,
            Dimension::Force => self.force,
            Dimension::Energy => self.force * self.size(Dimension::Length),
        }
    }
}

/// Largest velocity before an impact over C0: the strain is half of it, and no material of bars is elastic at 2.5 %.
const FASTEST: f64 = 0.05;

/// The first bar whose C0 is none of these, or that is too fast for its C0, with the unit of velocity in m/s.
pub fn strange_speed(case: &Case, velocity: Option<f64>) -> Option<String> {
    let unit = velocity?;
    let right = match Opposite::of(case) {
        Some(Opposite::Wall) => None,
        None => Some(("right", [rows::RIGHT_E, rows::RIGHT_RHO, rows::RIGHT_V0])),
    };
    let bars = [Some(("left", [rows::E, rows::RHO, rows::V0])), right];
    bars.into_iter().flatten().find_map(|(name, [e, rho, v0])| {
        let speed = (case.at(e)? / case.at(rho)?).sqrt() * unit;
        let velocity = case.at(v0)?.abs() * unit;
        let fits = (WAVE_SPEEDS[0]..=WAVE_SPEEDS[1]).contains(&speed);
        match (fits, velocity <= FASTEST * speed) {
            (false, _) => Some(format!("the {name} bar has {} m/s", short(speed))),
            (true, false) => Some(format!("V0 of the {name} bar is {} m/s", short(velocity))),
            (true, true) => None,
        }
    })
}
