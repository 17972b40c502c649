//! Curves over time: one row of panels a quantity, the exact solution thin below the cases.

use super::Shown;
use super::label;
use super::layout::{self, Key};
use super::sheet::{Axis, Panel, Series, Sheet};
use super::style::{self, Marker, Stroke};
use super::ticks;
use crate::history::History;
use crate::problem::parameter::Value;
use crate::problem::{Quantity, Solution, Source};
use crate::study::{Figure, FigureKind, Study};

/// More curves than there are looks cannot be told apart.
const MOST_CURVES: usize = 30;
/// Points of an exact curve: less than a point of paper apart.
const EXACT_POINTS: usize = 800;

/// The sheet of a `history` figure.
pub fn sheet(study: &Study, figure: &Figure, cases: &[Shown]) -> Sheet {
    let FigureKind::History { y, by, panels } = &figure.kind else {
        return Sheet::default();
    };
    let solved: Vec<Shown> = cases
        .iter()
        .copied()
        .filter(|c| c.solution.is_some())
        .collect();
    let drawn = &solved[..solved.len().min(MOST_CURVES)];
    let except: Vec<usize> = panels.iter().copied().collect();
    let (looks, labels) = label::numbered(&label::labels(
        study.problem.parameters(),
        drawn,
        *by,
        &except,
    ));
    let groups = match panels {
        Some(row) => label::values(drawn, *row),
        None => vec![None],
    };
    // Side by side where that makes a page of rows and columns, else below one another.
    let columns = if y.len() > 1 && groups.len() <= 3 {
        groups.len()
    } else {
        1
    };
    let width = if columns > 1 {
        style::DOUBLE
    } else {
        style::MIDDLE
    };
    let end = drawn
        .iter()
        .flat_map(|c| c.solution)
        .filter_map(|s| s.computed.time.last());
    let end = end.fold(0.0, |a: f64, b| a.max(*b));
    let curves = Curves {
        study,
        cases: drawn,
        looks: &looks,
        labels: &labels,
        end,
    };

    // One row of panels for each quantity, or each group and quantity.
    let quantities: Vec<&Quantity> = y.iter().map(|q| &study.problem.quantities()[*q]).collect();
    let members: Vec<Vec<usize>> = groups
        .iter()
        .map(|group| curves.members(panels.map(|row| (row, *group))))
        .collect();
    let blocks: Vec<&[Vec<usize>]> = members.chunks(columns).collect();
    let mut rows: Vec<Vec<(Vec<Series>, &Quantity, usize)>> = Vec::new();
    for (b, block) in blocks.iter().enumerate() {
        for quantity in &quantities {
            let panel = |(k, members): (usize, &Vec<usize>)| {
                (curves.of(quantity, members), *quantity, b * columns + k)
            };
            rows.push(block.iter().enumerate().map(panel).collect());
        }
    }
    let heights: Vec<f64> = rows.iter().map(|row| height(row[0].1)).collect();
    let axes: Vec<Axis> = quantities
        .iter()
        .map(|quantity| {
            let of_it = rows
                .iter()
                .flatten()
                .filter(|panel| panel.1.name == quantity.name);
            let values = of_it
                .flat_map(|panel| &panel.0)
                .flat_map(|s| &s.points)
                .map(|p| p[1]);
            ticks::around(quantity.title, values, height(quantity) / 17.0)
        })
        .collect();

    let grid = layout::grid(width, columns, &heights, &axes, 4.0);
    let time = time_axis(study, end, grid.width / 38.0);
    let mut sheet = Sheet {
        width,
        ..Sheet::default()
    };
    let last = rows.len().saturating_sub(1);
    for (r, row) in rows.into_iter().enumerate() {
        for (column, (series, _, group)) in row.into_iter().enumerate() {
            let mut y = axes[r % quantities.len()].clone();
            if column > 0 {
                y.title.clear();
            }
            let mut x = time.clone();
            if r != last {
                x.title.clear();
                x.numbered = false;
            }
            let mut panel = Panel::new(grid.frames[r][column], grid.margin, x, y);
            panel.zero = panel.y.range[0] < 0.0 && panel.y.range[1] > 0.0;
            panel.series = series;
            if let (Some(row), Some(Some(value))) = (panels, groups.get(group))
                && r % quantities.len() == 0
            {
                panel.letter = label::said(&study.problem.parameters()[*row], *value);
            }
            sheet.panels.push(panel);
        }
    }
    layout::letters(&mut sheet.panels);
    if let (true, Some(first)) = (drawn.len() < cases.len(), sheet.panels.first_mut()) {
        let (some, all) = (drawn.len(), cases.len());
        first.letter += &format!("  {some} of {all} cases");
    }
    let keys = curves.keys(&sheet);
    layout::finish(&mut sheet, vec![keys], figure.title.as_deref());
    sheet
}

fn is_error(quantity: &Quantity) -> bool {
    matches!(
        quantity.source,
        Source::DisplacementError | Source::VelocityError
    )
}

/// Errors lie flatter than the response.
fn height(quantity: &Quantity) -> f64 {
    if is_error(quantity) { 76.0 } else { 160.0 }
}

fn time_axis(study: &Study, end: f64, most: f64) -> Axis {
    let range = [0.0, if end > 0.0 { end } else { 1.0 }];
    let title = study.problem.time_title();
    if study.problem.time_in_pi() {
        ticks::in_pi(title, range, most)
    } else {
        ticks::linear(title, range, most)
    }
}

/// What the panels draw from.
struct Curves<'a> {
    study: &'a Study,
    cases: &'a [Shown<'a>],
    /// Number of each case's label.
    looks: &'a [usize],
    labels: &'a [String],
    /// Last time of any case.
    end: f64,
}

impl Curves<'_> {
    /// The cases of a panel.
    fn members(&self, group: Option<(usize, Option<Value>)>) -> Vec<usize> {
        let belongs = |i: &usize| match group {
            Some((row, value)) => label::same(self.cases[*i].case.values[row], value),
            None => true,
        };
        (0..self.cases.len()).filter(belongs).collect()
    }

    /// The curves of one panel, the exact ones first.
    fn of(&self, quantity: &Quantity, members: &[usize]) -> Vec<Series> {
        let mut series: Vec<Series> = Vec::new();
        for shown in members.iter().map(|i| &self.cases[*i]) {
            if let Some(points) = self.exact(quantity, shown)
                && !series.iter().any(|s| s.points == points)
            {
                series.push(Series {
                    label: "exact".into(),
                    points,
                    stroke: Stroke::Solid,
                    width: style::EXACT_LINE,
                    marker: None,
                    marked: Vec::new(),
                });
            }
        }
        for &i in members {
            let Some(solution) = self.cases[i].solution else {
                continue;
            };
            let points = points(quantity.source, solution);
            let look = self.looks[i];
            series.push(Series {
                label: self.labels[look].clone(),
                marked: self.marked(&points, look),
                points,
                stroke: Stroke::of_case(look),
                width: style::CASE_LINE,
                marker: Some(Marker::of_case(look)),
            });
        }
        series
    }

    /// The exact curve, finer than any case's steps; none for an error.
    fn exact(&self, quantity: &Quantity, shown: &Shown) -> Option<Vec<[f64; 2]>> {
        if is_error(quantity) {
            return None;
        }
        let time = |i| self.end * i as f64 / EXACT_POINTS as f64;
        let times: Vec<f64> = (0..=EXACT_POINTS).map(time).collect();
        let exact = self.study.problem.exact(shown.case, &times)?;
        let values = column(quantity.source, &exact);
        Some(times.iter().zip(values).map(|(t, x)| [*t, *x]).collect())
    }

    /// Points that carry a marker: few, and not at the same times for two curves.
    fn marked(&self, points: &[[f64; 2]], look: usize) -> Vec<usize> {
        // Not a whole number of cycles apart, so that markers do not gather at the same phase.
        let spacing = self.end / 9.3;
        let looks = self.labels.len().min(8) as f64;
        let first = (look as f64 % looks + 0.5) / looks * spacing;
        let mut marked: Vec<usize> = Vec::new();
        let mut time = first;
        while time < self.end && spacing > 0.0 {
            let after = points
                .partition_point(|p| p[0] < time)
                .min(points.len() - 1);
            let nearer = after > 0 && time - points[after - 1][0] < points[after][0] - time;
            let i = after - usize::from(nearer);
            if marked.last() != Some(&i) {
                marked.push(i);
            }
            time += spacing;
        }
        marked
    }

    /// The legend: exact, then every look once.
    fn keys(&self, sheet: &Sheet) -> Vec<Key> {
        let mut keys: Vec<Key> = Vec::new();
        for series in sheet.panels.iter().flat_map(|panel| &panel.series) {
            if !keys.iter().any(|key| key.label == series.label) {
                keys.push(Key {
                    label: series.label.clone(),
                    stroke: series.stroke,
                    width: series.width,
                    marker: series.marker,
                });
            }
        }
        keys
    }
}

fn points(source: Source, solution: &Solution) -> Vec<[f64; 2]> {
    let (computed, exact) = (&solution.computed, &solution.exact);
    let values = column(source, computed);
    let time = computed.time.iter();
    match source {
        Source::Displacement | Source::Velocity | Source::Force => {
            time.zip(values).map(|(t, c)| [*t, *c]).collect()
        }
        Source::DisplacementError | Source::VelocityError => {
            let pairs = values.iter().zip(column(source, exact));
            time.zip(pairs).map(|(t, (c, e))| [*t, c - e]).collect()
        }
    }
}

fn column(source: Source, history: &History) -> &[f64] {
    match source {
        Source::Displacement | Source::DisplacementError => &history.displacement,
        Source::Velocity | Source::VelocityError => &history.velocity,
        Source::Force => &history.force,
    }
}
