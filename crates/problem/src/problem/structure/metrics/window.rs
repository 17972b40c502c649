//! The window of a reduction, such as `from=10, to=20` in the brackets of a metric: the times that it is of.

use super::function::Function;
use super::reduction::Reduction;
use crate::metrics::SLACK;
use crate::problem::numbers::parameter::shortest;
use crate::problem::structure::given::amount::Amount;
use crate::problem::{Case, Violation};
use std::ops::Range;

/// The names of the limits.
pub const LIMITS: [&str; 2] = ["from", "to"];

/// The times that a reduction is of: from the first to the second limit, each with its end of the motion if it is left out.
#[derive(Debug, Clone, Default)]
pub struct Window {
    /// The limits as the study writes them.
    pub texts: [Option<String>; 2],
    /// Their numbers.
    pub amounts: [Option<Amount>; 2],
}

/// Whether a text begins with a limit, such as `from=10`.
pub fn begins_with_limit(text: &str) -> bool {
    limit(text).is_some_and(|(name, _)| LIMITS.contains(&name))
}

/// The name and the value of a text such as `from = 10`; `None` without `=`.
fn limit(text: &str) -> Option<(&str, &str)> {
    let (name, value) = text.split_once('=')?;
    Some((name.trim(), value.trim()))
}

/// The parts of a text between its commas outside of brackets, each with where it begins.
fn parts(text: &str) -> Vec<(usize, &str)> {
    let (mut found, mut begin, mut depth) = (Vec::new(), 0, 0);
    for (at, c) in text.char_indices() {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            ',' if depth == 0 => {
                found.push((begin, &text[begin..at]));
                begin = at + 1;
            }
            _ => {}
        }
    }
    found.push((begin, &text[begin..]));
    found
}

impl Window {
    /// What is in the brackets of a metric before its window, and the window.
    ///
    /// # Errors
    /// What is wrong and what is allowed.
    pub fn split(inside: &str) -> Result<(&str, Window), String> {
        let mut window = Window::default();
        let mut rest = inside;
        for (begin, part) in parts(inside) {
            let Some((name, value)) = limit(part) else {
                if rest.len() < inside.len() {
                    return Err("from= and to= stand last in the brackets".to_owned());
                }
                continue;
            };
            let Some(place) = LIMITS.iter().position(|known| *known == name) else {
                return Err(format!("no '{name}='; a window is from=TIME, to=TIME"));
            };
            if value.is_empty() {
                return Err(format!("{name}= needs a time, as in {name}=10"));
            }
            if window.texts[place].replace(value.to_owned()).is_some() {
                return Err(format!("{name}= is given twice"));
            }
            if rest.len() == inside.len() {
                rest = inside[..begin].trim_end_matches(',').trim();
            }
        }
        Ok((rest, window))
    }

    /// Whether it has a limit.
    pub fn is_given(&self) -> bool {
        self.texts.iter().any(Option::is_some)
    }

    /// The window in words with a blank before it, such as ` from 10 to 20 s`; empty without a limit. An expression gets no unit.
    pub fn in_words(&self, unit: Option<&str>) -> String {
        let with_texts = LIMITS.iter().zip(&self.texts);
        let limits = with_texts.filter_map(|(name, text)| Some((name, text.as_ref()?)));
        let mut words: String = limits
            .map(|(name, text)| format!(" {name} {text}"))
            .collect();
        let last = self.texts.iter().flatten().last();
        let is_number = last.is_some_and(|text| text.parse::<f64>().is_ok());
        if let Some(unit) = unit.filter(|_| is_number) {
            words = format!("{words} {unit}");
        }
        words
    }

    /// The limits in a case, each with its end of the times if it is left out.
    fn limits(&self, case: &Case, [begin, end]: [f64; 2]) -> Result<[f64; 2], Violation> {
        let value = |place: usize, other: f64| {
            let amount = self.amounts[place].as_ref();
            amount.map_or(Ok(other), |amount| amount.value(case))
        };
        Ok([value(0, begin)?, value(1, end)?])
    }

    /// The limits without a case; `None` if one of them depends on parameters.
    pub fn constant(&self) -> Option<[f64; 2]> {
        let value = |place: usize, other: f64| match (&self.texts[place], &self.amounts[place]) {
            (None, _) => Some(other),
            (Some(_), amount) => amount.as_ref()?.constant(),
        };
        Some([value(0, f64::NEG_INFINITY)?, value(1, f64::INFINITY)?])
    }

    /// The window is within the motion of a case, with at least one step in it.
    ///
    /// # Errors
    /// The rule that it breaks.
    pub fn check(&self, case: &Case, dt: f64, duration: f64) -> Result<(), Violation> {
        let Some(given) = self.amounts.iter().flatten().next() else {
            return Ok(());
        };
        let [from, to] = self.limits(case, [0.0, duration])?;
        let shown = |name: &str, text: &Option<String>, x: f64| match text {
            Some(text) if text.parse::<f64>().is_err() => {
                format!("{name} = {text} = {}", shortest(x))
            }
            Some(_) | None => format!("{name} = {}", shortest(x)),
        };
        let [first, last] = [
            shown(LIMITS[0], &self.texts[0], from),
            shown(LIMITS[1], &self.texts[1], to),
        ];
        let end = format!("the end of the motion, duration = {}", shortest(duration));
        if to > duration * (1.0 + SLACK) {
            return Err(given.violation(format!("{last} is after {end}")));
        }
        if from >= to {
            let message = match self.texts[1] {
                Some(_) => format!("{first} is not before {last}"),
                None => format!("{first} is not before {end}"),
            };
            return Err(given.violation(message));
        }
        let steps = crate::metrics::steps(duration, dt) as usize;
        if self.steps(case, dt, steps + 1).is_none() {
            let message = format!(
                "no step is between {first} and {last}, dt = {}",
                shortest(dt)
            );
            return Err(given.violation(message));
        }
        Ok(())
    }

    /// The steps in it, of so many that are `dt` apart: those at times t with from <= t <= to. `None` if there are none.
    pub fn steps(&self, case: &Case, dt: f64, count: usize) -> Option<Range<usize>> {
        if !self.is_given() {
            return (count > 0).then_some(0..count);
        }
        let end = count.checked_sub(1)? as f64 * dt;
        let [from, to] = self.limits(case, [0.0, end]).ok()?;
        let first = step_from(from, dt);
        let after = ((to / dt * (1.0 + SLACK)).floor() as usize + 1).min(count);
        (first < after).then_some(first..after)
    }

    /// The first step in it.
    pub fn first_step(&self, case: &Case, dt: f64) -> usize {
        if !self.is_given() {
            return 0;
        }
        let from = self.limits(case, [0.0, f64::INFINITY]);
        from.map_or(0, |[from, _]| step_from(from, dt))
    }

    /// The points in it at these times, which rise. `None` if there are none.
    pub fn points(&self, case: &Case, times: &[f64]) -> Option<Range<usize>> {
        let ends = [f64::NEG_INFINITY, f64::INFINITY];
        within(self.limits(case, ends).ok()?, times)
    }

    /// Why it has too few of these measured times; `None` if it has enough, or no limit.
    pub fn check_points(&self, case: &Case, times: &[f64], fewest: usize) -> Option<Violation> {
        let given = self.amounts.iter().flatten().next()?;
        let count = self.points(case, times).map_or(0, |points| points.len());
        let message =
            format!("{count} measured points are in the window; allowed: at least {fewest}");
        (count < fewest).then(|| given.violation(message))
    }
}

/// The first step that is not before a time.
fn step_from(from: f64, dt: f64) -> usize {
    (from / dt * (1.0 - SLACK)).ceil() as usize
}

/// The points at these rising times that are within limits; `None` if there are none.
pub fn within([from, to]: [f64; 2], times: &[f64]) -> Option<Range<usize>> {
    let slack = |t: f64| SLACK * t.abs();
    let first = times.partition_point(|t| *t < from - slack(from));
    let after = times.partition_point(|t| *t <= to + slack(to));
    (first < after).then_some(first..after)
}

impl Reduction {
    /// Whether it may be of a part of the motion.
    pub fn has_window(self) -> bool {
        match self.row().function {
            Function::Values(_)
            | Function::Distance(..)
            | Function::Pair(..)
            | Function::Estimated
            | Function::Contact(..)
            | Function::Measured(_)
            | Function::Loop(_) => true,
            Function::Perturbed(_) => self == Reduction::Difference,
            Function::Energies(_) | Function::Ground(_) | Function::Told => false,
        }
    }
}

/// Why a metric has no window, with those that have one.
pub fn no_window(name: &str) -> String {
    let windowed = Reduction::all().filter(|reduction| reduction.has_window());
    let having: Vec<&str> = windowed.map(Reduction::name).collect();
    format!(
        "{name} is of the whole motion and takes no from= and to=; these do: {}",
        having.join(", ")
    )
}
