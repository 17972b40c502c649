//! Metrics: one history against another.

pub mod friction;
pub mod impact;

/// Relative slack in comparing times and counting steps: 8 pi/(pi/10) is 80 steps, 70 (pi/10) is 7 pi.
pub const SLACK: f64 = 1e-12;

/// The number of steps N that fit in `duration`; 1.2/0.4 is 3.
pub fn steps(duration: f64, step: f64) -> u64 {
    // A quotient past u64 saturates, and is refused for its memory.
    (duration / step * (1.0 + SLACK)) as u64
}

/// Whether time `t` has reached `mark`, within the slack.
pub fn reached(t: f64, mark: f64) -> bool {
    t * (1.0 + SLACK) >= mark
}
