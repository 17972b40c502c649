//! One quantity over place and time: computed as cells, a node or an element wide and a step high; exact as the pieces
//! between its fronts.

use crate::FigureData;
use crate::kind::Draw;
use slipgap_drawing::colour_map::bar;
use slipgap_drawing::layout;
use slipgap_drawing::layout::legend::Key;
use slipgap_drawing::layout::sheet::{Cell, FilledMap, Panel, Series, Sheet};
use slipgap_drawing::layout::ticks;
use slipgap_drawing::style;
use slipgap_problem::problem::Lines;
use slipgap_study::Scale;
use slipgap_study::kinds::Wave;

/// A value between two places.
type Piece = ([f64; 2], f64);

const HEIGHT: f64 = 240.0;

impl Draw for Wave {
    fn sheet(&self, data: &FigureData) -> Sheet {
        let FigureData {
            study,
            figure,
            cases,
            ..
        } = *data;
        let Wave { y, times: shown } = *self;
        let mut rows: Vec<(f64, &Lines)> = Vec::new();
        for snapshot in cases.first().map_or(&[][..], |shown| shown.snapshots()) {
            // Several times can have the same step.
            if rows.last().is_none_or(|(time, _)| *time < snapshot.time) {
                rows.push((snapshot.time, &snapshot.profiles[y]));
            }
        }
        let times: Vec<f64> = rows.iter().map(|row| row.0).collect();
        let edges = between(&times, times.first(), times.last());
        let cells = |of: fn(&Lines) -> Vec<Piece>| -> Vec<Cell> {
            let each = rows.iter().zip(edges.windows(2));
            each.flat_map(|((_, lines), edge)| {
                let y = [edge[0], edge[1]];
                let pieces = of(lines).into_iter();
                let [low, high] = figure.ranges[0].unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
                let inside = pieces.filter(move |(x, _)| x[1] > low && x[0] < high);
                inside.map(move |(x, value)| Cell {
                    x: x.map(|x| x.clamp(low, high)),
                    y,
                    value,
                })
            })
            .collect()
        };
        let panels = [("computed", cells(computed)), ("exact", cells(exact))];

        let both_maps = panels.iter().flat_map(|panel| &panel.1);
        let title = &study.problem.schema().profiles[y].title;
        let colours = bar::axis(
            title,
            both_maps.clone().map(|cell| cell.value),
            Scale::Linear,
            None,
        );
        let [left, right] = both_maps.fold([0.0, 0.0], |[a, b]: [f64; 2], cell| {
            [a.min(cell.x[0]), b.max(cell.x[1])]
        });
        let across = match figure.ranges[0] {
            Some(range) => range,
            None if left < right => [left, right],
            None => [0.0, 1.0],
        };
        let end = times
            .last()
            .copied()
            .filter(|end| *end > 0.0)
            .unwrap_or(1.0);
        let from = shown
            .and_then(|_| times.first().copied())
            .filter(|from| *from < end);
        let window = [from.unwrap_or(0.0), end];
        let time = ticks::linear(&study.problem.schema().time.title, window, HEIGHT / 28.0);
        let width = figure.width.unwrap_or(style::DOUBLE);
        let axis = std::slice::from_ref(&time);
        let columns = layout::side_by_side(2, figure.width);
        let heights = vec![HEIGHT; 2 / columns];
        let grid = layout::grid(width, columns, &heights, axis, bar::room(&colours));
        let position = ticks::linear(
            &study.problem.schema().place_title,
            across,
            grid.width / 32.0,
        );
        let mut sheet = Sheet {
            width,
            ..Sheet::default()
        };
        for (k, (what, cells)) in panels.into_iter().enumerate() {
            let frame = grid.frames[k / columns][k % columns];
            let x = position.clone().labelled(k + columns >= 2);
            let y = time.clone().labelled(k % columns == 0);
            let mut panel = Panel::new(frame, grid.margin, x, y);
            panel.caption = what.into();
            // The contact.
            panel
                .series
                .push(Series::rule(window.map(|time| [0.0, time])));
            // At the end of each row.
            let bar = ((k + 1) % columns == 0).then(|| bar::frame(&frame));
            panel.map = Some(FilledMap::of_cells(cells, colours.clone(), bar));
            sheet.panels.push(panel);
        }
        layout::letter_panels(&mut sheet.panels);
        let keys = vec![Key::thin("contact")];
        layout::finish(&mut sheet, vec![keys], figure.title.as_deref());
        sheet
    }
}

/// Edges of cells round rising places: half-way between neighbours, and at the ends.
fn between(places: &[f64], first: Option<&f64>, last: Option<&f64>) -> Vec<f64> {
    let middles = places.windows(2).map(|pair| (pair[0] + pair[1]) / 2.0);
    first
        .copied()
        .into_iter()
        .chain(middles)
        .chain(last.copied())
        .collect()
}

/// A cell round each node or element, reaching to the ends of its part.
fn computed(lines: &Lines) -> Vec<Piece> {
    let mut cells = Vec::new();
    for (line, exact) in lines.computed.iter().zip(&lines.exact) {
        let mut points = line.clone();
        points.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let mut ends: Vec<f64> = exact.iter().map(|point| point[0]).collect();
        ends.sort_by(f64::total_cmp);
        let places: Vec<f64> = points.iter().map(|point| point[0]).collect();
        let edges = between(&places, ends.first(), ends.last());
        let pairs = edges.windows(2).zip(points);
        cells.extend(pairs.map(|(edge, [_, value])| ([edge[0], edge[1]], value)));
    }
    cells
}

/// The pieces between fronts, on each of which the exact solution has one value.
fn exact(lines: &Lines) -> Vec<Piece> {
    let pieces = lines.exact.iter().flat_map(|line| line.windows(2));
    pieces
        .filter(|piece| piece[0][0] != piece[1][0])
        .map(|piece| {
            let [a, b] = [piece[0], piece[1]];
            ([a[0].min(b[0]), a[0].max(b[0])], (a[1] + b[1]) / 2.0)
        })
        .collect()
}
