//! A part of a panel, enlarged, in a strip at the top of its frame that no curve reaches.

use crate::layout::axis::{Axis, Scale};
use crate::layout::limits;
use crate::layout::sheet::{Panel, Rect, Series};
use crate::{style, text};

/// Height that a panel needs more for the strip.
pub const HEIGHT: f64 = 78.0;

/// Space between the strip and what is below it.
const BELOW: f64 = 8.0;

/// An axis whose upper part is free for the strip, in a panel of this height with the strip.
pub fn with_strip(mut axis: Axis, height: f64) -> Axis {
    let [low, high] = axis.range;
    axis.range[1] = axis.value(height / (height - HEIGHT));
    // No numbers beside the strip.
    axis.ticks.retain(|tick| (low..=high).contains(&tick.at));
    axis
}

/// Puts the part of a panel with such a vertical axis along `x` into the strip.
pub fn add(panel: &mut Panel, x: Axis) {
    let window = Some(x.range);
    let series: Vec<Series> = panel
        .series
        .iter()
        .map(|series| Series {
            label: String::new(),
            marked: Vec::new(),
            ..series.clone()
        })
        .collect();
    let heights = limits::heights(limits::points(series.iter()), window);
    let y = limits::axis("", heights.into_iter(), Scale::Linear, None, 3.0).with_power_at_each();
    let numbers = y
        .ticks
        .iter()
        .map(|tick| text::width(&tick.label, style::LABEL));
    let left = numbers.fold(0.0, f64::max) + style::LABEL_GAP;
    let above = style::MAJOR_TICK + 4.0;
    let frame = Rect {
        left: panel.frame.left + style::MAJOR_TICK + 4.0 + left,
        top: panel.frame.top + above,
        width: panel.frame.width - 2.0 * (style::MAJOR_TICK + 8.0) - left,
        height: HEIGHT - above - super::below(&x) - BELOW,
    };
    let mut inset = Panel::new(frame, 0.0, x, y);
    inset.zero = inset.y.range[0] < 0.0 && inset.y.range[1] > 0.0;
    inset.series = series;
    panel.inset = Some(Box::new(inset));
}

/// The lines that join a part of a panel with its inset: its outline, and a line to each lower corner of the inset.
pub fn joins(panel: &Panel, inset: &Panel) -> Vec<Vec<[f64; 2]>> {
    let [[left, right], [low, high]] = [inset.x.range, inset.y.range];
    let foot = inset.frame.bottom() + super::below(&inset.x) + 2.0;
    // The outline ends below the strip.
    let corner = |x: f64, y: f64| {
        let [x, y] = panel.place([x, y]);
        [x, y.max(foot + 1.0).min(panel.frame.bottom())]
    };
    let corners = [
        [left, low],
        [left, high],
        [right, high],
        [right, low],
        [left, low],
    ];
    let outline = corners.map(|[x, y]| corner(x, y)).to_vec();
    let [a, b] = [left, right].map(|x| corner(x, high));
    let to_left = vec![a, [inset.frame.left, foot]];
    let to_right = vec![b, [inset.frame.right(), foot]];
    vec![outline, to_left, to_right]
}

/// The area of an inset with its numbers.
pub fn area(inset: &Panel) -> Rect {
    let numbers = inset
        .y
        .ticks
        .iter()
        .map(|tick| text::width(&tick.label, style::LABEL));
    let left = numbers.fold(0.0, f64::max) + style::LABEL_GAP;
    Rect {
        left: inset.frame.left - left,
        top: inset.frame.top,
        width: inset.frame.width + left,
        height: inset.frame.height + super::below(&inset.x),
    }
}
