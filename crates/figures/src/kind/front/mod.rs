//! Two metrics of many cases: for each value of a parameter a line through its best cases.

mod best;
mod legend;
mod lines;

use super::Draw;
use crate::label;
use crate::{DrawnCase, FigureData};
use best::{Point, points};
use lines::{Line, best_of, lines};
use slipgap_drawing::layout;
use slipgap_drawing::layout::legend::{Key, mark_single_points};
use slipgap_drawing::layout::limits;
use slipgap_drawing::layout::points::Point as Hover;
use slipgap_drawing::layout::sheet::{Panel, Series, Sheet};
use slipgap_drawing::style::{self, Stroke};
use slipgap_drawing::text::markup::plain;
use slipgap_drawing::text::number;
use slipgap_problem::problem::numbers::parameter;
use slipgap_study::kinds::Front;
use slipgap_study::{Study, alike};

/// The metric that counts work.
const COST: &str = "cost";

/// The label of the band under the best of all cases.
const BEST: &str = "best of all";

impl Draw for Front {
    fn sheet(&self, data: &FigureData) -> Sheet {
        let FigureData {
            study,
            figure,
            cases,
            ..
        } = *data;
        let (points, lacking) = points(self, study, cases);
        let band = best_of(&points, |_| true);
        let panels: Vec<Vec<Line>> = self
            .by
            .iter()
            .map(|row| lines(study, data.look(), cases, &points, *row))
            .collect();
        let mut keys: Vec<Vec<Key>> = panels.iter().map(|lines| keys(lines)).collect();
        let width = figure.width.unwrap_or(style::MIDDLE);
        let legend = legend::Arrangement::of(&keys, width);
        let least = if panels.len() == 1 { 190.0 } else { 150.0 };
        let rows = Vec::from_iter(keys.iter().map(|keys| legend.height_over(keys)));
        let heights: Vec<f64> = keys
            .iter()
            .map(|k| legend.height_beside(k).max(least))
            .collect();
        let [x_range, y_range] = figure.ranges;
        // Axes round the lines: the cases that are not among the best may be far away.
        let best = panels.iter().flatten().flat_map(|line| &line.best);
        let drawn: Vec<[f64; 2]> = best.map(|i| points[*i].at).collect();
        let [x_title, y_title] = [self.x, self.y].map(|row| title(study, row));
        let values = limits::heights(drawn.iter(), x_range).into_iter();
        let y = limits::axis(&y_title, values, self.scales[1], y_range, least / 24.0);
        let whole: Vec<f64> = rows.iter().zip(&heights).map(|(a, b)| a + b).collect();
        let axes = std::slice::from_ref(&y);
        let grid = layout::grid(width, 1, &whole, axes, legend.right());
        let values = drawn.iter().map(|at| at[0]);
        let x = limits::axis(&x_title, values, self.scales[0], x_range, grid.width / 40.0);

        let mut sheet = Sheet {
            width,
            ..Sheet::default()
        };
        let last = panels.len().saturating_sub(1);
        for (i, lines) in panels.iter().enumerate() {
            let mut frame = grid.frames[i][0];
            frame.top += rows[i];
            frame.height = heights[i];
            let x = x.clone().labelled(i == last);
            let mut panel = Panel::new(frame, grid.margin, x, y.clone());
            panel.series.push(Series {
                label: BEST.into(),
                points: band.iter().map(|i| points[*i].at).collect(),
                stroke: Stroke::LIGHT,
                width: style::FRONT_BAND,
                marker: None,
                marked: Vec::new(),
            });
            let curves = Vec::from_iter(lines.iter().map(|line| line.series(&points, &panel)));
            panel.series.extend(curves);
            if last > 0 {
                panel.caption = study.problem.parameters()[self.by[i]].symbol.to_string();
            }
            sheet.panels.push(panel);
        }
        layout::letter_panels(&mut sheet.panels);
        layout::finish(&mut sheet, Vec::new(), figure.title.as_deref());
        mark_single_points(&mut sheet.panels, &mut keys);
        sheet.legend = legend.entries(&keys, &sheet.panels);
        for words in small_print(
            self,
            study,
            cases.len(),
            lacking,
            &band_cases(&points, &band),
        ) {
            layout::small_print(&mut sheet, &words);
        }
        sheet
    }

    /// The best points of each line, also those without a marker, with the other parameters of their cases.
    fn points(&self, data: &FigureData, sheet: &Sheet) -> Vec<Hover> {
        let FigureData { study, cases, .. } = *data;
        let (points, _) = points(self, study, cases);
        let over: Vec<usize> = self.mean_over.into_iter().collect();
        let shared = alike::unaffected(&*study.problem, &study.blocks, &over);
        let table = study.problem.parameters();
        let [x, y] = [self.x, self.y].map(|row| plain(&study.measures[row].symbol));
        let varying = label::named(table, cases, None, &[]);
        let mut found = Vec::new();
        for (row, panel) in self.by.iter().zip(&sheet.panels) {
            let others: Vec<usize> = shared
                .iter()
                .copied()
                .filter(|other| other != row && varying.contains(other))
                .collect();
            let lines = lines(study, data.look(), cases, &points, *row);
            for (line, i) in lines
                .iter()
                .flat_map(|line| line.best.iter().map(move |i| (line, *i)))
            {
                let point = &points[i];
                let at = panel.place(point.at);
                let [a, b] = point.at.map(number::plain_text);
                let label = plain(&line.label);
                let mut text = format!("{label}: {x} = {a}, {y} = {b}");
                let others = label::value_labels(table, cases, &others, &point.shown.case());
                if !others.is_empty() {
                    text += &format!("; {}", plain(&others));
                }
                if panel.frame.contains(at) {
                    found.push(Hover { at, text });
                }
            }
        }
        found
    }
}

/// The title of an axis; of the count of the work of a textbook problem with what it counts. Programs count by themselves.
fn title(study: &Study, row: usize) -> String {
    let measure = &study.measures[row];
    let of_symbol = study.title(row);
    match (measure.name == COST && of_symbol == COST, study.programs()) {
        (true, None) => format!("Cost: {}", measure.meaning),
        (true, Some(_)) => "Cost: steps or iterations, as each program counts them".into(),
        (false, _) => of_symbol,
    }
}

/// What is averaged, which values are among the best of all, and how many cases are not drawn.
fn small_print(
    figure: &Front,
    study: &Study,
    cases: usize,
    lacking: usize,
    best: &[DrawnCase],
) -> Vec<String> {
    let table = study.problem.parameters();
    let [x, y] = [figure.x, figure.y].map(|row| &study.measures[row].symbol);
    let mut words = Vec::new();
    if let Some(row) = figure.mean_over {
        let over = &table[row].symbol;
        words.push(format!(
            "Root mean square of {y} and mean of {x} over {over}"
        ));
    }
    let among = |row: &usize| {
        let form = label::form(best, *row);
        let levels = label::values(best, *row).into_iter().flatten();
        let values: Vec<String> = levels
            .map(|value| label::value(&table[*row], value, form))
            .collect();
        let is = match table[*row].kind {
            parameter::Kind::Choice(_) => ":",
            parameter::Kind::Number(_) | parameter::Kind::Whole { .. } => " =",
        };
        format!("{}{is} {}", table[*row].symbol, values.join(", "))
    };
    if !best.is_empty() {
        let among: Vec<String> = figure.by.iter().map(among).collect();
        words.push(format!("Best of all by rising {x}; {}", among.join("; ")));
    }
    if lacking > 0 {
        words.push(format!("{lacking} of {cases} cases without a value"));
    }
    words
}

/// The cases of the best points.
fn band_cases<'a>(points: &[Point<'a>], band: &[usize]) -> Vec<DrawnCase<'a>> {
    band.iter().map(|i| points[*i].shown).collect()
}

fn keys(lines: &[Line]) -> Vec<Key> {
    let band = Key {
        label: BEST.into(),
        stroke: Stroke::LIGHT,
        width: style::FRONT_BAND,
        marker: None,
    };
    std::iter::once(band)
        .chain(lines.iter().map(Line::key))
        .collect()
}
