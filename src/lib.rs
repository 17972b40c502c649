//! Parameter studies of friction and impact models in time-history analysis.
//!
//! Two short papers by K. Kawashima put friction and impact into the direct integration of structures: `[F]`, *A
//! computational model of friction force in dynamic response analysis* (1980), and `[I]`, *An analytical model of contact
//! and impact in dynamic response analysis* (1981). Both soften a rigid law by a small spring or dashpot; both ask how the
//! answer depends on it and on the time step. slipgap answers with numbers: every case stands beside its exact solution.
//!
//! # The idea
//!
//! A structure is its modes, a contact is one scalar law, a step is one recursion per mode and one scalar root.
//!
//! ```text
//! x_k'' + omega_k^2 x_k = -phi_k^2 S            modes, scaled so that r = sum x_k (+ gap)      structure
//! W' = W - K P - G (S + S'),  P' = P + W'       constant average acceleration, exactly         stepper
//! r' = r* - h S'(r', state)                     the law's root, in closed form                 law
//! ```
//!
//! # The way of the data
//!
//! ```text
//! studies/*.json -> study -> cases -> [ solve -> history -> metrics, beside exact -> history ] -> results -> figures, checks
//! ```
//!
//! From the top down, each room using only those below it: [`report`], [`claims`] and [`checks`], [`figures`], [`batch`] with
//! the store, [`compare`], [`indices`], [`study`], [`recommend`], [`problem`], [`metrics`], [`exact`], [`stepper`], [`law`],
//! [`structure`], [`lane`], [`history`], [`error`]. Beside them stands [`textbook`]: the papers' matrices and iteration,
//! which the fast form is tested against.
//!
//! # Principal types
//!
//! - [`study::Study`]: a study file, read and validated; [`study::read`] names every fault with its place.
//! - [`problem::Problem`]: one of the two problems, [`problem::friction::FrictionOscillator`] and
//!   [`problem::impact::BarImpact`], with the tables of parameters and metrics that everything else reads.
//! - [`problem::Solution`]: a case's [`history::History`], the exact one beside it, and the metrics.
//! - [`problem::sweep`]: many cases side by side in [`lane::Lane`]s, to the bit what each alone has.
//! - [`stepper::Stepper`] and [`law::Law`]: the method and the contact.
//! - [`exact::coulomb::Coulomb`] and [`exact::wave::Wave`]: the exact solutions; they never use the stepper.
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

pub mod batch;
pub mod checks;
pub mod claims;
pub mod compare;
pub mod error;
pub mod exact;
pub mod figures;
pub mod history;
pub mod indices;
pub mod lane;
pub mod law;
pub mod metrics;
pub mod problem;
pub mod recommend;
pub mod report;
pub mod stepper;
pub mod structure;
pub mod study;
pub mod textbook;
