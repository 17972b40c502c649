//! The series of a contact.

use crate::exact::events::coordinates::pressed::Pressed;
use crate::exact::events::numerics::bernstein::{ORDERS, Polynomial, TERMS};

/// The polynomials of a contact.
#[derive(Debug, Clone)]
pub struct ContactSeries {
    /// r.
    pub r: [f64; ORDERS],
    /// S.
    pub force: Polynomial,
    /// The friction limit where it is positive.
    pub limit: Polynomial,
}

/// S of a spring on a piece, and whether it is in compression.
#[derive(Debug, Clone)]
pub struct PressingSpring {
    pub force: Polynomial,
    pub presses: bool,
}

impl PressingSpring {
    /// The springs of a contact.
    pub fn of(pressed: &Pressed) -> Vec<PressingSpring> {
        let spring = PressingSpring {
            force: [0.0; TERMS],
            presses: false,
        };
        vec![spring; pressed.springs.len()]
    }
}

/// Number of terms of u for a bound of the frequencies times the length: forces have two terms less.
pub(super) fn terms(phase: f64) -> usize {
    let (mut term, mut count) = (1.0, 0);
    while term > LEFT_OUT && count < TERMS {
        count += 1;
        term *= phase / count as f64;
    }
    (count + 2).max(FEWEST)
}

/// Terms of a motion without stiffness: a load that is straight in time gives a cubic.
pub(super) const FEWEST: usize = 6;

/// Size of the terms left out, over the motion with the highest frequency: the round-off of double precision is larger.
pub(super) const LEFT_OUT: f64 = 4e-18;
