//! Draws maps: cells or bands of colour, the labels of contours, and the colour bar.

use super::axes::tick_length;
use super::canvas::{Canvas, DrawResult, at, blank, shade, unit};
use crate::colour_map::RIM;
use crate::layout::sheet::{Anchor, FilledMap, Panel, Rect};
use crate::layout::{TITLE_LINE, bar_title};
use crate::{style, text};
use plotters::element::Rectangle;
use plotters_backend::DrawingBackend;

/// Shades of a map: so many that no step is seen in the colour bar.
const SHADES: usize = 128;

/// The middle of shade `k` on the scale of colours.
fn middle(k: usize) -> f64 {
    (k as f64 + 0.5) / SHADES as f64
}

impl<B: DrawingBackend> Canvas<B> {
    pub(super) fn map(&mut self, panel: &Panel, map: &FilledMap) -> DrawResult<B> {
        match map.levels.as_slice() {
            [] => self.cells(panel, map)?,
            _ => self.bands(panel, map)?,
        }
        for [from, to] in &map.hatched {
            let [[left, bottom], [right, top]] = [*from, *to].map(|corner| panel.place(corner));
            let frame = &panel.frame;
            let [left, right] = [left, right].map(|x| x.clamp(frame.left, frame.right()));
            let [top, bottom] = [top, bottom].map(|y| y.clamp(frame.top, frame.bottom()));
            self.hatch(&Rect {
                left,
                top,
                width: right - left,
                height: bottom - top,
            })?;
        }
        let title = bar_title(panel).unwrap_or_default();
        map.bar
            .iter()
            .try_for_each(|bar| self.bar(bar, map, &title))
    }

    /// The cells, by shade; neighbours of one shade in a row are one rectangle.
    fn cells(&mut self, panel: &Panel, map: &FilledMap) -> DrawResult<B> {
        let mut shades: Vec<Vec<[(f64, f64); 2]>> = vec![Vec::new(); SHADES];
        for cell in &map.cells {
            let fraction = map.colours.fraction(cell.value);
            if !fraction.is_finite() {
                continue;
            }
            let [from, to] = [(cell.x[0], cell.y[1]), (cell.x[1], cell.y[0])];
            let shade = &mut shades[((fraction * SHADES as f64) as usize).min(SHADES - 1)];
            match shade.last_mut() {
                Some([start, end]) if *end == (from.0, to.1) && start.1 == from.1 => *end = to,
                _ => shade.push([from, to]),
            }
        }
        let area = self.in_units_of(panel);
        for (k, cells) in shades.iter().enumerate() {
            for corners in cells {
                area.draw(&Rectangle::new(*corners, shade(middle(k))))?;
            }
        }
        Ok(())
    }

    fn bands(&mut self, panel: &Panel, map: &FilledMap) -> DrawResult<B> {
        let count = map.levels.len() + 1;
        let frame = &panel.frame;
        let corners = [
            at([frame.left, frame.top]),
            at([frame.right(), frame.bottom()]),
        ];
        self.cell(corners[0], corners[1], style::band(0, count))?;
        for (band, points) in &map.areas {
            let within = |p: &[f64; 2]| {
                let [x, y] = panel.place(*p);
                [
                    x.clamp(frame.left, frame.right()),
                    y.clamp(frame.top, frame.bottom()),
                ]
            };
            let corners: Vec<_> = points.iter().map(within).collect();
            self.area(&corners, style::band(*band, count))?;
        }
        let area = self.in_units_of(panel);
        for [[left, bottom], [right, top]] in &map.blank {
            let corners = [(*left, *top), (*right, *bottom)];
            area.draw(&Rectangle::new(corners, blank()))?;
        }
        Ok(())
    }

    /// The numbers on contour lines, each on white.
    pub(super) fn contour_labels(&mut self, panel: &Panel) -> DrawResult<B> {
        for label in panel.map.iter().flat_map(|map| &map.labels) {
            let height = style::CAP_HEIGHT * label.size;
            let under = Rect {
                left: label.at[0],
                top: label.at[1] - height,
                width: text::width(&label.text, label.size),
                height,
            };
            self.blank(&under.inflated(RIM))?;
            self.placed_text(label)?;
        }
        Ok(())
    }

    fn bar(&mut self, bar: &Rect, map: &FilledMap, title: &[String]) -> DrawResult<B> {
        let colours = &map.colours;
        let (left, right) = (unit(bar.left), unit(bar.right()));
        let height = |fraction: f64| unit(bar.bottom() - bar.height * fraction.clamp(0.0, 1.0));
        if map.levels.is_empty() {
            let edge = |k: usize| height(k as f64 / SHADES as f64);
            for k in 0..SHADES {
                self.cell((left, edge(k + 1)), (right, edge(k)), middle(k))?;
            }
        } else {
            let mut edges = vec![height(0.0)];
            edges.extend(
                map.levels
                    .iter()
                    .map(|level| height(colours.fraction(*level))),
            );
            edges.push(height(1.0));
            let count = edges.len() - 1;
            for k in 0..count {
                self.cell(
                    (left, edges[k + 1]),
                    (right, edges[k]),
                    style::band(k, count),
                )?;
            }
        }
        self.frame(bar)?;
        let size = style::LABEL;
        for tick in &colours.ticks {
            let y = bar.bottom() - bar.height * colours.fraction(tick.at);
            let edge = bar.right();
            let length = tick_length(&tick.label);
            self.path(&[[edge, y], [edge - length, y]], style::FRAME_LINE)?;
            let at_label = [edge + style::LABEL_GAP, y + style::CAP_HEIGHT * size / 2.0];
            self.text(&tick.label, size, at_label, Anchor::Start, false)?;
        }
        let above = bar.top - style::LABEL_GAP - 1.0;
        let at_power = [bar.right() + style::LABEL_GAP, above];
        self.text(&colours.power_label(), size, at_power, Anchor::Start, false)?;
        for (i, line) in title.iter().rev().enumerate() {
            let at_line = [bar.right(), above - i as f64 * TITLE_LINE];
            self.text(line, style::TITLE, at_line, Anchor::End, false)?;
        }
        Ok(())
    }
}
