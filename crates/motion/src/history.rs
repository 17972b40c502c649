//! Quantities over time: one list of times, and one list of values for each channel.

/// The channels of a motion at the steps 0..=N, in the problem's scales.
///
/// An exact solution is a history too (sampled at the same times), so that metrics and overlays need no special case.
///
/// The oscillator of `[F]` slides in half a period from 12 Δ to -10 Δ:
///
/// ```
/// use slipgap_motion::exact::coulomb::Coulomb;
/// use slipgap_motion::history::History;
/// use std::f64::consts::PI;
///
/// let exact = Coulomb::new(12.0);
/// let history = History::sample(&[0.0, PI, 2.0 * PI], |time| exact.at(time).values());
/// assert_eq!(history.displacement(), [12.0, -10.0, 8.0]);
/// assert_eq!(history.velocity(), [0.0; 3]);
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct History {
    /// Time: T for the oscillator, t/T_I for bars.
    pub time: Vec<f64>,
    /// The values of each channel, one for each time. The first three of a contact are r, rdot and its force.
    pub channels: Vec<Vec<f64>>,
}

impl History {
    /// A motion at these times; `values` returns the value of each channel at a time.
    pub fn sample<const N: usize>(
        times: &[f64],
        mut values: impl FnMut(f64) -> [f64; N],
    ) -> History {
        times.iter().map(|&time| (time, values(time))).collect()
    }

    /// The values of a channel; none if there is no such channel.
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

/// Rows of a time and the value of each channel.
impl<const N: usize> FromIterator<(f64, [f64; N])> for History {
    fn from_iter<I: IntoIterator<Item = (f64, [f64; N])>>(rows: I) -> History {
        let rows = rows.into_iter();
        let len = rows.size_hint().0;
        let mut history = History {
            time: Vec::with_capacity(len),
            channels: (0..N).map(|_| Vec::with_capacity(len)).collect(),
        };
        for (time, values) in rows {
            history.time.push(time);
            for (channel, value) in history.channels.iter_mut().zip(values) {
                channel.push(value);
            }
        }
        history
    }
}
