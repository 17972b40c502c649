//! A metric over two parameters with a colour bar: filled contours, or cells if there are too few places for contours.

mod dots;
mod places;

use super::Draw;
use crate::{DrawnCase, FigureData};
use dots::dots;
use places::{edges, places, same};
use slipgap_drawing::colour_map::bands;
use slipgap_drawing::colour_map::bar;
use slipgap_drawing::colour_map::{self, ridge};
use slipgap_drawing::layout;
use slipgap_drawing::layout::legend::Key;
use slipgap_drawing::layout::points::Point;
use slipgap_drawing::layout::sheet::{Cell, FilledMap, Panel, Sheet};
use slipgap_drawing::layout::ticks;
use slipgap_drawing::style::{self, Marker, Stroke};
use slipgap_drawing::text::markup::plain;
use slipgap_drawing::text::number;
use slipgap_problem::problem::escape;
use slipgap_problem::problem::table::schema::NO_VALUE;
use slipgap_study::kinds::Map;
use slipgap_study::{Ridge, Scale};
use std::collections::HashSet;

/// Fewest places along each axis that make a contour.
const FEWEST: usize = 3;

impl Draw for Map {
    fn sheet(&self, data: &FigureData) -> Sheet {
        let FigureData {
            study,
            figure,
            cases,
            ..
        } = *data;
        let Map {
            x,
            y,
            z,
            scales,
            z_range,
            marks,
            ridge,
        } = self;
        let (parameters, metric) = (study.problem.parameters(), &study.measures[*z]);
        let number = |shown: &DrawnCase, row: usize| shown.number(row);
        let (xs, ys) = (
            places(cases, scales[0], |c| number(c, *x)),
            places(cases, scales[1], |c| number(c, *y)),
        );
        let contoured = xs.len().min(ys.len()) >= FEWEST;
        let (x_edges, y_edges) = (edges(&xs, scales[0]), edges(&ys, scales[1]));
        let mut values = vec![f64::NAN; xs.len() * ys.len()];
        let mut cells: Vec<Cell> = Vec::new();
        // Mostly none.
        let mut empty: HashSet<usize> = HashSet::new();
        for shown in cases {
            let found = |places: &[f64], row| {
                let value = number(shown, row)?;
                let i = places.partition_point(|p| *p < value && !same(*p, value));
                places.get(i).is_some_and(|p| same(*p, value)).then_some(i)
            };
            let value = shown.metric(*z);
            let (Some(column), Some(row)) = (found(&xs, *x), found(&ys, *y)) else {
                continue;
            };
            let cell = column * ys.len() + row;
            let Some(value) = value else {
                empty.insert(cell);
                continue;
            };
            values[cell] = value;
            if !contoured {
                cells.push(Cell {
                    x: [x_edges[column], x_edges[column + 1]],
                    y: [y_edges[row], y_edges[row + 1]],
                    value,
                });
            }
        }
        let hatched = match contoured {
            _ if empty.is_empty() => Vec::new(),
            true => hatched([&xs, &ys], |i, j, rows| {
                [i, i + 1]
                    .iter()
                    .any(|i| [j, j + 1].iter().any(|j| empty.contains(&(i * rows + j))))
            }),
            false => hatched([&x_edges, &y_edges], |i, j, rows| {
                empty.contains(&(i * (rows - 1) + j))
            }),
        };
        let height = 190.0;
        let along = |row: usize, places: &[f64], edges: &[f64], scale, most| {
            // Contours reach from the first place to the last, cells half-way beyond them.
            let ends = if contoured { places } else { edges };
            let range = [ends[0], ends[ends.len() - 1]];
            let title = parameters[row].title();
            match scale {
                Scale::Linear => ticks::linear(&title, range, most),
                Scale::Log => ticks::log_range(&title, range, most),
            }
        };
        let colours = {
            let values = values.iter().copied().filter(|x| !x.is_nan());
            bar::axis(&study.title(self.z), values, scales[2], *z_range)
        };
        let outside = outside(&values, *z_range);
        let colours = match contoured {
            true => bands::limited(colours, height),
            false => colours,
        };
        let y_axis = along(*y, &ys, &y_edges, scales[1], height / 28.0);
        let width = figure.width.unwrap_or(1.3 * style::SINGLE);
        let grid = layout::grid(
            width,
            1,
            &[height],
            std::slice::from_ref(&y_axis),
            bar::room(&colours),
        );
        let x_axis = along(*x, &xs, &x_edges, scales[0], grid.width / 40.0);

        let frame = grid.frames[0][0];
        let mut panel = Panel::new(frame, grid.margin, x_axis, y_axis);
        let bar_frame = Some(bar::frame(&frame));
        let mut keys = Vec::new();
        if contoured {
            let values = bands::Values {
                places: [xs, ys],
                z: values,
            };
            let along = ridge.map(|which| {
                let which = match which {
                    Ridge::Least => colour_map::Ridge::Least,
                    Ridge::Greatest => colour_map::Ridge::Greatest,
                    Ridge::NearestToOne => colour_map::Ridge::NearestToOne,
                };
                let [xs, ys] = values.places.each_ref().map(Vec::as_slice);
                let label = ridge::label(which, &parameters[*x].symbol);
                ridge::line(&panel, [xs, ys], &ridge::rows(&values, which), label)
            });
            let along = along.filter(|line| !line.points.is_empty());
            panel.cloud = dots(&panel, &values);
            let marked = marks.iter().flat_map(|m| &m.at);
            let occupied: Vec<[f64; 2]> = marked
                .chain(along.iter().flat_map(|line| &line.points))
                .copied()
                .collect();
            values.fill(
                &mut panel,
                FilledMap::of_cells(Vec::new(), colours, bar_frame),
                &occupied,
            );
            keys.extend(along.iter().map(Key::of));
            panel.series.extend(along);
        } else {
            panel.map = Some(FilledMap::of_cells(cells, colours, bar_frame));
        }
        if let (Some(map), false) = (&mut panel.map, hatched.is_empty()) {
            map.hatched = hatched;
            keys.push(Key {
                label: escape(
                    metric
                        .metric
                        .map_or(NO_VALUE, |row| &study.problem.metrics()[row].empty),
                ),
                stroke: Stroke::Solid,
                width: 0.0,
                marker: Some(Marker::Hatched),
            });
        }
        if let Some(marks) = marks {
            panel.series.push(bands::marks(&marks.label, &marks.at));
            keys.extend(panel.series.last().map(Key::of));
        }
        let mut sheet = Sheet {
            width,
            panels: vec![panel],
            ..Sheet::default()
        };
        // A map without either has no legend and no space for one.
        let keys = if keys.is_empty() {
            Vec::new()
        } else {
            vec![keys]
        };
        layout::finish(&mut sheet, keys, figure.title.as_deref());
        if sheet.panels.iter().any(|panel| panel.cloud.is_some()) {
            layout::small_print(&mut sheet, DOTS);
        }
        if let Some(outside) = outside {
            layout::small_print(&mut sheet, &outside);
        }
        sheet
    }

    /// The cases at their places.
    fn points(&self, data: &FigureData, sheet: &Sheet) -> Vec<Point> {
        let FigureData { study, cases, .. } = *data;
        let Some(panel) = sheet.panels.first() else {
            return Vec::new();
        };
        let parameters = study.problem.parameters();
        let symbol = plain(&study.measures[self.z].symbol);
        let point = |shown: &DrawnCase| {
            let [x, y] = [self.x, self.y].map(|row| shown.number(row));
            let at = panel.place([x?, y?]);
            let z = shown.metric(self.z);
            let value = z.map_or("undefined".into(), number::plain_text);
            let [across, up] = [self.x, self.y].map(|row| plain(&parameters[row].symbol));
            let (x, y) = (number::plain_text(x?), number::plain_text(y?));
            let text = format!("{across} = {x}, {up} = {y}: {symbol} = {value}");
            panel.frame.contains(at).then_some(Point { at, text })
        };
        cases.iter().filter_map(point).collect()
    }
}

/// The rectangles between neighbouring lines along x and y that `is_empty` accepts by their numbers and the number of lines along y;
/// those above one another are one.
fn hatched(
    [xs, ys]: [&[f64]; 2],
    is_empty: impl Fn(usize, usize, usize) -> bool,
) -> Vec<[[f64; 2]; 2]> {
    let mut found: Vec<[[f64; 2]; 2]> = Vec::new();
    for i in 1..xs.len() {
        for j in 1..ys.len() {
            if !is_empty(i - 1, j - 1, ys.len()) {
                continue;
            }
            match found.last_mut() {
                Some([from, to]) if *to == [xs[i], ys[j - 1]] && from[0] == xs[i - 1] => {
                    to[1] = ys[j];
                }
                _ => found.push([[xs[i - 1], ys[j - 1]], [xs[i], ys[j]]]),
            }
        }
    }
    found
}

/// What the dots are.
const DOTS: &str = "Dots: the cases, between which the shades are interpolated.";

/// How many values are outside of the range of the shades; `None` if none is.
fn outside(values: &[f64], range: Option<[f64; 2]>) -> Option<String> {
    let [low, high] = range?;
    let finite = values.iter().filter(|x| x.is_finite()).count();
    let below = values.iter().filter(|x| **x < low).count();
    let above = values.iter().filter(|x| **x > high).count();
    let count = |some: usize, word: &str, end: f64| {
        (some > 0).then(|| format!("{some} {word} {}", number::short(end)))
    };
    let counts = [count(below, "below", low), count(above, "above", high)];
    let parts: Vec<String> = counts.into_iter().flatten().collect();
    (!parts.is_empty()).then(|| {
        format!(
            "Of {finite} values, {} lie outside of the range of colours.",
            parts.join(" and ")
        )
    })
}
