//! The elements as the papers print them: a force and its tangent, with the errata corrected (docs/errata.md).

/// Force and tangent of an element for a relative displacement and velocity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElementState {
    /// S.
    pub force: f64,
    /// k~ = dS/dr [F (11)].
    pub stiffness: f64,
    /// c~ = dS/drdot [F (18)].
    pub damping: f64,
    /// Branch of the law: -1 below the linear range, 0 in it, 1 above it.
    pub branch: i8,
}

/// A two-node element with a piecewise linear law.
pub trait Element: std::fmt::Debug {
    /// The state at the end of the last step.
    fn state(&self) -> ElementState;
    /// The state at `r`, `rdot` for a step from the end of the last one.
    fn trial(&self, r: f64, rdot: f64) -> ElementState;
    /// Makes `r`, `rdot` the end of the step.
    fn commit(&mut self, r: f64, rdot: f64);
}

impl<E: Element + ?Sized> Element for Box<E> {
    fn state(&self) -> ElementState {
        (**self).state()
    }

    fn trial(&self, r: f64, rdot: f64) -> ElementState {
        (**self).trial(r, rdot)
    }

    fn commit(&mut self, r: f64, rdot: f64) {
        (**self).commit(r, rdot)
    }
}

/// Friction, displacement-control model [F (9) to (11)].
#[derive(Debug, Clone, Copy)]
pub struct DisplacementFriction {
    /// Initial stiffness k^C.
    pub stiffness: f64,
    /// Coefficient of friction nu.
    pub nu: f64,
    /// Normal force N, compression negative; may change from step to step.
    pub normal_force: f64,
    /// Slip r^S.
    pub slip: f64,
    state: ElementState,
}

impl DisplacementFriction {
    /// An element with slip `slip` and force `force` at T = 0.
    pub fn new(stiffness: f64, nu: f64, normal_force: f64, slip: f64, force: f64) -> Self {
        let state = ElementState {
            force,
            stiffness,
            damping: 0.0,
            branch: 0,
        };
        DisplacementFriction {
            stiffness,
            nu,
            normal_force,
            slip,
            state,
        }
    }
}

impl Element for DisplacementFriction {
    fn state(&self) -> ElementState {
        self.state
    }

    fn trial(&self, r: f64, _rdot: f64) -> ElementState {
        let (open, strength) = contact(self.normal_force, self.nu);
        let elastic = strength / self.stiffness; // r^E
        let (force, k, branch) = if r >= self.slip + elastic {
            (strength, 0.0, 1)
        } else if r <= self.slip - elastic {
            (-strength, 0.0, -1)
        } else {
            // (11) prints -k^C <N>; the sign in the increment (10) is positive.
            let k = self.stiffness * open;
            (k * (r - self.slip), k, 0)
        };
        ElementState {
            force,
            stiffness: k,
            damping: 0.0,
            branch,
        }
    }

    fn commit(&mut self, r: f64, rdot: f64) {
        self.state = self.trial(r, rdot);
        let (_, strength) = contact(self.normal_force, self.nu);
        // (9) and (10) do not print this rule: in sliding, the slip follows r at the distance r^E.
        self.slip = match self.state.branch {
            0 => self.slip,
            branch => r - f64::from(branch) * strength / self.stiffness,
        };
    }
}

/// Friction, velocity-control model [F (16) to (18)].
#[derive(Debug, Clone, Copy)]
pub struct VelocityFriction {
    /// Initial damping c^C.
    pub damping: f64,
    /// Coefficient of friction nu.
    pub nu: f64,
    /// Normal force N, compression negative; may change from step to step.
    pub normal_force: f64,
    state: ElementState,
}

impl VelocityFriction {
    /// An element at rest.
    pub fn new(damping: f64, nu: f64, normal_force: f64) -> Self {
        let state = ElementState {
            force: 0.0,
            stiffness: 0.0,
            damping,
            branch: 0,
        };
        VelocityFriction {
            damping,
            nu,
            normal_force,
            state,
        }
    }
}

impl Element for VelocityFriction {
    fn state(&self) -> ElementState {
        self.state
    }

    fn trial(&self, _r: f64, rdot: f64) -> ElementState {
        let (open, strength) = contact(self.normal_force, self.nu);
        let limit = strength / self.damping; // rdot^E
        let (force, c, branch) = if rdot >= limit {
            (strength, 0.0, 1)
        } else if rdot <= -limit {
            (-strength, 0.0, -1)
        } else {
            let c = self.damping * open;
            (c * rdot, c, 0)
        };
        ElementState {
            force,
            stiffness: 0.0,
            damping: c,
            branch,
        }
    }

    fn commit(&mut self, r: f64, rdot: f64) {
        self.state = self.trial(r, rdot);
    }
}

/// <N> and nu |N| <N> [F (3), (9)].
fn contact(normal_force: f64, nu: f64) -> (f64, f64) {
    let open = if normal_force < 0.0 { 1.0 } else { 0.0 };
    (open, nu * normal_force.abs() * open)
}

/// Impact spring [I (7) to (9)]: it pushes while r < 0.
#[derive(Debug, Clone, Copy)]
pub struct ImpactElement {
    /// Stiffness k_I.
    pub stiffness: f64,
    state: ElementState,
}

impl ImpactElement {
    /// A spring without force.
    pub fn new(stiffness: f64) -> Self {
        let state = ElementState {
            force: 0.0,
            stiffness: 0.0,
            damping: 0.0,
            branch: 1,
        };
        ImpactElement { stiffness, state }
    }
}

impl Element for ImpactElement {
    fn state(&self) -> ElementState {
        self.state
    }

    fn trial(&self, r: f64, _rdot: f64) -> ElementState {
        // <r> is 1 for r < 0, else 0 [I (8)]; (7) prints S = k_I <r> and means k_I <r> r.
        let pressed = if r < 0.0 { 1.0 } else { 0.0 };
        ElementState {
            force: self.stiffness * pressed * r,
            stiffness: self.stiffness * pressed,
            damping: 0.0,
            branch: if r < 0.0 { 0 } else { 1 },
        }
    }

    fn commit(&mut self, r: f64, rdot: f64) {
        self.state = self.trial(r, rdot);
    }
}
