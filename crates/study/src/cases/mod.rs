//! The cases of a study, which `slipgap-cases` makes from its blocks.

pub(crate) mod ensemble;
pub mod scope;

use super::Study;
use slipgap_cases::{Enumeration, Filter, Selected};
use slipgap_motion::solve::Unsolvable;
use slipgap_problem::problem::structure::programs::Programs;
use slipgap_problem::problem::table::cases::Cases;
use slipgap_problem::problem::{Case, MeasuredChannel, Samples, Solution, Violation};

impl Study {
    /// The cases with their numbers.
    pub fn enumeration(&self) -> Enumeration<'_> {
        Enumeration {
            problem: &*self.problem,
            blocks: &self.blocks,
        }
    }

    /// Number of cases, or a larger number if they are not [counted](Enumeration::is_counted).
    pub fn len(&self) -> u64 {
        self.enumeration().len()
    }

    /// Whether there are no cases. No valid study is empty.
    pub fn is_empty(&self) -> bool {
        self.enumeration().is_empty()
    }

    /// Number of raw combinations, at most the limit of the study.
    pub fn raw_len(&self) -> u64 {
        self.enumeration().raw_len()
    }

    /// Case `index`, from 0, completed; `None` from `len` on, and for a combination that is no case.
    pub fn case(&self, index: u64) -> Option<Case> {
        self.enumeration().case(index)
    }

    /// The rules that case `index` breaks. Only a large study has such cases.
    pub fn violations(&self, index: u64) -> Vec<Violation> {
        self.enumeration().violations(index)
    }

    /// The solution of a completed case: by steps to convergence, or each solved once.
    ///
    /// # Errors
    /// Why it has none.
    pub fn solve(&self, case: &Case) -> Result<Solution, Unsolvable> {
        match self.problem.as_textbook().filter(|_| self.once) {
            Some(textbook) => textbook.solve_once(case, &self.metrics),
            None => self.problem.solve(case, &self.metrics),
        }
    }

    /// The cost of a completed case: steps times modes, and the references of the study's metrics.
    pub fn work(&self, case: &Case) -> u64 {
        let work = self.problem.work(case, &self.metrics);
        let steps = match self.problem.as_textbook().filter(|_| self.once) {
            Some(textbook) => textbook.once_work(case),
            None => work.steps,
        };
        steps.saturating_add(work.references)
    }

    /// The cost of each of these cases; 0 of a case that breaks a rule, which may have any number of steps.
    pub fn costs<'a>(&'a self, cases: &'a Cases) -> impl Iterator<Item = u64> + 'a {
        let deciding = self
            .problem
            .as_textbook()
            .and_then(|textbook| textbook.cost_rows(&self.metrics));
        let common = deciding.and_then(|rows| cases.common(rows.into_iter()));
        let same = common.map(|case| self.work(&case));
        let mut shown = cases.shown();
        (0..cases.len()).map(move |row| match (cases.may_be_solved(row), same) {
            (true, Some(same)) => same,
            (true, None) => self.work(shown.at(row)),
            (false, _) => 0,
        })
    }

    /// The programs of others that compute some of its cases; `None` without.
    pub fn programs(&self) -> Option<&Programs> {
        let programs = self.problem.programs()?;
        (!programs.list.is_empty()).then_some(programs)
    }

    /// What identifies the sampled signals of a completed case.
    pub fn samples(&self, case: &Case) -> Samples {
        let structure = self.problem.as_structure();
        structure.map_or_else(Samples::default, |structure| structure.samples(case))
    }

    /// What was measured of the motion of a completed case, for each channel that the study gives; none without.
    pub fn measured(&self, case: &Case) -> Vec<MeasuredChannel> {
        let structure = self.problem.as_structure();
        structure.map_or_else(Vec::new, |structure| structure.measured(case))
    }

    /// Rows of the parameters that are columns of tables, in the order of the problem's table.
    pub fn parameter_columns(&self) -> Vec<usize> {
        self.enumeration().parameter_columns()
    }

    /// All cases in order, each made when the iterator reaches it.
    pub fn cases(&self) -> impl Iterator<Item = Case> + '_ {
        self.range(0, self.raw_len()).map(|(_, case)| case)
    }

    /// The cases among raw combinations `from..to` with their numbers.
    pub fn range(&self, from: u64, to: u64) -> Selected<'_, (u64, Case)> {
        self.enumeration().range(from, to)
    }

    /// The cases among raw combinations `from..to` as columns, and the number of the first; without any, that of the next case.
    pub fn columns(&self, from: u64, to: u64) -> (u64, Cases) {
        self.enumeration().columns(from, to)
    }

    /// The numbers of the cases that a filter selects, in rising order.
    pub fn select<'a>(&'a self, filter: &'a Filter) -> Selected<'a, u64> {
        self.enumeration().select(filter)
    }
}
