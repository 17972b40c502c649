//! From the tree of a study file to a validated study, or to all its faults.

pub(super) mod blocks;
pub(super) mod checks;
mod ensemble;
mod references;
pub(super) mod resolve;
pub(super) mod units;
pub(super) mod validate;

use std::path::Path;

use crate::cases::scope::Scope;
use crate::computed::decode::Listed;
use crate::error::Error;
use crate::figure::figures;
use crate::measure;
use crate::source::faults::Faults;
use crate::source::hint::nearest;
use crate::source::input::{Input, tree_of};
use crate::source::object::Object;
use crate::source::place::Texts;
use crate::source::setting;
use crate::source::tree::{Node, Tree};
use crate::structure::measured::KEY as MEASURED;
use crate::structure::names::SHOWN;
use crate::structure::{self, own_records, record_axis};
use crate::units::Units;
use crate::value::{self, name};
use crate::{Check, Figure, Study, calibrate, computed, reduction};
use blocks::{BLOCK_KEYS, blocks};
use checks::check;
use ensemble::ensemble;
use slipgap_solver::problem::structure::schema::NAME;
use slipgap_solver::problem::{self, PROBLEMS, Problem};
use std::sync::Arc;
use validate::MOST_CASES;

/// The keys of a study, each with its meaning.
pub(crate) const KEYS: [(&str, &str); 17] = [
    (
        "$schema",
        "location of the schema, for editors; slipgap ignores it",
    ),
    ("title", "what the study shows, in one line"),
    ("problem", "the problem to solve"),
    ("parameters", "parameters of the cases; a list is an axis"),
    (
        "structure",
        "masses, bars, springs, contacts and loads of a study of structures",
    ),
    structure::measured::KEY,
    (
        "blocks",
        "several sets of parameters instead of one; their cases follow one another",
    ),
    (
        "metrics",
        "metrics to compute in addition to the default ones; each is a column of results.csv; a name, arithmetic such as \"max(a3 - a2)/h\", a ratio to a reference case such as \"peak(gap.S) relative to gamma = 1, n = 10\", or an object that gives one a name: {\"drift\": \"max(a3 - a2)/h\"} or {\"drift\": {\"value\": \"max(a3 - a2)/h\", \"unit\": \"rad\", \"title\": \"drift\"}}",
    ),
    reduction::decode::KEY,
    (
        "ensemble",
        "a parameter or a list of parameters over which the cases are an ensemble",
    ),
    (
        "units",
        "units of the parameters, for results in them; nothing is converted",
    ),
    structure::names::SHOWN,
    (
        "iteration",
        "converged (if left out), or once: each step is solved once with the matrices of the papers, without iteration",
    ),
    (
        "calibrate",
        "free parameters with their ranges and the metric to minimise, for `slipgap calibrate`",
    ),
    (
        "recommend",
        "the parameters to choose and the metrics to keep within tolerances, for `slipgap recommend`",
    ),
    ("figures", "figures to draw"),
    ("checks", "limits that `slipgap check` tests"),
];

/// Names of the ways to solve a step.
pub(crate) const ITERATIONS: [&str; 2] = ["converged", "once"];

/// Reads a study file of at most [`MOST_CASES`] raw combinations. Faults name the file as `file` does.
pub fn read(file: &Path) -> Result<Study, Error> {
    Input::of_file(file)?.study(MOST_CASES)
}

/// Reads a study from its text; `file` is its name in faults.
pub fn parse(file: &str, text: &str) -> Result<Study, Error> {
    Input::new(file, text).study(MOST_CASES)
}

impl Input {
    /// Whether the study can use every setting: false if `record` is set and it has neither such a parameter nor synthetic motions
    /// that records can replace. A text that is not JSON can; reading it gives its faults.
    pub fn uses_settings(&self) -> bool {
        if !self.sets_record() {
            return true;
        }
        tree_of(&self.file, &self.text).map_or(true, |root| own_records::takes_record(&root))
    }

    fn sets_record(&self) -> bool {
        let mut settings = self.settings.iter();
        settings.any(|setting| setting.name() == own_records::RECORD)
    }

    /// The study, of at most `limit` raw combinations.
    ///
    /// # Errors
    /// Every fault of the text and of the settings.
    pub fn study(&self, limit: u64) -> Result<Study, Error> {
        self.decoded(self.expanded()?, limit, true)
    }

    /// The study that an edited tree describes. Parameters that it does not use any more are no fault.
    pub(crate) fn edited(&self, limit: u64, edit: impl FnOnce(&mut Node)) -> Result<Study, Error> {
        let mut expanded = self.expanded()?;
        edit(&mut expanded.root);
        self.decoded(expanded, limit, false)
    }

    /// The tree with the settings and the lists of files in it.
    pub(crate) fn expanded(&self) -> Result<Expanded<'_>, Error> {
        let mut root = tree_of(&self.file, &self.text)?;
        let mut texts = Texts::new(&self.file, &self.text);
        let settings = self.settings.iter();
        let starts = settings.map(|setting| texts.push(setting.source(), setting.text()));
        let starts: Vec<usize> = starts.collect();
        let mut faults = Faults::default();
        let seed = self
            .sets_record()
            .then(|| own_records::seed(&root))
            .flatten();
        setting::put_all(&mut root, &self.settings, &starts, &mut faults);
        let before = faults.count();
        record_axis::expand(&mut root, &self.folder, &mut faults);
        if faults.count() > before {
            // Without its files, an axis would be a fault of its own.
            return Err(Error::Faults(faults.in_file_order(texts)));
        }
        if let Some(seed) = &seed {
            own_records::replace(&mut root, seed, &mut faults);
        }
        let set = self
            .settings
            .iter()
            .map(|setting| [setting.name().to_owned(), setting.name().to_owned()]);
        let of_records = seed.map(|seed| [seed, own_records::RECORD.to_owned()]);
        Ok(Expanded {
            root,
            texts,
            set: set.chain(of_records).collect(),
            faults,
        })
    }

    fn decoded(&self, expanded: Expanded, limit: u64, whole: bool) -> Result<Study, Error> {
        let Expanded {
            root,
            texts,
            set,
            mut faults,
        } = expanded;
        match study(&root, limit, &self.folder, (set, whole), &mut faults) {
            Some(study) if faults.count() == 0 => Ok(Study {
                settings: self.settings.clone(),
                sha256: self.sha256(),
                ..study
            }),
            Some(_) | None => Err(Error::Faults(faults.in_file_order(texts))),
        }
    }
}

/// The tree of a study with the settings and the lists of files in it.
pub(crate) struct Expanded<'a> {
    pub root: Node,
    /// The texts of its places.
    texts: Texts<'a>,
    /// The parameters that the command line set, each with the name of its setting.
    set: Vec<[String; 2]>,
    /// The faults found so far.
    faults: Faults,
}

/// The study at `root`, of at most `limit` raw combinations, without its settings and hash; records are in `folder`. The command
/// line set the parameters `set`, each with the name of its setting. Of a study that is not `whole`, unused parameters are no fault.
pub(crate) fn study(
    root: &Node,
    limit: u64,
    folder: &Path,
    (set, whole): (Vec<[String; 2]>, bool),
    faults: &mut Faults,
) -> Option<Study> {
    let keys: Vec<&str> = KEYS.iter().chain(&BLOCK_KEYS).map(|key| key.0).collect();
    let object = Object::open(root, "", &keys, faults)?;
    let mut string = |key: &str| {
        let node = object.get(key)?;
        value::text(node, &object.path(key), faults)
    };
    string("$schema");
    let title = string("title").unwrap_or_default();
    let problem = problem(&object, (root, whole), folder, faults);
    let blocks = blocks(&object, problem.as_deref(), limit, faults);
    let units = object
        .get("units")
        .and_then(|node| Units::decode(node, problem.as_deref(), faults));
    // The other names need the tables of the problem.
    let problem = problem?;
    let once = object
        .get("iteration")
        .and_then(|node| name(node, "iteration", "iteration", &ITERATIONS, faults))
        == Some(1);
    if let (true, Some(node)) = (once && problem.schema().described, object.get("iteration")) {
        let message = "a structure has no un-iterated form; allowed: converged";
        faults.add(node.at, "iteration", message);
    }
    let mut scope = Scope {
        measures: measure::measures(&*problem, units.as_ref()),
        problem,
        blocks,
        ensemble: None,
        once,
        checked: Vec::new(),
        set,
    };
    let listed = computed::decode::computed(&object, &mut scope, faults);
    let reductions = reduction::decode::measures(
        &object,
        &*scope.problem,
        &scope.measures,
        &scope.blocks,
        faults,
    );
    scope.measures.extend(reductions);
    scope.ensemble = ensemble(&object, &scope, faults);
    let calibrate = calibrate::decode::calibrate(&object, &scope, faults);
    let recommend = calibrate::recommend::recommend(&object, &scope, faults);
    let checks = object.items("checks", faults, |node, path, faults| {
        check(node, path, &scope, faults)
    });
    scope.checked = checks.iter().map(|check| check.metric).collect();
    let figures = figures(&object, &scope, faults);
    calibrate::decode::refuse_figures(&object, &figures, faults);
    let (metrics, columns) = columns(&scope, &listed, &figures, &checks);
    Some(Study {
        title,
        problem: scope.problem,
        once,
        units,
        columns,
        metrics,
        measures: scope.measures,
        blocks: scope.blocks,
        ensemble: scope.ensemble.unwrap_or_default(),
        calibrate,
        recommend,
        figures,
        checks,
        settings: Vec::new(),
        sha256: String::new(),
    })
}

/// The problem by its name. A misspelt name is a fault; the nearest problem is then used to find further faults.
fn problem(
    object: &Object,
    root: (&Node, bool),
    folder: &Path,
    faults: &mut Faults,
) -> Option<Arc<dyn Problem>> {
    let known: Vec<&str> = problem::names().collect();
    let node = object.need("problem", &format!("one of {}", known.join(", ")), faults)?;
    let row = name(node, "problem", "problem", &known, faults);
    let of_structure = row.is_some_and(|row| problem::is_described(known[row]));
    if let (Some(_), Some(node)) = (row.filter(|_| !of_structure), object.get("structure")) {
        let message = format!("only a study with \"problem\": \"{NAME}\" has this key");
        faults.add(node.at, "structure", message);
    }
    if let (Some(_), Some(node)) = (row.filter(|_| !of_structure), object.get(MEASURED.0)) {
        let message =
            format!("only a study with \"problem\": \"{NAME}\" compares with measurements");
        faults.add(node.at, MEASURED.0, message);
    }
    if let (Some(_), Some(node)) = (row.filter(|_| !of_structure), object.get(SHOWN.0)) {
        let message = format!("only a study with \"problem\": \"{NAME}\" names its parameters");
        faults.add(node.at, SHOWN.0, message);
    }
    match (row, &node.tree) {
        (Some(_), _) if of_structure => structure::problem(object, root, folder, faults),
        (Some(row), _) => Some(PROBLEMS[row].clone()),
        (None, Tree::Text(misspelt)) => problem::find(nearest(misspelt, &known)?),
        (None, _) => None,
    }
}

/// The metrics that are computed, in the order of the table: those that are default, that the study lists or reduces, that a
/// figure or check needs, and what other metrics are computed from. Then the columns of results.csv: not what the study names only in
/// arithmetic.
fn columns(
    scope: &Scope,
    listed: &Listed,
    figures: &[Figure],
    checks: &[Check],
) -> (Vec<usize>, Vec<usize>) {
    let (problem, measures) = (&*scope.problem, &scope.measures);
    let shown = |figure: &Figure| figure.kind.decoded().measures(problem);
    let drawn = figures.iter().flat_map(shown);
    let checked = checks.iter().map(|check| check.metric);
    let reduced = measures.iter().enumerate();
    let reduced = reduced.filter_map(|(row, measure)| Some([row, measure.reduction.as_ref()?.of]));
    let named = listed.named.iter().copied().chain(checked);
    let named: Vec<usize> = named.chain(reduced.flatten()).chain(drawn).collect();
    let count = problem.parameters().len();
    let all_of = |row: &usize| computed::metrics_of(measures, *row, count);
    let needed: Vec<usize> = named
        .iter()
        .chain(&listed.columns)
        .flat_map(all_of)
        .collect();
    let own = named.iter().filter_map(|row| measures[*row].metric);
    let own: Vec<usize> = own.collect();
    let parts: Vec<usize> = listed.columns.iter().flat_map(all_of).collect();
    let described = problem.schema().described;
    let metrics = problem.metrics().iter().enumerate();
    let metrics: Vec<usize> = metrics
        .filter(|(row, metric)| metric.default || needed.contains(row))
        .map(|(row, _)| row)
        .collect();
    let is_part = |row: &usize| {
        let usual = problem.metrics()[*row].default && !described;
        parts.contains(row) && !own.contains(row) && !usual
    };
    let columns: Vec<usize> = metrics
        .iter()
        .copied()
        .filter(|row| !is_part(row))
        .collect();
    let mut columns = measure::columns(measures, &columns);
    columns.extend(&listed.columns);
    (metrics, columns)
}
