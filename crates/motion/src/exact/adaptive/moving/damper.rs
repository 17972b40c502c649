//! A damper that is steep at rest, between two ends of steps.

use crate::contact::ContactLaw;

/// A damper between two ends of steps.
#[derive(Debug, Clone, Default)]
pub(crate) struct Creep {
    /// Whether S is an unknown of the steps.
    pub(super) creeps: bool,
    /// S at the end of the last step, and at that of the last one that was tried.
    pub(super) force: f64,
    pub(super) tried: f64,
    /// S while it is sought.
    pub(super) imposed: Option<f64>,
    /// Largest |S|, and size of rdot, so far.
    pub(super) largest: f64,
    pub(super) fastest: f64,
}

impl Creep {
    /// `None` for a law that is not steep at rest.
    pub(crate) fn of(law: &ContactLaw) -> Option<Creep> {
        let [_, slope] = law.properties().rate_under(0.0)?;
        (slope == 0.0).then(Creep::default)
    }

    /// S while it does not follow from rdot.
    pub(crate) fn force(&self) -> Option<f64> {
        self.creeps.then(|| self.imposed.unwrap_or(self.tried))
    }
}
