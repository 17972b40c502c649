//! A mode of a reduction.

/// A mode of the free rows.
#[derive(Debug, Clone)]
pub(super) struct Mode {
    /// Square of its natural circular frequency.
    pub(super) omega2: f64,
    /// Its shape phi, phi^T M phi = 1.
    pub(super) shape: Vec<f64>,
}
