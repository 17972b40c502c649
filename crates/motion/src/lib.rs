//! Motions of structures with contacts: step by step, exact, and by the papers' own equations.
//!
//! A part of slipgap, whose names may change: who needs the solver uses `slipgap-solver`.
//!
//! The oscillator of `[F]` with Coulomb friction of the displacement-control model, over half a period from X = 12. It loses 2 Delta
//! of its amplitude and arrives at -10:
//!
//! ```
//! use slipgap_contact::contact::{ContactLaw, DisplacementControl};
//! use slipgap_system::methods::AverageAcceleration;
//! use slipgap_motion::solve::{self, ContactTrack};
//! use slipgap_system::system::{Linear, Mode, System};
//! use std::f64::consts::PI;
//!
//! let system = System {
//!     linear: Linear::Oscillator { mode: Mode::new(1.0, 1.0), displacement: 12.0 },
//!     law: ContactLaw::DisplacementControl(DisplacementControl { compliance: 1e-6, limit: 1.0 }),
//!     gap: 0.0,
//!     force: 0.0,
//!     step: PI / 1000.0,
//!     last: 1000,
//!     method: AverageAcceleration.into(),
//! };
//! let motion = solve::run::<ContactTrack>(&system)?;
//! let [x, v, _] = motion.track.0[1000];
//! assert!((x + 10.0).abs() < 1e-4 && v.abs() < 0.02);
//! # Ok::<(), slipgap_motion::solve::Unsolvable>(())
//! ```

pub mod exact;
pub mod history;
pub mod solve;
pub mod textbook;

use slipgap_contact::{contact, lane};
use slipgap_system::{methods, system};

/// Hash of the code of this crate and of the crates of others that it computes with.
pub const CODE_KEY: &str = env!("SLIPGAP_CODE");
