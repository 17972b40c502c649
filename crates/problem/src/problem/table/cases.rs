//! Many cases in columns, one for each parameter; a value that all cases have is stored once.

pub use super::parameter_column::{Cells, Column, NO_NAME, NO_NUMBER, NO_WHOLE, applies};

use crate::problem::numbers::parameter::Value;
use crate::problem::{Case, Schema};
use std::collections::BTreeMap;
use std::ops::Range;
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
        for (column, value) in self.columns.iter_mut().zip(&case.values) {
            column.push(self.len, *value, 1);
        }
        self.count(offset, 1, refused);
    }

    /// Counts consecutive cases whose values are in the columns or will be, and why the first of them cannot be solved, if so.
    fn count(&mut self, offset: u64, count: usize, refused: Option<String>) {
        let row = self.len as u64;
        if offset != row && self.offsets.is_none() {
            self.offsets = Some((0..row).collect());
        }
        if let Some(offsets) = &mut self.offsets {
            offsets.extend(offset..offset + count as u64);
        }
        if let Some(why) = refused {
            self.refused.insert(self.len, why);
        }
        self.len += count;
    }

    /// To add cases that differ only in the rows `changing` of the table; the others have the values of `like`.
    pub fn alike<'a>(&'a mut self, like: &'a [Option<Value>], changing: &'a [usize]) -> Alike<'a> {
        Alike {
            before: self.len,
            cases: self,
            like,
            changing,
        }
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

    /// Some of the cases.
    pub fn only(&self, rows: Range<usize>) -> Cases {
        let mut some = Cases::new(&self.schema);
        let start = rows.start;
        for (target, column) in some.columns.iter_mut().zip(&self.columns) {
            target.extend(0, column, (rows.clone(), rows.len()));
        }
        for row in rows {
            let offset = self.offset(row) - self.offset(start);
            some.count(offset, 1, self.refused.get(&row).cloned());
        }
        some
    }

    /// Adds cases of the same table, those in `rows`, consecutive to the last; of the parameters only those that `has` selects.
    pub fn extend(&mut self, other: &Cases, rows: &[u32], has: impl Fn(usize) -> bool) {
        let columns = self.columns.iter_mut().zip(&other.columns).enumerate();
        for (_, (target, column)) in columns.filter(|(row, _)| has(*row)) {
            let rows = rows.iter().map(|row| *row as usize);
            target.extend(self.len, column, (rows.clone(), rows.len()));
        }
        let next = self
            .len
            .checked_sub(1)
            .map_or(0, |last| self.offset(last) + 1);
        self.count(next, rows.len(), None);
    }

    /// Number of cases.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The schema of the problem.
    pub fn schema(&self) -> &Arc<Schema> {
        &self.schema
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
                Column::Each(cells) => varying.push((row, cells)),
            }
        }
        Shown { case, varying }
    }
}

/// Adds cases that share the values of most parameters: these are added once for all of them.
#[derive(Debug)]
pub struct Alike<'a> {
    cases: &'a mut Cases,
    /// Number of cases before them.
    before: usize,
    like: &'a [Option<Value>],
    changing: &'a [usize],
}

impl Alike<'_> {
    /// Adds a case, the number of which is `offset` above that of the first, and why it cannot be solved, if so.
    #[inline]
    pub fn push(&mut self, offset: u64, case: &Case, refused: Option<String>) {
        let len = self.cases.len;
        let shared = |row: usize| Value::identical(case.values[row], self.like[row]);
        let mut rows = 0..case.values.len();
        debug_assert!(rows.all(|row| self.changing.contains(&row) || shared(row)));
        for row in self.changing {
            self.cases.columns[*row].push(len, case.values[*row], 1);
        }
        self.cases.count(offset, 1, refused);
    }

    /// Adds consecutive cases, the number of the first of which is `offset` above that of the first of all. Each row that changes comes
    /// with its values, and how many cases have each.
    pub fn extend<R: Iterator<Item = (Value, usize)>>(
        &mut self,
        offset: u64,
        count: usize,
        rows: impl Iterator<Item = (usize, R)>,
    ) {
        for (row, values) in rows {
            let (mut len, column) = (self.cases.len, &mut self.cases.columns[row]);
            for (value, count) in values {
                column.push(len, Some(value), count);
                len += count;
            }
        }
        self.cases.count(offset, count, None);
    }
}

impl Drop for Alike<'_> {
    /// Adds the values that they share.
    fn drop(&mut self) {
        let count = self.cases.len - self.before;
        if count == 0 {
            return;
        }
        let columns = self.cases.columns.iter_mut().zip(self.like).enumerate();
        for (_, (column, value)) in columns.filter(|(row, _)| !self.changing.contains(row)) {
            column.push(self.before, *value, count);
        }
    }
}

/// One case after the other in the same memory.
#[derive(Debug)]
pub struct Shown<'a> {
    case: Case,
    varying: Vec<(usize, &'a Cells)>,
}

impl Shown<'_> {
    /// Case `index`, from 0.
    ///
    /// # Panics
    /// If there is no such case.
    pub fn at(&mut self, index: usize) -> &Case {
        for (row, cells) in &self.varying {
            self.case.values[*row] = cells.at(index);
        }
        &self.case
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::PROBLEMS;

    /// A constant value, one that changes late and only in the sign of zero, one that is missing in some cases, and a name.
    fn values(i: usize) -> [(&'static str, Option<Value>); 4] {
        let number = |x: f64| Some(Value::Number(x));
        [
            ("gamma", number(0.1)),
            ("gap", number(if i < 3 { 0.0 } else { -0.0 })),
            ("n", Some(Value::Whole(7)).filter(|_| i % 2 == 1)),
            (
                "mass",
                Some(Value::Name(if i == 4 { "consistent" } else { "lumped" })).filter(|_| i != 2),
            ),
        ]
    }

    /// The same as a case, and the rows.
    fn case(i: usize) -> (Case, [usize; 4]) {
        let mut case = Case::new(PROBLEMS[1].schema());
        let row = |name: &str| {
            let mut table = PROBLEMS[1].parameters().iter();
            table.position(|parameter| parameter.name == name).unwrap()
        };
        let rows = values(i).map(|(name, value)| {
            case.values[row(name)] = value;
            row(name)
        });
        (case, rows)
    }

    #[track_caller]
    fn assert_same(cases: &Cases, numbers: &[usize]) {
        assert_eq!(cases.len(), numbers.len());
        let mut shown = cases.shown();
        for (index, i) in numbers.iter().enumerate().rev() {
            let (expected, _) = case(*i);
            for (found, expected) in shown.at(index).values.iter().zip(&expected.values) {
                let same = Value::identical(*found, *expected);
                assert!(same, "case {i}: {found:?}, not {expected:?}");
            }
        }
    }

    #[test]
    fn cases_are_read_as_they_were_added() {
        let mut cases = Cases::new(PROBLEMS[1].schema());
        (0..6).for_each(|i| cases.push(&case(i).0));
        let same = |row: usize| matches!(cases.columns()[row], Column::Same(_));
        assert_eq!(case(0).1.map(same), [true, false, false, false]);
        assert_same(&cases, &[0, 1, 2, 3, 4, 5]);
        assert_same(&cases.only(1..5), &[1, 2, 3, 4]);
        let mut more = cases.only(4..6);
        more.extend(&cases, &[0, 2, 4], |_| true);
        assert_same(&more, &[4, 5, 0, 2, 4]);
    }

    #[test]
    fn cases_that_share_values_are_added_as_each_alone() {
        let mut cases = Cases::new(PROBLEMS[1].schema());
        let (like, [gamma, gap, n, mass]) = case(0);
        // The constant value differs from that of the cases before.
        let mut other = case(5).0;
        other.values[gamma] = Some(Value::Number(3.0));
        cases.push(&other);
        let changing = [gap, n, mass];
        let mut alike = cases.alike(&like.values, &changing);
        for i in 0..6 {
            alike.push(2 + i as u64, &case(i).0, (i == 3).then(|| "no".into()));
        }
        drop(alike);
        assert_same(&cases.only(1..7), &[0, 1, 2, 3, 4, 5]);
        assert_eq!(cases.refused().collect::<Vec<_>>(), [(4, "no")]);
        assert_eq!(cases.offsets(), Some(&[0, 2, 3, 4, 5, 6, 7][..]));
        assert_eq!(cases.shown().at(0).values[gamma], Some(Value::Number(3.0)));
    }
}
