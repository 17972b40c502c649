//! Structures of a study: masses, bars, springs, contacts, loads and records, with the exact motion by events.

mod answers;
pub mod channels;
pub mod described;
pub mod given;
pub mod metrics;
pub mod model;
mod motions;
pub mod parts;
mod prepared;
pub mod programs;
mod refused;
pub mod tables;
mod warn;

use super::table::cases::Cases;
use super::{Case, Jumps, Problem, ProblemKind, Schema, Solution, Violation, Work, time_rules};
use crate::history::History;
pub use crate::problem::structure::described::ground_motion::GroundMotion;
pub use crate::problem::structure::described::scheme::picture::Scheme;
pub use crate::problem::structure::given::motion_set::SetSpectra;
pub use crate::problem::structure::given::signal_cache::MOST_NUMBERS as MOST_SAMPLED;
use crate::solve::{MetricTable, Unsolvable, Warning};
pub use model::assemble::MOST_NODES;
use model::assemble::{self, Model};
use motions::recorded::distinct;
use motions::sweep::Groups;
pub use prepared::StructureProblem;
use std::sync::Arc;
use tables::history_columns::all_numbers;

impl Problem for StructureProblem {
    fn schema(&self) -> &Arc<Schema> {
        &self.schema
    }

    fn kind(&self) -> ProblemKind<'_> {
        ProblemKind::Structure(self)
    }

    fn complete(&self, case: &mut Case) -> Vec<Violation> {
        let number = |row| case.at(row).unwrap_or(f64::NAN);
        let (step, duration) = (number(self.schema.step), number(self.schema.duration));
        let mut violations = Vec::new();
        if step.is_finite() && duration.is_finite() {
            violations.extend(time_rules("dt", step, duration));
        }
        match assemble::check(&self.template, case) {
            Err(broken) => violations.extend(broken),
            Ok(numbering) => {
                violations.extend(self.check_channels(&numbering, case));
                violations.extend(self.check_measures(case));
                if violations.is_empty() {
                    violations.extend(self.check_windows(case, step, duration));
                }
                violations.extend(self.check_measured(case));
                violations.extend(self.check_contacts(case));
                if violations.is_empty() {
                    violations.extend(self.check_memory(&numbering, duration / step));
                }
                if violations.is_empty() {
                    violations.extend(self.ignored_restitutions(case));
                    violations.extend(self.negative_stiffness(case));
                    violations.extend(self.static_ratio_rules(case));
                    violations.extend(self.step_rules(case, step));
                }
            }
        }
        violations
    }

    fn work(&self, case: &Case, _wanted: &[usize]) -> Work {
        let one_run = self.one_run_work(case);
        let runs = 1 + u64::from(self.needs_perturbed());
        let exact = self.exact_work(case, one_run);
        Work {
            steps: one_run.saturating_mul(runs),
            references: exact.saturating_add(self.unreduced_work(case)),
        }
    }

    fn solve(&self, case: &Case, _wanted: &[usize]) -> Result<Solution, Unsolvable> {
        let ready = self.ready(0, case)?;
        // A whole history that does not fit is refused where one is asked for; figures need their own channels.
        let is_asked = self.program_of(case).is_some() && !self.programs.is_whole();
        let numbers = match self.history_fault(case) {
            None if !is_asked => all_numbers(&ready.structure, &self.template),
            None | Some(_) => Vec::new(),
        };
        let drawn = self.drawn_numbers(&ready.numbering);
        let recorded = distinct(drawn.into_iter().chain(numbers.iter().copied()));
        let (motions, metrics, warnings) = self.solve_ready(&ready, &recorded)?;
        let time: Vec<f64> = (0..=ready.last).map(|i| i as f64 * ready.dt).collect();
        let reference = match (self.template.reference, self.against_rigid()) {
            (None, _) => None,
            (Some(_), true) => motions.rigid.as_ref(),
            (Some(_), false) => motions.softened.as_ref(),
        };
        let exact = reference.map(|motion| self.history(motion, &ready.numbering, &numbers));
        let computed = self.history(&motions.computed, &ready.numbering, &numbers);
        let history = |channels| History {
            time: time.clone(),
            channels,
        };
        let solution = Solution {
            computed: history(computed),
            exact: history(exact.unwrap_or_default()),
            metrics,
            warnings,
        };
        // A program may have no value at some instants.
        match solution.computed.is_finite() || self.program_of(case).is_some() {
            true => Ok(solution),
            false => Err(Unsolvable::OutOfRange),
        }
    }

    fn sweep(&self, cases: &Cases, rows: &[u32]) -> MetricTable {
        let mut groups = Groups::new(self, rows.len());
        let mut shown = cases.shown();
        for (index, row) in rows.iter().enumerate() {
            match self.ready(index, shown.at(*row as usize)) {
                Ok(ready) => groups.add(ready),
                Err(why) => groups.fail(index, why),
            }
        }
        groups.finish()
    }

    fn exact(&self, case: &Case, times: &[f64], _: Jumps) -> Option<History> {
        self.template.reference?;
        let (structure, numbering) = self.structure(case, Model::Study).ok()?;
        let numbers = self.drawn_numbers(&numbering);
        let exact = self.reference(&structure, times, &numbers).ok()?;
        Some(History {
            time: times.to_vec(),
            channels: self.history(&exact, &numbering, &[]),
        })
    }

    fn doubts(&self, case: &Case) -> Vec<(Warning, String)> {
        let whole = self.structure(case, Model::Study);
        whole.map_or(Vec::new(), |(structure, numbering)| {
            self.doubts_of(case, &structure, &numbering)
        })
    }
}
