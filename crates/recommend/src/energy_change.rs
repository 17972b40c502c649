//! The changes of energy of the problems of the papers, and the largest ones allowed.

use slipgap_contact::contact::StoredEnergy;
use slipgap_contact::lane::Lane;
use slipgap_motion::history::History;
use slipgap_motion::solve;
use slipgap_problem::metrics::impact::step_work;
use slipgap_problem::problem::impact::BarImpact;
use slipgap_problem::problem::{Case, Textbook};
use slipgap_system::methods::ContactWork;
use slipgap_system::system::System;

/// Largest changes of energy of an impact and of a structure. A gain of 1 % of the energy is 0.5 % of a velocity, less than most tolerances
/// allow. A loss of 10 % is 5 % of a velocity; without a limit methods would be chosen that damp the whole motion.
pub const LIMITS: EnergyChange = EnergyChange {
    gain: 0.01,
    loss: 0.1,
};

/// The same with friction. A softened law returns energy that the exact motion has lost. 5 % of the energy is 2.5 % of an amplitude.
pub const FRICTION_LIMITS: EnergyChange = EnergyChange {
    gain: 0.05,
    loss: f64::INFINITY,
};

/// The change of energy of a run, relative to the energy at the start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EnergyChange {
    /// The largest gain at any step.
    pub gain: f64,
    /// The loss up to the last step; zero for a problem that loses energy in the exact motion.
    pub loss: f64,
}

impl EnergyChange {
    /// Above all limits.
    pub const UNKNOWN: EnergyChange = EnergyChange {
        gain: f64::INFINITY,
        loss: f64::INFINITY,
    };
}

/// The largest excess of the mechanical energy (X^2 + V^2)/2 over that of the exact motion at a step, over the energy at release: what
/// the motion has more than the energy at release minus the exact work of friction. It is not negative, because both begin alike.
pub fn energy_gain(computed: &History, exact: &History) -> f64 {
    let energies = |of: &History| -> Vec<f64> {
        let states = of.displacement().iter().zip(of.velocity());
        states.map(|(x, v)| 0.5 * (x * x + v * v)).collect()
    };
    let (computed, exact) = (energies(computed), energies(exact));
    let Some(start) = exact.first().copied() else {
        return f64::INFINITY;
    };
    let excess = computed.iter().zip(&exact).map(|(c, e)| (c - e) / start);
    excess.fold(0.0, f64::max)
}

/// The change of energy of an impact. `energy_drift_max` does not show a gain if a loss is larger, and neither it nor
/// `energy_drift_final` shows what the damping of the contact or the method takes or adds.
///
/// The gain is the largest of drift of the contact minus numerical dissipation over all steps from t = 0, over E_0. It is not negative,
/// because step 0 is one of them. The loss is what is gone at the last step: damping of the contact and numerical dissipation minus drift.
/// The exact motion keeps its energy.
pub fn energy_change(case: &Case, computed: &History) -> Option<EnergyChange> {
    let system = BarImpact.system(case)?;
    let start = system.linear.energy();
    let (mut change, damping) = by_contact(&system, computed);
    // Constant average acceleration adds and takes nothing.
    if !system.method.conserves() {
        for (change, added) in change.iter_mut().zip(by_method(&system)) {
            *change += added;
        }
    }
    let gain = change.iter().copied().fold(0.0, f64::max);
    let last = change.last()?;
    Some(EnergyChange {
        gain: gain / start,
        loss: (damping - last) / start,
    })
}

/// The drift of the energy of bars and contact at every step, and what the damping of the contact takes.
fn by_contact(system: &System, computed: &History) -> (Vec<f64>, f64) {
    let form = step_work(&[*system]);
    let (mut bars, mut damping) = (0.0, 0.0);
    let mut last: Option<[f64; 4]> = None;
    let states = computed.displacement().iter().zip(computed.velocity());
    let drifts = states.zip(computed.force()).map(|((r, rdot), force)| {
        // rdot is in c, r in c T_I/2.
        let (r, rate, s) = (*r, 2.0 * rdot, -force);
        let kept = system.law.conservative_force(r, s);
        if let Some([r_last, rate_last, kept_last, damped_last]) = last {
            let ends = [[r_last, r], [rate_last, rate]];
            bars -= work(&form, [kept_last, kept], ends);
            damping += work(&form, [damped_last, s - kept], ends);
        }
        last = Some([r, rate, kept, s - kept]);
        bars + system.law.stored_energy(r, s)
    });
    (drifts.collect(), damping)
}

/// The work of a force over a step, from both ends of force, r and rdot.
fn work(form: &ContactWork<1>, force: [f64; 2], [r, rdot]: [[f64; 2]; 2]) -> f64 {
    let lanes = |ends: [f64; 2]| ends.map(|x| Lane([x]));
    let Lane([work]) = form.force(lanes(force)) * form.displacement(lanes(r), lanes(rdot));
    work
}

/// What the method adds to the energy of the modes, up to every step.
fn by_method(system: &System) -> Vec<f64> {
    let form = step_work(&[*system]);
    let start = system.linear.energy();
    let mut sum = 0.0;
    let mut last: Option<[f64; 3]> = None;
    let mut added = Vec::new();
    solve::visit(system, |_, state| {
        let contact = state.contact();
        let [r, rate, s] = [contact.displacement, contact.velocity, contact.force].map(|x| x.0[0]);
        if let Some([r_last, rate_last, s_last]) = last {
            sum += work(&form, [s_last, s], [[r_last, r], [rate_last, rate]]);
        }
        last = Some([r, rate, s]);
        let modes = state.modes().into_iter().enumerate();
        let energy: f64 = modes
            .map(|(j, [x, v])| system.linear.mode(j).mode.energy(x, v))
            .sum();
        added.push(energy + sum - start);
    });
    added
}
