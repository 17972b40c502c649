//! The legend of thin lines other than curves, such as zero and the ends of the bars.

use crate::layout::legend::Key;
use crate::layout::sheet::Panel;
use crate::style::{self, Stroke};

/// The entry for the thin lines of these panels: zero if one shows it, and the `others`.
pub fn key(panels: &[Panel], others: Option<&str>) -> Option<Key> {
    let zero = panels.iter().any(Panel::shows_zero).then_some("zero");
    let names: Vec<&str> = zero.into_iter().chain(others).collect();
    (!names.is_empty()).then(|| Key {
        label: names.join(", "),
        stroke: Stroke::Solid,
        width: style::ZERO_LINE,
        marker: None,
    })
}
