//! What accuracy costs: the best that each cost buys, the target, and the case recommended.

use super::layout;
use super::legend::Key;
use super::sheet::{Panel, Series, Sheet};
use super::style::{self, Marker, Stroke};
use super::ticks;

/// A front to draw.
#[derive(Debug)]
pub struct Front {
    /// What it is about, for readers that cannot see it.
    pub title: String,
    /// Axis title of the cost.
    pub cost: String,
    /// Cost and error over the target, by rising cost.
    pub points: Vec<[f64; 2]>,
    /// Position of the recommended point, if any.
    pub chosen: Option<usize>,
}

impl Front {
    /// The front as a sheet, both scales logarithmic.
    pub fn sheet(&self) -> Sheet {
        let height = 190.0;
        let errors = self.points.iter().map(|p| p[1]).chain([1.0]);
        let y = ticks::log("largest error over its target", errors, height / 24.0);
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
            marked: (0..points.len()).collect(),
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
                Stroke::Dotted,
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
