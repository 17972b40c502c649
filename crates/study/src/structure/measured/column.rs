//! Columns of measurements: their names and units.

use super::super::keys::COLUMN;
use crate::source::faults::{Faults, quoted};
use crate::source::tree::{Node, Tree};
use crate::structure::reading::reader::open;
use crate::value::text;
use slipgap_problem::problem::numbers::unit::Dimension;
use slipgap_problem::problem::structure::metrics::unit_consistency::{dimension_of, examples};
use slipgap_problem::problem::structure::metrics::unit_names::UnitNames;

/// A column of a file.
pub(in crate::structure) struct Column<'a> {
    /// Its name in the file.
    pub name: String,
    /// Its unit in that of the study.
    pub factor: f64,
    /// Its place in the study.
    pub place: (&'a Node, String),
}

/// A column of a quantity of this dimension: its name, or an object with its unit.
pub(in crate::structure) fn column<'a>(
    node: &'a Node,
    path: String,
    dimension: Dimension,
    units: &str,
    faults: &mut Faults,
) -> Option<Column<'a>> {
    let Tree::Object(_) = &node.tree else {
        if !matches!(node.tree, Tree::Text(_)) {
            let wanted = "the name of a column, or an object with column and unit";
            faults.must_be(node, &path, wanted);
            return None;
        }
        return Some(Column {
            name: text(node, &path, faults)?,
            factor: 1.0,
            place: (node, path),
        });
    };
    let object = open(node, &path, COLUMN, faults)?;
    let (key, meaning) = COLUMN[0];
    let name_node = object.need(key, meaning, faults)?;
    let origin = (name_node, object.path(key));
    let name = text(name_node, &origin.1, faults)?;
    let factor = match object.get("unit") {
        Some(node) => factor(node, &object.path("unit"), dimension, units, faults)?,
        None => 1.0,
    };
    Some(Column {
        name,
        factor,
        place: origin,
    })
}

/// A unit in that of the study.
fn factor(
    node: &Node,
    path: &str,
    dimension: Dimension,
    units: &str,
    faults: &mut Faults,
) -> Option<f64> {
    let unit = text(node, path, faults)?;
    let shown = quoted(&unit);
    let what = dimension.in_words();
    let message = match dimension_of(&unit) {
        Some(found) if found == dimension => match UnitNames::of(units) {
            Some(study) => match study.factor(&unit, dimension) {
                Some(factor) => return Some(factor),
                None => format!(
                    "the study's unit of {what}, {}, is not known; leave out the unit, with the column in that of the study",
                    quoted(&study.of_dimension(dimension))
                ),
            },
            None => "needs \"units\" in \"structure\", as in \"t, kN, m, s\"".to_owned(),
        },
        Some(found) => format!(
            "must be a unit of {what}, got {shown}, one of {}; allowed: {}",
            found.in_words(),
            examples(dimension)
        ),
        None => format!(
            "unknown unit {shown} of {what}; allowed: {}",
            examples(dimension)
        ),
    };
    faults.add(node.at, path, message);
    None
}
