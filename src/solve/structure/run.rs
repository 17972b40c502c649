//! Steps of structures in lanes.

use super::Prepared;
use super::forces::Forces;
use super::initial;
use super::laws::{Line, bounds, friction};
use super::loads::Inputs;
use crate::lane::Lane;
use crate::solve::Unsolvable;
use crate::system::structure::Structure;
use multiversion::multiversion;

/// The state of L structures after a step.
#[derive(Debug)]
pub struct State<'a, const L: usize> {
    pub(super) prepared: &'a Prepared,
    /// By place; the last one is the ground, which does not move.
    pub(super) nodes: Vec<Increments<L>>,
    pub(super) contacts: Vec<ContactState<L>>,
    pub(super) forces: Forces<L>,
    pub(super) inputs: Inputs<L>,
    /// Means over the step: loads, then contact forces without S(i+1).
    pub(super) input: Vec<Lane<L>>,
    /// Right side, then the solution.
    pub(super) work: Vec<Lane<L>>,
    trial: Vec<Lane<L>>,
    force: Vec<Lane<L>>,
}

/// The motion of a node.
#[derive(Debug, Clone, Copy)]
pub(super) struct Increments<const L: usize> {
    /// P = u + W/2.
    pub(super) p: Lane<L>,
    /// W = dt v.
    pub(super) w: Lane<L>,
}

/// The motion of a contact, and its law.
#[derive(Debug, Clone, Copy)]
pub(super) struct ContactState<const L: usize> {
    /// gap + B^T P.
    pub(super) p: Lane<L>,
    /// B^T W.
    pub(super) w: Lane<L>,
    /// S.
    pub(super) force: Lane<L>,
    gap: Lane<L>,
    pub(super) line: LaneLine<L>,
    /// B^T of the change of W without S(i+1).
    change: Lane<L>,
}

/// The laws of a contact.
#[derive(Debug, Clone, Copy)]
pub(super) struct LaneLine<const L: usize> {
    pub(super) compliance: Lane<L>,
    pub(super) by_increment: Lane<L>,
    pub(super) by_displacement: Lane<L>,
    pub(super) by_force: Lane<L>,
}

/// A contact after a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactStep<const L: usize> {
    /// Relative displacement r.
    pub displacement: Lane<L>,
    /// Relative velocity rdot.
    pub velocity: Lane<L>,
    /// Force S.
    pub force: Lane<L>,
    /// Friction limit; 0 for an impact.
    pub limit: Lane<L>,
    /// r - S/k^C of the displacement-control model; r of the other laws.
    pub slip: Lane<L>,
}

impl<const L: usize> State<'_, L> {
    /// Displacement of a node, numbered as in the structure.
    #[inline(always)]
    pub fn displacement(&self, node: usize) -> Lane<L> {
        let node = &self.nodes[self.prepared.place[node]];
        node.p - node.w * 0.5
    }

    /// Velocity of a node.
    #[inline(always)]
    pub fn velocity(&self, node: usize) -> Lane<L> {
        let dt = self.prepared.dt;
        self.nodes[self.prepared.place[node]].w.map(|w| w / dt)
    }

    /// A contact.
    #[inline(always)]
    pub fn contact(&self, contact: usize) -> ContactStep<L> {
        let dt = self.prepared.dt;
        let [_, limit] = self.forces.bounds(contact);
        let contact = &self.contacts[contact];
        let displacement = contact.p - contact.w * 0.5;
        ContactStep {
            displacement,
            velocity: contact.w.map(|w| w / dt),
            force: contact.force,
            limit,
            slip: displacement - contact.force * contact.line.by_force,
        }
    }

    /// Number of contacts.
    pub fn contacts(&self) -> usize {
        self.contacts.len()
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.prepared.nodes()
    }

    /// One step; `step` is the number of its end.
    #[inline(always)]
    fn step(&mut self, step: usize) {
        self.prescribe(step);
        self.eliminate();
        self.meet(step);
        self.substitute();
        self.touch();
    }

    /// Loads and limits.
    #[inline(always)]
    fn prescribe(&mut self, step: usize) {
        let loads = self.inputs.loads();
        self.inputs.write_loads(step, &mut self.input[..loads]);
        for (input, contact) in self.input[loads..].iter_mut().zip(&self.contacts) {
            *input = contact.force * 0.5;
        }
        if self.inputs.limits_vary() {
            for (contact, limit, slides) in self.inputs.limits(step) {
                let [mut low, mut high] = self.forces.bounds(contact);
                for (l, _) in slides.iter().enumerate().filter(|(_, slides)| **slides) {
                    [low.0[l], high.0[l]] = friction(limit.0[l]);
                }
                self.forces.bound(contact, [low, high]);
            }
            self.forces.hold();
        }
    }

    /// L y = (p(i) + p(i+1))/2 - B S(i)/2 - K P(i) - C W(i)/dt.
    #[inline(always)]
    fn eliminate(&mut self) {
        let factor = &self.prepared.factor;
        let rows = self.prepared.links.lists().zip(factor.rows());
        let rows = rows.zip(self.inputs.terms.lists()).zip(&self.nodes);
        for (i, (((links, row), terms), own)) in rows.enumerate() {
            let mut q = Lane::splat(0.0);
            for term in terms {
                q = q + term.factor * self.input[term.input];
            }
            for link in links {
                let other = &self.nodes[link.to];
                q = q + ((other.p - own.p) * link.k + (other.w - own.w) * link.c);
            }
            for entry in row {
                q = q - self.work[entry.at] * entry.value;
            }
            self.work[i] = q;
        }
    }

    /// The forces S(i+1), and y of the whole step.
    #[inline(always)]
    fn meet(&mut self, step: usize) {
        let reduced = &self.prepared.reduced;
        for (c, contact) in self.contacts.iter_mut().enumerate() {
            let mut change = Lane::splat(0.0);
            for entry in reduced.list(c) {
                change = change + self.work[entry.at] * entry.by_pivot;
            }
            let line = &contact.line;
            contact.change = change;
            self.trial[c] = change * 0.5
                + contact.w * line.by_increment
                + (contact.p * line.by_displacement + contact.force * line.by_force);
        }
        let contacts = &self.contacts;
        let size = |c: usize, l: usize| {
            let contact: &ContactState<L> = &contacts[c];
            let line = &contact.line;
            let terms = [
                contact.change * 0.5,
                contact.w * line.by_increment,
                contact.p * line.by_displacement,
                contact.force * line.by_force,
            ];
            terms.iter().map(|x| x.0[l].abs()).sum()
        };
        self.forces.solve(step, &self.trial, size, &mut self.force);
        for (c, contact) in self.contacts.iter_mut().enumerate() {
            let force = self.force[c];
            contact.force = force;
            let mean = force * 0.5;
            for entry in reduced.list(c) {
                self.work[entry.at] = self.work[entry.at] - mean * entry.value;
            }
        }
    }

    /// D L^T (W(i+1) - W(i)) = y.
    #[inline(always)]
    fn substitute(&mut self) {
        let factor = &self.prepared.factor;
        let rows = factor.columns().zip(factor.reciprocals()).enumerate();
        for (i, (column, reciprocal)) in rows.rev() {
            let mut x = self.work[i] * *reciprocal;
            for entry in column {
                x = x - self.work[entry.at] * entry.value;
            }
            self.work[i] = x;
            let node = &mut self.nodes[i];
            node.w = node.w + x;
            node.p = node.p + node.w;
        }
    }

    /// The contacts after the step.
    #[inline(always)]
    fn touch(&mut self) {
        for (contact, [i, j]) in self.contacts.iter_mut().zip(&self.prepared.between) {
            let [i, j] = [&self.nodes[*i], &self.nodes[*j]];
            contact.p = j.p - i.p + contact.gap;
            contact.w = j.w - i.w;
        }
    }

    /// Whether the motion of each lane is finite.
    fn finite(&self) -> [bool; L] {
        let mut finite = [true; L];
        for node in &self.nodes {
            for (l, finite) in finite.iter_mut().enumerate() {
                *finite &= node.p.0[l].is_finite() && node.w.0[l].is_finite();
            }
        }
        finite
    }
}

impl<'a, const L: usize> State<'a, L> {
    /// The structures at t = 0.
    fn new(cases: &[&Structure; L], prepared: &'a Prepared, inputs: Inputs<L>) -> Self {
        let (n, m) = (prepared.nodes(), prepared.contacts());
        let (dt, zero) = (prepared.dt, Lane::splat(0.0));
        let mut nodes = vec![Increments { p: zero, w: zero }; n + 1];
        for (node, place) in prepared.place.iter().enumerate() {
            for (l, case) in cases.iter().enumerate() {
                let w = dt * case.velocity[node];
                nodes[*place].w.0[l] = w;
                nodes[*place].p.0[l] = case.displacement[node] + 0.5 * w;
            }
        }
        let of = |number: &dyn Fn(&Structure) -> f64| {
            let mut lane = zero;
            for (x, case) in lane.0.iter_mut().zip(cases) {
                *x = number(case);
            }
            lane
        };
        let line = |c: usize| {
            let of =
                |number: fn(Line) -> f64| of(&|case| number(Line::new(&case.contacts[c].law, dt)));
            LaneLine {
                compliance: of(|line| line.compliance),
                by_increment: of(|line| line.by_increment),
                by_displacement: of(|line| line.by_displacement),
                by_force: of(|line| line.by_force),
            }
        };
        let mut force = vec![zero; m];
        let mut failures = Vec::new();
        for (l, case) in cases.iter().enumerate() {
            match initial::forces(case) {
                Ok(forces) => {
                    for (force, start) in force.iter_mut().zip(forces) {
                        force.0[l] = start;
                    }
                }
                Err(why) => failures.push((l, why)),
            }
        }
        let contact = |c: usize| ContactState {
            p: zero,
            w: zero,
            force: force[c],
            gap: of(&|case| case.contacts[c].gap),
            line: line(c),
            change: zero,
        };
        let contacts: Vec<_> = (0..m).map(contact).collect();
        let bound = |c: usize| {
            let side = |k: usize| of(&|case| bounds(&case.contacts[c], 0.0)[k]);
            (contacts[c].line.compliance, [side(0), side(1)])
        };
        let mut forces = Forces::new(&prepared.flexibility, (0..m).map(bound));
        for (lane, why) in failures {
            forces.fail(lane, 0, why);
        }
        let mut state = State {
            prepared,
            nodes,
            contacts,
            forces,
            input: vec![zero; inputs.loads() + m],
            inputs,
            work: vec![zero; n],
            trial: vec![zero; m],
            force,
        };
        state.touch();
        state
    }
}

/// Steps L structures to step `steps`; `visit` gets the number of each step, from 0 on, and the state.
///
/// All structures must fit `prepared` ([`Prepared::fits`]). The bits of each do not depend on the others, on L, or on its place.
///
/// # Errors
/// For each lane: [`Unsolvable::NoForces`] if the forces of a step are not unique, [`Unsolvable::OutOfRange`] if the motion does not
/// remain finite. What `visit` gets of such a lane has no meaning.
pub fn run<const L: usize>(
    cases: &[&Structure; L],
    prepared: &Prepared,
    steps: usize,
    mut visit: impl FnMut(usize, &State<L>),
) -> [Result<(), Unsolvable>; L] {
    let inputs = Inputs::new(cases, prepared, steps);
    let mut state = State::new(cases, prepared, inputs);
    visit(0, &state);
    step_all(&mut state, steps, &mut visit);
    let (finite, failures) = (state.finite(), state.forces.failures());
    std::array::from_fn(|l| match failures[l] {
        Some((step, why)) => Err(Unsolvable::NoForces { step, why }),
        None if finite[l] => Ok(()),
        None => Err(Unsolvable::OutOfRange),
    })
}

// A separate small function: with other code around it, its loop compiles to slower instructions.
#[multiversion(targets("x86_64+avx512f+avx512bw+avx512cd+avx512dq+avx512vl", "x86_64+avx2"))]
fn step_all<const L: usize, V: FnMut(usize, &State<L>)>(
    state: &mut State<L>,
    steps: usize,
    visit: &mut V,
) {
    for step in 1..=steps {
        state.step(step);
        visit(step, state);
    }
}
