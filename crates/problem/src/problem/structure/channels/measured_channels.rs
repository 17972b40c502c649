//! What was measured of a structure: channels over the times of a file, against which metrics compare.

use super::channel::{Channel, Quantity, Term};
use crate::problem::expression::quoted;
use crate::problem::numbers::parameter::shortest;
use crate::problem::structure::given::amount::Amount;
use crate::problem::structure::given::chosen::Chosen;
use crate::problem::{Case, MeasuredChannel, Violation};
use std::ops::Range;
use std::sync::Arc;

/// Fewest points that are compared.
pub const FEWEST: usize = 10;

/// Share of a step by which a time may be outside of the motion: it has round-off of the delay.
const SLACK: f64 = 1e-9;

/// The measured channels of a study.
#[derive(Debug, Clone)]
pub struct Measured {
    /// The file, or the parameter that chooses one.
    pub file: Chosen,
    /// The content of each file.
    pub tests: Vec<(&'static str, Arc<Test>)>,
    /// The channels, each with its number among the drawn ones.
    pub channels: Vec<(Channel, usize)>,
    /// The time of the file that is t = 0 of the motion; none for 0.
    pub delay: Option<Amount>,
    /// The smallest and the largest delay of the study.
    pub delays: [f64; 2],
    /// Byte offset and path of the file in the study.
    pub place: (usize, String),
}

/// The content of a file, in the units of the study.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Test {
    /// Times, which rise.
    pub time: Vec<f64>,
    /// Values at these times, for each channel.
    pub values: Vec<Vec<f64>>,
}

/// What was measured in a case.
#[derive(Debug)]
pub struct Compared<'a> {
    measured: &'a Measured,
    test: &'a Test,
    /// The time of the file that is t = 0 of the motion.
    delay: f64,
    /// The points that are compared. They are the same for all delays of the study.
    points: Range<usize>,
}

impl Measured {
    /// The number of a channel that was measured; the same quantity may have another name.
    pub fn channel(&self, channel: &Channel) -> Option<usize> {
        let mut channels = self.channels.iter();
        channels.position(|column| column.0.terms == channel.terms)
    }

    /// What was measured in a case whose motion has the steps 0..=`last`, `dt` apart.
    ///
    /// # Errors
    /// The delay is none of the study, or less than [`FEWEST`] points are within the motion.
    pub fn in_case(&self, case: &Case, dt: f64, last: u64) -> Result<Compared<'_>, Violation> {
        let name = self.file.name(case);
        let found = self.tests.iter().find(|pair| pair.0 == name);
        let (_, test) = found.ok_or_else(|| self.violation("the case has no file".to_owned()))?;
        let [least, most] = self.delays;
        let given_delay = self
            .delay
            .as_ref()
            .map(|amount| Ok((amount, amount.value(case)?)));
        let delay = match given_delay.transpose()? {
            Some((amount, delay)) => {
                let slack = SLACK * least.abs().max(most.abs());
                if delay < least - slack || delay > most + slack {
                    let [delay, least, most] = [delay, least, most].map(shortest);
                    return Err(amount.violation(format!(
                        "{delay} is not between {least} and {most}, the delays at the ends of the parameters that it contains"
                    )));
                }
                delay.clamp(least, most)
            }
            None => 0.0,
        };
        let (end, slack) = (last as f64 * dt, SLACK * dt);
        let first = test.time.partition_point(|t| t - most < -slack);
        let after = test.time.partition_point(|t| t - least <= end + slack);
        if after < first + FEWEST {
            return Err(self.violation(outside(name, test, self.delays, end, first..after)));
        }
        Ok(Compared {
            measured: self,
            test,
            delay,
            points: first..after,
        })
    }

    fn violation(&self, message: String) -> Violation {
        Violation {
            parameter: self.place.1.clone().into(),
            message,
            at: Some(self.place.0),
        }
    }
}

/// That too few points of a file are within the motion.
fn outside(name: &str, test: &Test, delays: [f64; 2], end: f64, points: Range<usize>) -> String {
    let ends = [test.time.first(), test.time.last()];
    let [from, to] = ends.map(|t| shortest(t.copied().unwrap_or_default()));
    let delay = match delays {
        [0.0, 0.0] => String::new(),
        [least, most] if least == most => format!(", with a delay of {}", shortest(least)),
        [least, most] => format!(
            ", with every delay from {} to {}",
            shortest(least),
            shortest(most)
        ),
    };
    format!(
        "{} has times from {from} to {to}, the motion from 0 to {}{delay}: {} of its points are within the motion; allowed: at least {FEWEST}",
        quoted(name),
        shortest(end),
        points.len()
    )
}

impl Compared<'_> {
    /// The measured values of a channel that are compared; `None` if it was not measured.
    pub fn values(&self, channel: &Channel) -> Option<&[f64]> {
        let column = self.measured.channel(channel)?;
        self.test.values[column].get(self.points.clone())
    }

    /// Times of the points that are compared, in the time of the motion.
    pub fn times(&self) -> Vec<f64> {
        let times = self.test.time[self.points.clone()].iter();
        times.map(|t| t - self.delay).collect()
    }

    /// All channels with all points.
    pub fn channels(&self) -> Vec<MeasuredChannel> {
        let time: Vec<f64> = self.test.time.iter().map(|t| t - self.delay).collect();
        let columns = self.measured.channels.iter().zip(&self.test.values);
        let one = |((channel, column), values): (&(Channel, usize), &Vec<f64>)| MeasuredChannel {
            name: channel.name.clone(),
            column: *column,
            time: time.clone(),
            values: values.clone(),
            compared: self.points.clone(),
        };
        columns.map(one).collect()
    }

    /// A line for `explain`.
    pub fn described(&self, case: &Case) -> String {
        let points = self.points.len();
        let of = self.test.time.len();
        let delay = match self.delay {
            0.0 => String::new(),
            delay => format!(", delay {}", shortest(delay)),
        };
        let columns = self.measured.channels.iter();
        let names: Vec<&str> = columns.map(|column| column.0.name.as_str()).collect();
        format!(
            "measured: {} of {}, {points} of {of} points are compared{delay}\n",
            names.join(", "),
            quoted(self.measured.file.name(case)),
        )
    }
}

/// r and S of a contact as channels.
pub fn measured_loop(contact: usize) -> [Channel; 2] {
    [("r", Quantity::Displacement), ("S", Quantity::Force)].map(|(name, quantity)| Channel {
        name: name.to_owned(),
        terms: vec![(1.0, Term::Contact(contact, quantity))],
    })
}
