//! Matrix Market files <https://math.nist.gov/MatrixMarket/formats.html>.
//!
//! The reader of nalgebra-sparse (feature `io`) names a line only where its grammar does not match. An index out of range, a missing
//! entry and an upper triangle have no line there, and it does not say at which line an entry is, as the checks of symmetry and
//! pivots need.

use super::{ImportFault, fault, number, shown, text};
use crate::system::structure::Symmetric;
use crate::system::structure::sparse::factor::negative_pivot;

/// Most rows.
const MOST_ROWS: usize = 1_000_000;

/// Largest difference of two entries that must be equal, and largest negative pivot, over the largest entry.
pub(crate) const ROUND_OFF: f64 = 1e-9;

/// A symmetric matrix of a file, with the lines of its entries.
#[derive(Debug, Clone)]
pub struct Matrix {
    /// The matrix.
    pub matrix: Symmetric,
    /// Index of the line of each entry of the diagonal; that of the size for an entry that is not there.
    diagonal: Vec<usize>,
    /// Index of the line of the size.
    size: usize,
}

/// The forms of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Form {
    coordinate: bool,
    symmetric: bool,
}

/// An entry of a file. Rows and lines fit in 32 bits: a file has 2 GiB at most.
#[derive(Debug, Clone, Copy)]
struct Entry {
    /// Row and column.
    place: [u32; 2],
    value: f64,
    /// Index of its line.
    line: u32,
}

impl Matrix {
    /// The matrix of a file.
    ///
    /// # Errors
    /// The first line that is wrong; also where the matrix is not square or not symmetric.
    pub fn parse(bytes: &[u8]) -> Result<Matrix, ImportFault> {
        let text = text(bytes)?;
        let mut lines = text.lines().enumerate();
        let form = form(lines.next().map_or("", |(_, line)| line))?;
        let mut content =
            lines.filter(|(_, line)| !line.starts_with('%') && !line.trim().is_empty());
        let end = || text.lines().count().saturating_sub(1);
        let Some((at, size)) = content.next() else {
            return Err(fault(end(), "the file ends before the size of the matrix"));
        };
        let (n, count) = sizes(size, form).map_err(|message| fault(at, message))?;
        // A line of an entry has two bytes at least.
        let mut entries = Vec::with_capacity(count.min(text.len() / 2));
        let mut next = (0, 0);
        let read = content.try_for_each(|(line, text)| {
            if entries.len() == count {
                let message = format!("more entries than the {count} announced");
                return Err(fault(line, message));
            }
            let (position, value) = match form.coordinate {
                true => entry(text, n),
                false => number(text.trim()).map(|value| (next, value)),
            }
            .map_err(|message| fault(line, message))?;
            let (i, j) = position;
            next = match (i + 1 < n, form.symmetric) {
                (true, _) => (i + 1, j),
                (false, true) => (j + 1, j + 1),
                (false, false) => (0, j + 1),
            };
            if form.symmetric && j > i {
                let message = "a symmetric file has entries on and below the diagonal only";
                return Err(fault(line, message));
            }
            entries.push(Entry {
                place: [i as u32, j as u32],
                value,
                line: line as u32,
            });
            Ok(())
        });
        // Equal places stay in the order of the lines.
        entries.sort_by_key(|entry| entry.place);
        let pairs = entries.windows(2);
        let twice = pairs.filter(|pair| pair[0].place == pair[1].place);
        if let Some(entry) = twice.map(|pair| pair[1]).min_by_key(|entry| entry.line) {
            let [i, j] = entry.place.map(|index| index + 1);
            let message = format!("row {i} and column {j} are there twice");
            return Err(fault(entry.line as usize, message));
        }
        read?;
        if entries.len() < count {
            let read = entries.len();
            let message = format!("the file ends after {read} entries of {count}");
            return Err(fault(end(), message));
        }
        symmetric(&entries, form, (n, at))
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.diagonal.len()
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The fault of a matrix that should have `rows` rows, as its list of degrees of freedom has.
    pub fn wrong_size(&self, rows: usize) -> ImportFault {
        let rows_of_matrix = self.len();
        fault(
            self.size,
            format!("the matrix has {rows_of_matrix} rows, but the file under \"dofs\" has {rows}"),
        )
    }

    /// Refuses a matrix with a negative pivot ([`negative_pivot`]): M is positive semidefinite. `name` gives the name of a row.
    ///
    /// # Errors
    /// The line of the pivot.
    pub fn check_pivots(&self, name: impl Fn(usize) -> String) -> Result<(), ImportFault> {
        match negative_pivot(&self.matrix) {
            None => Ok(()),
            Some(row) => Err(fault(
                self.diagonal[row],
                format!("the matrix has a negative pivot at {}", name(row)),
            )),
        }
    }
}

/// The form that the first line says.
fn form(line: &str) -> Result<Form, ImportFault> {
    let lower_case: Vec<String> = line
        .split_whitespace()
        .map(str::to_ascii_lowercase)
        .collect();
    let words: Vec<&str> = lower_case.iter().map(String::as_str).collect();
    let refuse = |what: &str| {
        let message = format!(
            "must begin with %%MatrixMarket matrix, coordinate or array, real or integer, general or symmetric, got {what}"
        );
        Err(fault(0, message))
    };
    let ["%%matrixmarket", "matrix", format, field, symmetry] = words[..] else {
        return refuse(&shown(line));
    };
    match (format, field, symmetry) {
        ("coordinate" | "array", "real" | "integer", "general" | "symmetric") => Ok(Form {
            coordinate: format == "coordinate",
            symmetric: symmetry == "symmetric",
        }),
        _ => refuse(&format!("{format} {field} {symmetry}")),
    }
}

/// Number of rows, and of entries.
fn sizes(line: &str, form: Form) -> Result<(usize, usize), String> {
    let whole = |text: &str| {
        let not = || {
            format!(
                "must be whole numbers, the size of the matrix, got {}",
                shown(line)
            )
        };
        text.parse::<usize>().map_err(|_| not())
    };
    let numbers = line
        .split_whitespace()
        .map(whole)
        .collect::<Result<Vec<_>, _>>()?;
    let (rows, columns, count) = match (numbers[..].iter().as_slice(), form.coordinate) {
        ([rows, columns, count], true) => (*rows, *columns, *count),
        // Larger numbers are refused below.
        ([rows, columns], false) if form.symmetric => (
            *rows,
            *columns,
            rows.saturating_mul(rows.saturating_add(1)) / 2,
        ),
        ([rows, columns], false) => (*rows, *columns, rows.saturating_mul(*columns)),
        (_, true) => return Err("must be numbers of rows, columns and entries".into()),
        (_, false) => return Err("must be numbers of rows and columns".into()),
    };
    if rows != columns {
        return Err(format!(
            "must be square, got {rows} rows and {columns} columns"
        ));
    }
    if rows == 0 || rows > MOST_ROWS {
        return Err(format!("must have 1 to {MOST_ROWS} rows, got {rows}"));
    }
    Ok((rows, count))
}

/// Row and column from 0, and the value.
fn entry(line: &str, n: usize) -> Result<((usize, usize), f64), String> {
    let words: Vec<&str> = line.split_whitespace().collect();
    let [i, j, value] = words[..] else {
        return Err(format!(
            "must be row, column and value, got {}",
            shown(line)
        ));
    };
    let index = |text: &str| match text.parse::<usize>() {
        Ok(i) if (1..=n).contains(&i) => Ok(i - 1),
        _ => Err(format!(
            "must be a row or column from 1 to {n}, got {}",
            shown(text)
        )),
    };
    Ok(((index(i)?, index(j)?), number(value)?))
}

/// The symmetric matrix of n rows of these entries, which rise; `size` is the line of its size.
fn symmetric(
    entries: &[Entry],
    form: Form,
    (n, size): (usize, usize),
) -> Result<Matrix, ImportFault> {
    let values = entries.iter().map(|entry| entry.value);
    let largest = values.fold(0.0, |a: f64, x| a.max(x.abs()));
    let at = |position: [u32; 2]| {
        let found = entries.binary_search_by_key(&position, |entry| entry.place);
        found.ok().map(|entry| entries[entry].value)
    };
    let mut counts = vec![0; n];
    let below = entries.iter().map(|entry| entry.place);
    below
        .filter(|[i, j]| i >= j)
        .for_each(|[i, _]| counts[i as usize] += 1);
    let mut matrix = Symmetric::with_room(&counts);
    let mut diagonal = vec![size; n];
    for Entry { place, value, line } in entries {
        let [i, j] = place.map(|index| index as usize);
        if i == j {
            diagonal[i] = *line as usize;
            matrix.add(i, i, *value);
            continue;
        }
        if form.symmetric {
            matrix.add(i, j, *value);
            continue;
        }
        let across = at([place[1], place[0]]);
        let other = across.unwrap_or(0.0);
        if (value - other).abs() > ROUND_OFF * largest {
            let message = format!(
                "the matrix is not symmetric: {value} in row {} and column {}, {other} in row {} and column {}",
                i + 1,
                j + 1,
                j + 1,
                i + 1
            );
            return Err(fault(*line as usize, message));
        }
        // Each of the two adds its half; equal ones give their value without round-off.
        matrix.add(i, j, 0.5 * value);
        if across.is_none() {
            matrix.add(i, j, 0.5 * other);
        }
    }
    Ok(Matrix {
        matrix,
        diagonal,
        size,
    })
}
