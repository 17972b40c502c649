//! Time stepping of structures with any number of contacts. The default is the constant average acceleration method, as follows;
//! `general` has the other methods.
//!
//! Newmark's method with gamma = 1/2, beta = 1/4 `[F section 4]` `[I section 3]` fulfils the equations of motion at the ends of
//! every step. Their mean is one equation for the change of the velocities. With the increments W = dt v, P = u + W/2
//!
//! ```text
//! (M/dt^2 + C/(2 dt) + K/4) (W(i+1) - W(i)) = (p(i) + p(i+1))/2 - B (S(i) + S(i+1))/2 - K P(i) - C W(i)/dt
//! P(i+1) = P(i) + W(i+1),   u = P - W/2,   v = W/dt
//! ```
//!
//! The matrix is Khat/4, K P and C W are sums over differences of neighbours, and no acceleration enters. The right side is
//! small where the motion is slow, so round-off stays small however small the step is.
//!
//! The forces at the end of a step are a small convex problem ([`crate::contact::coupled`]): the step without S(i+1) gives r*, and
//! r = r* - H S(i+1), H = B^T Khat^-1 B. One solution for each step is enough: forward elimination, forces, their subtraction,
//! back substitution.
//!
//! M is in the matrix alone, so that a consistent one costs no more than a lumped one. At nodes without mass and damping the
//! equation is K u + B S = p at the end of the step; P is u there, W = 0, and u(i+1) = u(i) + (W(i+1) - W(i))/2 of the solution.
//!
//! A rigid stop has r >= 0 at the end of every step. The method does not know its restitution. After a jump, the force of a contact
//! without compliance alternates about its mean from step to step, as the method has no damping. Only the mean of two steps moves
//! the structure, so the motion does not alternate.
//!
//! A mass of 1 with the velocity 2 and Coulomb friction 1 comes to rest after 2 s at v^2/2 = 2:
//!
//! ```
//! use slipgap_contact::contact::ClippedLine;
//! use slipgap_motion::solve::structure::{Prepared, run};
//! use slipgap_system::system::structure::{Limit, Structure, StructureLaw};
//!
//! let coulomb = StructureLaw::new(ClippedLine::Coulomb, Limit::constant(1.0));
//! let block = Structure::builder()
//!     .mass("block", 1.0)
//!     .contact("floor", ["ground", "block"], 0.0, coulomb)
//!     .start("block", [0.0, 2.0])
//!     .build()
//!     .expect("names of its masses");
//! let prepared = Prepared::new(&block, 0.01)?;
//! let mut last = [0.0; 2];
//! let [done] = run::<1>(&[&block], &prepared, 300, |_, state| {
//!     last = [state.displacement(0), state.velocity(0)].map(|x| x.0[0]);
//! });
//! done?;
//! assert!((last[0] - 2.0).abs() < 1e-10 && last[1].abs() < 1e-10);
//! # Ok::<(), slipgap_motion::solve::Unsolvable>(())
//! ```

mod average;
mod contacts;
mod general;
mod inputs;
mod linear_part;
mod run;
mod seen;
mod start;

pub use crate::solve::structure::contacts::static_fault::static_ratio_fault;
pub use crate::solve::structure::linear_part::block_matrix::sizes_of_blocks;
pub use crate::solve::structure::linear_part::prepared::Prepared;
pub use crate::solve::structure::seen::books::{Books, Work};
pub use crate::solve::structure::seen::ledger::Ledger;
pub use crate::solve::structure::seen::step_view::{ContactStep, State};
pub use crate::solve::structure::seen::watch::{Watch, Watched, WatchedContact};
pub use crate::solve::structure::start::instant::balance;
pub use crate::solve::structure::start::preload::settle;
pub use general::{CriticalFault, critical_fault, critical_step};
pub use run::run;

use crate::system::structure::Structure;

/// S(0) of every contact; `None` where rigid contacts have no forces that fit together.
pub fn forces_at_start(structure: &Structure) -> Option<Vec<f64>> {
    start::initial::forces(structure).ok()
}

#[cfg(test)]
mod tests;
