//! The numbers on contour lines: horizontal, on white, one or two for each level, without overlaps.

use crate::layout::clip;
use crate::layout::sheet::{Anchor, Panel, PlacedText, Rect};
use crate::style;
use crate::text;

/// Most numbers on the lines of one level.
const MOST: usize = 2;

/// Width of the white margin of a number.
pub const RIM: f64 = 1.5;

/// Numbers for lines in the axes' units, each with its text; long lines first, away from `occupied` places.
pub fn place(
    panel: &Panel,
    mut lines: Vec<(String, Vec<[f64; 2]>)>,
    occupied: &[[f64; 2]],
) -> Vec<PlacedText> {
    let mut placed: Vec<(Rect, PlacedText)> = Vec::new();
    let size = style::LABEL * 0.9;
    for (_, line) in &mut lines {
        *line = line.iter().map(|p| panel.place(*p)).collect();
    }
    let mut pieces: Vec<(String, Vec<[f64; 2]>, f64)> = lines
        .into_iter()
        .flat_map(|(text, line)| {
            let inside = clip::inside(&line, &panel.frame);
            inside.into_iter().map(move |piece| {
                let long = length(&piece);
                (text.clone(), piece, long)
            })
        })
        .collect();
    pieces.sort_by(|a, b| b.2.total_cmp(&a.2));
    let inner = panel.frame.inflated(-style::MAJOR_TICK);
    for (text, piece, long) in pieces {
        let (width, height) = (text::width(&text, size), style::CAP_HEIGHT * size);
        let there = placed
            .iter()
            .filter(|(_, words)| words.text == text)
            .count();
        if there == MOST || long < 1.5 * width + 10.0 {
            continue;
        }
        let area = |i: &usize| {
            let [x, y] = piece[*i];
            Rect {
                left: x - width / 2.0,
                top: y - height / 2.0,
                width,
                height,
            }
            .inflated(RIM)
        };
        let free = |area: &Rect| {
            inner.contains([area.left, area.top])
                && inner.contains([area.right(), area.bottom()])
                && !placed
                    .iter()
                    .any(|(other, _)| other.inflated(2.0).overlaps(area))
                && !occupied
                    .iter()
                    .any(|p| area.inflated(style::MARKER + 1.0).contains(panel.place(*p)))
        };
        let mut order: Vec<usize> = (0..piece.len()).collect();
        order.sort_by_key(|i| i.abs_diff(piece.len() / 2));
        if let Some(area) = order.iter().map(area).find(free) {
            let words = PlacedText {
                at: [area.left + RIM, area.bottom() - RIM],
                anchor: Anchor::Start,
                text,
                size,
            };
            placed.push((area, words));
        }
    }
    placed.into_iter().map(|(_, words)| words).collect()
}

fn length(line: &[[f64; 2]]) -> f64 {
    let step = |pair: &[[f64; 2]]| libm::hypot(pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]);
    line.windows(2).map(step).sum()
}
