//! Error over cost: the smallest error for each cost, the target, and the recommended case.

use libm::log10;
use slipgap_drawing::layout;
use slipgap_drawing::layout::legend::Key;
use slipgap_drawing::layout::sheet::{Panel, Series, Sheet};
use slipgap_drawing::layout::ticks;
use slipgap_drawing::style::{self, Marker, Stroke};

/// A front to draw.
#[derive(Debug)]
pub struct Front {
    /// Its title in plain text, for screen readers.
    pub title: String,
    /// Axis title of the cost.
    pub cost: String,
    /// Cost and error over the target, by rising cost.
    pub points: Vec<[f64; 2]>,
    /// Position of the recommended point, if any.
    pub chosen: Option<usize>,
}

/// Least distance of markers along the axis, relative to its length: the width of a marker.
const APART: f64 = 0.02;

/// The points to mark along a logarithmic axis, so that no marker hides the next.
fn apart(points: &[[f64; 2]], range: [f64; 2]) -> Vec<usize> {
    let share = |x: f64| log10(x / range[0]) / log10(range[1] / range[0]);
    let mut marked: Vec<usize> = Vec::new();
    for (i, point) in points.iter().enumerate() {
        let last = marked.last().map(|last| share(points[*last][0]));
        if last.is_none_or(|last| share(point[0]) - last >= APART) {
            marked.push(i);
        }
    }
    marked
}

impl Front {
    /// The front as a sheet, both scales logarithmic.
    pub fn sheet(&self) -> Sheet {
        let height = 190.0;
        let errors = self.points.iter().map(|p| p[1]).chain([1.0]);
        let y = ticks::log("largest ratio of error to target", errors, height / 24.0);
        let width = 1.2 * style::SINGLE;
        let grid = layout::grid(width, 1, &[height], std::slice::from_ref(&y), 4.0);
        let x = ticks::log(
            &self.cost,
            self.points.iter().map(|p| p[0]),
            grid.width / 40.0,
        );
        let mut panel = Panel::new(grid.frames[0][0], grid.margin, x, y);
        let curve = |label: &str, points: Vec<[f64; 2]>, stroke, width, marker| Series {
            label: label.into(),
            marked: apart(&points, panel.x.range),
            points,
            stroke,
            width,
            marker,
        };
        let target = panel.x.range.map(|x| [x, 1.0]).to_vec();
        let best = Some(Marker::Circle);
        panel.series = vec![
            curve("target", target, Stroke::Solid, style::EXACT_LINE, None),
            curve(
                "best at this cost",
                self.points.clone(),
                Stroke::Colour(0),
                style::CASE_LINE,
                best,
            ),
        ];
        if let Some(at) = self.chosen {
            let recommended = Some(Marker::Square);
            let point = vec![self.points[at]];
            panel
                .series
                .push(curve("recommended", point, Stroke::Solid, 0.0, recommended));
        }
        let keys = panel.series.iter().map(Key::of).collect();
        let mut sheet = Sheet {
            title: self.title.clone(),
            width,
            panels: vec![panel],
            ..Sheet::default()
        };
        layout::finish(&mut sheet, vec![keys], None);
        sheet
    }
}
