//! The colour bar of a map.

use crate::layout::axis::Axis;
use crate::layout::axis::Scale;
use crate::layout::limits;
use crate::layout::sheet::Rect;
use crate::style;
use crate::text;

const BAR_GAP: f64 = 12.0;
const BAR_WIDTH: f64 = 11.0;

/// Width of a colour bar and its numbers right of a frame.
pub fn room(colours: &Axis) -> f64 {
    let labels = colours.ticks.iter().map(|t| &t.label);
    let power = colours.power_label();
    let labels = labels.chain([&power]);
    let numbers = labels.map(|label| text::width(label, style::LABEL));
    BAR_GAP + BAR_WIDTH + style::LABEL_GAP + numbers.fold(0.0, f64::max)
}

/// The colour bar right of a frame.
pub fn frame(frame: &Rect) -> Rect {
    Rect {
        left: frame.right() + BAR_GAP,
        width: BAR_WIDTH,
        ..*frame
    }
}

/// The axis of the colours over `range`, or else from the smallest to the largest value with a place on the scale.
pub fn axis(
    title: &str,
    values: impl Iterator<Item = f64> + Clone,
    scale: Scale,
    range: Option<[f64; 2]>,
) -> Axis {
    let most = 7.0;
    let usable = values.filter(|v| v.is_finite() && (scale == Scale::Linear || *v > 0.0));
    let low = usable.clone().fold(f64::INFINITY, f64::min);
    let high = usable.fold(f64::NEG_INFINITY, f64::max);
    let range = range.or((low < high).then_some([low, high]));
    limits::axis(title, [low].into_iter(), scale, range, most)
}
