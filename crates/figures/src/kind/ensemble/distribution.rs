//! Empirical distribution functions of metrics with their confidence bands and that of tests in grey, a panel for each metric.

use super::ensembles::{Ensemble, MOST_BANDS, ensembles, keys, stroke, without_value};
use crate::FigureData;
use crate::column::has_place;
use crate::kind::Draw;
use slipgap_drawing::layout;
use slipgap_drawing::layout::axis::Axis;
use slipgap_drawing::layout::legend::Key;
use slipgap_drawing::layout::limits;
use slipgap_drawing::layout::sheet::{Band, MEASURED, Panel, Series, Sheet};
use slipgap_drawing::style::{self, Stroke};
use slipgap_statistics::empirical;
use slipgap_study::Scale;
use slipgap_study::kinds::Distribution;

/// Most steps that are drawn of a function: a step is then lower than a line is wide.
const MOST_STEPS: usize = 1000;

/// Title of the vertical axis.
const TITLE: &str = "fraction of the cases";

/// What the bands are.
const BANDS: &str = "Bands: contain the distribution function of independent cases everywhere with a probability of 95 % \
                     (Dvoretzky, Kiefer and Wolfowitz; Massart).";

impl Draw for Distribution {
    fn sheet(&self, data: &FigureData) -> Sheet {
        let FigureData {
            study,
            figure,
            cases,
            ..
        } = *data;
        let look = data.look();
        let (found, ensemble_count) = ensembles(study, cases, self.by, None);
        let banded = found.len() <= MOST_BANDS;
        let height = if self.y.len() == 1 { 190.0 } else { 130.0 };
        let [x_range, y_range] = figure.ranges;
        let width = figure.width.unwrap_or(1.2 * style::SINGLE);
        let y = limits::axis(
            TITLE,
            [0.0, 1.0].into_iter(),
            Scale::Linear,
            y_range,
            height / 24.0,
        );
        let tests = Vec::from_iter(self.y.iter().map(|metric| study.in_tests(*metric)));
        let across = |(metric, tests): (&usize, &Option<Vec<f64>>)| {
            let cases = found.iter().flat_map(|of| of.cases.iter());
            let computed = cases.filter_map(|shown| shown.metric(*metric));
            let values = computed.chain(tests.iter().flatten().copied());
            let title = &study.title(*metric);
            limits::axis(title, values, self.x_scale, x_range, width / 50.0)
        };
        let axes: Vec<Axis> = self.y.iter().zip(&tests).map(across).collect();
        // Each panel has its own horizontal axis.
        let rows: Vec<f64> = axes
            .iter()
            .map(|x| height + layout::foot(x, width - style::SINGLE / 4.0))
            .collect();
        let grid = layout::grid(width, 1, &rows, std::slice::from_ref(&y), 4.0);
        let mut sheet = Sheet {
            width,
            ..Sheet::default()
        };
        for (i, (metric, x)) in self.y.iter().zip(axes).enumerate() {
            let mut frame = grid.frames[i][0];
            frame.height = height;
            let mut panel = Panel::new(frame, grid.margin, x, y.clone());
            let of_tests = tests[i].as_deref().map(|rising| function(&panel, rising).0);
            panel.series.extend(of_tests.map(Series::measured));
            for (k, ensemble) in found.iter().enumerate() {
                draw(&mut panel, ensemble, *metric, stroke(look, k), banded);
            }
            sheet.panels.push(panel);
        }
        layout::letter_panels(&mut sheet.panels);
        layout::left_out(&mut sheet, found.len(), ensemble_count);
        let mut every_series = sheet.panels.iter().flat_map(|panel| &panel.series);
        let measured = every_series
            .find(|line| line.label == MEASURED)
            .map(Key::of);
        layout::finish(
            &mut sheet,
            vec![
                keys(look, &found, |_| None)
                    .into_iter()
                    .chain(measured)
                    .collect(),
            ],
            figure.title.as_deref(),
        );
        let bands = match banded {
            true => BANDS.to_owned(),
            false => format!(
                "Without confidence bands, because there are more than {MOST_BANDS} curves."
            ),
        };
        let mut counts = counts(&found);
        if let Some(tests) = tests.iter().flatten().next() {
            counts += &format!(" The measured function has {} tests.", tests.len());
        }
        layout::small_print(&mut sheet, &format!("{bands} {counts}"));
        without_value(&mut sheet, study, cases, &self.y);
        sheet
    }
}

/// How many cases the functions have.
fn counts(found: &[Ensemble]) -> String {
    let counts = || found.iter().map(|of| of.cases.len());
    match (counts().min(), counts().max()) {
        (Some(least), Some(most)) if least < most => {
            format!("Each function has {least} to {most} cases.")
        }
        (_, most) => format!("Each function has {} cases.", most.unwrap_or(0)),
    }
}

/// Adds the function of an ensemble and, if `banded`, its band.
fn draw(panel: &mut Panel, ensemble: &Ensemble, metric: usize, stroke: Stroke, banded: bool) {
    let values = ensemble
        .cases
        .iter()
        .filter_map(|shown| shown.metric(metric));
    let mut rising: Vec<f64> = values.collect();
    rising.sort_unstable_by(f64::total_cmp);
    if rising.is_empty() {
        return;
    }
    let half = empirical::half_band(rising.len());
    let (line, marked) = function(panel, &rising);
    let moved = |by: f64| -> Vec<[f64; 2]> {
        line.iter()
            .map(|[x, y]| [*x, (y + by).clamp(0.0, 1.0)])
            .collect()
    };
    if banded {
        panel.bands.push(Band {
            upper: moved(half),
            lower: moved(-half),
            stroke,
        });
    }
    panel.series.push(Series {
        label: ensemble.label.clone(),
        points: line,
        stroke,
        width: style::CASE_LINE,
        marker: None,
        marked,
    });
}

/// The function of rising values as a line from the left to the right end of an axis, and the places in it that show values.
fn function(panel: &Panel, rising: &[f64]) -> (Vec<[f64; 2]>, Vec<usize>) {
    let steps = empirical::steps(rising);
    let scale = panel.x.scale;
    let shown = thinned(&steps);
    let low = steps
        .iter()
        .filter(|step| !has_place(scale, step[0]))
        .map(|step| step[1]);
    let start = low.fold(0.0, f64::max);
    let shown: Vec<[f64; 2]> = shown
        .into_iter()
        .filter(|s| has_place(scale, s[0]))
        .collect();
    let line = staircase(panel.x.range, start, &shown);
    // The upper end of each step shows its values.
    let marked = (0..shown.len()).map(|step| 2 * step + 2).collect();
    (line, marked)
}

/// A line from the left to the right end of an axis that rises at each step.
fn staircase(ends: [f64; 2], start: f64, steps: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let first = steps.first().map_or(ends[0], |step| step[0].min(ends[0]));
    let last = steps.last().map_or(ends[1], |step| step[0].max(ends[1]));
    let (mut line, mut before) = (vec![[first, start]], start);
    for [x, part] in steps {
        line.extend([[*x, before], [*x, *part]]);
        before = *part;
    }
    line.push([last, before]);
    line
}

/// The steps, of many those that end on a new part of 1/1000, and the last.
fn thinned(steps: &[[f64; 2]]) -> Vec<[f64; 2]> {
    if steps.len() <= MOST_STEPS {
        return steps.to_vec();
    }
    let level_of = |step: &[f64; 2]| (step[1] * MOST_STEPS as f64).floor();
    let mut before = 0.0;
    let new = steps.iter().filter(|step| {
        let level = level_of(step);
        std::mem::replace(&mut before, level) < level
    });
    new.copied().collect()
}
