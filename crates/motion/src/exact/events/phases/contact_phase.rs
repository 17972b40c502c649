//! The phase of a contact.

/// The phase of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Phase {
    /// An impact contact with r > 0, or a friction contact without a normal force: no force.
    Open,
    /// An impact contact that presses; a friction contact that sticks: elastic, viscous, or rigid.
    Closed,
    /// A friction contact at its limit, in this direction, +1 or -1.
    Sliding(f64),
}
