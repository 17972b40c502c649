//! Laws that slide in a plane.

use crate::contact::{BoucWen, DisplacementControl, Lugre};

/// Friction that is elastic up to its limit, with a spring beside it.
#[derive(Debug, Clone, Copy)]
pub struct ElasticInPlane {
    /// The elastic part and its limit.
    pub law: DisplacementControl,
    /// Stiffness of the spring beside it.
    pub spring: f64,
    /// Whether it has the force of its first loading from r = 0 on, as hardening has.
    pub from_zero: bool,
    /// nu_min/nu_max and a of a coefficient that rises with the speed; 1 and 0 of a constant one.
    pub rising: [f64; 2],
}

impl From<DisplacementControl> for ElasticInPlane {
    fn from(law: DisplacementControl) -> ElasticInPlane {
        ElasticInPlane {
            law,
            spring: 0.0,
            from_zero: false,
            rising: [1.0, 0.0],
        }
    }
}

/// How a law of one direction acts in two.
#[derive(Debug, Clone, Copy)]
pub enum InPlane {
    /// Its force is along rdot.
    OfVelocity {
        /// rdot/S and the limit of a law that is viscous up to its limit.
        viscous: Option<[f64; 2]>,
    },
    /// Its force is along the elastic trial force, with a spring beside it.
    Elastic(ElasticInPlane),
    /// Its force turns towards the motion.
    BoucWen(BoucWen),
    /// Its bristles relax towards the direction of the motion.
    Lugre(Lugre),
}
