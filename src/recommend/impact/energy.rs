//! The change of energy of an impact. `energy_drift_max` does not show a gain if a loss is larger, and neither it nor
//! `energy_drift_final` shows what the damping of the contact or the method takes or adds.

use crate::contact::StoredEnergy;
use crate::history::History;
use crate::lane::Lane;
use crate::methods::MethodChoice;
use crate::problem::Case;
use crate::problem::impact::BarImpact;
use crate::recommend::EnergyChange;
use crate::solve;
use crate::system::System;

/// The gain is the largest of drift of the contact minus numerical dissipation over all steps from t = 0, over E_0. It is not negative,
/// because step 0 is one of them. The loss is what is gone at the last step: damping of the contact and numerical dissipation minus drift.
/// The exact motion keeps its energy.
pub fn energy_change(case: &Case, computed: &History) -> Option<EnergyChange> {
    let system = BarImpact.system(case).ok()?;
    let start = system.linear.energy();
    let (mut change, damping) = by_contact(&system, computed);
    // Constant average acceleration adds and takes nothing.
    if system.method != MethodChoice::AverageAcceleration {
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
    let [before, after] = system.method.work_weights();
    let (mut bars, mut damping) = (0.0, 0.0);
    let mut last: Option<[f64; 3]> = None;
    let states = computed.displacement().iter().zip(computed.force());
    let drifts = states.map(|(r, force)| {
        let (r, s) = (*r, -force);
        let kept = system.law.conservative_force(r, s);
        if let Some([r_last, kept_last, damped_last]) = last {
            bars -= (before * kept_last + after * kept) * (r - r_last);
            damping += (before * damped_last + after * (s - kept)) * (r - r_last);
        }
        last = Some([r, kept, s - kept]);
        bars + system.law.stored_energy(r, s)
    });
    (drifts.collect(), damping)
}

/// What the method adds to the energy of the modes, up to every step.
fn by_method(system: &System) -> Vec<f64> {
    let [before, after] = system.method.work_weights();
    let start = system.linear.energy();
    let mut work = 0.0;
    let mut last: Option<[f64; 2]> = None;
    let mut added = Vec::new();
    solve::visit(system, |_, state| {
        let contact = state.contact();
        let (Lane([r]), Lane([s])) = (contact.displacement, contact.force);
        if let Some([r_last, s_last]) = last {
            work += (before * s_last + after * s) * (r - r_last);
        }
        last = Some([r, s]);
        let modes = state.modes().into_iter().enumerate();
        let energy: f64 = modes
            .map(|(j, [x, v])| system.linear.mode(j).mode.energy(x, v))
            .sum();
        added.push(energy + work - start);
    });
    added
}
