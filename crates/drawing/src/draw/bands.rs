//! Draws bands, of dense curves and between two lines: their fills below all lines, their edges with the curves.

use super::canvas::{Canvas, DrawResult, at};
use crate::layout::clip;
use crate::layout::sheet::Panel;
use crate::style::{self, Stroke};
use plotters::element::Polygon;
use plotters::style::{Color, RGBColor};
use plotters_backend::DrawingBackend;

impl<B: DrawingBackend> Canvas<B> {
    /// The fills of the bands of a panel.
    pub fn fills(&mut self, panel: &Panel) -> DrawResult<B> {
        for band in &panel.envelopes {
            let series = &panel.series[band.series];
            let round = band.upper.iter().chain(band.lower.iter().rev());
            let corners: Vec<_> = round.map(|i| panel.place(series.points[*i])).collect();
            let corners = clip::polygon(&corners, &panel.frame);
            let [r, g, b] = series.stroke.fill();
            let corners: Vec<_> = corners.into_iter().map(at).collect();
            if corners.len() > 2 {
                let fill = RGBColor(r, g, b).filled();
                self.area.draw(&Polygon::new(corners, fill))?;
            }
        }
        for band in &panel.bands {
            let round = band.upper.iter().chain(band.lower.iter().rev());
            let corners: Vec<_> = round.map(|point| panel.place(*point)).collect();
            let corners = clip::polygon(&corners, &panel.frame);
            // One light grey for all: where bands overlap, their edges tell them apart.
            let [r, g, b] = Stroke::Solid.fill();
            let corners: Vec<_> = corners.into_iter().map(at).collect();
            if corners.len() > 2 {
                let fill = RGBColor(r, g, b).filled();
                self.area.draw(&Polygon::new(corners, fill))?;
            }
        }
        Ok(())
    }

    /// A thin line through places, with the dashes of a stroke.
    fn edge(&mut self, panel: &Panel, places: &[[f64; 2]], stroke: Stroke) -> DrawResult<B> {
        for visible in clip::inside(places, &panel.frame) {
            for dash in clip::dashes(&visible, stroke.pattern()) {
                self.curve(&dash, style::BAND_LINE, stroke.colour())?;
            }
        }
        Ok(())
    }

    /// The edges of the bands of a panel, thin, with the dashes of their curves.
    pub fn edges(&mut self, panel: &Panel) -> DrawResult<B> {
        for band in &panel.envelopes {
            let series = &panel.series[band.series];
            for edge in [&band.upper, &band.lower] {
                let places: Vec<_> = edge
                    .iter()
                    .map(|i| panel.place(series.points[*i]))
                    .collect();
                self.edge(panel, &places, series.stroke)?;
            }
        }
        for band in &panel.bands {
            for edge in [&band.upper, &band.lower] {
                let places: Vec<_> = edge.iter().map(|point| panel.place(*point)).collect();
                self.edge(panel, &places, band.stroke)?;
            }
        }
        Ok(())
    }
}
