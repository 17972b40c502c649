//! The points of a sheet that show their values in a report.

use super::cloud::Dot;
use super::sheet::{Panel, Sheet};
use crate::text::markup::plain;
use crate::text::number;

/// A point on the sheet with its values.
pub struct Point {
    /// The place.
    pub at: [f64; 2],
    /// Its description in plain text.
    pub text: String,
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
