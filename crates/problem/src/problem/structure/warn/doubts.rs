//! The warnings of a case that need no motion.

use super::doubt::Doubt;
use super::masses::Masses;
use super::{at_start, between_steps, directions, given, matrices, restitution};
use crate::problem::Case;
use crate::problem::structure::StructureProblem;
use crate::problem::structure::given::node::Numbering;
use crate::problem::structure::metrics::computed_ground;
use crate::system::structure::Structure;

impl StructureProblem {
    /// Those of a case with this structure, one of each kind.
    pub(in crate::problem::structure) fn doubts_of(
        &self,
        case: &Case,
        structure: &Structure,
        numbering: &Numbering,
    ) -> Vec<Doubt> {
        let template = &self.template;
        let masses = Masses::new(structure, numbering);
        [
            given::spring_mass(template, case, &masses),
            given::damping_ratio(template, case),
            given::friction_coefficient(template, case),
            given::colliding_mass(template, case, &masses),
            matrices::periods(template, structure),
            given::idle_gravity(template, case),
            given::wave_speed(template, case),
            directions::of_one_body(template, case),
            at_start::closed(structure),
            at_start::at_once(structure),
            self.computed_steps(case).and_then(|steps| {
                let cut = computed_ground::cut(template, case, steps);
                cut.or_else(|| between_steps::missed(template, case, steps))
            }),
            restitution::missed(template, case, structure),
        ]
        .into_iter()
        .flatten()
        .collect()
    }
}
