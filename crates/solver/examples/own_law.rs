//! A law from outside of slipgap: a spring that yields, with its plastic displacement as its state.
//!
//! `cargo run --package slipgap-solver --example own_law` prints the displacement of a mass that the spring holds.

use slipgap_solver::{
    AverageAcceleration, Contact, ContactLaw, Direction, Node, Own, OwnAnswer, OwnLaw, OwnState,
    OwnStep, Structure, StructureLaw, Unsolvable, run,
};

/// Elastic with `stiffness` up to `limit`, then with a tenth of it. The state is the plastic displacement.
#[derive(Debug)]
pub struct Yielding {
    /// Stiffness until it yields.
    pub stiffness: f64,
    /// The force at which it yields.
    pub limit: f64,
}

/// Stiffness after yielding over the one before.
pub const RATIO: f64 = 0.1;

impl OwnLaw for Yielding {
    fn answer(&self, step: &OwnStep, state: &OwnState) -> OwnAnswer {
        let [r, _] = step.to;
        let [soft, stiff] = [RATIO, 1.0 - RATIO].map(|part| part * self.stiffness);
        let width = (1.0 - RATIO) * self.limit;
        let elastic = stiff * (r - state[0]);
        let held = elastic.clamp(-width, width);
        let slope = if held == elastic { stiff } else { 0.0 };
        let mut after = *state;
        after[0] = r - held / stiff;
        OwnAnswer {
            force: soft * r + held,
            slopes: [soft + slope, 0.0],
            state: after,
        }
    }

    fn largest_stiffness(&self) -> f64 {
        self.stiffness
    }
}

/// A mass of 1 with the velocity 2 on a contact with this law.
pub fn mass_on(law: ContactLaw) -> Structure {
    let mut structure = Structure::new(vec![Node {
        name: "mass".into(),
        mass: 1.0,
        direction: Direction::X,
    }]);
    structure.contacts.push(Contact {
        name: "spring".into(),
        along: vec![(0, 1.0)],
        gap: 0.0,
        law: StructureLaw::new(law, None),
    });
    structure.velocity[0] = 2.0;
    structure
}

/// The law for the mass above.
pub static LAW: Yielding = Yielding {
    stiffness: 4.0,
    limit: 1.0,
};

#[allow(dead_code)]
fn main() -> Result<(), Unsolvable> {
    let structure = mass_on(ContactLaw::Own(Own::new(&LAW)));
    let motion = run(&structure, &AverageAcceleration.into(), 0.01, 400)?;
    for i in (0..=400).step_by(100) {
        let [t, u] = [motion.time[i], motion.displacement[i][0]];
        println!("t = {t}: u = {u:.6}, S = {:.6}", motion.force[i][0]);
    }
    Ok(())
}
