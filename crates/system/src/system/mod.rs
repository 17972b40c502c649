//! Systems: a linear structure, a contact, the state at t = 0 and the time step. A problem makes one from a case, and the solver
//! integrates it.

pub mod bar;
mod bar_pair;
pub mod import;
pub mod loads;
pub mod massless;
pub mod measured_table;
mod modes;
pub mod reduction;
pub mod structure;

pub use crate::methods::Mode;
pub use bar_pair::BarPair;
pub use modes::Modal;

use crate::contact::{ContactLaw, StoredEnergy, in_series};
use crate::methods::Method;

/// A structure with a contact, from t = 0 on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct System {
    /// The structure without the contact.
    pub linear: Linear,
    /// The contact's law.
    pub law: ContactLaw,
    /// r at rest.
    pub gap: f64,
    /// S(0).
    pub force: f64,
    /// Time step.
    pub step: f64,
    /// Number of steps N.
    pub last: u64,
    /// The method of integration.
    pub method: Method,
}

impl System {
    /// r, rdot and S of the contact itself, from those of the modes. They differ if contact nodes have no mass.
    pub fn at_contact(&self, modes: [f64; 3]) -> [f64; 3] {
        in_series(
            |s| self.law.deflection(s),
            self.linear.contact_compliance(),
            modes,
        )
    }
}

/// The linear part of a system and its state at t = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Linear {
    /// One mode, released at rest at a displacement.
    Oscillator {
        /// The mode.
        mode: Mode,
        /// x(0).
        displacement: f64,
    },
    /// Two bars, or a bar and a wall, that approach one another.
    Bars(BarPair),
}

/// A mode and its state at t = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModeAtStart {
    /// The mode.
    pub mode: Mode,
    /// Coordinate x.
    pub displacement: f64,
    /// Its velocity.
    pub velocity: f64,
}

impl Linear {
    /// Number of modes.
    pub fn len(&self) -> usize {
        match self {
            Linear::Oscillator { .. } => 1,
            Linear::Bars(bars) => bars.len(),
        }
    }

    /// Number of finite elements; one for an oscillator.
    pub fn elements(&self) -> u32 {
        match self {
            Linear::Oscillator { .. } => 1,
            Linear::Bars(bars) => bars.each().map(|bar| bar.elements).sum(),
        }
    }

    /// Compliance between the modes and the contact, c0: the modes move by c0 S more than r. Zero if all nodes have mass.
    pub fn contact_compliance(&self) -> f64 {
        match self {
            Linear::Oscillator { .. } => 0.0,
            Linear::Bars(bars) => bars.contact_compliance(),
        }
    }

    /// Whether there is no mode.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Mode `j`, from 0; modes after the last one have no meaning.
    #[inline(always)]
    pub fn mode(&self, j: usize) -> ModeAtStart {
        match self {
            Linear::Oscillator { mode, displacement } => ModeAtStart {
                mode: *mode,
                displacement: *displacement,
                velocity: 0.0,
            },
            Linear::Bars(bars) => bars.mode_at_start(j),
        }
    }

    /// Kinetic and strain energy at t = 0.
    pub fn energy(&self) -> f64 {
        match self {
            Linear::Oscillator { mode, displacement } => mode.energy(*displacement, 0.0),
            Linear::Bars(bars) => bars.energy_at_start(),
        }
    }
}
