//! Units of acceleration.

use std::fmt;

/// Standard gravity g in m/s2, exact by definition (General Conference on Weights and Measures, 1901).
pub const STANDARD_GRAVITY: f64 = 9.80665;

/// A unit of acceleration.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// Standard gravity.
    G,
    /// m/s2.
    MetrePerSecond2,
    /// cm/s2, which is 1 gal.
    CentimetrePerSecond2,
}

impl Unit {
    /// All units.
    pub const ALL: [Unit; 3] = [Unit::G, Unit::MetrePerSecond2, Unit::CentimetrePerSecond2];

    /// The unit in m/s2.
    pub fn in_m_s2(self) -> f64 {
        match self {
            Unit::G => STANDARD_GRAVITY,
            Unit::MetrePerSecond2 => 1.0,
            Unit::CentimetrePerSecond2 => 0.01,
        }
    }

    /// Its name in a study.
    pub fn name(self) -> &'static str {
        match self {
            Unit::G => "g",
            Unit::MetrePerSecond2 => "m/s2",
            Unit::CentimetrePerSecond2 => "cm/s2",
        }
    }

    /// The unit with this name in a study.
    pub fn from_name(name: &str) -> Option<Unit> {
        Unit::ALL.into_iter().find(|unit| unit.name() == name)
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_has_one_name_and_a_gal_is_a_hundredth_of_m_s2() {
        let named = |name| Unit::from_name(name).map(Unit::in_m_s2);
        assert_eq!(named("g"), Some(9.80665));
        assert_eq!(named("m/s2"), Some(1.0));
        assert_eq!(named("cm/s2"), Some(0.01));
        for name in ["", "G", "gal", "m/s^2"] {
            assert_eq!(named(name), None);
        }
    }
}
