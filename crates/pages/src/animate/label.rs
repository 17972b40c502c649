//! The parameters of a case in words.

use super::film::short_numbers;
use slipgap_problem::problem::Case;
use slipgap_problem::problem::numbers::parameter::{Parameter, Value};
use slipgap_study::{Axis, Study};

/// Most parameters that a label names.
const MOST: usize = 6;

/// For each case the parameters that differ between the cases, or else those that differ between the cases of the study.
pub fn labels(study: &Study, cases: &[&Case]) -> Vec<String> {
    let table = study.problem.parameters();
    let differs = |row: usize| {
        let first = cases.first().map(|case| case.values[row]);
        cases.iter().any(|case| Some(case.values[row]) != first)
    };
    let is_axis = |row: usize| {
        let of_blocks = study.blocks.iter().flat_map(|block| &block.groups);
        let mut groups = of_blocks.filter(|group| group.len() > 1);
        // Of parameters that change together a name says all, but not that of a file.
        groups.any(|group| {
            let is_name = |axis: &&Axis| matches!(axis.values.at(0), Value::Name(name) if !name.contains('/'));
            let named = group.axes.iter().find(is_name);
            let is_named = named.map(|axis| axis.parameter == row);
            is_named.unwrap_or_else(|| group.axes.iter().any(|axis| axis.parameter == row))
        })
    };
    let different: Vec<usize> = (0..table.len()).filter(|row| differs(*row)).collect();
    let named: Vec<usize> = match different.is_empty() {
        true => (0..table.len()).filter(|row| is_axis(*row)).collect(),
        // What follows from others says nothing new.
        false if different.iter().any(|row| is_axis(*row)) => {
            different.into_iter().filter(|row| is_axis(*row)).collect()
        }
        false => different,
    };
    let label = |case: &&Case| {
        let shown = named.iter().filter_map(|row| {
            let value = case.values[*row]?;
            Some(format!(
                "{} = {}",
                table[*row].name,
                words(&table[*row], value)
            ))
        });
        let values: Vec<String> = shown.collect();
        let more = match values.len() > MOST {
            true => ", …",
            false => "",
        };
        format!("{}{more}", values[..values.len().min(MOST)].join(", "))
    };
    cases.iter().map(label).collect()
}

/// A value with at most five significant digits.
fn words(parameter: &Parameter, value: Value) -> String {
    match value {
        Value::Number(x) => {
            let x = short_numbers::digits(x, 5);
            match x == 0.0 || (1e-4..1e6).contains(&x.abs()) {
                true => x.to_string(),
                false => format!("{x:e}"),
            }
        }
        Value::Whole(n) => n.to_string(),
        Value::Name(name) => parameter.shown(name).to_owned(),
    }
}
