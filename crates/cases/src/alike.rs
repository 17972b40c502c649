//! Cases that differ only in some parameters.

use super::block::Block;
use slipgap_problem::problem::numbers::parameter::{Default, Value};
use slipgap_problem::problem::{Case, Problem};
use std::collections::HashMap;
use std::hash::Hash;

impl Block {
    /// Whether a parameter changes with one of those in `rows`: it advances together with it, or has an expression of it.
    fn changes_with(&self, parameter: usize, rows: &[usize]) -> bool {
        let moved = |group: usize| rows.iter().any(|row| self.groups[group].has(*row));
        let derived = self.derived.iter().find(|d| d.parameter == parameter);
        let on = derived.map_or(&[][..], |derived| &derived.formula.on);
        let mut moved_groups =
            (0..self.groups.len()).filter(|group| self.groups[*group].has(parameter));
        moved_groups.any(moved) || on.iter().any(|group| moved(*group))
    }
}

/// The parameters that cases share if they differ only in those in `rows`: not these, nor what changes with them in a block,
/// nor what the problem computes from other parameters.
pub fn unaffected(problem: &dyn Problem, blocks: &[Block], rows: &[usize]) -> Vec<usize> {
    let table = problem.parameters();
    let given = |row: &usize| {
        !matches!(table[*row].default, Default::Follows(_))
            || blocks.iter().any(|block| block.gives(*row))
    };
    let affected = |row: &usize| {
        rows.contains(row) || blocks.iter().any(|block| block.changes_with(*row, rows))
    };
    (0..table.len())
        .filter(|row| given(row) && !affected(row))
        .collect()
}

/// The values of some parameters in a case, as a key.
pub type Identity = Vec<Option<(u64, &'static str)>>;

/// The values of these parameters in a case, as a key.
pub fn identity(case: &Case, rows: &[usize]) -> Identity {
    let values = rows.iter().map(|row| case.values[*row]);
    values.map(|value| value.map(Value::identity)).collect()
}

/// Numbers groups of cases with the same values of some parameters, in the order of the first case of each group.
#[derive(Debug)]
pub struct Groups {
    rows: Vec<usize>,
    found: HashMap<Identity, usize>,
}

impl Groups {
    /// No group yet; cases of a group have the same values of these parameters.
    pub fn new(rows: &[usize]) -> Groups {
        Groups {
            rows: rows.to_vec(),
            found: HashMap::new(),
        }
    }

    /// The number of the group of a case, and whether it is the first case of the group.
    pub fn place(&mut self, case: &Case) -> (usize, bool) {
        let next = self.found.len();
        let place = *self.found.entry(identity(case, &self.rows)).or_insert(next);
        (place, place == next)
    }
}

/// Items with equal keys together, in the order of the first one of each group.
pub fn grouped<T, K: Eq + Hash>(
    items: impl IntoIterator<Item = T>,
    key: impl Fn(&T) -> K,
) -> Vec<Vec<T>> {
    let mut places = HashMap::new();
    let mut groups: Vec<Vec<T>> = Vec::new();
    for item in items {
        let group_index = *places.entry(key(&item)).or_insert(groups.len());
        match groups.get_mut(group_index) {
            Some(group) => group.push(item),
            None => groups.push(vec![item]),
        }
    }
    groups
}

/// The values of these parameters in a case, as in `law = hertz, n = 5`.
pub fn values(case: &Case, rows: &[usize]) -> String {
    let value = |row: &usize| {
        let name = &case.schema.parameters[*row].name;
        case.values[*row].map(|value| format!("{name} = {value}"))
    };
    rows.iter().filter_map(value).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_are_in_the_order_of_their_first_items() {
        let groups = grouped([3, 1, 4, 1, 5, 9, 2, 6], |x| x % 3);
        assert_eq!(groups, [vec![3, 9, 6], vec![1, 4, 1], vec![5, 2]]);
    }
}
