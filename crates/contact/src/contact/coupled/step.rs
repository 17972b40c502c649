//! The numbers of a step.

/// The numbers of one step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Step<'a> {
    pub d: &'a [f64],
    pub low: &'a [f64],
    pub high: &'a [f64],
    pub size: &'a [f64],
}

impl Step<'_> {
    /// The same numbers; the compiler may know how many they are.
    #[inline(always)]
    pub(super) fn of(self, contacts: usize) -> Self {
        Step {
            d: &self.d[..contacts],
            low: &self.low[..contacts],
            high: &self.high[..contacts],
            size: &self.size[..contacts],
        }
    }
}
