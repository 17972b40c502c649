//! The points of a figure that show their values in a report.

use super::{FigureData, kind};
use slipgap_drawing::draw::vector::escape;
use slipgap_drawing::layout::sheet::Sheet;
use slipgap_drawing::style::{self, UNITS};
use std::fmt::Write;

/// Most points of a figure that show their values.
const MOST: usize = 5000;

/// The figure as SVG whose points show their values.
pub fn with_hover(data: &FigureData, sheet: &Sheet, svg: &str) -> String {
    let points = kind::of(&data.figure.kind).points(data, sheet);
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
    match points.is_empty() {
        true => svg.to_owned(),
        false => svg.replace("</svg>", &group),
    }
}
