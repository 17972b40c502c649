//! The part of the cases in which a metric exceeds a limit, with intervals and a lognormal function.

use super::Draw;
use super::ensembles::{Ensemble, ensembles, stroke, without_value};
use crate::figures::DrawnCase;
use slipgap_drawing::layout;
use slipgap_drawing::layout::legend::Key;
use slipgap_drawing::layout::limits;
use slipgap_drawing::layout::points::Point;
use slipgap_drawing::layout::sheet::{Panel, Series, Sheet};
use slipgap_drawing::style::{self, Marker};
use slipgap_drawing::text::markup::plain;
use slipgap_drawing::text::number;
use slipgap_statistics::binomial;
use slipgap_statistics::lognormal::{Fragility as Fit, NoFit, Trials};
use slipgap_study::kinds::Fragility;
use slipgap_study::{Figure, Scale, Study};

/// Points of a fitted curve.
const POINTS: u32 = 200;

/// Distance of the intervals of different curves at one value of x.
const APART: f64 = 2.4 * style::MARKER;

/// What points and intervals are.
const POINTS_ARE: &str = "Points: part of the cases, with 95 % intervals (Clopper and Pearson).";

/// What curves are.
const CURVES_ARE: &str = "Curves: the lognormal function of the largest likelihood.";

/// How points of several curves are drawn.
const BESIDE: &str = "Points at the same value are drawn side by side.";

impl Draw for Fragility {
    fn sheet(&self, study: &Study, figure: &Figure, cases: &[DrawnCase]) -> Sheet {
        let (found, all) = ensembles(study, cases, self.by, Some(self.x));
        let trials: Vec<Vec<Trials>> = found.iter().map(|of| trials(self, of)).collect();
        let fits: Vec<Result<Fit, NoFit>> = trials.iter().map(|of| Fit::fit(of)).collect();
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
        let places = trials.iter().flatten().map(|trials| trials.at);
        let title = &study.problem.parameters()[self.x].symbol;
        let x_axis = limits::axis(title, places, self.x_scale, x_range, grid.width / 40.0);
        let mut panel = Panel::new(grid.frames[0][0], grid.margin, x_axis, y_axis);
        for (k, (trials, fit)) in trials.iter().zip(&fits).enumerate() {
            if let Ok(fit) = fit {
                let curve = curve(&panel, fit, k);
                panel.series.push(curve);
            }
            let shift = shift(k, found.len());
            points(&mut panel, trials, shift, k, &found[k].label);
        }
        let mut sheet = Sheet {
            width,
            panels: vec![panel],
            ..Sheet::default()
        };
        layout::left_out(&mut sheet, found.len(), all);
        let key = |(k, (ensemble, fit)): (usize, (&Ensemble, &Result<Fit, NoFit>))| Key {
            label: label(&ensemble.label, fit),
            stroke: stroke(k),
            width: fit.map_or(0.0, |_| style::CASE_LINE),
            marker: Some(Marker::of_case(k)),
        };
        let keys = found.iter().zip(&fits).enumerate().map(key).collect();
        layout::finish(&mut sheet, vec![keys], figure.title.as_deref());
        let parts = [
            Some(POINTS_ARE),
            fits.iter().any(Result::is_ok).then_some(CURVES_ARE),
            (found.len() > 1).then_some(BESIDE),
        ];
        let parts: Vec<&str> = parts.into_iter().flatten().collect();
        layout::small_print(&mut sheet, &parts.join(" "));
        without_value(&mut sheet, study, cases, &[self.y]);
        sheet
    }

    /// The numbers of cases at each point.
    fn points(&self, study: &Study, cases: &[DrawnCase], sheet: &Sheet) -> Vec<Point> {
        let (found, _) = ensembles(study, cases, self.by, Some(self.x));
        let Some(panel) = sheet.panels.first() else {
            return Vec::new();
        };
        let symbol = plain(&study.problem.parameters()[self.x].symbol);
        let mut points = Vec::new();
        for (k, ensemble) in found.iter().enumerate() {
            let shift = shift(k, found.len());
            for trials in &trials(self, ensemble) {
                let [x, y] = panel.place([trials.at, part(trials)]);
                let at = [x + shift, y];
                let [low, high] = binomial::interval(trials.exceeded, trials.count);
                let [low, high] = [low, high].map(number::short);
                let label = match ensemble.label.as_str() {
                    "" => String::new(),
                    label => format!("{}: ", plain(label)),
                };
                let x = number::plain_text(trials.at);
                let Trials {
                    exceeded, count, ..
                } = trials;
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

/// The trials of an ensemble at each x, rising; of cases without a value none.
fn trials(figure: &Fragility, ensemble: &Ensemble) -> Vec<Trials> {
    let trials = |(at, cases): (f64, Vec<&DrawnCase>)| {
        let values = cases.iter().filter_map(|shown| shown.metric(figure.y));
        let values: Vec<f64> = values.collect();
        Trials {
            at,
            exceeded: values.iter().filter(|value| **value > figure.limit).count() as u64,
            count: values.len() as u64,
        }
    };
    let all = ensemble.at_each(figure.x).into_iter().map(trials);
    all.filter(|trials| trials.count > 0).collect()
}

/// How far the points of curve `k` of `count` are beside their place.
fn shift(k: usize, count: usize) -> f64 {
    APART * (k as f64 - 0.5 * (count as f64 - 1.0))
}

/// The part of the cases that exceeds.
fn part(trials: &Trials) -> f64 {
    trials.exceeded as f64 / trials.count as f64
}

/// The fitted function over the whole axis.
fn curve(panel: &Panel, fit: &Fit, k: usize) -> Series {
    let place = |i: u32| panel.x.value(f64::from(i) / f64::from(POINTS));
    let point = |i: u32| [place(i), fit.probability(place(i))];
    Series {
        label: String::new(),
        points: (0..=POINTS).map(point).collect(),
        stroke: stroke(k),
        width: style::CASE_LINE,
        marker: None,
        marked: Vec::new(),
    }
}

/// Adds the points of an ensemble with their intervals, `shift` beside their place.
fn points(panel: &mut Panel, trials: &[Trials], shift: f64, k: usize, label: &str) {
    let beside = |x: f64| {
        let moved = panel.x.fraction(x) + shift / panel.frame.width;
        if shift == 0.0 {
            x
        } else {
            panel.x.value(moved)
        }
    };
    let mut new: Vec<Series> = Vec::new();
    for trials in trials {
        let x = beside(trials.at);
        let ends = binomial::interval(trials.exceeded, trials.count);
        new.push(Series {
            width: style::EXACT_LINE,
            ..Series::rule(ends.map(|p| [x, p]))
        });
        // A point alone, so that no line joins it with the next.
        new.push(Series {
            label: label.into(),
            points: vec![[x, part(trials)]],
            stroke: stroke(k),
            width: style::CASE_LINE,
            marker: Some(Marker::of_case(k)),
            marked: vec![0],
        });
    }
    panel.series.extend(new);
}

/// The label of an ensemble with its fit.
fn label(name: &str, fit: &Result<Fit, NoFit>) -> String {
    let fit = match fit {
        Ok(fit) => {
            let [median, dispersion] = [fit.median, fit.dispersion].map(|x| number::rounded(x, 3));
            format!("median {median}, dispersion {dispersion}")
        }
        Err(why) => format!("no fit, {why}"),
    };
    match name {
        "" => fit,
        name => format!("{name}: {fit}"),
    }
}
