//! The state of structures in lanes, by the constant average acceleration method.

use super::lane_contacts::Start;
pub(crate) use super::lane_contacts::{ContactState, LaneLine};
use crate::lane::Lane;
use crate::solve::structure::contacts::curved::contacts::Curved;
use crate::solve::structure::contacts::curved::lanes::curved_lanes;
use crate::solve::structure::contacts::curved::step::Motion;
use crate::solve::structure::contacts::forces::Forces;
use crate::solve::structure::contacts::laws::Line;
use crate::solve::structure::contacts::static_friction::StaticFriction;
use crate::solve::structure::inputs::loads_at_steps::Inputs;
use crate::solve::structure::inputs::pressing::Pressing;
use crate::solve::structure::linear_part::moving::Moving;
use crate::solve::structure::start::initial;
use crate::solve::structure::{ContactStep, Prepared};
use crate::system::structure::Structure;

/// The state of L structures after a step.
#[derive(Debug)]
pub(crate) struct Average<'a, const L: usize> {
    pub(crate) prepared: &'a Prepared,
    /// P = u + W/2 by place; the last one is the ground, which does not move.
    pub(crate) p: Vec<Lane<L>>,
    /// W = dt v.
    pub(crate) w: Vec<Lane<L>>,
    pub(crate) contacts: Vec<ContactState<L>>,
    pub(crate) forces: Forces<L>,
    /// The contacts of lanes with laws that are not clipped lines; empty if there is none.
    pub(crate) curved: Vec<Option<Curved>>,
    pub(crate) inputs: Inputs<L>,
    /// The last step.
    pub(crate) step: usize,
    /// Right side, then the solution; the last one is the ground.
    pub(crate) work: Vec<Lane<L>>,
    pub(crate) trial: Vec<Lane<L>>,
    pub(crate) force: Vec<Lane<L>>,
    /// Changes of u of the nodes without mass over the last step by place, and 0 of the others; empty if all have mass.
    pub(crate) moved: Vec<Lane<L>>,
    /// Supports that move.
    pub(crate) moving: Option<Moving<L>>,
    /// Friction with two limits.
    pub(crate) two_limits: Option<StaticFriction>,
    /// What presses in a step that is repeated.
    pub(crate) pressing: Option<Pressing<L>>,
    /// The start of that step.
    pub(crate) start: Start<L>,
}

/// The motions of the nodes, numbered as in the structure.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Nodes<'a, const L: usize> {
    pub(crate) prepared: &'a Prepared,
    pub(crate) p: &'a [Lane<L>],
    pub(crate) w: &'a [Lane<L>],
    pub(crate) moved: &'a [Lane<L>],
}

impl<const L: usize> Nodes<'_, L> {
    #[inline(always)]
    pub(crate) fn displacement(&self, node: usize) -> Lane<L> {
        let row = self.prepared.place[node];
        self.p[row] - self.w[row] * 0.5
    }

    #[inline(always)]
    pub(crate) fn velocity(&self, node: usize) -> Lane<L> {
        let dt = self.prepared.dt;
        let row = self.prepared.place[node];
        let change = match self.moved.get(row) {
            None => self.w[row],
            Some(moved) => self.w[row] + *moved,
        };
        change.map(|w| w / dt)
    }

    /// The same of one lane: u and u'.
    #[inline(always)]
    pub(crate) fn in_lane(&self, node: usize, l: usize) -> [f64; 2] {
        let row = self.prepared.place[node];
        let w = self.w[row].0[l];
        let change = self.moved.get(row).map_or(w, |moved| w + moved.0[l]);
        [self.p[row].0[l] - w * 0.5, change / self.prepared.dt]
    }
}

impl<const L: usize> Average<'_, L> {
    /// Displacement of a node, numbered as in the structure.
    #[inline(always)]
    pub(crate) fn displacement(&self, node: usize) -> Lane<L> {
        self.nodes().displacement(node)
    }

    /// Velocity of a node.
    #[inline(always)]
    pub(crate) fn velocity(&self, node: usize) -> Lane<L> {
        self.nodes().velocity(node)
    }

    /// The motions of the nodes.
    #[inline(always)]
    pub(super) fn nodes(&self) -> Nodes<'_, L> {
        Nodes {
            prepared: self.prepared,
            p: &self.p,
            w: &self.w,
            moved: &self.moved,
        }
    }

    /// The friction limit of a contact.
    #[inline(always)]
    pub(crate) fn limit(&self, contact: usize) -> Lane<L> {
        let [_, mut limit] = self.forces.bounds(contact);
        if let Some(friction) = &self.two_limits {
            friction.show(contact, &mut limit);
        }
        limit
    }

    /// The mean force of a contact over the last step, from its forces at both ends.
    #[inline(always)]
    pub(crate) fn mean_force(&self, contact: usize, [start, end]: [Lane<L>; 2]) -> Lane<L> {
        let mut mean = (start + end) * 0.5;
        if let Some(friction) = &self.two_limits {
            friction.show_mean(contact, end, &mut mean);
        }
        mean
    }

    /// A contact.
    #[inline(always)]
    pub(crate) fn contact(&self, contact: usize) -> ContactStep<L> {
        let dt = self.prepared.dt;
        let limit = self.limit(contact);
        let mut change = self.contacts[contact].w;
        if !self.moved.is_empty() {
            for (at, factor) in self.prepared.along.list(contact) {
                change = change + self.moved[*at] * *factor;
            }
        }
        let contact = &self.contacts[contact];
        let displacement = contact.p - contact.w * 0.5;
        ContactStep {
            displacement,
            velocity: change.map(|w| w / dt),
            force: contact.force,
            limit,
            slip: displacement - contact.force * contact.line.by_force,
        }
    }

    /// Whether the motion of each lane is finite.
    pub(crate) fn finite(&self) -> [bool; L] {
        let mut finite = [true; L];
        for (p, w) in self.p.iter().zip(&self.w) {
            for (l, finite) in finite.iter_mut().enumerate() {
                *finite &= p.0[l].is_finite() && w.0[l].is_finite();
            }
        }
        finite
    }
}

impl<const L: usize> ContactState<L> {
    /// The motion of a lane over the step without its forces.
    ///
    /// `terms` are the sizes of the terms of P and W.
    pub(crate) fn motion(&self, l: usize, dt: f64, [of_p, of_w]: [f64; 2]) -> Motion {
        let [p, w, change] = [self.p.0[l], self.w.0[l], 0.5 * self.change.0[l]];
        let displacement = p - 0.5 * w;
        Motion {
            displacement,
            velocity: w / dt,
            force: self.force.0[l],
            // rdot* = 2/dt (r* - r(i)) - rdot(i).
            change: change + w,
            rate: (2.0 * change + w) / dt,
            size: change.abs() + w.abs() + displacement.abs(),
            terms: [of_p + of_w + displacement.abs(), (of_w + w.abs()) / dt],
        }
    }
}

impl<'a, const L: usize> Average<'a, L> {
    /// The structures at t = 0.
    pub(crate) fn new(cases: &[&Structure; L], prepared: &'a Prepared, inputs: Inputs<L>) -> Self {
        let (n, m) = (prepared.nodes(), prepared.contacts());
        let (dt, zero) = (prepared.dt, Lane::splat(0.0));
        let (mut p, mut w) = (vec![zero; n + 1], vec![zero; n + 1]);
        for (node, row) in prepared.place.iter().enumerate() {
            for (l, case) in cases.iter().enumerate() {
                w[*row].0[l] = dt * case.velocity[node];
                p[*row].0[l] = case.displacement[node] + 0.5 * w[*row].0[l];
            }
        }
        for node in &prepared.massless {
            p[node.place] = p[node.place] - w[node.place] * 0.5;
            w[node.place] = zero;
        }
        let of = |number: &dyn Fn(&Structure) -> f64| {
            let mut lane = zero;
            for (x, case) in lane.0.iter_mut().zip(cases) {
                *x = number(case);
            }
            lane
        };
        let massless: Vec<usize> = prepared.massless_contacts().collect();
        let line = |c: usize| {
            let line = |case: &Structure| {
                let law = &case.contacts[c].law;
                match massless.contains(&c) {
                    false => Line::new(law, dt),
                    true => Line::without_mass(law, dt),
                }
            };
            let of = |number: fn(Line) -> f64| of(&|case| number(line(case)));
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
            let side = |k: usize| of(&|case| initial::bounds_at_start(case, c)[k]);
            (contacts[c].line.compliance, [side(0), side(1)])
        };
        let mut forces = Forces::new(&prepared.flexibility, (0..m).map(bound));
        for (lane, why) in failures {
            forces.fail(lane, 0, why);
        }
        let curved = curved_lanes(cases, &prepared.flexibility, 2.0 / dt, dt, &mut forces);
        let mut state = Average {
            prepared,
            p,
            w,
            contacts,
            forces,
            curved,
            pressing: inputs.pressing(),
            inputs,
            step: 0,
            work: vec![zero; n + 1],
            trial: vec![zero; m],
            force,
            moved: match prepared.massless.is_empty() {
                true => Vec::new(),
                false => vec![zero; n + 1],
            },
            moving: Moving::new(cases, dt, &prepared.method),
            two_limits: StaticFriction::new(cases),
            start: Start::default(),
        };
        state.touch();
        state
    }
}
