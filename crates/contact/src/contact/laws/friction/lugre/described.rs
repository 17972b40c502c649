//! What the LuGre model says of itself.

use super::Lugre;
use crate::contact::prelude::*;

impl StoredEnergy for Lugre {
    /// That of the bristles if they alone make S; with damping S does not tell z, and the energy of the bristles counts as
    /// dissipated until they give it back.
    fn stored_energy(&self, _: f64, s: f64) -> f64 {
        if self.sigma1 == 0.0 && self.sigma2 == 0.0 {
            self.bristle_energy(s)
        } else {
            0.0
        }
    }
}

impl Described for Lugre {
    const KIND: ContactKind = ContactKind::Friction;
    const NAME: &'static str = "lugre";
    const OFFERS: &'static [Offer] = &[Offer::new(Self::NAME, |given| {
        let ratio = given.need("static_ratio")?;
        // Without a fall of the limit v_S has no effect.
        let stribeck_velocity = match (ratio > 1.0, given.given("stribeck_velocity")) {
            (false, None) => 1.0,
            _ => given.need("stribeck_velocity")?,
        };
        Ok(Form::of(Lugre {
            sigma0: given.need("sigma0")?,
            sigma1: given.need("sigma1")?,
            sigma2: given.need("sigma2")?,
            limit: given.limit(),
            static_limit: ratio * given.limit(),
            stribeck_velocity,
        }))
    })
        .in_oscillator(
            "bristles with stiffness sigma0, damping sigma1 and viscosity sigma2 (Canudas de Wit et al. 1995)",
            of_oscillator![SIGMA0, SIGMA1, SIGMA2, STATIC_RATIO, STRIBECK_VELOCITY],
        )
        .in_structures(
            "friction, bristles with stiffness sigma0, damping sigma1 and viscosity sigma2 (Canudas de Wit et al. 1995)",
            of_structures![SIGMA0, SIGMA1, SIGMA2, STATIC_RATIO, STRIBECK_VELOCITY_OF_STATIC],
        )];
    const IN_PLANE: InPlane<Self> = Some(|law, on| AnyPlaneLaw::new(*law, on));
    const CLOSED_FORM: ClosedForm<Self> = ClosedForm::Driven(|law, velocity, time| {
        let [g, _] = law.strength(velocity);
        let faded = libm::exp(-law.sigma0 * velocity * time / g);
        let damping = (law.sigma1 * faded + law.sigma2) * velocity;
        Some(g * (1.0 - faded) + damping)
    });
}

impl Properties for Lugre {
    fn shown(&self) -> Vec<(&'static str, f64)> {
        vec![("sigma0 =", self.sigma0)]
    }

    fn largest_stiffness(&self, _: f64) -> f64 {
        self.sigma0 * (1.0 + self.static_limit / self.limit)
    }

    fn initial_stiffness(&self, _: f64) -> f64 {
        if self.limit > 0.0 { self.sigma0 } else { 0.0 }
    }

    fn reach(&self) -> f64 {
        (4.0 * self.static_limit / self.sigma0).max(1.0)
    }

    fn has_rigid_form(&self) -> bool {
        true
    }

    fn over_velocity(&self) -> bool {
        true
    }

    fn falls(&self) -> bool {
        self.static_limit > self.limit
    }

    /// Whether every step with these flexibilities has one root; if not, some may have more.
    ///
    /// With m = L_s/L_k - 1, sigma0 z(i+1) falls with r(i+1) at most at the rate
    ///
    /// ```text
    /// q = m sigma0 + min(0.8578 (L_s - L_k)/(v_S dt) (1 + m exp(-1 - 1/m)), 0.7358 m (1 + m) sigma0)
    /// ```
    ///
    /// the first term from bristles beyond L_k, the second from the fall of g, whose slope is at most 0.8578 (L_s - L_k)/v_S and
    /// whose slope times velocity is at most 0.7358 (L_s - L_k). So h (1 + 2 sigma1/(sigma0 dt)) q < 1 + sigma2 h_rate is enough.
    fn has_one_root(&self, on: &StepFlexibility<1>) -> bool {
        if self.static_limit == self.limit {
            return true;
        }
        let [h, h_rate, dt] = [on.end.h.0[0], on.end.h_rate.0[0], on.dt.0[0]];
        if h == 0.0 {
            return true;
        }
        let m = self.static_limit / self.limit - 1.0;
        let range = self.static_limit - self.limit;
        let slope_by_dt = 0.8578 * range / (self.stribeck_velocity * dt);
        let steep = slope_by_dt * (1.0 + m * libm::exp(-1.0 - 1.0 / m));
        let fast = 0.7358 * m * (1.0 + m) * self.sigma0;
        let q = m * self.sigma0 + if steep < fast { steep } else { fast };
        h * (1.0 + 2.0 * self.sigma1 / (self.sigma0 * dt)) * q < 1.0 + self.sigma2 * h_rate
    }

    fn unbent_force(&self, rdot: f64) -> Option<f64> {
        Some(match self.limit > 0.0 {
            true => (self.sigma1 + self.sigma2) * rdot,
            false => 0.0,
        })
    }

    fn evolution(&self) -> Option<&dyn Evolution> {
        Some(self)
    }
}
