//! The spectra of a set of ground motions: all motions, their mean or envelope, the target and the range of the rule.

use super::spectrum::{over_periods, title};
use crate::kind::Draw;
use crate::label;
use crate::{DrawnCase, FigureData};
use slipgap_drawing::layout;
use slipgap_drawing::layout::legend::Key;
use slipgap_drawing::layout::limits;
use slipgap_drawing::layout::sheet::{Panel, Series, Sheet};
use slipgap_drawing::style::{self, Look, Stroke};
use slipgap_drawing::text::{markup, number};
use slipgap_problem::problem::structure::SetSpectra;
use slipgap_study::kinds::{Ordinate, Set};
use slipgap_study::{Scale, Study};

/// Most panels: more are too small.
const MOST: usize = 6;

/// Width of the mean over that of the curve of a case.
const BOLD: f64 = 1.8;

impl Draw for Set {
    fn sheet(&self, data: &FigureData) -> Sheet {
        let FigureData {
            study,
            figure,
            cases,
            ..
        } = *data;
        let (mut shown, units) = sets(study, cases);
        let count = shown.len();
        shown.truncate(MOST);
        let named = label::labels(study.problem.parameters(), &shown, None, &[]);
        let drawn = Vec::from_iter(shown.iter().filter_map(|shown| drawn(self, study, shown)));
        let height = if drawn.len() == 1 { 190.0 } else { 150.0 };
        let vertical = title(Ordinate::PseudoAcceleration, &units);
        let axes: Vec<_> = drawn
            .iter()
            .map(|(_, set)| {
                let motions = set.motions.iter().flatten().chain(&set.target);
                let values = motions.copied().chain([0.0]);
                let mut axis = limits::axis(&vertical, values, Scale::Linear, None, height / 24.0);
                axis.range[0] = 0.0;
                axis.ticks.retain(|tick| tick.at >= 0.0);
                axis
            })
            .collect();
        let width = figure.width.unwrap_or(1.2 * style::SINGLE);
        let grid = layout::grid(width, 1, &vec![height; axes.len()], &axes, 4.0);
        let mut sheet = Sheet {
            width,
            ..Sheet::default()
        };
        let time = match units[1].as_str() {
            "" => "Period *T*".to_owned(),
            unit => format!("Period *T* ({})", markup::escape(unit)),
        };
        for (i, ((periods, set), y)) in drawn.iter().zip(axes).enumerate() {
            let ends = periods.first().zip(periods.last());
            let range = ends.map(|(first, last)| [*first, *last]);
            let across = grid.width / 40.0;
            let x = limits::axis(&time, [].into_iter(), Scale::Log, range, across);
            let mut panel = Panel::new(grid.frames[i][0], grid.margin, x, y);
            panel.series = curves(periods, set, data.look());
            for period in set.between {
                let heights = panel.y.range;
                panel.series.push(Series {
                    stroke: Stroke::Dotted,
                    ..Series::rule(heights.map(|y| [period, y]))
                });
            }
            if drawn.len() > 1 {
                panel.caption.clone_from(&named[i]);
            }
            sheet.panels.push(panel);
        }
        layout::letter_panels(&mut sheet.panels);
        layout::left_out(&mut sheet, drawn.len(), count);
        let first = sheet.panels.first().map(|panel| &panel.series);
        let series = first.into_iter().flatten();
        let mut keys: Vec<Key> = series
            .filter(|series| !series.label.is_empty())
            .map(Key::of)
            .collect();
        keys.dedup_by(|a, b| a.label == b.label);
        layout::finish(&mut sheet, vec![keys], figure.title.as_deref());
        for (_, set) in &drawn {
            layout::small_print(&mut sheet, &meaning(set, &units[1]));
        }
        sheet
    }
}

/// The cases with different sets, and the units of length and time.
fn sets<'a>(study: &Study, cases: &[DrawnCase<'a>]) -> (Vec<DrawnCase<'a>>, [String; 2]) {
    let mut known: Vec<SetSpectra> = Vec::new();
    let (mut first, mut units) = (Vec::new(), Default::default());
    for shown in cases {
        // Without periods: what tells sets apart, for little work.
        if let Some((set, of_set)) = study
            .problem
            .as_structure()
            .and_then(|structure| structure.set_spectra(&shown.case(), &[]))
            && !known.contains(&set)
        {
            known.push(set);
            first.push(*shown);
            units = of_set;
        }
    }
    (first, units)
}

/// The set of a case at the periods of the figure.
fn drawn(figure: &Set, study: &Study, shown: &DrawnCase) -> Option<(Vec<f64>, SetSpectra)> {
    let case = shown.case();
    let [from, to] = study
        .problem
        .as_structure()
        .and_then(|structure| structure.set_spectra(&case, &[]))?
        .0
        .between;
    let periods = over_periods(figure.periods.unwrap_or([0.5 * from, 2.0 * to]));
    let (set, _) = study
        .problem
        .as_structure()
        .and_then(|structure| structure.set_spectra(&case, &periods))?;
    Some((periods, set))
}

/// The curves of a panel.
fn curves(periods: &[f64], set: &SetSpectra, look: Look) -> Vec<Series> {
    let curve = |values: &[f64], label: &str, stroke, width| Series {
        label: label.to_owned(),
        points: periods
            .iter()
            .copied()
            .zip(values.iter().copied())
            .map(|(t, y)| [t, y])
            .collect(),
        stroke,
        width,
        marker: None,
        marked: Vec::new(),
    };
    let motion = |values: &Vec<f64>| curve(values, "motions", Stroke::Grey, style::EXACT_LINE);
    let mut curves: Vec<Series> = set.motions.iter().map(motion).collect();
    let coloured = |i: u8, black| match look.colour {
        true => Stroke::Colour(i),
        false => black,
    };
    let component = set.component.map(|component| match component.name() {
        "srss" => "SRSS".to_owned(),
        "geometric-mean" => "geometric means".to_owned(),
        rotated => rotated.replace("rotd", "RotD"),
    });
    let statistic = match (set.is_envelope, component) {
        (true, None) => "envelope".to_owned(),
        (false, None) => "mean".to_owned(),
        (true, Some(name)) => format!("envelope of {name}"),
        (false, Some(name)) => format!("mean of {name}"),
    };
    let target = |label: &str, factor: f64, stroke| {
        let values: Vec<f64> = set.target.iter().map(|y| factor * y).collect();
        curve(&values, label, stroke, style::CASE_LINE)
    };
    curves.push(target("target", 1.0, coloured(1, Stroke::Dashed)));
    if set.least != 1.0 {
        let label = format!("{} × target", number::plain(set.least));
        curves.push(target(&label, set.least, coloured(2, Stroke::DashDot)));
    }
    let bold = BOLD * style::CASE_LINE;
    curves.push(curve(
        &set.statistic,
        &statistic,
        coloured(0, Stroke::Solid),
        bold,
    ));
    curves
}

/// What the lines of the range are, and the state of the set.
fn meaning(set: &SetSpectra, time: &str) -> String {
    let [from, to] = set.between.map(number::short);
    let [factor, ratio, period] =
        [set.state.factor, set.state.ratio, set.state.period].map(number::short);
    let time = markup::escape(time);
    format!(
        "Dotted: range of the rule, {from} to {to} {time}. Factor of the set {factor}; least ratio to the rule {ratio} at *T* = {period} {time}."
    )
}
