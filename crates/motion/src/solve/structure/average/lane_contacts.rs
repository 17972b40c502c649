//! The contacts of structures in lanes, and what a step changes.

use crate::lane::Lane;
use crate::solve::structure::contacts::curved::contacts::Curved;
use crate::solve::structure::contacts::static_friction::StaticFriction;

/// The motion of a contact, and its law.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ContactState<const L: usize> {
    /// gap + B^T P.
    pub(crate) p: Lane<L>,
    /// B^T W.
    pub(crate) w: Lane<L>,
    /// S.
    pub(crate) force: Lane<L>,
    pub(crate) gap: Lane<L>,
    pub(crate) line: LaneLine<L>,
    /// B^T of the change of W without S(i+1).
    pub(crate) change: Lane<L>,
}

/// The laws of a contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LaneLine<const L: usize> {
    pub(crate) compliance: Lane<L>,
    pub(crate) by_increment: Lane<L>,
    pub(crate) by_displacement: Lane<L>,
    pub(crate) by_force: Lane<L>,
}

/// What a step changes, as at its start. The lists are kept from step to step.
#[derive(Debug, Default)]
pub(crate) struct Start<const L: usize> {
    /// P, W, the moved nodes and S.
    pub(super) lists: [Vec<Lane<L>>; 4],
    pub(super) contacts: Vec<ContactState<L>>,
    pub(super) curved: Vec<Option<Curved>>,
    pub(super) two_limits: Option<StaticFriction>,
}
