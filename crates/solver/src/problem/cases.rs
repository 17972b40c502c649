//! Many cases in columns, one for each parameter; a value that all cases have is stored once.

use std::ops::Range;

use super::parameter::Value;
use super::{Case, Schema};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Cases of one problem, as columns.
#[derive(Debug, Clone)]
pub struct Cases {
    schema: Arc<Schema>,
    len: usize,
    columns: Vec<Column>,
    refused: BTreeMap<usize, String>,
    /// By how much the number of each case is above that of the first; `None` if the cases are consecutive.
    offsets: Option<Vec<u64>>,
}

/// The values of one parameter over many cases; `None` if it does not apply.
#[derive(Debug, Clone)]
pub enum Column {
    /// One for all cases.
    Same(Option<Value>),
    /// One for each case.
    Each(Vec<Option<Value>>),
}

impl Cases {
    /// No cases.
    pub fn new(schema: &Arc<Schema>) -> Cases {
        Cases {
            schema: schema.clone(),
            len: 0,
            columns: vec![Column::Same(None); schema.parameters.len()],
            refused: BTreeMap::new(),
            offsets: None,
        }
    }

    /// Adds a case, the number of which is `offset` above that of the first, and why it cannot be solved, if so.
    pub fn push_at(&mut self, offset: u64, case: &Case, refused: Option<String>) {
        let row = self.len as u64;
        if offset != row && self.offsets.is_none() {
            self.offsets = Some((0..row).collect());
        }
        if let Some(offsets) = &mut self.offsets {
            offsets.push(offset);
        }
        if let Some(why) = refused {
            self.refused.insert(self.len, why);
        }
        self.push_values(case);
    }

    /// By how much the number of a case is above that of the first.
    pub fn offset(&self, row: usize) -> u64 {
        let offsets = self.offsets.as_ref();
        offsets.map_or(row as u64, |offsets| offsets[row])
    }

    /// The same of all cases; `None` if they are consecutive.
    pub fn offsets(&self) -> Option<&[u64]> {
        self.offsets.as_deref()
    }

    /// The cases that cannot be solved, in increasing order, and why.
    pub fn refused(&self) -> impl Iterator<Item = (usize, &str)> {
        self.refused.iter().map(|(case, why)| (*case, why.as_str()))
    }

    /// Whether a case may be solved.
    pub fn may_be_solved(&self, case: usize) -> bool {
        !self.refused.contains_key(&case)
    }

    /// Adds a case of the same table, consecutive to the last.
    pub fn push(&mut self, case: &Case) {
        let next = self
            .len
            .checked_sub(1)
            .map_or(0, |last| self.offset(last) + 1);
        self.push_at(next, case, None);
    }

    fn push_values(&mut self, case: &Case) {
        for (column, value) in self.columns.iter_mut().zip(&case.values) {
            match column {
                Column::Each(values) => values.push(*value),
                Column::Same(same) if self.len == 0 => *same = *value,
                Column::Same(same) if Value::identical(*same, *value) => {}
                Column::Same(same) => {
                    let mut values = vec![*same; self.len];
                    values.push(*value);
                    *column = Column::Each(values);
                }
            }
        }
        self.len += 1;
    }

    /// Some of the cases.
    pub fn only(&self, rows: Range<usize>) -> Cases {
        let (mut some, mut shown) = (Cases::new(&self.schema), self.shown());
        let start = rows.start;
        for row in rows {
            let offset = self.offset(row) - self.offset(start);
            some.push_at(offset, shown.at(row), self.refused.get(&row).cloned());
        }
        some
    }

    /// Number of cases.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// One column for each row of the problem's table.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// A case with the values in these rows of the table, if all cases have the same.
    pub fn common(&self, rows: impl Iterator<Item = usize>) -> Option<Case> {
        let mut case = Case::new(&self.schema);
        for row in rows {
            match &self.columns[row] {
                Column::Same(value) => case.values[row] = *value,
                Column::Each(_) => return None,
            }
        }
        Some(case)
    }

    /// Access to the cases, one after the other.
    pub fn shown(&self) -> Shown<'_> {
        let mut case = Case::new(&self.schema);
        let mut varying = Vec::new();
        for (row, column) in self.columns.iter().enumerate() {
            match column {
                Column::Same(value) => case.values[row] = *value,
                Column::Each(values) => varying.push((row, &values[..])),
            }
        }
        Shown { case, varying }
    }
}

/// One case after the other in the same memory.
#[derive(Debug)]
pub struct Shown<'a> {
    case: Case,
    varying: Vec<(usize, &'a [Option<Value>])>,
}

impl Shown<'_> {
    /// Case `index`, from 0.
    ///
    /// # Panics
    /// If there is no such case.
    pub fn at(&mut self, index: usize) -> &Case {
        for (row, values) in &self.varying {
            self.case.values[*row] = values[index];
        }
        &self.case
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::PROBLEMS;

    #[test]
    fn cases_are_read_as_they_were_added() {
        let schema = PROBLEMS[0].schema();
        let number = |x: f64| Some(Value::Number(x));
        // A constant value, one that changes late and only in the sign of zero, and one that is missing in some cases.
        let values = |i: usize| {
            [
                number(0.1),
                number(if i < 3 { 0.0 } else { -0.0 }),
                Some(Value::Whole(7)).filter(|_| i % 2 == 1),
                Some(Value::Name(if i == 4 { "wall" } else { "bar" })),
            ]
        };
        let mut case = Case::new(schema);
        let mut cases = Cases::new(schema);
        for i in 0..6 {
            case.values[..4].copy_from_slice(&values(i));
            cases.push(&case);
        }
        let same = |column: &Column| matches!(column, Column::Same(_));
        let which: Vec<bool> = cases.columns().iter().map(same).collect();
        assert_eq!(which[..5], [true, false, false, false, true]);
        let mut shown = cases.shown();
        for i in [5, 0, 3, 1, 4, 2] {
            let case = shown.at(i);
            for (value, expected) in case.values.iter().zip(values(i)) {
                assert!(
                    Value::identical(*value, expected),
                    "case {i}: {value:?}, not {expected:?}"
                );
            }
            assert!(case.values[4..].iter().all(Option::is_none));
        }
    }
}
