//! Motions of a structure, by steps and exact.

use crate::{Method, Structure, Unsolvable};
use slipgap_motion::exact::adaptive;
use slipgap_motion::exact::events::{self, EventsFault};
use slipgap_motion::solve::structure::{Prepared, balance, run as step, settle};

/// A motion at given times. All numbers are in the units of the structure, which are any that belong together.
#[derive(Debug, Clone, Default, PartialEq)]
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

/// The structure at t = 0: in equilibrium under its static loads, nodes without mass included.
fn started(structure: &Structure, dt: f64) -> Result<Structure, Unsolvable> {
    let mut own = structure.clone();
    if !own.preload.load.is_empty() {
        settle(&mut own)?;
    }
    own.press_at_start();
    balance(&mut own, dt)?;
    Ok(own)
}

/// The motion by `steps` steps of `dt`, t = 0 included.
///
/// A mass of 1 with the velocity 2 and Coulomb friction 1 comes to rest after 2 s at v^2/2 = 2:
///
/// ```
/// use slipgap_solver::{AverageAcceleration, ClippedLine, Contact, Direction, Limit, Node, Structure, StructureLaw, Symmetric, run};
///
/// let block = Structure {
///     nodes: vec![Node { name: "block".into(), mass: 1.0, direction: Direction::X }],
///     coupled_mass: Symmetric::zeros(1),
///     stiffness: Symmetric::zeros(1),
///     damping: Symmetric::zeros(1),
///     contacts: vec![Contact {
///         name: "floor".into(),
///         along: vec![(0, 1.0)],
///         gap: 0.0,
///         law: StructureLaw::new(ClippedLine::Coulomb, Limit::constant(1.0)),
///     }],
///     loads: Vec::new(),
///     displacement: vec![0.0],
///     velocity: vec![2.0],
///     supports: Vec::new(),
///     preload: Default::default(),
///     observed: None,
/// };
/// let motion = run(&block, &AverageAcceleration.into(), 0.01, 300)?;
/// assert!((motion.displacement[300][0] - 2.0).abs() < 1e-10);
/// assert!(motion.velocity[300][0].abs() < 1e-10);
/// # Ok::<(), slipgap_solver::Unsolvable>(())
/// ```
///
/// # Errors
/// The matrix of a step is not positive definite, the structure has no equilibrium, the forces of a step are not unique, or the motion
/// is not finite.
pub fn run(
    structure: &Structure,
    method: &Method,
    dt: f64,
    steps: usize,
) -> Result<Solution, Unsolvable> {
    let own = started(structure, dt)?;
    let prepared = Prepared::by(method, &own, dt)?;
    let mut solution = Solution::default();
    let (nodes, contacts) = (0..own.len(), 0..own.contacts.len());
    let [ended] = step::<1>(&[&own], &prepared, steps, |i, state| {
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

/// The exact motion at `times`, which rise from a number >= 0: by events where all laws are straight lines, else integrated in
/// continuous time with a tolerance of 1e-12.
///
/// ```
/// # use slipgap_solver::{ClippedLine, Contact, Direction, Limit, Node, Structure, StructureLaw, Symmetric};
/// # let block = Structure {
/// #     nodes: vec![Node { name: "block".into(), mass: 1.0, direction: Direction::X }],
/// #     coupled_mass: Symmetric::zeros(1), stiffness: Symmetric::zeros(1), damping: Symmetric::zeros(1),
/// #     contacts: vec![Contact {
/// #         name: "floor".into(), along: vec![(0, 1.0)], gap: 0.0,
/// #         law: StructureLaw::new(ClippedLine::Coulomb, Limit::constant(1.0)),
/// #     }],
/// #     loads: Vec::new(), displacement: vec![0.0], velocity: vec![2.0], supports: Vec::new(),
/// #     preload: Default::default(), observed: None,
/// # };
/// let motion = slipgap_solver::exact(&block, &[1.0, 5.0])?;
/// assert_eq!(motion.displacement, [[1.5], [2.0]]);
/// assert_eq!(motion.velocity[1], [0.0]);
/// # Ok::<(), slipgap_solver::Unsolvable>(())
/// ```
///
/// # Errors
/// [`Unsolvable::Reference`]: the motion has too many events or steps, its rigid contacts have no unique forces, or it has a contact that
/// neither way knows; and the errors of the equilibrium at t = 0.
pub fn exact(structure: &Structure, times: &[f64]) -> Result<Solution, Unsolvable> {
    let own = started(structure, SHORT * times.last().copied().unwrap_or(1.0))?;
    let nodes: Vec<usize> = (0..own.len()).collect();
    let mut solution = Solution::default();
    let mut visit = |i: usize, state: &events::State| {
        let all = [state.u, state.v, state.r, state.force].map(<[f64]>::to_vec);
        solution.add(times[i], all);
    };
    let refused = |why: String| Unsolvable::Reference(why);
    match events::run_of(&own, &nodes, times, &mut visit) {
        Err(EventsFault::Law { .. }) => adaptive::refuse_large(&own)
            .and_then(|()| adaptive::run_of(&own, &nodes, times, adaptive::TOLERANCE, &mut visit))
            .map_err(|why| refused(why.to_string()))?,
        ended => ended.map_err(|why| refused(why.to_string()))?,
    }
    Ok(solution)
}

/// Part of the motion's time with which nodes without mass find their place at t = 0.
const SHORT: f64 = 1e-6;
