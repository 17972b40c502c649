//! What was measured, what is computed with the best values, and their differences.

use slipgap_drawing::layout::sheet::{Panel, Series, Sheet};
use slipgap_drawing::layout::ticks;
use slipgap_drawing::layout::{self, legend};
use slipgap_drawing::style::{self, Look};

/// The motions to draw.
#[derive(Debug)]
pub struct MeasuredMotion {
    /// The title in plain text, for screen readers.
    pub title: String,
    /// Title of the axis of time, in markup.
    pub time: String,
    /// Number of tests without panels.
    pub left_out: usize,
    /// A panel for each channel of each test.
    pub panels: Vec<MeasuredPanel>,
}

/// A channel of a test.
#[derive(Debug)]
pub struct MeasuredPanel {
    /// Title of the vertical axis, in markup.
    pub title: String,
    /// Name of the test, in markup; empty for a single one.
    pub caption: String,
    /// Measured points; none in a panel of differences.
    pub measured: Vec<[f64; 2]>,
    /// Number and name of each alternative, in markup, with its computed motion.
    pub curves: Vec<(usize, String, Vec<[f64; 2]>)>,
}

/// Height of a panel.
const HEIGHT: f64 = 130.0;

/// Differences of several alternatives cross at every impact; dashes would not tell them apart.
const LOOK: Look = Look {
    colour: true,
    markers: false,
};

impl MeasuredMotion {
    /// The sheet, one panel below the other.
    pub fn sheet(&self) -> Sheet {
        let width = style::MIDDLE;
        let end = |panel: &MeasuredPanel| {
            let curves = panel.curves.iter().map(|curve| curve.2.last());
            let ends = curves.chain([panel.measured.last()]).flatten();
            ends.fold(0.0, |end: f64, point| end.max(point[0]))
        };
        let end = self.panels.iter().map(end).fold(0.0, f64::max);
        let axis = |panel: &MeasuredPanel| {
            let curves = panel.curves.iter().map(|curve| &curve.2);
            let points = curves.chain([&panel.measured]).flatten();
            ticks::around(&panel.title, points.map(|point| point[1]), HEIGHT / 17.0)
        };
        let axes: Vec<_> = self.panels.iter().map(axis).collect();
        let grid = layout::grid(width, 1, &vec![HEIGHT; axes.len()], &axes, 4.0);
        let numbers = self
            .panels
            .iter()
            .flat_map(|panel| &panel.curves)
            .map(|curve| curve.0 + 1);
        let count = numbers.max().unwrap_or(1);
        let mut sheet = Sheet {
            title: self.title.clone(),
            width,
            ..Sheet::default()
        };
        let last = self.panels.len().saturating_sub(1);
        for (i, (compared, y)) in self.panels.iter().zip(axes).enumerate() {
            let end = if end > 0.0 { end } else { 1.0 };
            let x = ticks::linear(&self.time, [0.0, end], grid.width / 38.0).labelled(i == last);
            let mut panel = Panel::new(grid.frames[i][0], grid.margin, x, y);
            panel.zero = true;
            panel.caption = compared.caption.clone();
            panel.series = compared.series(count);
            sheet.panels.push(panel);
        }
        layout::letter_panels(&mut sheet.panels);
        let keys = legend::keys(&sheet.panels);
        layout::finish(&mut sheet, vec![keys], None);
        if self.left_out > 0 {
            let text = format!("{} further tests are not drawn.", self.left_out);
            layout::small_print(&mut sheet, &text);
        }
        sheet
    }
}

impl MeasuredPanel {
    /// The measured line, then the computed ones.
    fn series(&self, count: usize) -> Vec<Series> {
        let drawn = Some(&self.measured).filter(|points| !points.is_empty());
        let measured = drawn.map(|points| Series::measured(points.clone()));
        let computed = self.curves.iter().map(|(index, label, points)| Series {
            label: label.clone(),
            points: points.clone(),
            stroke: LOOK.stroke(*index, count),
            width: style::CASE_LINE,
            marker: None,
            marked: Vec::new(),
        });
        measured.into_iter().chain(computed).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn measured_points_and_each_alternative_are_in_the_panel_of_their_channel() {
        let points = |factor: f64| (0..20).map(|i| [0.1 * f64::from(i), factor]).collect();
        let panel = |factor: f64| MeasuredPanel {
            title: "*u*".into(),
            caption: String::new(),
            measured: points(factor),
            curves: vec![(0, "hertz".into(), points(2.0 * factor))],
        };
        let motion = MeasuredMotion {
            title: "motion".into(),
            time: "*t*".into(),
            left_out: 3,
            panels: vec![panel(1.0), panel(5.0)],
        };
        let sheet = motion.sheet();
        for (panel, compared) in sheet.panels.iter().zip(&motion.panels) {
            assert_eq!(panel.series[0].points, compared.measured);
            assert_eq!(panel.series[1].points, compared.curves[0].2);
        }
        assert_eq!(sheet.small_print[0].text, "3 further tests are not drawn.");
    }
}
