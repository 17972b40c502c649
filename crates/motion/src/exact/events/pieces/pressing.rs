//! Friction whose normal force other contacts and springs give: the limit is nu times the sum of their compression forces.
//!
//! While none of them begins or ends to press, the limit is linear in the motion, order by order. Forces of stops without compliance
//! come from the constraints; friction that they press and that slides is then a part of these equations.

use super::series::Series;
use crate::exact::events::coordinates::model::Model;
use crate::exact::events::coordinates::pressed::Pressed;
use crate::exact::events::numerics::bernstein::{Polynomial, TERMS};
use crate::exact::events::phases::contact_state::{ContactState, Force};

/// S of a spring on a piece, and whether it is in compression.
#[derive(Debug, Clone)]
pub struct PressingSpring {
    pub force: Polynomial,
    pub presses: bool,
}

impl PressingSpring {
    /// The springs of a contact.
    pub fn of(pressed: &Pressed) -> Vec<PressingSpring> {
        let spring = PressingSpring {
            force: [0.0; TERMS],
            presses: false,
        };
        vec![spring; pressed.springs.len()]
    }
}

impl Series {
    /// Whether the springs press, at the start of a motion.
    pub fn start_pressing(&mut self, model: &Model, states: &[ContactState]) {
        self.press(model, states);
        for spring in self.springs.iter_mut().flatten() {
            let [force, change] = [spring.force[0], spring.force[1]];
            spring.presses = force < 0.0 || force == 0.0 && change < 0.0;
        }
        self.press(model, states);
    }

    /// The same where forces have jumped by more than these tolerances; `turned` is one that has just begun or ended to press.
    pub fn turn_springs(
        &mut self,
        turned: Option<[usize; 2]>,
        tolerance: impl Fn(usize, usize) -> f64,
    ) {
        for (i, springs) in self.springs.iter_mut().enumerate() {
            for (j, spring) in springs.iter_mut().enumerate() {
                if turned == Some([i, j]) {
                    spring.presses = !spring.presses;
                } else if spring.force[0].abs() > tolerance(i, j) {
                    spring.presses = spring.force[0] < 0.0;
                }
            }
        }
    }

    /// The limits of contacts that others press, in the terms of order 0 and 1 that the state gives.
    pub fn press(&mut self, model: &Model, states: &[ContactState]) {
        for k in 0..2 {
            for pressed in &model.pressed {
                for contact in &pressed.contacts {
                    let state = &states[*contact];
                    let law = state.law(&model.contacts[*contact].law);
                    let is_state = match law {
                        Force::Constraint => true,
                        Force::Spring { k, .. } => k.is_infinite(),
                        Force::None
                        | Force::Line { .. }
                        | Force::Dashpot { .. }
                        | Force::Limit(_) => false,
                    };
                    self.contacts[*contact].force[k] = match (is_state, k) {
                        (true, 0) => state.force,
                        (true, _) => 0.0,
                        (false, _) => self.own_force(*contact, k, law),
                    };
                }
            }
            self.press_order(k, k == 0, model);
        }
    }

    /// The limits of order k of contacts that others press, without constraints; `damped` with dampers, which need order k + 1.
    pub fn press_order(&mut self, k: usize, damped: bool, model: &Model) {
        let n = model.len();
        let rate = (k + 1) as f64 / self.length;
        for (pressed, springs) in model.pressed.iter().zip(&mut self.springs) {
            let contacts = pressed.contacts.iter();
            let mut force: f64 = contacts.map(|i| self.contacts[*i].force[k]).sum();
            for (spring, series) in pressed.springs.iter().zip(springs) {
                series.force[k] = spring.k * spring.row.dot(&self.u[k * n..(k + 1) * n]);
                if damped && spring.c != 0.0 {
                    let next = &self.u[(k + 1) * n..(k + 2) * n];
                    series.force[k] += spring.c * rate * spring.row.dot(next);
                }
                if series.presses {
                    force += series.force[k];
                }
            }
            self.contacts[pressed.contact].limit[k] = -pressed.nu * force;
        }
    }

    /// Adds the forces of constraints, of order k, to the limits that they give, and to the friction of contacts that slide.
    pub fn press_by_constraints(
        &mut self,
        k: usize,
        model: &Model,
        states: &[ContactState],
        force: impl Fn(usize) -> Option<f64>,
    ) {
        for pressed in &model.pressed {
            let more = pressed.limit_by(&force);
            let contact = pressed.contact;
            self.contacts[contact].limit[k] += more;
            if let Force::Limit(direction) = states[contact].law(&model.contacts[contact].law) {
                let all = self.contacts[contact].force[k] + direction * more;
                model.subtract_force(contact, direction * more, &mut self.acceleration);
                self.contacts[contact].force[k] = all;
            }
        }
    }
}
