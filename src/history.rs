//! What a contact does over time: the same four columns for every problem, computed or exact.

/// Relative displacement, relative velocity and element force at the steps 0..=N, in the problem's scales.
///
/// An exact solution is a history too (sampled at the same times), so metrics and overlays need no special case.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct History {
    /// Time: T for the oscillator, t/T_I for bars.
    pub time: Vec<f64>,
    /// Relative displacement: X, or r/(c T_I/2).
    pub displacement: Vec<f64>,
    /// Relative velocity: V, or rdot/c.
    pub velocity: Vec<f64>,
    /// Force of the contact: S in units of nu N, or F/F0.
    pub force: Vec<f64>,
}

impl History {
    /// An empty history with room for `len` rows.
    pub fn with_capacity(len: usize) -> History {
        History {
            time: Vec::with_capacity(len),
            displacement: Vec::with_capacity(len),
            velocity: Vec::with_capacity(len),
            force: Vec::with_capacity(len),
        }
    }

    /// Adds one row.
    pub fn push(&mut self, time: f64, displacement: f64, velocity: f64, force: f64) {
        self.time.push(time);
        self.displacement.push(displacement);
        self.velocity.push(velocity);
        self.force.push(force);
    }

    /// Number of rows, N + 1.
    pub fn len(&self) -> usize {
        self.time.len()
    }

    /// Whether there are no rows.
    pub fn is_empty(&self) -> bool {
        self.time.is_empty()
    }

    /// Whether every number is finite.
    pub fn is_finite(&self) -> bool {
        [&self.displacement, &self.velocity, &self.force]
            .iter()
            .all(|column| column.iter().all(|x| x.is_finite()))
    }
}
