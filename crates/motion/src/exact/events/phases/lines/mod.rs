//! Laws of straight lines between r and S, with yielding: each line holds until r reaches an end of it, or until rdot turns.

mod band;
mod one_sided;
mod parts;

use super::contact_phase::Phase;
use crate::contact::Straight;
use crate::system::structure::StructureLaw;
use band::Band;
use one_sided::OneSided;
use parts::Parts;

/// Numbers that a law keeps from line to line.
const KEPT: usize = 6;

/// A line of a law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// dS/dr.
    pub slope: f64,
    /// r of a point of it, and S there.
    pub point: [f64; 2],
    /// The r between which it holds.
    pub ends: [f64; 2],
    /// The sign of rdot for which it holds; 0 for both.
    pub direction: f64,
    /// The energy that dr dissipates: this, and this times S.
    pub loss: [f64; 2],
    /// The phase that events show.
    pub phase: Phase,
    /// How many parts yield on it.
    yielding: usize,
    kept: [f64; KEPT],
}

/// How a line ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum End {
    /// r falls to its lower end.
    Low,
    /// r rises to its upper end.
    High,
    /// rdot turns.
    Turn,
}

/// A law of straight lines.
#[derive(Debug, Clone, Copy)]
pub enum Lines {
    /// Elastic between two parallel lines.
    Band(Band),
    /// On one side of a gap.
    OneSided(OneSided),
    /// Parts that yield one after the other.
    Parts(Parts),
}

/// The lines of a law; `None` if it has none, or if they change with time.
pub fn of(law: &StructureLaw) -> Option<Lines> {
    let limited = match law.limit() {
        Some(limit) if limit.varying.is_none() => law.law(limit.constant),
        Some(_) => return None,
        None => law.as_given(),
    };
    match limited
        .properties()
        .straight()
        .filter(|_| law.row().is_none())?
    {
        Straight::Band {
            band,
            unbent,
            is_stop,
        } => Some(Lines::Band(Band {
            stiffness: band.stiffness,
            bounds: band.bounds,
            unbent,
            is_stop,
        })),
        Straight::OneSided(spring) => Some(Lines::OneSided(OneSided(spring))),
        Straight::Parts(law) => Some(Lines::Parts(Parts(law))),
    }
}

impl Line {
    /// Without a force.
    fn open(ends: [f64; 2]) -> Line {
        Line {
            slope: 0.0,
            point: [0.0; 2],
            ends,
            direction: 0.0,
            loss: [0.0; 2],
            phase: Phase::Open,
            yielding: 0,
            kept: [0.0; KEPT],
        }
    }

    /// S at r.
    pub fn force(&self, r: f64) -> f64 {
        self.point[1] + self.slope * (r - self.point[0])
    }
}

impl Lines {
    /// The line at t = 0, of a first loading to r or with this force.
    pub fn start(&self, r: f64, force: Option<f64>) -> Line {
        match self {
            Lines::Band(law) => law.start(r, force),
            Lines::OneSided(law) => law.start(r, force),
            Lines::Parts(law) => law.start(r),
        }
    }

    /// Whether r and a force at t = 0 tell the state.
    pub fn knows(&self, r: f64, force: Option<f64>) -> bool {
        match (self, force) {
            (Lines::Parts(law), Some(force)) => law.is_first(r, force),
            _ => true,
        }
    }

    /// The line after this one, which ends at r.
    pub fn next(&self, line: &Line, end: End, r: f64) -> Line {
        match self {
            Lines::Band(law) => law.next(line, end, r),
            Lines::OneSided(law) => law.next(line, end, r),
            Lines::Parts(law) => law.next(line, end, r),
        }
    }

    /// The energy that is stored at r.
    pub fn stored(&self, line: &Line, r: f64) -> f64 {
        match self {
            Lines::Band(law) => law.stored(line, r),
            Lines::OneSided(law) => law.stored(line, r),
            Lines::Parts(law) => law.stored(line, r),
        }
    }
}
