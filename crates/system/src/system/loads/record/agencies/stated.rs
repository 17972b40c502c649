//! What headers state about the numbers: labels with numbers, units, and the peak, which the numbers have, too.

use super::super::fault::{LineFault, RecordCause, fault};
use super::super::fortran_number::number;
use super::super::{Doubt, Record};
use crate::system::loads::Unit;

/// What is behind a label in capitals in the first of these lines that has it, without signs between, and the index of the line.
pub(super) fn behind<'a>(lines: &[&'a str], label: &str) -> Option<(usize, &'a str)> {
    let of = |line: &&'a str| {
        let start = line.to_ascii_uppercase().find(label)?;
        let rest = &line[start + label.len()..];
        Some(rest.trim_start_matches([' ', '=', ':']).trim_end())
    };
    lines
        .iter()
        .enumerate()
        .find_map(|(i, line)| Some((i, of(line)?)))
}

/// The whole number >= 2 at the beginning of a text, which `what` names, in the line with this index.
pub(super) fn count(text: &str, what: &'static str, line: usize) -> Result<f64, LineFault> {
    let count = first_number(text).map_err(|cause| fault(line, cause))?;
    match count >= 2.0 && count.fract() == 0.0 {
        true => Ok(count),
        false => Err(fault(line, RecordCause::Count(what, count))),
    }
}

/// The number > 0 at the beginning of a text, which `what` names, in the line with this index.
pub(super) fn positive(text: &str, what: &'static str, line: usize) -> Result<f64, LineFault> {
    let x = first_number(text).map_err(|cause| fault(line, cause))?;
    match x > 0.0 {
        true => Ok(x),
        false => Err(fault(line, RecordCause::NotPositive(what, x))),
    }
}

fn first_number(text: &str) -> Result<f64, RecordCause> {
    let word = text.split([' ', ',']).next().unwrap_or_default();
    number(word)
}

/// A unit of acceleration among the words of a text, and by what its numbers are divided: `G/10` is g with 10.
pub(super) fn unit(text: &str) -> Option<(Unit, f64)> {
    let mut words = text.split([' ', ',', ';', ':', '(', ')', '=']);
    words.find_map(|word| {
        let word = word.trim_end_matches('.');
        match word.eq_ignore_ascii_case("g/10") {
            true => Some((Unit::G, 10.0)),
            false => Unit::spelled(word).map(|unit| (unit, 1.0)),
        }
    })
}

/// Share by which a peak may differ from that of the numbers besides its last digit: they are rounded, too.
const ROUNDED: f64 = 1e-3;

/// The doubt about a record whose header states another peak than its numbers have; the unit of the peak is the one behind it, or
/// `unit`.
pub(super) fn peak(
    record: &Record,
    (text, unit): (&str, Option<Unit>),
    (by, line): (&str, usize),
) -> Option<Doubt> {
    let mut words = text.split([' ', ',']).filter(|word| !word.is_empty());
    let word = words.next()?;
    let stated = number(word).ok()?.abs();
    let named = words.next().and_then(Unit::spelled);
    let [of_record, other] = [record.unit?, named.or(unit).or(record.unit)?].map(Unit::in_m_s2);
    let peak = record
        .values
        .iter()
        .fold(0.0, |max: f64, a| max.max(a.abs()));
    let largest = peak * of_record / other;
    let tolerance = last_digit(word)? + ROUNDED * largest;
    let cause = || RecordCause::Peak(largest, format!("{by} of line {}", line + 1), stated);
    ((largest - stated).abs() > tolerance).then(|| Doubt::new(line, cause()))
}

/// The doubt about a record that ends at a time, more than two steps from that of its header.
pub(super) fn ends(
    end: f64,
    (step, text): (f64, &str),
    (by, line): (&str, usize),
) -> Option<Doubt> {
    let word = text.split([' ', ',']).next()?;
    let stated = number(word).ok()?;
    let source = format!("{by} of line {}", line + 1);
    let differs = (end - stated).abs() > 2.0 * step + last_digit(word)?;
    differs.then(|| Doubt::new(line, RecordCause::Ends(end, source, stated)))
}

/// One unit of the last digit of a number such as `-267.957`.
fn last_digit(word: &str) -> Option<f64> {
    let decimals = word.split_once('.').map_or("", |(_, decimals)| decimals);
    let digits = decimals.bytes().all(|c| c.is_ascii_digit());
    digits.then(|| 0.1f64.powi(decimals.len() as i32))
}
