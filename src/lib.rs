//! Parameter studies of friction and impact models in time-history analysis.
//!
//! Two short papers by K. Kawashima put friction and impact into the direct integration of structures: `[F]`, *A
//! computational model of friction force in dynamic response analysis* (1980), and `[I]`, *An analytical model of contact
//! and impact in dynamic response analysis* (1981). Both soften a rigid law by a small spring or dashpot; both ask how the
//! answer depends on it and on the time step. slipgap answers with numbers: every case is compared with its exact solution.
//!
//! # The idea
//!
//! A structure answers the forces of its contact, a contact is one scalar law, a method is a small recursion, a step is one
//! scalar root. Every law works with every method: a method tells the law how r and rdot at the end of a step depend on the force
//! there, and the law gives the force.
//!
//! ```text
//! x_k'' + omega_k^2 x_k = -phi_k^2 S            modes, scaled so that r = sum x_k (+ gap)      system
//! W' = W - K P - G (S + S'),  P' = P + W'       constant average acceleration, exactly         methods
//! r' = r* - h S'(r', state)                     the law's root                                 contact
//! ```
//!
//! # The data flow
//!
//! ```text
//! studies/*.json -> study -> cases -> problem -> System -> [ solve -> history -> metrics, with exact -> history ]
//!                -> results -> figures, checks, reports
//! ```
//!
//! The modules from top to bottom; each uses only those below it: [`program`] with the verbs, [`claims`], [`compare`], [`calibrate`], [`run`], [`warnings`].
//! Below them are crates, whose modules are named here, too: [`animate`] and [`report`], [`batch`] with the store, [`checks`] and
//! [`study_figures`], [`recommend`], [`figures`],
//! [`study`] with [`error`], the solver with [`problem`], [`metrics`], [`solve`], [`textbook`], [`exact`], [`system`], [`methods`],
//! [`contact`], [`expression`], [`lane`] and [`history`], and [`statistics`]. [`textbook`] has the papers' matrices and iteration,
//! which the fast form is tested against. Who needs the solver alone uses `slipgap-solver`.
//!
//! Structures with many contacts ([`system::structure`]) have the same data flow, with the forces of a step as a small convex
//! problem ([`contact::coupled`]) and the exact motion by events ([`exact::events`]).
//!
//! # Principal types
//!
//! - [`study::Study`]: a study file, read and validated; [`study::read`] reports every error with its place.
//! - [`problem::Problem`]: one of the problems, [`problem::friction::FrictionOscillator`] and
//!   [`problem::impact::BarImpact`] or [`problem::structure::StructureProblem`], with the tables of parameters and metrics that everything else reads.
//! - [`system::System`]: what a problem with one contact makes of a case: the modes, the contact, the start, the step.
//! - [`problem::Solution`]: a case's [`history::History`], the exact history, and the metrics.
//! - [`solve::sweep`]: many cases side by side in [`lane::Lane`]s, to the bit what each has by itself.
//! - [`methods::Method`] with [`methods::AverageAcceleration`] and others, and [`contact::Law`]: the method and
//!   the contact.
//! - [`exact::coulomb::Coulomb`] and [`exact::wave::Wave`]: the exact solutions; they never use the method.
//!
//! # An example
//!
//! One case of `[F]` Fig. 5, and its `rms_error`:
//!
//! ```
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let study = slipgap::study::parse(
//!     "fig5.json",
//!     r#"{ "problem": "friction-oscillator",
//!          "parameters": { "law": "displacement-control", "alpha": 0.1, "dT": "pi/10", "duration": "8*pi" } }"#,
//! )?;
//! let case = study.case(0).ok_or("no case")?;
//! let solution = study.problem.solve(&case, &[])?;
//! assert_eq!(study.problem.metrics()[0].name, "rms_error");
//! assert!((solution.metrics[0].ok_or("undefined")? - 0.0245).abs() < 5e-5);
//! # Ok(())
//! # }
//! ```
//!
//! Equations are cited where they are carried out, as in `[F (9)]`; `docs/errata.md` says where the papers' print is
//! departed from, and why.

pub mod calibrate;
pub mod claims;
mod commands;
pub mod compare;
pub mod program;
pub mod run;
pub mod warnings;

pub use slipgap_batch::{self as batch, checks, study_figures};
pub use slipgap_contact::{contact, lane};
pub use slipgap_figures as figures;
pub use slipgap_motion::{exact, history, solve, textbook};
pub use slipgap_pages::{animate, report};
pub use slipgap_problem::{
    metrics,
    problem::{self, expression},
};
pub use slipgap_recommend as recommend;
pub use slipgap_statistics as statistics;
pub use slipgap_study as study;
pub use slipgap_study::error;
pub use slipgap_system::{methods, system};
