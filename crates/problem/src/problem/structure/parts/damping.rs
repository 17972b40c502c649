//! Damping of the whole structure, by M and K or by its modes.

use crate::problem::structure::given::amount::Amount;
use crate::problem::{Case, Violation};
use std::f64::consts::PI;

/// C += mass M + stiffness K.
#[derive(Debug, Clone)]
pub enum Rayleigh {
    /// The factors of M and K.
    Factors([Option<Amount>; 2]),
    /// The damping ratios of two modes, from which the factors follow.
    Ratios {
        /// The two ratios.
        ratios: [Amount; 2],
        /// The modes that have them.
        of: Pair,
    },
}

/// The two modes of which Rayleigh damping has the ratios.
#[derive(Debug, Clone)]
pub enum Pair {
    /// By their numbers, from 1 by rising frequency, without rigid-body modes.
    Modes([Amount; 2]),
    /// By their natural periods.
    Periods([Amount; 2]),
}

impl Default for Rayleigh {
    fn default() -> Self {
        Rayleigh::Factors([None, None])
    }
}

impl Rayleigh {
    /// The numbers that make damping.
    pub fn amounts(&self) -> Vec<&Amount> {
        match self {
            Rayleigh::Factors(factors) => factors.iter().flatten().collect(),
            Rayleigh::Ratios { ratios, .. } => ratios.iter().collect(),
        }
    }

    /// The number that makes damping in proportion to K.
    pub fn of_stiffness(&self) -> Option<&Amount> {
        match self {
            Rayleigh::Factors([_, stiffness]) => stiffness.as_ref(),
            Rayleigh::Ratios { ratios, .. } => ratios.last(),
        }
    }
}

/// Damping ratios of the modes.
#[derive(Debug, Clone)]
pub enum ModalDamping {
    /// The same one in every mode.
    Every(Amount),
    /// One for each mode from the lowest frequency on, without rigid-body modes; modes beyond the last have none.
    Each(Vec<Amount>),
}

impl ModalDamping {
    /// The ratios.
    pub fn amounts(&self) -> &[Amount] {
        match self {
            ModalDamping::Every(ratio) => std::slice::from_ref(ratio),
            ModalDamping::Each(ratios) => ratios,
        }
    }

    /// The ratio of each mode with these squares of natural frequencies.
    ///
    /// # Errors
    /// A number that is not in its range, or more ratios than modes.
    pub fn ratios(&self, case: &Case, omega2: &[f64]) -> Result<Vec<f64>, Violation> {
        let given = match self {
            ModalDamping::Every(ratio) => return Ok(vec![ratio.value(case)?; omega2.len()]),
            ModalDamping::Each(given) => given,
        };
        let modes = vibrating(omega2);
        if let Some(beyond) = given.get(modes.len()) {
            let count = modes.len();
            return Err(beyond.violation(format!(
                "is the ratio of mode {}, the structure has {count} with a stiffness",
                count + 1
            )));
        }
        let mut ratios = vec![0.0; omega2.len()];
        for (mode, ratio) in modes.into_iter().zip(given) {
            ratios[mode] = ratio.value(case)?;
        }
        Ok(ratios)
    }
}

/// The modes with a stiffness, by rising frequency.
pub fn vibrating(omega2: &[f64]) -> Vec<usize> {
    let least = rigid_below(omega2);
    let mut modes: Vec<usize> = (0..omega2.len())
        .filter(|mode| omega2[*mode] > least)
        .collect();
    modes.sort_by(|a, b| omega2[*a].total_cmp(&omega2[*b]));
    modes
}

/// The |omega^2| up to which a mode has no stiffness: round-off of the eigensolver.
pub fn rigid_below(omega2: &[f64]) -> f64 {
    1e-12 * omega2.iter().fold(0.0, |largest, x| x.abs().max(largest))
}

impl Pair {
    /// The natural frequencies of the two modes, omega.
    ///
    /// # Errors
    /// A number that is not in its range, or two equal ones, or a mode that is not among those with these squares of frequencies.
    pub fn frequencies(&self, case: &Case, omega2: &[f64]) -> Result<[f64; 2], Violation> {
        let found = match self {
            Pair::Periods([first, second]) => [
                2.0 * PI / first.value(case)?,
                2.0 * PI / second.value(case)?,
            ],
            Pair::Modes([first, second]) => {
                let modes = vibrating(omega2);
                let count = u32::try_from(modes.len()).unwrap_or(u32::MAX);
                let frequency = |number: &Amount| -> Result<f64, Violation> {
                    let mode = number.whole(case, 1, count.max(1))? as usize;
                    let found = modes.get(mode - 1).map(|mode| omega2[*mode].sqrt());
                    found.ok_or_else(|| {
                        number.violation("the structure has no mode with a stiffness")
                    })
                };
                [frequency(first)?, frequency(second)?]
            }
        };
        let (Pair::Modes([_, second]) | Pair::Periods([_, second])) = self;
        match found[0] == found[1] {
            true => Err(second.violation("must not have the frequency of the other mode")),
            false => Ok(found),
        }
    }
}

/// The factors of M and K with which C = mass M + stiffness K has these damping ratios at these frequencies omega:
/// ratio = (mass/omega + stiffness omega)/2.
pub fn factors([z1, z2]: [f64; 2], [w1, w2]: [f64; 2]) -> [f64; 2] {
    let between = (w2 - w1) * (w2 + w1);
    [
        2.0 * w1 * w2 * (z1 * w2 - z2 * w1) / between,
        2.0 * (z2 * w2 - z1 * w1) / between,
    ]
}
