//! Problems: each makes a system of a case, knows its exact solution, and computes its metrics.

pub mod expression;
pub mod friction;
pub mod impact;
pub mod method;
pub mod numbers;
mod offered_laws;
mod parameter_expression;
mod preset;
mod side_by_side;
pub mod structure;
pub mod table;
mod times;

pub use crate::problem::numbers::text::{Text, interned};
pub use crate::problem::table::case::{Case, Violation};
pub use crate::problem::table::schema::{
    Budget, Channel, Metric, Profile, Quantity, Schema, metric_of,
};
pub use crate::problem::table::solution::{
    HistoryColumn, Lines, MeasuredChannel, Snapshot, Solution,
};
pub use parameter_expression::{NotComputed, ParameterExpression, values_used};
pub use slipgap_notation::{capital, escape, unit as set_unit};

use crate::contact::ContactLaw;
use crate::history::History;
use crate::solve::{MetricTable, Unsolvable, Warning};
use crate::system::System;
use crate::system::structure::Structure;
use numbers::parameter::Parameter;
use numbers::unit::Dimension;
use std::sync::{Arc, LazyLock};
use structure::StructureProblem;
use structure::programs::Programs;
use table::cases::Cases;
use times::{ends_early, time_rules};

/// A problem: its schema, and how one of its cases is solved and judged.
///
/// A case of `[F]` Fig. 5 with the time step pi/10; its rms error is 0.0245 |x0|:
///
/// ```
/// use slipgap_problem::problem::{self, Case, numbers::parameter::Value};
/// use std::f64::consts::PI;
///
/// let problem = problem::find("friction-oscillator").expect("a problem");
/// let given = [
///     ("law", Value::Name("displacement-control")),
///     ("alpha", Value::Number(0.1)),
///     ("dT", Value::Number(PI / 10.0)),
///     ("duration", Value::Number(8.0 * PI)),
/// ];
/// let (case, violations) = Case::given(&*problem, &given);
/// assert_eq!(violations, []);
/// let solution = problem.solve(&case, &[])?;
/// assert_eq!(solution.computed.len(), 81);
/// let rms = solution.metrics[0].expect("rms_error is always defined");
/// assert!((rms - 0.0245).abs() < 5e-5);
/// # Ok::<(), slipgap_motion::solve::Unsolvable>(())
/// ```
pub trait Problem: Send + Sync + std::fmt::Debug {
    /// The tables.
    fn schema(&self) -> &Arc<Schema>;
    /// What only structures, or only the problems of the papers, answer.
    fn kind(&self) -> ProblemKind<'_>;
    /// Fills in the values that follow from others, and reports every rule across parameters that the case breaks.
    fn complete(&self, case: &mut Case) -> Vec<Violation>;
    /// Cost of a completed case, the references those of the metrics in these rows.
    fn work(&self, case: &Case, wanted: &[usize]) -> Work;
    /// Solves a completed case.
    ///
    /// `wanted` has rows of the table of metrics; of those that are not default, only they are computed.
    fn solve(&self, case: &Case, wanted: &[usize]) -> Result<Solution, Unsolvable>;
    /// The default metrics of the completed cases in these rows, in their order, solved side by side: to the bit what `solve`
    /// gives for each.
    fn sweep(&self, cases: &Cases, rows: &[u32]) -> MetricTable;
    /// The exact motion of a completed case at these times, which increase; `None` where there is none.
    fn exact(&self, case: &Case, times: &[f64], jumps: Jumps) -> Option<History>;
    /// The warnings of a completed case that need no motion, each with what it is of.
    fn doubts(&self, case: &Case) -> Vec<(Warning, String)>;
}

/// The two kinds of problems, each with what only it answers.
#[derive(Debug, Clone, Copy)]
pub enum ProblemKind<'a> {
    /// The structure that a study describes.
    Structure(&'a StructureProblem),
    /// A problem of the papers.
    Textbook(&'a dyn Textbook),
}

/// Cost of a case, in steps times modes. A core computes about 5e8 of them in a second.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Work {
    /// Of the steps.
    pub steps: u64,
    /// Of the references of its metrics.
    pub references: u64,
}

/// What an exact motion has where it jumps, as the velocities of waves do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Jumps {
    /// The right-hand limit, if one of the times is at the jump.
    RightLimit,
    /// Both sides of every jump between the times, which start at 0: a line to draw.
    BothSides,
}

impl dyn Problem + '_ {
    /// Its name in a study's `problem`.
    pub fn name(&self) -> &str {
        &self.schema().name
    }

    /// The table of parameters.
    pub fn parameters(&self) -> &[Parameter] {
        &self.schema().parameters
    }

    /// The table of metrics.
    pub fn metrics(&self) -> &[Metric] {
        &self.schema().metrics
    }

    /// The structure that a study describes; `None` for a textbook problem.
    pub fn as_structure(&self) -> Option<&StructureProblem> {
        match self.kind() {
            ProblemKind::Structure(structure) => Some(structure),
            ProblemKind::Textbook(_) => None,
        }
    }

    /// The problem of a paper; `None` for structures.
    pub fn as_textbook(&self) -> Option<&dyn Textbook> {
        match self.kind() {
            ProblemKind::Structure(_) => None,
            ProblemKind::Textbook(textbook) => Some(textbook),
        }
    }

    /// What determines results and is neither in the parameters nor in the program; empty if there is nothing.
    pub fn identity(&self) -> &str {
        match self.kind() {
            ProblemKind::Structure(structure) => structure.identity(),
            ProblemKind::Textbook(textbook) => textbook.programs().map_or("", Programs::identity),
        }
    }

    /// The columns of the history of a completed case, after the time.
    pub fn history_columns(&self, case: &Case) -> Vec<HistoryColumn> {
        let channels = self.schema().channels.iter().enumerate();
        let column = |(index, channel): (usize, &Channel)| HistoryColumn {
            index,
            column: channel.clone(),
        };
        match self.kind() {
            ProblemKind::Structure(structure) => structure.history_columns(case),
            ProblemKind::Textbook(_) => channels.map(column).collect(),
        }
    }

    /// The programs of others that a study has; `None` for a textbook problem without.
    pub fn programs(&self) -> Option<&Programs> {
        match self.kind() {
            ProblemKind::Structure(structure) => Some(structure.programs()),
            ProblemKind::Textbook(textbook) => textbook.programs(),
        }
    }

    /// The structure of a completed case; of a textbook problem its modes are masses. `None` if unsolved or without mass there.
    pub fn structure(&self, case: &Case) -> Option<Structure> {
        match self.kind() {
            ProblemKind::Structure(structure) => structure.assembled(case),
            ProblemKind::Textbook(textbook) => preset::structure(&textbook.system(case)?),
        }
    }
}

/// What only the problems of the papers have: one contact with a law of the table, modes, and the steps that the papers print.
pub trait Textbook: Problem {
    /// Cost of a completed case whose steps are each solved once, with the matrices of the papers, in the same unit.
    fn once_work(&self, case: &Case) -> u64 {
        // Measured: 1 us a step for one mode, and 30 ns for each element of a full matrix.
        case.steps().saturating_mul(600)
    }
    /// Solves a completed case by the papers' element matrices, each step once and not iterated: the other reading of the papers,
    /// for the claims.
    fn solve_once(&self, case: &Case, wanted: &[usize]) -> Result<Solution, Unsolvable>;
    /// The modes, the one contact and the steps of a completed case, in the scales of the problem; `None` if a parameter is not given.
    fn system(&self, case: &Case) -> Option<System>;
    /// The law of the contact.
    fn contact_law(&self, case: &Case) -> Option<ContactLaw> {
        self.system(case).map(|system| system.law)
    }
    /// The exact motion of a completed case with its own law, where [`Problem::exact`] has another one, at these times, which increase;
    /// `None` where none is known.
    fn exact_of_law(&self, _case: &Case, _times: &[f64]) -> Option<History> {
        None
    }
    /// The programs of others that compute cases of it; `None` without.
    fn programs(&self) -> Option<&Programs> {
        None
    }
    /// The structure that a study would describe for a completed case, for programs of others.
    ///
    /// # Errors
    /// What a structure does not have.
    fn described(&self, case: &Case) -> Result<Described, String>;
    /// The solution of a completed case whose motion has these channels of its structure at the steps.
    ///
    /// # Errors
    /// A parameter or a channel is not given.
    fn judged(
        &self,
        case: &Case,
        channels: &[Vec<f64>],
        wanted: &[usize],
    ) -> Result<Solution, Unsolvable>;
    /// The problem with further parameters, which only expressions of a study contain.
    fn with_parameters(&self, further: Vec<Parameter>) -> Arc<dyn Problem>;
    /// The problem for parameters in units of which this gives the sizes in SI units; `None` for one whose units say nothing more.
    fn in_units(&self, _size: &dyn Fn(Dimension) -> Option<f64>) -> Option<Arc<dyn Problem>> {
        None
    }
    /// The profiles of a completed case at the steps nearest to `times`; none for a problem without extent.
    fn snapshots(&self, _case: &Case, _times: &[f64]) -> Vec<Snapshot> {
        Vec::new()
    }
    /// The numbers of `Schema::later` for a completed case, the event after `flight` of free motion; `None` where undefined.
    fn after(&self, _case: &Case, _flight: f64) -> Vec<Option<f64>> {
        Vec::new()
    }
    /// Size of the unit of a dimension in a completed case, in the units of its parameters; `None` for a problem without.
    fn size(&self, _case: &Case, _dimension: Dimension) -> Option<f64> {
        None
    }
    /// Rows of the parameters that alone decide the cost of a case and of the references of its metrics; `None` if others may.
    fn cost_rows(&self, _wanted: &[usize]) -> Option<[usize; 2]> {
        None
    }
}

/// A textbook problem as a structure, in its scales.
#[derive(Debug, Clone, PartialEq)]
pub struct Described {
    /// The value of the key `structure` of a study.
    pub structure: serde_json::Value,
    /// The channels that [`Textbook::judged`] needs.
    pub channels: Vec<String>,
}

/// The sampled signals of a case, such as synthetic ground motions.
#[derive(Debug, Clone, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Samples {
    /// The same for cases that share all of them; empty without any.
    pub key: Vec<u64>,
    /// Size of the largest one in numbers, of which [`structure::MOST_SAMPLED`] are kept for each load.
    pub numbers: usize,
    /// Cost of making all of them, in steps times modes.
    pub work: u64,
}

/// Every problem there is.
pub static PROBLEMS: LazyLock<[Arc<dyn Problem>; 2]> = LazyLock::new(|| {
    [
        Arc::new(friction::FrictionOscillator),
        Arc::new(impact::BarImpact),
    ]
});

/// The names of all problems: of those in [`PROBLEMS`], and of structures, which studies describe.
pub fn names() -> impl Iterator<Item = &'static str> {
    let known = PROBLEMS.iter().map(|problem| problem.name());
    known.chain([structure::tables::schema::NAME])
}

/// The problem called `name`.
pub fn find(name: &str) -> Option<Arc<dyn Problem>> {
    PROBLEMS.iter().find(|p| p.name() == name).cloned()
}

/// Whether studies describe the system of the problem called `name`, see [`Schema::described`].
pub fn is_described(name: &str) -> bool {
    find(name).is_none() && names().any(|known| known == name)
}

/// Number of cases that were solved and have no contact: those without [`Schema::contact_metric`]. None for a
/// problem without impacts.
pub fn cases_without_contact(problem: &dyn Problem, table: &MetricTable) -> u64 {
    let metric = problem.schema().contact_metric;
    metric.map_or(0, |metric| table.solved_without(metric))
}

/// Most steps of a run: a history of more, with its exact solution, would not fit in 2 GiB.
pub const MOST_STEPS: u64 = 30_000_000;
