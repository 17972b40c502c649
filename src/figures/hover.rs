//! What a reader of a report is told of the points of a figure.

use super::cloud::Dot;
use super::markup::plain;
use super::sheet::{Panel, Sheet};
use super::style::{self, UNITS};
use super::vector::escape;
use super::{Shown, number};
use crate::study::{Figure, FigureKind, Study};
use std::fmt::Write;

/// Most points of a figure that can be pointed at.
const MOST: usize = 5000;

/// A place on the sheet and what is there.
struct Point {
    at: [f64; 2],
    text: String,
}

/// The figure as SVG with its points to point at; `prefix` keeps its names apart from those of other figures.
pub fn with_hover(
    study: &Study,
    figure: &Figure,
    cases: &[Shown],
    sheet: &Sheet,
    svg: &str,
    prefix: &str,
) -> String {
    let points = match &figure.kind {
        FigureKind::Map { x, y, z, .. } => of_map(study, cases, sheet, [*x, *y], *z),
        _ => sheet.panels.iter().flat_map(of_panel).collect(),
    };
    let mut group = String::from("<g class=\"hover\">\n");
    for point in points.iter().take(MOST) {
        let [x, y] = point.at.map(|u| (u * UNITS).round());
        let _ = writeln!(
            group,
            "<circle cx=\"{x}\" cy=\"{y}\" r=\"{}\" role=\"img\" aria-label=\"{}\"/>",
            (1.6 * style::MARKER * UNITS).round(),
            escape(&point.text)
        );
    }
    group += "</g>\n</svg>";
    let svg = svg
        .replace("id=\"", &format!("id=\"{prefix}"))
        .replace("href=\"#", &format!("href=\"#{prefix}"));
    match points.is_empty() {
        true => svg,
        false => svg.replace("</svg>", &group),
    }
}

/// The marked points of the curves of a panel, by the names of curve and axes.
fn of_panel(panel: &Panel) -> Vec<Point> {
    let axis = |title: &str, value: f64| match title.is_empty() {
        true => number::told(value),
        false => format!("{} = {}", plain(title), number::told(value)),
    };
    let mut points = Vec::new();
    for series in &panel.series {
        let marked = series.marked.iter().filter_map(|i| series.points.get(*i));
        for point in marked {
            let at = panel.place(*point);
            if panel.frame.contains(at) {
                let (x, y) = (
                    axis(&panel.x.title, point[0]),
                    axis(&panel.y.title, point[1]),
                );
                let text = format!("{}: {x}, {y}", plain(&series.label));
                points.push(Point { at, text });
            }
        }
    }
    // Dots that are one image are too many to point at.
    for cloud in panel.cloud.iter().filter(|cloud| !cloud.image) {
        let shown = |dot: &&Dot| panel.frame.contains(panel.place(dot.at));
        for dot in cloud.dots.iter().filter(shown) {
            let mut text = format!(
                "{}, {}",
                axis(&panel.x.title, dot.at[0]),
                axis(&panel.y.title, dot.at[1])
            );
            if let (Some(value), Some(map)) = (dot.value, &panel.map) {
                text += &format!(", {}", axis(&map.colours.title, value));
            }
            points.push(Point {
                at: panel.place(dot.at),
                text,
            });
        }
    }
    points
}

/// The cases of a map.
fn of_map(
    study: &Study,
    cases: &[Shown],
    sheet: &Sheet,
    axes: [usize; 2],
    metric: usize,
) -> Vec<Point> {
    let Some(panel) = sheet.panels.first() else {
        return Vec::new();
    };
    let parameters = study.problem.parameters();
    let symbol = plain(&study.measures[metric].symbol);
    let point = |shown: &Shown| {
        let [x, y] = axes.map(|row| shown.case.values[row].and_then(|v| v.as_f64()));
        let at = panel.place([x?, y?]);
        let value = shown.metrics.get(metric).copied().flatten();
        let value = value.map_or("undefined".into(), number::told);
        let [across, up] = axes.map(|row| plain(&parameters[row].symbol));
        let (x, y) = (number::told(x?), number::told(y?));
        let text = format!("{across} = {x}, {up} = {y}: {symbol} = {value}");
        panel.frame.contains(at).then_some(Point { at, text })
    };
    cases.iter().filter_map(point).collect()
}
