//! The oscillator by the papers' element matrices, each step solved once: the other reading of [F], "iteration as needed"
//! taken as none.

use super::release;
use super::run::Given;
use crate::history::History;
use crate::problem::Case;
use crate::textbook::element::{DisplacementFriction, Element, VelocityFriction};
use crate::textbook::{Assembly, Iteration, Newmark};
use nalgebra::{DMatrix, DVector};

/// The steps of a completed case.
pub fn run(case: &Case, given: &Given) -> Option<History> {
    let Given { x0, step, last, .. } = *given;
    match case.number("alpha") {
        Some(alpha) => {
            let (slip, force) = release(case.choice("initial_slip"), x0, alpha);
            let element = DisplacementFriction::new(1.0 / alpha, 1.0, -1.0, slip, force);
            walk(element, step, x0, last)
        }
        None => {
            let element = VelocityFriction::new(1.0 / case.number("beta")?, 1.0, -1.0);
            walk(element, step, x0, last)
        }
    }
}

fn walk(element: impl Element, step: f64, x0: f64, last: u64) -> Option<History> {
    let assembly = Assembly {
        mass: DMatrix::from_element(1, 1, 1.0),
        stiffness: DMatrix::from_element(1, 1, 1.0),
        nodes: [None, Some(0)],
        gap: 0.0,
    };
    let alone = |x| DVector::from_element(1, x);
    let mut newmark = Newmark::new(assembly, element, step, alone(x0), alone(0.0))?;
    let mut history = History::with_capacity(last as usize + 1);
    for i in 0..=last {
        if i > 0 {
            newmark.step(Iteration::Once).ok()?;
        }
        let [x, v, s] = newmark.contact();
        history.push(i as f64 * step, x, v, s);
    }
    Some(history)
}
