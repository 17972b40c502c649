//! The keys of a record that say how its file is read: values, or parameters that choose them.

use crate::source::faults::{Faults, any_of, quoted};
use crate::source::object::Object;
use crate::source::tree::Node;
use crate::structure::keys::{FUNCTION, MOST};
use crate::structure::reading::reader::Reader;
use crate::value::number;
use slipgap_problem::problem::numbers::parameter::{Kind, Value, shortest};
use slipgap_system::system::loads::Unit;
use slipgap_system::system::loads::record::{Mean, Reading};

/// Why a file gives no signal, and the key of the function that contradicts it; without one, the file itself is at fault.
pub(super) type Fault = (Option<&'static str>, String);

/// The keys of a record.
pub(super) struct RecordKeys {
    unit: Given<Unit>,
    mean: Option<Mean>,
    column: Given<f64>,
    dt: Given<f64>,
    component: Given<f64>,
}

/// The value of a key, or the row of the parameter that has it.
#[derive(Debug, Clone, Copy)]
enum Given<T> {
    Is(Option<T>),
    Chosen(usize),
}

impl RecordKeys {
    /// The keys of a function.
    pub fn of(function: &Object, reader: &Reader, faults: &mut Faults) -> Option<RecordKeys> {
        let before = faults.count();
        let mean = function.choice("mean", &Mean::ALL, faults);
        let unit = match function.get("unit") {
            None => Some(Given::Is(None)),
            Some(node) => match chosen(node, true, reader) {
                Some(row) => Some(Given::Chosen(row)),
                None => {
                    let unit = function.choice("unit", &Unit::ALL, faults);
                    unit.map(|unit| Given::Is(Some(unit)))
                }
            },
        };
        let mut numeric = |key: &'static str| {
            let Some((node, path)) = function.given(key, faults) else {
                return Some(Given::Is(None));
            };
            if let Some(row) = chosen(node, false, reader) {
                reader.used.borrow_mut().insert(row);
                return Some(Given::Chosen(row));
            }
            let x = number(node, &path, FUNCTION.range(key), faults)?;
            match checked(key, x) {
                Ok(x) => Some(Given::Is(Some(x))),
                Err(why) => {
                    faults.add(node.at, &path, why);
                    None
                }
            }
        };
        let [column, dt, component] = ["column", "dt", "component"].map(&mut numeric);
        let keys = RecordKeys {
            unit: unit?,
            mean,
            column: column?,
            dt: dt?,
            component: component?,
        };
        (faults.count() == before).then_some(keys)
    }

    /// The rows of the parameters that choose values.
    pub fn rows(&self) -> Vec<usize> {
        let unit = match self.unit {
            Given::Chosen(row) => Some(row),
            Given::Is(_) => None,
        };
        let numbers = [self.column, self.dt, self.component].map(|key| match key {
            Given::Chosen(row) => Some(row),
            Given::Is(_) => None,
        });
        unit.into_iter()
            .chain(numbers.into_iter().flatten())
            .collect()
    }

    /// Unit and reading with these values of parameters, by their rows.
    pub fn with(&self, values: &[(usize, Value)]) -> Result<(Option<Unit>, Reading), Fault> {
        let of = |row: usize| {
            values
                .iter()
                .find(|value| value.0 == row)
                .map(|value| value.1)
        };
        let unit = match self.unit {
            Given::Is(unit) => unit,
            Given::Chosen(row) => {
                let given = of(row).map_or("", Value::name);
                let unit = Unit::ALL.into_iter().find(|unit| unit.name() == given);
                let names = Unit::ALL.map(Unit::name);
                let why = || {
                    format!(
                        "unknown unit {}; allowed: {}",
                        quoted(given),
                        any_of(&names)
                    )
                };
                Some(unit.ok_or_else(|| (Some("unit"), why()))?)
            }
        };
        let number = |key: &'static str, given: Given<f64>| match given {
            Given::Is(x) => Ok(x),
            Given::Chosen(row) => {
                let x = of(row).and_then(Value::as_f64).unwrap_or(f64::NAN);
                checked(key, x).map(Some).map_err(|why| (Some(key), why))
            }
        };
        let whole = |key, given| number(key, given).map(|x| x.map(|x| x as usize));
        let reading = Reading {
            mean: self.mean,
            column: whole("column", self.column)?,
            dt: number("dt", self.dt)?,
            component: whole("component", self.component)?,
        };
        Ok((unit, reading))
    }

    /// Whether the study says what happens to the mean.
    pub fn has_mean(&self) -> bool {
        self.mean.is_some()
    }
}

/// The row of the parameter that a text names, of names or of numbers.
fn chosen(node: &Node, of_names: bool, reader: &Reader) -> Option<usize> {
    let text = node.text()?;
    let row = reader.table.iter().position(|row| row.name == text)?;
    (matches!(reader.table[row].kind, Kind::Choice(_)) == of_names).then_some(row)
}

/// A number of a key, if it is allowed.
fn checked(key: &str, x: f64) -> Result<f64, String> {
    let range = FUNCTION.range(key);
    let is_place = key != "dt";
    match range.contains(x) && (!is_place || x.fract() == 0.0 && x <= MOST as f64) {
        true => Ok(x),
        false if is_place => Err(format!(
            "must be a whole number from 1 to {MOST}, got {}",
            shortest(x)
        )),
        false => Err(format!("must be {range}, got {}", shortest(x))),
    }
}
