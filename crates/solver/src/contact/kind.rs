//! The kinds of contacts.

/// What a contact can do, whatever its law.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum ContactKind {
    /// It closes where r becomes 0, and pushes: S <= 0.
    Impact,
    /// It resists sliding in both directions, up to a limit that may change with the normal force.
    Friction,
    /// It is never open and has no limit: S has both signs, as that of a damper between two bodies.
    Link,
}
