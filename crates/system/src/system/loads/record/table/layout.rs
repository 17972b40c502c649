//! How the numbers of a table are laid out: in columns, or one series in rows.

use super::super::fault::RecordCause;
use super::super::fortran_number::number;
use super::Rows;
use super::fields::cells;

/// Largest share of the change along a column that the numbers of one series have from each to the next.
const SMOOTH: f64 = 0.7;

/// Fewest rows by which a layout is judged.
const FEWEST: usize = 8;

/// Largest share by which even steps differ.
const EVEN: f64 = 1e-3;

/// Whether the rows look like one series of numbers, row after row.
///
/// From the last number of a row to the first of the next one is then a single step, from row to row are several; columns that have
/// little to do with each other differ by more than their own steps.
pub(super) fn is_series(rows: &Rows) -> bool {
    let Some(values) = values(rows).filter(|found| found.len() >= FEWEST) else {
        return false;
    };
    let width = values[0].len();
    if width < 2 || rows.names.is_some() {
        return false;
    }
    let series: Vec<f64> = values.concat();
    let mean = |pairs: &mut dyn Iterator<Item = f64>| {
        let (sum, count) = pairs.fold((0.0, 0.0), |(sum, count), x| (sum + x, count + 1.0));
        sum / count
    };
    let distance = |step: usize| {
        mean(
            &mut series
                .iter()
                .zip(&series[step..])
                .map(|(a, b)| (b - a).abs()),
        )
    };
    let wraps = values
        .windows(2)
        .map(|pair| (pair[1][0] - pair[0][width - 1]).abs());
    let along = distance(width);
    distance(1) < SMOOTH * along && mean(&mut wraps.into_iter()) < SMOOTH * along
}

/// The step of the first column if it has times: it rises evenly, and is not 1, as that of row numbers.
pub(super) fn step(rows: &Rows) -> Option<f64> {
    let values = values(rows).filter(|found| found.len() >= FEWEST && found[0].len() > 1)?;
    let step = (values[values.len() - 1][0] - values[0][0]) / (values.len() - 1) as f64;
    let is_even = values
        .windows(2)
        .all(|pair| (pair[1][0] - pair[0][0] - step).abs() <= EVEN * step);
    (step > 0.0 && is_even && step != 1.0).then_some(step)
}

/// Why a row of so many numbers is not one of two, or of one if the table has no times.
pub(super) fn fault(rows: &Rows, count: usize, even: bool) -> RecordCause {
    let least = 2 - usize::from(even);
    let widths: Vec<usize> = rows.lines.iter().map(|line| cells(line).len()).collect();
    let full = widths.iter().filter(|width| **width == count).count();
    let firsts: Vec<f64> = rows
        .lines
        .iter()
        .map_while(|line| number(cells(line).first()?).ok())
        .collect();
    let rises = firsts.windows(2).all(|pair| pair[0] < pair[1]);
    let is_filled = rows.names.is_none() && !rises && widths.iter().all(|width| *width <= count);
    match count > least && full == widths.len() {
        true if is_series(rows) => RecordCause::Series(count, even),
        true if even || rises => RecordCause::Fields(count, None, even),
        true => RecordCause::EvenColumns(count),
        // The last row of a series, or of a part of it, has what is left.
        false if is_filled && count > least && 2 * full > widths.len() => {
            RecordCause::Series(count, even)
        }
        false => RecordCause::Row(count, even),
    }
}

/// The numbers of rows of one length; `None` if a field is none.
fn values(rows: &Rows) -> Option<Vec<Vec<f64>>> {
    let width = cells(rows.lines.first()?).len();
    let row = |line: &&str| {
        let fields = cells(line);
        let numbers: Option<Vec<f64>> = fields.iter().map(|field| number(field).ok()).collect();
        numbers.filter(|found| found.len() == width)
    };
    rows.lines.iter().map(row).collect()
}
