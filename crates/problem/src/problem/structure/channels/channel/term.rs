//! Quantities of a structure by their names.

use super::Quantity;
use super::number::{Derived, Energy, Number};
use crate::problem::numbers::unit::Dimension;
use crate::problem::structure::given::node::{NodeRef, Numbering};
use crate::system::structure::{Direction, Quantity as OfMotion};

/// A quantity over time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Term {
    /// u of a node.
    Displacement(NodeRef),
    /// u' of a node.
    Velocity(NodeRef),
    /// u'' of a node or of a support.
    Acceleration(NodeRef),
    /// u'' of a node with the acceleration of the ground.
    Absolute(NodeRef),
    /// A quantity of a contact, by its place in the list.
    Contact(usize, Quantity),
    /// Force of a spring, by its place in the list.
    Spring(usize),
    /// Force of an element of a bar, from 1 at its left end on.
    Element(usize, u32),
    /// u of a node in a force of members, which its factor makes a force, or a moment.
    Member(NodeRef, Dimension),
    /// A quantity of the motion of the ground.
    Ground(Direction, OfMotion),
    /// Force of the ground and of all supports on the structure.
    Base(Direction),
    /// Force of a support that moves, by its place among the motions.
    Reaction(usize),
    /// An energy.
    Energy(Energy),
}

impl Term {
    /// What it measures.
    pub fn dimension(self) -> Dimension {
        match self {
            Term::Displacement(_) | Term::Ground(_, OfMotion::Displacement) => Dimension::Length,
            Term::Velocity(_) | Term::Ground(_, OfMotion::Velocity) => Dimension::Velocity,
            Term::Acceleration(_) | Term::Absolute(_) | Term::Ground(_, OfMotion::Acceleration) => {
                Dimension::Acceleration
            }
            Term::Contact(_, quantity) => match quantity {
                Quantity::Displacement
                | Quantity::Slip
                | Quantity::Distance
                | Quantity::SlipDistance => Dimension::Length,
                Quantity::Velocity | Quantity::Speed => Dimension::Velocity,
                Quantity::Force | Quantity::Limit | Quantity::Size => Dimension::Force,
            },
            Term::Spring(_) | Term::Element(..) | Term::Base(_) | Term::Reaction(_) => {
                Dimension::Force
            }
            Term::Member(_, dimension) => dimension,
            Term::Energy(_) => Dimension::Energy,
        }
    }

    /// Whether it needs more of a structure than its equations and its motion.
    pub fn is_derived(self) -> bool {
        match self {
            Term::Displacement(_) | Term::Velocity(_) | Term::Contact(..) | Term::Member(..) => {
                false
            }
            Term::Acceleration(node) => !matches!(node, NodeRef::Support(_) | NodeRef::Ground),
            Term::Absolute(_)
            | Term::Spring(_)
            | Term::Element(..)
            | Term::Ground(..)
            | Term::Base(_)
            | Term::Reaction(_)
            | Term::Energy(_) => true,
        }
    }

    /// The node that it is of.
    pub fn node(self) -> Option<NodeRef> {
        match self {
            Term::Displacement(node)
            | Term::Velocity(node)
            | Term::Acceleration(node)
            | Term::Absolute(node)
            | Term::Member(node, _) => Some(node),
            Term::Contact(..)
            | Term::Spring(_)
            | Term::Element(..)
            | Term::Ground(..)
            | Term::Base(_)
            | Term::Reaction(_)
            | Term::Energy(_) => None,
        }
    }

    /// The quantity of a structure with this numbering; `None` for the ground of a support that does not move, which is always 0.
    ///
    /// # Errors
    /// A bar has no such inner node or element.
    pub fn number(self, numbering: &Numbering) -> Result<Option<Number>, String> {
        let derived = |derived| Some(Number::Derived(derived));
        Ok(match self {
            Term::Displacement(node) | Term::Member(node, _) => {
                numbering.find(node)?.map(Number::Displacement)
            }
            Term::Velocity(node) => numbering.find(node)?.map(Number::Velocity),
            Term::Acceleration(NodeRef::Support(support))
            | Term::Absolute(NodeRef::Support(support)) => Some(Number::Acceleration(support)),
            Term::Acceleration(node) => {
                let node = numbering.find(node)?;
                node.map(|node| Number::Derived(Derived::Acceleration(node)))
            }
            Term::Absolute(node) => {
                let node = numbering.find(node)?;
                node.map(|node| Number::Derived(Derived::Absolute(node)))
            }
            Term::Contact(contact, quantity) => Some(Number::Contact(contact, quantity)),
            Term::Spring(spring) => derived(Derived::Spring(spring)),
            Term::Element(bar, element) => {
                derived(Derived::Element(bar, numbering.element(bar, element)?))
            }
            Term::Ground(direction, quantity) => derived(Derived::Ground(direction, quantity)),
            Term::Base(direction) => derived(Derived::Base(direction)),
            Term::Reaction(support) => derived(Derived::Reaction(support)),
            Term::Energy(energy) => Some(Number::Energy(energy)),
        })
    }
}
