//! The values under the keys of a figure, decoded by the types in the table of `kinds`.

use super::choice::{Each, Fit, Marks, Ridge};
use super::extent;
use super::keys::{EACH, FITS, Key, ORDINATES, RIDGES, SCALES, Takes};
use super::values::DecodedValue;
use crate::faults::Faults;
use crate::object::Object;
use crate::scope::{Scope, names};
use crate::tree::{Node, Tree};
use crate::units::NEEDS_UNITS;
use crate::value::{name, number, text};
use crate::{ColumnRef, Scale};
use slipgap_problem::problem::numbers::parameter::{self, Range};

/// Longest file name of a figure, well within the limits of file systems with an extension.
const LONGEST_NAME: usize = 100;

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
            let scales = [Scale::Linear, Scale::Log];
            return name(node, path, "scale", &SCALES, faults)
                .map(|row| DecodedValue::Scale(scales[row]));
        }
        Takes::Ridge => {
            let ridges = [Ridge::Least, Ridge::Greatest, Ridge::NearestToOne];
            return name(node, path, "ridge", &RIDGES, faults)
                .map(|row| DecodedValue::Ridge(ridges[row]));
        }
        Takes::Fit => {
            return name(node, path, "fit", &FITS, faults)
                .map(|row| DecodedValue::Fit(Fit::ALL[row]));
        }
        Takes::Each => {
            return name(node, path, "value", &EACH, faults)
                .map(|row| DecodedValue::Each(Each::ALL[row]));
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
        Takes::Column | Takes::Columns => {
            let numeric =
                |row: &usize| !matches!(parameters[*row].kind, parameter::Kind::Choice(_));
            let rows: Vec<usize> = (0..parameters.len()).filter(numeric).collect();
            let named = rows.iter().map(|row| &*parameters[*row].name);
            let offered: Vec<&str> = named.chain(scope.metrics()).collect();
            let what = "parameter or metric";
            let places = match key.takes == Takes::Columns {
                true => names(node, path, what, &offered, faults)?,
                false => vec![name(node, path, what, &offered, faults)?],
            };
            let column = |index: &usize| match rows.get(*index) {
                Some(row) => ColumnRef::Parameter(*row),
                None => ColumnRef::Metric(*index - rows.len()),
            };
            return Some(DecodedValue::Columns(places.iter().map(column).collect()));
        }
        Takes::Quantity => {
            name(node, path, "quantity", &quantities(scope), faults).map(|row| vec![row])
        }
        Takes::Quantities => names(node, path, "quantity", &quantities(scope), faults),
        Takes::Ordinates => {
            let ordinates = ORDINATES.map(|ordinate| ordinate.0);
            names(node, path, "ordinate", &ordinates, faults)
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
            let budgets: Vec<&str> = scope
                .problem
                .schema()
                .budgets
                .iter()
                .map(|b| &*b.name)
                .collect();
            names(node, path, "budget", &budgets, faults)
        }
        Takes::Switch => {
            let Tree::Bool(on) = node.tree else {
                faults.must_be(node, path, "true or false");
                return None;
            };
            return Some(DecodedValue::Switch(on));
        }
        Takes::Marks => return marks(node, path, faults).map(DecodedValue::Marks),
        Takes::Hazard => return hazard(node, path, faults).map(DecodedValue::Points),
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
    let quantities = scope.problem.schema().quantities.iter();
    quantities.map(|quantity| &*quantity.name).collect()
}

fn ratios(node: &Node, path: &str, faults: &mut Faults) -> Option<Vec<f64>> {
    let what = "a damping ratio or a non-empty list of ratios";
    let ratios = numbers(node, path, what, faults)?;
    let Some(i) = ratios.iter().position(|ratio| *ratio >= 1.0) else {
        return Some(ratios);
    };
    let (at, path) = match &node.tree {
        Tree::List(items) => (items[i].at, format!("{path}[{i}]")),
        Tree::Object(_) | Tree::Text(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => {
            (node.at, path.to_owned())
        }
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
        pair(node, path, "a place [x, y]", Range::Any, faults)
    });
    object.need("at", MARKS[1].1, faults)?;
    (faults.count() == before).then_some(Marks { label: label?, at })
}

/// Points of a hazard curve: values rise, and their annual frequencies fall.
fn hazard(node: &Node, path: &str, faults: &mut Faults) -> Option<Vec<[f64; 2]>> {
    let what = "a list of at least two points [x, annual frequency]";
    let Tree::List(items) = &node.tree else {
        faults.must_be(node, path, what);
        return None;
    };
    if items.len() < 2 {
        faults.must_be(node, path, what);
        return None;
    }
    let item_path = |i: usize| format!("{path}[{i}]");
    let point = |(i, item): (usize, &Node)| {
        pair(
            item,
            &item_path(i),
            "a point [x, annual frequency]",
            Range::Positive,
            faults,
        )
    };
    // Collected first, so that every faulty number is reported.
    let read: Vec<Option<[f64; 2]>> = items.iter().enumerate().map(point).collect();
    let points = read.into_iter().collect::<Option<Vec<[f64; 2]>>>()?;
    let wrong = |pair: &[[f64; 2]]| pair[1][0] <= pair[0][0] || pair[1][1] >= pair[0][1];
    if let Some(i) = points.windows(2).position(wrong) {
        let message = "must have a larger x and a smaller frequency than the point before";
        faults.add(items[i + 1].at, &item_path(i + 1), message);
        return None;
    }
    Some(points)
}

/// A list of two numbers; `what` is allowed.
fn pair(
    node: &Node,
    path: &str,
    what: &str,
    range: Range,
    faults: &mut Faults,
) -> Option<[f64; 2]> {
    let Tree::List(items) = &node.tree else {
        faults.must_be(node, path, what);
        return None;
    };
    let [x, y] = items.as_slice() else {
        faults.must_be(node, path, what);
        return None;
    };
    let mut one = |node, i| number(node, &format!("{path}[{i}]"), range, faults);
    let (x, y) = (one(x, 0), one(y, 1));
    Some([x?, y?])
}
