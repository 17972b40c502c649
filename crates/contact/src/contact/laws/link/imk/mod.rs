//! A part that degrades: the model of Ibarra, Medina and Krawinkler, bilinear, peak-oriented, or with pinching.

use crate::contact::laws::shared::Shared;
use crate::contact::prelude::*;
mod backbone;
mod described;
mod state;
mod walk;

use backbone::Backbone;
use state::State;
use std::ops::Deref;
use walk::Walk;

/// A plastic hinge that hardens, loses strength from its cap on, and degrades with the energy that it takes (Ibarra, Medina and
/// Krawinkler 2005). OpenSees has it as `IMKPeakOriented` and `IMKPinching`.
///
/// In each direction the first loading is elastic with k up to Fy, goes on over `Up` to the cap Fcap = `Fcap_ratio` Fy, falls within
/// `Upc` to zero, stays at the residual `Fres_ratio` Fy and fails at `Uu`. Unloading has a stiffness of its own. Once the force has
/// changed its sign, it goes in a straight line to the peak of this direction, or first to the last turn if that line is steeper;
/// pinching bends the line at (1 - `kappa_D`) times the plastic part of the peak, with `kappa_F` times the slope to the peak.
///
/// What has been dissipated degrades four numbers by the rule of Rahnama and Krawinkler (1993), with E_t = lambda Fy:
///
/// ```text
/// beta = (E_i/(E_t - E))^c
/// ```
///
/// At every change of sign of S, E_i is the energy since the last one, E that of all before: (1 - `beta_S` D) multiplies Fy and
/// the hardening, (1 - `beta_C` D) the force at which the falling line meets r = 0, (1 + `beta_A` D) the deflection of the peak, all in the
/// direction that begins. At every turn from loading (1 - `beta_K`) multiplies the stiffness of unloading, with both energies less the
/// elastic part S^2/2k. The part fails where a beta exceeds 1, or E_t is used up.
///
/// The bilinear form goes on with the stiffness of unloading up to the first loading of the direction as it is left, its hardening line
/// extended to r < 0, but not below the residual (Lignos and Krawinkler 2011; `IMKBilin`). Its falling line turns about the force at r = 0
/// so that it has the slope of the first one times (Fy - F_res)/(Fy(0) - F_res), as that of `IMKBilin`. There, other than here, a part
/// that has been at its residual unloads with k/2, hardens at most from the residual on, and a failure by `Uu` leaves the residual of the
/// other direction.
///
/// Energy is the sum of S dr with the mean force of each step, and known at its ends: so has OpenSees it, whose forces are these along the
/// same steps, but in these cases: there a used-up E_t gives a beta below 0 that counts as 0 or no number at all, and a step that begins
/// with S = 0 to the last bit may be taken for a turn. Without a memory of energy, S^2/2k is stored and the rest dissipated.
///
/// The force in a step of a structure follows the way from r, line by line. A failure that would make it jump takes effect in
/// the next step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Imk(&'static Numbers);

/// The numbers of the law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Numbers {
    /// k > 0.
    pub stiffness: f64,
    /// The first loading to r < 0, with its signs turned, and to r > 0.
    pub sides: [Backbone; 2],
    /// E_t of S, C, A and K; infinite without degradation.
    pub energies: [f64; 4],
    /// c of them.
    pub exponents: [f64; 4],
    /// How it is loaded again.
    pub reloading: Reloading,
}

/// How a part is loaded again after a change of sign of S.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Reloading {
    /// With the stiffness of unloading, up to what is left of the first loading.
    Bilinear,
    /// Towards the peak.
    PeakOriented,
    /// The same over the point of pinching of `kappa_F` and `kappa_D`.
    Pinching([f64; 2]),
}

/// The law over a step.
#[derive(Debug, Clone, Copy)]
pub struct Step<const L: usize> {
    laws: [Imk; L],
    /// Flexibilities for S(i) and S(i+1).
    h: [Lane<L>; 2],
}

/// The state of each case, from the first step on.
#[derive(Debug, Clone, Copy)]
pub struct States<const L: usize>([Option<State>; L]);

impl<const L: usize> Default for States<L> {
    fn default() -> Self {
        States([None; L])
    }
}

impl Deref for Imk {
    type Target = Numbers;

    fn deref(&self) -> &Numbers {
        self.0
    }
}

impl Imk {
    /// The law of these numbers.
    pub fn new(numbers: Numbers) -> Imk {
        static KNOWN: Shared<Numbers> = Shared::new();
        let [first, second] = numbers.sides.map(Backbone::numbers);
        let reloading = match numbers.reloading {
            Reloading::Bilinear => [f64::INFINITY; 2],
            Reloading::PeakOriented => [f64::NAN; 2],
            Reloading::Pinching(kappas) => kappas,
        };
        let of_sides = [numbers.stiffness].into_iter().chain(first).chain(second);
        let with_energies = of_sides.chain(numbers.energies).chain(numbers.exponents);
        Imk(KNOWN.get(with_energies.chain(reloading), numbers))
    }
}

impl StoredEnergy for Imk {
    fn stored_energy(&self, _: f64, s: f64) -> f64 {
        0.5 * s * s / self.stiffness
    }
}

impl Law for Imk {
    type Step<const L: usize> = Step<L>;

    fn step<const L: usize>(laws: &[Self; L], on: &StepFlexibility<L>) -> Step<L> {
        Step {
            laws: *laws,
            h: [on.start.h, on.end.h],
        }
    }
}

impl<const L: usize> StepLaw<L> for Step<L> {
    type Memory = States<L>;

    fn force(&self, trial: &Trial<L>, memory: &mut States<L>) -> Lane<L> {
        let [start, end] = self.h;
        let mut forces = Lane::splat(0.0);
        for (l, law) in self.laws.iter().enumerate() {
            let [r, mut s, h] = [trial.displacement.0[l], trial.force.0[l], end.0[l]];
            let free = r + (trial.change.0[l] - s * start.0[l]);
            let state = memory.0[l].unwrap_or_else(|| {
                // Loaded from r = 0 on.
                let (first, state) = Walk::new(law, State::new(law), [0.0; 2]).to(r, 0.0);
                if s == 0.0 {
                    s = first;
                }
                state
            });
            let (force, after) = Walk::new(law, state, [r, s]).to(free, h);
            forces.0[l] = force;
            memory.0[l] = Some(after);
        }
        forces
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{Lugre, RunningLaw};
    use std::mem::size_of;

    /// The force at the end of a path from r = 0 through these turns.
    fn after(law: &Imk, turns: &[f64]) -> f64 {
        let (mut at, mut state) = ([0.0; 2], State::new(law));
        for turn in turns {
            let from = at[0];
            for i in 1..=100 {
                let r = from + (turn - from) * f64::from(i) / 100.0;
                let (force, next) = Walk::new(law, state, at).to(r, 0.0);
                (at, state) = ([r, force], next);
            }
        }
        at[1]
    }

    /// A part that is unloaded on its way to the point of pinching goes on to that point: a small loop within the way changes nothing
    /// beyond it. With the numbers below S is 0 at r = -3.6, and the point is at r = 1.8 under 0.3 times 1.4 times 5.4/8.6.
    #[test]
    fn a_small_loop_before_the_point_of_pinching_changes_nothing_beyond_it() {
        let side = Backbone {
            yield_force: 1.0,
            hardening: 0.1,
            falling: -0.1,
            projected: 3.0,
            residual: 0.1,
            ultimate: 100.0,
            damage: 1.0,
        };
        let law = Imk::new(Numbers {
            stiffness: 1.0,
            sides: [side; 2],
            energies: [f64::INFINITY; 4],
            exponents: [1.0; 4],
            reloading: Reloading::Pinching([0.3, 0.5]),
        });
        let slope = 0.3 * 1.4 / 8.6;
        for (r, wanted) in [(0.5, 4.1 * slope), (1.7, 5.3 * slope)] {
            for way in [&[5.0, -5.0, r][..], &[5.0, -5.0, 0.0, -0.1, r]] {
                let force = after(&law, way);
                assert!((force - wanted).abs() < 1e-12, "{way:?} {force} {wanted}");
            }
        }
        let beyond = after(&law, &[5.0, -5.0, 3.0]);
        assert!((after(&law, &[5.0, -5.0, 0.0, -0.1, 3.0]) - beyond).abs() < 1e-12);
    }

    /// A law of every kind is copied for each case and step.
    #[test]
    fn it_makes_no_other_law_larger() {
        assert_eq!(size_of::<Imk>(), size_of::<usize>());
        fn runs<W: Law, const L: usize>() -> usize {
            size_of::<RunningLaw<W::Step<L>, L>>()
        }
        assert!(runs::<Imk, 1>() <= runs::<Lugre, 1>());
        assert!(runs::<Imk, 8>() <= runs::<Lugre, 8>());
    }
}
