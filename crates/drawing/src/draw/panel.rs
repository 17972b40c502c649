//! Draws a panel: its areas, lines and markers.

use super::canvas::{Canvas, DrawResult, line, shade};
use super::dots::Image;
use crate::layout::sheet::{Bar, Panel};
use crate::layout::{clip, coincide, envelope, inset};
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
        self.edges(panel)?;
        for k in coincide::order(panel) {
            let series = &panel.series[k];
            let points: Vec<_> = series.points.iter().map(|p| panel.place(*p)).collect();
            let parts = envelope::drawn(&panel.envelopes, k, &points);
            let visible = parts
                .iter()
                .flat_map(|part| clip::inside(part, &panel.frame));
            for dash in coincide::dashes(panel, k, &visible.collect::<Vec<_>>()) {
                self.curve(&dash, series.width, series.stroke.colour())?;
            }
        }
        for series in &panel.series {
            let colour = series.stroke.colour();
            let marked = series.marked.iter().filter_map(|i| series.points.get(*i));
            let shown = |point: &[f64; 2]| panel.frame.contains(panel.place(*point));
            match series.marker {
                Some(marker) => {
                    for point in marked.filter(|point| shown(point)) {
                        self.marker(marker, panel.place(*point), colour)?;
                    }
                }
                None if coincide::is_curve(series) => {
                    for point in alone(&series.points).filter(shown) {
                        self.dot(panel.place(point), colour)?;
                    }
                }
                None => {}
            }
        }
        Ok(())
    }
}

/// The points of a curve without a neighbour, which no line shows.
fn alone(points: &[[f64; 2]]) -> impl Iterator<Item = [f64; 2]> {
    let is_there = |i: usize| {
        points
            .get(i)
            .is_some_and(|p| p.iter().all(|x| x.is_finite()))
    };
    let alone = move |i: &usize| {
        is_there(*i) && !is_there(i + 1) && i.checked_sub(1).is_none_or(|before| !is_there(before))
    };
    (0..points.len()).filter(alone).map(|i| points[i])
}
