//! The values of one parameter over many cases: 8 bytes for a number, 4 for a name.

use crate::problem::numbers::parameter::Value;

/// The values of one parameter over many cases; `None` if it does not apply.
#[derive(Debug, Clone)]
pub enum Column {
    /// One for all cases.
    Same(Option<Value>),
    /// One for each case.
    Each(Cells),
}

/// A value for each case, all of the kind of the parameter.
#[derive(Debug, Clone)]
pub enum Cells {
    /// Numbers; [`NO_NUMBER`] where the parameter does not apply.
    Numbers(Vec<f64>),
    /// Whole numbers; [`NO_WHOLE`] where the parameter does not apply.
    Whole(Vec<u64>),
    /// Names as places in a list; [`NO_NAME`] where the parameter does not apply.
    Names {
        /// The different names, in the order of their first cases.
        names: Vec<&'static str>,
        /// The place of the name of each case.
        places: Vec<u32>,
    },
}

/// In place of a number that does not apply: a NaN that no computation gives.
pub const NO_NUMBER: f64 = f64::from_bits(0x7ff8_6e6f_6e65_0000);

/// In place of a whole number that does not apply.
pub const NO_WHOLE: u64 = u64::MAX;

/// In place of a name that does not apply.
pub const NO_NAME: u32 = u32::MAX;

/// Whether a number of [`Cells::Numbers`] applies.
pub fn applies(x: f64) -> bool {
    x.to_bits() != NO_NUMBER.to_bits()
}

impl Cells {
    /// No values yet, of the kind of `like`.
    fn like(like: Value, capacity: usize) -> Cells {
        match like {
            Value::Number(_) => Cells::Numbers(Vec::with_capacity(capacity)),
            Value::Whole(_) => Cells::Whole(Vec::with_capacity(capacity)),
            Value::Name(_) => Cells::Names {
                names: Vec::new(),
                places: Vec::with_capacity(capacity),
            },
        }
    }

    /// The value of a case.
    ///
    /// # Panics
    /// If there is no such case.
    #[inline]
    pub fn at(&self, case: usize) -> Option<Value> {
        match self {
            Cells::Numbers(numbers) => {
                let x = numbers[case];
                applies(x).then_some(Value::Number(x))
            }
            Cells::Whole(numbers) => {
                let n = numbers[case];
                (n != NO_WHOLE).then_some(Value::Whole(n))
            }
            Cells::Names { names, places } => {
                let index = places[case];
                (index != NO_NAME).then(|| Value::Name(names[index as usize]))
            }
        }
    }

    /// Adds `count` cases with this value. A value of another kind does not occur.
    #[inline]
    fn push(&mut self, value: Option<Value>, count: usize) {
        match self {
            Cells::Numbers(numbers) => {
                let x = match value {
                    Some(Value::Number(x)) => x,
                    _ => NO_NUMBER,
                };
                // On most axes a value is that of one case.
                match count {
                    1 => numbers.push(x),
                    _ => numbers.extend(std::iter::repeat_n(x, count)),
                }
            }
            Cells::Whole(numbers) => {
                let n = match value {
                    Some(Value::Whole(n)) => n,
                    _ => NO_WHOLE,
                };
                numbers.extend(std::iter::repeat_n(n, count));
            }
            Cells::Names { names, places } => {
                let index = match value {
                    Some(Value::Name(name)) => place_of(names, name),
                    _ => NO_NAME,
                };
                places.extend(std::iter::repeat_n(index, count));
            }
        }
    }

    /// Adds the values of some cases of another column of the same kind.
    fn extend(&mut self, other: &Cells, rows: impl Iterator<Item = usize>) {
        match (self, other) {
            (Cells::Numbers(cells), Cells::Numbers(other)) => {
                cells.extend(rows.map(|row| other[row]))
            }
            (Cells::Whole(cells), Cells::Whole(other)) => cells.extend(rows.map(|row| other[row])),
            (
                Cells::Names { names, places },
                Cells::Names {
                    names: others,
                    places: other,
                },
            ) => {
                let known: Vec<u32> = others.iter().map(|name| place_of(names, name)).collect();
                places.extend(rows.map(|row| match other[row] {
                    NO_NAME => NO_NAME,
                    index => known[index as usize],
                }));
            }
            (cells, _) => rows.for_each(|row| cells.push(other.at(row), 1)),
        }
    }
}

/// The place of a name in the list, to which it is added if it is new.
fn place_of(names: &mut Vec<&'static str>, name: &'static str) -> u32 {
    let same = |known: &&'static str| std::ptr::eq(*known, name) || *known == name;
    let index = names.iter().position(same).unwrap_or_else(|| {
        names.push(name);
        names.len() - 1
    });
    index as u32
}

impl Column {
    /// The value of a case.
    #[inline]
    pub fn at(&self, case: usize) -> Option<Value> {
        match self {
            Column::Same(value) => *value,
            Column::Each(cells) => cells.at(case),
        }
    }

    /// Adds `count` cases with this value to `len` others.
    #[inline]
    pub(crate) fn push(&mut self, len: usize, value: Option<Value>, count: usize) {
        match self {
            Column::Each(cells) => cells.push(value, count),
            Column::Same(same) if len == 0 => *same = value,
            Column::Same(same) if Value::identical(*same, value) => {}
            Column::Same(same) => {
                let before = *same;
                if let Some(like) = before.or(value) {
                    let mut cells = Cells::like(like, len + count);
                    cells.push(before, len);
                    cells.push(value, count);
                    *self = Column::Each(cells);
                }
            }
        }
    }

    /// Adds `count` cases of another column, those in `rows`, to `len` others.
    pub(crate) fn extend(
        &mut self,
        len: usize,
        other: &Column,
        (mut rows, count): (impl Iterator<Item = usize>, usize),
    ) {
        match (self, other) {
            (column, Column::Same(value)) => column.push(len, *value, count),
            (Column::Each(cells), Column::Each(other)) => cells.extend(other, rows),
            (column, Column::Each(other)) => {
                // One by one as long as all values are the same.
                let mut len = len;
                while matches!(column, Column::Same(_))
                    && let Some(row) = rows.next()
                {
                    column.push(len, other.at(row), 1);
                    len += 1;
                }
                if let Column::Each(cells) = column {
                    cells.extend(other, rows);
                }
            }
        }
    }
}
