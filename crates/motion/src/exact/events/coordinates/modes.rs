//! What the motion of modes is at nodes.

use crate::exact::events::numerics::row::dot;

/// What the motion of modes is at nodes.
#[derive(Debug)]
pub struct Modes {
    /// Shape of each node, a number for each mode.
    pub(crate) shapes: Vec<Vec<f64>>,
    /// Nodes without mass: u for a load, a contact and a plate of 1.
    pub(crate) massless: Vec<Option<[Vec<f64>; 3]>>,
}

impl Modes {
    /// u of a node for u of the modes, signals of the loads, forces and u of the plates; or the rates.
    pub fn at(&self, node: usize, modes: &[f64], others: [&[f64]; 3]) -> f64 {
        let of_modes = dot(&self.shapes[node], modes);
        let parts = self.massless[node].iter().flatten().zip(others);
        parts.fold(of_modes, |sum, (row, values)| sum + dot(row, values))
    }
}
