//! Problems: the one place where a case's parameters become structure, law, exact solution and metrics.

pub mod cases;
pub mod friction;
pub mod impact;
pub mod parameter;
pub mod unit;

use crate::history::History;
use crate::metrics::steps;
use crate::solve::sweep::{LONGEST, LaneCase};
use crate::solve::{MetricTable, Unsolvable};
use cases::Cases;
use parameter::{Parameter, Value};
use unit::{Dimension, Unit};

/// The values of one case, in the order of the problem's table; `None` where a parameter does not apply.
#[derive(Debug, Clone)]
pub struct Case {
    /// The problem's table.
    pub table: &'static [Parameter],
    /// One entry for each row of the table.
    pub values: Vec<Option<Value>>,
}

impl Case {
    /// A case in which nothing is said yet.
    pub fn new(table: &'static [Parameter]) -> Case {
        let values = vec![None; table.len()];
        Case { table, values }
    }

    /// A completed case from parameters by name, the others at their defaults, and the rules that it breaks.
    pub fn given(problem: &dyn Problem, given: &[(&str, Value)]) -> (Case, Vec<Violation>) {
        let mut case = Case::new(problem.parameters());
        for (row, parameter) in case.table.iter().enumerate() {
            let own = given.iter().find(|(name, _)| *name == parameter.name);
            // A name that a default depends on precedes it in the table.
            case.values[row] = own
                .map(|(_, value)| *value)
                .or_else(|| case.default_at(row));
        }
        let broken = problem.complete(&mut case);
        (case, broken)
    }

    /// The default of a row of the table, where it has one and applies.
    pub fn default_at(&self, row: usize) -> Option<Value> {
        let parameter = &self.table[row];
        let applies = parameter
            .applies
            .is_none_or(|(governor, name)| self.choice(governor) == name);
        match parameter.default {
            parameter::Default::Is(value) if applies => Some(value),
            _ => None,
        }
    }

    /// The value of the parameter `name`, if it applies.
    pub fn get(&self, name: &str) -> Option<Value> {
        let row = self.table.iter().position(|p| p.name == name)?;
        self.values[row]
    }

    /// The number called `name`; `None` where it does not apply.
    pub fn number(&self, name: &str) -> Option<f64> {
        self.get(name)?.as_f64()
    }

    /// The number in a row of the table; `None` where it does not apply.
    pub fn at(&self, row: usize) -> Option<f64> {
        self.values[row]?.as_f64()
    }

    /// The name in a row of the table; empty where it does not apply.
    pub fn name_at(&self, row: usize) -> &'static str {
        match self.values[row] {
            Some(Value::Name(chosen)) => chosen,
            _ => "",
        }
    }

    /// The name chosen for `name`; empty where it does not apply.
    pub fn choice(&self, name: &str) -> &'static str {
        match self.get(name) {
            Some(Value::Name(chosen)) => chosen,
            _ => "",
        }
    }
}

/// A rule across parameters that a case breaks.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Violation {
    /// The parameter to point at: at its value where it is given, else at the block's opening brace.
    pub parameter: &'static str,
    /// What is wrong and what is allowed.
    pub message: String,
}

impl Violation {
    /// All rules that a case breaks, in one line; `None` where it breaks none.
    pub fn all(violations: &[Violation]) -> Option<String> {
        let one = |violation: &Violation| format!("{}: {}", violation.parameter, violation.message);
        let all: Vec<String> = violations.iter().map(one).collect();
        (!all.is_empty()).then(|| all.join("; "))
    }
}

/// One column of results.csv beyond the parameters.
#[derive(Debug)]
pub struct Metric {
    /// Column name.
    pub name: &'static str,
    /// How figures write it, with its scale.
    pub symbol: &'static str,
    /// Name of one of the problem's units, or `1`.
    pub unit: &'static str,
    /// Formula in words, for schema and documentation.
    pub meaning: &'static str,
    /// Whether every study has the column, or only those that ask for it.
    pub default: bool,
}

/// The row of a table of metrics that has this name, for constants: a name that is not there does not compile.
pub const fn metric_of(table: &[Metric], name: &str) -> usize {
    let mut row = 0;
    while row < table.len() {
        if parameter::same(table[row].name, name) {
            return row;
        }
        row += 1;
    }
    panic!("no such metric")
}

/// A quantity that history figures can draw.
#[derive(Debug)]
pub struct Quantity {
    /// Its name in a figure's `y`.
    pub name: &'static str,
    /// Axis title, in the markup of `figures::markup`.
    pub title: &'static str,
    /// Which numbers of a solution it draws.
    pub source: Source,
}

/// An error and what it is made of, for budget figures.
#[derive(Debug)]
pub struct Budget {
    /// Its name in a figure's `y`.
    pub name: &'static str,
    /// Axis title, in the markup of `figures::markup`.
    pub title: &'static str,
    /// Row of the table of metrics.
    pub total: usize,
    /// What each part is called, and its row.
    pub parts: &'static [(&'static str, usize)],
}

impl Budget {
    /// Rows of the total and of its parts.
    pub fn metrics(&self) -> Vec<usize> {
        let parts = self.parts.iter().map(|part| part.1);
        std::iter::once(self.total).chain(parts).collect()
    }
}

/// A quantity along the structure that profile figures can draw.
#[derive(Debug)]
pub struct Profile {
    /// Its name in a figure's `y`.
    pub name: &'static str,
    /// Axis title, in the markup of `figures::markup`.
    pub title: &'static str,
}

/// Where a quantity's numbers come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// Relative displacement, computed over exact.
    Displacement,
    /// Relative velocity, computed over exact.
    Velocity,
    /// Force, computed over exact.
    Force,
    /// Relative displacement, computed minus exact.
    DisplacementError,
    /// Relative velocity, computed minus exact.
    VelocityError,
}

impl Source {
    /// What its numbers measure.
    pub fn dimension(self) -> Dimension {
        match self {
            Source::Displacement | Source::DisplacementError => Dimension::Length,
            Source::Velocity | Source::VelocityError => Dimension::Velocity,
            Source::Force => Dimension::Force,
        }
    }
}

/// What stands along the structure at one time.
#[derive(Debug, Clone, PartialEq)]
pub struct Snapshot {
    /// Time of the step, in the problem's unit.
    pub time: f64,
    /// In the order of `problem.profiles()`.
    pub profiles: Vec<Lines>,
    /// Where the exact solution's fronts stand, those at an end of a part included.
    pub fronts: Vec<f64>,
}

/// One quantity along the structure, a line for each of its parts, as points (place, value).
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Lines {
    /// By the stepper, at nodes or in elements.
    pub computed: Vec<Vec<[f64; 2]>>,
    /// By the exact solution, with both sides of every jump.
    pub exact: Vec<Vec<[f64; 2]>>,
}

/// A case solved: what was computed, and the exact solution at the same times.
#[derive(Debug, Clone)]
pub struct Solution {
    /// By the stepper.
    pub computed: History,
    /// By the exact solution.
    pub exact: History,
    /// In the order of the problem's table; `None` where one is undefined for the case.
    pub metrics: Vec<Option<f64>>,
}

/// A problem: its tables, and how one of its cases is solved and judged.
pub trait Problem: Sync + std::fmt::Debug {
    /// Its name in a study's `problem`.
    fn name(&self) -> &'static str;
    /// What it is, in one sentence.
    fn meaning(&self) -> &'static str;
    /// The table of parameters.
    fn parameters(&self) -> &'static [Parameter];
    /// The table of metrics.
    fn metrics(&self) -> &'static [Metric];
    /// Row of a default metric that is empty exactly where no contact happens; none for a problem without impacts.
    fn contact(&self) -> Option<usize> {
        None
    }
    /// What history figures can draw; the first is the response itself.
    fn quantities(&self) -> &'static [Quantity];
    /// What profile figures can draw; none for a problem without extent.
    fn profiles(&self) -> &'static [Profile] {
        &[]
    }
    /// The errors that budget figures can take apart.
    fn budgets(&self) -> &'static [Budget];
    /// Name of the parameter that is the time step.
    fn step(&self) -> &'static str;
    /// Title of the axis along the structure, for profiles.
    fn place_title(&self) -> &'static str {
        ""
    }
    /// The profiles of a completed case at the steps nearest to `times`; none for a problem without extent.
    fn snapshots(&self, _case: &Case, _times: &[f64]) -> Vec<Snapshot> {
        Vec::new()
    }
    /// Names of the numbers about the event that follows a case's own, for claims; none for a problem without such an event.
    fn later(&self) -> &'static [&'static str] {
        &[]
    }
    /// The numbers of `later` for a completed case, the event after `flight` of free motion; `None` where undefined.
    fn after(&self, _case: &Case, _flight: f64) -> Vec<Option<f64>> {
        Vec::new()
    }
    /// Symbols of the scales that results are given in, each with its formula and meaning.
    fn scales(&self) -> &'static [[&'static str; 2]] {
        &[]
    }
    /// The units of scaled results; none for a problem whose parameters have no units.
    fn units(&self) -> &'static [Unit] {
        &[]
    }
    /// Size of the unit of a dimension in a completed case, in the units of its parameters; `None` for a problem without.
    fn size(&self, _case: &Case, _dimension: Dimension) -> Option<f64> {
        None
    }
    /// Title of the time axis.
    fn time_title(&self) -> &'static str;
    /// Whether time axes have their ticks at multiples of pi.
    fn time_in_pi(&self) -> bool;
    /// Names of the six history columns: time, displacement, velocity, force, exact displacement, exact velocity.
    fn history_columns(&self) -> [&'static str; 6];
    /// Pairs of parameters of which one is given and the other follows.
    fn alternatives(&self) -> &'static [[&'static str; 2]] {
        &[]
    }
    /// Fills in the values that follow from others, and names every rule across parameters that the case breaks.
    fn complete(&self, case: &mut Case) -> Vec<Violation>;
    /// Number of steps N of a completed case.
    fn steps(&self, case: &Case) -> u64;
    /// What a completed case costs: steps times modes.
    fn work(&self, case: &Case) -> u64 {
        self.steps(case)
    }
    /// What the references of the metrics in these rows cost besides, in the same unit.
    fn reference_work(&self, _case: &Case, _wanted: &[usize]) -> u64 {
        0
    }
    /// Solves a completed case; an error says why it has no solution in double precision.
    ///
    /// `wanted` holds rows of the table of metrics; of those that are not default, only they are computed.
    fn solve(&self, case: &Case, wanted: &[usize]) -> Result<Solution, Unsolvable>;
    /// The default metrics of the completed cases in these rows, in their order, moved side by side: to the bit what
    /// `solve` gives each.
    fn sweep(&self, cases: &Cases, rows: &[u32]) -> MetricTable;
    /// The same by the papers' element matrices, each step solved once and not to the end: the other reading of the
    /// papers, for the ledger of claims.
    fn solve_once(&self, case: &Case, wanted: &[usize]) -> Result<Solution, Unsolvable>;
    /// The exact solution of a completed case as a line to draw: at these times, rising from 0, and on both sides of
    /// every jump between them; `None` where there is none.
    fn exact(&self, case: &Case, times: &[f64]) -> Option<History>;
}

/// Every problem there is.
pub static PROBLEMS: [&dyn Problem; 2] = [&friction::FrictionOscillator, &impact::BarImpact];

/// The problem called `name`.
pub fn find(name: &str) -> Option<&'static dyn Problem> {
    PROBLEMS.iter().copied().find(|p| p.name() == name)
}

/// How many metrics of a problem every study has: the first of its table.
pub fn defaults(problem: &(impl Problem + ?Sized)) -> usize {
    problem.metrics().iter().take_while(|m| m.default).count()
}

/// Number of cases that were solved and have no contact: those without the metric that [`Problem::contact`] names. None for a
/// problem without impacts.
pub fn cases_without_contact(problem: &dyn Problem, table: &MetricTable) -> u64 {
    problem
        .contact()
        .map_or(0, |metric| table.solved_without(metric))
}

/// The default metrics of the cases in these rows, in their order, L at a time where their runs are not too long; to the bit
/// what each has by itself.
fn sweep_cases<const L: usize, C: LaneCase<L>>(
    problem: &impl Problem,
    cases: &Cases,
    rows: &[u32],
    lane_case: impl Fn(&Case) -> Result<C, Unsolvable>,
) -> MetricTable {
    let mut table = MetricTable::new(rows.len(), defaults(problem));
    let mut together = Vec::with_capacity(rows.len());
    let mut shown = cases.shown();
    for (place, row) in rows.iter().enumerate() {
        let case = shown.at(*row as usize);
        match lane_case(case) {
            Ok(own) if problem.steps(case) <= LONGEST => together.push((place, own)),
            Ok(_) => {
                let solution = problem.solve(case, &[]);
                table.put(place, solution.map(|solution| solution.metrics));
            }
            Err(why) => table.fail(place, why),
        }
    }
    crate::solve::sweep::sweep(&together, &mut table);
    table
}

/// Most steps of a run: a history of more, with its exact solution, would not fit in 2 GiB.
pub const MOST_STEPS: u64 = 30_000_000;

/// The rules that every problem has for its `step` and duration.
fn time_rules(parameter: &'static str, step: f64, duration: f64) -> Vec<Violation> {
    let message = if step > duration {
        format!("must be at most duration = {duration}, got {step}")
    } else if steps(duration, step) > MOST_STEPS {
        format!(
            "gives {:.3e} steps, at most {MOST_STEPS} fit in memory",
            duration / step
        )
    } else {
        return Vec::new();
    };
    vec![Violation { parameter, message }]
}
