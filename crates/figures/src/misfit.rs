//! The misfit of a calibration: a row of panels for each alternative, a panel for each of its free parameters.

use slipgap_drawing::layout;
use slipgap_drawing::layout::axis::Axis;
use slipgap_drawing::layout::legend;
use slipgap_drawing::layout::sheet::{Panel, Series, Sheet};
use slipgap_drawing::layout::ticks;
use slipgap_drawing::style::{self, Marker, Stroke};

/// The misfits to draw.
#[derive(Debug)]
pub struct Misfits {
    /// The title in plain text, for screen readers.
    pub title: String,
    /// Title of the axis of the misfit, in markup.
    pub axis: String,
    /// The alternatives.
    pub alternatives: Vec<AlternativeMisfit>,
}

/// The misfit of an alternative. It has axes of its own, since the best one would be a point on those of the others.
#[derive(Debug)]
pub struct AlternativeMisfit {
    /// Its name in markup.
    pub label: String,
    /// Its smallest misfit.
    pub least: f64,
    /// A panel for each of its free parameters.
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
    /// Values and smallest misfits.
    pub points: Vec<[f64; 2]>,
    /// The best value.
    pub best: f64,
    /// Ends of the 95 % interval.
    pub interval: Option<[f64; 2]>,
}

/// Ratio of misfits from which on the axis is logarithmic.
const WIDE: f64 = 5.0;

/// Part of the length of an axis beyond the points.
const PAD: f64 = 0.03;

/// Height of a panel.
const HEIGHT: f64 = 100.0;

/// Most panels side by side; more parameters of an alternative are in a further row.
const COLUMNS: usize = 3;

/// Width of the line of an interval.
const INTERVAL_LINE: f64 = 2.2;

impl Misfits {
    /// The sheet.
    pub fn sheet(&self) -> Sheet {
        let rows: Vec<(&AlternativeMisfit, &[MisfitPanel])> = self
            .alternatives
            .iter()
            .flat_map(|alternative| {
                alternative
                    .panels
                    .chunks(COLUMNS)
                    .map(move |panels| (alternative, panels))
            })
            .collect();
        let columns = rows
            .iter()
            .map(|(_, panels)| panels.len())
            .max()
            .unwrap_or(1);
        let width = if columns > 1 {
            style::DOUBLE
        } else {
            1.2 * style::SINGLE
        };
        let axes: Vec<Axis> = rows
            .iter()
            .map(|(alternative, _)| alternative.vertical(&self.axis))
            .collect();
        let grid = layout::grid(width, columns, &vec![HEIGHT; rows.len()], &axes, 4.0);
        // The titles of the axes of the parameters are between the rows.
        let mut sheet = Sheet {
            title: self.title.clone(),
            width,
            ..Sheet::default()
        };
        let mut below = 0.0;
        for (((alternative, panels), y), frames) in rows.iter().zip(&axes).zip(&grid.frames) {
            let mut deepest: f64 = 0.0;
            for (column, panel_data) in panels.iter().enumerate() {
                let mut frame = frames[column];
                frame.top += below;
                let x = panel_data.horizontal(grid.width);
                deepest = deepest.max(layout::below(&x));
                let y = y.clone().labelled(column == 0);
                let mut panel = Panel::new(frame, grid.margin, x, y);
                if column == 0 {
                    panel.caption = alternative.label.clone();
                }
                panel.series = panel_data.series(alternative.least);
                sheet.panels.push(panel);
            }
            below += deepest;
        }
        layout::letter_panels(&mut sheet.panels);
        let keys = legend::keys(&sheet.panels);
        layout::finish(&mut sheet, vec![keys], None);
        sheet
    }
}

impl AlternativeMisfit {
    /// The axis of the misfit, the same in all panels of the alternative.
    fn vertical(&self, title: &str) -> Axis {
        let largest_of = || {
            let points = self.panels.iter().flat_map(|profile| &profile.points);
            points
                .map(|point| point[1])
                .filter(|x| x.is_finite())
                .chain([self.least, limit(self.least)])
        };
        let largest = largest_of().fold(0.0, f64::max);
        match self.least > 0.0 && largest > WIDE * self.least {
            true => ticks::log(title, largest_of(), HEIGHT / 24.0),
            false => ticks::around(title, largest_of(), HEIGHT / 17.0),
        }
    }
}

/// 10 % above a misfit.
fn limit(least: f64) -> f64 {
    1.1 * least
}

impl MisfitPanel {
    /// The curve, the interval with the best point, and the limit.
    fn series(&self, least: f64) -> Vec<Series> {
        let line = |label: &str, points: Vec<[f64; 2]>, width| Series {
            label: label.to_owned(),
            points,
            stroke: Stroke::Solid,
            width,
            marker: None,
            marked: Vec::new(),
        };
        let mut series = vec![line(
            "smallest misfit",
            self.points.clone(),
            style::CASE_LINE,
        )];
        if let Some(ends) = self.interval {
            let points = ends.map(|x| [x, least]).to_vec();
            series.push(line("95 % interval", points, INTERVAL_LINE));
        }
        series.push(Series {
            marker: Some(Marker::Circle),
            marked: vec![0],
            ..line("best", vec![[self.best, least]], 0.0)
        });
        let points = self.shown().map(|x| [x, limit(least)]).to_vec();
        series.push(line("10 % above the best", points, style::ZERO_LINE));
        series
    }

    fn horizontal(&self, width: f64) -> Axis {
        match self.log {
            true => ticks::log_range(&self.title, self.shown(), width / 40.0),
            false => ticks::linear(&self.title, self.shown(), width / 40.0),
        }
    }

    /// The ends of the axis: those of all points that have a misfit, a little wider, within the range that was searched.
    fn shown(&self) -> [f64; 2] {
        let known = || {
            let points = self.points.iter();
            points
                .filter(|point| point[1].is_finite())
                .map(|point| point[0])
        };
        let [low, high] = [
            known().fold(f64::INFINITY, f64::min),
            known().fold(f64::NEG_INFINITY, f64::max),
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

    /// A parabola around a best value with seven points, a misfit without a solution beyond it.
    fn panel(best: f64, width: f64, least: f64) -> MisfitPanel {
        let point = |i: i32| {
            let part = f64::from(i) / 3.0;
            [best + part * width, least * (1.0 + 0.2 * part * part)]
        };
        let mut points: Vec<[f64; 2]> = (-3..=3).map(point).collect();
        points.push([best + 2.0 * width, f64::INFINITY]);
        MisfitPanel {
            title: "*k*".into(),
            range: [best - 50.0 * width, best + 50.0 * width],
            log: false,
            points,
            best,
            interval: Some([best - 0.3 * width, best + 0.3 * width]),
        }
    }

    #[test]
    fn each_alternative_has_axes_of_its_own_on_which_its_curve_is_seen() {
        // The sharp minimum of the best law is 1e-4 of the width of the other, and its misfit a seventh.
        let (best, other) = ((0.1374, 1e-5, 0.08), (0.15, 0.1, 0.56));
        let alternative =
            |label: &str, (at, width, least): (f64, f64, f64), count: usize| AlternativeMisfit {
                label: label.into(),
                least,
                panels: (0..count).map(|_| panel(at, width, least)).collect(),
            };
        let misfits = Misfits {
            title: "misfit".into(),
            axis: "error".into(),
            alternatives: vec![
                alternative("kelvin-voigt", other, 2),
                alternative("hertz-damp", best, 4),
            ],
        };
        let sheet = misfits.sheet();
        assert_eq!(sheet.panels.len(), 6);
        for (i, panel) in sheet.panels.iter().enumerate() {
            let (at, width, least) = if i < 2 { other } else { best };
            let curve = &panel.series[0];
            let places = Vec::from_iter(curve.points[..7].iter().map(|point| panel.place(*point)));
            let extent = |k: usize| {
                let coordinates = places.iter().map(|point| point[k]);
                coordinates.clone().fold(f64::MIN, f64::max) - coordinates.fold(f64::MAX, f64::min)
            };
            // Padded by 3 % at each side; the axis of the misfit has round ends.
            assert!(extent(0) > 0.9 * panel.frame.width, "{}", extent(0));
            assert!(extent(1) > 0.4 * panel.frame.height, "{}", extent(1));
            // The interval and the best point are on the curve's minimum.
            let of = |label: &str| {
                let found = panel.series.iter().find(|series| series.label == label);
                found.unwrap().points.clone()
            };
            assert_eq!(of("best"), [[at, least]]);
            assert_eq!(
                of("95 % interval"),
                [-0.3, 0.3].map(|x| [at + x * width, least])
            );
            assert!(
                of("10 % above the best")
                    .iter()
                    .all(|point| point[1] == 1.1 * least)
            );
            // A point without a solution does not widen the axis.
            assert!(panel.x.range[1] < at + 1.2 * width);
        }
        let captions: Vec<&str> = sheet.panels.iter().map(|panel| &*panel.caption).collect();
        let wanted = [
            "(a)  kelvin-voigt",
            "(b)",
            "(c)  hertz-damp",
            "(d)",
            "(e)",
            "(f)  hertz-damp",
        ];
        assert_eq!(captions, wanted);
        // Rows are below each other with the titles of their axes.
        let tops = [0, 2, 5].map(|i| sheet.panels[i].frame.top);
        for pair in tops.windows(2) {
            assert!(pair[1] > pair[0] + HEIGHT + layout::below(&sheet.panels[0].x) - 1.0);
        }
        assert_eq!(sheet.panels[2].frame.top, sheet.panels[4].frame.top);
        let of_keys = legend::keys(&sheet.panels).into_iter().map(|key| key.label);
        let labels: Vec<String> = of_keys.collect();
        let wanted = [
            "smallest misfit",
            "95 % interval",
            "best",
            "10 % above the best",
        ];
        assert_eq!(labels, wanted);
    }
}
