//! Whether values are within limits, and whether they still are when the limits move.

/// Most values that a finding lists separately.
const MOST: usize = 6;

/// How far limits move to see which verdicts are near them: this part of half the range, or of a single limit.
pub const NEAR: f64 = 0.1;

/// The smallest and the largest value allowed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Smallest value allowed.
    pub min: Option<f64>,
    /// Largest value allowed.
    pub max: Option<f64>,
}

impl Limits {
    /// Whether a value is within.
    pub fn contain(self, x: f64) -> bool {
        self.min.is_none_or(|min| x >= min) && self.max.is_none_or(|max| x <= max)
    }

    /// The limits as text, as in ` (0.9..1.1)`.
    fn text(self) -> String {
        match (self.min, self.max) {
            (Some(min), Some(max)) => format!(" ({}..{})", short(min), short(max)),
            (Some(min), None) => format!(" (at least {})", short(min)),
            (None, Some(max)) => format!(" (at most {})", short(max)),
            (None, None) => String::new(),
        }
    }

    /// The limits moved inwards by a part of half their range, or of the limit if it is the only one; outwards if negative.
    pub fn moved(self, part: f64) -> Limits {
        let scale = match (self.min, self.max) {
            (Some(min), Some(max)) => (max - min) / 2.0,
            (Some(limit), None) | (None, Some(limit)) => limit.abs(),
            (None, None) => 0.0,
        };
        Limits {
            min: self.min.map(|min| min + part * scale),
            max: self.max.map(|max| max - part * scale),
        }
    }
}

/// The result of one expectation.
#[derive(Debug, Clone, PartialEq)]
pub struct Met {
    /// Whether it is met.
    pub holds: bool,
    /// Whether it is met with limits that are narrower by `NEAR`.
    pub narrower: bool,
    /// Whether it is met with limits that are wider by `NEAR`.
    pub wider: bool,
    /// The values found, in Markdown.
    pub found: String,
}

impl Met {
    /// Tests all values against limits. An undefined value fails.
    pub fn of(values: &[Option<f64>], limits: Limits, found: String) -> Met {
        let are_within = |limits: Limits| {
            let mut values = values.iter();
            values.all(|x| x.is_some_and(|x| limits.contain(x)))
        };
        Met {
            holds: are_within(limits),
            narrower: are_within(limits.moved(NEAR)),
            wider: are_within(limits.moved(-NEAR)),
            found,
        }
    }

    /// The result of something that has no limit which could move.
    pub fn plain(holds: bool, found: String) -> Met {
        Met {
            holds,
            narrower: holds,
            wider: holds,
            found,
        }
    }
}

/// The result for limits of values, which `name` names in Markdown.
pub fn within(values: &[Option<f64>], name: &str, min: Option<f64>, max: Option<f64>) -> Met {
    let limits = Limits { min, max };
    let found = format!("{name} {}{}", summary(values), limits.text());
    Met::of(values, limits, found)
}

/// The result if at least a share of the values must be within limits. Values that are undefined are left out, and counted.
pub fn share_within(
    values: &[Option<f64>],
    name: &str,
    [min, max]: [Option<f64>; 2],
    share: f64,
) -> Met {
    let limits = Limits { min, max };
    let known: Vec<f64> = values.iter().copied().flatten().collect();
    let inside = |limits: Limits| known.iter().filter(|x| limits.contain(**x)).count();
    // A share of 0.95 of 20 is 19, also where the product is rounded up.
    let least = share * known.len() as f64 * (1.0 - 1e-12);
    let holds = |limits: Limits| !known.is_empty() && inside(limits) as f64 >= least;
    let mut found = format!(
        "{name} in {} of {}{} (at least {})",
        inside(limits),
        known.len(),
        limits.text(),
        short(share)
    );
    if known.len() < values.len() {
        found += &format!(", {} undefined", values.len() - known.len());
    }
    Met {
        holds: holds(limits),
        narrower: holds(limits.moved(NEAR)),
        wider: holds(limits.moved(-NEAR)),
        found,
    }
}

/// Values as text: each of them, or the range of many.
fn summary(values: &[Option<f64>]) -> String {
    let known: Vec<f64> = values.iter().copied().flatten().collect();
    if known.len() < values.len() || known.is_empty() {
        return "undefined".into();
    }
    if known.len() <= MOST {
        let each: Vec<String> = known.into_iter().map(short).collect();
        return each.join(", ");
    }
    let low = known.iter().copied().fold(f64::INFINITY, f64::min);
    let high = known.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    format!("{}..{} in {} cases", short(low), short(high), known.len())
}

/// A number with four digits.
pub fn short(x: f64) -> String {
    let rounded: f64 = format!("{x:.3e}").parse().unwrap_or(x);
    match rounded.abs() {
        0.0 | 1e-4..1e6 => rounded.to_string(),
        _ => format!("{rounded:e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_apply_to_every_value_and_an_undefined_one_fails() {
        let inside = |values: &[Option<f64>]| within(values, "x", Some(1.0), Some(2.0)).holds;
        assert!(inside(&[Some(1.0), Some(2.0)]));
        assert!(!inside(&[Some(1.0), Some(2.1)]) && !inside(&[Some(1.5), None]));
    }

    #[test]
    fn a_share_is_that_of_the_values_which_are_defined() {
        let mut values: Vec<Option<f64>> = vec![Some(1.0); 19];
        values.extend([Some(2.0), None]);
        let of = |share| share_within(&values, "x", [Some(0.95), Some(1.05)], share);
        // 19 of 20.
        assert!(of(0.95).holds && !of(0.96).holds);
        let found = "x in 19 of 20 (0.95..1.05) (at least 0.95), 1 undefined";
        assert_eq!(of(0.95).found, found);
        assert!(!share_within(&[None], "x", [None, Some(1.0)], 0.5).holds);
    }

    #[test]
    fn limits_move_by_a_part_of_half_their_range_or_of_the_only_limit() {
        let (low, high) = (Some(0.9), Some(1.1));
        let moved = |min, max, part| Limits { min, max }.moved(part);
        let both = moved(low, high, 0.1);
        // A tenth of 0.1; round-off of one addition.
        assert!(
            (both.min.unwrap() - 0.91).abs() < 1e-15 && (both.max.unwrap() - 1.09).abs() < 1e-15
        );
        assert_eq!(moved(Some(-2.0), None, 0.25).min, Some(-1.5));
        assert_eq!(moved(None, Some(-2.0), -0.25).max, Some(-1.5));
        assert_eq!(moved(None, Some(0.0), 0.1).max, Some(0.0));
    }

    #[test]
    fn a_value_near_a_limit_changes_the_result_when_the_limit_moves() {
        for (x, narrower, holds, wider) in [
            (1.0, true, true, true),
            (1.085, true, true, true),
            (1.095, false, true, true),
            (1.105, false, false, true),
            (1.115, false, false, false),
            (0.895, false, false, true),
        ] {
            let met = within(&[Some(1.0), Some(x)], "x", Some(0.9), Some(1.1));
            assert_eq!(
                (met.narrower, met.holds, met.wider),
                (narrower, holds, wider),
                "{x}"
            );
        }
        let met = within(&[None], "x", Some(0.9), None);
        assert_eq!((met.narrower, met.holds, met.wider), (false, false, false));
    }

    #[test]
    fn values_are_listed_or_summarised() {
        assert_eq!(summary(&[Some(1.0), None]), "undefined");
        assert_eq!(summary(&[Some(3.0); 7]), "3..3 in 7 cases");
    }

    #[test]
    fn values_have_four_digits() {
        assert_eq!(short(0.123456), "0.1235");
        assert_eq!(short(1e-7), "1e-7");
        assert_eq!(short(0.0), "0");
    }
}
