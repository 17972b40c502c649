//! What happens to the mean of a record.

/// Whether the mean of the values of a record is subtracted from them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mean {
    /// It is subtracted.
    Removed,
    /// The values stay as they are.
    Kept,
}

impl Mean {
    /// Both.
    pub const ALL: [Mean; 2] = [Mean::Removed, Mean::Kept];

    /// Its name in a study.
    pub fn name(self) -> &'static str {
        match self {
            Mean::Removed => "removed",
            Mean::Kept => "kept",
        }
    }
}

/// The mean of some values.
pub(super) fn of(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}
