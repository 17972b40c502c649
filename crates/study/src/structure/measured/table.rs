//! Files of measurements, read by the names of their columns.

use super::column::Column;
use crate::source::faults::{Faults, quoted};
use crate::source::hint::nearest;
use crate::source::tree::Node;
use crate::structure::reading::reader::Reader;
use slipgap_problem::problem::structure::channels::measured_channels::Test;
use slipgap_system::system::measured_table::MeasuredTable;

/// Most bytes of a file.
const LARGEST: u64 = 64 << 20;

/// The content of a file, in the units of the study, and its bytes.
pub(in crate::structure) fn test(
    file: &str,
    (node, path): (&Node, &str),
    (time, columns): (&Column, &[&Column]),
    reader: &Reader,
    faults: &mut Faults,
) -> Option<(Test, Vec<u8>)> {
    let refuse = |why: String, (node, path): (&Node, &str), faults: &mut Faults| {
        faults.add(node.at, path, format!("{}: {why}", quoted(file)));
    };
    let of_file = (node, path);
    let bytes = match reader.folder.bytes(file, LARGEST) {
        Ok(bytes) => bytes,
        Err(why) => {
            refuse(why, of_file, faults);
            return None;
        }
    };
    let table = match MeasuredTable::read(file, &bytes) {
        Ok(table) => table,
        Err(why) => {
            refuse(format!("line {}: {}", why.line, why.cause), of_file, faults);
            return None;
        }
    };
    let mut numbers = |column: &Column, rise: bool| {
        let found = match rise {
            true => table.times(&column.name),
            false => table.column(&column.name),
        };
        let of_column = (column.place.0, column.place.1.as_str());
        match found {
            Ok(numbers) => {
                return Some(numbers.iter().map(|x| x * column.factor).collect());
            }
            Err(why) => {
                // The study has the name of a column that is not there, the file has the other faults.
                let known: Vec<&str> = table.names().iter().map(String::as_str).collect();
                let is_known = known.contains(&column.name.as_str());
                let hint = match nearest(&column.name, &known).filter(|_| !is_known) {
                    Some(near) => format!(", did you mean {}?", quoted(near)),
                    None => String::new(),
                };
                let origin = if is_known { of_file } else { of_column };
                refuse(
                    format!("line {}: {}{hint}", why.line, why.cause),
                    origin,
                    faults,
                );
            }
        }
        None
    };
    let time = numbers(time, true);
    let values: Vec<Option<Vec<f64>>> = columns
        .iter()
        .map(|column| numbers(column, false))
        .collect();
    let (time, values) = (time?, values.into_iter().collect::<Option<Vec<_>>>()?);
    Some((Test { time, values }, bytes))
}
