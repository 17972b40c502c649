//! The checks of the figures that show reductions.

use super::checker::Checker;
use super::keys::{Key, Takes};
use super::reduced::KINDS;
use super::values::Values;
use crate::ColumnRef;
use crate::Reduction;
use crate::faults::quoted;

/// Reports reductions that a figure of `kind` with these keys cannot show, and other metrics next to them. It returns one of
/// the reductions, if there are any.
pub(super) fn check<'a>(
    kind: &str,
    keys: &'static [Key],
    checker: &mut Checker<'a>,
) -> Option<&'a Reduction> {
    let scope = checker.scope;
    let taken = metrics(keys, checker.values);
    let first = taken.iter().find_map(|(key, i, row)| {
        let measure = &scope.measures[*row];
        Some((*key, *i, &measure.name, measure.reduction.as_ref()?))
    });
    let (key, i, name, reduction) = first?;
    if !KINDS.contains(&kind) {
        let kinds = KINDS.join(", ");
        let message = format!(
            "{} is a reduction; kinds that show them: {kinds}",
            quoted(name)
        );
        checker.fault_of_item(key, i, message);
        return Some(reduction);
    }
    for (key, i, row) in taken {
        let other = &scope.measures[row];
        let plain_name = &other.name;
        let message = match &other.reduction {
            // Faults of their own.
            Some(other) if other.over.is_empty() || reduction.over.is_empty() => continue,
            Some(other) if other.groups_like(reduction) => continue,
            Some(_) => format!(
                "{} and {} are over different parameters; a figure needs reductions over the same ones",
                quoted(plain_name),
                quoted(name)
            ),
            None => format!(
                "{plain_name} is not reduced, but {} is; a figure shows reductions only, or none",
                quoted(name)
            ),
        };
        checker.fault_of_item(key, i, message);
    }
    if checker.values.has("mean_over") {
        let message = "a figure of reductions has no further means; reduce both metrics over this parameter, too";
        checker.fault("mean_over", message);
    }
    Some(reduction)
}

/// The metrics under the keys of a figure: key, place in its list, and row of the measures.
fn metrics(keys: &'static [Key], values: &Values) -> Vec<(&'static str, usize, usize)> {
    let mut found = Vec::new();
    for key in keys {
        match key.takes {
            Takes::Metric | Takes::Metrics => {
                let rows = values.rows(key.name).unwrap_or_default();
                found.extend(rows.iter().enumerate().map(|(i, row)| (key.name, i, *row)));
            }
            Takes::Column | Takes::Columns => {
                for (i, column) in values.columns(key.name).into_iter().enumerate() {
                    if let ColumnRef::Metric(row) = column {
                        found.push((key.name, i, row));
                    }
                }
            }
            Takes::FileName
            | Takes::Kind
            | Takes::Text
            | Takes::Filter
            | Takes::Parameter
            | Takes::Parameters
            | Takes::NumericParameter
            | Takes::Quantity
            | Takes::Quantities
            | Takes::Profile
            | Takes::Profiles
            | Takes::Times
            | Takes::Budgets
            | Takes::Width
            | Takes::Range
            | Takes::Marks
            | Takes::Scale
            | Takes::ScaleOrLog
            | Takes::Ridge
            | Takes::Fit
            | Takes::Each
            | Takes::InUnits
            | Takes::Switch
            | Takes::Ordinates
            | Takes::Ratios
            | Takes::Periods
            | Takes::Number
            | Takes::Probabilities
            | Takes::Hazard => {}
        }
    }
    found
}
