//! Motions of a structure, by steps and exact.

use crate::{Method, Structure};
use slipgap_motion::exact::adaptive;
use slipgap_motion::exact::events::{self as exactly, EventsFault};
use slipgap_motion::solve::structure::{Prepared, balance, run as step, settle};

/// Why [`run`], [`exact`] or [`events`] have no motion, with the step, the node or the contact; its text says what to do.
///
/// ```
/// use slipgap_solver::{Direction, Node, Structure, Unsolvable, exact};
///
/// let mut mass = Structure::new(vec![Node { name: "mass".into(), mass: 1.0, direction: Direction::X }]);
/// mass.preload.load = vec![1.0];
/// let why = exact(&mass, &[1.0]).unwrap_err();
/// assert_eq!(why, Unsolvable::NoEquilibrium { node: "mass".into() });
/// ```
#[doc(inline)]
pub use slipgap_motion::solve::Unsolvable;

/// What [`events`] tells: a time, the place of the contact in the list of the structure, and what happens there.
///
/// ```
/// use slipgap_solver::{Event, EventKind};
///
/// let event = Event { time: 0.5, contact: 0, kind: EventKind::Impact { rate: -2.0 } };
/// assert!(matches!(event.kind, EventKind::Impact { rate } if rate < 0.0));
/// ```
#[doc(inline)]
pub use slipgap_motion::exact::events::Event;

/// A rigid stop closes with a velocity, or a contact begins another phase.
///
/// ```
/// use slipgap_solver::{EventKind, Phase};
///
/// assert_ne!(EventKind::Phase(Phase::Open), EventKind::Phase(Phase::Sliding(1.0)));
/// ```
#[doc(inline)]
pub use slipgap_motion::exact::events::EventKind;

/// Open, closed, or sliding in the direction +1 or -1.
///
/// ```
/// use slipgap_solver::Phase;
///
/// assert_ne!(Phase::Sliding(1.0), Phase::Sliding(-1.0));
/// ```
#[doc(inline)]
pub use slipgap_motion::exact::events::Phase;

/// A motion at given times. All numbers are in the units of the structure, which are any that belong together.
///
/// ```
/// use slipgap_solver::{AverageAcceleration, Direction, Node, Structure, run};
///
/// let mut mass = Structure::new(vec![Node { name: "mass".into(), mass: 1.0, direction: Direction::X }]);
/// mass.velocity[0] = 3.0;
/// let motion = run(&mass, &AverageAcceleration.into(), 0.5, 4)?;
/// assert_eq!(motion.time, [0.0, 0.5, 1.0, 1.5, 2.0]);
/// assert_eq!(motion.displacement[4], [6.0]);
/// assert!(motion.opening[4].is_empty());
/// # Ok::<(), slipgap_solver::Unsolvable>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
#[non_exhaustive]
pub struct Solution {
    /// The times t_i.
    pub time: Vec<f64>,
    /// u of each node at each time: `displacement[i][node]`; with supports that move, the rest w.
    pub displacement: Vec<Vec<f64>>,
    /// u' of each node, alike.
    pub velocity: Vec<Vec<f64>>,
    /// r of each contact, its gap included: `opening[i][contact]`.
    pub opening: Vec<Vec<f64>>,
    /// S of each contact, alike; it resists the motion, so that S <= 0 in an impact.
    pub force: Vec<Vec<f64>>,
}

impl Solution {
    fn add(&mut self, time: f64, [u, v, r, s]: [Vec<f64>; 4]) {
        self.time.push(time);
        self.displacement.push(u);
        self.velocity.push(v);
        self.opening.push(r);
        self.force.push(s);
    }
}

/// Whether the lists of a structure have their lengths, and nodes are those of its list.
fn check(structure: &Structure) -> Result<(), String> {
    let (n, m) = (structure.len(), structure.contacts.len());
    let load = &structure.preload.load;
    let lists = [
        ("coupled_mass", structure.coupled_mass.size(), n),
        ("stiffness", structure.stiffness.size(), n),
        ("damping", structure.damping.size(), n),
        ("displacement", structure.displacement.len(), n),
        ("velocity", structure.velocity.len(), n),
        (
            "preload.load",
            load.len(),
            if load.is_empty() { 0 } else { n },
        ),
    ];
    let supports = structure.supports.iter();
    let of_supports = supports.flat_map(|support| {
        [
            ("carried", support.carried.len(), n),
            ("gaps", support.gaps.len(), m),
        ]
    });
    let mut lengths = lists.into_iter().chain(of_supports);
    if let Some((name, got, right)) = lengths.find(|(_, got, right)| got != right) {
        return Err(format!("{name} must have the size {right}, got {got}"));
    }
    let contacts = structure.contacts.iter().flat_map(|contact| &contact.along);
    let loads = structure.loads.iter().flat_map(|load| &load.pattern);
    match contacts.chain(loads).find(|(node, _)| *node >= n) {
        Some((node, _)) => Err(format!("a node must be below {n}, got {node}")),
        None => Ok(()),
    }
}

/// The structure at t = 0: in equilibrium under its static loads, nodes without mass included.
fn started(structure: &Structure, dt: f64) -> Result<Structure, Unsolvable> {
    check(structure).map_err(Unsolvable::BrokenRules)?;
    if !(dt > 0.0 && dt.is_finite()) {
        let rule = "times must be > 0 and finite".to_owned();
        return Err(Unsolvable::BrokenRules(rule));
    }
    let mut started = structure.clone();
    if !started.preload.load.is_empty() {
        settle(&mut started)?;
    }
    started.press_at_start();
    balance(&mut started, dt)?;
    Ok(started)
}

/// The motion by `steps` steps of `dt`, t = 0 included.
///
/// A mass of 1 with the velocity 2 and Coulomb friction 1 comes to rest after 2 s at v^2/2 = 2:
///
/// ```
/// use slipgap_solver::{AverageAcceleration, ClippedLine, Contact, Direction, Limit, Node, Structure, StructureLaw, run};
///
/// let mut block = Structure::new(vec![Node { name: "block".into(), mass: 1.0, direction: Direction::X }]);
/// let law = StructureLaw::new(ClippedLine::Coulomb, Limit::constant(1.0));
/// block.contacts.push(Contact { name: "floor".into(), along: vec![(0, 1.0)], gap: 0.0, law });
/// block.velocity[0] = 2.0;
/// let motion = run(&block, &AverageAcceleration.into(), 0.01, 300)?;
/// assert!((motion.displacement[300][0] - 2.0).abs() < 1e-10);
/// assert!(motion.velocity[300][0].abs() < 1e-10);
/// # Ok::<(), slipgap_solver::Unsolvable>(())
/// ```
///
/// # Errors
/// The matrix of a step is not positive definite, the structure has no equilibrium, the forces of a step are not unique, or the motion
/// is not finite; [`Unsolvable::BrokenRules`] where `dt` is not > 0, or a list of the structure has not the length that it needs.
pub fn run(
    structure: &Structure,
    method: &Method,
    dt: f64,
    steps: usize,
) -> Result<Solution, Unsolvable> {
    let structure_at_start = started(structure, dt)?;
    let prepared = Prepared::by(method, &structure_at_start, dt)?;
    let mut solution = Solution::default();
    let (nodes, contacts) = (
        0..structure_at_start.len(),
        0..structure_at_start.contacts.len(),
    );
    let [ended] = step::<1>(&[&structure_at_start], &prepared, steps, |i, state| {
        let contact = |c| state.contact(c);
        solution.add(
            i as f64 * dt,
            [
                nodes.clone().map(|n| state.displacement(n).0[0]).collect(),
                nodes.clone().map(|n| state.velocity(n).0[0]).collect(),
                contacts
                    .clone()
                    .map(|c| contact(c).displacement.0[0])
                    .collect(),
                contacts.clone().map(|c| contact(c).force.0[0]).collect(),
            ],
        );
    });
    ended.map(|()| solution)
}

/// The exact motion at `times`, which rise from a number >= 0 to one > 0: by events where all laws are straight lines, else integrated in
/// continuous time with a tolerance of 1e-12.
///
/// ```
/// # use slipgap_solver::{ClippedLine, Contact, Direction, Limit, Node, Structure, StructureLaw};
/// # let mut block = Structure::new(vec![Node { name: "block".into(), mass: 1.0, direction: Direction::X }]);
/// # let law = StructureLaw::new(ClippedLine::Coulomb, Limit::constant(1.0));
/// # block.contacts.push(Contact { name: "floor".into(), along: vec![(0, 1.0)], gap: 0.0, law });
/// # block.velocity[0] = 2.0;
/// let motion = slipgap_solver::exact(&block, &[1.0, 5.0])?;
/// assert_eq!(motion.displacement, [[1.5], [2.0]]);
/// assert_eq!(motion.velocity[1], [0.0]);
/// # Ok::<(), slipgap_solver::Unsolvable>(())
/// ```
///
/// # Errors
/// [`Unsolvable::Reference`]: the motion has too many events or steps, its rigid contacts have no unique forces, or it has a contact that
/// neither way knows; and the errors of [`run`] at t = 0.
pub fn exact(structure: &Structure, times: &[f64]) -> Result<Solution, Unsolvable> {
    let rising = times.windows(2).all(|pair| pair[0] < pair[1]);
    let starts = times.first().is_some_and(|first| *first >= 0.0);
    let end = times.last().copied().filter(|end| *end > 0.0);
    let Some(end) = end.filter(|_| rising && starts) else {
        let rule = "times must rise from a number >= 0 to one > 0".to_owned();
        return Err(Unsolvable::BrokenRules(rule));
    };
    let structure_at_start = started(structure, SHORT * end)?;
    let nodes: Vec<usize> = (0..structure_at_start.len()).collect();
    let mut solution = Solution::default();
    let mut visit = |i: usize, state: &exactly::State| {
        let channels = [state.u, state.v, state.r, state.force].map(<[f64]>::to_vec);
        solution.add(times[i], channels);
    };
    let refused = |why: String| Unsolvable::Reference(why);
    match exactly::run_of(&structure_at_start, &nodes, times, &mut visit) {
        Err(EventsFault::Law { .. }) => adaptive::refuse_large(&structure_at_start)
            .and_then(|()| {
                adaptive::run_of(
                    &structure_at_start,
                    &nodes,
                    times,
                    adaptive::TOLERANCE,
                    &mut visit,
                )
            })
            .map_err(|why| refused(why.to_string()))?,
        ended => ended.map_err(|why| refused(why.to_string()))?,
    }
    Ok(solution)
}

/// The events of the exact motion up to the time `end` > 0, in time.
///
/// A ball with the speed 2 meets a stop after a way of 1:
///
/// ```
/// use slipgap_solver::{ClippedLine, Contact, Direction, EventKind, Node, Structure, StructureLaw, events};
///
/// let mut ball = Structure::new(vec![Node { name: "ball".into(), mass: 1.0, direction: Direction::X }]);
/// let law = StructureLaw::new(ClippedLine::Stop { restitution: 1.0 }, None);
/// ball.contacts.push(Contact { name: "wall".into(), along: vec![(0, 1.0)], gap: 1.0, law });
/// ball.velocity[0] = -2.0;
/// let impact = events(&ball, 3.0)?.into_iter().find(|event| event.time > 0.0).expect("an impact");
/// assert_eq!((impact.time, impact.kind), (0.5, EventKind::Impact { rate: -2.0 }));
/// # Ok::<(), slipgap_solver::Unsolvable>(())
/// ```
///
/// # Errors
/// As [`exact`], and a law that is none of straight lines: its motion has no events.
pub fn events(structure: &Structure, end: f64) -> Result<Vec<Event>, Unsolvable> {
    let structure_at_start = started(structure, SHORT * end)?;
    let motion = exactly::run(&structure_at_start, &[end], |_, _| ())
        .map_err(|why| Unsolvable::Reference(why.to_string()))?;
    Ok(motion.events)
}

/// Part of the motion's time with which nodes without mass find their place at t = 0.
const SHORT: f64 = 1e-6;
