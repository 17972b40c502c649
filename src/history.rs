//! Quantities over time: one list of times, and one list of values for each channel.

/// The channels of a motion at the steps 0..=N, in the problem's scales.
///
/// An exact solution is a history too (sampled at the same times), so that metrics and overlays need no special case.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct History {
    /// Time: T for the oscillator, t/T_I for bars.
    pub time: Vec<f64>,
    /// The values of each channel, one a time. The first three of a contact are r, rdot and its force.
    pub channels: Vec<Vec<f64>>,
}

impl History {
    /// An empty history of a contact with room for `len` rows.
    pub fn of_contact(len: usize) -> History {
        History {
            time: Vec::with_capacity(len),
            channels: (0..3).map(|_| Vec::with_capacity(len)).collect(),
        }
    }

    /// Adds one row: the time and the value of each channel.
    pub fn push<const N: usize>(&mut self, time: f64, values: [f64; N]) {
        self.time.push(time);
        for (channel, value) in self.channels.iter_mut().zip(values) {
            channel.push(value);
        }
    }

    /// The values of a channel; none where there is no such channel.
    pub fn channel(&self, channel: usize) -> &[f64] {
        self.channels.get(channel).map_or(&[], Vec::as_slice)
    }

    /// Relative displacement of the first contact: X, or r/(c T_I/2).
    pub fn displacement(&self) -> &[f64] {
        self.channel(0)
    }

    /// Relative velocity of the first contact: V, or rdot/c.
    pub fn velocity(&self) -> &[f64] {
        self.channel(1)
    }

    /// Force of the first contact: S in units of nu N, or F/F0.
    pub fn force(&self) -> &[f64] {
        self.channel(2)
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
        self.channels
            .iter()
            .all(|channel| channel.iter().all(|x| x.is_finite()))
    }
}
