//! The releases for which an answer must hold: one, or all of a range.

use slipgap_problem::problem::numbers::parameter::shortest;
use std::fmt;
use std::str::FromStr;

/// Largest |x0|, whose motion is short enough for a search.
const LARGEST: f64 = 1000.0;

/// Largest length of a range.
const LONGEST: f64 = 40.0;

/// Distances from an odd number at which a range is searched. At an odd x0 the exact motion has one half-cycle more or less, and the
/// errors have cusps; just above it is the longer motion. Between them the errors change slowly.
const AROUND: [f64; 26] = [
    -0.9, -0.8, -0.7, -0.6, -0.5, -0.4, -0.3, -0.2, -0.1, -0.05, -0.02, 0.0, 1e-6, 0.01, 0.02,
    0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0,
];

/// Just above an odd number.
const ABOVE: f64 = 1e-6;

/// Number of parts of a range on which an answer is looked at in the end.
const PARTS: u32 = 1200;

/// How far these parts reach below and above one release: two cycles less and four more.
const LOOK: [f64; 2] = [4.0, 8.0];

/// Releases at rest, in Delta.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Releases {
    /// One, and those within 2 % of it.
    One(f64),
    /// All from the first to the second, which are positive.
    Range(f64, f64),
}

impl Releases {
    /// The one, or the largest, whose motion is longest.
    pub fn longest(&self) -> f64 {
        match self {
            Releases::One(x0) => *x0,
            Releases::Range(_, to) => *to,
        }
    }

    /// The releases that are likely to have the largest errors: the ends, the first and the last odd number, and just above them.
    pub(super) fn hardest(&self) -> Vec<f64> {
        let Releases::Range(from, to) = *self else {
            return vec![self.longest()];
        };
        let first = first_odd(from);
        let last = first + 2.0 * ((to - first) / 2.0).floor();
        let hard = [first, last].map(|odd| [odd, odd + ABOVE]).concat();
        let mut all: Vec<f64> = Vec::new();
        for x0 in hard.into_iter().chain([from, to]) {
            if (from..=to).contains(&x0) && !all.contains(&x0) {
                all.push(x0);
            }
        }
        all
    }

    /// All releases at which a range is searched, in their order.
    pub(super) fn all(&self) -> Vec<f64> {
        let Releases::Range(from, to) = *self else {
            return vec![self.longest()];
        };
        let odds = std::iter::successors(Some(first_odd(from) - 2.0), |odd| Some(odd + 2.0));
        let odds = odds.take_while(|odd| *odd <= to + 1.0);
        let inner = odds.flat_map(|odd| AROUND.map(|around| odd + around));
        let mut all = vec![from];
        all.extend(inner.filter(|x0| from < *x0 && *x0 < to));
        all.push(to);
        all
    }

    /// The releases on which an answer is looked at in the end: the range, or those about the one.
    pub(super) fn looked_at(&self) -> Vec<f64> {
        let (from, to, sign) = match *self {
            Releases::Range(from, to) => (from, to, 1.0),
            Releases::One(x0) => {
                let size = x0.abs();
                (
                    (size - LOOK[0]).max(size.min(1.0)),
                    size + LOOK[1],
                    x0.signum(),
                )
            }
        };
        let part = (to - from) / f64::from(PARTS);
        let inner = (0..PARTS).map(|i| sign * (from + f64::from(i) * part));
        inner.chain([sign * to]).collect()
    }

    /// Refuses a release whose motion is too long for a search, and a range that is none.
    ///
    /// # Errors
    /// What is allowed.
    pub fn check(&self) -> Result<(), ReleasesFault> {
        match *self {
            Releases::One(x0) if x0 != 0.0 && x0.abs() <= LARGEST => Ok(()),
            Releases::One(_) => Err(ReleasesFault::One),
            Releases::Range(from, to) if !(from > 0.0 && from < to && to <= LARGEST) => {
                Err(ReleasesFault::Ends(*self))
            }
            Releases::Range(from, to) if to - from > LONGEST => Err(ReleasesFault::TooLong(*self)),
            Releases::Range(..) => Ok(()),
        }
    }
}

/// Why a text or numbers are no releases of a search. Displayed as what is allowed.
#[derive(Debug, Clone, PartialEq)]
pub enum ReleasesFault {
    /// One release that is 0, too large or no number.
    One,
    /// A range whose ends do not rise, or are not in the range allowed.
    Ends(Releases),
    /// A range that is too long.
    TooLong(Releases),
    /// A range of this text, without two numbers.
    NoNumbers(String),
}

impl fmt::Display for ReleasesFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ReleasesFault::One => write!(
                f,
                "must be a number from -{LARGEST} to {LARGEST}, but not 0, or a range such as 8..20"
            ),
            ReleasesFault::Ends(range) => write!(
                f,
                "a range must rise from a number above 0 to one up to {LARGEST}, as 8..20, got {range}"
            ),
            ReleasesFault::TooLong(range) => {
                write!(f, "a range must not be longer than {LONGEST}, got {range}")
            }
            ReleasesFault::NoNumbers(text) => {
                write!(f, "a range needs two numbers, as 8..20, got {text}")
            }
        }
    }
}

impl std::error::Error for ReleasesFault {}

/// The smallest odd number that is not below x.
fn first_odd(x: f64) -> f64 {
    2.0 * ((x - 1.0) / 2.0).ceil() + 1.0
}

impl From<f64> for Releases {
    fn from(x0: f64) -> Releases {
        Releases::One(x0)
    }
}

impl fmt::Display for Releases {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Releases::One(x0) => f.write_str(&shortest(*x0)),
            Releases::Range(from, to) => write!(f, "{}..{}", shortest(*from), shortest(*to)),
        }
    }
}

impl FromStr for Releases {
    type Err = ReleasesFault;

    /// Reads `12` or `8..20`.
    fn from_str(text: &str) -> Result<Releases, ReleasesFault> {
        // What is no number is refused as NaN is.
        let number = |text: &str| text.parse().unwrap_or(f64::NAN);
        let releases = match text.split_once("..") {
            None => Releases::One(number(text)),
            Some((from, to)) => {
                let ends = [from, to].map(number);
                if ends.iter().any(|end| !end.is_finite()) {
                    return Err(ReleasesFault::NoNumbers(text.to_owned()));
                }
                Releases::Range(ends[0], ends[1])
            }
        };
        releases.check().map(|()| releases)
    }
}
