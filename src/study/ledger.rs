//! A ledger of claims: sentences of a paper, each with the studies and values that decide whether it holds.

use std::path::{Path, PathBuf};

use super::decode::{self, text_of};
use super::object::Object;
use super::report::{Faults, quoted};
use super::scope::Scope;
use super::tree::{Node, Tree};
use super::value::{name, number, text};
use super::{Filter, Study};
use crate::error::Error;
use crate::problem::parameter::Range;

/// The claims of one paper.
#[derive(Debug)]
pub struct Ledger {
    /// The paper, for the page.
    pub paper: String,
    /// What is claimed, in the paper's order.
    pub claims: Vec<Claim>,
    /// The studies that the readings name.
    pub studies: Vec<Settling>,
}

/// A study that settles claims.
#[derive(Debug)]
pub struct Settling {
    /// Its folder under the output folder, as in `claims/impact-once`.
    pub name: String,
    /// Its file.
    pub file: PathBuf,
    /// The study.
    pub study: Study,
}

/// One sentence.
#[derive(Debug)]
pub struct Claim {
    /// Short name, as in `F4`.
    pub id: String,
    /// Where it stands in the paper.
    pub place: String,
    /// What it says, in our words.
    pub says: String,
    /// What is computed to judge it.
    pub quantity: String,
    /// The readings tried.
    pub readings: Vec<Reading>,
    /// Why it fails or holds only if, or what else there is to say.
    pub because: Option<String>,
}

/// One way to read a sentence.
#[derive(Debug)]
pub struct Reading {
    /// What is assumed.
    pub name: String,
    /// Which of the ledger's studies.
    pub study: usize,
    /// A figure of that study to look at.
    pub figure: Option<String>,
    /// All of these must be so.
    pub expect: Vec<Expect>,
    /// The recorded verdict.
    pub holds: bool,
}

/// One thing that must be so for a reading to hold.
#[derive(Debug)]
pub struct Expect {
    /// What is looked at.
    pub of: Looked,
    /// In which cases.
    pub filter: Filter,
    /// What must be so.
    pub demand: Demand,
}

/// What an expectation looks at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Looked {
    /// Row of `problem.metrics()`.
    Metric(usize),
    /// Row of `problem.profiles()`: the root mean square of its error away from fronts.
    Profile(usize),
}

/// What must be so.
#[derive(Debug, Clone, PartialEq)]
pub enum Demand {
    /// In every case within limits.
    Within {
        /// Smallest value allowed.
        min: Option<f64>,
        /// Largest value allowed.
        max: Option<f64>,
    },
    /// From case to case along a parameter.
    Trend {
        /// Row of `problem.parameters()`.
        along: usize,
        /// Whether it rises, or falls.
        rising: bool,
    },
    /// Least at a value of a parameter within limits.
    LeastAt {
        /// Row of `problem.parameters()`.
        along: usize,
        /// Limits of that value.
        range: [f64; 2],
    },
    /// A profile's error at these times, further than `away` from every front, at most `max`.
    Away {
        /// Times in the problem's unit.
        times: Vec<f64>,
        /// Distance in the profile's unit of place.
        away: f64,
        /// Largest value allowed.
        max: f64,
    },
}

const CLAIM: [&str; 6] = ["id", "where", "says", "quantity", "readings", "because"];
const READING: [&str; 5] = ["reading", "study", "figure", "expect", "holds"];
const EXPECT: [&str; 11] = [
    "metric", "profile", "where", "min", "max", "along", "trend", "least_at", "times", "away", "//",
];

/// Reads a ledger and the studies it names. Faults name the file as `file` does.
///
/// # Errors
/// Every fault of the ledger, or of the first study that has any.
pub fn read(file: &Path) -> Result<Ledger, Error> {
    let shown = file.display().to_string();
    let source = text_of(file)?;
    let root = decode::tree_of(&shown, &source)?;
    let mut faults = Faults::default();
    let ledger = ledger(&root, file, &mut faults)?;
    match ledger {
        Some(ledger) if faults.count() == 0 => Ok(ledger),
        _ => Err(Error::Faults(faults.in_file_order(&shown, &source))),
    }
}

fn ledger(root: &Node, file: &Path, faults: &mut Faults) -> Result<Option<Ledger>, Error> {
    let Some(object) = Object::open(root, "", &["paper", "studies", "claims"], faults) else {
        return Ok(None);
    };
    let mut string = |key: &str, what: &str| {
        let node = object.need(key, what, faults)?;
        text(node, &object.path(key), faults)
    };
    let paper = string("paper", "the paper");
    let folder = string("studies", "the folder of the studies, from here");
    object.need("claims", "a list of claims", faults);
    let folder = file
        .parent()
        .unwrap_or(Path::new(""))
        .join(folder.unwrap_or_default());
    // Studies are read where they are first named.
    let found = std::cell::RefCell::new((Vec::<Settling>::new(), None));
    let study = |node: &Node, path: &str, faults: &mut Faults| {
        let name = text(node, path, faults)?;
        let (studies, failed) = &mut *found.borrow_mut();
        if let Some(at) = studies.iter().position(|s| s.name == name) {
            return Some(at);
        }
        let file = folder.join(format!("{name}.json"));
        if !file.is_file() {
            let message = format!("no study {}", file.display());
            faults.add(node.at, path, message);
            return None;
        }
        match decode::read(&file) {
            Ok(study) => {
                studies.push(Settling { name, file, study });
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
            problem: study.problem,
            blocks: study.blocks.clone(),
            once: study.once,
        };
        (scope, figures, study.metrics.clone())
    };
    let claims = object.items("claims", faults, |node, path, faults| {
        claim(node, path, faults, &|node, path, faults| {
            reading(node, path, faults, &study, &scope)
        })
    });
    for (i, claim) in claims.iter().enumerate() {
        if claims[..i].iter().any(|first| first.id == claim.id) {
            object.fault(
                format!("two claims are called {}", quoted(&claim.id)),
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

fn claim(
    node: &Node,
    path: &str,
    faults: &mut Faults,
    reading: &dyn Fn(&Node, &str, &mut Faults) -> Option<Reading>,
) -> Option<Claim> {
    let before = faults.count();
    let object = Object::open(node, path, &CLAIM, faults)?;
    let mut string = |key: &str, what: &str| {
        let node = object.need(key, what, faults)?;
        text(node, &object.path(key), faults)
    };
    let id = string("id", "a short name");
    let place = string("where", "where it stands in the paper");
    let says = string("says", "what it says");
    let quantity = string("quantity", "what is computed to judge it");
    let because = object.get("because");
    let because = because.and_then(|node| text(node, &object.path("because"), faults));
    let readings = object.items("readings", faults, reading);
    if faults.count() == before && readings.is_empty() {
        object.missing("readings", "at least one reading", faults);
    }
    if faults.count() == before && because.is_none() && readings.iter().any(|r| !r.holds) {
        object.missing("because", "why it does not hold in every reading", faults);
    }
    (faults.count() == before).then_some(Claim {
        id: id?,
        place: place?,
        says: says?,
        quantity: quantity?,
        readings,
        because,
    })
}

fn reading(
    node: &Node,
    path: &str,
    faults: &mut Faults,
    study: &dyn Fn(&Node, &str, &mut Faults) -> Option<usize>,
    scope: &dyn Fn(usize) -> (Scope, Vec<String>, Vec<usize>),
) -> Option<Reading> {
    let before = faults.count();
    let object = Object::open(node, path, &READING, faults)?;
    let assumed = object
        .need("reading", "what is assumed", faults)
        .and_then(|node| text(node, &object.path("reading"), faults));
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
        .need("study", "the study that settles it", faults)
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
    (faults.count() == before).then_some(Reading {
        name: assumed?,
        study: at,
        figure,
        expect,
        holds: holds?,
    })
}

fn expect(
    node: &Node,
    path: &str,
    scope: &Scope,
    columns: &[usize],
    faults: &mut Faults,
) -> Option<Expect> {
    let before = faults.count();
    let object = Object::open(node, path, &EXPECT, faults)?;
    let filter = match object.get("where") {
        Some(node) => scope.filter(node, &object.path("where"), faults),
        None => Some(Filter::default()),
    };
    let of = match (object.get("metric"), object.get("profile")) {
        (Some(node), None) => {
            let all = scope.metrics();
            let row = name(node, &object.path("metric"), "metric", &all, faults)?;
            if !columns.contains(&row) {
                faults.add(
                    node.at,
                    &object.path("metric"),
                    "the study does not list it",
                );
            }
            Looked::Metric(row)
        }
        (None, Some(node)) => Looked::Profile(name(
            node,
            &object.path("profile"),
            "profile",
            &scope.profiles(),
            faults,
        )?),
        _ => {
            object.fault("takes a \"metric\" or a \"profile\"", faults);
            return None;
        }
    };
    let mut limit = |key: &str| {
        let node = object.get(key)?;
        number(node, &object.path(key), Range::Any, faults)
    };
    let (min, max, away) = (limit("min"), limit("max"), limit("away"));
    let along = object.get("along").and_then(|node| {
        name(
            node,
            &object.path("along"),
            "parameter",
            &scope.parameters(),
            faults,
        )
    });
    let demand = if let Looked::Profile(_) = of {
        let times = object.items("times", faults, |node, path, faults| {
            number(node, path, Range::NotNegative, faults)
        });
        match (away, max) {
            (Some(away), Some(max)) if !times.is_empty() => Demand::Away { times, away, max },
            _ => {
                object.fault("a profile takes \"times\", \"away\" and \"max\"", faults);
                return None;
            }
        }
    } else if let Some(along) = along {
        sequence(&object, along, filter.as_ref()?, scope, faults)?
    } else if min.is_some() || max.is_some() {
        Demand::Within { min, max }
    } else {
        object.fault("takes \"min\", \"max\" or both, or \"along\"", faults);
        return None;
    };
    (faults.count() == before).then_some(Expect {
        of,
        filter: filter?,
        demand,
    })
}

/// What is demanded along a parameter, each of whose values has one case.
fn sequence(
    object: &Object,
    along: usize,
    filter: &Filter,
    scope: &Scope,
    faults: &mut Faults,
) -> Option<Demand> {
    let cases = scope.select(filter).count();
    if cases != scope.levels(filter, along).len() || cases < 2 {
        let name = scope.problem.parameters()[along].name;
        let message = format!("\"along\" takes one case for each {name}; {cases} are chosen");
        object.fault(message, faults);
        return None;
    }
    match (object.get("trend"), object.get("least_at")) {
        (Some(node), None) => {
            let trends = ["rising", "falling"];
            let row = name(node, &object.path("trend"), "trend", &trends, faults)?;
            Some(Demand::Trend {
                along,
                rising: row == 0,
            })
        }
        (None, Some(_)) => {
            let range = object.items("least_at", faults, |node, path, faults| {
                number(node, path, Range::Any, faults)
            });
            match range[..] {
                [a, b] if a <= b => Some(Demand::LeastAt {
                    along,
                    range: [a, b],
                }),
                _ => {
                    object.fault("\"least_at\" takes [from, to]", faults);
                    None
                }
            }
        }
        _ => {
            object.fault("\"along\" takes a \"trend\" or \"least_at\"", faults);
            None
        }
    }
}
