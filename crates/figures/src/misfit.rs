//! The misfit of a calibration over each free parameter, a curve for each alternative.

use slipgap_drawing::layout;
use slipgap_drawing::layout::axis::Axis;
use slipgap_drawing::layout::legend;
use slipgap_drawing::layout::sheet::{Panel, Series, Sheet};
use slipgap_drawing::layout::ticks;
use slipgap_drawing::style::{self, Look, Marker, Stroke};

/// The misfits to draw.
#[derive(Debug)]
pub struct Misfits {
    /// The title in plain text, for screen readers.
    pub title: String,
    /// Title of the axis of the misfit, in markup.
    pub axis: String,
    /// The misfit 10 % above the best one.
    pub limit: Option<f64>,
    /// A panel for each free parameter.
    pub panels: Vec<MisfitPanel>,
}

/// The misfit over a parameter.
#[derive(Debug)]
pub struct MisfitPanel {
    /// Title of the axis of the parameter, in markup.
    pub title: String,
    /// The ends of the range that was searched; the axis shows the part with points.
    pub range: [f64; 2],
    /// Whether the axis is logarithmic.
    pub log: bool,
    /// The alternatives that use the parameter.
    pub curves: Vec<MisfitCurve>,
}

/// The misfit of an alternative over a parameter.
#[derive(Debug)]
pub struct MisfitCurve {
    /// Number of the alternative.
    pub index: usize,
    /// Its name in markup.
    pub label: String,
    /// Values and smallest misfits.
    pub points: Vec<[f64; 2]>,
    /// The best value and its misfit.
    pub best: [f64; 2],
    /// Ends of the 95 % interval.
    pub interval: Option<[f64; 2]>,
}

/// Ratio of misfits from which on the axis is logarithmic.
const WIDE: f64 = 5.0;

/// Part of the length of an axis beyond the points.
const PAD: f64 = 0.03;

/// Height of a panel.
const HEIGHT: f64 = 130.0;

/// Width of the line of an interval.
const INTERVAL_LINE: f64 = 2.2;

impl Misfits {
    /// The sheet, at most two panels side by side.
    pub fn sheet(&self) -> Sheet {
        let columns = self.panels.len().clamp(1, 2);
        let rows = self.panels.len().div_ceil(columns);
        let width = if columns > 1 {
            style::DOUBLE
        } else {
            1.2 * style::SINGLE
        };
        let y = self.vertical();
        let axes = vec![y.clone(); rows];
        let grid = layout::grid(width, columns, &vec![HEIGHT; rows], &axes, 4.0);
        // The titles of the axes of the parameters are between the rows.
        let mut sheet = Sheet {
            title: self.title.clone(),
            width,
            ..Sheet::default()
        };
        let most = self
            .panels
            .iter()
            .flat_map(|panel| &panel.curves)
            .map(|own| own.index + 1);
        let count = most.max().unwrap_or(1);
        let mut below = 0.0;
        for (row, panels) in self.panels.chunks(columns).enumerate() {
            let mut deepest: f64 = 0.0;
            for (column, own) in panels.iter().enumerate() {
                let mut frame = grid.frames[row][column];
                frame.top += below;
                let x = own.horizontal(grid.width);
                deepest = deepest.max(layout::below(&x));
                let mut y = y.clone();
                if column > 0 {
                    y.title.clear();
                    y.numbered = false;
                }
                let mut panel = Panel::new(frame, grid.margin, x, y);
                panel.series = self.series(own, count);
                sheet.panels.push(panel);
            }
            below += deepest;
        }
        layout::letter_panels(&mut sheet.panels);
        let keys = legend::keys(&sheet.panels);
        layout::finish(&mut sheet, vec![keys], None);
        sheet
    }

    /// The axis of the misfit, the same in all panels.
    fn vertical(&self) -> Axis {
        let all = || {
            let curves = self.panels.iter().flat_map(|panel| &panel.curves);
            let points = curves.flat_map(|own| own.points.iter().chain([&own.best]));
            points
                .map(|point| point[1])
                .filter(|x| x.is_finite())
                .chain(self.limit)
        };
        let least = all().fold(f64::INFINITY, f64::min);
        let largest = all().fold(0.0, f64::max);
        match least > 0.0 && largest > WIDE * least {
            true => ticks::log(&self.axis, all(), HEIGHT / 24.0),
            false => ticks::around(&self.axis, all(), HEIGHT / 17.0),
        }
    }

    /// The curves of a panel, then their best points and intervals, and the limit.
    fn series(&self, panel: &MisfitPanel, count: usize) -> Vec<Series> {
        let line = |label: &str, points: Vec<[f64; 2]>, stroke, width| Series {
            label: label.to_owned(),
            points,
            stroke,
            width,
            marker: None,
            marked: Vec::new(),
        };
        let mut series = Vec::new();
        for own in &panel.curves {
            let stroke = Look::default().stroke(own.index, count);
            let points = own.points.clone();
            series.push(line(&own.label, points, stroke, style::CASE_LINE));
        }
        for own in &panel.curves {
            if let Some(ends) = own.interval {
                let points = ends.map(|x| [x, own.best[1]]).to_vec();
                series.push(line("95 % interval", points, Stroke::Solid, INTERVAL_LINE));
            }
            series.push(Series {
                marker: Some(Marker::Circle),
                marked: vec![0],
                ..line("best", vec![own.best], Stroke::Solid, 0.0)
            });
        }
        series.extend(self.limit.map(|limit| {
            let points = panel.shown().map(|x| [x, limit]).to_vec();
            let label = "10 % above the best";
            line(label, points, Stroke::Solid, style::ZERO_LINE)
        }));
        series
    }
}

impl MisfitPanel {
    fn horizontal(&self, width: f64) -> Axis {
        match self.log {
            true => ticks::log_range(&self.title, self.shown(), width / 40.0),
            false => ticks::linear(&self.title, self.shown(), width / 40.0),
        }
    }

    /// The ends of the axis: those of all points that have a misfit, a little wider, within the range that was searched.
    fn shown(&self) -> [f64; 2] {
        let all = || {
            let points = self.curves.iter().flat_map(|own| &own.points);
            points
                .filter(|point| point[1].is_finite())
                .map(|point| point[0])
        };
        let [low, high] = [
            all().fold(f64::INFINITY, f64::min),
            all().fold(f64::NEG_INFINITY, f64::max),
        ];
        if low >= high || !(high - low).is_finite() {
            return self.range;
        }
        let wider = match self.log {
            true => {
                let pad = libm::pow(high / low, PAD);
                [low / pad, high * pad]
            }
            false => {
                let pad = PAD * (high - low);
                [low - pad, high + pad]
            }
        };
        [wider[0].max(self.range[0]), wider[1].min(self.range[1])]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_parameter_has_a_panel_with_its_range_and_the_best_points() {
        let curve = |index: usize| MisfitCurve {
            index,
            label: ["hertz", "kelvin-voigt"][index].to_owned(),
            points: vec![[1e4, 2.0], [1e5, 1.0], [1e6, f64::INFINITY]],
            best: [1e5, 1.0],
            interval: Some([8e4, 1.2e5]),
        };
        let panel = |log: bool| MisfitPanel {
            title: "*k*".into(),
            range: [1e4, 1e6],
            log,
            curves: vec![curve(0), curve(1)],
        };
        let misfits = Misfits {
            title: "misfit".into(),
            axis: "error".into(),
            limit: Some(1.1),
            panels: vec![panel(true), panel(false), panel(true)],
        };
        let sheet = misfits.sheet();
        assert_eq!(sheet.panels.len(), 3);
        for panel in &sheet.panels {
            // Nothing is shown beyond the last point with a misfit.
            assert!(panel.x.range[0] == 1e4 && (1e5..1.2e5).contains(&panel.x.range[1]));
            // A point without a solution does not widen the axis.
            assert!(panel.y.range[0] < 1.0 && panel.y.range[1] < 4.0);
            let best = panel.series.iter().filter(|own| own.label == "best");
            assert_eq!(
                best.map(|own| own.points[0]).collect::<Vec<_>>(),
                [[1e5, 1.0]; 2]
            );
        }
        // The third panel is below the first with the title of its axis.
        let [first, _, third] = &sheet.panels[..] else {
            panic!("three panels");
        };
        assert!(third.frame.top > first.frame.bottom() + layout::below(&first.x) - 1.0);
        let labels: Vec<String> = legend::keys(&sheet.panels)
            .into_iter()
            .map(|key| key.label)
            .collect();
        assert_eq!(
            labels,
            [
                "hertz",
                "kelvin-voigt",
                "95 % interval",
                "best",
                "10 % above the best"
            ]
        );
    }
}
