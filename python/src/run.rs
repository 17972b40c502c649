//! `slipgap.run`: a study in memory, or into its folder with the files of the program.

use crate::given;
use crate::results::Results;
use crate::results::arrow_table::Table;
use crate::results::figure::Shown;
use crate::results::group_tables::Groups;
use crate::results::result_columns::Columns;
use crate::worker;
use arrow_array::RecordBatch;
use indicatif::ProgressBar;
use pyo3::prelude::*;
use slipgap::batch::WarnedCases;
use slipgap::batch::groups::sobol::DesignMetrics;
use slipgap::batch::output::Folder;
use slipgap::batch::output::ensemble::EnsembleMetrics;
use slipgap::batch::output::reductions::ReducedMetrics;
use slipgap::batch::solve::work_progress::WorkProgress;
use slipgap::batch::store::Store;
use slipgap::batch::{self, PartResult, RunOptions, ShownCases};
use slipgap::checks::{CheckCollector, TestedValues};
use slipgap::error::Error;
use slipgap::problem::{Case, cases_without_contact};
use slipgap::run::{Observer, OutputOptions, Source, run_study};
use slipgap::study_figures;
use slipgap::warnings::StudyWarnings;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What a run leaves in memory.
struct Collected {
    batches: Vec<RecordBatch>,
    failures: Vec<(u64, String)>,
    checked: TestedValues,
    without_contact: u64,
    warnings: Vec<WarnedCases>,
    /// The cases that figures show; none if the run wrote the figures.
    shown: ShownCases,
    /// The metrics of its saltelli designs.
    designs: DesignMetrics,
    /// The results over groups of cases.
    groups: Groups,
}

/// Runs a study; `progress` is called with the numbers of finished and of all cases.
#[pyfunction]
#[pyo3(signature = (study, out, jobs, set, progress, allow_programs))]
pub fn run(
    py: Python<'_>,
    study: &Bound<'_, PyAny>,
    out: Option<PathBuf>,
    jobs: Option<i64>,
    set: Option<&Bound<'_, PyAny>>,
    progress: Option<&Bound<'_, PyAny>>,
    allow_programs: bool,
) -> PyResult<Results> {
    let jobs = worker::jobs(py, jobs)?;
    let source = given::computed(py, study, set, allow_programs)?;
    let cases = source.study.len();
    let folder = out.map(|out| out.join(&source.name));
    let (bar, stop) = (ProgressBar::hidden(), Arc::new(WorkProgress::new(0.0)));
    let shared = (bar.clone(), stop.clone());
    let report = |done: u64| match progress {
        Some(progress) => progress.call1((done, cases)).map(|_| ()),
        None => Ok(()),
    };
    let path = folder.clone();
    let (source, columns, collected) = worker::wait(
        py,
        jobs,
        move || {
            let collector = Collector::new(&source.study, shared);
            let schema = collector.columns.schema();
            let collected = match &path {
                Some(path) => to_folder(&source, path, collector)?,
                None => in_memory(&source, collector)?,
            };
            Ok((source, schema, collected))
        },
        || stop.stop(),
        |_| report(bar.position()),
    )?;
    report(cases)?;
    let (cases, designs) = (collected.shown, collected.designs);
    let shown = Arc::new(Shown {
        source: Arc::new(source),
        cases,
        designs,
    });
    let table = Table {
        schema: columns,
        batches: collected.batches,
    };
    Ok(Results {
        table: Py::new(py, table)?,
        figures: Results::figures(py, &shown, folder.as_ref())?,
        folder,
        shown,
        failures: collected.failures,
        checked: collected.checked,
        without_contact: collected.without_contact,
        warnings: collected.warnings,
        groups: collected.groups,
    })
}

/// Runs a study without files.
fn in_memory(source: &Source, mut collector: Collector<'_>) -> Result<Collected, Error> {
    let study = &source.study;
    let (bar, work) = collector.shared.clone();
    let keep = |case: &Case| study_figures::show_history(study, case);
    let options = RunOptions {
        keep_history: study_figures::show_histories(study).then_some(&keep),
        progress: Some(&*work),
        ..RunOptions::METRICS
    };
    let needed = study_figures::needed(study);
    let mut shown = ShownCases::new(study.problem.schema());
    batch::run(study, &bar, &options, |mut part| {
        collector.add(&part)?;
        study_figures::add(study, &needed, &mut part, &mut shown);
        Ok(())
    })?;
    study_figures::add_histories(study, &mut shown);
    collector.finish(shown)
}

/// Runs a study into its folder, as the program does.
fn to_folder(
    source: &Source,
    path: &Path,
    mut collector: Collector<'_>,
) -> Result<Collected, Error> {
    let folder = Folder::of_study(path)?;
    let store = Store::open(path)?;
    let output = OutputOptions::default();
    run_study(source, folder, store, &output, &mut collector)?;
    let none = ShownCases::new(collector.study.problem.schema());
    collector.finish(none)
}

/// Collects the results part by part.
struct Collector<'a> {
    study: &'a slipgap::study::Study,
    shared: (ProgressBar, Arc<WorkProgress>),
    columns: Columns,
    checks: CheckCollector<'a>,
    warnings: StudyWarnings<'a>,
    ensembles: Option<EnsembleMetrics<'a>>,
    reductions: ReducedMetrics<'a>,
    collected: Collected,
    error: Option<Error>,
}

impl<'a> Collector<'a> {
    fn new(
        study: &'a slipgap::study::Study,
        shared: (ProgressBar, Arc<WorkProgress>),
    ) -> Collector<'a> {
        Collector {
            study,
            shared,
            columns: Columns::new(study, &study.columns),
            checks: CheckCollector::new(study),
            warnings: StudyWarnings::new(study),
            ensembles: EnsembleMetrics::new(study),
            reductions: ReducedMetrics::new(study),
            collected: Collected {
                batches: Vec::new(),
                failures: Vec::new(),
                checked: TestedValues::default(),
                without_contact: 0,
                warnings: Vec::new(),
                shown: ShownCases::new(study.problem.schema()),
                designs: DesignMetrics::new(study),
                groups: Groups::default(),
            },
            error: None,
        }
    }

    fn add(&mut self, part: &PartResult) -> Result<(), Error> {
        self.warnings.add(part);
        self.reductions.add(part);
        self.collected
            .designs
            .add(part.first, &part.cases, &part.metrics);
        if let Some(ensembles) = &mut self.ensembles {
            ensembles.add(part);
        }
        let (study, collected) = (self.study, &mut self.collected);
        collected.batches.push(self.columns.of(study, part)?);
        let failures = part.metrics.failures();
        let numbered = failures.map(|(row, why)| (part.first + row as u64, why.to_string()));
        collected.failures.extend(numbered);
        collected.without_contact += cases_without_contact(&*study.problem, &part.metrics);
        self.checks.add(part);
        Ok(())
    }

    fn finish(mut self, shown: ShownCases) -> Result<Collected, Error> {
        if let Some(error) = self.error {
            return Err(error);
        }
        self.collected.groups = Groups::new(self.ensembles.as_ref(), &self.reductions)?;
        self.collected.checked = self.checks.finish();
        self.collected.warnings = self.warnings.list();
        self.collected.shown = shown;
        Ok(self.collected)
    }
}

impl Observer for Collector<'_> {
    fn begin_cases(&mut self, _source: &Source) -> (ProgressBar, Arc<WorkProgress>) {
        self.shared.clone()
    }

    fn part(&mut self, part: &PartResult) {
        if let Err(error) = self.add(part) {
            self.error.get_or_insert(error);
        }
    }

    fn end_cases(&mut self, _source: &Source, _bar: &ProgressBar, _summary: &str) {}

    fn begin_indices(&mut self, _source: &Source, _estimates: usize) -> ProgressBar {
        ProgressBar::hidden()
    }

    fn begin_figures(&mut self, _source: &Source, _figures: usize) -> ProgressBar {
        ProgressBar::hidden()
    }

    fn note(&mut self, _line: &str) {}
}
