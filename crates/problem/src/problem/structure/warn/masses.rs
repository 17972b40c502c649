//! The masses that a spring or a contact may move: those of its nodes, and those of all that springs and bars connect with them.

use crate::problem::Case;
use crate::problem::structure::given::node::{NodeRef, Numbering};
use crate::problem::structure::parts::along::Term;
use crate::system::structure::Structure;
use std::cell::OnceCell;

/// The masses of a case.
#[derive(Debug)]
pub struct Masses<'a> {
    structure: &'a Structure,
    numbering: &'a Numbering,
    /// The mass of the part of each node in the direction of the node.
    parts: OnceCell<Vec<f64>>,
}

impl<'a> Masses<'a> {
    /// Of a structure with this numbering.
    pub fn new(structure: &'a Structure, numbering: &'a Numbering) -> Masses<'a> {
        Masses {
            structure,
            numbering,
            parts: OnceCell::new(),
        }
    }

    /// The masses m that move along these nodes, 1/m = sum factor^2/m_i: of the nodes alone, and of their whole parts; and the
    /// largest mass of such a part. `None` for rows of matrices, whose masses depend on their mesh, and where no node moves.
    pub fn along(&self, terms: &[Term], case: &Case) -> Option<[f64; 3]> {
        let mut inverse = [0.0; 2];
        let mut largest = 0.0;
        for term in terms {
            match term.node.node {
                NodeRef::Ground | NodeRef::Support(_) => continue,
                NodeRef::Dof(..) => return None,
                NodeRef::Mass(_) | NodeRef::Left(_) | NodeRef::Right(_) | NodeRef::Inner(..) => {}
            }
            let node = self.numbering.of(&term.node).ok()??;
            let factor = term.factor.value(case).ok()?;
            largest = self.part(node).max(largest);
            for (sum, mass) in inverse.iter_mut().zip([self.own(node), self.part(node)]) {
                *sum += factor * factor / mass;
            }
        }
        let [least, part] = inverse.map(|sum| 1.0 / sum);
        (inverse[1] > 0.0).then_some([least, part, largest])
    }

    fn own(&self, node: usize) -> f64 {
        self.structure.nodes[node].mass
    }

    fn part(&self, node: usize) -> f64 {
        let parts = self.parts.get_or_init(|| {
            let nodes = &self.structure.nodes;
            let parts = self.structure.parts();
            let mut sums = vec![0.0; nodes.len()];
            for (node, part) in nodes.iter().zip(&parts) {
                sums[*part] += node.mass;
            }
            parts.iter().map(|part| sums[*part]).collect()
        });
        parts[node]
    }
}
