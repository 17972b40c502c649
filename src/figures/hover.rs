//! The points of a figure that show their values in a report.

use crate::figures::draw::vector::escape;
use crate::figures::layout::cloud::Dot;
use crate::figures::layout::sheet::{Panel, Sheet};
use crate::figures::style::{self, UNITS};
use crate::figures::text::markup::plain;
use crate::figures::text::number;
use crate::figures::{DrawnCase, kind};
use crate::study::{Figure, Study};
use std::fmt::Write;

/// Most points of a figure that show their values.
const MOST: usize = 5000;

/// A point on the sheet with its values.
pub struct Point {
    /// The place.
    pub at: [f64; 2],
    /// Its description in plain text.
    pub text: String,
}

/// The figure as SVG whose points show their values; `prefix` makes its names different from those of other figures.
pub fn with_hover(
    study: &Study,
    figure: &Figure,
    cases: &[DrawnCase],
    sheet: &Sheet,
    svg: &str,
    prefix: &str,
) -> String {
    let points = kind::of(&figure.kind).points(study, cases, sheet);
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

/// The marked points of the curves, and the dots, of all panels.
pub fn of_panels(sheet: &Sheet) -> Vec<Point> {
    sheet.panels.iter().flat_map(of_panel).collect()
}

/// The marked points of the curves of a panel, by the names of curve and axes.
fn of_panel(panel: &Panel) -> Vec<Point> {
    let axis = |title: &str, value: f64| match title.is_empty() {
        true => number::plain_text(value),
        false => format!("{} = {}", plain(title), number::plain_text(value)),
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
    // Dots that are one image are too many.
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
