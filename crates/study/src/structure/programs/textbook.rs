//! Programs of others in a study of a textbook problem: the problem, whose cases by a program are those of the structure that describes it.

use super::described::structure;
use super::{choices, list, restricted};
use crate::source::faults::Faults;
use crate::source::folder::Folder;
use crate::source::object::Object;
use crate::source::tree::Node;
use crate::structure::identity::identity;
use crate::structure::reading::reader::Reader;
use slipgap_motion::history::History;
use slipgap_motion::solve::{MetricTable, Unsolvable, Warning, Warnings};
use slipgap_problem::problem::method::PARAMETERS;
use slipgap_problem::problem::numbers::parameter::{Kind, Parameter, Value};
use slipgap_problem::problem::numbers::unit::Dimension;
use slipgap_problem::problem::structure::programs::{Program, Programs};
use slipgap_problem::problem::structure::tables::of_programs;
use slipgap_problem::problem::table::cases::Cases;
use slipgap_problem::problem::{
    self, Case, Described, Jumps, Problem, ProblemKind, Schema, Snapshot, Solution, Textbook,
    Violation, Work,
};
use slipgap_system::methods::METHODS;
use slipgap_system::system::System;
use std::sync::Arc;

/// The metrics of a textbook problem that are those of a method of the product.
const OF_METHOD: [&str; 3] = ["spectral_radius", "period_elongation", "numerical_damping"];

/// Those that estimate an error by steps of the product.
const OF_STEPS: &str = "reference_error";

/// A textbook problem with programs.
#[derive(Debug, Clone)]
struct WithPrograms {
    problem: Arc<dyn Problem>,
    schema: Arc<Schema>,
    programs: Arc<Programs>,
    /// Row of the parameter that chooses the method.
    method: usize,
}

/// The problem with the programs of the study at `root`, with the names of them that are `shown` in figures; the same without any, and
/// that of a structure.
pub(crate) fn with_programs(
    problem: Arc<dyn Problem>,
    (root, root_node): (&Object, &Node),
    (folder, shown): (&Folder, Vec<(String, String)>),
    faults: &mut Faults,
) -> Arc<dyn Problem> {
    let method = problem
        .parameters()
        .iter()
        .position(|parameter| parameter.name == PARAMETERS[0].name);
    let (Some(_), Some(node), Some(method)) =
        (problem.as_textbook(), root.get(super::KEY.name), method)
    else {
        return problem;
    };
    let mut schema = (**problem.schema()).clone();
    let reader = Reader::plain(root_node, problem.parameters(), folder);
    let (programs, used) = list(root, &reader, faults);
    let identity = identity((node, None), (None, None), &reader.records.borrow());
    let own = problem::find(problem.name()).map_or(0, |own| own.parameters().len());
    let rows = schema.parameters.to_mut();
    for (row, names) in restricted(&reader, &used) {
        if row >= own {
            rows[row].applies = of_programs(names);
        }
    }
    if let Some(names) = choices(root_node) {
        rows[method].kind = Kind::Choice(names);
    }
    let words = shown
        .into_iter()
        .map(|(name, words)| (name.into(), words.into()));
    rows[method].shown_values = words.collect();
    Arc::new(WithPrograms {
        schema: Arc::new(schema),
        programs: Arc::new(Programs::new(programs, folder.study.clone(), identity)),
        problem,
        method,
    })
}

impl WithPrograms {
    fn textbook(&self) -> Option<&dyn Textbook> {
        self.problem.as_textbook()
    }

    /// The program that computes a case; `None` for one by a method of the product.
    fn program_of(&self, case: &Case) -> Option<&Program> {
        self.programs.named(case.name_at(self.method))
    }

    /// The case by a method of the product, which has no rules of its own.
    fn plain(&self, case: &Case) -> Case {
        let mut plain = case.clone();
        if self.program_of(case).is_some() {
            plain.values[self.method] = Some(Value::Name(METHODS[0].name));
        }
        plain
    }

    fn solve_by_program(
        &self,
        program: &Program,
        case: &Case,
        wanted: &[usize],
    ) -> Result<Solution, Unsolvable> {
        let (textbook, plain) = (
            self.textbook().ok_or(Unsolvable::ParameterMissing)?,
            self.plain(case),
        );
        let broken = |why: String| Unsolvable::Program(format!("{}: {why}", program.name));
        let described = textbook.described(&plain).map_err(broken)?;
        let (study, inner) = structure(
            case,
            &self.schema,
            &described,
            Some((&self.programs, program)),
        )?;
        let motion = study.problem.solve(&inner, &study.metrics)?;
        let channels = &motion.computed.channels[..described.channels.len()];
        let mut solution = match textbook.judged(&plain, channels, wanted) {
            Err(Unsolvable::OutOfRange) => {
                return Err(broken(
                    "a channel that the metrics need has no value (null)".into(),
                ));
            }
            judged => judged?,
        };
        for (metric, value) in self.schema.metrics.iter().zip(&mut solution.metrics) {
            if OF_METHOD.contains(&&*metric.name) || metric.name.starts_with(OF_STEPS) {
                *value = None;
            }
            if metric.name == "cost" {
                *value = motion.metrics.first().copied().flatten();
            }
        }
        solution.warnings = all(motion.warnings.iter().chain(solution.warnings.iter()));
        Ok(solution)
    }
}

/// These warnings.
fn all(warnings: impl Iterator<Item = Warning>) -> Warnings {
    warnings.fold(Warnings::NONE, |all, warning| all.with(warning, true))
}

impl Problem for WithPrograms {
    fn schema(&self) -> &Arc<Schema> {
        &self.schema
    }

    fn kind(&self) -> ProblemKind<'_> {
        ProblemKind::Textbook(self)
    }

    fn complete(&self, case: &mut Case) -> Vec<Violation> {
        let method = case.values[self.method];
        let mut plain = self.plain(case);
        let broken = self.problem.complete(&mut plain);
        *case = plain;
        case.values[self.method] = method;
        broken
    }

    fn work(&self, case: &Case, wanted: &[usize]) -> Work {
        self.problem.work(&self.plain(case), wanted)
    }

    fn solve(&self, case: &Case, wanted: &[usize]) -> Result<Solution, Unsolvable> {
        match self.program_of(case) {
            Some(program) => self.solve_by_program(program, case, wanted),
            None => self.problem.solve(case, wanted),
        }
    }

    fn sweep(&self, cases: &Cases, rows: &[u32]) -> MetricTable {
        self.problem.sweep(cases, rows)
    }

    fn exact(&self, case: &Case, times: &[f64], jumps: Jumps) -> Option<History> {
        self.problem.exact(&self.plain(case), times, jumps)
    }

    fn doubts(&self, case: &Case) -> Vec<(Warning, String)> {
        self.problem.doubts(&self.plain(case))
    }
}

impl Textbook for WithPrograms {
    fn once_work(&self, case: &Case) -> u64 {
        self.textbook()
            .map_or(0, |textbook| textbook.once_work(&self.plain(case)))
    }

    fn solve_once(&self, case: &Case, wanted: &[usize]) -> Result<Solution, Unsolvable> {
        match (self.program_of(case), self.textbook()) {
            (Some(program), _) => self.solve_by_program(program, case, wanted),
            (None, Some(textbook)) => textbook.solve_once(case, wanted),
            (None, None) => Err(Unsolvable::ParameterMissing),
        }
    }

    fn system(&self, case: &Case) -> Option<System> {
        self.textbook()?.system(&self.plain(case))
    }

    fn exact_of_law(&self, case: &Case, times: &[f64]) -> Option<History> {
        self.textbook()?.exact_of_law(&self.plain(case), times)
    }

    fn programs(&self) -> Option<&Programs> {
        Some(&self.programs)
    }

    fn described(&self, case: &Case) -> Result<Described, String> {
        let textbook = self.textbook().ok_or("no textbook problem")?;
        textbook.described(&self.plain(case))
    }

    fn judged(
        &self,
        case: &Case,
        channels: &[Vec<f64>],
        wanted: &[usize],
    ) -> Result<Solution, Unsolvable> {
        let textbook = self.textbook().ok_or(Unsolvable::ParameterMissing)?;
        textbook.judged(&self.plain(case), channels, wanted)
    }

    fn with_parameters(&self, further: Vec<Parameter>) -> Arc<dyn Problem> {
        let schema = self.schema.with_parameters(further);
        Arc::new(WithPrograms {
            schema,
            ..self.clone()
        })
    }

    fn in_units(&self, size: &dyn Fn(Dimension) -> Option<f64>) -> Option<Arc<dyn Problem>> {
        let problem = self.textbook()?.in_units(size)?;
        Some(Arc::new(WithPrograms {
            problem,
            ..self.clone()
        }))
    }

    fn snapshots(&self, case: &Case, times: &[f64]) -> Vec<Snapshot> {
        let of = self.textbook().filter(|_| self.program_of(case).is_none());
        of.map_or(Vec::new(), |textbook| textbook.snapshots(case, times))
    }

    fn after(&self, case: &Case, flight: f64) -> Vec<Option<f64>> {
        let of = self.textbook().filter(|_| self.program_of(case).is_none());
        of.map_or(Vec::new(), |textbook| textbook.after(case, flight))
    }

    fn size(&self, case: &Case, dimension: Dimension) -> Option<f64> {
        self.textbook()?.size(case, dimension)
    }

    fn cost_rows(&self, wanted: &[usize]) -> Option<[usize; 2]> {
        self.textbook()?.cost_rows(wanted)
    }
}
