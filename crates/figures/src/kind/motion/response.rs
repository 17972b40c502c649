//! What the last cycles of the excitation have at each frequency: a panel for each quantity, a point for each cycle.

use super::cycles::{of_case, of_cycle, scattered, values};
use crate::kind::Draw;
use crate::label;
use crate::{DrawnCase, FigureData};
use slipgap_drawing::layout;
use slipgap_drawing::layout::axis::Axis;
use slipgap_drawing::layout::legend::Key;
use slipgap_drawing::layout::limits;
use slipgap_drawing::layout::sheet::{Panel, Sheet};
use slipgap_drawing::style;
use slipgap_drawing::text::markup;
use slipgap_problem::problem::Quantity;
use slipgap_problem::problem::numbers::unit::Dimension;
use slipgap_study::Study;
use slipgap_study::kinds::{Each, Response};
use std::collections::HashSet;

/// Places that are nearer than a point over this are one.
const NEAR: f64 = 10.0;

impl Draw for Response {
    fn sheet(&self, data: &FigureData) -> Sheet {
        let FigureData {
            study,
            figure,
            cases,
            ..
        } = *data;
        let solved = cases.iter().copied().filter(|c| c.solution().is_some());
        let solved: Vec<DrawnCase> = solved.collect();
        let table = study.problem.parameters();
        let along = |x| label::along(study, &solved, x);
        let except = self.x.map_or(Vec::new(), along);
        let of_cases = label::labels(table, &solved, self.by, &except);
        let (indices, labels) = label::numbered(&of_cases);
        let count = labels.len().min(style::MOST_STYLES);
        let quantities = &study.problem.schema().quantities;
        let curves = |row: &usize| -> Vec<Vec<[f64; 2]>> {
            let of_label = |label: usize| {
                let members = solved.iter().zip(&indices).filter(|(_, i)| **i == label);
                let points =
                    members.flat_map(|(shown, _)| of(self, study, shown, &quantities[*row]));
                points.collect()
            };
            (0..count).map(of_label).collect()
        };
        let panels: Vec<Vec<Vec<[f64; 2]>>> = self.y.iter().map(curves).collect();
        let height = if self.y.len() == 1 { 190.0 } else { 130.0 };
        let width = figure.width.unwrap_or(1.2 * style::SINGLE);
        let [x_range, y_range] = figure.ranges;
        let up = |(row, curves): (&usize, &Vec<Vec<[f64; 2]>>)| {
            let values = limits::heights(curves.iter().flatten(), x_range);
            let title = title(self.each, &quantities[*row].title);
            limits::axis(
                &title,
                values.into_iter(),
                self.scales[1],
                y_range,
                height / 24.0,
            )
        };
        let axes: Vec<Axis> = self.y.iter().zip(&panels).map(up).collect();
        let grid = layout::grid(width, 1, &vec![height; axes.len()], &axes, 4.0);
        let places = panels.iter().flatten().flatten().map(|point| point[0]);
        let x_title = match self.x {
            Some(row) => table[row].title(),
            None => frequency(study),
        };
        let across = limits::axis(&x_title, places, self.scales[0], x_range, grid.width / 40.0);
        let look = data.look();
        let mut sheet = Sheet {
            width,
            ..Sheet::default()
        };
        let last = axes.len().saturating_sub(1);
        for (i, (curves, y)) in panels.iter().zip(axes).enumerate() {
            let x = across.clone().labelled(i == last);
            let mut panel = Panel::new(grid.frames[i][0], grid.margin, x, y);
            // The first ones last, so that the markers of others are seen under them.
            for (k, points) in curves.iter().enumerate().rev() {
                let seen = once(&panel, points);
                let series = scattered(&seen, &labels[k], look.stroke(k, count), (k, count));
                panel.series.push(series);
            }
            sheet.panels.push(panel);
        }
        layout::letter_panels(&mut sheet.panels);
        layout::left_out(&mut sheet, count, labels.len());
        let key = |k: usize| {
            Key::of(&scattered(
                &[],
                &labels[k],
                look.stroke(k, count),
                (k, count),
            ))
        };
        let keys = (0..count).filter(|_| count > 1).map(key).collect();
        layout::finish(&mut sheet, vec![keys], figure.title.as_deref());
        let at = match self.x {
            Some(row) => markup::escape(&table[row].name),
            None => "frequency".to_owned(),
        };
        let words = match self.cycles {
            1.0 => format!("Points: the last cycle of each {at}."),
            cycles => format!("Points: the last {cycles} cycles of each {at}."),
        };
        layout::small_print(&mut sheet, &words);
        sheet
    }
}

/// The points of a case.
fn of(figure: &Response, study: &Study, shown: &DrawnCase, quantity: &Quantity) -> Vec<[f64; 2]> {
    let Some(solution) = shown.solution() else {
        return Vec::new();
    };
    let values = values(quantity, &solution.computed, &solution.exact);
    let time = &solution.computed.time;
    let mut points = Vec::new();
    for cycles in of_case(study, shown) {
        let x = match figure.x {
            Some(row) => shown.number(row),
            None => Some(cycles.frequency),
        };
        let first = cycles.count.saturating_sub(figure.cycles as usize);
        let point = |cycle: usize| {
            let value = of_cycle(figure.each, time, &values, cycles.ends(cycle));
            Some([x?, value])
        };
        points.extend((first..cycles.count).filter_map(point));
    }
    points
}

/// The points that are at different places of a panel.
fn once(panel: &Panel, points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut seen = HashSet::new();
    let is_new = |point: &&[f64; 2]| {
        let place = panel.place(**point);
        seen.insert(place.map(|x| (x * NEAR).round() as i64))
    };
    points.iter().filter(is_new).copied().collect()
}

/// The title of what is drawn of each cycle.
fn title(each: Each, quantity: &str) -> String {
    let word = match each {
        Each::Peak => "Peak",
        Each::Max => "Largest",
        Each::Min => "Smallest",
        Each::Start => return format!("{quantity} at the start of a cycle"),
    };
    format!("{word} {}", markup::small(quantity))
}

/// The title of an axis of frequencies.
fn frequency(study: &Study) -> String {
    let structure = study.problem.as_structure();
    let time = structure.and_then(|structure| structure.unit_name(Dimension::Time));
    let unit = match time.as_deref() {
        None | Some("") => String::new(),
        Some("s") => "Hz".to_owned(),
        Some(time) => format!("1/{time}"),
    };
    markup::in_unit("Frequency of the excitation", &markup::unit(&unit))
}
