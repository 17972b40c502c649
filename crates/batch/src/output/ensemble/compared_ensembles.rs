//! Which ensembles are compared: those that differ in the value of one parameter, all else equal.

use super::EnsembleMetrics;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_study::alike;
use std::cmp::Ordering;

/// Most values of a parameter that are all compared with each other. Of more, neighbours are compared.
const MOST_VALUES: usize = 10;

/// Two ensembles to compare.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Pair {
    /// The place of the parameter in `outside`.
    pub place: usize,
    /// Both ensembles.
    pub ensembles: [usize; 2],
}

impl EnsembleMetrics<'_> {
    /// The pairs of ensembles, parameter by parameter. Parameters that change together are compared once, under the name of
    /// the first.
    pub(super) fn pairs(&self) -> Vec<Pair> {
        let mut before: Vec<Vec<usize>> = Vec::new();
        let mut pairs = Vec::new();
        for column in self.varying() {
            let equal = self.equal_beside(column);
            if !before.contains(&equal) {
                pairs.extend(self.pairs_of(column, &equal));
                before.push(equal);
            }
        }
        pairs
    }

    /// The places of the parameters that must be equal where ensembles are compared by the parameter at `place`: not those
    /// that change with it, nor those that apply only to some of its names.
    fn equal_beside(&self, column: usize) -> Vec<usize> {
        let table = self.study.problem.parameters();
        let parameter = &table[self.outside[column]].name;
        let others = self.study.outside_ensemble(&[self.outside[column]]);
        let depends = |row: usize| {
            let applies = table[row].applies.as_ref();
            applies.is_some_and(|on| on.governor == parameter)
        };
        let equal = |other: &usize| {
            let row = self.outside[*other];
            others.contains(&row) && !depends(row)
        };
        (0..self.outside.len()).filter(equal).collect()
    }

    fn pairs_of(&self, index: usize, equal: &[usize]) -> Vec<Pair> {
        let value = |ensemble: usize| self.ensembles[ensemble][index];
        let given = (0..self.ensembles.len()).filter(|ensemble| value(*ensemble).is_some());
        let classes = alike::grouped(given, |ensemble| {
            let values = equal.iter().map(|other| self.ensembles[*ensemble][*other]);
            let identity = values.map(|value| value.map(Value::identity));
            identity.collect::<alike::Identity>()
        });
        let mut pairs = Vec::new();
        for mut class in classes {
            class.sort_by(|a, b| by_size(value(*a), value(*b)));
            for (i, a) in class.iter().enumerate() {
                let others = match class.len() <= MOST_VALUES {
                    true => &class[i + 1..],
                    false => &class[i + 1..(i + 2).min(class.len())],
                };
                let different = others
                    .iter()
                    .filter(|b| !Value::identical(value(*a), value(**b)));
                pairs.extend(different.map(|b| Pair {
                    place: index,
                    ensembles: [*a, *b],
                }));
            }
        }
        pairs
    }
}

/// Numbers by size; names stay in their order.
fn by_size(a: Option<Value>, b: Option<Value>) -> Ordering {
    let [a, b] = [a, b].map(|value| value.and_then(|value| value.as_f64()));
    match (a, b) {
        (Some(a), Some(b)) => a.total_cmp(&b),
        (None, _) | (_, None) => Ordering::Equal,
    }
}
