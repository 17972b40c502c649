//! The state of structures in lanes, by any method.

use super::sub_step_contacts::{LaneContact, LaneLine};
use crate::lane::Lane;
use crate::methods::SubStep;
use crate::solve::Unsolvable;
use crate::solve::structure::Prepared;
use crate::solve::structure::contacts::curved::contacts::Curved;
use crate::solve::structure::contacts::forces::Forces;
use crate::solve::structure::contacts::static_friction::StaticFriction;
use crate::solve::structure::general::held::corrections::Corrections;
use crate::solve::structure::general::held::impacts::Impacts;
use crate::solve::structure::inputs::loads_at_steps::Inputs;
use crate::solve::structure::inputs::pressing::Pressing;
use crate::solve::structure::linear_part::moving::Moving;

/// The state of L structures after a step.
#[derive(Debug)]
pub(crate) struct General<'a, const L: usize> {
    pub(in crate::solve::structure) prepared: &'a Prepared,
    /// The motion at the start of the last step, and at the end of each of its sub-steps.
    pub(super) stages: Vec<Stage<L>>,
    pub(super) contacts: Vec<LaneContact<L>>,
    /// The lines of the contacts, and what finds their forces, for each sub-step.
    pub(super) lines: Vec<Vec<LaneLine<L>>>,
    pub(super) forces: Vec<Forces<L>>,
    /// The contacts of lanes with laws that are not clipped lines, for each sub-step; empty if there is none.
    pub(super) curved: Vec<Vec<Option<Curved>>>,
    pub(super) inputs: Inputs<L>,
    /// Rigid stops with impulses; `None` without any.
    pub(super) impacts: Option<Impacts<L>>,
    /// Rigid stops that correct displacements; `None` without any.
    pub(super) corrections: Option<Box<Corrections<L>>>,
    /// Whether a law gives S' before r' is known.
    pub(super) knows: bool,
    /// The last step.
    pub(super) step: usize,
    /// u* - u and v* - v, u_e and v_e, by place; the last one is the ground.
    pub(super) predicted: Vec<[Lane<L>; 2]>,
    pub(super) weighted: Vec<[Lane<L>; 2]>,
    /// Right side, then a'.
    pub(super) work: Vec<Lane<L>>,
    pub(super) trial: Vec<Lane<L>>,
    pub(super) force: Vec<Lane<L>>,
    /// Supports that move.
    pub(in crate::solve::structure) moving: Option<Moving<L>>,
    /// Why a lane cannot start.
    pub(super) refused: [Option<Unsolvable>; L],
    /// Friction with two limits.
    pub(super) two_limits: Option<StaticFriction>,
    /// What presses in a sub-step that is repeated.
    pub(super) pressing: Option<Pressing<L>>,
    /// The start of that sub-step.
    pub(super) start: Start<L>,
}

/// The motion at one time.
#[derive(Debug, Clone, Default)]
pub(super) struct Stage<const L: usize> {
    /// u, v, a by place; the last one is the ground, which does not move.
    pub(super) nodes: Vec<[Lane<L>; 3]>,
    /// r, rdot, S of the contacts.
    pub(super) contacts: Vec<[Lane<L>; 3]>,
    /// What supports moved the gaps, and the rates of it; empty without supports that move.
    pub(super) gaps: Vec<[Lane<L>; 2]>,
}

/// What a sub-step changes, as at its start. The lists are kept from step to step.
#[derive(Debug, Default)]
pub(super) struct Start<const L: usize> {
    pub(super) stage: Stage<L>,
    pub(super) force: Vec<Lane<L>>,
    pub(super) curved: Vec<Option<Curved>>,
    pub(super) two_limits: Option<StaticFriction>,
    pub(super) impacts: Option<Impacts<L>>,
    pub(super) corrections: Option<Box<Corrections<L>>>,
}

/// u* - u and v* - v of a place.
#[inline(always)]
pub(super) fn predict<const L: usize>(
    sub_step: &SubStep,
    first: [Lane<L>; 3],
    [u, v, a]: [Lane<L>; 3],
) -> [Lane<L>; 2] {
    let mut du = v * sub_step.u_v + a * sub_step.u_a;
    let mut dv = a * sub_step.v_a;
    if let Some([by_u, by_v]) = sub_step.u_before {
        let moved = v - first[1];
        du = du + (u - first[0]) * by_u + moved * by_v;
        dv = dv + moved * sub_step.v_d;
    }
    [du, dv]
}
