//! Which cases a filter selects, and the values of a parameter among them.

use super::block::Block;
use super::filter::Filter;
use crate::axis::group::AxisGroup;
use slipgap_problem::problem::Problem;
use slipgap_problem::problem::numbers::parameter::Value;
use std::collections::HashSet;

/// What a filter or a range selects, one after the other. Behind a pointer, so that its code is that of this crate, which is optimised.
pub type Selected<'a, T> = Box<dyn Iterator<Item = T> + 'a>;

impl Block {
    /// The cases that `filter` selects, as combination and case number of the block, in rising order. The filter is applied
    /// to the axes before cases are made.
    pub fn select<'a>(
        &'a self,
        problem: &'a dyn Problem,
        filter: &'a Filter,
    ) -> Selected<'a, (u64, u64)> {
        self.select_among(u64::MAX, problem, filter)
    }

    /// The same among the first `most` combinations that the filtered axes give.
    pub fn select_among<'a>(
        &'a self,
        most: u64,
        problem: &'a dyn Problem,
        filter: &'a Filter,
    ) -> Selected<'a, (u64, u64)> {
        let positions: Vec<Vec<u64>> = self
            .groups
            .iter()
            .map(|group| group.positions(filter))
            .collect();
        let on_axis = |row: usize| self.axes().any(|axis| axis.parameter == row);
        let only_axes = filter.0.iter().all(|(row, _)| on_axis(*row));
        let count: u64 = positions.iter().map(|p| p.len() as u64).product();
        let combinations = (0..count.min(most)).map(move |number| {
            let (mut rest, mut raw, mut stride) = (number, 0, 1);
            for (group, positions) in self.groups.iter().zip(&positions).rev() {
                let len = positions.len() as u64;
                raw += stride * positions[(rest % len) as usize];
                stride *= group.len();
                rest /= len;
            }
            raw
        });
        let selected = combinations.filter(move |raw| {
            self.is_case(problem, *raw)
                && (only_axes || filter.matches(&self.completed(problem, *raw)))
        });
        // Case numbers rise with combinations. Each is counted from the previous one.
        let (mut last, mut number) = (0, 0);
        Box::new(selected.map(move |raw| {
            if self.when.is_none() || self.is_uncounted() {
                return (raw, raw);
            }
            number = if raw - last > 4096 {
                self.rank(problem, raw)
            } else {
                number + (last..raw).filter(|r| self.is_case(problem, *r)).count() as u64
            };
            last = raw;
            (raw, number)
        }))
    }

    /// Number of combinations that `select` tests.
    pub fn candidates(&self, filter: &Filter) -> u64 {
        let groups = self.groups.iter();
        groups
            .map(|group| group.positions(filter).len() as u64)
            .product()
    }

    /// The different values of a parameter among the cases that `filter` selects; none if the parameter does not apply, or
    /// if the problem computes it from others.
    pub fn levels(&self, problem: &dyn Problem, filter: &Filter, parameter: usize) -> Vec<Value> {
        let on_axis = |group: &&AxisGroup| group.len() > 1 && group.has(parameter);
        let group = self.groups.iter().find(on_axis);
        let derived = self.derived.iter().any(|d| d.parameter == parameter);
        let mut raws = self.select(problem, filter).map(|(raw, _)| raw);
        let value = |raw: u64| self.raw_case(problem, raw).values[parameter];
        let Some(group) = group else {
            return match derived {
                true => distinct(raws.filter_map(value)),
                false => raws.next().and_then(value).into_iter().collect(),
            };
        };
        if self.when.is_some() {
            return distinct(raws.filter_map(value));
        }
        if raws.next().is_none() {
            return Vec::new();
        }
        let positions = group.positions(filter);
        let axis = group.axes.iter().find(|axis| axis.parameter == parameter);
        let values = axis.map(|axis| &axis.values);
        distinct(
            positions
                .iter()
                .filter_map(|i| Some(values?.at(*i as usize))),
        )
    }

    /// Whether the parameters in `from` decide a parameter among the cases that a filter selects: it advances together with one
    /// of them, or has an expression of them and of values that the filter fixes.
    pub fn follows(&self, filter: &Filter, parameter: usize, from: &[usize]) -> bool {
        let decided = |group: &AxisGroup| {
            group.positions(filter).len() == 1 || from.iter().any(|row| group.has(*row))
        };
        let mut groups = self.groups.iter();
        match self.derived.iter().find(|d| d.parameter == parameter) {
            Some(derived) => {
                let mut on = derived.formula.on.iter();
                on.all(|group| decided(&self.groups[*group]))
            }
            None => groups.any(|group| group.has(parameter) && decided(group)),
        }
    }

    /// Whether the block gives a parameter, as a value, a list, a rule or an expression.
    pub fn gives(&self, parameter: usize) -> bool {
        self.axes().any(|axis| axis.parameter == parameter)
            || self.derived.iter().any(|d| d.parameter == parameter)
    }
}

/// The values in their order, without repetitions.
pub(crate) fn distinct(values: impl Iterator<Item = Value>) -> Vec<Value> {
    let mut seen = HashSet::new();
    values
        .filter(|value| seen.insert(value.identity()))
        .collect()
}
