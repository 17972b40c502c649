//! How a link joins parts, and its ends.

use slipgap_problem::problem::structure::described::scheme::picture::{End, Link, Place};

/// How a link is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Join {
    /// Between the right face of one part and the left face of another; `None` is a wall of the ground.
    /// Of a link between the ground and a support both are `None`.
    Beside([Option<usize>; 2]),
    /// Between the top of a lower part and the bottom of an upper one; `None` is the ground.
    Above(Option<usize>, usize),
    /// Over other parts of their row, from the first to the second part.
    Over(usize, usize),
}

/// A part of a link with its place; `None` for the ground.
pub fn end(link: &Link, k: usize) -> Option<(usize, Place)> {
    match link.between[k] {
        End::Ground => None,
        End::Part(part, at) => Some((part, at)),
    }
}
