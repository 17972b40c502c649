//! The candidates of a friction model, and their values in tables and studies.

use super::laws::{has_bristles, parameters, width};
use super::{EVERY, Friction, MOST, Releases, WIDTHS, X0_DIFFERENCE, energy_gain, released};
use crate::format::{is_positive_integer, plain};
use crate::grid::decades;
use crate::setting::{has_sub_steps, method_parameters, sentence};
use crate::{CostLevel, EnergyChange, Further, Grid, Range, SearchSpace, Variant, Variants};
use slipgap_problem::problem::friction::FrictionOscillator;
use slipgap_problem::problem::numbers::parameter::shortest;
use slipgap_problem::problem::{Case, Problem, Solution};
use std::f64::consts::PI;

/// Widths of a decade.
const DECADE: f64 = 20.0;

/// One of so many widths is a candidate of the coarse grid.
const COARSE: usize = 4;

impl Friction {
    /// Names of the widths, each once.
    fn widths(&self) -> Vec<&'static str> {
        let laws = self.variants.iter();
        let mut widths: Vec<_> = laws.filter_map(|v| width(v.law.name)).collect();
        widths.sort_unstable();
        widths.dedup();
        widths
    }

    /// The neighbours in a sentence.
    fn neighbours(&self) -> String {
        let widths = self.widths();
        let width = match widths.as_slice() {
            [one] => one,
            _ => "width",
        };
        match self.releases {
            Releases::One(_) => format!(
                "neighbours that must also reach the target: {width} 12 % smaller and larger, x0 {} % smaller and larger",
                100.0 * X0_DIFFERENCE
            ),
            Releases::Range(from, to) => format!(
                "every release x0 {} .. {} must reach the target ({} of them, at most 0.1 apart; the first search has {}), each over \
                 its own motion; the cost is that of the longest. Neighbours that must reach it, too: {width} 12 % smaller and larger",
                shortest(from),
                shortest(to),
                self.releases.all().len(),
                self.releases.hardest().len()
            ),
        }
    }

    /// The releases of a level, and whether the neighbours of the width are also tested there.
    fn level_releases(&self) -> Vec<(f64, bool)> {
        match self.releases {
            Releases::One(x0) => {
                let near = [1.0 - X0_DIFFERENCE, 1.0 + X0_DIFFERENCE];
                let near = near.map(|ratio| (ratio * x0, false));
                [&[(x0, true)][..], &near].concat()
            }
            Releases::Range(..) => {
                let hard = self.releases.hardest().into_iter();
                hard.map(|x0| (x0, true)).collect()
            }
        }
    }
}

impl SearchSpace for Friction {
    fn problem(&self) -> &'static dyn Problem {
        &FrictionOscillator
    }

    fn table_parameters(&self) -> Vec<&'static str> {
        let mut names = vec!["law"];
        let [listed, of_widths] = parameters();
        names.extend(listed.into_iter().chain(of_widths));
        names.extend(["dT", "method"]);
        names.extend(method_parameters());
        // The release with the largest error.
        if let Releases::Range(..) = self.releases {
            names.push("x0");
        }
        names
    }

    fn study_parameters(&self) -> Vec<&str> {
        let mut names = vec!["law"];
        let searched = parameters().concat();
        let rows = FrictionOscillator.parameters().iter();
        names.extend(rows.filter_map(|row| searched.iter().find(|name| row.name == **name)));
        names.extend(["dT", "duration", "x0", "method"]);
        names.extend(method_parameters());
        names
    }

    fn study_value(&self, case: &Case, name: &str) -> String {
        match (name, case.number(name)) {
            ("dT", Some(x)) if is_positive_integer(PI / x) => format!("pi/{}", (PI / x).round()),
            ("duration", Some(x)) if is_positive_integer(x / PI) => {
                format!("{}*pi", (x / PI).round())
            }
            _ => plain(case, name),
        }
    }

    fn notes(&self) -> Vec<String> {
        let ends = WIDTHS.map(shortest).join(" .. ");
        let lugre = self.variants.iter().any(|v| has_bristles(v.law.name));
        let bristles = match lugre {
            true => " (lugre: 1/sigma0, with sigma1 = sqrt(sigma0))",
            false => "",
        };
        vec![
            format!(
                "searched: {}; {}",
                sentence(self.variants.iter().map(|v| &v.law)),
                sentence(self.variants.iter().map(|v| &v.method)),
            ),
            format!(
                "widths {ends}, {DECADE} a decade{bristles}; dT pi/2 .. pi/{EVERY} with every whole number, then in ratios of \
                 1.05 to pi/{MOST}; duration {}*pi (a cycle after the exact rest)",
                (self.duration(self.releases.longest()) / PI).round()
            ),
            self.neighbours(),
            "not searched: stribeck, static_ratio and nu_ratio (other physics than the exact motion), other exponents and damping, \
             releases with a velocity, initial_slip pulled and sliding, steps that do not divide a half-cycle or break a rule"
                .into(),
        ]
    }

    fn cost_title(&self) -> &'static str {
        match has_sub_steps(&self.variants) {
            true => "steps × sub-steps",
            false => "steps",
        }
    }

    fn costs(&self) -> Vec<u64> {
        let of_count = |count: u32| {
            let variants = self.variants.iter();
            variants.map(move |variant| self.cost(variant, count))
        };
        self.step_counts().into_iter().flat_map(of_count).collect()
    }

    fn level(&self, index: usize) -> CostLevel {
        let variant = &self.variants[self.variant_of(index)];
        let steps = self.step_counts()[index / self.variants.len()];
        let widths = match width(variant.law.name) {
            Some(_) => decades(WIDTHS[0], WIDTHS[1], DECADE),
            None => vec![1.0],
        };
        let every = match self.grid {
            Grid::Coarse => COARSE,
            Grid::Fine => 1,
        };
        let count = widths.len();
        let mut level = CostLevel::default();
        let mut allowed = vec![true; count];
        let releases = self.level_releases();
        for (x0, _) in &releases {
            for (width, allowed) in widths.iter().zip(&mut allowed) {
                let (case, broken) = self.case(variant, *width, steps, *x0);
                *allowed &= broken.is_empty();
                level.cases.push(case);
            }
        }
        let of = |i: usize| {
            let places = releases.iter().enumerate();
            let cells = places.map(|(place, (_, neighbours))| {
                let own = place * count + i;
                match *neighbours && count > 1 {
                    true => vec![own, own - 1, own + 1],
                    false => vec![own],
                }
            });
            cells.collect::<Vec<_>>().concat()
        };
        if count == 1 {
            level.candidates.extend(allowed[0].then(|| of(0)));
            return level;
        }
        let inner = (1..count - 1).step_by(every);
        level.candidates = inner
            .filter(|i| allowed[i - 1..=i + 1].iter().all(|allowed| *allowed))
            .map(of)
            .collect();
        level
    }

    fn further(&self, candidate: &[Case]) -> Further {
        let (Releases::Range(..), Grid::Fine, Some(first)) =
            (self.releases, self.grid, candidate.first())
        else {
            return Further::default();
        };
        let x0 = |case: &Case| case.number("x0");
        // The case with the widths of its neighbours.
        let widths = candidate.iter().filter(|case| x0(case) == x0(first));
        let widths: Vec<&Case> = widths.collect();
        let hardest = self.releases.hardest();
        let others = |case: &Case, known: &[f64]| -> Vec<Case> {
            let all = self.releases.all().into_iter();
            let others = all.filter(|x0| !known.contains(x0));
            others.map(|x0| released(case, x0)).collect()
        };
        let neighbours = widths.iter().skip(1);
        Further {
            own: others(first, &hardest[..1]),
            neighbours: neighbours.flat_map(|case| others(case, &hardest)).collect(),
        }
    }

    fn range(&self, case: &Case) -> Option<Range> {
        let cases = self.releases.looked_at().into_iter();
        Some(Range {
            parameter: "x0",
            title: "releases",
            cases: cases.map(|x0| released(case, x0)).collect(),
        })
    }

    fn energy_change(&self, _: &Case, solution: &Solution) -> EnergyChange {
        EnergyChange {
            gain: energy_gain(&solution.computed, &solution.exact),
            loss: 0.0,
        }
    }
}

impl Variants for Friction {
    fn variants(&self) -> &[Variant] {
        &self.variants
    }

    fn variant_of(&self, level: usize) -> usize {
        level % self.variants.len().max(1)
    }

    fn with(&self, variants: &[usize], grid: Grid) -> Box<dyn Variants> {
        let variants = variants.iter().map(|at| self.variants[*at].clone());
        Box::new(Friction {
            variants: variants.collect(),
            grid,
            releases: self.releases,
        })
    }

    fn space(&self) -> &dyn SearchSpace {
        self
    }
}
