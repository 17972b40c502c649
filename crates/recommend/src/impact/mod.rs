//! Search space of an impact of two bars: law, stiffness, method, mesh, mass matrix and step.

mod energy;
mod mesh;
mod space;
mod task;
mod variants;

pub use energy::energy_change;
pub use task::{BarFault, ENERGY_GAIN, ENERGY_LOSS, ImpactTask, MOST_ELEMENTS, bar};

use super::{Fixed, Grid, Setting, Variant};
use mesh::{Mesh, meshes, most_cost};
use slipgap_contact::contact::{Described, ImpactSpring};
use slipgap_problem::problem::impact::BarImpact;
use slipgap_problem::problem::impact::scaled::Scaled;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_problem::problem::table::schema::Text;
use slipgap_problem::problem::{Case, Problem, Violation};
use slipgap_system::methods::AverageAcceleration;
use std::sync::OnceLock;

/// Largest number of passes of a wave through the shorter bar before the bars part.
const MOST_TRIPS: f64 = 1e4;

/// Values that the user gives, which are not searched.
#[derive(Debug, Clone, Default)]
pub struct FixedParameters {
    /// The law and the method.
    pub choice: Fixed,
    /// `gamma` or `k_I`, with its value.
    pub spring: Option<(&'static str, f64)>,
    /// Elements of the left bar.
    pub n: Option<u32>,
    /// The mass matrix.
    pub mass: Option<&'static str>,
    /// Data of the bars, as in a study.
    pub bars: Vec<(Text, Value)>,
}

impl FixedParameters {
    /// The spring, if it is given, else a soft one.
    fn spring_or_soft(&self) -> (&'static str, f64) {
        self.spring.unwrap_or(("gamma", space::GAMMAS[0]))
    }

    /// Whether the mesh of the right bar is given.
    fn has_right_mesh(&self) -> bool {
        self.bars.iter().any(|(name, _)| *name == "right.n")
    }
}

/// The variant, the mesh and the cost of a level.
type Level = (usize, Mesh, u64);

/// Laws, stiffnesses, methods, meshes, mass matrices and steps for two bars.
#[derive(Debug, Clone)]
pub struct Impact {
    fixed: FixedParameters,
    variants: Vec<Variant>,
    grid: Grid,
    /// Travel time of the right bar over that of the left; `None` if they are equal, and for a wall.
    time_ratio: Option<f64>,
    duration: f64,
    /// Peak of the exact contact force over F0.
    pub peak: f64,
    /// Computed when they are needed.
    levels: OnceLock<Vec<Level>>,
}

impl Impact {
    /// The search space of these bars, or the rules that they break.
    pub fn new(fixed: FixedParameters) -> Result<Impact, Vec<Violation>> {
        let usual = Variant {
            law: Setting::new(ImpactSpring::NAME),
            method: Setting::new(AverageAcceleration::NAME),
            mass: Some("lumped"),
        };
        let mut impact = Impact {
            variants: variants::variants(&fixed),
            fixed,
            grid: Grid::Fine,
            time_ratio: None,
            duration: 1.0,
            peak: 1.0,
            levels: OnceLock::new(),
        };
        let spring = impact.fixed.spring_or_soft();
        let (case, broken) = impact.completed(&usual, spring, (1, 1.0), 0.0);
        if !broken.is_empty() {
            return Err(broken);
        }
        let bars = Scaled::new(&case).map(|scaled| scaled.bars);
        let bars = bars.filter(|bars| !bars.wall() && bars.time_ratio != 1.0);
        impact.time_ratio = bars.map(|bars| bars.time_ratio);
        let separation = Scaled::new(&case).and_then(|scaled| first_separation(&scaled));
        let Some(separation) = separation else {
            return Err(violation(
                "right",
                &format!(
                    "the bars do not part before a wave has passed the shorter bar {MOST_TRIPS} times"
                ),
            ));
        };
        impact.duration = 1.5 * separation;
        let exact = BarImpact.exact(&case, &[0.0, impact.duration]);
        let force = exact.map_or(Vec::new(), |exact| exact.force().to_vec());
        impact.peak = force.into_iter().fold(0.0, f64::max);
        let all = meshes(impact.fixed.n, Grid::Fine);
        if !all.iter().any(|mesh| impact.work(&usual, *mesh).is_some()) {
            let message = "the travel times of the bars differ so much that no mesh searched suits both; give right.n";
            return Err(violation("right", message));
        }
        impact.keep_suitable_variants()?;
        Ok(impact)
    }

    /// Removes the variants that break a rule also with the shortest step, for instance rigid contact with a given stiffness. Returns
    /// the broken rules if none remains.
    fn keep_suitable_variants(&mut self) -> Result<(), Vec<Violation>> {
        let spring = self.fixed.spring_or_soft();
        let short = mesh::PASSES.into_iter().fold(f64::INFINITY, f64::min);
        let mesh = (self.fixed.n.unwrap_or(2), short);
        let broken = |variant: &Variant| match variants::is_rigid(variant.law.name) {
            true if self.fixed.spring.is_some() => violation(
                "gamma",
                "does not apply to law rigid, which has no stiffness",
            ),
            _ => self.completed(variant, spring, mesh, 0.0).1,
        };
        let broken: Vec<Vec<Violation>> = self.variants.iter().map(broken).collect();
        let suitable = |at: usize| broken[at].is_empty();
        let kept = (0..self.variants.len()).filter(|at| suitable(*at));
        let kept: Vec<Variant> = kept.map(|at| self.variants[at].clone()).collect();
        if kept.is_empty() {
            return Err(broken.into_iter().next().unwrap_or_default());
        }
        self.variants = kept;
        Ok(())
    }

    /// A case with the impact at the position `into` of a step, 0..1, and the rules that it breaks.
    fn completed(
        &self,
        variant: &Variant,
        spring: (&'static str, f64),
        mesh: Mesh,
        into: f64,
    ) -> (Case, Vec<Violation>) {
        let (n, dt) = (mesh.0, mesh::step(mesh));
        let bars = self.fixed.bars.iter();
        let mut given: Vec<(&str, Value)> = bars.map(|(name, value)| (&**name, *value)).collect();
        given.extend([
            ("n", Value::Whole(u64::from(n))),
            ("dt", Value::Number(dt)),
            ("duration", Value::Number(self.duration)),
            ("gap", Value::Number(2.0 * into * dt)),
        ]);
        given.extend(variant.mass.map(|mass| ("mass", Value::Name(mass))));
        let settings = variant.law.given("law");
        for (name, value) in settings.chain(variant.method.given("method")) {
            given.push((name, value));
        }
        if !variants::is_rigid(variant.law.name) {
            given.push((spring.0, Value::Number(spring.1)));
        }
        if let Some(ratio) = self.time_ratio.filter(|_| !self.fixed.has_right_mesh()) {
            let count = (f64::from(n) * ratio).round().max(1.0);
            given.push(("right.n", Value::Whole(count as u64)));
        }
        Case::given(&BarImpact, &given)
    }

    /// The number of steps times modes times sub-steps of a mesh; `None` if a run has only one step or the right bar only one element.
    fn work(&self, variant: &Variant, mesh: Mesh) -> Option<u64> {
        let (case, _) = self.completed(variant, self.fixed.spring_or_soft(), mesh, 0.0);
        let right = case.number("right.n").unwrap_or(f64::INFINITY);
        let meshed = self.time_ratio.is_none() || right >= 2.0 || self.fixed.has_right_mesh();
        let searched = BarImpact.steps(&case) > 1 && meshed;
        searched.then(|| BarImpact.work(&case))
    }

    /// The levels: every variant with every mesh that it can afford.
    fn levels(&self) -> &[Level] {
        self.levels.get_or_init(|| {
            let most = most_cost(self.fixed.n);
            let mut levels = Vec::new();
            for mesh in meshes(self.fixed.n, self.grid) {
                // Most variants have the same work: it depends on the mass matrix and the number of sub-steps only.
                let mut known: Vec<([&str; 2], Option<u64>)> = Vec::new();
                for (at, variant) in self.variants.iter().enumerate() {
                    let key = [variant.mass.unwrap_or(""), variant.method.name];
                    let found = known.iter().find(|(other, _)| *other == key);
                    let work = found.map(|(_, work)| *work).unwrap_or_else(|| {
                        let work = self.work(variant, mesh);
                        known.push((key, work));
                        work
                    });
                    let affordable = work.filter(|work| *work <= most);
                    levels.extend(affordable.map(|work| (at, mesh, work)));
                }
            }
            levels
        })
    }
}

fn violation(parameter: &'static str, message: &str) -> Vec<Violation> {
    vec![Violation {
        parameter: parameter.into(),
        message: message.into(),
        at: None,
    }]
}

/// When the bars part for the first time in the exact solution; `None` if it is too late to compute.
fn first_separation(scaled: &Scaled) -> Option<f64> {
    let shorter = match scaled.pair.right {
        Some(right) => right.travel_time.min(1.0),
        None => 1.0,
    };
    let longer = |trips: &f64| Some(4.0 * trips).filter(|trips| *trips <= MOST_TRIPS);
    let mut ends = std::iter::successors(Some(2.0), longer).map(|trips| trips * shorter);
    ends.find_map(|end| scaled.bars.solve(end).durations()[1])
}
