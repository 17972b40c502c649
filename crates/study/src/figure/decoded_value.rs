//! The values under the keys of a figure, decoded by the types in the table of `kinds`.

use super::choice::{Fit, Marks, Ridge};
use super::extent;
use super::keys::{FITS, Key, ORDINATES, RIDGES, SCALES, Takes};
use crate::faults::{Faults, join};
use crate::object::Object;
use crate::scope::{Scope, names};
use crate::tree::{Node, Tree};
use crate::units::NEEDS_UNITS;
use crate::value::{name, number, text};
use crate::{ColumnRef, Filter, Scale};
use slipgap_solver::problem::parameter::{self, Range};

/// Longest file name of a figure, well within the limits of file systems with an extension.
const LONGEST_NAME: usize = 100;

/// The decoded value of one key.
pub(crate) enum DecodedValue {
    Text(String),
    Filter(Filter),
    Rows(Vec<usize>),
    Column(ColumnRef),
    Numbers(Vec<f64>),
    Width(f64),
    Range([f64; 2]),
    Scale(Scale),
    Ridge(Ridge),
    Fit(Fit),
    Marks(Marks),
    Switch(bool),
}

/// The decoded values of one figure, by key.
pub(crate) struct Values<'a> {
    pub node: &'a Node,
    pub path: &'a str,
    pub taken: Vec<(&'static str, &'a Node, DecodedValue)>,
}

impl Values<'_> {
    pub fn text(&self, key: &str) -> Option<String> {
        match self.get(key)? {
            DecodedValue::Text(text) => Some(text.clone()),
            _ => None,
        }
    }

    pub fn rows(&self, key: &str) -> Option<Vec<usize>> {
        match self.get(key)? {
            DecodedValue::Rows(rows) => Some(rows.clone()),
            _ => None,
        }
    }

    pub fn row(&self, key: &str) -> Option<usize> {
        self.rows(key)?.first().copied()
    }

    pub fn column(&self, key: &str) -> Option<ColumnRef> {
        match self.get(key)? {
            DecodedValue::Column(column) => Some(*column),
            _ => None,
        }
    }

    pub fn scale(&self, key: &str) -> Scale {
        self.scale_or(key, Scale::Linear)
    }

    pub fn scale_or(&self, key: &str, left_out: Scale) -> Scale {
        match self.get(key) {
            Some(DecodedValue::Scale(scale)) => *scale,
            _ => left_out,
        }
    }

    pub fn ridge(&self, key: &str) -> Option<Ridge> {
        match self.get(key)? {
            DecodedValue::Ridge(ridge) => Some(*ridge),
            _ => None,
        }
    }

    pub fn fit(&self, key: &str) -> Fit {
        match self.get(key) {
            Some(DecodedValue::Fit(fit)) => *fit,
            _ => Fit::default(),
        }
    }

    pub fn marks(&self, key: &str) -> Option<Marks> {
        match self.get(key)? {
            DecodedValue::Marks(marks) => Some(marks.clone()),
            _ => None,
        }
    }

    pub fn switch(&self, key: &str) -> bool {
        self.given_switch(key) == Some(true)
    }

    /// `None` if the key is not given, or has another meaning for the kind.
    pub fn given_switch(&self, key: &str) -> Option<bool> {
        match self.get(key)? {
            DecodedValue::Switch(on) => Some(*on),
            _ => None,
        }
    }

    /// Times or ratios; none if the key is not given.
    pub fn numbers(&self, key: &str) -> Vec<f64> {
        match self.get(key) {
            Some(DecodedValue::Numbers(numbers)) => numbers.clone(),
            _ => Vec::new(),
        }
    }

    pub fn width(&self, key: &str) -> Option<f64> {
        match self.get(key)? {
            DecodedValue::Width(width) => Some(*width),
            _ => None,
        }
    }

    pub fn range(&self, key: &str) -> Option<[f64; 2]> {
        match self.get(key)? {
            DecodedValue::Range(range) => Some(*range),
            _ => None,
        }
    }

    pub fn filter(&self) -> Filter {
        match self.get("where") {
            Some(DecodedValue::Filter(filter)) => filter.clone(),
            _ => Filter::default(),
        }
    }

    fn get(&self, key: &str) -> Option<&DecodedValue> {
        let found = self.taken.iter().find(|taken| taken.0 == key);
        found.map(|taken| &taken.2)
    }

    /// Whether the figure has `key`.
    pub fn has(&self, key: &str) -> bool {
        self.get(key).is_some()
    }

    /// The offset of the value of `key`; of the figure, if the key is not given.
    pub fn at(&self, key: &str) -> usize {
        let found = self.taken.iter().find(|taken| taken.0 == key);
        found.map_or(self.node.at, |taken| taken.1.at)
    }

    /// The offset and path of item `i` of the value of `key`, which may be given without a list.
    pub fn item(&self, key: &str, i: usize) -> (usize, String) {
        let path = join(self.path, key);
        let found = self.taken.iter().find(|taken| taken.0 == key);
        match found.map(|taken| &taken.1.tree) {
            Some(Tree::List(items)) if i < items.len() => (items[i].at, format!("{path}[{i}]")),
            _ => (self.at(key), path),
        }
    }
}

/// Decodes the value of one key.
pub(crate) fn take(
    key: &Key,
    node: &Node,
    path: &str,
    scope: &Scope,
    faults: &mut Faults,
) -> Option<DecodedValue> {
    let parameters = scope.problem.parameters();
    let rows = match key.takes {
        Takes::FileName => {
            let name = text(node, path, faults)?;
            let plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
            let fits = (1..=LONGEST_NAME).contains(&name.len());
            if fits && name.chars().all(plain) && !name.starts_with('-') {
                return Some(DecodedValue::Text(name));
            }
            let what =
                format!("1 to {LONGEST_NAME} letters, digits, _ and -, not beginning with -");
            faults.must_be(node, path, &what);
            return None;
        }
        Takes::Text | Takes::Kind => return text(node, path, faults).map(DecodedValue::Text),
        Takes::Filter => return scope.filter(node, path, faults).map(DecodedValue::Filter),
        Takes::Times => {
            let what = "a time or a non-empty list of times";
            return numbers(node, path, what, faults).map(DecodedValue::Numbers);
        }
        Takes::Width => return extent::width(node, path, faults).map(DecodedValue::Width),
        Takes::Range | Takes::Periods => {
            return extent::range(node, path, faults).map(DecodedValue::Range);
        }
        Takes::Scale | Takes::ScaleOrLog => {
            let all = [Scale::Linear, Scale::Log];
            return name(node, path, "scale", &SCALES, faults)
                .map(|row| DecodedValue::Scale(all[row]));
        }
        Takes::Ridge => {
            let all = [Ridge::Least, Ridge::Greatest, Ridge::NearestToOne];
            return name(node, path, "ridge", &RIDGES, faults)
                .map(|row| DecodedValue::Ridge(all[row]));
        }
        Takes::Fit => {
            return name(node, path, "fit", &FITS, faults)
                .map(|row| DecodedValue::Fit(Fit::ALL[row]));
        }
        Takes::Parameter => {
            name(node, path, "parameter", &scope.parameters(), faults).map(|row| vec![row])
        }
        Takes::Parameters => names(node, path, "parameter", &scope.parameters(), faults),
        Takes::NumericParameter => {
            let row = name(node, path, "parameter", &scope.parameters(), faults)?;
            if matches!(parameters[row].kind, parameter::Kind::Choice(_)) {
                faults.must_be(node, path, "a parameter that is a number");
                return None;
            }
            Some(vec![row])
        }
        Takes::Column => {
            let numeric =
                |row: &usize| !matches!(parameters[*row].kind, parameter::Kind::Choice(_));
            let rows: Vec<usize> = (0..parameters.len()).filter(numeric).collect();
            let named = rows.iter().map(|row| &*parameters[*row].name);
            let all: Vec<&str> = named.chain(scope.metrics()).collect();
            let place = name(node, path, "parameter or metric", &all, faults)?;
            return Some(DecodedValue::Column(match rows.get(place) {
                Some(row) => ColumnRef::Parameter(*row),
                None => ColumnRef::Metric(place - rows.len()),
            }));
        }
        Takes::Quantity => {
            name(node, path, "quantity", &quantities(scope), faults).map(|row| vec![row])
        }
        Takes::Quantities => names(node, path, "quantity", &quantities(scope), faults),
        Takes::Ordinates => {
            let all = ORDINATES.map(|ordinate| ordinate.0);
            names(node, path, "ordinate", &all, faults)
        }
        Takes::Number => {
            return number(node, path, Range::Any, faults).map(|x| DecodedValue::Numbers(vec![x]));
        }
        Takes::Probabilities => {
            let [low, high] = extent::range(node, path, faults)?;
            if low < 0.0 || high > 1.0 {
                let (low, high) = (parameter::shortest(low), parameter::shortest(high));
                let message =
                    format!("must be two probabilities from 0 to 1, got {low} and {high}");
                faults.add(node.at, path, message);
                return None;
            }
            return Some(DecodedValue::Range([low, high]));
        }
        Takes::Ratios => return ratios(node, path, faults).map(DecodedValue::Numbers),
        Takes::Profile => {
            name(node, path, "profile", &scope.profiles(), faults).map(|row| vec![row])
        }
        Takes::Profiles => names(node, path, "profile", &scope.profiles(), faults),
        Takes::Budgets => {
            let all: Vec<&str> = scope
                .problem
                .schema()
                .budgets
                .iter()
                .map(|b| &*b.name)
                .collect();
            names(node, path, "budget", &all, faults)
        }
        Takes::Switch => {
            let Tree::Bool(on) = node.tree else {
                faults.must_be(node, path, "true or false");
                return None;
            };
            return Some(DecodedValue::Switch(on));
        }
        Takes::Marks => return marks(node, path, faults).map(DecodedValue::Marks),
        Takes::InUnits => {
            let Tree::Bool(on) = node.tree else {
                faults.must_be(node, path, "true or false");
                return None;
            };
            if on && !scope.has_units() {
                faults.add(node.at, path, NEEDS_UNITS);
            }
            return Some(DecodedValue::Switch(on));
        }
        Takes::Metric => name(node, path, "metric", &scope.metrics(), faults).map(|row| vec![row]),
        Takes::Metrics => names(node, path, "metric", &scope.metrics(), faults),
    };
    rows.map(DecodedValue::Rows)
}

/// Names of the problem's quantities over time.
fn quantities(scope: &Scope) -> Vec<&str> {
    let all = scope.problem.schema().quantities.iter();
    all.map(|quantity| &*quantity.name).collect()
}

fn ratios(node: &Node, path: &str, faults: &mut Faults) -> Option<Vec<f64>> {
    let what = "a damping ratio or a non-empty list of ratios";
    let ratios = numbers(node, path, what, faults)?;
    let Some(i) = ratios.iter().position(|ratio| *ratio >= 1.0) else {
        return Some(ratios);
    };
    let (at, path) = match &node.tree {
        Tree::List(items) => (items[i].at, format!("{path}[{i}]")),
        _ => (node.at, path.to_owned()),
    };
    let ratio = parameter::shortest(ratios[i]);
    faults.add(at, &path, format!("must be less than 1, got {ratio}"));
    None
}

/// One or several numbers that are not negative; `what` is allowed.
fn numbers(node: &Node, path: &str, what: &str, faults: &mut Faults) -> Option<Vec<f64>> {
    let Tree::List(items) = &node.tree else {
        return number(node, path, Range::NotNegative, faults).map(|one| vec![one]);
    };
    if items.is_empty() {
        faults.must_be(node, path, what);
        return None;
    }
    let numbers = items.iter().enumerate().map(|(i, item)| {
        let path = format!("{path}[{i}]");
        number(item, &path, Range::NotNegative, faults)
    });
    // Collected first, so that every faulty number is reported.
    let numbers: Vec<Option<f64>> = numbers.collect();
    numbers.into_iter().collect()
}

/// The keys of `marks`.
pub(crate) const MARKS: [(&str, &str); 2] = [
    ("label", "text in the legend"),
    ("at", "points, each [x, y]; expressions are allowed"),
];

fn marks(node: &Node, path: &str, faults: &mut Faults) -> Option<Marks> {
    let before = faults.count();
    let object = Object::open(node, path, &MARKS.map(|key| key.0), faults)?;
    let label = object
        .need("label", MARKS[0].1, faults)
        .and_then(|node| text(node, &object.path("label"), faults));
    let at = object.items("at", faults, |node, path, faults| {
        let Tree::List(items) = &node.tree else {
            faults.must_be(node, path, "a place [x, y]");
            return None;
        };
        let [x, y] = items.as_slice() else {
            faults.must_be(node, path, "a place [x, y]");
            return None;
        };
        let mut one = |node, i| number(node, &format!("{path}[{i}]"), Range::Any, faults);
        let (x, y) = (one(x, 0), one(y, 1));
        Some([x?, y?])
    });
    object.need("at", MARKS[1].1, faults)?;
    (faults.count() == before).then_some(Marks { label: label?, at })
}
