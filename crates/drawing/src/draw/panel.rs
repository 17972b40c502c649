//! Draws a panel: its areas, lines and markers.

use super::canvas::{Canvas, DrawResult, line, shade};
use super::dots::Image;
use crate::layout::sheet::{Bar, Panel};
use crate::layout::{clip, envelope, inset};
use crate::style;
use plotters::element::{PathElement, Rectangle};
use plotters_backend::DrawingBackend;

impl<B: DrawingBackend> Canvas<B> {
    pub(super) fn panel(&mut self, panel: &Panel, image: Option<&Image>) -> DrawResult<B> {
        // First, because it is white between its dots.
        if let Some(image) = image {
            self.image(image)?;
        }
        if let Some(map) = &panel.map {
            self.map(panel, map)?;
        }
        for bar in &panel.bars {
            self.bar_of_panel(panel, bar)?;
        }
        self.fills(panel)?;
        if panel.zero {
            let ends = panel.x.range.map(|x| (x, 0.0));
            self.in_units_of(panel)
                .draw(&PathElement::new(ends, line(style::ZERO_LINE)))?;
        }
        self.dots(panel)?;
        self.frame(&panel.frame)?;
        self.ticks(panel)?;
        self.curves(panel)?;
        self.contour_labels(panel)?;
        for [a, b] in &panel.arrows {
            self.arrow(panel.place(*a), panel.place(*b))?;
        }
        self.lettering(panel)?;
        match &panel.inset {
            Some(inset) => self.inset(panel, inset),
            None => Ok(()),
        }
    }

    /// An enlarged part of a panel, joined with where it is.
    fn inset(&mut self, panel: &Panel, part: &Panel) -> DrawResult<B> {
        for line in inset::joins(panel, part) {
            self.path(&line, style::ZERO_LINE)?;
        }
        self.panel(part, None)
    }

    fn bar_of_panel(&mut self, panel: &Panel, bar: &Bar) -> DrawResult<B> {
        let corners = [(bar.x[0], bar.y[1]), (bar.x[1], bar.y[0])];
        let area = self.in_units_of(panel);
        area.draw(&Rectangle::new(corners, shade(bar.shade)))?;
        area.draw(&Rectangle::new(corners, line(style::FRAME_LINE)))
    }

    /// All lines first, then all markers, so that no line runs through a marker.
    fn curves(&mut self, panel: &Panel) -> DrawResult<B> {
        for (k, series) in panel.series.iter().enumerate() {
            let points: Vec<_> = series.points.iter().map(|p| panel.place(*p)).collect();
            let parts = envelope::drawn(&panel.envelopes, k, &points);
            let visible = |part: &Vec<_>| clip::inside(part, &panel.frame);
            for visible in parts.iter().flat_map(visible) {
                for dash in clip::dashes(&visible, series.stroke.pattern()) {
                    self.curve(&dash, series.width, series.stroke.colour())?;
                }
            }
        }
        self.edges(panel)?;
        for series in &panel.series {
            let Some(marker) = series.marker else {
                continue;
            };
            for point in series.marked.iter().filter_map(|i| series.points.get(*i)) {
                let place = panel.place(*point);
                if panel.frame.contains(place) {
                    self.marker(marker, place)?;
                }
            }
        }
        Ok(())
    }
}
