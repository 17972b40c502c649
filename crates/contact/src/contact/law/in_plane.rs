//! Laws that slide in a plane.

use crate::contact::{BoucWen, Lugre};

/// How a law of one direction acts in two.
#[derive(Debug, Clone, Copy)]
pub enum InPlane {
    /// Its force is along rdot.
    OfVelocity {
        /// rdot/S and the limit of a law that is viscous up to its limit.
        viscous: Option<[f64; 2]>,
    },
    /// Its force is along the elastic trial force, with a spring beside it.
    Elastic {
        /// r/S of the elastic part.
        compliance: f64,
        /// Its limit.
        limit: f64,
        /// Stiffness of the spring beside it.
        spring: f64,
        /// Whether it has the force of its first loading from r = 0 on, as hardening has.
        from_zero: bool,
        /// nu_min/nu_max and a of a coefficient that rises with the speed; 1 and 0 of a constant one.
        rising: [f64; 2],
    },
    /// Its force turns towards the motion.
    BoucWen(BoucWen),
    /// Its bristles relax towards the direction of the motion.
    Lugre(Lugre),
}
