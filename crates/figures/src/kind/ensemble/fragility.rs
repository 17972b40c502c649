//! The fraction of the cases in which a metric exceeds a limit, with intervals and a lognormal function.

use super::ensembles::{Ensemble, ensembles, stroke};
use super::fragility_text as text;
use crate::GroupResults;
use crate::groups::fragility::FragilityCurve;
use crate::groups::point::Probability;
use crate::kind::Draw;
use crate::{DrawnCase, FigureData};
use slipgap_drawing::layout;
use slipgap_drawing::layout::legend::Key;
use slipgap_drawing::layout::limits;
use slipgap_drawing::layout::points::Point;
use slipgap_drawing::layout::sheet::{Panel, Series, Sheet};
use slipgap_drawing::style::{self, Marker, Stroke};
use slipgap_drawing::text::markup::plain;
use slipgap_drawing::text::number;
use slipgap_statistics::fragility::Fragility as Function;
use slipgap_study::kinds::Fragility;
use slipgap_study::{ColumnRef, Scale, Study};

/// Points of a fitted curve.
const POINTS: u32 = 200;

/// Half the width of the ends of the intervals of the first curve, and by how much those of the next one are wider: intervals at
/// one value of x are told apart where they end.
const CAP: [f64; 2] = [0.9 * style::MARKER, 0.5 * style::MARKER];

impl Draw for Fragility {
    fn sheet(&self, data: &FigureData) -> Sheet {
        let FigureData {
            study,
            figure,
            cases,
            groups,
            ..
        } = *data;
        let look = data.look();
        let (found, curve_count) = of_curves(self, study, cases);
        let curves = curves(groups);
        let height = 190.0;
        let width = figure.width.unwrap_or(1.2 * style::SINGLE);
        let [x_range, y_range] = figure.ranges;
        let y_axis = limits::axis(
            &title(self, study),
            [0.0, 1.0].into_iter(),
            Scale::Linear,
            y_range,
            height / 24.0,
        );
        let grid = layout::grid(width, 1, &[height], std::slice::from_ref(&y_axis), 4.0);
        let pairs = found.iter().zip(curves);
        let places = pairs.flat_map(|(_, curve)| drawn(curve)).map(|(at, _)| at);
        let title = axis_title(self, study);
        let x_axis = limits::axis(&title, places, self.x_scale, x_range, grid.width / 40.0);
        let mut panel = Panel::new(grid.frames[0][0], grid.margin, x_axis, y_axis);
        for (k, (_, curve)) in found.iter().zip(curves).enumerate() {
            if let Some(function) = curve.function() {
                let line = line(&panel, &function, stroke(look, k));
                panel.series.push(line);
            }
            intervals(&mut panel, curve, stroke(look, k), k);
        }
        // The first ones last: triangles and squares are seen under circles.
        for (k, (ensemble, curve)) in found.iter().zip(curves).enumerate().rev() {
            let (stroke, marker) = (stroke(look, k), Marker::of_case(k));
            points(&mut panel, curve, (stroke, marker), &ensemble.label);
        }
        let mut sheet = Sheet {
            width,
            panels: vec![panel],
            ..Sheet::default()
        };
        layout::left_out(&mut sheet, found.len(), curve_count);
        let key = |(k, (ensemble, curve)): (usize, (&Ensemble, &FragilityCurve))| Key {
            label: text::label(&ensemble.label, curve),
            stroke: stroke(look, k),
            width: curve.function().map_or(0.0, |_| style::CASE_LINE),
            marker: Some(Marker::of_case(k)),
        };
        let keys = found.iter().zip(curves).enumerate().map(key).collect();
        layout::finish(&mut sheet, vec![keys], figure.title.as_deref());
        text::small_print(self, data, curves, found.len(), &mut sheet);
        sheet
    }

    /// The numbers of cases at each point.
    fn points(&self, data: &FigureData, sheet: &Sheet) -> Vec<Point> {
        let FigureData {
            study,
            cases,
            groups,
            ..
        } = *data;
        let (found, _) = of_curves(self, study, cases);
        let Some(panel) = sheet.panels.first() else {
            return Vec::new();
        };
        let symbol = plain(&axis_title(self, study));
        let mut points = Vec::new();
        for (ensemble, curve) in found.iter().zip(curves(groups)) {
            let label = match ensemble.label.as_str() {
                "" => String::new(),
                label => format!("{}: ", plain(label)),
            };
            for point in &curve.points {
                let Some(part) = point.probability else {
                    continue;
                };
                let at = panel.place([point.at, part.value]);
                let [low, high] = [part.low, part.high].map(number::short);
                let x = number::plain_text(point.at);
                let (exceeded, count) = (point.exceeded, point.count());
                let text = format!(
                    "{label}{symbol} = {x}, {exceeded} of {count} cases exceed, interval {low} to {high}"
                );
                if panel.frame.contains(at) {
                    points.push(Point { at, text });
                }
            }
        }
        points
    }
}

fn title(figure: &Fragility, study: &Study) -> String {
    let above = study.measures[figure.y].above(&number::short(figure.limit));
    format!("P({above})")
}

/// The curves that were computed for the figure.
fn curves<'a>(groups: &'a GroupResults) -> &'a [FragilityCurve] {
    match groups {
        GroupResults::Fragility(curves) => curves,
        GroupResults::None | GroupResults::Indices { .. } => &[],
    }
}

/// The points of a curve that have a probability.
fn drawn(curve: &FragilityCurve) -> impl Iterator<Item = (f64, Probability)> {
    let points = curve.points.iter();
    points.filter_map(|point| Some((point.at, point.probability?)))
}

/// The fitted function over the whole axis.
fn line(panel: &Panel, fit: &Function, stroke: Stroke) -> Series {
    let x = |i: u32| panel.x.value(f64::from(i) / f64::from(POINTS));
    let point = |i: u32| [x(i), fit.probability(x(i))];
    Series {
        label: String::new(),
        points: (0..=POINTS).map(point).collect(),
        stroke,
        width: style::CASE_LINE,
        marker: None,
        marked: Vec::new(),
    }
}

/// Adds the intervals of curve `k`, each with ends across it.
fn intervals(panel: &mut Panel, curve: &FragilityCurve, stroke: Stroke, k: usize) {
    let half = (CAP[0] + CAP[1] * k as f64) / panel.frame.width;
    let interval = |(at, part): (f64, Probability)| {
        let [left, right] = [-half, half].map(|by| panel.x.value(panel.x.fraction(at) + by));
        let [low, high] = [part.low, part.high];
        let points = [
            [left, low],
            [right, low],
            [at, low],
            [at, high],
            [left, high],
            [right, high],
        ];
        Series {
            label: String::new(),
            points: points.to_vec(),
            stroke: match stroke {
                Stroke::Colour(_) => stroke,
                Stroke::Solid
                | Stroke::Dashed
                | Stroke::DashDot
                | Stroke::Dotted
                | Stroke::DashDotDot
                | Stroke::LongDash
                | Stroke::Grey
                | Stroke::Graded(_) => Stroke::Solid,
            },
            width: style::EXACT_LINE,
            marker: None,
            marked: Vec::new(),
        }
    };
    let new: Vec<Series> = drawn(curve).map(interval).collect();
    panel.series.extend(new);
}

/// Adds the points of an ensemble, each alone, so that no line joins it with the next.
fn points(
    panel: &mut Panel,
    curve: &FragilityCurve,
    (stroke, marker): (Stroke, Marker),
    label: &str,
) {
    let point = |(at, part): (f64, Probability)| Series {
        label: label.into(),
        points: vec![[at, part.value]],
        stroke,
        width: style::CASE_LINE,
        marker: Some(marker),
        marked: vec![0],
    };
    panel.series.extend(drawn(curve).map(point));
}

/// The ensembles of the curves, at most as many as are drawn, and the number of all.
fn of_curves<'a, 'c>(
    figure: &Fragility,
    study: &Study,
    cases: &'a [DrawnCase<'c>],
) -> (Vec<Ensemble<'a, 'c>>, usize) {
    match (figure.parameter(), figure.by) {
        // Over a metric, all cases make one curve.
        (None, None) => {
            let label = String::new();
            let cases = cases.iter().collect();
            (vec![Ensemble { label, cases }], 1)
        }
        (x, by) => ensembles(study, cases, by, x),
    }
}

/// The title of the horizontal axis.
fn axis_title(figure: &Fragility, study: &Study) -> String {
    match figure.x {
        ColumnRef::Parameter(row) => study.problem.parameters()[row].title(),
        ColumnRef::Metric(row) => study.title(row),
    }
}
