//! Spring, mesh, mass matrix and step of an impact of two bars.

use super::{Rung, Space, energy, metric, wholes, written};
use crate::history::History;
use crate::problem::impact::BarImpact;
use crate::problem::impact::scaled::Scaled;
use crate::problem::parameter::{Value, shortest};
use crate::problem::schema::Text;
use crate::problem::{Case, Problem, Violation};

/// Most elements of a bar.
const MOST: u32 = 140;

/// Elements that a wave passes in a step. The first are searched with every mesh, the others with some.
const PASSES: [f64; 14] = [
    4.0, 3.0, 2.5, 2.0, 1.75, 1.5, 1.25, 1.0, 0.75, 0.5, 0.375, 0.25, 0.125, 0.0625,
];
const WITH_EVERY_MESH: usize = 10;

/// Values of gamma.
const GAMMAS: [f64; 2] = [0.01, 10.0];

/// Most steps times modes of a case, unless n is given.
const MOST_COST: u64 = 2_000_000;

/// The same for one n that is given.
const MOST_COST_GIVEN: u64 = 200_000_000;

/// Trips of a wave through the shorter bar up to which the bars must part.
const MOST_TRIPS: f64 = 1e4;

/// Where in a step the impact falls, for neighbours.
const INTO: [f64; 2] = [0.37, 0.71];

/// What is not searched: values that the user gives.
#[derive(Debug, Clone, Default)]
pub struct Fixed {
    /// `gamma` or `k_I`, with its value.
    pub spring: Option<(&'static str, f64)>,
    /// Elements of the left bar.
    pub n: Option<u32>,
    /// The mass matrix.
    pub mass: Option<&'static str>,
    /// Data of the bars, as in a study.
    pub bars: Vec<(Text, Value)>,
}

/// Springs, meshes, mass matrices and steps for two bars.
#[derive(Debug)]
pub struct Impact {
    fixed: Fixed,
    /// Travel time of the right bar over that of the left; `None` for like bars and for a wall.
    unlike: Option<f64>,
    duration: f64,
    /// Peak of the exact contact force over F0.
    pub peak: f64,
    /// All rungs with their costs.
    meshes: Vec<(Mesh, u64)>,
}

/// A rung: elements, elements that a wave passes in a step, mass matrix.
type Mesh = (u32, f64, &'static str);

impl Impact {
    /// The bars given, and what follows from them; or the rules that they break.
    pub fn new(fixed: Fixed) -> Result<Impact, Vec<Violation>> {
        let mut impact = Impact {
            fixed,
            unlike: None,
            duration: 1.0,
            peak: 1.0,
            meshes: Vec::new(),
        };
        let spring = impact.fixed.spring.unwrap_or(("gamma", 1.0));
        let (case, broken) = impact.completed(spring, (1, 1.0, "lumped"), 0.0);
        if !broken.is_empty() {
            return Err(broken);
        }
        let bars = Scaled::new(&case).map(|scaled| scaled.bars);
        let bars = bars.filter(|bars| !bars.wall() && bars.time_ratio != 1.0);
        impact.unlike = bars.map(|bars| bars.time_ratio);
        let Some(parted) = Scaled::new(&case).and_then(|scaled| parting(&scaled)) else {
            return Err(vec![Violation {
                parameter: "right".into(),
                message: format!(
                    "the bars do not part before a wave has passed the shorter bar {MOST_TRIPS} times"
                ),
            }]);
        };
        impact.duration = 1.5 * parted;
        let exact = BarImpact.exact(&case, &[0.0, impact.duration]);
        let force = exact.map_or(Vec::new(), |exact| exact.force().to_vec());
        impact.peak = force.into_iter().fold(0.0, f64::max);
        impact.meshes = impact.affordable();
        if impact.meshes.is_empty() {
            let message = "the travel times of the bars differ so much that no mesh searched suits both; give right.n";
            let parameter = "right";
            return Err(vec![Violation {
                parameter: parameter.into(),
                message: message.into(),
            }]);
        }
        Ok(impact)
    }

    /// A case whose impact falls `into` a step, 0..1, and the rules that it breaks.
    fn completed(
        &self,
        spring: (&'static str, f64),
        (n, passes, mass): Mesh,
        into: f64,
    ) -> (Case, Vec<Violation>) {
        let dt = passes / f64::from(2 * n);
        let own = self.fixed.bars.iter();
        let mut given: Vec<(&str, Value)> = own.map(|(name, value)| (&**name, *value)).collect();
        given.extend([
            (spring.0, Value::Number(spring.1)),
            ("n", Value::Whole(u64::from(n))),
            ("dt", Value::Number(dt)),
            ("duration", Value::Number(self.duration)),
            ("gap", Value::Number(2.0 * into * dt)),
            ("mass", Value::Name(mass)),
        ]);
        if let Some(ratio) = self.unlike.filter(|_| !self.own_mesh()) {
            let count = (f64::from(n) * ratio).round().max(1.0);
            given.push(("right.n", Value::Whole(count as u64)));
        }
        Case::given(&BarImpact, &given)
    }

    /// Whether the user gives the mesh of the right bar.
    fn own_mesh(&self) -> bool {
        self.fixed.bars.iter().any(|(name, _)| *name == "right.n")
    }

    fn case(&self, spring: (&'static str, f64), mesh: Mesh, into: f64) -> Case {
        // Rules across the bars were held by `new`; a grid within the table's ranges breaks no others.
        self.completed(spring, mesh, into).0
    }

    fn masses(&self) -> Vec<&'static str> {
        self.fixed
            .mass
            .map_or(vec!["lumped", "consistent"], |own| vec![own])
    }

    /// The meshes and steps to search, with their costs.
    fn affordable(&self) -> Vec<(Mesh, u64)> {
        let most = self.fixed.n.map_or(MOST_COST, |_| MOST_COST_GIVEN);
        let mut meshes = Vec::new();
        for (at, passes) in PASSES.into_iter().enumerate() {
            let ratio = if at < WITH_EVERY_MESH { 1.0 } else { 1.05 };
            let elements = self
                .fixed
                .n
                .map_or_else(|| wholes(2, MOST, ratio), |n| vec![n]);
            for n in elements {
                for mass in self.masses() {
                    let mesh = (n, passes, mass);
                    let spring = self.fixed.spring.unwrap_or(("gamma", 1.0));
                    let case = self.case(spring, mesh, 0.0);
                    let cost = BarImpact.work(&case);
                    let steps = BarImpact.steps(&case);
                    let right = case.number("right.n").unwrap_or(f64::INFINITY);
                    let meshed = self.unlike.is_none() || right >= 2.0 || self.own_mesh();
                    if steps > 1 && meshed && cost <= most {
                        meshes.push((mesh, cost));
                    }
                }
            }
        }
        meshes
    }
}

/// When the ends part for the first time, by the exact solution; `None` where that takes too long to follow.
fn parting(scaled: &Scaled) -> Option<f64> {
    let shorter = match scaled.pair.right {
        Some(right) => right.travel_time.min(1.0),
        None => 1.0,
    };
    let longer = |trips: &f64| Some(4.0 * trips).filter(|trips| *trips <= MOST_TRIPS);
    let mut ends = std::iter::successors(Some(2.0), longer).map(|trips| trips * shorter);
    ends.find_map(|end| scaled.bars.solve(end).durations()[1])
}

impl Space for Impact {
    fn problem(&self) -> &'static dyn Problem {
        &BarImpact
    }

    fn shown(&self) -> Vec<&'static str> {
        let mut shown = vec!["gamma"];
        // In units of the bars' data: of use where those are the user's.
        let own = !self.fixed.bars.is_empty() || self.fixed.spring.is_some();
        shown.extend(own.then_some("k_I"));
        shown.push("n");
        shown.extend(self.unlike.map(|_| "right.n"));
        shown.extend(["dt", "mass"]);
        shown
    }

    fn stated(&self) -> Vec<&str> {
        let spring = self.fixed.spring.map_or("gamma", |(name, _)| name);
        let mut stated = vec![spring, "n", "dt", "duration", "mass"];
        let bars = self.fixed.bars.iter().map(|(name, _)| &**name);
        stated.extend(bars.filter(|name| *name != "right.n"));
        stated.extend(self.unlike.map(|_| "right.n"));
        stated
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
                "every n 2 .. {MOST} (steps below {} elements: in ratios of 1.05)",
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
        if self.unlike.is_some() {
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

    fn rung(&self, at: usize) -> Rung {
        let (mesh, _) = self.meshes[at];
        let mut rung = Rung::default();
        if let Some(spring) = self.fixed.spring {
            let into = [0.0, INTO[0], INTO[1]];
            rung.cases = into.map(|into| self.case(spring, mesh, into)).to_vec();
            rung.candidates = vec![vec![0, 1, 2]];
            return rung;
        }
        let gammas = written(GAMMAS[0], GAMMAS[1], 20.0);
        for into in [0.0, INTO[0]] {
            let cases = gammas
                .iter()
                .map(|gamma| self.case(("gamma", *gamma), mesh, into));
            rung.cases.extend(cases);
        }
        let count = gammas.len();
        rung.candidates = (1..count - 1)
            .map(|i| vec![i, i - 1, i + 1, i + count])
            .collect();
        rung
    }

    fn energy_drifts(&self) -> Option<[usize; 2]> {
        Some(["energy_drift_max", "energy_drift_final"].map(|name| metric(&BarImpact, name)))
    }

    fn energy_gain(&self, case: &Case, computed: &History) -> Option<f64> {
        energy::gain(case, computed)
    }
}
