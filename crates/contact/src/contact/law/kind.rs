//! The kinds of contacts.

/// What a contact can do, whatever its law.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum ContactKind {
    /// It closes where r becomes 0, and pushes: S <= 0.
    Impact,
    /// It resists sliding in both directions, up to a limit that may change with the normal force.
    Friction,
    /// It is none of both: it never counts as open and has no limit that changes, as a damper or a yielding part between two bodies.
    Link,
}
