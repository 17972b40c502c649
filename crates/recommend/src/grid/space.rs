//! Search spaces: the candidates of a problem.

use super::Request;
use crate::Variant;
use slipgap_problem::problem::Case;
use slipgap_problem::problem::Problem;
use slipgap_problem::problem::Solution;

/// Candidates of the same cost, with their neighbours.
#[derive(Debug, Default)]
pub struct CostLevel {
    /// The cases of candidates and neighbours.
    pub cases: Vec<Case>,
    /// For each candidate its index in `cases`, then those of its neighbours.
    pub candidates: Vec<Vec<usize>>,
}

/// The candidates of a search.
pub trait SearchSpace: Send + Sync {
    /// The problem.
    fn problem(&self) -> &'static dyn Problem;
    /// Names of the parameters in the table of an answer.
    fn table_parameters(&self) -> Vec<&'static str>;
    /// Names of the parameters of an answer in a study.
    fn study_parameters(&self) -> Vec<&str>;
    /// The value of a parameter in the table.
    fn table_cell(&self, case: &Case, name: &str) -> String {
        self.study_value(case, name)
    }
    /// The value of a parameter in a study, as an expression if that is rounder; `-` if the parameter does not apply.
    fn study_value(&self, case: &Case, name: &str) -> String;
    /// Sentences about the candidates, the neighbours, and the cases that are not searched.
    fn notes(&self) -> Vec<String>;
    /// The unit of the cost.
    fn cost_title(&self) -> &'static str;
    /// The cost of every level.
    fn costs(&self) -> Vec<u64>;
    /// A level by its index in `costs`.
    fn level(&self, index: usize) -> CostLevel;
    /// The other conditions for which a candidate with these cases must hold, if any.
    fn further(&self, _candidate: &[Case]) -> Further {
        Further::default()
    }
    /// Many conditions, on which the answer is looked at in the end; `None` if there is one only.
    fn range(&self, _case: &Case) -> Option<Range> {
        None
    }
    /// Smallest and largest changes of energy that a case with these default metrics can have.
    fn energy_bounds(&self, _case: &Case, _metrics: &[Option<f64>]) -> [EnergyChange; 2] {
        [EnergyChange::NONE, EnergyChange::UNKNOWN]
    }
    /// The change of energy of a case.
    fn energy_change(&self, case: &Case, solution: &Solution) -> EnergyChange;
}

/// Conditions that are tested only if a candidate reaches the target at those of its level.
#[derive(Debug, Default)]
pub struct Further {
    /// Those of the candidate itself, which must also hold with finer steps.
    pub own: Vec<Case>,
    /// Those of its neighbours.
    pub neighbours: Vec<Case>,
}

/// One case at many values of a parameter, densely from the first to the last.
#[derive(Debug)]
pub struct Range {
    /// The parameter.
    pub parameter: &'static str,
    /// What it is called, in the plural.
    pub title: &'static str,
    /// The cases, in the order of its values.
    pub cases: Vec<Case>,
}

/// The change of energy of a run, relative to the energy at the start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EnergyChange {
    /// The largest gain at any step.
    pub gain: f64,
    /// The loss up to the last step; zero for a problem that loses energy in the exact motion.
    pub loss: f64,
}

impl EnergyChange {
    /// No change.
    pub const NONE: EnergyChange = EnergyChange {
        gain: 0.0,
        loss: 0.0,
    };
    /// Above all limits.
    pub const UNKNOWN: EnergyChange = EnergyChange {
        gain: f64::INFINITY,
        loss: f64::INFINITY,
    };

    /// Whether it is within the limits of a request.
    pub fn within(&self, request: &Request) -> bool {
        self.gain <= request.energy_gain && self.loss <= request.energy_loss
    }
}

/// How many candidates of a space are searched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Grid {
    /// Some of them, enough to compare laws and methods.
    Coarse,
    /// All.
    Fine,
}

/// A search space with several laws and methods. Each of its levels is of one variant.
pub trait Variants: SearchSpace {
    /// The laws with their methods.
    fn variants(&self) -> &[Variant];
    /// The index of the variant of a level.
    fn variant_of(&self, level: usize) -> usize;
    /// The space of these variants.
    fn with(&self, variants: &[usize], grid: Grid) -> Box<dyn Variants>;
    /// Itself, without its variants.
    fn space(&self) -> &dyn SearchSpace;
}
