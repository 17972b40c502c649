//! The results that figures show, as columns: 8 bytes for a number of a case.

use slipgap_motion::solve::{MetricTable, Warning};
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_problem::problem::table::cases::Cases;
use slipgap_problem::problem::{Case, Schema, Snapshot, Solution};
use slipgap_study::alike::Identity;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// The parameters and metrics of cases, and the histories and profiles of some of them.
#[derive(Debug, Clone)]
pub struct ShownCases {
    cases: Cases,
    /// By row of the measures of the study; NaN where one is undefined.
    metrics: Vec<Vec<f64>>,
    solutions: BTreeMap<usize, Arc<Solution>>,
    snapshots: BTreeMap<usize, Vec<Snapshot>>,
    failed: BTreeSet<usize>,
    runaway: BTreeSet<usize>,
}

/// The columns that figures read.
#[derive(Debug)]
pub struct Needed {
    /// For each row of the table of parameters whether it is one.
    pub parameters: Vec<bool>,
    /// For each row of the measures of the study whether it is one.
    pub measures: Vec<bool>,
}

impl ShownCases {
    /// No cases yet.
    pub fn new(schema: &Arc<Schema>) -> ShownCases {
        ShownCases {
            cases: Cases::new(schema),
            metrics: Vec::new(),
            solutions: BTreeMap::new(),
            snapshots: BTreeMap::new(),
            failed: BTreeSet::new(),
            runaway: BTreeSet::new(),
        }
    }

    /// Number of cases.
    pub fn len(&self) -> usize {
        self.cases.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.cases.is_empty()
    }

    /// Adds those of `cases` in these rows, with their histories, which `solutions` then has no longer.
    pub fn add(
        &mut self,
        cases: &Cases,
        metrics: &MetricTable,
        solutions: &mut BTreeMap<usize, Box<Solution>>,
        rows: &[u32],
        needed: &Needed,
    ) {
        let before = self.len();
        self.cases.extend(cases, rows, |row| needed.parameters[row]);
        self.metrics.resize(needed.measures.len(), Vec::new());
        let columns = self.metrics.iter_mut().zip(&needed.measures).enumerate();
        for (metric, (values, _)) in columns.filter(|(_, (_, needed))| **needed) {
            match metrics.numbers(metric) {
                Some(column) if rows.len() == column.len() => values.extend_from_slice(column),
                Some(column) => values.extend(rows.iter().map(|row| column[*row as usize])),
                None => values.resize(before + rows.len(), f64::NAN),
            }
        }
        let has_more = !solutions.is_empty() || metrics.failures().next().is_some();
        let warned = metrics.warned();
        let runaway = warned.filter(|(_, warnings)| warnings.has(Warning::Runaway));
        for (row, _) in runaway {
            let found = rows.binary_search(&(row as u32)).ok();
            self.runaway.extend(found.map(|index| before + index));
        }
        for (index, row) in (before..).zip(rows).filter(|_| has_more) {
            let row = *row as usize;
            if let Some(solution) = solutions.remove(&row) {
                self.solutions.insert(index, Arc::from(solution));
            }
            if metrics.failure(row).is_some() {
                self.failed.insert(index);
            }
        }
    }

    /// Adds a case with its metrics, the first ones of the measures.
    pub fn push(&mut self, case: &Case, metrics: &[Option<f64>], solution: Option<Solution>) {
        let index = self.len();
        self.metrics.resize(metrics.len(), Vec::new());
        for (values, metric) in self.metrics.iter_mut().zip(metrics) {
            values.push(metric.unwrap_or(f64::NAN));
        }
        self.cases.push(case);
        if let Some(solution) = solution {
            self.solutions.insert(index, Arc::new(solution));
        }
    }

    /// Some of the cases.
    pub fn only(&self, rows: &[u32]) -> ShownCases {
        let mut some = ShownCases::new(self.cases.schema());
        some.cases.extend(&self.cases, rows, |_| true);
        let chosen = |column: &Vec<f64>| match column.is_empty() {
            true => Vec::new(),
            false => rows.iter().map(|row| column[*row as usize]).collect(),
        };
        some.metrics = self.metrics.iter().map(chosen).collect();
        for (index, row) in rows.iter().enumerate() {
            let row = *row as usize;
            let solution = self.solutions.get(&row).cloned();
            some.solutions
                .extend(solution.map(|solution| (index, solution)));
            let snapshots = self.snapshots.get(&row).cloned();
            some.snapshots
                .extend(snapshots.map(|snapshots| (index, snapshots)));
            some.failed
                .extend(self.failed.contains(&row).then_some(index));
            some.runaway
                .extend(self.runaway.contains(&row).then_some(index));
        }
        some
    }

    /// Sets the histories of a case.
    pub fn set_solution(&mut self, row: usize, solution: Solution) {
        self.solutions.insert(row, Arc::new(solution));
    }

    /// Sets the profiles of a case.
    pub fn set_snapshots(&mut self, row: usize, snapshots: Vec<Snapshot>) {
        self.snapshots.insert(row, snapshots);
    }

    /// Whether a case could not be solved.
    pub fn has_failed(&self, row: usize) -> bool {
        self.failed.contains(&row)
    }

    /// The parameters.
    pub fn cases(&self) -> &Cases {
        &self.cases
    }

    /// The case in a row.
    pub fn at(&self, row: usize) -> DrawnCase<'_> {
        DrawnCase { shown: self, row }
    }

    /// All cases.
    pub fn all(&self) -> Vec<DrawnCase<'_>> {
        (0..self.len()).map(|row| self.at(row)).collect()
    }
}

/// A case that a figure draws.
#[derive(Debug, Clone, Copy)]
pub struct DrawnCase<'a> {
    shown: &'a ShownCases,
    row: usize,
}

impl<'a> DrawnCase<'a> {
    /// The value of the parameter in a row of the table; `None` if it does not apply.
    pub fn value(&self, row: usize) -> Option<Value> {
        self.shown.cases.columns()[row].at(self.row)
    }

    /// The same as a number; `None` for a name.
    pub fn number(&self, row: usize) -> Option<f64> {
        self.value(row)?.as_f64()
    }

    /// The metric in a row of the study's measures; `None` if it is undefined.
    pub fn metric(&self, row: usize) -> Option<f64> {
        let value = self.shown.metrics.get(row)?.get(self.row)?;
        Some(*value).filter(|x| !x.is_nan())
    }

    /// Whether its structure has lost its stability and run away.
    pub fn has_run_away(&self) -> bool {
        self.shown.runaway.contains(&self.row)
    }

    /// The values of these parameters, as a key.
    pub fn identity(&self, rows: &[usize]) -> Identity {
        let values = rows.iter().map(|row| self.value(*row));
        values.map(|value| value.map(Value::identity)).collect()
    }

    /// All parameters.
    pub fn case(&self) -> Case {
        self.shown.cases.shown().at(self.row).clone()
    }

    /// Its histories, for kinds that draw them; `None` if the case could not be solved.
    pub fn solution(&self) -> Option<&'a Solution> {
        self.shown
            .solutions
            .get(&self.row)
            .map(|solution| &**solution)
    }

    /// The quantities along the structure at the figure's times, rising; empty for kinds that do not draw them.
    pub fn snapshots(&self) -> &'a [Snapshot] {
        let snapshots = self.shown.snapshots.get(&self.row);
        snapshots.map_or(&[], Vec::as_slice)
    }
}
