//! What a scheme shows.

use super::model::Model;
use crate::system::structure::Direction;

/// The structure of a case, for a picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Scheme {
    /// Masses, then bars, then matrices.
    pub parts: Vec<Part>,
    /// Springs, then contacts.
    pub links: Vec<Link>,
    /// Ends with a force, each once.
    pub loads: Vec<End>,
    /// The directions in which the ground or a support moves, each once.
    pub ground: Vec<Direction>,
}

/// A mass, a bar or matrices.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Its name.
    pub name: String,
    /// Number of elements of a bar; `None` for others.
    pub elements: Option<u32>,
    /// Nodes of matrices; `None` for others.
    pub model: Option<Model>,
}

/// A spring or a contact.
#[derive(Debug, Clone, PartialEq)]
pub struct Link {
    /// What it is.
    pub kind: LinkKind,
    /// Name of a contact; empty for a spring.
    pub name: String,
    /// Ends I and J.
    pub between: [End; 2],
    /// X, Y, Z in which its end J in matrices moves against end I where r or the extension grows; 0 without ends in matrices.
    pub direction: [f64; 3],
    /// For an end at a support that moves, its name with its direction, such as `left.x`.
    pub supports: [Option<String>; 2],
}

/// The kinds of links.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LinkKind {
    /// A spring, a dashpot or both.
    Spring {
        /// Whether k > 0.
        elastic: bool,
        /// Whether c > 0.
        viscous: bool,
    },
    /// An impact contact.
    Impact,
    /// A friction contact.
    Friction,
}

/// An end of a link.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum End {
    /// The ground.
    Ground,
    /// A part, by its place in the list.
    Part(usize, Place),
}

/// A place of a part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// A mass as a point.
    Mass,
    /// The left end of a bar.
    Left,
    /// The right end of a bar.
    Right,
    /// A node between the ends of a bar: its distance from the left end over the length.
    Inner(f64),
    /// A degree of freedom of matrices, by its place in their interface.
    Dof(usize),
}
