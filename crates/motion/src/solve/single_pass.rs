//! Integration by the papers' element matrices with each step solved once: one reading of "iteration as needed" is no iteration.

use super::Unsolvable;
use crate::contact::element::Element;
use crate::system::System;
use crate::textbook::{Iteration, Newmark, assemble};

/// Most elements of a structure; its matrices are full here.
const MOST_ELEMENTS: u32 = 400;

/// The assembled structure with its element.
pub type Assembled = Newmark<Box<dyn Element>>;

/// Runs all steps; `record` gets the structure at each, from step 0 on.
pub fn run(system: &System, mut record: impl FnMut(&Assembled)) -> Result<(), Unsolvable> {
    let elements = system.linear.elements();
    if elements > MOST_ELEMENTS {
        return Err(Unsolvable::TooManyElements {
            most: MOST_ELEMENTS,
            elements,
        });
    }
    if system.linear.contact_compliance() > 0.0 {
        // Nodes without mass have no acceleration that equilibrium gives.
        return Err(Unsolvable::SingularMass);
    }
    let (assembly, u, v) = assemble(&system.linear, system.gap);
    let r = assembly.relative(&u) + system.gap;
    let element = system
        .law
        .properties()
        .element(r, system.force)
        .ok_or(Unsolvable::NotPrinted)?;
    let mut newmark =
        Newmark::new(assembly, element, system.step, u, v).ok_or(Unsolvable::SingularMass)?;
    record(&newmark);
    for _ in 0..system.last {
        newmark
            .step(Iteration::Once)
            .map_err(|cycle| Unsolvable::NoSolution { step: cycle.step })?;
        record(&newmark);
    }
    Ok(())
}
