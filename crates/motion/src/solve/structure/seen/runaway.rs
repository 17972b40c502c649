//! Whether a structure that may lose its stability moves away from where it stood, and nothing brings it back.

use crate::contact::ContactKind;
use crate::lane::Lane;
use crate::solve::structure::State;
use crate::system::structure::Structure;
use crate::system::structure::sparse::factor::negative_pivot;

/// Share of its terms below which the work of the restoring forces is round-off.
const ROUND_OFF: f64 = 1e-9;

/// Most nodes of a structure whose K is factored for this: of a larger one, the factor would need as much memory as its steps.
const MOST_NODES: usize = 1000;

/// L structures that may run away: K is not positive semidefinite, or a link softens.
///
/// For the displacements u from the static equilibrium (without static loads, from u = 0) the restoring forces are K u + B S, S without
/// that of the equilibrium. A structure runs away if at the last step u^T M u is the largest so far and rises, and
/// u^T (K u + B S) is not above 0: the structure pushes itself further.
#[derive(Debug, Clone)]
pub(super) struct Runaway<const L: usize> {
    /// u of the nodes, and r and S of the contacts, in equilibrium.
    nodes: Vec<Lane<L>>,
    contacts: Vec<[Lane<L>; 2]>,
    /// Rows, columns and entries of M and K, those beside the diagonal twice.
    mass: Vec<(usize, usize, f64)>,
    stiffness: Vec<(usize, usize, f64)>,
    /// Largest u^T M u, at least what is round-off.
    largest: Lane<L>,
    /// Whether the last step shows it.
    shows: [bool; L],
}

impl<const L: usize> Runaway<L> {
    /// `None` of structures that are stable.
    pub fn new(structures: &[&Structure; L], start: &State<L>) -> Option<Self> {
        // All have the same matrices.
        let first = structures.first()?;
        let softens = |of: &&Structure| {
            let mut laws = of.contacts.iter().map(|contact| contact.law.as_given());
            laws.any(|law| law.kind() == ContactKind::Link && law.properties().falls())
        };
        let is_unstable =
            || first.len() <= MOST_NODES && negative_pivot(&first.stiffness).is_some();
        if !structures.iter().any(softens) && !is_unstable() {
            return None;
        }
        let whole = |entries: Vec<((usize, usize), f64)>| -> Vec<(usize, usize, f64)> {
            let twice = |((i, j), x): ((usize, usize), f64)| match i == j {
                true => (i, j, x),
                false => (i, j, 2.0 * x),
            };
            entries.into_iter().map(twice).collect()
        };
        let mut mass = whole(first.coupled_mass.entries().collect());
        let nodes = first.nodes.iter().enumerate();
        mass.extend(nodes.map(|(i, node)| (i, i, node.mass)));
        let lanes = |of: &dyn Fn(&Structure) -> f64| Lane(structures.map(of));
        // 0 without static loads.
        let at_rest = |of: &Structure, x: f64| match of.preload.load.is_empty() {
            true => 0.0,
            false => x,
        };
        let nodes = (0..first.len()).map(|i| lanes(&|of| at_rest(of, of.displacement[i])));
        let contacts = (0..start.contacts()).map(|c| {
            let moved = |of: &Structure| at_rest(of, of.relative(c, &of.displacement));
            let force = |of: &Structure| at_rest(of, of.preload.force(c).unwrap_or(0.0));
            [lanes(&|of| of.contacts[c].gap + moved(of)), lanes(&force)]
        });
        let nodes: Vec<Lane<L>> = nodes.collect();
        let at_rest = mass
            .iter()
            .map(|(i, j, m)| nodes[*i] * nodes[*j] * *m)
            .fold(Lane::splat(0.0), |sum, term| sum + term);
        Some(Runaway {
            nodes,
            contacts: contacts.collect(),
            mass,
            stiffness: whole(first.stiffness.entries().collect()),
            // What is smaller than this is the round-off of the equilibrium.
            largest: at_rest * (ROUND_OFF * ROUND_OFF),
            shows: [false; L],
        })
    }

    /// Adds a step.
    pub fn add(&mut self, state: &State<L>) {
        let moved = |i: usize| state.rest_displacement(i) - self.nodes[i];
        let product = |entries: &[(usize, usize, f64)], of: &dyn Fn(usize) -> Lane<L>| {
            let mut sum = [Lane::<L>::splat(0.0); 2];
            for (i, j, x) in entries {
                // Of entries beside the diagonal, the mean of both sides.
                let term = (moved(*i) * of(*j) + moved(*j) * of(*i)) * (0.5 * x);
                sum = [sum[0] + term, sum[1] + term.map(f64::abs)];
            }
            sum
        };
        let [size, _] = product(&self.mass, &moved);
        let [rises, _] = product(&self.mass, &|i| state.rest_velocity(i));
        let is_far = |l: usize| size.0[l] >= self.largest.0[l] && rises.0[l] > 0.0;
        let far: [bool; L] = std::array::from_fn(is_far);
        self.largest = self.largest.larger(size);
        if !far.contains(&true) {
            self.shows = far;
            return;
        }
        let [mut work, mut terms] = product(&self.stiffness, &moved);
        for (c, [r, force]) in self.contacts.iter().enumerate() {
            let now = state.contact(c);
            let step_work = (now.force - *force) * (now.displacement - *r);
            work = work + step_work;
            terms = terms + step_work.map(f64::abs);
        }
        // The sum of infinite terms is no number.
        let restores = |l: usize| work.0[l] > ROUND_OFF * terms.0[l];
        self.shows = std::array::from_fn(|l| far[l] && !restores(l));
    }

    /// Whether a lane has run away up to the last step.
    pub fn of_lane(&self, l: usize) -> bool {
        self.shows[l]
    }
}
