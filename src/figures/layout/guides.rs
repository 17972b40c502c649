//! Thin lines that are no curves, such as zero and the ends of the bars, and how the legend names them.

use crate::figures::layout::legend::Key;
use crate::figures::layout::sheet::Panel;
use crate::figures::style::{self, Stroke};

/// The legend's line for the thin lines of these panels: zero, where one shows it, and the `others`.
pub fn key(panels: &[Panel], others: Option<&str>) -> Option<Key> {
    let zero = panels.iter().any(|panel| panel.zero).then_some("zero");
    let names: Vec<&str> = zero.into_iter().chain(others).collect();
    (!names.is_empty()).then(|| Key {
        label: names.join(", "),
        stroke: Stroke::Solid,
        width: style::ZERO_LINE,
        marker: None,
    })
}
