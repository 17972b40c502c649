//! One case step by step, for who looks at its states.

use super::{start, stepper};
use crate::contact::StepFlexibility;
use crate::methods::{AverageAcceleration, ContactState, ManyModes, Recursion, Scheme};
use crate::system::System;

/// The state of a structure after a step.
pub trait State {
    /// The contact.
    fn contact(&self) -> ContactState<1>;
    /// Coordinates and velocities of the modes.
    fn modes(&self) -> Vec<[f64; 2]>;
}

/// The constant average acceleration method for one system.
pub type Stepper = <AverageAcceleration as Scheme>::Lanes<1, ManyModes>;

impl<N: Recursion<1>> State for N {
    fn contact(&self) -> ContactState<1> {
        Recursion::contact(self)
    }

    fn modes(&self) -> Vec<[f64; 2]> {
        Recursion::modes(self)
            .map(|(x, v)| [x.0[0], v.0[0]])
            .collect()
    }
}

/// The flexibilities of a system for its contact in both sub-steps of its method; `None` without a mode.
pub fn flexibilities(system: &System) -> Option<[StepFlexibility<1>; 2]> {
    fn of<D: Scheme>(_: &D, system: &System) -> Option<[StepFlexibility<1>; 2]> {
        Some(stepper::<1, D::Lanes<1, ManyModes>, _>(&[*system])?.flexibilities())
    }
    slipgap_system::each_method!(&system.method, method => of(method, system))
}

/// Integrates one system to its last step; `visit` gets the number of each step, from 0 on, and the state of the structure.
pub fn visit(system: &System, visit: impl FnMut(u64, &dyn State)) {
    fn of<D: Scheme>(_: &D, system: &System, visit: impl FnMut(u64, &dyn State)) {
        visit_by::<D::Lanes<1, ManyModes>>(system, visit);
    }
    slipgap_system::each_method!(&system.method, method => of(method, system, visit));
}

/// The same with one method.
pub(super) fn visit_by<N: Recursion<1>>(system: &System, mut visit: impl FnMut(u64, &dyn State)) {
    let Some((mut stepper, mut law)) = start::<1, N, _>(&[*system]) else {
        return;
    };
    visit(0, &stepper);
    for step in 1..=system.last {
        stepper.step(&mut law);
        visit(step, &stepper);
    }
}
