//! From the tree of a study file to a validated study, or to all its faults.

pub(super) mod blocks;
pub(super) mod checks;
mod columns;
mod ensemble;
mod keys;
mod references;
pub(super) mod resolve;
mod spread;
#[cfg(test)]
mod tests;
pub(super) mod units;
pub(super) mod validate;

pub(crate) use keys::{KEYS, OF_STUDY};
use std::path::Path;

use crate::cases::scope::Scope;
use crate::error::Error;
use crate::figure::figures;
use crate::measure;
use crate::source::faults::Faults;
use crate::source::folder::Folder;
use crate::source::hint::nearest;
use crate::source::input::{Input, tree_of};
use crate::source::object::Object;
use crate::source::place::Texts;
use crate::source::setting;
use crate::source::tree::{Node, Tree};
use crate::structure::keys::KEY as MEASURED;
use crate::structure::named::free_names::with_free_names;
use crate::structure::named::shown::{SHOWN, of_programs};
use crate::structure::programs;
use crate::structure::programs::textbook::with_programs;
use crate::structure::{
    self,
    recorded::{own_records, record_axis},
};
use crate::units::Units;
use crate::value::name;
use crate::{Study, calibrate, computed, reduction};
use blocks::blocks;
use checks::check;
use columns::columns;
use ensemble::ensemble;
use slipgap_problem::problem::structure::metrics::unit_consistency;
use slipgap_problem::problem::structure::tables::schema::NAME;
use slipgap_problem::problem::{self, PROBLEMS, Problem};
use std::sync::Arc;
use validate::MOST_CASES;

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
        spread::share(&mut root);
        let mut texts = Texts::new(&self.file, &self.text);
        let settings = self.settings.iter();
        let pushed = settings.map(|setting| texts.push(setting.source(), setting.text()));
        let starts: Vec<usize> = pushed.collect();
        let mut faults = Faults::default();
        let seed = self
            .sets_record()
            .then(|| own_records::seed(&root))
            .flatten();
        setting::put_all(&mut root, &self.settings, &starts, &mut faults);
        let before = faults.count();
        let folder = Folder::new(&self.folder, &self.file);
        record_axis::expand(&mut root, &folder, &mut faults);
        if faults.count() > before {
            // Without its files, an axis would be a fault of its own.
            return Err(Error::Faults(faults.in_file_order(texts)));
        }
        if let Some(seed) = &seed {
            own_records::replace(&mut root, seed, &mut faults);
        }
        spread::spread(&mut root);
        let set = self
            .settings
            .iter()
            .map(|setting| [setting.name().to_owned(), setting.name().to_owned()]);
        let of_records = seed.map(|seed| [seed, own_records::RECORD.to_owned()]);
        Ok(Expanded {
            root,
            folder,
            texts,
            set: set.chain(of_records).collect(),
            faults,
        })
    }

    fn decoded(&self, expanded: Expanded, limit: u64, whole: bool) -> Result<Study, Error> {
        let Expanded {
            root,
            folder,
            texts,
            set,
            mut faults,
        } = expanded;
        match study(&root, limit, &folder, (set, whole), &mut faults) {
            Some(study) if faults.count() == 0 => {
                if let (Some(runner), Some(programs)) = (&self.programs, study.programs()) {
                    programs.allow(runner.clone());
                }
                Ok(Study {
                    settings: self.settings.clone(),
                    sha256: self.sha256(),
                    read: folder.into_files(),
                    ..study
                })
            }
            Some(_) | None => Err(Error::Faults(faults.in_file_order(texts))),
        }
    }
}

/// The tree of a study with the settings and the lists of files in it.
pub(crate) struct Expanded<'a> {
    pub root: Node,
    /// The folder of its files, and which of them were read.
    folder: Folder<'a>,
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
    folder: &Folder,
    (set, whole): (Vec<[String; 2]>, bool),
    faults: &mut Faults,
) -> Option<Study> {
    let object = Object::open(root, "", &KEYS, faults)?;
    object.text("$schema", faults);
    let title = object.text("title", faults).unwrap_or_default();
    let problem = problem(&object, (root, whole), folder, faults)
        .map(|problem| with_free_names(problem, (root, whole), faults))
        .map(|problem| {
            let shown = match problem.as_textbook() {
                Some(_) => of_programs(&object, &programs::names(root), faults),
                None => Vec::new(),
            };
            with_programs(problem, (&object, root), (folder, shown), faults)
        });
    let blocks = blocks(&object, problem.as_deref(), limit, faults);
    let units = object
        .get("units")
        .and_then(|node| Units::decode(node, problem.as_deref(), faults));
    // The other names need the tables of the problem.
    let problem = problem?;
    let size = |of| unit_consistency::size_of(&units.as_ref()?.of(of), of);
    let problem = problem
        .as_textbook()
        .and_then(|textbook| textbook.in_units(&size))
        .unwrap_or(problem);
    let once = object.word("iteration", faults) == Some(1);
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
        read: Vec::new(),
    })
}

/// The problem by its name. A misspelt name is a fault; the nearest problem is then used to find further faults.
fn problem(
    object: &Object,
    root: (&Node, bool),
    folder: &Folder,
    faults: &mut Faults,
) -> Option<Arc<dyn Problem>> {
    let known: Vec<&str> = problem::names().collect();
    let node = object.need("problem", &format!("one of {}", known.join(", ")), faults)?;
    let row = name(node, "problem", "problem", &known, faults);
    let of_structure = row.is_some_and(|row| problem::is_described(known[row]));
    if row.is_some() && !of_structure {
        for (key, what) in [
            ("structure", "has this key"),
            (MEASURED.name, "compares with measurements"),
            (SHOWN.name, "names its parameters"),
        ] {
            // There, they are names of programs.
            let allowed = key == SHOWN.name && object.get(programs::KEY.name).is_some();
            if let (Some(node), false) = (object.get(key), allowed) {
                let message = format!("only a study with \"problem\": \"{NAME}\" {what}");
                faults.add(node.at, key, message);
            }
        }
    }
    match (row, &node.tree) {
        (Some(_), _) if of_structure => structure::problem(object, root, folder, faults),
        (Some(row), _) => Some(PROBLEMS[row].clone()),
        (None, Tree::Text(misspelt)) => problem::find(nearest(misspelt, &known)?),
        (None, _) => None,
    }
}
