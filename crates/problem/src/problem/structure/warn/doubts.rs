//! The warnings of a case that need no motion.

use super::doubt::Doubt;
use super::masses::Masses;
use super::{at_start, between_steps, directions, matrices, restitution, twice, unlikely, weight};
use crate::metrics::last_time;
use crate::problem::structure::StructureProblem;
use crate::problem::structure::given::node::Numbering;
use crate::problem::structure::metrics::computed_ground;
use crate::problem::{Case, ends_early};
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
        let steps = self.computed_steps(case);
        let masses = Masses::new(structure, numbering);
        [
            unlikely::spring_mass(template, case, &masses),
            unlikely::spring_period(template, case),
            unlikely::damping_ratio(template, case),
            twice::damped(template, case),
            twice::none(template, case, structure),
            twice::impacts(template, case, structure),
            unlikely::friction_coefficient(template, case),
            unlikely::radius(template, case),
            weight::far(template, case, structure),
            unlikely::colliding_mass(template, case, &masses),
            matrices::periods(template, structure),
            unlikely::idle_gravity(template, case)
                .or_else(|| weight::along_friction(template, case, structure)),
            unlikely::wave_speed(template, case),
            directions::of_one_body(template, case),
            at_start::closed(structure),
            at_start::at_once(structure),
            between_steps::before(template, case),
            steps.and_then(|steps| self.long_step(structure, numbering, steps)),
            steps.and_then(|steps| {
                unlikely::support_drift(template, case, steps.dt * steps.last as f64)
            }),
            self.ends_early(case),
            steps.and_then(|steps| {
                let cut = computed_ground::cut(template, case, steps);
                cut.or_else(|| between_steps::missed(template, case, steps))
            }),
            restitution::missed(template, case, structure),
        ]
        .into_iter()
        .flatten()
        .collect()
    }

    /// A duration that is no multiple of the step.
    fn ends_early(&self, case: &Case) -> Option<Doubt> {
        let (step, duration) = (case.at(self.schema.step)?, case.at(self.schema.duration)?);
        last_time(duration, step, case.steps()).map(ends_early)
    }
}
