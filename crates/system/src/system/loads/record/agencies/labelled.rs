//! Files whose header has a label in each line: ESM and ITACA (DYNA), with one acceleration a line, and UNAM (ASA 2.0), with a column
//! for each channel.

use super::super::fault::{LineFault, RecordCause, fault};
use super::super::fortran_number::{Stated, before_end, fields, number};
use super::super::heading::{self, Heading, spaced};
use super::super::quantity::of_unit;
use super::super::{Doubt, Format, Parts, Reading, Record, Series, choice};
use super::stated::{count, ends, peak, positive, unit};
use crate::system::loads::Unit;

/// The format of ESM and ITACA.
pub(in super::super) const ESM: Format = Format {
    name: "ESM or ITACA",
    find: |lines| find(lines, &OF_ESM),
    read: |lines, reading| read(lines, reading, &OF_ESM),
    heading: |lines, reading| heading(lines, reading, &OF_ESM),
    parts: Parts::One,
};

/// The format of UNAM.
pub(in super::super) const UNAM: Format = Format {
    name: "UNAM (ASA 2.0)",
    find: |lines| find(lines, &OF_UNAM),
    read: |lines, reading| read(lines, reading, &OF_UNAM),
    heading: |lines, reading| heading(lines, reading, &OF_UNAM),
    parts: Parts::Columns,
};

/// The labels with which lines of a header begin.
struct Labels {
    /// Those of which a file has [`FEWEST`] or more; the numbers are behind them.
    marks: &'static [&'static str],
    /// Why a file without them is in another format.
    without: &'static str,
    step: &'static str,
    count: &'static str,
    /// Whether the file has as many rows: an excerpt of a file of several channels is read with a doubt.
    is_whole: bool,
    unit: &'static str,
    /// What the numbers are; none if always accelerations.
    quantity: Option<&'static str>,
    duration: &'static str,
    /// Label and unit of the peak.
    peak: (&'static str, Unit),
    event: &'static str,
    station: &'static str,
    component: &'static str,
}

const FEWEST: usize = 4;

/// Lines that are searched for labels.
const LINES: usize = 160;

const OF_ESM: Labels = Labels {
    marks: &[
        "EVENT_NAME:",
        "STATION_CODE:",
        "SAMPLING_INTERVAL_S:",
        "NDATA:",
        "STREAM:",
        "UNITS:",
        "PGA_CM/S^2:",
        "DATA_TYPE:",
        "HEADER_FORMAT:",
    ],
    without: "no 4 of its lines begin with labels such as \"SAMPLING_INTERVAL_S:\" and \"NDATA:\"",
    step: "SAMPLING_INTERVAL_S",
    count: "NDATA",
    is_whole: true,
    unit: "UNITS",
    quantity: Some("DATA_TYPE"),
    duration: "DURATION_S",
    peak: ("PGA_CM/S^2", Unit::CentimetrePerSecond2),
    event: "EVENT_NAME",
    station: "STATION_CODE",
    component: "STREAM",
};

const OF_UNAM: Labels = Labels {
    marks: &[
        "ARCHIVO ESTANDAR DE ACELERACION",
        "VERSION DEL FORMATO",
        "ORIENTACION C1-C6",
        "INTERVALO DE MUESTREO",
        "NUM. TOTAL DE MUESTRAS",
        "UNIDADES DE LOS DATOS",
        "DATOS DE ACELERACION",
    ],
    without: "no 4 of its lines begin with labels such as \"VERSION DEL FORMATO\" and \"INTERVALO DE MUESTREO\"",
    step: "INTERVALO DE MUESTREO",
    count: "NUM. TOTAL DE MUESTRAS",
    is_whole: false,
    unit: "UNIDADES DE LOS DATOS",
    quantity: None,
    duration: "DURACION DEL REGISTRO",
    peak: ("ACEL. MAX.(Gal)", Unit::CentimetrePerSecond2),
    event: "FECHA DEL SISMO",
    station: "CLAVE DE LA ESTACION",
    component: "ORIENTACION C",
};

/// Whether a file has enough of the labels, and its rows are not those of a table of times; else why not.
fn find(lines: &[&str], labels: &Labels) -> Result<(), &'static str> {
    let head = &lines[..lines.len().min(LINES)];
    let has = |mark: &&&str| {
        head.iter()
            .any(|line| line.trim_start().starts_with(**mark))
    };
    if labels.marks.iter().filter(has).count() < FEWEST {
        return Err(labels.without);
    }
    let first = body(lines, labels)
        .next()
        .map(|(_, line)| fields(line).count());
    match (first, values(lines, labels.step).len()) {
        (Some(2), 1) => Err("its rows have two numbers, as those of a table"),
        _ => Ok(()),
    }
}

/// The values behind a label, each with the index of its line: one, or one for each channel, `/0.01/0.01`, also in several lines.
fn values<'a>(lines: &[&'a str], label: &str) -> Vec<(usize, &'a str)> {
    let of = |(i, line): (usize, &&'a str)| {
        let tail = line.trim_start().strip_prefix(label)?;
        let rest = tail.split_once(':').map_or("", |(_, rest)| rest).trim();
        let by = if rest.starts_with('/') { "/" } else { ":" };
        let values = rest.split(by).map(str::trim);
        Some(
            values
                .filter(|value| !value.is_empty())
                .map(move |value| (i, value)),
        )
    };
    let head = lines.iter().take(LINES).enumerate();
    head.filter_map(of).flatten().collect()
}

/// The value of a channel behind a label.
fn value<'a>(
    lines: &[&'a str],
    label: &'static str,
    channel: usize,
) -> Result<(usize, &'a str), LineFault> {
    let values = values(lines, label);
    let missing = || fault(0, RecordCause::NoLine(label));
    values.get(channel).copied().ok_or_else(missing)
}

fn read(lines: &[&str], reading: &Reading, labels: &Labels) -> Series {
    let lines = before_end(lines)?;
    let steps = values(lines, labels.step).len();
    let directions = values(lines, labels.component);
    let names: Vec<String> = (0..steps)
        .map(|i| directions.get(i).map_or("", |pair| pair.1).to_owned())
        .collect();
    let channel = match steps {
        0 => 0,
        _ => choice("column", &names, reading.column)?,
    };
    let (step_line, step) = value(lines, labels.step, channel)?;
    let step = positive(step, labels.step, step_line)?;
    let (count_line, points) = value(lines, labels.count, channel)?;
    let points = count(points, labels.count, count_line)?;
    let units = units(lines, labels)?;
    let rows = rows(lines, labels, (steps, step_line))?;
    let accelerations: Vec<f64> = rows.iter().map(|row| row[channel]).collect();
    let mut record = Record::even(accelerations, step, units);
    let found = record.times.len();
    if found < 2 {
        return Err(fault(count_line, RecordCause::OneRow));
    }
    let stated = Stated::new(points, labels.count, count_line);
    if found as f64 != points {
        let cause = RecordCause::Rows(found, stated.place(), points);
        match labels.is_whole {
            true => return Err(fault(count_line, cause)),
            false => record.doubts.push(Doubt::new(count_line, cause)),
        }
    } else {
        // An excerpt has another peak and duration.
        let stated = |label| value(lines, label, channel).ok();
        let (by, unit) = labels.peak;
        let of_peak =
            stated(by).and_then(|(line, text)| peak(&record, (text, Some(unit)), (by, line)));
        let of_end = stated(labels.duration)
            .and_then(|(line, text)| ends(points * step, (step, text), (labels.duration, line)));
        record.doubts.extend(of_peak.into_iter().chain(of_end));
    }
    Ok((record, Some(Stated::new(step, labels.step, step_line))))
}

/// The unit of the numbers, which must be accelerations.
fn units(lines: &[&str], labels: &Labels) -> Result<Option<Unit>, LineFault> {
    let quantity = labels
        .quantity
        .and_then(|label| value(lines, label, 0).ok());
    if let Some((line, text)) = quantity {
        let text = text.to_ascii_lowercase();
        let others = [
            ("spectr", "response spectrum"),
            ("veloc", "velocity"),
            ("displ", "displacement"),
        ];
        if let Some((_, other)) = others.into_iter().find(|pair| text.contains(pair.0)) {
            return Err(fault(line, RecordCause::Quantity(other)));
        }
    }
    let Ok((line, text)) = value(lines, labels.unit, 0) else {
        return Ok(None);
    };
    match (unit(text), of_unit(text)) {
        (Some((unit, _)), _) => Ok(Some(unit)),
        (None, Some(other)) => Err(fault(line, RecordCause::Quantity(other))),
        (None, None) => Ok(None),
    }
}

/// The rows of numbers behind the labels, one number for each of the channels that the header has in a line.
fn rows(
    lines: &[&str],
    labels: &Labels,
    (channels, at): (usize, usize),
) -> Result<Vec<Vec<f64>>, LineFault> {
    let mut rows = Vec::new();
    for (index, line) in body(lines, labels).filter(|(_, line)| !line.trim().is_empty()) {
        let row = numbers(line).map_err(|cause| fault(index, cause))?;
        if row.len() != channels {
            let source = format!("{} of line {}", labels.step, at + 1);
            let cause = RecordCause::Channels(row.len(), source, channels);
            return Err(fault(index, cause));
        }
        rows.push(row);
    }
    Ok(rows)
}

/// The lines from the first row of numbers behind the labels on, with their indices.
fn body<'a>(lines: &'a [&str], labels: &Labels) -> impl Iterator<Item = (usize, &'a str)> {
    let begins = |line: &&str| {
        labels
            .marks
            .iter()
            .any(|mark| line.trim_start().starts_with(mark))
    };
    let last = lines
        .iter()
        .take(LINES)
        .rposition(begins)
        .unwrap_or_default();
    let body = lines.iter().copied().enumerate().skip(last + 1);
    body.skip_while(|(_, line)| !numbers(line).is_ok_and(|row| !row.is_empty()))
}

/// The numbers of a line.
fn numbers(line: &str) -> Result<Vec<f64>, RecordCause> {
    fields(line).map(number).collect()
}

fn heading(lines: &[&str], reading: &Reading, labels: &Labels) -> Heading {
    let of = |label, index| value(lines, label, index).map_or("", |pair| pair.1);
    let column = reading.column.unwrap_or(1).saturating_sub(1);
    Heading {
        event: spaced(of(labels.event, 0)).replace('/', "-"),
        station: spaced(of(labels.station, 0)),
        component: heading::component(of(labels.component, column)),
    }
}
