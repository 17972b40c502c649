//! The candidates of an impact of two bars, and their values in tables and studies.

use super::Impact;
use super::energy::energy_change;
use super::mesh::{MOST_ELEMENTS, Mesh, PASSES, WITH_EVERY_MESH};
use super::variants::{has_impulses, is_rigid, masses};
use crate::format::{digits, is_positive_integer, plain};
use crate::grid::decades;
use crate::setting::{has_sub_steps, method_named, method_parameters, sentence};
use crate::{CostLevel, EnergyChange, Grid, SearchSpace, Setting, Variant, Variants, metric};
use slipgap_problem::problem::impact::BarImpact;
use slipgap_problem::problem::numbers::parameter::{Value, shortest};
use slipgap_problem::problem::{Case, Problem, Solution};
use slipgap_system::methods::AverageAcceleration;
use std::sync::OnceLock;

/// Smallest and largest gamma.
pub const GAMMAS: [f64; 2] = [0.01, 10.0];

/// One of so many values of gamma is a candidate of the coarse grid.
const COARSE: usize = 4;

/// Position of the impact in a step, 0..1, for neighbours.
const INTO: [f64; 2] = [0.37, 0.71];

impl SearchSpace for Impact {
    fn problem(&self) -> &'static dyn Problem {
        &BarImpact
    }

    fn table_parameters(&self) -> Vec<&'static str> {
        let mut names = vec!["law", "restitution", "gamma"];
        // k_I has the units of the bars, and is useful only if the user gives data in these units.
        let data = !self.fixed.bars.is_empty() || self.fixed.spring.is_some();
        names.extend(data.then_some("k_I"));
        names.push("n");
        names.extend(self.time_ratio.map(|_| "right.n"));
        names.extend(["dt", "mass", "method"]);
        names.extend(method_parameters());
        names
    }

    fn study_parameters(&self) -> Vec<&str> {
        let spring = self.fixed.spring.map_or("gamma", |(name, _)| name);
        let mut names = vec!["law", "restitution", spring, "n", "dt", "duration", "mass"];
        names.push("method");
        names.extend(method_parameters());
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
            // A study may not give it: the method ignores it.
            ("restitution", _)
                if is_rigid(case.choice("law")) && !has_impulses(case.choice("method")) =>
            {
                "-".into()
            }
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
                "every n 2 .. {MOST_ELEMENTS} with steps of {} elements (others: in ratios of 1.05)",
                PASSES[..WITH_EVERY_MESH]
                    .iter()
                    .map(|x| shortest(*x))
                    .collect::<Vec<_>>()
                    .join(", ")
            ),
        };
        let mut notes = vec![
            format!(
                "searched: {}; {}",
                sentence(self.variants.iter().map(|v| &v.law)),
                sentence(self.variants.iter().map(|v| &v.method)),
            ),
            format!(
                "{spring}; {n}; mass {}; dt of {} .. {} elements passed by a wave, close to each other from 0.4 to 1; duration {}",
                masses(self.fixed.mass).join(" and "),
                passes(0),
                passes(PASSES.len() - 1),
                shortest(self.duration)
            ),
            match self.fixed.spring {
                None => format!(
                    "neighbours that must also reach the target: gamma 12 % smaller and larger, impact {} into a step; with \
                     rigid contact impact {} and {} into a step",
                    INTO[0], INTO[0], INTO[1]
                ),
                Some(_) => format!(
                    "neighbours that must also reach the target: impact {} and {} into a step",
                    INTO[0], INTO[1]
                ),
            },
            "not searched: law rigid unless it is given (its force depends on the step), other restitutions and parameters of \
             methods, other steps than these parts of an element, steps that break a rule (above the critical step), elements of \
             different lengths in a bar, steps without iteration, larger gaps"
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
        match has_sub_steps(&self.variants) {
            true => "steps × modes × sub-steps",
            false => "steps × modes",
        }
    }

    fn costs(&self) -> Vec<u64> {
        self.levels().iter().map(|(_, _, cost)| *cost).collect()
    }

    fn level(&self, index: usize) -> CostLevel {
        let (variant, mesh, _) = self.levels()[index];
        let variant = &self.variants[variant];
        match (self.fixed.spring, is_rigid(variant.law.name)) {
            (Some(spring), _) => self.one_stiffness(variant, spring, mesh),
            (None, true) => self.one_stiffness(variant, ("gamma", 1.0), mesh),
            (None, false) => self.stiffnesses(variant, mesh),
        }
    }

    fn energy_bounds(&self, case: &Case, metrics: &[Option<f64>]) -> [EnergyChange; 2] {
        let drifts = ["energy_drift_max", "energy_drift_final"];
        let drifts = drifts.map(|name| metrics.get(metric(&BarImpact, name)).copied().flatten());
        let [Some(largest), Some(last)] = drifts else {
            return [EnergyChange::UNKNOWN; 2];
        };
        // Other methods change the energy, too.
        if !method_named(case.choice("method")).is_some_and(|method| method.conserves()) {
            return [EnergyChange::NONE, EnergyChange::UNKNOWN];
        }
        // If a loss is larger than all gains, the gain is unknown.
        let gains = match largest >= 0.0 {
            true => [largest, largest],
            false => [last.max(0.0), -largest],
        };
        let loss = (-last).max(0.0);
        // Without damping the drift of the contact is the only change.
        let damped = case.number("restitution").is_some();
        let losses = [loss, if damped { f64::INFINITY } else { loss }];
        [0, 1].map(|of| EnergyChange {
            gain: gains[of],
            loss: losses[of],
        })
    }

    fn energy_change(&self, case: &Case, solution: &Solution) -> EnergyChange {
        energy_change(case, &solution.computed).unwrap_or(EnergyChange::UNKNOWN)
    }
}

impl Impact {
    /// One candidate, with the impact at several positions of a step.
    fn one_stiffness(&self, variant: &Variant, spring: Spring, mesh: Mesh) -> CostLevel {
        let cases = [0.0, INTO[0], INTO[1]].map(|into| self.completed(variant, spring, mesh, into));
        let allowed = cases.iter().all(|(_, broken)| broken.is_empty());
        CostLevel {
            cases: cases.map(|(case, _)| case).to_vec(),
            candidates: allowed.then(|| vec![0, 1, 2]).into_iter().collect(),
        }
    }

    /// A candidate for each gamma that breaks no rule.
    fn stiffnesses(&self, variant: &Variant, mesh: Mesh) -> CostLevel {
        let gammas = decades(GAMMAS[0], GAMMAS[1], 20.0);
        let spring = |gamma: f64| ("gamma", gamma);
        // The critical step of a method falls as gamma rises.
        let keeps_rules = |gamma: &f64| {
            let (_, broken) = self.completed(variant, spring(*gamma), mesh, 0.0);
            broken.is_empty()
        };
        let allowed = gammas.partition_point(keeps_rules);
        let every = match self.grid {
            Grid::Coarse => COARSE,
            Grid::Fine => 1,
        };
        let candidates = (1..allowed.saturating_sub(1)).step_by(every);
        let mut level = CostLevel::default();
        // The index of each gamma at each position of a step.
        let mut indices = [vec![None; gammas.len()], vec![None; gammas.len()]];
        for i in candidates {
            let cells = [(0, i), (0, i - 1), (0, i + 1), (1, i)];
            let case = |(position, i): (usize, usize)| {
                *indices[position][i].get_or_insert_with(|| {
                    let into = [0.0, INTO[0]][position];
                    let case = self.unruled(variant, spring(gammas[i]), mesh, into);
                    level.cases.push(case);
                    level.cases.len() - 1
                })
            };
            level.candidates.push(cells.map(case).to_vec());
        }
        level
    }

    /// A case whose rules are known to hold. They are not tested again, because the critical step of a method is slow to find.
    fn unruled(&self, variant: &Variant, spring: Spring, mesh: Mesh, into: f64) -> Case {
        let usual = Variant {
            method: Setting::new(AverageAcceleration::NAME),
            ..variant.clone()
        };
        let (mut case, _) = self.completed(&usual, spring, mesh, into);
        let rows = self.problem().parameters().iter();
        for (row, name) in rows.map(|p| &*p.name).enumerate() {
            if name == "method" {
                case.values[row] = Some(Value::Name(variant.method.name));
            }
            let mut own = variant.method.parameters.iter();
            if let Some((_, value)) = own.find(|(own, _)| *own == name) {
                case.values[row] = Some(Value::Number(*value));
            }
        }
        case
    }
}

/// `gamma` or `k_I`, and its value.
type Spring = (&'static str, f64);

impl Variants for Impact {
    fn variants(&self) -> &[Variant] {
        &self.variants
    }

    fn variant_of(&self, level: usize) -> usize {
        self.levels()[level].0
    }

    fn with(&self, variants: &[usize], grid: Grid) -> Box<dyn Variants> {
        let variants = variants.iter().map(|at| self.variants[*at].clone());
        Box::new(Impact {
            variants: variants.collect(),
            grid,
            levels: OnceLock::new(),
            ..self.clone()
        })
    }

    fn space(&self) -> &dyn SearchSpace {
        self
    }
}

/// Largest numerator of a fraction.
const NUMERATORS: i32 = 49;

/// A number as a fraction k/m with small k, if the fraction gives the same double.
fn fraction(x: f64) -> Option<String> {
    let k = (1..=NUMERATORS).find(|k| is_positive_integer(f64::from(*k) / x))?;
    let denominator = (f64::from(k) / x).round();
    (f64::from(k) / denominator == x).then(|| format!("{k}/{denominator}"))
}
