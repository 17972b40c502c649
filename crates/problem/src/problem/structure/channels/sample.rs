//! Tests that are compared as a sample with the cases of an ensemble, not point by point.

use super::channel::Channel;
use super::measured_channels::Test;
use std::sync::Arc;

/// Fewest tests of a sample.
pub const FEWEST_TESTS: usize = 2;

/// The tests of a study, each with the same channels.
#[derive(Debug, Clone)]
pub struct Sample {
    /// The content of each file.
    pub tests: Vec<Arc<Test>>,
    /// The channels, in the order of the values of a test.
    pub channels: Vec<Channel>,
}

impl Sample {
    /// Times and values of a channel in each test; `None` if it was not measured. The same quantity may have another name.
    pub fn channel(&self, channel: &Channel) -> Option<impl Iterator<Item = (&[f64], &[f64])>> {
        let mut channels = self.channels.iter();
        let column = channels.position(|known| known.terms == channel.terms)?;
        let tests = self.tests.iter();
        Some(tests.map(move |test| (&test.time[..], &test.values[column][..])))
    }
}
