//! The kinds of figure, one file each: its keys, what is decoded from them, its checks, and which results it needs. The
//! sheet of each is in `figures/kind`, since a study is read below the drawing.

mod ensembles;
mod metrics;
mod model;
mod motion;
use super::checker::Checker;
pub use super::choice::{Each, Fit, Marks, Ridge};
use super::keys::{COMMON, Key};
use super::values::Values;
use crate::scope::Scope;
use crate::{ColumnRef, Scale};
use slipgap_problem::problem::{Case, Problem};

/// One kind of figure.
pub(crate) struct Kind {
    pub name: &'static str,
    /// What it needs of the problem.
    pub needs: Needs,
    pub meaning: &'static str,
    /// Keys beyond those of every figure.
    pub keys: &'static [Key],
    /// What its values mean; `None` where a required one is missing.
    pub decode: fn(&Values, &Scope) -> Option<FigureKind>,
}

/// What a kind of figure needs of the problem.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Needs {
    /// Parameters, metrics or histories, which every problem has.
    Nothing,
    /// Quantities along the structure.
    Profiles,
    /// A structure that the study describes.
    Structure,
    /// One contact, whose law is among the parameters.
    OneContact,
    /// Nothing of the problem; the study has an ensemble.
    Ensemble,
}

/// A kind of figure with its values.
pub(crate) trait Decoded {
    /// Scales of the two axes that `x_range` and `y_range` limit, and how many quantities share the vertical axis; `None`
    /// for a kind without these keys.
    fn limited_axes(&self) -> Option<([Scale; 2], usize)>;

    /// Reports faults for any cases.
    fn check_keys(&self, _: &mut Checker) {}

    /// Reports cases that the figure cannot show.
    fn check_cases(&self, checker: &mut Checker);

    /// The rows of the study's measures that it shows.
    fn measures(&self, _: &dyn Problem) -> Vec<usize> {
        Vec::new()
    }

    /// The columns of the results that it reads; `None` for all of them.
    fn columns(&self) -> Option<Vec<ColumnRef>> {
        None
    }

    /// Whether it draws histories.
    fn draws_histories(&self) -> bool {
        false
    }

    /// Whether it draws quantities along the structure.
    fn draws_snapshots(&self) -> bool {
        false
    }

    /// The times of its snapshots of a case that ends at `end`, of this number of steps; none for a kind without snapshots.
    fn snapshot_times(&self, _end: f64, _steps: u64) -> Vec<f64> {
        Vec::new()
    }
}

macro_rules! kinds {
    ($($group:ident :: $module:ident :: $kind:ident),+ $(,)?) => {
        $(pub use $group::$module::$kind;)+

        /// What a figure shows.
        #[derive(Debug)]
        pub enum FigureKind {
            $(#[doc = concat!("See [`", stringify!($kind), "`].")] $kind($kind)),+
        }

        impl FigureKind {
            pub(crate) fn decoded(&self) -> &dyn Decoded {
                match self {
                    $(FigureKind::$kind(kind) => kind),+
                }
            }
        }

        /// Every kind of figure: the table that decoding, schema and documentation read.
        pub(crate) static KINDS: &[Kind] = &[$($group::$module::KIND),+];
    };
}

pub use motion::spectrum::Ordinate;

kinds! {
    motion::history::History,
    motion::curve::Curve,
    motion::orbit::Orbit,
    motion::response::Response,
    motion::profile::Profile,
    motion::wave::Wave,
    metrics::metric::Metric,
    metrics::convergence::Convergence,
    metrics::budget::Budget,
    metrics::map::Map,
    metrics::scatter::Scatter,
    metrics::front::Front,
    metrics::envelope::Envelope,
    ensembles::samples::Samples,
    ensembles::sobol::Sobol,
    ensembles::distribution::Distribution,
    ensembles::quantiles::Quantiles,
    ensembles::fragility::Fragility,
    model::law::Law,
    motion::spectrum::Spectrum,
    motion::set::Set,
    model::scheme::Scheme,
}

impl FigureKind {
    /// The fragility that it shows, if it is one.
    pub fn fragility(&self) -> Option<&Fragility> {
        let FigureKind::Fragility(fragility) = self else {
            return None;
        };
        Some(fragility)
    }

    /// Whether the figure draws histories of the cases.
    pub fn draws_histories(&self) -> bool {
        self.decoded().draws_histories()
    }

    /// The rows of the study's measures that it shows.
    pub fn measures(&self, problem: &dyn Problem) -> Vec<usize> {
        self.decoded().measures(problem)
    }

    /// The columns of the results that the figure reads; `None` for all of them.
    pub fn columns(&self) -> Option<Vec<ColumnRef>> {
        self.decoded().columns()
    }

    /// Whether the figure draws quantities along the structure.
    pub fn draws_snapshots(&self) -> bool {
        self.decoded().draws_snapshots()
    }

    /// The times at which it draws quantities along the structure of a case; none for kinds without them.
    pub fn snapshot_times(&self, case: &Case) -> Vec<f64> {
        let end = case.at(case.schema.duration).unwrap_or(0.0);
        self.decoded().snapshot_times(end, case.steps())
    }
}

impl Kind {
    /// Whether the problem has what it needs.
    pub fn suits(&self, problem: &dyn Problem) -> bool {
        match self.needs {
            Needs::Nothing | Needs::Ensemble => true,
            Needs::Profiles => !problem.schema().profiles.is_empty(),
            Needs::Structure => problem.schema().described,
            Needs::OneContact => !problem.schema().described,
        }
    }

    /// Whether it draws converged steps only.
    pub fn needs_convergence(&self) -> bool {
        self.needs == Needs::Profiles
    }
}

/// Names of all kinds.
pub(crate) fn names() -> Vec<&'static str> {
    KINDS.iter().map(|kind| kind.name).collect()
}

/// Names of all keys of figures, each once.
pub(crate) fn all_keys() -> Vec<&'static str> {
    let mut names: Vec<&str> = COMMON.iter().map(|key| key.name).collect();
    for key in KINDS.iter().flat_map(|kind| kind.keys) {
        if !names.contains(&key.name) {
            names.push(key.name);
        }
    }
    names
}

/// Names of the kinds that take `key`.
pub(crate) fn takers(key: &str) -> Vec<&'static str> {
    KINDS
        .iter()
        .filter(|kind| kind.keys.iter().any(|k| k.name == key))
        .map(|kind| kind.name)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::keys::Takes;
    use crate::{Study, parse};
    use std::collections::HashSet;
    use std::mem::discriminant;

    /// A study of bars with a figure of each kind.
    fn studies() -> [Study; 4] {
        let study = |parameters: &str, figures: &str| {
            let text = format!(
                r#"{{"problem": "bar-impact", "parameters": {{"n": 4, "duration": 1, {parameters}, "figures": [{figures}]}}"#
            );
            parse("s", &text).unwrap_or_else(|e| panic!("{e}"))
        };
        [
            study(
                r#""gamma": [1, 2], "dt": [0.01, 0.02]}"#,
                r#"{"name": "a", "kind": "history"}, {"name": "b", "kind": "profile", "times": [0, 1]},
                   {"name": "c", "kind": "wave", "where": {"gamma": 1, "dt": 0.01}},
                   {"name": "d", "kind": "metric", "x": "gamma", "y": "peak_force"},
                   {"name": "e", "kind": "convergence", "y": "peak_force"},
                   {"name": "f", "kind": "budget", "x": "dt", "where": {"gamma": 1}},
                   {"name": "g", "kind": "map", "x": "gamma", "y": "dt", "z": "peak_force"},
                   {"name": "h", "kind": "scatter", "x": "gamma", "y": "peak_force"}, {"name": "i", "kind": "law"},
                   {"name": "j", "kind": "curve", "x": "r", "y": "force"},
                   {"name": "k", "kind": "front", "x": "peak_force", "y": "rms_error_r", "by": "gamma"},
                   {"name": "l", "kind": "envelope", "x": ["peak_force", "rms_error_r"]}"#,
            ),
            study(
                r#""gamma": {"uniform": [1, 2]}, "dt": {"uniform": [0.01, 0.02]}},
                   "design": {"kind": "saltelli", "n": 4}"#,
                r#"{"name": "a", "kind": "samples", "y": "peak_force"},
                   {"name": "b", "kind": "sobol", "y": "peak_force"}"#,
            ),
            study(
                r#""gamma": [1, 2], "gap": [0, 0.1], "dt": 0.01}, "ensemble": "gap""#,
                r#"{"name": "a", "kind": "distribution", "y": "peak_force"},
                   {"name": "b", "kind": "quantiles", "x": "gamma", "y": "peak_force"},
                   {"name": "c", "kind": "fragility", "x": "gamma", "y": "peak_force", "limit": 1}"#,
            ),
            parse(
                "s",
                r#"{"problem": "structure", "parameters": {"dt": 0.01, "duration": 1}, "metrics": ["peak(m)"],
                  "structure": {"masses": {"m": 1}, "springs": [{"between": ["ground", "m"], "k": 1, "name": "s"}],
                    "loads": [{"at": "m", "sine": {"amplitude": 1, "omega": 10}}],
                    "ground": {"synthetic": {"seed": 1}, "scale_to": {"factor": 1, "set":
                      {"rule": "EN 1998-1", "period": 1, "spectrum": {"T": [1], "Sa": [1]}}}}},
                  "figures": [{"name": "a", "kind": "scheme"}, {"name": "d", "kind": "set"}, {"name": "b", "kind": "spectrum", "y": "displacement"},
                    {"name": "c", "kind": "orbit", "x": "m", "y": "m.v"}, {"name": "e", "kind": "response", "y": "m"}]}"#,
            )
            .unwrap_or_else(|e| panic!("{e}")),
        ]
    }

    #[test]
    fn every_kind_decodes_to_its_variant_with_axes_for_its_ranges() {
        let studies = studies();
        let figures: Vec<_> = studies.iter().flat_map(|study| &study.figures).collect();
        let variants: HashSet<_> = figures.iter().map(|f| discriminant(&f.kind)).collect();
        assert_eq!([figures.len(), variants.len()], [KINDS.len(); 2]);
        for figure in figures {
            // Debug writes the name of the variant, which is that of the kind.
            let written = format!("{:?}", figure.kind).to_lowercase();
            let named = |kind: &&Kind| {
                written.split(|c: char| !c.is_alphabetic()).next() == Some(kind.name)
            };
            let kind = KINDS.iter().find(named).unwrap();
            let has = |name: &str| kind.keys.iter().any(|key| key.name == name);
            let limited = figure.kind.decoded().limited_axes().is_some();
            assert_eq!(
                [has("x_range"), has("y_range")],
                [limited; 2],
                "{}",
                kind.name
            );
            let metrics = kind.keys.iter().any(|key| {
                use Takes::{Budgets, Column, Metric, Metrics};
                matches!(key.takes, Metric | Metrics | Column | Budgets)
            });
            let problem = &*studies[0].problem;
            let measures = figure.kind.decoded().measures(problem);
            assert_eq!(!measures.is_empty(), metrics, "{}", kind.name);
        }
    }
}
