//! The candidates of an impact of two bars, and their values in tables and studies.

use super::Impact;
use super::energy::energy_gain;
use super::mesh::{MOST_ELEMENTS, PASSES, WITH_EVERY_MESH};
use crate::history::History;
use crate::problem::impact::BarImpact;
use crate::problem::parameter::shortest;
use crate::problem::{Case, Problem};
use crate::recommend::format::{digits, is_positive_integer, plain};
use crate::recommend::grid::decades;
use crate::recommend::{CostLevel, SearchSpace, metric};

/// Smallest and largest gamma.
const GAMMAS: [f64; 2] = [0.01, 10.0];

/// Position of the impact in a step, 0..1, for neighbours.
const INTO: [f64; 2] = [0.37, 0.71];

impl SearchSpace for Impact {
    fn problem(&self) -> &'static dyn Problem {
        &BarImpact
    }

    fn table_parameters(&self) -> Vec<&'static str> {
        let mut names = vec!["gamma"];
        // k_I has the units of the bars, and is useful only if the user gives data in these units.
        let data = !self.fixed.bars.is_empty() || self.fixed.spring.is_some();
        names.extend(data.then_some("k_I"));
        names.push("n");
        names.extend(self.time_ratio.map(|_| "right.n"));
        names.extend(["dt", "mass"]);
        names
    }

    fn study_parameters(&self) -> Vec<&str> {
        let spring = self.fixed.spring.map_or("gamma", |(name, _)| name);
        let mut names = vec![spring, "n", "dt", "duration", "mass"];
        let bars = self.fixed.bars.iter().map(|(name, _)| &**name);
        names.extend(bars.filter(|name| *name != "right.n"));
        names.extend(self.time_ratio.map(|_| "right.n"));
        names
    }

    fn table_cell(&self, case: &Case, name: &str) -> String {
        match (name, case.number(name)) {
            // One of them is computed from the other and has many digits.
            ("gamma" | "k_I", Some(x)) => digits(x),
            _ => self.study_value(case, name),
        }
    }

    fn study_value(&self, case: &Case, name: &str) -> String {
        match (name, case.number(name)) {
            ("dt", Some(x)) => fraction(x).unwrap_or_else(|| shortest(x)),
            _ => plain(case, name),
        }
    }

    fn notes(&self) -> Vec<String> {
        let passes = |at: usize| shortest(PASSES[at]);
        let spring = match self.fixed.spring {
            Some((name, x)) => format!("{name} = {}", shortest(x)),
            None => format!("gamma {} .. {}, 20 a decade", GAMMAS[0], GAMMAS[1]),
        };
        let n = match self.fixed.n {
            Some(n) => format!("n = {n}"),
            None => format!(
                "every n 2 .. {MOST_ELEMENTS} (steps below {} elements: in ratios of 1.05)",
                passes(WITH_EVERY_MESH - 1)
            ),
        };
        let mut notes = vec![
            format!(
                "searched: {spring}; {n}; mass {}; dt of {} .. {} elements passed by a wave; duration {}",
                self.masses().join(" and "),
                passes(0),
                passes(PASSES.len() - 1),
                shortest(self.duration)
            ),
            match self.fixed.spring {
                None => format!(
                    "neighbours that must also reach the target: gamma 12 % smaller and larger, impact {} into a step",
                    INTO[0]
                ),
                Some(_) => format!(
                    "neighbours that must also reach the target: impact {} and {} into a step",
                    INTO[0], INTO[1]
                ),
            },
            "not searched: other steps than these parts of an element, elements of different lengths in a bar, steps \
             without iteration, larger gaps"
                .into(),
        ];
        if self.time_ratio.is_some() {
            notes.push(
                "the right bar has elements of the same travel time, at least 2, unless right.n is given".into(),
            );
        }
        if self.peak != 1.0 {
            notes.push(format!(
                "exact peak of the force: {} F0",
                shortest(self.peak)
            ));
        }
        notes
    }

    fn cost_title(&self) -> &'static str {
        "steps × modes"
    }

    fn costs(&self) -> Vec<u64> {
        self.meshes.iter().map(|(_, cost)| *cost).collect()
    }

    fn level(&self, index: usize) -> CostLevel {
        let (mesh, _) = self.meshes[index];
        let mut level = CostLevel::default();
        if let Some(spring) = self.fixed.spring {
            let into = [0.0, INTO[0], INTO[1]];
            level.cases = into.map(|into| self.case(spring, mesh, into)).to_vec();
            level.candidates = vec![vec![0, 1, 2]];
            return level;
        }
        let gammas = decades(GAMMAS[0], GAMMAS[1], 20.0);
        for into in [0.0, INTO[0]] {
            let cases = gammas
                .iter()
                .map(|gamma| self.case(("gamma", *gamma), mesh, into));
            level.cases.extend(cases);
        }
        let count = gammas.len();
        level.candidates = (1..count - 1)
            .map(|i| vec![i, i - 1, i + 1, i + count])
            .collect();
        level
    }

    fn energy_drifts(&self) -> Option<[usize; 2]> {
        Some(["energy_drift_max", "energy_drift_final"].map(|name| metric(&BarImpact, name)))
    }

    fn energy_gain(&self, case: &Case, computed: &History) -> Option<f64> {
        energy_gain(case, computed)
    }
}

/// Largest numerator of a fraction.
const NUMERATORS: i32 = 9;

/// A number as a fraction k/m with small k, if the fraction gives the same double.
fn fraction(x: f64) -> Option<String> {
    let k = (1..=NUMERATORS).find(|k| is_positive_integer(f64::from(*k) / x))?;
    let denominator = (f64::from(k) / x).round();
    (f64::from(k) / denominator == x).then(|| format!("{k}/{denominator}"))
}
