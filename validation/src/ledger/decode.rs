//! A ledger, read from its file with its studies.

use std::cell::RefCell;
use std::path::{Path, PathBuf};

use super::expect::expect;
use super::{Claim, Ledger, LedgerStudy, Reading};
use slipgap_study as study;
use slipgap_study::error::Error;
use slipgap_study::faults::{Faults, quoted};
use slipgap_study::input::{text_of, tree_of};
use slipgap_study::object::Object;
use slipgap_study::place::Texts;
use slipgap_study::scope::Scope;
use slipgap_study::search::{named, slashes};
use slipgap_study::tree::{Node, Tree};
use slipgap_study::value::{name, text};

const CLAIM: [&str; 6] = ["id", "where", "says", "quantity", "readings", "because"];
const READING: [&str; 6] = ["reading", "study", "figure", "expect", "holds", "near"];

/// Reads a ledger and its studies. Faults name the file as `file` does.
///
/// # Errors
/// Every fault of the ledger, or of the first study that has any.
pub fn read(file: &Path) -> Result<Ledger, Error> {
    let shown = file.display().to_string();
    let source = text_of(file)?;
    let root = tree_of(&shown, &source)?;
    let mut faults = Faults::default();
    let ledger = ledger(&root, file, &mut faults)?;
    match ledger {
        Some(ledger) if faults.count() == 0 => Ok(ledger),
        Some(_) | None => Err(Error::Faults(
            faults.in_file_order(Texts::new(&shown, &source)),
        )),
    }
}

fn ledger(root: &Node, file: &Path, faults: &mut Faults) -> Result<Option<Ledger>, Error> {
    let Some(object) = Object::of_keys(root, "", &["paper", "studies", "claims"], faults) else {
        return Ok(None);
    };
    let mut string = |key: &str, what: &str| {
        let node = object.need(key, what, faults)?;
        markdown(node, &object.path(key), faults)
    };
    let paper = string("paper", "the name of the paper or of the literature");
    let folder = string(
        "studies",
        "the folder of the studies, relative to this file",
    );
    object.need("claims", "a list of claims", faults);
    let folder = file
        .parent()
        .unwrap_or(Path::new(""))
        .join(folder.unwrap_or_default());
    // A study is read at its first occurrence.
    let found = RefCell::new((Vec::<LedgerStudy>::new(), None));
    let study = |node: &Node, path: &str, faults: &mut Faults| {
        let given = text(node, path, faults)?;
        let (studies, failed) = &mut *found.borrow_mut();
        let file = match study_file(&folder, &given) {
            Ok(Ok(file)) => file,
            Ok(Err(message)) => {
                faults.add(node.at, path, message);
                return None;
            }
            Err(error) => {
                failed.get_or_insert(error);
                return None;
            }
        };
        if let Some(at) = studies.iter().position(|s| s.file == file) {
            return Some(at);
        }
        let relative = file.strip_prefix(&folder).unwrap_or(&file);
        let name = slashes(&relative.with_extension(""));
        match study::read(&file) {
            Ok(study) => {
                studies.push(LedgerStudy { name, file, study });
                Some(studies.len() - 1)
            }
            Err(error) => {
                failed.get_or_insert(error);
                None
            }
        }
    };
    let scope = |at: usize| {
        let (studies, _) = &*found.borrow();
        let study = &studies[at].study;
        let figures: Vec<String> = study.figures.iter().map(|f| f.name.clone()).collect();
        let scope = Scope {
            problem: study.problem.clone(),
            measures: study.measures.clone(),
            blocks: study.blocks.clone(),
            ensemble: None,
            once: study.once,
            checked: Vec::new(),
            set: Vec::new(),
        };
        (scope, figures, study.columns.clone())
    };
    let claims = object.items("claims", faults, |node, path, faults| {
        claim(node, path, faults, &|node, path, faults| {
            reading(node, path, faults, &study, &scope)
        })
    });
    for (i, claim) in claims.iter().enumerate() {
        if claims[..i].iter().any(|first| first.id == claim.id) {
            object.fault(
                format!("two claims have the id {}", quoted(&claim.id)),
                faults,
            );
        }
    }
    let (studies, failed) = found.into_inner();
    match failed {
        Some(error) => Err(error),
        None => Ok(paper.map(|paper| Ledger {
            paper,
            claims,
            studies,
        })),
    }
}

/// The file of the study `name` in the folder of the studies or a folder in it, or why there is not one.
fn study_file(folder: &Path, name: &str) -> Result<Result<PathBuf, String>, Error> {
    let study_path = PathBuf::from(format!("{name}.json"));
    let file = folder.join(&study_path);
    if file.is_file() {
        return Ok(Ok(file));
    }
    let mut files = named(folder, &study_path)?;
    Ok(match (files.pop(), &files[..]) {
        (Some(file), []) => Ok(file),
        (None, _) => Err(format!("no study {}", file.display())),
        (Some(last), [first, ..]) => Err(format!(
            "{} and {} have this name; give the folder, too",
            first.display(),
            last.display()
        )),
    })
}

fn claim(
    node: &Node,
    path: &str,
    faults: &mut Faults,
    reading: &dyn Fn(&Node, &str, &mut Faults) -> Option<Reading>,
) -> Option<Claim> {
    let before = faults.count();
    let object = Object::of_keys(node, path, &CLAIM, faults)?;
    let mut string = |key: &str, what: &str| {
        let node = object.need(key, what, faults)?;
        markdown(node, &object.path(key), faults)
    };
    let id = string("id", "a short name");
    let place_in_paper = string("where", "its place in the paper, or its source");
    let statement = string("says", "the statement");
    let quantity = string("quantity", "the quantity that decides");
    let node = object.get("because");
    let because = node.and_then(|node| markdown(node, &object.path("because"), faults));
    if let (Some(id), Some(node)) = (&id, object.get("id"))
        && !is_id(id)
    {
        faults.must_be(node, &object.path("id"), "letters, digits, - and _");
    }
    let readings = object.items("readings", faults, reading);
    if faults.count() == before && readings.is_empty() {
        object.missing("readings", "at least one reading", faults);
    }
    if faults.count() == before && because.is_none() && readings.iter().any(|r| !r.holds) {
        object.missing("because", "why it does not hold in every reading", faults);
    }
    (faults.count() == before).then_some(Claim {
        id: id?,
        place: place_in_paper?,
        statement: statement?,
        quantity: quantity?,
        readings,
        because,
    })
}

/// Whether a text is an id, which is a heading of the page and the address of a link.
fn is_id(text: &str) -> bool {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    !text.is_empty() && text.chars().all(plain)
}

/// A text of the page, which is Markdown: without HTML, which a browser would run.
fn markdown(node: &Node, path: &str, faults: &mut Faults) -> Option<String> {
    let text = text(node, path, faults)?;
    let opens =
        |after: &str| after.starts_with(|c: char| c.is_ascii_alphabetic() || "/!?".contains(c));
    let html = text
        .match_indices('<')
        .any(|(at, _)| opens(&text[at + 1..]));
    if html {
        let message = "must not contain HTML; put a blank after <";
        faults.add(node.at, path, format!("{message}, got {}", quoted(&text)));
        return None;
    }
    Some(text)
}

fn reading(
    node: &Node,
    path: &str,
    faults: &mut Faults,
    study: &dyn Fn(&Node, &str, &mut Faults) -> Option<usize>,
    scope: &dyn Fn(usize) -> (Scope, Vec<String>, Vec<usize>),
) -> Option<Reading> {
    let before = faults.count();
    let object = Object::of_keys(node, path, &READING, faults)?;
    let assumed = object
        .need("reading", "what is assumed", faults)
        .and_then(|node| markdown(node, &object.path("reading"), faults));
    let holds = match object.need("holds", "the recorded verdict", faults) {
        Some(Node {
            tree: Tree::Bool(holds),
            ..
        }) => Some(*holds),
        Some(node) => {
            faults.must_be(node, &object.path("holds"), "true or false");
            None
        }
        None => None,
    };
    let at = object
        .need("study", "the study that decides", faults)
        .and_then(|node| study(node, &object.path("study"), faults))?;
    let (scope, figures, columns) = scope(at);
    let figure = object.get("figure").and_then(|node| {
        let names: Vec<&str> = figures.iter().map(String::as_str).collect();
        let row = name(node, &object.path("figure"), "figure", &names, faults)?;
        Some(figures[row].clone())
    });
    let expect = object.items("expect", faults, |node, path, faults| {
        expect(node, path, &scope, &columns, faults)
    });
    if faults.count() == before && expect.is_empty() {
        object.missing("expect", "at least one expectation", faults);
    }
    let near_node = object.get("near");
    let near = near_node.and_then(|node| text(node, &object.path("near"), faults));
    (faults.count() == before).then_some(Reading {
        name: assumed?,
        study: at,
        figure,
        expect,
        holds: holds?,
        near,
    })
}
