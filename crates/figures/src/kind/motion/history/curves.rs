//! The curves of a history figure, as series.

use super::measured_curves::Measured;
use crate::DrawnCase;
use crate::label;
use slipgap_drawing::layout::sheet::{MEASURED, Series};
use slipgap_drawing::style::{self, Look, Stroke};
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_problem::problem::numbers::unit::Dimension;
use slipgap_problem::problem::{Case, Jumps, Quantity, Solution};
use slipgap_study::Study;

/// Points of an exact curve: less than a typographic point apart.
const EXACT_POINTS: usize = 800;

/// The cases of a history figure, with their labels.
pub struct Curves<'a> {
    /// The study.
    pub study: &'a Study,
    /// The cases drawn, all solved.
    pub cases: &'a [DrawnCase<'a>],
    /// Index of each case's label.
    pub indices: &'a [usize],
    /// The different labels.
    pub labels: &'a [String],
    /// How curves are told apart.
    pub look: Look,
    /// The stroke of each label.
    pub strokes: &'a [Stroke],
    /// Whether axes are in the units of the study.
    pub in_units: bool,
    /// First and last time shown.
    pub window: [f64; 2],
    /// Markers along a curve: not a whole number for each cycle, so that they are at different phases.
    pub markers: f64,
}

impl Curves<'_> {
    /// The curves of one panel, the measured ones first, then the exact ones.
    pub fn of(&self, quantity: &Quantity, members: &[usize]) -> Vec<Series> {
        let mut series: Vec<Series> = Vec::new();
        for shown in members.iter().map(|i| &self.cases[*i]) {
            if let Some(points) = self.measured(quantity, shown)
                && !series.iter().any(|s| s.points == points)
            {
                series.push(Series::measured(points));
            }
        }
        for shown in members.iter().map(|i| &self.cases[*i]) {
            if let Some(points) = self.exact(quantity, shown)
                && !series.iter().any(|s| s.points == points)
            {
                series.push(Series::exact(points));
            }
        }
        if let Some(points) = self.input(quantity, members) {
            series.push(Series {
                label: String::new(),
                ..Series::measured(points)
            });
            return series;
        }
        for &i in members {
            let Some(points) = self.computed(quantity, i) else {
                continue;
            };
            let index = self.indices[i];
            series.push(Series {
                label: self.labels[index].clone(),
                marked: self.marked(&points, index),
                points,
                stroke: self.strokes[index],
                width: style::CASE_LINE,
                marker: self.look.marker(index),
            });
        }
        series
    }

    /// The computed points of a case.
    fn computed(&self, quantity: &Quantity, i: usize) -> Option<Vec<[f64; 2]>> {
        let shown = &self.cases[i];
        let sizes = sizes(self.study, self.in_units, &shown.case(), quantity);
        let unscaled = points(quantity, shown.solution()?).into_iter();
        Some(unscaled.map(|p| times(p, sizes)).collect())
    }

    /// The points of a motion of the ground that all cases of the figure have, with the finest steps.
    fn input(&self, quantity: &Quantity, members: &[usize]) -> Option<Vec<[f64; 2]>> {
        let structure = self.study.problem.as_structure()?;
        let cases: Vec<Case> = self.cases.iter().map(DrawnCase::case).collect();
        let is_one = !quantity.error && structure.is_one_input(quantity.channel, &cases);
        let curves = members.iter().filter(|_| is_one);
        curves
            .filter_map(|i| self.computed(quantity, *i))
            .max_by_key(Vec::len)
    }

    /// The measured points in the window, with the next ones on both sides if the motion goes on there; none if there are none.
    fn measured(&self, quantity: &Quantity, shown: &DrawnCase) -> Option<Vec<[f64; 2]>> {
        let measured = Measured::of(self.study, &shown.case());
        let (time, values) = measured.quantity(quantity)?;
        let sizes = sizes(self.study, self.in_units, &shown.case(), quantity);
        let [first, last] = self.window;
        let end = *shown.solution()?.computed.time.last()? * sizes[0];
        let from = time.partition_point(|t| t * sizes[0] < first);
        let to = time.partition_point(|t| t * sizes[0] <= last);
        let from = from.saturating_sub(usize::from(first > 0.0));
        let to = (to + usize::from(last < end)).min(time.len());
        let inside = time.get(from..to)?.iter().zip(&values[from..to]);
        let points: Vec<[f64; 2]> = inside.map(|(t, x)| times([*t, *x], sizes)).collect();
        (!points.is_empty()).then_some(points)
    }

    /// The exact curve, finer than any case's steps; none for an error.
    fn exact(&self, quantity: &Quantity, shown: &DrawnCase) -> Option<Vec<[f64; 2]>> {
        if quantity.error {
            return None;
        }
        let sizes = sizes(self.study, self.in_units, &shown.case(), quantity);
        let [first, last] = self.window.map(|time| time / sizes[0]);
        let time = |i| first + (last - first) * i as f64 / EXACT_POINTS as f64;
        // It starts at 0 even if the first time shown is later.
        let start = (first > 0.0).then_some(0.0);
        let exact_times: Vec<f64> = start
            .into_iter()
            .chain((0..=EXACT_POINTS).map(time))
            .collect();
        let exact = self
            .study
            .problem
            .exact(&shown.case(), &exact_times, Jumps::BothSides)?;
        let values = exact.channel(quantity.channel);
        // No exact motion has energies by kind.
        if values.is_empty() {
            return None;
        }
        let line = exact.time.iter().zip(values);
        Some(line.map(|(t, x)| times([*t, *x], sizes)).collect())
    }

    /// The points with a marker: few, at different times for different curves.
    fn marked(&self, points: &[[f64; 2]], index: usize) -> Vec<usize> {
        let [begin, end] = self.window;
        let spacing = (end - begin) / self.markers;
        let indices = self.labels.len().min(8) as f64;
        let first = begin + (index as f64 % indices + 0.5) / indices * spacing;
        let mut marked: Vec<usize> = Vec::new();
        let mut time = first;
        while time < end && !points.is_empty() {
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
}

/// Takes the marker from the only curve of each panel: it needs none if no exact curve is with it. Measured ones and inputs are grey.
pub fn unmark_alone<'a>(series: impl Iterator<Item = &'a mut Series>, labels: &[String]) {
    let lines: Vec<&mut Series> = series.collect();
    let alone = labels.len() == 1
        && lines
            .iter()
            .all(|series| ["", MEASURED, &labels[0]].contains(&&*series.label));
    for series in lines.into_iter().filter(|_| alone) {
        series.marker = None;
    }
}

/// The cases of a panel: those with a value of a parameter, or all.
pub fn members(cases: &[DrawnCase], group: Option<(usize, Option<Value>)>) -> Vec<usize> {
    let belongs = |i: &usize| match group {
        Some((row, value)) => label::same(cases[*i].value(row), value),
        None => true,
    };
    (0..cases.len()).filter(belongs).collect()
}

/// Sizes of the units of time and of a quantity in a case; 1 if the axes are scaled.
pub fn sizes(study: &Study, in_units: bool, case: &Case, quantity: &Quantity) -> [f64; 2] {
    let of = |dimension| match in_units {
        true => study
            .problem
            .as_textbook()
            .and_then(|textbook| textbook.size(case, dimension))
            .unwrap_or(f64::NAN),
        false => 1.0,
    };
    [
        of(Dimension::Time),
        of(study.problem.schema().channels[quantity.channel].dimension),
    ]
}

fn times(point: [f64; 2], sizes: [f64; 2]) -> [f64; 2] {
    [point[0] * sizes[0], point[1] * sizes[1]]
}

fn points(quantity: &Quantity, solution: &Solution) -> Vec<[f64; 2]> {
    let computed = solution.computed.channel(quantity.channel);
    let time = solution.computed.time.iter();
    if !quantity.error {
        return time.zip(computed).map(|(t, c)| [*t, *c]).collect();
    }
    let pairs = computed
        .iter()
        .zip(solution.exact.channel(quantity.channel));
    time.zip(pairs).map(|(t, (c, e))| [*t, c - e]).collect()
}
