//! Negative stiffness, of springs or of matrices: what it pulls away contacts must hold.

use crate::problem::structure::StructureProblem;
use crate::problem::structure::model::assemble::{self, Model};
use crate::problem::structure::parts::template::{SpringNumbers, Template};
use crate::problem::{Case, Violation};
use crate::system::structure::sparse::factor::negative_pivot;

impl StructureProblem {
    /// A part that K pulls away and no contact holds, or damping in proportion to such a K.
    pub(crate) fn negative_stiffness(&self, case: &Case) -> Option<Violation> {
        let template = &self.template;
        let cause = cause(template, case)?;
        let structure = assemble::outline(template, case, Model::Study).ok()?;
        let name = |node: usize| &structure.nodes[node].name;
        if let Some(node) = structure.pulled_node() {
            let node = name(node);
            let message = format!(
                "the stiffness pulls {node} away, and no contact holds it; allowed: a K without negative pivots, or contacts that hold it where they stick or touch"
            );
            return Some(Violation { message, ..cause });
        }
        let of_stiffness = template.rayleigh.of_stiffness()?;
        if of_stiffness.value(case).ok()? == 0.0 {
            return None;
        }
        let stiffness = assemble::damping_stiffness(template, &structure);
        let node = name(negative_pivot(&stiffness)?);
        Some(of_stiffness.violation(format!(
            "K pulls {node} away, so that damping in proportion to it would feed the motion; allowed: 0, modal_damping, or damping_stiffness \"initial\" with contacts that hold it"
        )))
    }
}

/// The place of a stiffness that may be negative; `None` if none is.
fn cause(template: &Template, case: &Case) -> Option<Violation> {
    let springs = template.springs.iter();
    let mut negative = springs.filter_map(|spring| match &spring.numbers {
        SpringNumbers::Stiffness { k, .. } if k.value(case).is_ok_and(|k| k < 0.0) => {
            Some(k.violation(""))
        }
        SpringNumbers::Stiffness { .. } | SpringNumbers::Period { .. } => None,
    });
    let of_matrices = || {
        let mut matrices = template.matrices.iter();
        let negative = matrices.find(|block| block.in_case(case).is_negative)?;
        Some(Violation {
            parameter: negative.place.1.clone().into(),
            message: String::new(),
            at: Some(negative.place.0),
        })
    };
    negative.next().or_else(of_matrices)
}
