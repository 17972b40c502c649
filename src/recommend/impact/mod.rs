//! Search space of an impact of two bars: spring, mesh, mass matrix and step.

mod energy;
mod mesh;
mod space;

pub use energy::energy_gain;

use crate::problem::impact::BarImpact;
use crate::problem::impact::scaled::Scaled;
use crate::problem::parameter::Value;
use crate::problem::schema::Text;
use crate::problem::{Case, Problem, Violation};
use mesh::{Mesh, affordable};

/// Largest number of passes of a wave through the shorter bar before the bars part.
const MOST_TRIPS: f64 = 1e4;

/// Values that the user gives, which are not searched.
#[derive(Debug, Clone, Default)]
pub struct FixedParameters {
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
    /// The spring, if it is given, else gamma = 1.
    fn spring_or_default(&self) -> (&'static str, f64) {
        self.spring.unwrap_or(("gamma", 1.0))
    }

    /// Whether the mesh of the right bar is given.
    fn has_right_mesh(&self) -> bool {
        self.bars.iter().any(|(name, _)| *name == "right.n")
    }
}

/// Springs, meshes, mass matrices and steps for two bars.
#[derive(Debug)]
pub struct Impact {
    fixed: FixedParameters,
    /// Travel time of the right bar over that of the left; `None` if they are equal, and for a wall.
    time_ratio: Option<f64>,
    duration: f64,
    /// Peak of the exact contact force over F0.
    pub peak: f64,
    /// The mesh and the cost of each level.
    meshes: Vec<(Mesh, u64)>,
}

impl Impact {
    /// The search space of these bars, or the rules that they break.
    pub fn new(fixed: FixedParameters) -> Result<Impact, Vec<Violation>> {
        let mut impact = Impact {
            fixed,
            time_ratio: None,
            duration: 1.0,
            peak: 1.0,
            meshes: Vec::new(),
        };
        let spring = impact.fixed.spring_or_default();
        let (case, broken) = impact.completed(spring, (1, 1.0, "lumped"), 0.0);
        if !broken.is_empty() {
            return Err(broken);
        }
        let bars = Scaled::new(&case).map(|scaled| scaled.bars);
        let bars = bars.filter(|bars| !bars.wall() && bars.time_ratio != 1.0);
        impact.time_ratio = bars.map(|bars| bars.time_ratio);
        let separation = Scaled::new(&case).and_then(|scaled| first_separation(&scaled));
        let Some(separation) = separation else {
            return Err(vec![Violation {
                parameter: "right".into(),
                message: format!(
                    "the bars do not part before a wave has passed the shorter bar {MOST_TRIPS} times"
                ),
                at: None,
            }]);
        };
        impact.duration = 1.5 * separation;
        let exact = BarImpact.exact(&case, &[0.0, impact.duration]);
        let force = exact.map_or(Vec::new(), |exact| exact.force().to_vec());
        impact.peak = force.into_iter().fold(0.0, f64::max);
        impact.meshes = affordable(impact.fixed.n, &impact.masses(), |mesh| impact.cost(mesh));
        if impact.meshes.is_empty() {
            let message = "the travel times of the bars differ so much that no mesh searched suits both; give right.n";
            let parameter = "right";
            return Err(vec![Violation {
                parameter: parameter.into(),
                message: message.into(),
                at: None,
            }]);
        }
        Ok(impact)
    }

    /// A case with the impact at the position `into` of a step, 0..1, and the rules that it breaks.
    fn completed(
        &self,
        spring: (&'static str, f64),
        (n, passes, mass): Mesh,
        into: f64,
    ) -> (Case, Vec<Violation>) {
        let dt = passes / f64::from(2 * n);
        let bars = self.fixed.bars.iter();
        let mut given: Vec<(&str, Value)> = bars.map(|(name, value)| (&**name, *value)).collect();
        given.extend([
            (spring.0, Value::Number(spring.1)),
            ("n", Value::Whole(u64::from(n))),
            ("dt", Value::Number(dt)),
            ("duration", Value::Number(self.duration)),
            ("gap", Value::Number(2.0 * into * dt)),
            ("mass", Value::Name(mass)),
        ]);
        if let Some(ratio) = self.time_ratio.filter(|_| !self.fixed.has_right_mesh()) {
            let count = (f64::from(n) * ratio).round().max(1.0);
            given.push(("right.n", Value::Whole(count as u64)));
        }
        Case::given(&BarImpact, &given)
    }

    fn case(&self, spring: (&'static str, f64), mesh: Mesh, into: f64) -> Case {
        // `new` has tested the rules of the bars. All other values are in the ranges of the table.
        self.completed(spring, mesh, into).0
    }

    /// The cost of a mesh; `None` if a run has only one step or the right bar only one element.
    fn cost(&self, mesh: Mesh) -> Option<u64> {
        let case = self.case(self.fixed.spring_or_default(), mesh, 0.0);
        let right = case.number("right.n").unwrap_or(f64::INFINITY);
        let meshed = self.time_ratio.is_none() || right >= 2.0 || self.fixed.has_right_mesh();
        let searched = BarImpact.steps(&case) > 1 && meshed;
        searched.then(|| BarImpact.work(&case))
    }

    fn masses(&self) -> Vec<&'static str> {
        self.fixed
            .mass
            .map_or(vec!["lumped", "consistent"], |mass| vec![mass])
    }
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
