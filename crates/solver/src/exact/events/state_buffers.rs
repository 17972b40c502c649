//! StateBuffers for a state.

use super::State;
use crate::system::structure::Structure;

/// The numbers of a state.
pub struct StateBuffers {
    pub u: Vec<f64>,
    pub v: Vec<f64>,
    pub r: Vec<f64>,
    pub rate: Vec<f64>,
    pub force: Vec<f64>,
    pub slip: Vec<f64>,
}

impl StateBuffers {
    /// Zeros.
    pub fn new(structure: &Structure) -> StateBuffers {
        let [u, v] = [(); 2].map(|()| vec![0.0; structure.len()]);
        let [r, rate, force, slip] = [(); 4].map(|()| vec![0.0; structure.contacts.len()]);
        StateBuffers {
            u,
            v,
            r,
            rate,
            force,
            slip,
        }
    }

    /// The state.
    pub fn state(&self) -> State<'_> {
        State {
            u: &self.u,
            v: &self.v,
            r: &self.r,
            rate: &self.rate,
            force: &self.force,
            slip: &self.slip,
        }
    }
}
