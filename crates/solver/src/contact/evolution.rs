//! Laws with a state in continuous time.

/// A law whose force follows from a state z that moves with the contact: the limit of its step for a step that goes to zero.
///
/// |z| stays within a bound: at the bound z follows it, as long as it would leave it otherwise.
pub trait Evolution {
    /// dz/dt at this state and rdot.
    fn rate(&self, z: f64, rdot: f64) -> f64;

    /// S at this state, r and rdot.
    fn force(&self, z: f64, r: f64, rdot: f64) -> f64;

    /// z of a contact with this S at r, before it moves with rdot.
    fn state(&self, s: f64, r: f64, rdot: f64) -> f64;

    /// The largest |z|; infinite without one.
    fn bound(&self) -> f64;
}
