//! Quantities of one dimension over time as areas on one another, one panel for each case.

use super::measured_curves::Measured;
use super::{height, time_axis, window};
use crate::label;
use crate::{DrawnCase, FigureData};
use slipgap_drawing::layout;
use slipgap_drawing::layout::axis::Axis;
use slipgap_drawing::layout::legend;
use slipgap_drawing::layout::limits;
use slipgap_drawing::layout::sheet::{Band, MEASURED, Panel, Series, Sheet};
use slipgap_drawing::style::{self, Look};
use slipgap_drawing::text::markup;
use slipgap_problem::problem::Quantity;
use slipgap_study::kinds::History;
use slipgap_study::{Scale, Study};

/// The sheet of a figure with `stacked`: a line is the sum of the quantities up to its own, and the area below it is its own.
pub fn sheet(figure: &History, data: &FigureData) -> Sheet {
    let study = data.study;
    let solved: Vec<DrawnCase> = data
        .cases
        .iter()
        .copied()
        .filter(|c| c.solution().is_some())
        .collect();
    let drawn = &solved[..solved.len().min(style::MOST_STYLES)];
    let table = study.problem.parameters();
    let quantities: Vec<&Quantity> = figure
        .y
        .iter()
        .map(|q| &study.problem.schema().quantities[*q])
        .collect();
    let [x_range, y_range] = data.figure.ranges;
    let ends = drawn
        .iter()
        .filter_map(|c| c.solution()?.computed.time.last().copied());
    let end = ends.fold(0.0, f64::max);
    let sums: Vec<Vec<Series>> = drawn
        .iter()
        .map(|case| {
            let measured = measured(study, &quantities, case, end).into_iter();
            measured
                .chain(sums(data.look(), &quantities, case))
                .collect()
        })
        .collect();
    let tall = quantities.first().map_or(0.0, |first| height(first));
    let heights = vec![tall; drawn.len()];
    let values = limits::heights(limits::points(sums.iter().flatten()), x_range);
    let lowest = values.into_iter().chain([0.0]);
    let title = title(&quantities);
    let axis = limits::axis(&title, lowest, Scale::Linear, y_range, tall / 17.0);
    let axes: Vec<Axis> = drawn.iter().map(|_| axis.clone()).collect();
    let width = data.figure.width.unwrap_or(style::SINGLE);
    let grid = layout::grid(width, 1, &heights, &axes[..axes.len().min(1)], 4.0);
    let shown = window(x_range, end);
    let time = time_axis(
        study,
        &study.problem.schema().time.title,
        if shown[0] < shown[1] {
            shown
        } else {
            [0.0, 1.0]
        },
        grid.width / 38.0,
    );
    let (_, labels) = label::numbered(&label::labels(table, drawn, None, &[]));
    let mut sheet = Sheet {
        width,
        ..Sheet::default()
    };
    for (row, series) in sums.into_iter().enumerate() {
        let x = time.clone().labelled(row + 1 >= drawn.len());
        let mut panel = Panel::new(grid.frames[row][0], grid.margin, x, axis.clone());
        panel.zero = panel.y.range[0] < 0.0 && panel.y.range[1] > 0.0;
        panel.bands = bands(series.iter().filter(|line| line.label != MEASURED));
        panel.series = series;
        if let (Some(label), true) = (labels.get(row), drawn.len() > 1) {
            panel.caption.clone_from(label);
        }
        sheet.panels.push(panel);
    }
    layout::letter_panels(&mut sheet.panels);
    layout::left_out(&mut sheet, drawn.len(), solved.len());
    let keys = legend::keys(&sheet.panels);
    layout::finish(&mut sheet, vec![keys], data.figure.title.as_deref());
    sheet
}

/// `Sum` with the unit of the quantities.
fn title(quantities: &[&Quantity]) -> String {
    let unit = quantities
        .first()
        .and_then(|first| first.title.rsplit_once(", "));
    markup::in_unit("Sum", unit.map_or("", |(_, unit)| unit))
}

/// The title of a quantity without its unit, within a legend.
fn name(quantity: &Quantity) -> &str {
    let title = &*quantity.title;
    title.rsplit_once(", ").map_or(title, |(name, _)| name)
}

/// The sums of the first quantities, of the first two, and so on.
fn sums(look: Look, quantities: &[&Quantity], case: &DrawnCase) -> Vec<Series> {
    let Some(solution) = case.solution() else {
        return Vec::new();
    };
    let computed = &solution.computed;
    let mut sum = vec![0.0; computed.time.len()];
    let mut series = Vec::with_capacity(quantities.len());
    for (k, quantity) in quantities.iter().enumerate() {
        for (sum, x) in sum.iter_mut().zip(computed.channel(quantity.channel)) {
            *sum += x;
        }
        let points = computed.time.iter().zip(&sum);
        series.push(Series {
            label: match k {
                0 => name(quantity).to_owned(),
                _ => format!("+ {}", markup::small(name(quantity))),
            },
            points: points.map(|(t, x)| [*t, *x]).collect(),
            stroke: look.stroke(k, quantities.len().max(2)),
            width: style::CASE_LINE,
            marker: None,
            marked: Vec::new(),
        });
    }
    series
}

/// The measured sum of all quantities up to `end`; none unless all were measured.
fn measured(study: &Study, quantities: &[&Quantity], case: &DrawnCase, end: f64) -> Option<Series> {
    let measured = Measured::of(study, &case.case());
    let mut sum: Vec<[f64; 2]> = Vec::new();
    for (k, quantity) in quantities.iter().enumerate() {
        let (time, values) = measured.quantity(quantity)?;
        match k {
            0 => sum.extend(time.iter().zip(values).map(|(t, x)| [*t, *x])),
            _ => sum
                .iter_mut()
                .zip(values)
                .for_each(|(point, x)| point[1] += x),
        }
    }
    sum.retain(|[t, _]| (0.0..=end).contains(t));
    (!sum.is_empty()).then(|| Series::measured(sum))
}

/// The area of each quantity, from the sum without it to the sum with it.
fn bands<'a>(series: impl Iterator<Item = &'a Series>) -> Vec<Band> {
    let mut lower: Option<&Series> = None;
    let mut bands = Vec::new();
    for line in series {
        let zero = || line.points.iter().map(|[t, _]| [*t, 0.0]).collect();
        bands.push(Band {
            upper: line.points.clone(),
            lower: lower.map_or_else(zero, |before| before.points.clone()),
            stroke: line.stroke,
        });
        lower = Some(line);
    }
    bands
}
