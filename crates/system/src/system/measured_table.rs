//! Tables of measured values: a line with the names of the columns, then rows of numbers.

use super::loads::record::file_text::{decode, is_end};
use super::loads::record::fortran_number::{decimal, number};
use super::loads::record::table::fields::{bare, split};
use super::loads::record::{RecordCause, RecordFault, Shown};

/// Largest number of a cell: sums of squares of such numbers in any unit are finite.
pub const LARGEST: f64 = 1e100;

/// A table whose columns have names. A column is read when it is asked for, so that others may have texts.
///
/// ```
/// use slipgap_system::system::measured_table::MeasuredTable;
///
/// let table = MeasuredTable::read("test.csv", b"# rig 2\nt;\"disp, mm\"\n0.0;1.5\n0.1;1.7\n")?;
/// assert_eq!(table.times("t")?, [0.0, 0.1]);
/// assert_eq!(table.column("disp, mm")?, [1.5, 1.7]);
/// let why = table.column("force").unwrap_err();
/// assert_eq!(why.to_string(), "test.csv:2: no column \"force\"; the columns are \"t\", \"disp, mm\"");
/// # Ok::<(), slipgap_system::system::loads::record::RecordFault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredTable {
    file: String,
    /// Index of the line with the names, from 0.
    header: usize,
    names: Vec<String>,
    by: Option<char>,
    /// The rows with the indices of their lines.
    rows: Vec<(usize, String)>,
}

impl MeasuredTable {
    /// The table of a file; `file` is for messages only.
    ///
    /// Lines that begin with `#` and empty lines do not count. The line of names has the separator: a tab before a semicolon, a
    /// semicolon before a comma, a comma before blanks. One may also end a row.
    ///
    /// # Errors
    /// No line of names, or a row with more or fewer fields than names.
    pub fn read(file: &str, bytes: &[u8]) -> Result<MeasuredTable, RecordFault> {
        let text = decode(bytes);
        let mut lines = text.lines().enumerate().filter(|(_, line)| {
            let line = line.trim();
            !line.is_empty() && !line.starts_with('#')
        });
        let at = |line, cause| fault(file, line, cause);
        let (header, line) = lines.next().ok_or_else(|| at(0, RecordCause::NoNames))?;
        let mut separators = ['\t', ';', ','].into_iter();
        let by = separators.find(|by| split(line, Some(*by)).len() > 1);
        let mut names: Vec<String> = cells(line, by).into_iter().map(String::from).collect();
        if by.is_some() && names.last().is_some_and(String::is_empty) {
            names.pop();
        }
        if names.iter().all(|name| number(name).is_ok()) {
            return Err(at(header, RecordCause::NoNames));
        }
        let mut rows = Vec::new();
        let mut end = None;
        for (index, line) in lines {
            if let Some(end) = end {
                return Err(at(index, RecordCause::AfterEnd(end + 1)));
            }
            if is_end(line) {
                end = Some(index);
                continue;
            }
            let cells = cells(line, by);
            let ends = cells.len() == names.len() + 1 && cells.last() == Some(&"");
            if cells.len() != names.len() && !ends {
                return Err(at(index, RecordCause::Cells(cells.len(), names.len())));
            }
            rows.push((index, line.to_owned()));
        }
        Ok(MeasuredTable {
            file: file.to_owned(),
            header,
            names,
            by,
            rows,
        })
    }

    /// The names of the columns, in their order. A name without letters is of a column that has none.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The numbers of a column, one for each row.
    ///
    /// # Errors
    /// No column of this name or two, or the first row without a finite number there.
    pub fn column(&self, name: &str) -> Result<Vec<f64>, RecordFault> {
        let numbers = self.numbers(name)?;
        Ok(numbers.into_iter().map(|(_, x)| x).collect())
    }

    /// The numbers of a column of times, which rise.
    ///
    /// # Errors
    /// Those of [`column`](Self::column), and the first time that is not after the one before it.
    pub fn times(&self, name: &str) -> Result<Vec<f64>, RecordFault> {
        let numbers = self.numbers(name)?;
        for pair in numbers.windows(2) {
            let [(_, last), (line, t)] = [pair[0], pair[1]];
            if t <= last {
                return Err(fault(&self.file, line, RecordCause::Time { t, last }));
            }
        }
        Ok(numbers.into_iter().map(|(_, x)| x).collect())
    }

    /// The numbers of a column with the indices of their lines.
    fn numbers(&self, name: &str) -> Result<Vec<(usize, f64)>, RecordFault> {
        let mut places = (0..self.names.len()).filter(|column| self.names[*column] == name);
        let column = match (places.next(), places.next()) {
            (Some(column), None) => column,
            (found, _) => {
                let names = || self.names.iter().map(|name| Shown::new(name)).collect();
                let cause = match found {
                    Some(_) => RecordCause::TwoColumns(Shown::new(name)),
                    None => RecordCause::NoColumn(Shown::new(name), names()),
                };
                return Err(fault(&self.file, self.header, cause));
            }
        };
        let rows = self.rows.iter().map(|(line, row)| {
            let text = cells(row, self.by).get(column).copied().unwrap_or_default();
            let x = cell(text).map_err(|cause| {
                let cause = RecordCause::InColumn(Shown::new(name), Box::new(cause));
                fault(&self.file, *line, cause)
            })?;
            Ok((*line, x))
        });
        rows.collect()
    }
}

/// The fields of a line without their quotes.
fn cells(line: &str, by: Option<char>) -> Vec<&str> {
    split(line, by).into_iter().map(bare).collect()
}

/// The number of a cell; else why there is none.
fn cell(text: &str) -> Result<f64, RecordCause> {
    if text.is_empty() {
        return Err(RecordCause::Missing);
    }
    let found = decimal(text)?;
    match found.abs() <= LARGEST {
        true => Ok(found),
        false => Err(RecordCause::Bounds(Shown::new(text))),
    }
}

/// A fault in the line with this index, from 0.
fn fault(file: &str, index: usize, cause: RecordCause) -> RecordFault {
    RecordFault {
        name: file.to_owned(),
        line: index + 1,
        cause,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<MeasuredTable, String> {
        MeasuredTable::read("a.csv", text.as_bytes()).map_err(|why| why.to_string())
    }

    #[test]
    fn tables_of_all_separators_have_the_same_numbers() {
        for text in [
            "t,u,S\n0,1.5,-2\n0.1,1e-3,3\n",
            "t;u;S;\n0;1.5;-2;\n0.1;1e-3;3\n",
            "t\tu\tS\r\n0\t1.5\t-2\r\n0.1\t1D-3\t3",
            "  t   u  S\n 0  1.5\t-2\n .1 +1.E-3 3 \n",
            "\u{feff}# remark, with; all\n\n  # and blanks\nt,u,S\n0,1.5,-2\n# within\n\n0.1,0.001,3\n\n",
            "\"t\",\"u\",\"S\"\n\"0\",\"1.5\",\"-2\"\n0.1, 0.001 ,3,\n",
        ] {
            let table = read(text).unwrap();
            assert_eq!(table.names(), ["t", "u", "S"], "{text}");
            assert_eq!(table.times("t").unwrap(), [0.0, 0.1], "{text}");
            assert_eq!(table.column("u").unwrap(), [1.5, 1e-3], "{text}");
            assert_eq!(table.column("S").unwrap(), [-2.0, 3.0], "{text}");
        }
    }

    #[test]
    fn names_have_blanks_and_separators_in_quotes() {
        let table = read("t\tdisp mm\t\"S; kN\"\n0\t1\t2\n").unwrap();
        assert_eq!(table.names(), ["t", "disp mm", "S; kN"]);
        assert_eq!(table.column("disp mm").unwrap(), [1.0]);
        let table = read("time (s),\"u, left\",, S \n0,1,x,2\n").unwrap();
        assert_eq!(table.names(), ["time (s)", "u, left", "", "S"]);
        assert_eq!(table.column("u, left").unwrap(), [1.0]);
        assert_eq!(table.column("S").unwrap(), [2.0]);
        // Latin-1: the name has another character, the rest is read.
        let table = MeasuredTable::read("a.csv", b"t;T (\xb0C)\n0;20\n").unwrap();
        assert_eq!(table.column("T (\u{fffd}C)").unwrap(), [20.0]);
    }

    #[test]
    fn a_text_is_at_fault_in_its_column_only() {
        let table = read("t,u,note\n0,1,start\n1,,\n2,NaN,\"a, b\"\n3,-inf,\n").unwrap();
        assert_eq!(table.times("t").unwrap(), [0.0, 1.0, 2.0, 3.0]);
        let why = |name| table.column(name).unwrap_err().to_string();
        assert_eq!(why("u"), "a.csv:3: column \"u\": a number is missing");
        assert_eq!(
            why("note"),
            "a.csv:2: column \"note\": not a number: \"start\""
        );
        assert_eq!(
            why("T"),
            "a.csv:1: no column \"T\"; the columns are \"t\", \"u\", \"note\""
        );
    }

    #[test]
    fn faults_name_the_line_and_what_is_allowed() {
        for (text, message) in [
            (
                "",
                "a.csv:1: the file must begin with a line of names, one for each column; only lines with # may be before it",
            ),
            (
                "# t,u\n0,1\n",
                "a.csv:2: the file must begin with a line of names, one for each column; only lines with # may be before it",
            ),
            (
                "t,u\n0,1\n1,2,3\n",
                "a.csv:3: a row must have a number for each of the 2 columns, got 3",
            ),
            (
                "t u\n0 1\n1\n",
                "a.csv:3: a row must have a number for each of the 2 columns, got 1",
            ),
        ] {
            assert_eq!(read(text).unwrap_err(), message);
        }
        for (text, message) in [
            (
                "t;u\n0;1\n0;2\n",
                "a.csv:3: the times must rise, got 0 after 0",
            ),
            (
                "t;u\n0;1\n\n#\n-1;2\n",
                "a.csv:5: the times must rise, got -1 after 0",
            ),
            (
                "t;u\n0,5;1\n",
                "a.csv:2: column \"t\": numbers must have decimal points, got \"0,5\"",
            ),
            (
                "t;u\ns;mm\n0;1\n",
                "a.csv:2: column \"t\": not a number: \"s\"",
            ),
            (
                "t;u\n0;1\ninf;1\n",
                "a.csv:3: column \"t\": not a finite number: \"inf\"",
            ),
            (
                "t;u;t\n0;1;2\n",
                "a.csv:1: two columns have the name \"t\"; each needs one of its own",
            ),
        ] {
            let why = read(text).unwrap().times("t").unwrap_err();
            assert_eq!(why.to_string(), message);
        }
    }
}
