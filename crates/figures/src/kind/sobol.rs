//! Sobol' indices as bars with their intervals: a panel for each metric, a pair of bars for each parameter.

use super::Draw;
use crate::FigureData;
use crate::GroupResults;
use crate::groups::sobol::Estimates;
use slipgap_drawing::layout;
use slipgap_drawing::layout::axis::{Axis, Tick};
use slipgap_drawing::layout::legend::Key;
use slipgap_drawing::layout::sheet::{Anchor, Bar, Panel, PlacedText, Rect, Series, Sheet};
use slipgap_drawing::layout::ticks;
use slipgap_drawing::style::{self, Marker, Stroke};
use slipgap_statistics::sobol::{Index, Indices};
use slipgap_study::kinds::Sobol;
use slipgap_study::{Scale, Study};

/// Half the width of a bar, and of the cap of its interval, where parameters are 1 apart.
const HALF: f64 = 0.17;
const CAP: f64 = 0.06;

/// A first-order index that is less above the total one is as good as equal.
const LEAST: f64 = 0.01;

/// What the intervals are.
const WHISKERS: &str = "Intervals: middle 95 % of bootstrap samples. They assume random points; \
                        a Sobol\u{2019} sequence has smaller errors.";

impl Draw for Sobol {
    fn sheet(&self, data: &FigureData) -> Sheet {
        let FigureData {
            study,
            figure,
            groups,
            ..
        } = *data;
        let Sobol { y } = self;
        let GroupResults::Indices { block, estimates } = groups else {
            return Sheet::default();
        };
        let Some(design) = study.blocks.get(*block).and_then(|b| b.design.as_ref()) else {
            return Sheet::default();
        };
        let height = if y.len() == 1 { 190.0 } else { 130.0 };
        let axes: Vec<Axis> = y
            .iter()
            .zip(estimates)
            .map(|(&metric, found)| {
                let both = found.iter().flatten().flat_map(|i| [i.first, i.total]);
                let ends = both.flat_map(|i| [i.interval[0], i.interval[1], i.value]);
                let title = format!("indices of {}", study.measures[metric].bare_symbol());
                ticks::around(&title, ends.chain([0.0, 1.0]), height / 24.0)
            })
            .collect();
        let width = figure.width.unwrap_or(1.2 * style::SINGLE);
        let grid = layout::grid(width, 1, &vec![height; y.len()], &axes, 4.0);
        let tick = |(i, row): (usize, &usize)| Tick {
            at: i as f64,
            label: study.problem.parameters()[*row].symbol.to_string(),
        };
        let across = Axis {
            title: String::new(),
            range: [-0.5, design.parameters.len() as f64 - 0.5],
            scale: Scale::Linear,
            ticks: design.parameters.iter().enumerate().map(tick).collect(),
            power: 0,
            numbered: true,
        };
        let mut sheet = Sheet {
            width,
            ..Sheet::default()
        };
        for (i, (found, y)) in estimates.iter().zip(axes).enumerate() {
            let mut x = across.clone();
            x.numbered = i + 1 == grid.frames.len();
            let mut panel = Panel::new(grid.frames[i][0], grid.margin, x, y);
            panel.zero = true;
            // Only for the legend: the bars are drawn separately.
            panel.series = vec![
                named("first order", Marker::Dark),
                named("total", Marker::Light),
            ];
            if let Err(lack) = found {
                panel.notes.push(PlacedText {
                    at: middle(&panel.frame),
                    anchor: Anchor::Middle,
                    text: format!("no indices: {lack}"),
                    size: style::LABEL,
                });
            }
            for (k, of) in found.iter().flatten().enumerate() {
                for (index, at, marker) in [
                    (of.first, k as f64 - 1.1 * HALF, Marker::Dark),
                    (of.total, k as f64 + 1.1 * HALF, Marker::Light),
                ] {
                    bar(&mut panel, index, at, marker);
                }
            }
            sheet.panels.push(panel);
        }
        layout::letter_panels(&mut sheet.panels);
        let mut keys: Vec<Key> = Vec::new();
        if let Some(panel) = sheet.panels.first() {
            let named = panel
                .series
                .iter()
                .filter(|series| !series.label.is_empty());
            keys.extend(named.map(Key::of));
        }
        layout::finish(&mut sheet, vec![keys], figure.title.as_deref());
        layout::small_print(&mut sheet, WHISKERS);
        if let Some(words) = not_converged(study, &design.parameters, y, estimates) {
            layout::small_print(&mut sheet, &words);
        }
        sheet
    }
}

/// The parameters whose first-order index is above the total one, beyond an interval. The total contains the first order: the indices
/// of a large enough sample are not so.
fn not_converged(
    study: &Study,
    parameters: &[usize],
    metrics: &[usize],
    estimates: &[&Estimates],
) -> Option<String> {
    let wrong = |of: &Indices| {
        let (first, total) = (of.first, of.total);
        first.value > total.value + LEAST
            && (first.value > total.interval[1] || total.value < first.interval[0])
    };
    let of_metric = |(metric, found): (&usize, &&Estimates)| {
        let pairs = found.iter().flatten().zip(parameters);
        let wrong = pairs.filter(|(of, _)| wrong(of));
        let symbols = wrong.map(|(_, row)| &*study.problem.parameters()[*row].symbol);
        let names: Vec<&str> = symbols.collect();
        let metric = study.measures[*metric].bare_symbol();
        (!names.is_empty()).then(|| format!("{} ({metric})", names.join(", ")))
    };
    let parts: Vec<String> = metrics
        .iter()
        .zip(estimates)
        .filter_map(of_metric)
        .collect();
    (!parts.is_empty()).then(|| {
        format!(
            "Not converged: the first order is above the total, beyond an interval, for {}; take more points.",
            parts.join(", ")
        )
    })
}

fn middle(frame: &Rect) -> [f64; 2] {
    [
        frame.left + frame.width / 2.0,
        frame.top + frame.height / 2.0,
    ]
}

fn named(label: &str, marker: Marker) -> Series {
    Series {
        label: label.into(),
        points: Vec::new(),
        stroke: Stroke::Solid,
        width: 0.0,
        marker: Some(marker),
        marked: Vec::new(),
    }
}

/// A bar from zero with its interval.
fn bar(panel: &mut Panel, index: Index, at: f64, marker: Marker) {
    panel.bars.push(Bar {
        x: [at - HALF, at + HALF],
        y: [0.0_f64.min(index.value), index.value.max(0.0)],
        shade: marker.shade(),
    });
    let [low, high] = index.interval;
    let across = |y: f64| [[at - CAP, y], [at + CAP, y]];
    for points in [[[at, low], [at, high]], across(low), across(high)] {
        panel.series.push(Series {
            width: style::EXACT_LINE,
            ..Series::rule(points)
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_first_order_above_the_total_is_not_converged() {
        let study = slipgap_study::parse(
            "s",
            r#"{"problem": "bar-impact", "parameters": {"gamma": 1, "n": 4, "dt": 0.01, "duration": 1}}"#,
        )
        .unwrap_or_else(|e| panic!("{e}"));
        let row = |name: &str| {
            let mut table = study.problem.parameters().iter();
            table.position(|parameter| parameter.name == name).unwrap()
        };
        let index = |value, low, high| Index {
            value,
            interval: [low, high],
        };
        let words = |first, total| {
            let found: Estimates = Ok(vec![Indices { first, total }]);
            not_converged(&study, &[row("gamma")], &[0], &[&found])
        };
        // 0.5 above 0.3, and above the interval of 0.3 or below that of 0.5.
        let said = words(index(0.5, 0.2, 0.8), index(0.3, 0.2, 0.4)).unwrap();
        let symbol = &*study.problem.parameters()[row("gamma")].symbol;
        assert!(said.contains(&format!("{symbol} (")), "{said}");
        assert!(words(index(0.5, 0.4, 0.6), index(0.3, 0.1, 0.9)).is_some());
        // Inside of both intervals, hardly above, and below.
        assert_eq!(words(index(0.5, 0.2, 0.8), index(0.3, 0.1, 0.6)), None);
        assert_eq!(
            words(index(0.008, 0.007, 0.009), index(0.001, 0.0, 0.002)),
            None
        );
        assert_eq!(words(index(0.3, 0.2, 0.4), index(0.5, 0.4, 0.6)), None);
        let none: Estimates = Err(slipgap_statistics::sobol::Lack::Constant);
        assert_eq!(not_converged(&study, &[row("gamma")], &[0], &[&none]), None);
    }
}
