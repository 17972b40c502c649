//! From the parameters of a case with their units to the scaled numbers that the motion depends on.
//!
//! Time in T_I, displacement in c T_I/2, force in F0 = c Z1 Z2/(Z1 + Z2), so velocity in c/2 and mass in 2 F0 T_I/c.
//! With z = Z1/Z2 and theta = T_2/T_1, the mass of the left bar is (1 + z)/4, the mass of the right bar is theta/z of it, and the
//! stiffness of the spring is gamma n (1 + z). For equal bars z = theta = 1 exactly, so that density and speed have no effect on
//! scaled results.

use super::law_of_case::{is_rigid, law};
use super::tables::{METHOD, MassMatrix, Opposite, rows};
use crate::contact::ContactLaw;
use crate::exact::wave::Bars;
use crate::methods::Method;
use crate::problem::{Case, method};
use crate::system::BarPair;
use crate::system::bar::{Bar, Mass};

/// Velocity of the rigid-body motion that closes the gap: c in units of c/2.
pub const CLOSING: f64 = -2.0;

/// A case in its own scales.
#[derive(Debug, Clone, Copy)]
pub struct Scaled {
    /// The bars of finite elements.
    pub pair: BarPair,
    /// Impedance and time ratio, gap.
    pub bars: Bars,
    /// Stiffness of the impact spring, or the secant stiffness of another law; infinite for rigid contact.
    pub spring: f64,
    /// The contact law.
    pub law: ContactLaw,
    /// The method of integration.
    pub method: Method,
    /// L_R/L, for drawings; zero for a wall.
    pub length_ratio: f64,
}

impl Scaled {
    /// Scales a completed case; `None` if a parameter is not given.
    pub fn new(case: &Case) -> Option<Scaled> {
        let kind = match MassMatrix::of(case)? {
            MassMatrix::Lumped => Mass::Lumped,
            MassMatrix::Consistent => Mass::Consistent,
            MassMatrix::MasslessContact => Mass::MasslessContact,
        };
        let n = case.at(rows::N)?;
        let ratio = |left: usize, right: usize| Some(case.at(left)? / case.at(right)?);
        let (z, theta, length) = match Opposite::of(case) {
            Some(Opposite::Wall) => (0.0, 1.0, 0.0),
            None => {
                let e = ratio(rows::E, rows::RIGHT_E)?;
                let a = ratio(rows::A, rows::RIGHT_A)?;
                let rho = ratio(rows::RHO, rows::RIGHT_RHO)?;
                let l = ratio(rows::L, rows::RIGHT_L)?;
                // Z = A sqrt(E rho), T = 2 L sqrt(rho/E)
                (a * (e * rho).sqrt(), (e / rho).sqrt() / l, 1.0 / l)
            }
        };
        let mass = (1.0 + z) / 4.0;
        let left = Bar {
            elements: n as u32,
            mass,
            travel_time: 1.0,
            kind,
        };
        let right = if z > 0.0 {
            Some(Bar {
                elements: case.at(rows::RIGHT_N)? as u32,
                mass: mass * theta / z,
                travel_time: theta,
                kind,
            })
        } else {
            None
        };
        let spring = match is_rigid(case) {
            true => f64::INFINITY,
            false => case.at(rows::GAMMA)? * n * (1.0 + z),
        };
        let method = method::of_case(case, METHOD)?;
        let masses = right.map_or(mass, |right| mass * right.mass / (mass + right.mass));
        Some(Scaled {
            pair: BarPair {
                left,
                right,
                velocity: CLOSING,
            },
            bars: Bars {
                impedance_ratio: z,
                time_ratio: theta,
                gap: case.at(rows::GAP)?,
            },
            spring,
            law: law(case, method, spring, masses)?,
            method,
            length_ratio: length,
        })
    }
}
