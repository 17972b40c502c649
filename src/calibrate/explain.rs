//! What `slipgap calibrate` would search, in words.

use super::usage;
use super::used;
use slipgap_problem::problem::numbers::parameter::shortest;
use slipgap_study::{Free, Study};

/// Lines about the free parameters of a study and the cost of their search; empty without `calibrate`.
pub fn explained(study: &Study) -> String {
    let Some(calibrate) = &study.calibrate else {
        return String::new();
    };
    let table = study.problem.parameters();
    let names = |free: &[Free]| {
        let names = free
            .iter()
            .map(|free_parameter| &*table[free_parameter.parameter].name);
        names.collect::<Vec<&str>>().join(", ")
    };
    let range = |free_parameter: &Free| {
        let [low, high] = free_parameter.range.ends.map(shortest);
        let log = if free_parameter.range.log {
            " by its logarithm"
        } else {
            ""
        };
        format!(
            "{} from {low} to {high}{log}",
            table[free_parameter.parameter].name
        )
    };
    let ranges: Vec<String> = calibrate.free.iter().map(range).collect();
    let alternatives = study.alternatives();
    let tests = alternatives
        .first()
        .map_or(1, |alternative| alternative.cases());
    let mut text = format!(
        "calibrate: minimises {}; free: {}\n",
        study.measures[calibrate.minimise].name,
        ranges.join(", ")
    );
    let points = match tests {
        1 => String::new(),
        tests => format!(", {tests} for each point, one of each test"),
    };
    let each = match calibrate.varies.is_empty() {
        true => points,
        false => format!("{points}; and as much for each test alone"),
    };
    text += &match alternatives.len() {
        1 => format!(
            "calibrate: a search of up to {} cases, then profiles{each}\n",
            calibrate.cases / 4 * 3
        ),
        count => format!(
            "calibrate: {count} alternatives, each with a search of up to {} cases, then profiles{each}\n",
            calibrate.cases / 4 * 3
        ),
    };
    for alternative in &alternatives {
        let [free, unused] = used(study, alternative);
        let apart = usage::apart(study, alternative, &free);
        let prefix = match alternative.name.as_str() {
            "" => "calibrate: ".to_owned(),
            name => format!("calibrate: {name}: "),
        };
        if !unused.is_empty() {
            text += &format!("{prefix}does not use {}\n", names(&unused));
        }
        if !apart.is_empty() {
            text += &format!(
                "{prefix}masses, stiffnesses or dashpots follow from {}: cases are solved one by one, not side by side, which takes \
                 several times as long\n",
                names(&apart)
            );
        }
    }
    text
}
