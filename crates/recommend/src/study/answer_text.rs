//! The answer in words: what becomes of each candidate, what metrics are compared with, and what the answer is worth.

use super::errors::From;
use super::verdict::{Mesh, State, Trial};
use super::{Advice, NotConverged};
use crate::format::digits;
use slipgap_motion::solve::WARNINGS;
use slipgap_problem::problem::numbers::parameter::{Value, shortest};

impl Advice {
    /// The rows and names of the parameters that candidates have.
    pub fn parameters(&self) -> Vec<(usize, &str)> {
        let recommend = self.study.recommend.iter();
        let rows = recommend.flat_map(|recommend| {
            let free = recommend.free.iter().map(|free| free.parameter);
            recommend.over.iter().copied().chain(free)
        });
        rows.map(|row| (row, self.name(row))).collect()
    }

    /// The metrics to keep, each with its tolerance.
    pub fn within(&self) -> Vec<(&str, f64)> {
        let within = self
            .study
            .recommend
            .iter()
            .flat_map(|recommend| &recommend.within);
        let name = |row: usize| self.study.measures[row].name.as_str();
        within
            .map(|(row, tolerance)| (name(*row), *tolerance))
            .collect()
    }

    /// What becomes of a candidate.
    pub fn verdict(&self, at: usize) -> String {
        let choice = &self.choices[at];
        if self.chosen == Some(at) {
            return "recommended".into();
        }
        match &choice.state {
            State::Keeps => match choice.trial {
                None => "keeps all, costs more".into(),
                Some(trial) => self.lacks(trial),
            },
            State::Misses => {
                let metrics = self.within().into_iter().zip(&choice.errors);
                let beyond = metrics.filter(|((_, tolerance), error)| *error > tolerance);
                let missed: Vec<&str> = beyond.map(|((name, _), _)| name).collect();
                format!("misses {}", missed.join(", "))
            }
            State::Energy => "gains or loses energy".into(),
            State::ContactEnergy => "a contact may make energy".into(),
            State::Unsolved(why) => format!("not solved: {why}"),
            State::Incomplete => "does not have all physical cases".into(),
        }
    }

    /// What a candidate lacks that keeps all metrics and is not recommended.
    fn lacks(&self, trial: Trial) -> String {
        let lists = &self.not_converged;
        if !trial.is_converged() {
            "only with this step or mesh".into()
        } else if trial.neighbours > 1.0 {
            "a neighbour does not keep all".into()
        } else if !trial.holds() {
            "only with the seeds of the study".into()
        } else {
            let names: Vec<&str> = lists.iter().map(|list| self.name(list.parameter)).collect();
            format!("not converged in {}", names.join(", "))
        }
    }

    /// What the metrics are compared with, what the warnings are, and whether the recommended candidate holds in further tests.
    pub fn sentences(&self) -> Vec<String> {
        let mut lines = vec![match self.conditions {
            1 => "There is one physical case.".to_owned(),
            count => format!("Each error is the largest one of {count} physical cases."),
        }];
        if let Some(reference) = &self.reference {
            let finest = self.named(&reference.finest);
            let metrics = self.within().into_iter().zip(&reference.from);
            lines.extend(metrics.map(|((metric, _), from)| match from {
                From::Zero => format!("{metric} is an error itself."),
                From::Exact => format!("{metric}: relative to the exact motion of {finest}."),
                From::Finest => {
                    format!("{metric}: relative to the finest motion, {finest} with half the step.")
                }
            }));
        }
        lines.extend(self.searched.map(|[compared, count]| {
            format!(
                "Of {count} candidates {compared} were compared, up to the cost of the answer. Shown are those with smaller errors than all \
                 cheaper ones, and those that keep all metrics."
            )
        }));
        lines.extend(self.warnings());
        lines.extend(self.not_converged.iter().map(|list| self.list_ends(list)));
        lines.extend(self.answer());
        lines
    }

    /// How many candidates have each warning.
    fn warnings(&self) -> impl Iterator<Item = String> {
        WARNINGS.into_iter().filter_map(|kind| {
            let with = self
                .choices
                .iter()
                .filter(|choice| choice.warnings.has(kind));
            let (count, of) = (with.count(), self.choices.len());
            (count > 0).then(|| {
                let (name, message) = (kind.name(), kind.message());
                format!("Warning {name}: {count} of {of} candidates {message}.")
            })
        })
    }

    fn list_ends(&self, list: &NotConverged) -> String {
        let (name, within) = (self.name(list.parameter), self.within());
        let [before, last] = list.values.map(shown);
        let (metric, tolerance) = within[list.metric];
        let (change, tolerance) = (cell(list.change), shortest(tolerance));
        format!(
            "Not converged in {name}: from {name} = {before} to {last} {metric} changes by {change}, more than its tolerance {tolerance}. \
             Continue the list, or compare with rigid contact (\"contacts_reference\": \"rigid\"); the force of an impact grows with k, and needs that of the real contact."
        )
    }

    /// The recommended candidate, else the nearest one.
    fn answer(&self) -> Option<String> {
        let choices = self.choices.iter();
        let nearest = choices.min_by(|a, b| a.worst.total_cmp(&b.worst));
        let shown = self.chosen.map(|at| &self.choices[at]).or(nearest);
        let choice = shown.filter(|choice| choice.worst.is_finite())?;
        let name = self.named(&choice.values);
        let Some(trial) = choice.trial.filter(|_| self.chosen.is_some()) else {
            let worst = digits(choice.worst);
            return Some(format!(
                "Nearest: {name}. Its largest error is {worst} times its tolerance."
            ));
        };
        let mesh = match trial.mesh {
            Mesh::NotChosen => String::new(),
            Mesh::Next(mesh) => format!(", with the next finer mesh {}", cell(mesh)),
            Mesh::Finest => {
                ". No candidate has a finer mesh, which would show the error of this one".into()
            }
        };
        let fresh = trial.fresh.map_or(String::new(), |fresh| {
            format!(" With fresh seeds it is {}.", cell(fresh))
        });
        let only = match trial.is_converged() {
            true => "",
            false => "Warning: this answer is valid only for its own step and mesh. ",
        };
        let step = cell(trial.step);
        let finer = match self.searched {
            None => "half",
            Some(_) => "1/2, 1/4, 1/8 and 1/16 of",
        };
        Some(format!(
            "{only}Recommended: {name}. With {finer} its step the largest error is {step} of its tolerance{mesh}.{fresh}"
        ))
    }

    fn named(&self, values: &[(usize, Value)]) -> String {
        let one =
            |(row, value): &(usize, Value)| format!("{} = {}", self.name(*row), shown(*value));
        values.iter().map(one).collect::<Vec<_>>().join(", ")
    }

    /// The name of a parameter.
    pub fn name(&self, row: usize) -> &str {
        &self.study.problem.parameters()[row].name
    }
}

/// A number of a sentence.
fn cell(x: f64) -> String {
    if x.is_finite() { digits(x) } else { "-".into() }
}

/// A value with at most ten digits, which a search may give more of.
pub fn shown(value: Value) -> String {
    match value {
        Value::Number(x) => shortest(format!("{x:.9e}").parse().unwrap_or(x)),
        other @ (Value::Whole(_) | Value::Name(_)) => other.to_string(),
    }
}
