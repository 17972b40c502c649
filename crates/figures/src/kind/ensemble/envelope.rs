//! Metrics at positions along the structure, upwards: a curve for each case, of an ensemble its median on a band.

use super::ensembles::{Ensemble, MOST_BANDS, bars, ensembles, keys, stroke, without_value};
use super::quantiles::{meaning, quantiles};
use crate::FigureData;
use crate::kind::Draw;
use slipgap_drawing::layout;
use slipgap_drawing::layout::limits;
use slipgap_drawing::layout::sheet::{Band, Panel, Series, Sheet};
use slipgap_drawing::style;
use slipgap_drawing::text::markup;
use slipgap_study::kinds::Envelope;
use slipgap_study::{Scale, Study};

impl Draw for Envelope {
    fn sheet(&self, data: &FigureData) -> Sheet {
        let FigureData {
            study,
            figure,
            cases,
            ..
        } = *data;
        let (found, ensemble_count) = ensembles(study, cases, self.by, None);
        // Lower edge, median and upper edge at each position, for each row of metrics of each ensemble.
        let of = |ensemble: &Ensemble| -> Vec<[f64; 3]> {
            let of_metric = |metric: &usize| {
                let values = ensemble.cases.iter();
                quantiles(values.filter_map(|shown| shown.metric(*metric)), self.band)
            };
            self.x.iter().map(of_metric).collect()
        };
        let curves: Vec<Vec<[f64; 3]>> = found.iter().map(of).collect();
        let sampled = found.iter().any(|ensemble| ensemble.cases.len() > 1);
        let banded = sampled && found.len() <= MOST_BANDS;
        let height = 190.0;
        let width = figure.width.unwrap_or(1.2 * style::SINGLE);
        let [x_range, y_range] = figure.ranges;
        let [x_title, at_title] = &self.titles;
        let at_title = at_title.as_deref().unwrap_or("Position");
        let places = self.at.iter().copied();
        // Storeys have whole numbers.
        let most = (height / 24.0f64).min(self.at.len().max(2) as f64);
        let up = limits::axis(at_title, places, Scale::Linear, y_range, most);
        let grid = layout::grid(width, 1, &[height], std::slice::from_ref(&up), 4.0);
        let shown = if sampled { 0..3 } else { 1..2 };
        let values = curves
            .iter()
            .flatten()
            .flat_map(|of| of[shown.clone()].to_vec());
        let shared = || title(study, &self.x);
        let x_title = x_title.clone().unwrap_or_else(shared);
        let all_positive = values.clone().all(|x| x >= 0.0 || x.is_nan());
        let values = values.chain([0.0]);
        let mut across = limits::axis(&x_title, values, Scale::Linear, x_range, grid.width / 40.0);
        if all_positive && x_range.is_none() {
            across.range[0] = 0.0;
            across.ticks.retain(|tick| tick.at >= 0.0);
        }
        let look = data.look();
        let mut panel = Panel::new(grid.frames[0][0], grid.margin, across, up);
        if panel.x.range[0] < 0.0 && panel.x.range[1] > 0.0 {
            let zero = Series::rule(panel.y.range.map(|y| [0.0, y]));
            panel.series.push(zero);
        }
        for (k, rows) in curves.iter().enumerate() {
            for row in rows.chunks(self.at.len()) {
                let line = |which: usize| -> Vec<[f64; 2]> {
                    let points = row.iter().zip(&self.at);
                    points.map(|(of, at)| [of[which], *at]).collect()
                };
                let [lower, median, upper] = [0, 1, 2].map(line);
                let is_finite = |line: &[[f64; 2]]| line.iter().all(|point| point[0].is_finite());
                if banded && is_finite(&lower) && is_finite(&upper) {
                    panel.bands.push(Band {
                        upper,
                        lower,
                        stroke: stroke(look, k),
                    });
                } else if sampled && !banded {
                    let ends = lower.into_iter().zip(upper);
                    let ends: Vec<_> = ends.map(|(low, high)| [low, high]).collect();
                    bars(&mut panel, &ends, stroke(look, k), [k, curves.len()]);
                }
                panel.series.push(Series {
                    label: found[k].label.clone(),
                    marked: (0..median.len()).collect(),
                    points: median,
                    stroke: stroke(look, k),
                    width: style::CASE_LINE,
                    marker: look.marker(k),
                });
            }
        }
        let mut sheet = Sheet {
            width,
            panels: vec![panel],
            ..Sheet::default()
        };
        layout::left_out(&mut sheet, found.len(), ensemble_count);
        let keys = keys(look, &found, |k| look.marker(k));
        layout::finish(&mut sheet, vec![keys], figure.title.as_deref());
        if sampled {
            let rows = found
                .iter()
                .flat_map(|of| self.x.iter().map(move |row| (of, *row)));
            let counts = rows.map(|(of, row)| {
                let known = of.cases.iter().filter(|shown| shown.metric(row).is_some());
                known.count()
            });
            layout::small_print(&mut sheet, &meaning(self.band, banded, counts));
        }
        without_value(&mut sheet, study, cases, &self.x);
        sheet
    }
}

/// The words with which the titles of all metrics begin, with their unit; the first word may differ, as of largest and smallest
/// values.
fn title(study: &Study, metrics: &[usize]) -> String {
    let titles: Vec<String> = metrics.iter().map(|metric| study.title(*metric)).collect();
    let parts = titles
        .iter()
        .map(|title| title.rsplit_once(", ").unwrap_or((title, "")));
    let (words, units): (Vec<Vec<&str>>, Vec<&str>) = parts
        .map(|(words, unit)| (words.split(' ').collect(), unit))
        .unzip();
    let Some(first) = words.first() else {
        return String::new();
    };
    let is_shared = |i: usize| words.iter().all(|other| other.get(i) == first.get(i));
    let from = usize::from(!is_shared(0));
    let count = (from..first.len()).take_while(|i| is_shared(*i)).count();
    let mut shared = &first[from..from + count];
    while let [before @ .., "of" | "relative" | "to" | "from"] = shared {
        shared = before;
    }
    let unit = match units.iter().all(|unit| *unit == units[0]) {
        true => units[0],
        false => "",
    };
    markup::in_unit(&markup::capital(&shared.join(" ")), unit)
}
