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
        self.falling_with(self.falling, [stiffness, strength, cap])
    }

    /// The same, of which the falling line turns about its force at r = 0 as the yield force comes down to the residual.
    pub(super) fn turned(&self, stiffness: f64, strength: f64, cap: f64) -> Degraded {
        let above = strength * self.yield_force - self.residual;
        let falling = match (strength < 1.0, above > 0.0) {
            (false, _) => self.falling,
            (true, true) => above / (self.yield_force - self.residual) * self.falling,
            (true, false) => 0.0,
        };
        self.falling_with(falling, [stiffness, strength, cap])
    }

    fn falling_with(&self, falling: f64, [stiffness, strength, factor]: [f64; 3]) -> Degraded {
        let yield_force = self.yield_force * strength;
        let hardening = self.hardening * strength;
        let start = yield_force - hardening * (yield_force / stiffness);
        let r = (self.projected * factor - start) / (hardening - falling);
        let cap = [r, start + hardening * r];
        let end = match falling < 0.0 {
            true => r + (self.residual - cap[1]) / falling,
            false => f64::INFINITY,
        };
        Degraded {
            hardening,
            falling,
            cap,
            residual: [end, self.residual],
        }
    }
}

impl Degraded {
    /// Where a line of this slope from a point below it meets it.
    pub(super) fn meets(&self, slope: f64, [r, s]: [f64; 2]) -> f64 {
        let [[cap, top], [_, residual]] = [self.cap, self.residual];
        let to = |bent: f64| match slope > bent {
            true => r + (top + bent * (r - cap) - s) / (slope - bent),
            false => f64::INFINITY,
        };
        let line = to(self.hardening).min(to(self.falling));
        line.max(r + (residual - s) / slope)
    }

    /// Up to where it is at its residual before it hardens; no number if it does not harden.
    pub(super) fn hardens_from(&self) -> f64 {
        let [[cap, top], [_, residual]] = [self.cap, self.residual];
        match top > residual {
            true => cap - (top - residual) / self.hardening,
            false => f64::NAN,
        }
    }

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
