//! Quantiles of metrics over a parameter: the median as a line on a band, a panel for each metric.

use super::ensembles::{Ensemble, MOST_BANDS, bars, ensembles, keys, stroke, without_value};
use crate::kind::Draw;
use crate::{DrawnCase, FigureData};
use slipgap_drawing::layout;
use slipgap_drawing::layout::axis::Axis;
use slipgap_drawing::layout::limits;
use slipgap_drawing::layout::sheet::{Band, Panel, Series, Sheet};
use slipgap_drawing::style::{self, Stroke};
use slipgap_drawing::text::number;
use slipgap_statistics::quantile::quantile;
use slipgap_study::Scale;
use slipgap_study::kinds::Quantiles;

/// Most points of a curve that each have a marker.
const MOST_MARKED: usize = 40;

/// A value of x, the lower edge of the band, the median and the upper edge, not finite without values, and the number of values.
type Point = (f64, [f64; 3], usize);

impl Draw for Quantiles {
    fn sheet(&self, data: &FigureData) -> Sheet {
        let FigureData {
            study,
            figure,
            cases,
            ..
        } = *data;
        let (found, ensemble_count) = ensembles(study, cases, self.by, Some(self.x));
        let points = |metric: &usize| -> Vec<Vec<Point>> {
            let of = |ensemble: &Ensemble| points_of(self, ensemble, *metric);
            found.iter().map(of).collect()
        };
        let panels: Vec<Vec<Vec<Point>>> = self.y.iter().map(points).collect();
        let height = if self.y.len() == 1 { 190.0 } else { 130.0 };
        let width = figure.width.unwrap_or(1.2 * style::SINGLE);
        let [x_range, y_range] = figure.ranges;
        let [x_scale, y_scale] = self.scales;
        let up = |(metric, curves): (&usize, &Vec<Vec<Point>>)| {
            let points = curves.iter().flatten();
            let ends = Vec::from_iter(points.flat_map(|(x, of, _)| of.map(|y| [*x, y])));
            let values = limits::heights(ends.iter(), x_range).into_iter();
            let title = &study.title(*metric);
            limits::axis(title, values, y_scale, y_range, height / 24.0)
        };
        let axes: Vec<Axis> = self.y.iter().zip(&panels).map(up).collect();
        let grid = layout::grid(width, 1, &vec![height; self.y.len()], &axes, 4.0);
        let places = panels.iter().flatten().flatten().map(|(x, ..)| *x);
        let title = &study.problem.parameters()[self.x].title();
        let across = limits::axis(title, places, x_scale, x_range, grid.width / 40.0);
        let longest = panels.iter().flatten().map(Vec::len).max().unwrap_or(0);
        let (look, banded) = (data.look(), found.len() <= MOST_BANDS);
        let marker = |k: usize| look.marker(k).filter(|_| longest <= MOST_MARKED);
        let mut sheet = Sheet {
            width,
            ..Sheet::default()
        };
        let count = axes.len();
        for (i, (curves, y)) in panels.iter().zip(axes).enumerate() {
            let x = across.clone().labelled(i + 1 == count);
            let mut panel = Panel::new(grid.frames[i][0], grid.margin, x, y);
            panel.zero =
                y_scale == Scale::Linear && panel.y.range[0] < 0.0 && panel.y.range[1] > 0.0;
            for (k, points) in curves.iter().enumerate() {
                match banded {
                    true => bands(&mut panel, points, stroke(look, k)),
                    false => {
                        let interval = |(x, [low, _, high], _): &Point| [[*x, *low], [*x, *high]];
                        let ends: Vec<_> = points.iter().map(interval).collect();
                        bars(&mut panel, &ends, stroke(look, k), [k, curves.len()]);
                    }
                }
                panel.series.push(Series {
                    label: found[k].label.clone(),
                    points: points
                        .iter()
                        .map(|(x, [_, median, _], _)| [*x, *median])
                        .collect(),
                    stroke: stroke(look, k),
                    width: style::CASE_LINE,
                    marker: marker(k),
                    marked: (0..points.len()).collect(),
                });
            }
            sheet.panels.push(panel);
        }
        layout::letter_panels(&mut sheet.panels);
        layout::left_out(&mut sheet, found.len(), ensemble_count);
        let keys = keys(look, &found, marker);
        layout::finish(&mut sheet, vec![keys], figure.title.as_deref());
        let points = panels.iter().flatten().flatten();
        let counts = points.map(|(.., count)| *count).filter(|count| *count > 0);
        layout::small_print(&mut sheet, &meaning(self.band, banded, counts));
        without_value(&mut sheet, study, cases, &self.y);
        sheet
    }
}

/// What lines and bands, or bars, are, with the numbers of cases of the medians.
pub fn meaning(
    band: [f64; 2],
    banded: bool,
    counts: impl Iterator<Item = usize> + Clone,
) -> String {
    let [least, most] = [counts.clone().min(), counts.max()].map(Option::unwrap_or_default);
    let cases = match (least, most) {
        (1, 1) => "1 case".to_owned(),
        _ if least < most => format!("{least} to {most} cases"),
        _ => format!("{most} cases"),
    };
    let are = if banded { "Bands" } else { "Bars" };
    let [low, high] = band.map(|p| number::plain(1e-9 * (1e11 * p).round()));
    let ends = match band {
        [0.0, 1.0] => "smallest to the largest value".to_owned(),
        _ => format!("{low} % to the {high} % quantile"),
    };
    format!("Lines: medians of {cases}. {are}: from the {ends}.")
}

/// The points of a curve, by rising x.
fn points_of(figure: &Quantiles, ensemble: &Ensemble, metric: usize) -> Vec<Point> {
    let point = |(x, cases): (f64, Vec<&DrawnCase>)| {
        let values = cases.iter().filter_map(|shown| shown.metric(metric));
        let count = values.clone().count();
        (x, quantiles(values, figure.band), count)
    };
    ensemble.at_each(figure.x).into_iter().map(point).collect()
}

/// Lower edge of the band, median and upper edge; not finite without values.
pub fn quantiles(values: impl Iterator<Item = f64>, [low, high]: [f64; 2]) -> [f64; 3] {
    let mut sorted: Vec<f64> = values.collect();
    sorted.sort_unstable_by(f64::total_cmp);
    [low, 0.5, high].map(|p| {
        let value = quantile(&sorted, p).filter(|y| y.is_finite());
        value.unwrap_or(f64::NAN)
    })
}

/// Adds the bands of a curve: one for each part without a gap.
fn bands(panel: &mut Panel, points: &[Point], stroke: Stroke) {
    let has_place = |(x, of, _): &Point| {
        let mut ends = of.iter().map(|y| panel.place([*x, *y]));
        ends.all(|end| end.iter().all(|v| v.is_finite()))
    };
    let chunks = points.chunk_by(|a, b| has_place(a) == has_place(b));
    let parts: Vec<&[Point]> = chunks.filter(|part| has_place(&part[0])).collect();
    for part in parts {
        let edge = |which: usize| part.iter().map(|(x, of, _)| [*x, of[which]]).collect();
        panel.bands.push(Band {
            upper: edge(2),
            lower: edge(0),
            stroke,
        });
    }
}
