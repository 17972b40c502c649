//! A parameter along an axis: whether its values can lie there.

use super::taken::Values;
use crate::problem::parameter::{Default, Value, shortest};
use crate::study::report::{Faults, join};
use crate::study::scope::Scope;
use crate::study::{Figure, Scale};

/// A parameter in its part in a figure.
pub(super) struct Axis {
    pub key: &'static str,
    pub row: usize,
}

impl Axis {
    /// Reports a parameter that none of the chosen cases has.
    pub fn has_values(&self, figure: &Figure, values: &Values, scope: &Scope, faults: &mut Faults) {
        let parameter = &scope.problem.parameters()[self.row];
        let known = !matches!(parameter.default, Default::Follows(_));
        if known && scope.levels(&figure.filter, self.row).is_empty() {
            let path = join(values.path, self.key);
            let message = format!("{} applies to none of the cases shown", parameter.name);
            faults.add(values.at(self.key), &path, message);
        }
    }

    /// Reports a logarithmic scale for numbers that have no logarithm.
    pub fn fits(
        &self,
        scale: Scale,
        figure: &Figure,
        values: &Values,
        scope: &Scope,
        faults: &mut Faults,
    ) {
        let levels = scope.levels(&figure.filter, self.row);
        let mut numbers = levels.iter().filter_map(|level| level.as_f64());
        if scale == Scale::Log
            && let Some(bad) = numbers.find(|x| *x <= 0.0)
        {
            let key = format!("{}_scale", self.key);
            let name = &scope.problem.parameters()[self.row].name;
            let bad = Value::Number(bad);
            let message =
                format!("a log scale needs numbers > 0, but {name} is {bad} in a case shown");
            faults.add(values.at(&key), &join(values.path, &key), message);
        }
    }

    /// Reports a mark beyond the values of its axis.
    pub fn reaches(
        &self,
        place: f64,
        mark: usize,
        figure: &Figure,
        values: &Values,
        scope: &Scope,
        faults: &mut Faults,
    ) {
        let levels = scope.levels(&figure.filter, self.row);
        let numbers = levels.iter().filter_map(|level| level.as_f64());
        let (low, high) = numbers.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| {
            (a.min(x), b.max(x))
        });
        let slack = 1e-12 * place.abs();
        if low <= high && !(place >= low - slack && place <= high + slack) {
            let name = &scope.problem.parameters()[self.row].name;
            let (low, high, place) = (shortest(low), shortest(high), shortest(place));
            let message =
                format!("{name} of mark {mark} must lie within {low}..{high}, got {place}");
            faults.add(values.at("marks"), &join(values.path, "marks"), message);
        }
    }
}
