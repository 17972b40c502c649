//! What a figure shows, in words: which quantities over which, the curves, and the cases.

use crate::report::decimal;
use slipgap_figures::FigureData;
use slipgap_figures::markup::plain;
use slipgap_figures::sheet::{Panel, Sheet};
use slipgap_problem::problem::numbers::parameter::{Parameter, Value, shortest};
use slipgap_study::Study;

/// Most numbers of a parameter that a caption lists.
const MOST_NUMBERS: usize = 4;

/// Most curves that a caption names.
const MOST_CURVES: usize = 8;

/// The caption in plain text: one sentence after the other, with the title of the figure first if it has one.
pub fn of(data: &FigureData, sheet: &Sheet) -> String {
    let title = data.figure.title.is_some().then(|| sheet.title.clone());
    let parts = [
        title,
        scheme(data, sheet),
        quantities(data.study, sheet),
        panels(sheet),
        curves(sheet),
        cases(data),
        data.figure.note.as_deref().map(plain),
    ];
    let sentences = parts.into_iter().flatten().map(|text| sentence(&text));
    let text: Vec<String> = sentences.collect();
    match text.is_empty() {
        true => sentence(&sheet.title),
        false => text.join(" "),
    }
}

/// The text with a capital and a full stop. A symbol keeps its case.
fn sentence(text: &str) -> String {
    let first = text.split([' ', ':', ',']).next().unwrap_or_default();
    let is_word = first.len() > 1 && first.chars().all(|c| c.is_ascii_lowercase());
    let mut letters = text.chars();
    let text = match letters.next() {
        Some(letter) if is_word => letter.to_uppercase().chain(letters).collect(),
        _ => text.to_owned(),
    };
    match text.ends_with(['.', '!', '?']) {
        true => text,
        false => text + ".",
    }
}

/// What a figure without panels shows.
fn scheme(data: &FigureData, sheet: &Sheet) -> Option<String> {
    let is_scheme = sheet.panels.is_empty() && !sheet.picture.shapes.is_empty();
    let of = match (&data.figure.title, &*data.study.title) {
        (Some(_), _) | (None, "") => String::new(),
        (None, title) => format!(": {title}"),
    };
    is_scheme.then(|| format!("scheme of the structure{of}"))
}

/// What is over what; nothing of a figure without axes.
fn quantities(study: &Study, sheet: &Sheet) -> Option<String> {
    let x = titles(sheet, |panel| &panel.x.title);
    let y = titles(sheet, |panel| &panel.y.title);
    let colours = titles(sheet, |panel| {
        panel.map.as_ref().map_or("", |map| &map.colours.title)
    });
    let in_words = |titles: Vec<String>| {
        let titles: Vec<String> = titles.iter().map(|title| in_words(study, title)).collect();
        list(&titles, "and")
    };
    let [x, y, colours] = [x, y, colours].map(in_words);
    match [!colours.is_empty(), !y.is_empty(), !x.is_empty()] {
        [true, ..] if sheet.panels.iter().all(|panel| panel.cloud.is_none()) => {
            Some(format!("{colours} over {x} and {y}"))
        }
        [true, ..] => Some(format!("{y} over {x}, coloured by {colours}")),
        [_, true, true] => Some(format!("{y} over {x}")),
        [_, true, false] => Some(y),
        [_, false, true] => Some(x),
        [false, false, false] => None,
    }
}

/// The title of an axis; if it is the symbol of a parameter, the first words of what this means are before it.
fn in_words(study: &Study, title: &str) -> String {
    let mut table = study.problem.parameters().iter();
    let parameter = table.find(|parameter| plain(&parameter.symbol) == title);
    let meaning = parameter.map_or("", |parameter| &*parameter.meaning);
    match meaning.split([',', ';', '(']).next() {
        // A structure's study names its own parameters, which have no meaning here.
        Some(words) if !words.is_empty() && !study.problem.schema().described => {
            format!("{} {title}", words.trim_end())
        }
        _ => title.to_owned(),
    }
}

/// The captions of the panels.
fn panels(sheet: &Sheet) -> Option<String> {
    let mut captions = titles(sheet, |panel| &panel.caption);
    captions.retain(|caption| !is_letter(caption));
    (!captions.is_empty()).then(|| format!("panels: {}", captions.join("; ")))
}

/// Whether a panel has only a letter, as in `(a)`.
fn is_letter(caption: &str) -> bool {
    caption.len() == 3 && caption.starts_with('(')
}

/// The names of the curves.
fn curves(sheet: &Sheet) -> Option<String> {
    let mut labels: Vec<String> = Vec::new();
    for entry in &sheet.legend {
        let label = plain(&entry.label);
        if let Some(before) = labels.last_mut().filter(|_| entry.continues()) {
            *before += &format!(" {label}");
        } else if !label.is_empty() && !labels.contains(&label) {
            labels.push(label);
        }
    }
    let more = labels.len().saturating_sub(MOST_CURVES);
    labels.truncate(MOST_CURVES);
    if more > 0 {
        labels.push(format!("{more} more"));
    }
    (!labels.is_empty()).then(|| format!("shown: {}", labels.join("; ")))
}

/// The cases that the figure chooses.
fn cases(data: &FigureData) -> Option<String> {
    let table = data.study.problem.parameters();
    let of_rows = data.figure.filter.0.iter().map(|(row, values)| {
        let parameter = &table[*row];
        let are_numbers = values.iter().all(|value| value.as_f64().is_some());
        let words: Vec<String> = values
            .iter()
            .map(|value| written(parameter, value))
            .collect();
        let values = match &words[..] {
            [first, .., last] if are_numbers && words.len() > MOST_NUMBERS => {
                format!("{} values from {first} to {last}", words.len())
            }
            words => list(words, "or"),
        };
        format!("{} = {values}", plain(&parameter.symbol))
    });
    let chosen: Vec<String> = of_rows.collect();
    (!chosen.is_empty()).then(|| format!("for {}", chosen.join(", ")))
}

/// A value with at most six digits.
fn written(parameter: &Parameter, value: &Value) -> String {
    match value {
        Value::Number(x) => shortest(decimal::rounded(*x)),
        Value::Whole(n) => n.to_string(),
        Value::Name(name) => parameter.shown(name).to_owned(),
    }
}

/// The different titles of the panels in plain text, in their order.
fn titles<'a>(sheet: &'a Sheet, title: impl Fn(&'a Panel) -> &'a str) -> Vec<String> {
    let mut titles = Vec::new();
    for panel in &sheet.panels {
        let title = plain(title(panel)).replace("  ", " ");
        if !title.is_empty() && !titles.contains(&title) {
            titles.push(title);
        }
    }
    titles
}

/// `a, b and c`.
fn list(items: &[String], last: &str) -> String {
    match items {
        [] => String::new(),
        [one] => one.clone(),
        [others @ .., end] => format!("{} {last} {end}", others.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sentence_begins_with_a_capital_unless_with_a_symbol() {
        assert_eq!(sentence("peak of F over x"), "Peak of F over x.");
        assert_eq!(sentence("r over t"), "r over t.");
        assert_eq!(sentence("γ = 1"), "γ = 1.");
        assert_eq!(sentence("Done."), "Done.");
        assert_eq!(sentence("rdot/c over t"), "rdot/c over t.");
        assert_eq!(sentence("shown: a; b"), "Shown: a; b.");
    }

    #[test]
    fn a_list_has_commas_and_a_last_word() {
        let items = ["a", "b", "c"].map(String::from);
        assert_eq!(list(&items, "and"), "a, b and c");
        assert_eq!(list(&items[..1], "and"), "a");
        assert_eq!(list(&[], "or"), "");
    }
}
