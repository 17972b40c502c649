//! The keys of a study for searches. `calibrate`: free parameters with ranges, the metric to minimise, and the cases of a search;
//! `recommend`: parameters to choose, and metrics to keep.

mod alternatives;
mod best;
mod candidates;
pub(super) mod decode;
mod edit;
mod files;
mod nodes;
mod points;
mod print;
pub(super) mod range;
pub(super) mod recommend;

pub use alternatives::Alternative;
pub use candidates::Candidates;
pub use points::PointCases;
pub use range::FreeRange;
pub use recommend::Recommend;

use crate::Study;
use crate::computed::metrics_of;
use slipgap_problem::problem::Case;

/// Most values of an axis that is looked at for repeated ones.
const LONGEST_LIST: usize = 1000;

/// Free parameters of a study and the metric that their best values minimise.
#[derive(Debug, Clone, PartialEq)]
pub struct Calibrate {
    /// The free parameters, in the order of the file.
    pub free: Vec<Free>,
    /// Row of the study's measures.
    pub minimise: usize,
    /// Seed of the search.
    pub seed: u64,
    /// Most cases that the search of an alternative solves.
    pub cases: u64,
    /// Row of the parameter that chooses the file of measurements, if it is an axis: its values are tests with one misfit together.
    pub tests: Option<usize>,
    /// Rows of the free parameters that vary from test to test; each test is then fitted alone, too.
    pub varies: Vec<usize>,
}

/// A free parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Free {
    /// Row of `problem.parameters()`.
    pub parameter: usize,
    /// Its range.
    pub range: FreeRange,
}

impl Study {
    /// What was done to input files that the study does not ask for, what may be a mistake, such as a value twice in an axis, and that its
    /// free parameters are not searched here, in words.
    pub fn notes(&self) -> Vec<String> {
        let table = self.problem.parameters();
        let parameters = self.calibrate.iter().flat_map(|calibrate| &calibrate.free);
        let names: Vec<&str> = parameters
            .map(|parameter| &*table[parameter.parameter].name)
            .collect();
        let free = (!names.is_empty()).then(|| {
            format!(
                "{}: the values are those of the study; `slipgap calibrate` finds the best ones",
                names.join(", ")
            )
        });
        let notes = self
            .problem
            .as_structure()
            .map_or(&[][..], |structure| structure.notes())
            .iter()
            .cloned();
        notes.chain(self.repeated_values()).chain(free).collect()
    }

    /// The axes of their own with a value twice, whose cases are computed twice.
    fn repeated_values(&self) -> Vec<String> {
        let groups = self.blocks.iter().flat_map(|block| &block.groups);
        let alone = groups.filter_map(|group| match &group.axes[..] {
            [axis] => Some(axis),
            _ => None,
        });
        let mut notes: Vec<String> = Vec::new();
        for axis in alone {
            // Longer ones are by rule.
            if axis.values.len() > LONGEST_LIST {
                continue;
            }
            let mut texts: Vec<String> =
                axis.values.iter().map(|value| value.to_string()).collect();
            texts.sort_unstable();
            if let Some(twice) = texts.windows(2).find(|pair| pair[0] == pair[1]) {
                let name = &self.problem.parameters()[axis.parameter].name;
                let note = format!("{name} has the value {} twice: its cases repeat", twice[0]);
                if !notes.contains(&note) {
                    notes.push(note);
                }
            }
        }
        notes
    }

    /// The value of a measure in a case from its metrics, in the order of the problem's table; `None` if it is undefined.
    pub fn measure_value(
        &self,
        row: usize,
        case: &Case,
        metric: &dyn Fn(usize) -> Option<f64>,
    ) -> Option<f64> {
        let measure = &self.measures[row];
        match (&measure.computed, measure.metric) {
            (Some(computed), _) => {
                // A measure is computed from earlier ones.
                let of =
                    |part: usize| (part < row).then(|| self.measure_value(part, case, metric))?;
                computed.value(case, &of).filter(|x| x.is_finite())
            }
            (None, Some(metric_row)) => metric(metric_row),
            (None, None) => None,
        }
    }

    /// Whether arithmetic of a measure contains a parameter.
    pub fn measure_contains(&self, row: usize, parameter: usize) -> bool {
        let count = self.problem.parameters().len();
        let Some(computed) = &self.measures[row].computed else {
            return false;
        };
        let mut parts = computed.uses(count).into_iter();
        computed.contains(parameter)
            || parts.any(|part| part < row && self.measure_contains(part, parameter))
    }

    /// The metric of the problem that `calibrate` minimises, if it is one alone.
    pub fn minimised_metric(&self) -> Option<usize> {
        let calibrate = self.calibrate.as_ref()?;
        let measure = &self.measures[calibrate.minimise];
        let count = self.problem.parameters().len();
        match measure.computed {
            None => measure.metric,
            // A name of the study for one metric.
            Some(_) => match metrics_of(&self.measures, calibrate.minimise, count)[..] {
                [metric] if self.measures[metric].name == measure.meaning => Some(metric),
                _ => None,
            },
        }
    }
}
