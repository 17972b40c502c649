//! What the forces of coupled contacts need of their laws.

/// The laws of the contacts over a step.
pub trait Laws {
    /// J(y): S of r' = y - a S, S = f(r'), where a is [`super::CurvedForces::flexibility`] of the contact.
    fn answer(&self, contact: usize, y: f64) -> f64;

    /// 1/f' where J(y) is `force`, from 0 to infinity: of the law, or of its chord over `width` to both sides of r'.
    fn compliance(&self, contact: usize, y: f64, force: f64, width: f64) -> f64;

    /// Bounds of the force.
    fn bounds(&self, contact: usize) -> [f64; 2];

    /// Whether this contact and the next one are the two components of a contact in a plane.
    fn is_plane(&self, _contact: usize) -> bool {
        false
    }

    /// J(y) of a contact in a plane: the gradient of a convex function, with slopes from 0 to 1/a in all directions.
    fn answer_plane(&self, _contact: usize, _y: [f64; 2]) -> [f64; 2] {
        [0.0; 2]
    }

    /// 1/f' of a contact in a plane where J(y) is `force`.
    fn directions(&self, _contact: usize, _y: [f64; 2], _force: [f64; 2]) -> Directions {
        Directions {
            along: [1.0, 0.0],
            slopes: [f64::INFINITY; 2],
        }
    }
}

/// The slopes of a law in a plane: 1/f' along a unit vector and across it.
#[derive(Debug, Clone, Copy)]
pub struct Directions {
    /// The unit vector, in which most laws slide.
    pub along: [f64; 2],
    /// 1/f' along it, and across; infinite where the force does not follow.
    pub slopes: [f64; 2],
}

impl Directions {
    /// 1/f' as a symmetric matrix by its entries 11, 12 and 22, with both slopes up to `most`.
    pub(super) fn matrix(&self, most: f64) -> [f64; 3] {
        let [g, across] = self.slopes.map(|g| g.clamp(0.0, most));
        let [x, z] = self.along;
        [
            g * x * x + across * z * z,
            (g - across) * x * z,
            g * z * z + across * x * x,
        ]
    }
}
