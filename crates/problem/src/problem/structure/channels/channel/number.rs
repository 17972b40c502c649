//! Quantities of a numbered structure.

use super::Quantity;
use crate::system::structure::{Direction, Quantity as OfMotion};

/// A quantity of a numbered structure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Number {
    /// u of a node, or of a support after the nodes.
    Displacement(usize),
    /// u' of a node.
    Velocity(usize),
    /// u'' of a support that moves, by its place among them.
    Acceleration(usize),
    /// A quantity of a contact.
    Contact(usize, Quantity),
    /// What follows from the motion.
    Derived(Derived),
    /// An energy.
    Energy(Energy),
}

/// A quantity that is linear in u, v, S and the loads of an instant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Derived {
    /// u'' of a node.
    Acceleration(usize),
    /// u'' of a node with the acceleration of the ground.
    Absolute(usize),
    /// Force of a spring, by its place in the list.
    Spring(usize),
    /// Force between two nodes of a bar, the left one first.
    Element(usize, [usize; 2]),
    /// A quantity of the motion of the ground in a direction.
    Ground(Direction, OfMotion),
    /// Force of the ground and of all supports on the structure in a direction.
    Base(Direction),
    /// Force of a support that moves, by its place among them.
    Reaction(usize),
}

/// A kind of energy.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Energy {
    /// Of the masses.
    Kinetic,
    /// Of K and of the contacts.
    Elastic,
    /// Dissipated by C.
    Damping,
    /// Dissipated by all contacts.
    Contacts,
    /// Taken by the method of integration.
    Method,
    /// The energy at t = 0 and the work of the loads.
    Input,
    /// Dissipated by a contact.
    Contact(usize),
}

impl Number {
    /// The node whose motion it is; `None` for a contact.
    pub fn node(&self) -> Option<usize> {
        match self {
            Number::Displacement(node) | Number::Velocity(node) => Some(*node),
            Number::Acceleration(_)
            | Number::Contact(..)
            | Number::Derived(_)
            | Number::Energy(_) => None,
        }
    }

    /// Both directions of which it is the length; `None` for other quantities.
    pub fn directions(&self) -> Option<[Number; 2]> {
        match self {
            Number::Contact(contact, quantity) => {
                let component = quantity.of_direction()?;
                Some([0, 1].map(|direction| Number::Contact(contact + direction, component)))
            }
            Number::Displacement(_)
            | Number::Velocity(_)
            | Number::Acceleration(_)
            | Number::Derived(_)
            | Number::Energy(_) => None,
        }
    }

    /// The quantity that follows from the motion, if it is one.
    pub fn derived(&self) -> Option<Derived> {
        match self {
            Number::Derived(derived) => Some(*derived),
            Number::Displacement(_)
            | Number::Velocity(_)
            | Number::Acceleration(_)
            | Number::Contact(..)
            | Number::Energy(_) => None,
        }
    }
}
