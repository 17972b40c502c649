//! The curves of two quantities: computed, measured and exact.

use super::super::cycles::{self, values};
use super::super::history::curves::sizes;
use super::super::history::measured_curves::Measured;
use crate::DrawnCase;
use slipgap_drawing::layout::sheet::Series;
use slipgap_motion::history::History;
use slipgap_problem::problem::{Jumps, Quantity};
use slipgap_study::Study;

/// Fewest and most points of an exact curve, and points for each step between them.
const EXACT_POINTS: [usize; 2] = [800, 20_000];
/// See `EXACT_POINTS`.
const FOR_EACH_STEP: usize = 4;

/// The horizontal quantity, which each of the others is paired with.
pub struct Pairs<'a> {
    /// The study.
    pub study: &'a Study,
    /// The horizontal quantity.
    pub x: &'a Quantity,
    /// Whether the axes have the units of the study.
    pub in_units: bool,
    /// First and last time in the unit of the axes, if not all.
    pub times: Option<[f64; 2]>,
    /// Whether it shows only the points at the start of each cycle of the excitation.
    pub section: bool,
}

impl Pairs<'_> {
    /// The title of an axis.
    pub fn title(&self, quantity: &Quantity) -> String {
        let problem = &*self.study.problem;
        let dimension = problem.schema().channels[quantity.channel].dimension;
        match self.study.units.as_ref().filter(|_| self.in_units) {
            Some(units) => units.title(problem, &quantity.title, dimension),
            None => quantity.title.to_string(),
        }
    }

    /// Points of two lists of values, in the units of the axes.
    fn points(&self, y: &Quantity, shown: &DrawnCase, values: [Vec<f64>; 2]) -> Vec<[f64; 2]> {
        let size = |quantity| sizes(self.study, self.in_units, &shown.case(), quantity)[1];
        let [across, up] = [self.x, y].map(size);
        let [xs, ys] = values;
        let pairs = xs.into_iter().zip(ys);
        pairs.map(|(x, y)| [x * across, y * up]).collect()
    }

    /// The computed curve of a case.
    pub fn computed(&self, y: &Quantity, shown: &DrawnCase) -> Vec<[f64; 2]> {
        let Some(solution) = shown.solution() else {
            return Vec::new();
        };
        let time = &solution.computed.time;
        let of = |quantity| values(quantity, &solution.computed, &solution.exact);
        let both = [self.x, y].map(of);
        if !self.section {
            let points = self.points(y, shown, both);
            return self.within(shown, time, points);
        }
        let cycles = cycles::of_case(self.study, shown);
        let starts = cycles
            .iter()
            .flat_map(|of| (0..of.count).map(|cycle| of.ends(cycle)[0]));
        let starts: Vec<f64> = starts.collect();
        let sampled = |values: Vec<f64>| {
            starts
                .iter()
                .map(|t| cycles::at(time, &values, *t))
                .collect()
        };
        let points = self.points(y, shown, both.map(sampled));
        self.within(shown, &starts, points)
    }

    /// The points at the times shown.
    fn within(&self, shown: &DrawnCase, time: &[f64], points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
        let Some([first, last]) = self.times else {
            return points;
        };
        let size = sizes(self.study, self.in_units, &shown.case(), self.x)[0];
        let pairs = time.iter().zip(points);
        let inside = pairs.filter(|(t, _)| (first..=last).contains(&(**t * size)));
        inside.map(|(_, point)| point).collect()
    }

    /// The measured curves of a group of cases, equal ones once, where both quantities were measured; none for a section.
    pub fn measured(&self, y: &Quantity, drawn: &[DrawnCase], group: &[usize]) -> Vec<Series> {
        let mut found: Vec<Series> = Vec::new();
        for shown in group.iter().filter(|_| !self.section).map(|i| &drawn[*i]) {
            let measured = Measured::of(self.study, &shown.case());
            let [Some((time, xs)), Some((_, ys))] = [self.x, y].map(|row| measured.quantity(row))
            else {
                continue;
            };
            let computed = shown.solution().map(|solution| &solution.computed.time[..]);
            let end = computed.and_then(<[f64]>::last).copied();
            let points = self.points(y, shown, [xs.to_vec(), ys.to_vec()]);
            let moving =
                time.partition_point(|t| *t < 0.0)..time.partition_point(|t| Some(*t) <= end);
            let points = self.within(shown, &time[moving.clone()], points[moving].to_vec());
            if !points.is_empty() && found.iter().all(|other| other.points != points) {
                found.push(Series::measured(points));
            }
        }
        found
    }

    /// The exact curves of a group of cases, equal ones once; none for an error or a section.
    pub fn exact(&self, y: &Quantity, drawn: &[DrawnCase], group: &[usize]) -> Vec<Series> {
        let mut found: Vec<Series> = Vec::new();
        for shown in group.iter().map(|i| &drawn[*i]) {
            let exact = match self.x.error || y.error || self.section {
                true => None,
                false => self.history(shown),
            };
            let Some(exact) = exact else { continue };
            let both = [self.x, y].map(|quantity| exact.channel(quantity.channel).to_vec());
            let whole = self.points(y, shown, both);
            let points = self.within(shown, &exact.time, whole);
            if !points.is_empty() && found.iter().all(|other| other.points != points) {
                found.push(Series::exact(points));
            }
        }
        found
    }

    /// The exact motion, at more times than the computed one.
    fn history(&self, shown: &DrawnCase) -> Option<History> {
        let time = &shown.solution()?.computed.time;
        let end = *time.last()?;
        let [fewest, most] = EXACT_POINTS;
        let count = (FOR_EACH_STEP * time.len()).clamp(fewest, most);
        let time = |i| end * i as f64 / count as f64;
        let times: Vec<f64> = (0..=count).map(time).collect();
        self.study
            .problem
            .exact(&shown.case(), &times, Jumps::BothSides)
    }
}
