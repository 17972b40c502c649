//! Laws with a state in continuous time.

/// A law whose force follows from a state z that moves with the contact: the limit of its step for a step that goes to zero.
///
/// |z| stays within a bound: at the bound z follows it, as long as it would leave it otherwise.
pub trait Evolution {
    /// dz/dt at this state and rdot.
    fn rate(&self, z: f64, rdot: f64) -> f64;

    /// S at this state, r and rdot; z itself where nothing else is said.
    fn force(&self, z: f64, _r: f64, _rdot: f64) -> f64 {
        z
    }

    /// z of a contact at rest at r under S.
    fn state(&self, s: f64, _r: f64) -> f64 {
        s
    }

    /// z at t = 0: that of the equilibrium at r with static loads, where S was `at_rest`, whatever velocity the contact has from then
    /// on; 0 for a contact that nothing has bent.
    fn at_start(&self, at_rest: Option<f64>, r: f64) -> f64 {
        at_rest.map_or(0.0, |s| self.state(s, r))
    }

    /// The largest |z|; infinite without one.
    fn bound(&self) -> f64;
}
