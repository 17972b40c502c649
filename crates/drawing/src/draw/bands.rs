//! Draws bands, of dense curves and between two lines: their fills below all lines, their edges below the curves.

use super::canvas::{Canvas, DrawResult, at};
use crate::layout::sheet::Panel;
use crate::layout::{clip, envelope};
use crate::style::{self, Stroke};
use plotters::element::Polygon;
use plotters::style::{Color, RGBColor};
use plotters_backend::DrawingBackend;

impl<B: DrawingBackend> Canvas<B> {
    /// The fills of the bands of a panel.
    pub fn fills(&mut self, panel: &Panel) -> DrawResult<B> {
        for band in envelope::filled(panel) {
            let series = &panel.series[band.series];
            let round = band.upper.iter().chain(band.lower.iter().rev());
            let corners: Vec<_> = round.map(|i| panel.place(series.points[*i])).collect();
            let hatched = !series.stroke.hatching().is_empty();
            self.fill(panel, &corners, series.stroke, hatched)?;
        }
        for band in &panel.bands {
            let round = band.upper.iter().chain(band.lower.iter().rev());
            let corners: Vec<_> = round.map(|point| panel.place(*point)).collect();
            // One band in light grey, so that the hatching of the others shows on it.
            let hatched = !band.stroke.hatching().is_empty() && band.stroke != Stroke::Solid;
            self.fill(panel, &corners, band.stroke, hatched)?;
        }
        Ok(())
    }

    /// An area of a panel in a light colour, or hatched as its stroke.
    fn fill(
        &mut self,
        panel: &Panel,
        corners: &[[f64; 2]],
        stroke: Stroke,
        hatched: bool,
    ) -> DrawResult<B> {
        let corners = clip::polygon(corners, &panel.frame);
        if corners.len() < 3 {
            return Ok(());
        }
        if hatched {
            for direction in stroke.hatching() {
                for line in clip::hatching(&corners, *direction, style::BAND_HATCH) {
                    self.curve(&line, style::HATCH_LINE, style::BAND_GREY)?;
                }
            }
            return Ok(());
        }
        let ([r, g, b], opacity) = stroke.fill();
        let corners: Vec<_> = corners.into_iter().map(at).collect();
        let fill = RGBColor(r, g, b).mix(opacity).filled();
        self.area.draw(&Polygon::new(corners, fill))
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
