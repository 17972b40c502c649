//! The state of a contact in an exact solution.

/// Relative displacement, relative velocity and force of a contact at one time, in the scales of the problem.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// X for the oscillator, r/(c T_I/2) for bars.
    pub displacement: f64,
    /// X' for the oscillator, rdot/c for bars.
    pub velocity: f64,
    /// S/(nu N) for the oscillator: the sign of X' in sliding, -X at rest. F/F0 >= 0 for bars.
    pub force: f64,
}

impl State {
    /// Bars in flight at the distance `displacement`, before they touch.
    pub(super) fn flight(displacement: f64) -> State {
        State {
            displacement,
            velocity: -1.0,
            force: 0.0,
        }
    }

    /// The values of the channels of a contact, see [`crate::history::History`].
    pub fn values(self) -> [f64; 3] {
        [self.displacement, self.velocity, self.force]
    }
}
