//! The start of a structure under construction.

use super::Draft;
use crate::problem::Violation;
use crate::problem::structure::given::amount::Amount;
use crate::problem::structure::parts::reduce::Start as DirectionStart;
use crate::problem::structure::parts::template::Moved;
use crate::system::structure::Structure;

impl Draft<'_> {
    pub(super) fn start(&mut self) {
        let mut starts = vec![DirectionStart::default(); self.reduced.len()];
        let is_massless = match self.is_built() {
            true => self.structure.massless(),
            false => Vec::new(),
        };
        for start in &self.template.start {
            let mut given =
                |amount: &Option<Amount>| amount.as_ref().map(|amount| self.value(amount));
            let (u, v) = (given(&start.u), given(&start.v));
            for node in self.moved(&start.of) {
                if let (Moved::Node(name), true) = (&start.of, is_massless.get(node) == Some(&true))
                {
                    let message = "the node has no mass: it is where the forces on it are in equilibrium; leave out its start, or give it a mass";
                    self.violations.push(Violation {
                        parameter: name.path.clone().into(),
                        message: message.into(),
                        at: Some(name.at),
                    });
                }
                let Structure {
                    displacement,
                    velocity,
                    ..
                } = &mut self.structure;
                displacement[node] = u.unwrap_or(displacement[node]);
                velocity[node] = v.unwrap_or(velocity[node]);
            }
            if let Moved::Rows(matrices, direction) = &start.of {
                starts[*matrices].set(*direction, [u, v]);
            }
        }
        if !self.is_built() {
            return;
        }
        for (block, start) in starts.iter().enumerate() {
            if let Some(reduced) = &self.reduced[block] {
                let nodes = self.numbering.coordinates(block, reduced);
                let Structure {
                    displacement,
                    velocity,
                    ..
                } = &mut self.structure;
                start.project(reduced, &nodes, [displacement, velocity]);
            }
        }
    }

    /// The nodes that a start moves; of reduced matrices the kept ones.
    pub(super) fn moved(&mut self, of: &Moved) -> Vec<usize> {
        match of {
            Moved::Node(name) => self.node(name).into_iter().collect(),
            // It starts as its rows do.
            Moved::Tied(_) => Vec::new(),
            Moved::Bar(bar) => {
                let first = self.numbering.first(*bar);
                (first..first + self.numbering.elements()[*bar] as usize + 1).collect()
            }
            Moved::Rows(matrices, direction) => {
                let of_matrices = self.template.matrices[*matrices].imported.dofs.rows();
                let rows = of_matrices.iter().enumerate();
                let dofs = rows.filter(|(_, dof)| dof.direction == *direction);
                let nodes = dofs.filter_map(|(row, _)| self.numbering.row(*matrices, row));
                // Those behind the nodes are supports.
                nodes
                    .filter(|node| *node < self.numbering.nodes())
                    .collect()
            }
        }
    }
}
