//! The text files of the National Strong-Motion Program (USGS): blocks of accelerations, velocities and displacements one after the
//! other, each with seven lines of text, the last two with labels, then rows of numbers.

use super::super::fault::{RecordCause, fault};
use super::super::fortran_number::{Stated, block};
use super::super::heading::{self, Heading, spaced};
use super::super::{Format, Parts, Reading, Record, Series, component};
use super::stated::{behind, count, positive, unit};

/// The format.
pub(in super::super) const FORMAT: Format = Format {
    name: "NSMP",
    find: |lines| {
        let head = &lines[..lines.len().min(LINES)];
        let count = MARKS
            .iter()
            .filter(|mark| behind(head, mark).is_some())
            .count();
        match blocks(head).is_empty() || count < FEWEST {
            false => Ok(()),
            true => Err(
                "its first 20 lines have less than 4 labels such as \"SAMPLES/SEC=\" and \"DATA TYPE=\"",
            ),
        }
    },
    read,
    heading,
    parts: Parts::Components,
};

/// Labels of the text, and how many of them a file has at least.
const MARKS: [&str; 5] = [
    "SAMPLES/SEC=",
    "DATA TYPE=",
    "NO OF POINTS=",
    "FILTER TYPE=",
    "JULIAN DAY=",
];
const FEWEST: usize = 4;

/// Lines that are searched for labels.
const LINES: usize = 20;

/// Lines of text before the one with the type.
const TITLES: usize = 5;

/// The lines with the type of a block, and whether it has accelerations.
fn blocks(lines: &[&str]) -> Vec<(usize, bool)> {
    let of = |(i, line): (usize, &&str)| {
        let (_, kind) = behind(&[*line], "DATA TYPE=")?;
        Some((i, kind.to_ascii_uppercase().starts_with("AC")))
    };
    lines.iter().enumerate().filter_map(of).collect()
}

/// The lines with the type of the blocks that have accelerations.
fn accelerations(lines: &[&str]) -> Vec<usize> {
    let blocks = blocks(lines).into_iter();
    blocks
        .filter(|block| block.1)
        .map(|block| block.0)
        .collect()
}

/// The text of a block before the line with its type.
fn titles<'a, 'b>(lines: &'a [&'b str], at: usize) -> &'a [&'b str] {
    &lines[at.saturating_sub(TITLES)..at]
}

/// The record of a block of accelerations.
fn read(lines: &[&str], reading: &Reading) -> Series {
    let blocks = accelerations(lines);
    if blocks.is_empty() {
        return Err(fault(0, RecordCause::Quantity("velocity or displacement")));
    }
    let direction = |at: &usize| {
        let (_, rest) = behind(titles(lines, *at), "COMPONENT=").unwrap_or_default();
        spaced(rest)
    };
    let names: Vec<String> = blocks.iter().map(direction).collect();
    let at = blocks[component(&names, reading.component)?];
    let labelled = |line: usize, label: &'static str| {
        let text = lines.get(line).copied().unwrap_or_default();
        let found = behind(&[text], label).map(|(_, rest)| rest);
        found.ok_or_else(|| fault(line, RecordCause::NoLine(label)))
    };
    let rate = positive(labelled(at, "SAMPLES/SEC=")?, "SAMPLES/SEC", at)?;
    let points = count(labelled(at + 1, "NO OF POINTS=")?, "NO OF POINTS", at + 1)?;
    let word = labelled(at + 1, "UNITS=")?.split(',').next();
    let units = word.and_then(unit).map(|pair| pair.0);
    let source = format!("NO OF POINTS of line {}", at + 2);
    let values = block(lines, at + 2, points, &source)?;
    let stated = Stated::new(1.0 / rate, "SAMPLES/SEC", at);
    Ok((Record::even(values, 1.0 / rate, units), Some(stated)))
}

/// The station, the event and the direction of a block.
fn heading(lines: &[&str], reading: &Reading) -> Heading {
    let index = reading.component.unwrap_or(1).saturating_sub(1);
    let Some(at) = accelerations(lines).get(index).copied() else {
        return Heading::default();
    };
    let titles = titles(lines, at);
    let event = titles
        .iter()
        .find(|line| line.to_ascii_uppercase().contains("EARTHQUAKE"));
    let (_, direction) = behind(titles, "COMPONENT=").unwrap_or_default();
    Heading {
        event: spaced(event.copied().unwrap_or_default()),
        station: spaced(titles.first().copied().unwrap_or_default()),
        component: heading::component(direction),
    }
}
