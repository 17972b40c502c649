//! COSMOS V1 and V2: channels one after the other, each with lines of text, whole numbers, numbers and comments, and a line that
//! says how many values of which quantity follow. A file in V2 may have velocities and displacements behind the accelerations.

use super::fault::{LineFault, RecordCause, fault};
use super::fortran_number::{Stated, first, number, table};
use super::heading::{self, Heading, spaced};
use super::{Format, Parts, Reading, Record, Series, component, end};
use crate::system::loads::Unit;

/// The format.
pub(super) const FORMAT: Format = Format {
    name: "COSMOS V1 or V2",
    find: |lines| match lines.first().is_some_and(is_start) {
        true => Ok(()),
        false => Err("line 1 has no \"(Format v\" with a number of text lines"),
    },
    read,
    heading,
    parts: Parts::Components,
};

/// Place of the time step in ms among the numbers of the header, from 0.
const STEP: usize = 61;

/// Whether a channel begins with this line, such as `Corrected acceleration (Format v01.20 with 13 text lines)`.
fn is_start(line: &&str) -> bool {
    let line = line.to_ascii_lowercase();
    line.contains("(format v") && line.contains("text lines")
}

/// The record of a channel, in the unit that the file names.
fn read(lines: &[&str], reading: &Reading) -> Series {
    let starts = starts(lines);
    if starts.is_empty() {
        return Err(fault(0, RecordCause::Quantity("velocity or displacement")));
    }
    let names: Vec<String> = starts.iter().map(|start| name(lines, *start)).collect();
    let start = starts[component(&names, reading.component)?];
    let (header, count) = labelled(lines, start, "real-header value", "lines")?;
    let numbers = table(lines, header + 1, count)?;
    let step = numbers.get(STEP).copied().unwrap_or_default();
    let (data, values) = labelled(lines, header + count, "acceleration", "pts")?;
    if step <= 0.0 || !(step * values as f64).is_finite() {
        let cause = RecordCause::NotPositive("real header 62, the time step in ms,", step);
        return Err(fault(header, cause));
    }
    if values < 2 {
        return Err(fault(data, RecordCause::OneNumber));
    }
    let source = format!("the number of points of line {}", data + 1);
    let values = first(lines, data + 1, values as f64, &source)?;
    let step = step / 1000.0;
    let stated = Stated::new(step, "real header 62 (in ms) below the label", header);
    let record = Record::even(values, step, unit(lines[data]));
    Ok((record, Some(stated)))
}

/// The lines with which channels of accelerations begin; those of velocities and displacements are no components.
fn starts(lines: &[&str]) -> Vec<usize> {
    let sections = lines.iter().enumerate().filter(|(_, line)| is_start(line));
    let starts = sections.filter(|(_, line)| line.to_ascii_lowercase().contains("acceleration"));
    starts.map(|(index, _)| index).collect()
}

/// The event in the first columns of the second line, the code of the station and the direction of the channel.
fn heading(lines: &[&str], reading: &Reading) -> Heading {
    let index = reading.component.unwrap_or(1).saturating_sub(1);
    let start = starts(lines).get(index).copied().unwrap_or_default();
    let event = lines.get(start + 1).copied().unwrap_or_default();
    let mut header = lines.iter().skip(start).take(20);
    let code = header
        .find_map(|line| line.split_once("Code:"))
        .and_then(|(_, rest)| rest.split_whitespace().next());
    let channel = name(lines, start);
    let direction = channel
        .split_once(':')
        .map_or("", |(_, direction)| direction);
    Heading {
        // The date is behind several blanks.
        event: spaced(event.trim().split("  ").next().unwrap_or_default()),
        station: code.unwrap_or_default().to_owned(),
        component: heading::component(direction),
    }
}

/// The station and channel as the header names them.
fn name(lines: &[&str], start: usize) -> String {
    let mut header = lines.iter().skip(start).take(20).map(|line| line.trim());
    let line = header.find(|line| line.starts_with("Sta Chan"));
    let named = line.unwrap_or_default().split('(').next();
    named.unwrap_or_default().trim().to_owned()
}

/// The index of the first line from `from` on that has both words, and a number of it: the one behind `on` if there is one, else the
/// first.
fn labelled(
    lines: &[&str],
    from: usize,
    label: &'static str,
    unit: &'static str,
) -> Result<(usize, usize), LineFault> {
    let found = lines
        .iter()
        .enumerate()
        .skip(from.max(1))
        .find(|(_, line)| {
            let line = line.to_ascii_lowercase();
            !line.starts_with('|')
                && line.contains(label)
                && line.contains(unit)
                && !is_start(&&*line)
        });
    let Some((index, line)) = found else {
        return Err(fault(end(lines), RecordCause::NoLine(label)));
    };
    let lower_case = line.to_ascii_lowercase();
    let text = lower_case
        .split_once(" on ")
        .map_or(&*lower_case, |(_, after)| after);
    let word = text.split_whitespace().next().unwrap_or_default();
    let count = number(word).map_err(|cause| fault(index, cause))?;
    // So many lines or points fit in no file.
    match (1.0..1e9).contains(&count) && count.fract() == 0.0 {
        true => Ok((index, count as usize)),
        false => Err(fault(index, RecordCause::Count(label, count))),
    }
}

/// The unit of a line such as `42000 acceleration pts, approx 210 secs, units=cm/sec2(04),Format=(1E15.6)`.
fn unit(line: &str) -> Option<Unit> {
    let (_, after) = line.split_once("units")?;
    let after = after.trim_start_matches([' ', '=']);
    Unit::spelled(after.split(['(', ',']).next()?)
}
