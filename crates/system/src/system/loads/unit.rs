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
    /// mm/s2.
    MillimetrePerSecond2,
}

impl Unit {
    /// All units.
    pub const ALL: [Unit; 4] = [
        Unit::G,
        Unit::MetrePerSecond2,
        Unit::CentimetrePerSecond2,
        Unit::MillimetrePerSecond2,
    ];

    /// The unit in m/s2.
    pub fn in_m_s2(self) -> f64 {
        match self {
            Unit::G => STANDARD_GRAVITY,
            Unit::MetrePerSecond2 => 1.0,
            Unit::CentimetrePerSecond2 => 0.01,
            Unit::MillimetrePerSecond2 => 0.001,
        }
    }

    /// Its name in a study.
    pub fn name(self) -> &'static str {
        match self {
            Unit::G => "g",
            Unit::MetrePerSecond2 => "m/s2",
            Unit::CentimetrePerSecond2 => "cm/s2",
            Unit::MillimetrePerSecond2 => "mm/s2",
        }
    }

    /// The unit with this name in a study.
    fn from_name(name: &str) -> Option<Unit> {
        Unit::ALL.into_iter().find(|unit| unit.name() == name)
    }

    /// The unit that the header of a record writes so: `G`, `GAL`, `cm/sec/sec`, `M/S**2`, `mm/s^2`, `cm/s\u{b2}`.
    pub(super) fn spelled(text: &str) -> Option<Unit> {
        let text = text.trim().trim_end_matches(['.', ',', ';', ':']);
        let lower_case = text.to_ascii_lowercase().replace("**", "").replace('^', "");
        let plain = lower_case.replace('\u{b2}', "2").replace("sec", "s");
        match plain.as_str() {
            "gal" | "gals" => Some(Unit::CentimetrePerSecond2),
            _ => Unit::from_name(&plain.replace("/s/s", "/s2")),
        }
    }

    /// The names of all units, for messages.
    pub fn names() -> String {
        let [first @ .., last] = Unit::ALL.map(Unit::name);
        format!("{} or {last}", first.join(", "))
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
        assert_eq!(named("mm/s2"), Some(0.001));
        assert_eq!(Unit::names(), "g, m/s2, cm/s2 or mm/s2");
        for (text, unit) in [
            ("G.", 9.80665),
            ("GAL", 0.01),
            ("CM/SEC/SEC", 0.01),
            ("M/S**2", 1.0),
            ("mm/sec^2,", 0.001),
            ("m/s\u{b2}", 1.0),
        ] {
            assert_eq!(Unit::spelled(text).map(Unit::in_m_s2), Some(unit), "{text}");
        }
        assert_eq!(Unit::spelled("FURLONGS"), None);
        for name in ["", "G", "gal", "m/s^2"] {
            assert_eq!(named(name), None);
        }
    }
}
