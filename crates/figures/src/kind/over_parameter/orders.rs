//! Lines of order 1 and 2.

use slipgap_drawing::layout::sheet::{Anchor, Panel, PlacedText, Series};
use slipgap_drawing::style::{self, Stroke};
use slipgap_drawing::text;

/// Label of the lines of order 1 and 2.
pub const ORDERS: &str = "orders 1 and 2";

/// Adds thin lines of order 1 and 2 from the lower left corner, for comparison.
pub fn order_lines(panel: &mut Panel) {
    let [[left, right], [bottom, top]] = [panel.x.range, panel.y.range];
    for order in [1, 2] {
        let end = bottom * libm::pow(right / left, f64::from(order));
        let mut line = Series::rule([[left, bottom], [right, end]]);
        line.stroke = Stroke::Dotted;
        line.width = style::EXACT_LINE;
        panel.series.push(line);
        // Its label a little before the line leaves the frame.
        let reach = (top / bottom).min(end / bottom);
        let at = |part: f64| {
            let y = bottom * libm::pow(reach, part);
            [left * libm::pow(y / bottom, 1.0 / f64::from(order)), y]
        };
        let text = order.to_string();
        let edge = panel.frame.right() - style::MAJOR_TICK - text::width(&text, style::LABEL) - 4.0;
        let parts = (0..20).map(|i| panel.place(at(0.93 - 0.03 * f64::from(i))));
        if let Some([x, y]) = parts.into_iter().find(|[x, _]| *x <= edge) {
            panel.notes.push(PlacedText {
                at: [x + 4.0, y + style::LABEL],
                anchor: Anchor::Start,
                text,
                size: style::LABEL,
            });
        }
    }
}
