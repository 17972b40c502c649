//! The limits of axes: those of the study, or else round the values that are drawn; and room for their numbers.

use crate::layout::axis::Axis;
use crate::layout::axis::Scale;
use crate::layout::sheet::{Panel, Rect, Series, Sheet};
use crate::layout::ticks;
use crate::{style, text};

/// An axis over `range`, or else round the values; `most` labels at most.
pub fn axis(
    title: &str,
    values: impl Iterator<Item = f64>,
    scale: Scale,
    range: Option<[f64; 2]>,
    most: f64,
) -> Axis {
    match (scale, range) {
        (Scale::Linear, None) => ticks::around(title, values, most),
        (Scale::Log, None) => ticks::log(title, values, most),
        (Scale::Linear, Some(range)) => ticks::linear(title, range, most),
        (Scale::Log, Some(range)) => ticks::log_range(title, range, most),
    }
}

/// The heights of points inside of `x`; of all points if fewer than two are inside, or `x` is not given.
pub fn heights<'a>(
    points: impl Iterator<Item = &'a [f64; 2]> + Clone,
    x: Option<[f64; 2]>,
) -> Vec<f64> {
    let inside = |point: &&[f64; 2]| x.is_none_or(|[a, b]| (a..=b).contains(&point[0]));
    let ordinates = points.clone().map(|point| point[1]);
    let heights: Vec<f64> = points.filter(inside).map(|point| point[1]).collect();
    let known = heights.iter().filter(|height| height.is_finite()).count();
    if known < 2 {
        ordinates.collect()
    } else {
        heights
    }
}

/// The points of several curves.
pub fn points<'a>(
    series: impl Iterator<Item = &'a Series> + Clone,
) -> impl Iterator<Item = &'a [f64; 2]> + Clone {
    series.flat_map(|series| &series.points)
}

/// Makes all frames narrower, if the last number of a horizontal axis would reach over the right edge of the sheet.
pub fn keep_numbers_whole(sheet: &mut Sheet) {
    let right = sheet.width - 1.0;
    let excess = |panel: &Panel| {
        let Rect { left, width, .. } = panel.frame;
        let numbers = panel.x.ticks.iter().filter(|_| panel.x.numbered);
        let most = numbers.map(|tick| {
            let room = right - left - text::width(&tick.label, style::LABEL) / 2.0;
            room / panel.x.fraction(tick.at)
        });
        let most = most.filter(|most| *most > 0.0).fold(width, f64::min);
        (width - most).ceil()
    };
    let by = sheet.panels.iter().map(excess).fold(0.0, f64::max);
    for panel in sheet.panels.iter_mut().filter(|_| by > 0.0) {
        narrow(panel, by);
    }
}

/// Makes a frame narrower, with what is placed in it.
fn narrow(panel: &mut Panel, by: f64) {
    let Rect { left, width, .. } = panel.frame;
    let factor = (width - by) / width;
    let moved = |x: f64| left + factor * (x - left);
    panel.frame.width -= by;
    let labels = panel.map.iter_mut().flat_map(|map| &mut map.labels);
    for words in panel.notes.iter_mut().chain(labels) {
        words.at[0] = moved(words.at[0]);
    }
    if let Some(bar) = panel.map.as_mut().and_then(|map| map.bar.as_mut()) {
        bar.left -= by;
    }
    if let Some(inset) = &mut panel.inset {
        let right = moved(inset.frame.right());
        inset.frame.left = moved(inset.frame.left);
        inset.frame.width = right - inset.frame.left;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout;
    use crate::layout::sheet::{Anchor, PlacedText};

    /// A sheet of one panel up to 4 points from the edge of the sheet, as grids make them, over `range`.
    fn sheet(range: [f64; 2]) -> Sheet {
        let vertical = ticks::linear("", [0.0, 1.0], 5.0);
        let grid = layout::grid(255.0, 1, &[100.0], std::slice::from_ref(&vertical), 4.0);
        let across = ticks::linear("Time", range, grid.width / 40.0);
        let mut panel = Panel::new(grid.frames[0][0], grid.margin, across, vertical);
        let middle = panel.place([(range[0] + range[1]) / 2.0, 0.5]);
        panel.notes.push(PlacedText {
            at: middle,
            anchor: Anchor::Start,
            text: "note".to_owned(),
            size: style::LABEL,
        });
        Sheet {
            width: 255.0,
            panels: vec![panel],
            ..Sheet::default()
        }
    }

    #[test]
    fn numbers_at_the_edge_are_whole() {
        for range in [[0.0, 10_000.0], [-1.0, 10_000.0], [0.4501, 0.4502]] {
            let mut drawn = sheet(range);
            let before = drawn.panels[0].frame;
            layout::finish(&mut drawn, Vec::new(), None);
            let panel = &drawn.panels[0];
            for tick in &panel.x.ticks {
                let end =
                    panel.place([tick.at, 0.0])[0] + text::width(&tick.label, style::LABEL) / 2.0;
                assert!(end <= 254.0 + 1e-9, "{tick:?} ends at {end}");
            }
            // By less than half a number, and the note stays in the middle.
            let by = before.width - panel.frame.width;
            assert!((1.0..24.0).contains(&by), "{by}");
            let middle = panel.frame.left + panel.frame.width / 2.0;
            assert!((panel.notes[0].at[0] - middle).abs() < 1e-9);
        }
        // Short numbers need no more room.
        let mut short = sheet([0.0, 10.0]);
        let before = short.panels[0].frame.width;
        layout::finish(&mut short, Vec::new(), None);
        assert_eq!(short.panels[0].frame.width, before);
    }
}
