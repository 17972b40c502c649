//! Draws the ticks, numbers and titles of the axes of a panel.

use super::canvas::{Canvas, DrawResult, line, unit};
use crate::layout::sheet::{Anchor, Panel};
use crate::layout::{TITLE_LINE, foot, horizontal_title, vertical_title};
use crate::{style, text};
use plotters::element::{EmptyElement, PathElement};
use plotters_backend::DrawingBackend;

impl<B: DrawingBackend> Canvas<B> {
    /// The ticks along all four sides, inwards.
    pub(super) fn ticks(&mut self, panel: &Panel) -> DrawResult<B> {
        let area = self.in_units_of(panel);
        let tick = |at: (f64, f64), along: (i32, i32)| {
            let stroke = PathElement::new([(0, 0), along], line(style::FRAME_LINE));
            area.draw(&(EmptyElement::at(at) + stroke))
        };
        let [[left, right], [bottom, top]] = [panel.x.range, panel.y.range];
        for mark in &panel.x.ticks {
            let length = unit(tick_length(&mark.label));
            tick((mark.at, bottom), (0, -length))?;
            tick((mark.at, top), (0, length))?;
        }
        for mark in &panel.y.ticks {
            let length = unit(tick_length(&mark.label));
            tick((left, mark.at), (length, 0))?;
            tick((right, mark.at), (-length, 0))?;
        }
        Ok(())
    }

    /// The numbers and titles of the axes, the caption and the notes.
    pub(super) fn lettering(&mut self, panel: &Panel) -> DrawResult<B> {
        let (frame, size) = (&panel.frame, style::LABEL);
        if panel.x.numbered {
            let y = frame.bottom() + style::LABEL_GAP + style::CAP_HEIGHT * size;
            for tick in &panel.x.ticks {
                let x = panel.place([tick.at, 0.0])[0];
                self.text(&tick.label, size, [x, y], Anchor::Middle, false)?;
            }
        }
        let lines = horizontal_title(&panel.x, frame.width);
        let y = frame.bottom() + foot(&panel.x, frame.width) - style::TITLE * 0.3;
        let mut right = frame.right() + style::EDGE;
        if panel.x.numbered && panel.x.power != 0 {
            let power = panel.x.power_label();
            self.text(&power, size, [frame.right(), y], Anchor::End, false)?;
            right = frame.right() - text::width(&power, size) - style::TITLE_GAP;
        }
        for (i, line) in lines.iter().enumerate() {
            // In the middle, or left of the power.
            let half = text::width(line, style::TITLE) / 2.0;
            let middle = (frame.left + frame.width / 2.0).min(right - half);
            let y = y - (lines.len() - 1 - i) as f64 * TITLE_LINE;
            self.text(line, style::TITLE, [middle, y], Anchor::Middle, false)?;
        }
        for tick in panel.y.ticks.iter().filter(|_| panel.y.numbered) {
            let y = frame.bottom() - frame.height * panel.y.fraction(tick.at);
            let at_label = [
                frame.left - style::LABEL_GAP,
                y + style::CAP_HEIGHT * size / 2.0,
            ];
            self.text(&tick.label, size, at_label, Anchor::End, false)?;
        }
        if panel.y.numbered {
            let gap = style::LABEL_GAP;
            let at_power = [frame.left - gap, frame.top - gap - 1.0];
            self.text(&panel.y.power_label(), size, at_power, Anchor::End, false)?;
        }
        let middle = frame.top + frame.height / 2.0;
        let x = frame.left - panel.margin + style::TITLE * 0.75;
        let lines = vertical_title(&panel.y.title, frame.height);
        for (i, text) in lines.iter().enumerate() {
            let at_line = [x + i as f64 * TITLE_LINE, middle];
            self.text(text, style::TITLE, at_line, Anchor::Middle, true)?;
        }
        let at_caption = [frame.left, frame.top - style::LABEL_GAP];
        self.text(
            &panel.caption,
            style::TITLE,
            at_caption,
            Anchor::Start,
            false,
        )?;
        panel
            .notes
            .iter()
            .try_for_each(|text| self.placed_text(text))
    }
}

/// Length of a tick with this label, in points.
pub(super) fn tick_length(label: &str) -> f64 {
    if label.is_empty() {
        style::MINOR_TICK
    } else {
        style::MAJOR_TICK
    }
}
