//! What the law remembers from step to step.

use super::backbone::Degraded;
use super::{Numbers, Reloading};

/// Which line the part is on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Branch {
    /// It has not yielded.
    Elastic,
    /// With the stiffness of unloading.
    Unloading,
    /// To the point of pinching.
    ToPinch,
    /// To the last turn.
    ToLast,
    /// To the peak.
    ToPeak,
    /// Between the peak and the cap.
    ToCap,
    /// From the cap to the residual.
    Falling,
    /// At the residual.
    Residual,
    /// Without a force, for good.
    Failed,
}

/// The state of a direction, with its signs turned where r < 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Side {
    /// Factor of Fy and of the hardening.
    pub(super) strength: f64,
    /// Factor of the force at which the falling line meets r = 0.
    pub(super) cap: f64,
    /// Deflection of the peak; its force is that of the first loading there.
    pub(super) peak: f64,
    /// Deflection and force of the last turn.
    pub(super) last: [f64; 2],
}

/// The state of the part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct State {
    pub(super) branch: Branch,
    /// Whether its branch beyond unloading is in the direction r > 0.
    pub(super) positive: bool,
    /// To r < 0 and to r > 0.
    pub(super) sides: [Side; 2],
    /// Stiffness of unloading.
    pub(super) unloading: f64,
    /// Slope of the line to the point of pinching, the last turn or the peak.
    pub(super) reloading: f64,
    /// The point of pinching, with the signs of its side.
    pub(super) pinch: [f64; 2],
    /// Energy taken up to now, and up to the last change of sign of S.
    pub(super) energy: [f64; 2],
}

impl State {
    pub(super) fn new(law: &Numbers) -> State {
        let side = |which: usize| {
            let force = law.sides[which].yield_force;
            let yielding = force / law.stiffness;
            Side {
                strength: 1.0,
                cap: 1.0,
                peak: yielding,
                last: [yielding, force],
            }
        };
        State {
            branch: Branch::Elastic,
            positive: true,
            sides: [0, 1].map(side),
            unloading: law.stiffness,
            reloading: law.stiffness,
            pinch: [0.0; 2],
            energy: [0.0; 2],
        }
    }

    /// beta of S, C, A or K for the energy E_i after E; above 1 where the part fails.
    fn beta(law: &Numbers, which: usize, [dissipated, before]: [f64; 2]) -> f64 {
        let left = law.energies[which] - before;
        if dissipated <= 0.0 {
            return 0.0;
        }
        match left > 0.0 {
            true => libm::pow(dissipated / left, law.exponents[which]),
            false => f64::INFINITY,
        }
    }

    /// A turn from loading at this point, in the signs of a side; whether the part survives it.
    pub(super) fn turn(&mut self, law: &Numbers, side: usize, [r, s]: [f64; 2]) -> bool {
        self.branch = Branch::Unloading;
        let side_state = &mut self.sides[side];
        side_state.last = [r, s];
        side_state.peak = side_state.peak.max(r);
        let elastic = 0.5 * s * (s / self.unloading);
        let [now, before] = self.energy;
        let beta = State::beta(law, 3, [now - before - elastic, now - elastic]);
        if beta > 1.0 {
            return false;
        }
        self.unloading *= 1.0 - beta;
        true
    }

    /// A change of sign of S at this r, in the signs of the side that begins; whether the part survives it.
    pub(super) fn begin(&mut self, law: &Numbers, side: usize, r: f64) -> bool {
        let [now, before] = self.energy;
        let [strength, cap, peak] =
            [0, 1, 2].map(|which| State::beta(law, which, [now - before, now]));
        self.energy[1] = now;
        let backbone = &law.sides[side];
        let side_state = &mut self.sides[side];
        side_state.strength *= 1.0 - strength.min(1.0) * backbone.damage;
        side_state.cap *= 1.0 - cap.min(1.0) * backbone.damage;
        side_state.peak *= 1.0 + peak.min(1.0) * backbone.damage;
        let peak_force = self.peak(law, side)[1];
        self.positive = side == 1;
        let survives = strength <= 1.0 && cap <= 1.0 && peak <= 1.0;
        match law.reloading {
            Reloading::Bilinear => survives,
            Reloading::PeakOriented | Reloading::Pinching(_) => {
                if survives && peak_force != 0.0 {
                    self.aim(law, side, r);
                }
                survives && peak_force != 0.0
            }
        }
    }

    /// Chooses the line from r with S = 0.
    fn aim(&mut self, law: &Numbers, side: usize, r: f64) {
        let [peak, force] = self.peak(law, side);
        let to_peak = force / (peak - r);
        if let Reloading::Pinching([kappa_f, kappa_d]) = law.reloading {
            let bend = (1.0 - kappa_d) * (peak - force / self.unloading);
            self.pinch = [bend, kappa_f * force * (bend - r) / (peak - r)];
            if r < bend {
                self.branch = Branch::ToPinch;
                self.reloading = self.pinch[1] / (bend - r);
                return;
            }
        }
        let [last, last_force] = self.sides[side].last;
        let to_last = last_force / (last - r);
        (self.branch, self.reloading) = match r < last && last_force < force && to_last > to_peak {
            true => (Branch::ToLast, to_last),
            false => (Branch::ToPeak, to_peak),
        };
    }

    /// Whether a side that is at S = 0 or above is loaded by the stiffness of unloading, up to its first loading as it is left.
    pub(super) fn is_bilinear(&self, law: &Numbers, side: usize) -> bool {
        law.reloading == Reloading::Bilinear && self.positive == (side == 1)
    }

    /// The line of the first loading that begins at r; whether it has a force.
    pub(super) fn load(&mut self, law: &Numbers, side: usize, r: f64) -> bool {
        let left = self.degraded(law, side);
        let [[cap, top], [end, residual]] = [left.cap, left.residual];
        (self.positive, self.branch) = (
            side == 1,
            match () {
                () if top > residual && r < left.hardens_from() => Branch::Residual,
                () if top > residual && r < cap => Branch::ToCap,
                () if top > residual && r < end => Branch::Falling,
                () => Branch::Residual,
            },
        );
        residual > 0.0 || (top > residual && r < end)
    }

    /// The line beyond the last turn, from which it was unloaded.
    pub(super) fn go_on(&mut self, law: &Numbers, side: usize) {
        let [peak, force] = self.peak(law, side);
        let [last, last_force] = self.sides[side].last;
        let to_peak = (force - last_force) / (peak - last);
        self.positive = side == 1;
        (self.branch, self.reloading) = (Branch::ToPeak, to_peak);
        if let Reloading::Pinching(_) = law.reloading {
            let [bend, bend_force] = self.pinch;
            let to_bend = (bend_force - last_force) / (bend - last);
            let between = last < bend && last_force < bend_force;
            if between && bend < peak && bend_force < force && to_bend < to_peak {
                (self.branch, self.reloading) = (Branch::ToPinch, to_bend);
            }
        }
    }

    /// The line beyond the point of pinching.
    pub(super) fn leave_pinch(&mut self, law: &Numbers, side: usize) {
        let [peak, force] = self.peak(law, side);
        let [last, last_force] = self.sides[side].last;
        let [bend, bend_force] = self.pinch;
        let to_peak = (force - bend_force) / (peak - bend);
        let to_last = (last_force - bend_force) / (last - bend);
        let between = bend < last && bend_force < last_force && last_force < force;
        (self.branch, self.reloading) = match between && to_last > to_peak {
            true => (Branch::ToLast, to_last),
            false => (Branch::ToPeak, to_peak),
        };
    }

    /// The line beyond the last turn, to which it went.
    pub(super) fn leave_last(&mut self, law: &Numbers, side: usize) {
        let [peak, force] = self.peak(law, side);
        let [last, last_force] = self.sides[side].last;
        (self.branch, self.reloading) = (Branch::ToPeak, (force - last_force) / (peak - last));
    }

    /// The peak of a side.
    pub(super) fn peak(&self, law: &Numbers, side: usize) -> [f64; 2] {
        let r = self.sides[side].peak;
        [r, self.degraded(law, side).force(r)]
    }

    /// What is left of the first loading of a side.
    pub(super) fn degraded(&self, law: &Numbers, side: usize) -> Degraded {
        let side_state = &self.sides[side];
        let [strength, cap] = [side_state.strength, side_state.cap];
        match law.reloading {
            Reloading::Bilinear => law.sides[side].turned(law.stiffness, strength, cap),
            Reloading::PeakOriented | Reloading::Pinching(_) => {
                law.sides[side].degraded(law.stiffness, strength, cap)
            }
        }
    }
}
