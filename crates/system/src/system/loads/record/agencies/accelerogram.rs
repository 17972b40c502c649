//! The layout of CSMIP (CDMG), which RENADIC, USC and BHRC have, too: channels one after the other, each with lines of text, 100 whole
//! numbers, 50 or 100 numbers, then pairs of a time and an acceleration, or a line that says how many accelerations follow how far
//! apart. A corrected file (V2) has velocities and displacements behind them. BHRC has accelerations without such a line.

use super::super::fault::{LineFault, RecordCause, fault};
use super::super::fortran_number::{Stated, block, fields, table};
use super::super::heading::{self, Heading, spaced};
use super::super::{Doubt, Format, Parts, Reading, Record, Series, component};
use super::channel::{Channel, channels};
use super::stated::{behind, count, ends, peak, positive, unit};
use crate::system::loads::Unit;

/// The format.
pub(in super::super) const FORMAT: Format = Format {
    name: "CSMIP, RENADIC, USC or BHRC (V1 or V2)",
    find: |lines| match marks(lines) {
        FEWEST.. if has_whole(lines) => Ok(()),
        FEWEST.. => Err("its header has no row of 10 whole numbers or more"),
        _ => Err("its header has less than 3 words such as \"ACCELEROGRAM\" and \"INSTR PERIOD\""),
    },
    read,
    heading,
    parts: Parts::Components,
};

/// Phrases of the header, and how many of them a file has at least.
const MARKS: [&str; 14] = [
    "ACCELEROGRAM",
    "INSTR PERIOD",
    "SENSITIVITY",
    "CHAN",
    "STATION NO",
    "USC#",
    "RMS ACC",
    "RECORD LENGTH",
    "UNCOR",
    "NO. OF POINTS",
    "POINTS OF INSTRUMENT",
    "SEC AND G",
    "SECONDS AND G",
    BHRC,
];
const FEWEST: usize = 3;

/// A mark of BHRC, whose data are no pairs.
const BHRC: &str = "VOL1DS";

/// Lines that are searched for marks, and for the first row of whole numbers.
const LINES: [usize; 2] = [30, 80];

fn marks(lines: &[&str]) -> usize {
    let head = &lines[..lines.len().min(LINES[0])];
    let has = |mark: &&&str| behind(head, mark).is_some();
    MARKS.iter().filter(has).count()
}

fn has_whole(lines: &[&str]) -> bool {
    !channels(&lines[..lines.len().min(LINES[1])]).is_empty()
}

/// The record of a channel.
fn read(lines: &[&str], reading: &Reading) -> Series {
    let channels = channels(lines);
    let names: Vec<String> = channels
        .iter()
        .map(|channel| name(text(lines, channel)))
        .collect();
    let channel = &channels[component(&names, reading.component)?];
    let head = text(lines, channel);
    if let Some((line, _)) = behind(head, "SPECTRA") {
        let cause = RecordCause::Quantity("response spectrum");
        return Err(fault(channel.text + line, cause));
    }
    let first = lines.get(channel.data).copied().unwrap_or_default();
    let has_words = first.contains(|c: char| c.is_ascii_alphabetic() && !"eEdD".contains(c));
    let (mut record, step) = match (has_words, behind(head, BHRC)) {
        (true, _) => counted(lines, channel.data)?,
        (false, Some(_)) => even(lines, channel)?,
        (false, None) => pairs(lines, channel)?,
    };
    let stated = ["PEAK ACCELERATION", " MAX "]
        .into_iter()
        .find_map(|by| Some((by, behind(head, by)?)));
    if let Some((by, (line, text))) = stated {
        let doubt = peak(&record, (text, None), (by.trim(), channel.text + line));
        record.doubts.extend(doubt);
    }
    Ok((record, step))
}

/// The text of a channel.
fn text<'a, 'b>(lines: &'a [&'b str], channel: &Channel) -> &'a [&'b str] {
    &lines[channel.text..channel.whole]
}

/// The accelerations behind a line such as `3251 POINTS OF ACCEL DATA EQUALLY SPACED AT .020 SEC. (UNITS: CM/SEC/SEC)`, or
/// `13200 Accelerogram points at 200 pts/sec in units of g`.
fn counted(lines: &[&str], at: usize) -> Series {
    let line = lines[at].trim().to_ascii_uppercase();
    let other = ["VELOC", "DISPL"]
        .into_iter()
        .find(|word| line.contains(word));
    if let (false, Some(other)) = (line.contains("ACC"), other) {
        let other = if other == "VELOC" {
            "velocity"
        } else {
            "displacement"
        };
        return Err(fault(at, RecordCause::Quantity(other)));
    }
    let points = count(&line, "the number of points", at)?;
    let Some((_, step)) = line.split_once(" AT ") else {
        return Err(fault(at, RecordCause::NoLine("points ... at ... sec")));
    };
    let step = step.trim_start();
    let per = step.split_whitespace().nth(1).unwrap_or_default();
    let step = match (positive(step, "the time step", at)?, per.contains("/SEC")) {
        (rate, true) => 1.0 / rate,
        (step, false) => step,
    };
    let after_word = line.split_once("UNITS").or_else(|| line.split_once(" IN "));
    let units = after_word.and_then(|(_, rest)| unit(rest));
    let source = format!("the number of points of line {}", at + 1);
    let values = block(lines, at + 1, points, &source)?;
    let stated = Stated::new(step, "the time step", at);
    Ok((scaled(values, step, units), Some(stated)))
}

/// The accelerations of a channel of BHRC.
fn even(lines: &[&str], channel: &Channel) -> Series {
    let (points, source) = points(lines, channel)?;
    // Its rows of eight numbers are cut.
    let second = channel.numbers + 1;
    let numbers = table(lines, second, 1)?;
    let rate = numbers.first().copied().unwrap_or_default();
    if rate <= 0.0 {
        let cause =
            RecordCause::NotPositive("number 9 of the header, the samples per second,", rate);
        return Err(fault(second, cause));
    }
    let values = block(lines, channel.data, points, &source)?;
    let mut record = scaled(values, 1.0 / rate, units(lines, channel)?);
    record.doubts.extend(end(lines, channel, &record));
    let by = "the sampling rate (number 9 of the header)";
    let stated = Stated::new(1.0 / rate, by, second);
    Ok((record, Some(stated)))
}

/// The pairs of a channel.
fn pairs(lines: &[&str], channel: &Channel) -> Series {
    let (points, source) = points(lines, channel)?;
    let source = format!("twice {source}");
    let numbers = block(lines, channel.data, 2.0 * points, &source)?;
    let units = units(lines, channel)?;
    let mut record = scaled(Vec::new(), 0.0, units);
    let divisor = units.map_or(1.0, |units| units.1);
    let row = fields(lines[channel.data]).count().max(1);
    for (i, pair) in numbers.chunks_exact(2).enumerate() {
        let (t, a) = (pair[0], pair[1]);
        if let Some(&last) = record.times.last().filter(|last| t <= **last) {
            let line = channel.data + 2 * i / row;
            return Err(fault(line, RecordCause::Time { t, last }));
        }
        record.times.push(t);
        record.values.push(a / divisor);
    }
    record.doubts.extend(end(lines, channel, &record));
    let times = &record.times;
    let step = (times[times.len() - 1] - times[0]) / (times.len() - 1) as f64;
    let mut between = times.windows(2).map(|pair| pair[1] - pair[0]);
    let is_even = between.all(|dt| (dt - step).abs() <= EVEN * step);
    let stated = is_even.then(|| Stated::new(step, "the times", channel.data));
    Ok((record, stated))
}

/// Largest share by which even steps differ.
const EVEN: f64 = 1e-3;

/// The number of points that the text states, and where.
fn points(lines: &[&str], channel: &Channel) -> Result<(f64, String), LineFault> {
    const BY: &str = "NO. OF POINTS";
    let head = text(lines, channel);
    let Some((line, rest)) = behind(head, BY) else {
        return Err(fault(channel.whole, RecordCause::NoLine(BY)));
    };
    let line = channel.text + line;
    Ok((count(rest, BY, line)?, format!("{BY} of line {}", line + 1)))
}

/// The unit that the text states; none if it is unknown. Without its line, tenths of g would be taken for g.
fn units(lines: &[&str], channel: &Channel) -> Result<Option<(Unit, f64)>, LineFault> {
    const BY: &str = "UNITS";
    match behind(text(lines, channel), BY) {
        Some((_, rest)) => Ok(unit(rest)),
        None => Err(fault(channel.whole, RecordCause::NoLine(BY))),
    }
}

/// Accelerations in a unit, divided by a number.
fn scaled(values: Vec<f64>, step: f64, units: Option<(Unit, f64)>) -> Record {
    let divisor = units.map_or(1.0, |units| units.1);
    let values = values.into_iter().map(|a| a / divisor).collect();
    Record::even(values, step, units.map(|units| units.0))
}

/// The doubt about a record that does not end where its header says.
fn end(lines: &[&str], channel: &Channel, record: &Record) -> Option<Doubt> {
    let head = text(lines, channel);
    let stated = ["RECORD LENGTH", "DURATION"].into_iter();
    let (by, (line, rest)) = stated
        .into_iter()
        .find_map(|by| Some((by, behind(head, by)?)))?;
    let (end, count) = (*record.times.last()?, record.times.len() as f64);
    ends(end, (end / count, rest), (by, channel.text + line))
}

/// The channel as the text names it.
fn name(head: &[&str]) -> String {
    let [label, direction] = channel_words(head);
    spaced(&format!("{label} {direction}"))
}

/// `CHAN  1:` or `COMP`, and the direction behind it.
fn channel_words(head: &[&str]) -> [String; 2] {
    let begins = |line: &&&str| {
        let line = line.trim_start().to_ascii_uppercase();
        line.starts_with("CHAN") || line.starts_with("COMP")
    };
    let line = head.iter().find(begins).copied().unwrap_or_default().trim();
    let end = line
        .find(':')
        .map_or(line.len().min("COMP".len()), |i| i + 1);
    let (label, rest) = line.split_at_checked(end).unwrap_or((line, ""));
    // Numbers of columns, and of the channel at the station, are behind it.
    let rest = rest.split('(').next().unwrap_or_default().trim();
    let direction = rest.split("   ").next().unwrap_or_default();
    [label, direction].map(spaced)
}

/// The event, the station and the direction of the channel.
fn heading(lines: &[&str], reading: &Reading) -> Heading {
    let channels = channels(lines);
    let index = reading.component.unwrap_or(1).saturating_sub(1);
    let Some(channel) = channels.get(index) else {
        return Heading::default();
    };
    let head = text(lines, channel);
    let column = |line: &str| spaced(line.trim().split("   ").next().unwrap_or_default());
    let data = head
        .iter()
        .rposition(|line| line.to_ascii_uppercase().contains("ACCELEROGRAM DATA"));
    let event = data.and_then(|line| head.get(line + 1));
    let label = head.iter().position(|line| {
        let line = line.trim_start().to_ascii_uppercase();
        line.starts_with("STATION NO") || line.starts_with("STATION USC")
    });
    let station = label.and_then(|line| head.get(line + 1));
    let [_, direction] = channel_words(head);
    Heading {
        event: event.map(|line| column(line)).unwrap_or_default(),
        station: station.map(|line| column(line)).unwrap_or_default(),
        component: heading::component(&direction),
    }
}
