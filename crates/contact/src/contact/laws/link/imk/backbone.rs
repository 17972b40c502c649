//! The first loading in one direction, and what is left of it.

/// The first loading in one direction; its numbers are positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Backbone {
    /// Fy.
    pub yield_force: f64,
    /// Slope from the yield point to the cap.
    pub hardening: f64,
    /// Slope beyond the cap, below 0.
    pub falling: f64,
    /// The force at which the falling line meets r = 0.
    pub projected: f64,
    /// The residual force.
    pub residual: f64,
    /// The deflection at which the part fails.
    pub ultimate: f64,
    /// D.
    pub damage: f64,
}

/// What is left of a first loading.
#[derive(Debug, Clone, Copy)]
pub(super) struct Degraded {
    /// Slope from the yield point to the cap.
    pub(super) hardening: f64,
    pub(super) falling: f64,
    /// Deflection and force of the cap.
    pub(super) cap: [f64; 2],
    /// Where the residual begins, and its force.
    pub(super) residual: [f64; 2],
}

impl Backbone {
    /// Fy, the deflections from the yield point to the cap and from there to zero, the cap and the residual over Fy, the deflection at
    /// failure, and D.
    pub fn new(
        stiffness: f64,
        [yield_force, to_cap, to_zero]: [f64; 3],
        [cap, residual]: [f64; 2],
        [ultimate, damage]: [f64; 2],
    ) -> Backbone {
        let yielding = yield_force / stiffness;
        let top = cap * yield_force;
        let falling = -top / to_zero;
        Backbone {
            yield_force,
            hardening: (top - yield_force) / to_cap,
            falling,
            projected: top - falling * (yielding + to_cap),
            residual: residual * yield_force,
            ultimate,
            damage,
        }
    }

    pub(super) fn numbers(self) -> [f64; 7] {
        [
            self.yield_force,
            self.hardening,
            self.falling,
            self.projected,
            self.residual,
            self.ultimate,
            self.damage,
        ]
    }

    /// The force at the cap.
    pub(super) fn top(&self, stiffness: f64) -> f64 {
        self.degraded(stiffness, 1.0, 1.0).cap[1]
    }

    /// What is left of it with these factors of strength and of the cap.
    pub(super) fn degraded(&self, stiffness: f64, strength: f64, cap: f64) -> Degraded {
        let yield_force = self.yield_force * strength;
        let hardening = self.hardening * strength;
        let start = yield_force - hardening * (yield_force / stiffness);
        let r = (self.projected * cap - start) / (hardening - self.falling);
        let cap = [r, start + hardening * r];
        let end = r + (self.residual - cap[1]) / self.falling;
        Degraded {
            hardening,
            falling: self.falling,
            cap,
            residual: [end, self.residual],
        }
    }
}

impl Degraded {
    /// The force of the first loading at a deflection beyond yielding, at least the residual.
    pub(super) fn force(&self, r: f64) -> f64 {
        let [cap, top] = self.cap;
        let slope = if r < cap {
            self.hardening
        } else {
            self.falling
        };
        (top + slope * (r - cap)).max(self.residual[1])
    }
}
