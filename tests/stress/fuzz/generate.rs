//! Studies generated from the tables of the problems: many are valid, most of the others nearly.

use crate::random_choice::RandomChoice;
use crate::words::{NUMBERS, STRINGS, TITLES};
use slipgap::problem::numbers::parameter::{ColumnRule, Default, Kind, Parameter};
use slipgap::problem::{PROBLEMS, Problem};

/// The text of a study.
pub fn study(random: &mut RandomChoice) -> String {
    let problem = &PROBLEMS[random.below(PROBLEMS.len())];
    let mut keys = vec![
        format!("\"problem\": \"{}\"", problem.name()),
        match random.below(4) {
            0 => format!(
                "\"blocks\": [{}, {}]",
                braced(block(&**problem, random)),
                braced(block(&**problem, random))
            ),
            _ => block(&**problem, random).join(", "),
        },
    ];
    let ensemble = ensemble(&**problem, &keys[1], random);
    if let Some(over) = &ensemble {
        keys.push(format!("\"ensemble\": {}", quoted(over)));
    }
    let some = |count: usize| 0..count;
    if random.once_in(3) {
        let metrics = some(2).map(|_| quoted(metric(&**problem, random)));
        keys.push(format!(
            "\"metrics\": [{}]",
            metrics.collect::<Vec<_>>().join(", ")
        ));
    }
    let count = [0, 1, 1, 2][random.below(4)];
    let figure_list: Vec<String> = some(count)
        .map(|i| figure(&**problem, i, ensemble.is_some(), random))
        .collect();
    let mut figures = figure_list.join(", ");
    if random.once_in(6) {
        // Some figures show it instead of the metric.
        let metric = metric(&**problem, random);
        let word = random.of(&["least", "worst", "mean", "quantile 0.9 of"]);
        let over = match random.once_in(4) {
            true => parameter(&**problem, random),
            false => problem.schema().step_name(),
        };
        let text = format!("{word} {metric} over {over}");
        figures = figures.replace(&format!("[\"{metric}\"]"), &format!("[\"{text}\"]"));
        keys.push(format!("\"reductions\": [\"{text}\"]"));
    }
    keys.push(format!("\"figures\": [{figures}]"));
    if random.once_in(4) {
        let (metric, limit) = (metric(&**problem, random), number(random));
        keys.push(format!(
            "\"checks\": [{{\"metric\": \"{metric}\", \"max\": {limit}}}]"
        ));
    }
    if random.once_in(10) {
        keys.push("\"iteration\": \"once\"".into());
    }
    braced(keys)
}

/// A parameter of an ensemble: mostly none, or one that has a list of values in the text of the blocks.
fn ensemble(problem: &dyn Problem, blocks: &str, random: &mut RandomChoice) -> Option<String> {
    if !random.once_in(4) {
        return None;
    }
    let table = problem.parameters().iter();
    let is_listed = |row: &&Parameter| blocks.contains(&format!("\"{}\": [", row.name));
    let listed: Vec<&Parameter> = table.filter(is_listed).collect();
    if random.once_in(20) {
        return Some(parameter(problem, random).to_owned());
    }
    let row = listed.get(random.below(listed.len().max(1)))?;
    Some(row.name.to_string())
}

fn braced(keys: Vec<String>) -> String {
    format!("{{{}}}", keys.join(", "))
}

fn quoted(text: &str) -> String {
    format!("\"{text}\"")
}

fn metric<'a>(problem: &'a dyn Problem, random: &mut RandomChoice) -> &'a str {
    // Mostly one that needs no mention in "metrics".
    let any = random.once_in(4);
    let metrics = problem.metrics().iter();
    let table: Vec<_> = metrics.filter(|metric| any || metric.default).collect();
    &table[random.below(table.len())].name
}

fn parameter<'a>(problem: &'a dyn Problem, random: &mut RandomChoice) -> &'a str {
    // Mostly one of those that a study is likely to give.
    let any = random.once_in(8);
    let table: Vec<_> = problem
        .parameters()
        .iter()
        .filter(|row| any || row.column == ColumnRule::Always)
        .collect();
    &table[random.below(table.len())].name
}

/// The keys of a block: parameters, and sometimes `design`, `when` or `zip`.
fn block(problem: &dyn Problem, random: &mut RandomChoice) -> Vec<String> {
    let mut given: Vec<String> = Vec::new();
    let mut right: Vec<String> = Vec::new();
    let mut sampled = false;
    for row in problem.parameters() {
        let likely = match (&*row.name, &row.default) {
            // One of these two is given, and the other is computed from it.
            ("k_I", _) => random.once_in(20),
            ("gamma", _) => !random.once_in(20),
            (_, Default::Required) => !random.once_in(40),
            _ => random.once_in(5),
        };
        // One law and one method for all cases, with their own parameters.
        let suits = row.applies.as_ref().is_none_or(|on| {
            let value = given.iter().find_map(|key| {
                let value = key.strip_prefix(&format!("\"{}\": \"", on.governor))?;
                value.strip_suffix('"')
            });
            let governor = problem.parameters().iter().find(|p| p.name == on.governor);
            let default = match governor.map(|p| &p.default) {
                Some(Default::Is(value)) => value.name(),
                _ => "",
            };
            on.allows(value.unwrap_or(default))
        });
        let wanted = match suits {
            false => random.once_in(200),
            true => likely,
        };
        if !wanted {
            continue;
        }
        let value = value(row, &mut sampled, random);
        match row.name.strip_prefix("right.") {
            Some(key) => right.push(format!("\"{key}\": {value}")),
            None => given.push(format!("\"{}\": {value}", row.name)),
        }
    }
    if !right.is_empty() && !given.iter().any(|key| key.starts_with("\"right\"")) {
        given.push(format!("\"right\": {}", braced(right)));
    }
    let mut keys = vec![format!("\"parameters\": {}", braced(given))];
    if sampled {
        let kind = random.of(&["latin-hypercube", "sobol", "saltelli"]);
        let n = 2 + random.below(4);
        keys.push(format!("\"design\": {{\"kind\": \"{kind}\", \"n\": {n}}}"));
    }
    if random.once_in(12) {
        let (a, b) = (parameter(problem, random), parameter(problem, random));
        let test = random.of(&["<", ">=", "!="]);
        keys.push(format!(
            "\"when\": \"{a} {test} {} or {b} < 1\"",
            number(random)
        ));
    }
    if random.once_in(20) {
        let (a, b) = (parameter(problem, random), parameter(problem, random));
        keys.push(format!("\"zip\": [[\"{a}\", \"{b}\"]]"));
    }
    keys
}

/// A value of a parameter, mostly for a short run.
fn value(row: &Parameter, sampled: &mut bool, random: &mut RandomChoice) -> String {
    if let Kind::Choice(choices) = row.kind {
        // `block` gives the width of the first law.
        let chosen = if random.once_in(4) {
            random.below(choices.len())
        } else {
            0
        };
        return quoted(choices[chosen].0);
    }
    if random.once_in(60) {
        return quoted(random.of(&STRINGS));
    }
    let ends = match &*row.name {
        "n" | "right.n" => (1.0, 6.0),
        "dt" | "dT" => (0.05, 0.5),
        "duration" => (0.6, 7.0),
        "x0" => (-13.0, 13.0),
        "V0" => (0.05, 0.2),
        "right.V0" => (-0.2, 0.04),
        "gap" => (0.0, 0.5),
        "restitution" | "nu_ratio" | "rho_inf" => (0.2, 1.0),
        "theta" => (0.5, 1.0),
        "hht_alpha" => (-0.33, 0.0),
        "static_ratio" | "exponent" => (1.0, 1.5),
        _ => (0.1, 12.0),
    };
    let one = |random: &mut RandomChoice| match (random.once_in(25), row.kind) {
        (true, _) => number(random),
        (_, Kind::Whole { .. }) => random.between(ends.0, ends.1).round().to_string(),
        _ => random.between(ends.0, ends.1).to_string(),
    };
    let (a, b) = (one(random), one(random));
    let whole = matches!(row.kind, Kind::Whole { .. });
    match random.below(16) {
        0 => format!("[{a}, {b}]"),
        1 => format!("[{a}, {b}, {}]", one(random)),
        2 => format!("{{\"linspace\": [{a}, {b}, {}]}}", 2 + random.below(4)),
        3 => format!("{{\"geomspace\": [{a}, {b}, {}]}}", 2 + random.below(4)),
        4 => {
            *sampled = true;
            let kind = random.of(&["uniform", "loguniform"]);
            let in_order = a.parse::<f64>().ok() < b.parse::<f64>().ok();
            let (a, b) = if in_order { (a, b) } else { (b, a) };
            format!("{{\"{kind}\": [{a}, {b}]}}")
        }
        5 if !whole => format!("\"{a} * 1.5\""),
        6 if row.name != "duration" => format!("\"{a} + 0 * duration\""),
        _ => a,
    }
}

/// A number, in half of the calls of moderate size.
fn number(random: &mut RandomChoice) -> String {
    match random.once_in(2) {
        true => random.between(-2.0, 12.0).to_string(),
        false => random.of(&NUMBERS).to_owned(),
    }
}

/// A figure of any kind, with the required keys and some optional ones.
fn figure(
    problem: &dyn Problem,
    index: usize,
    ensemble: bool,
    random: &mut RandomChoice,
) -> String {
    // Kinds without conditions on the cases first.
    let kinds = [
        "metric",
        "metric",
        "history",
        "law",
        "convergence",
        "budget",
        "profile",
        "wave",
        "map",
        "sobol",
    ];
    let kind = match random.once_in(2) {
        _ if ensemble && random.once_in(2) => {
            random.of(&["distribution", "quantiles", "fragility"])
        }
        true => kinds[random.below(4)],
        false => random.of(&kinds),
    };
    let mut keys = vec![
        format!("\"name\": \"f{index}\""),
        format!("\"kind\": \"{kind}\""),
    ];
    let mut add = |key: &str, value: String| keys.push(format!("\"{key}\": {value}"));
    match kind {
        "profile" => add("times", format!("[0, {}]", random.between(0.0, 0.6))),
        "metric" | "budget" if random.once_in(2) => add("x", quoted(problem.schema().step_name())),
        "metric" | "budget" => add("x", quoted(parameter(problem, random))),
        "fragility" => {
            add("x", quoted(parameter(problem, random)));
            add("y", quoted(metric(problem, random)));
            add("limit", random.between(-1.0, 2.0).to_string());
            if random.once_in(3) {
                add("fit", quoted(random.of(&["incremental", "cloud"])));
                add("against", quoted(parameter(problem, random)));
            }
            if random.once_in(3) {
                add("collapse", random.between(1.0, 3.0).to_string());
            }
            if random.once_in(3) {
                let last = random.between(0.0, 2.0);
                add("hazard", format!("[[0.1, 1], [{last}, 1e-3]]"));
            }
        }
        "quantiles" => {
            add("x", quoted(parameter(problem, random)));
            if random.once_in(3) {
                add("band", format!("[{}, 1]", random.between(0.0, 1.1)));
            }
        }
        "map" => {
            add("x", quoted(parameter(problem, random)));
            add("y", quoted(parameter(problem, random)));
            add("z", quoted(metric(problem, random)));
        }
        _ => {}
    }
    if [
        "metric",
        "convergence",
        "sobol",
        "distribution",
        "quantiles",
    ]
    .contains(&kind)
    {
        add("y", format!("[\"{}\"]", metric(problem, random)));
    }
    if kind == "metric" && random.once_in(2) {
        add("y_scale", "\"log\"".into());
        add("x_scale", quoted(random.of(&["log", "linear"])));
    }
    if random.once_in(3) {
        add("title", quoted(random.of(&TITLES)));
        let words = if random.once_in(9) {
            &STRINGS[..]
        } else {
            &TITLES
        };
        add("note", quoted(random.of(words)));
    }
    if random.once_in(9) {
        add(
            "where",
            format!("{{\"{}\": {}}}", parameter(problem, random), number(random)),
        );
    }
    braced(keys)
}
