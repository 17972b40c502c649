//! Draws bands: their fills below all lines, their edges with the curves.

use crate::figures::clip;
use crate::figures::pen::{Drawn, Pen, at};
use crate::figures::sheet::{Envelope, Panel};
use crate::figures::style;
use plotters::element::Polygon;
use plotters::style::{Color, RGBColor};
use plotters_backend::DrawingBackend;

/// The parts of a curve that no band replaces: all of it where there is none.
pub fn drawn(envelopes: &[Envelope], series: usize, places: &[[f64; 2]]) -> Vec<Vec<[f64; 2]>> {
    let own = envelopes.iter().filter(|band| band.series == series);
    let mut hidden: Vec<(usize, usize)> = own
        .filter_map(|band| Some((*band.upper.first()?, *band.upper.last()?)))
        .collect();
    hidden.sort_unstable();
    let starts = std::iter::once(0).chain(hidden.iter().map(|(_, to)| *to));
    let end = places.len().saturating_sub(1);
    let ends = hidden.iter().map(|(from, _)| *from).chain([end]);
    let parts = starts.zip(ends).filter_map(|(a, b)| places.get(a..=b));
    parts.map(<[_]>::to_vec).collect()
}

impl<B: DrawingBackend> Pen<B> {
    /// The fills of the bands of a panel.
    pub fn fills(&mut self, panel: &Panel) -> Drawn<B> {
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
        Ok(())
    }

    /// The edges of the bands of a panel, thin, with the dashes of their curves.
    pub fn edges(&mut self, panel: &Panel) -> Drawn<B> {
        for band in &panel.envelopes {
            let series = &panel.series[band.series];
            for edge in [&band.upper, &band.lower] {
                let places: Vec<_> = edge
                    .iter()
                    .map(|i| panel.place(series.points[*i]))
                    .collect();
                for visible in clip::inside(&places, &panel.frame) {
                    for dash in clip::dashes(&visible, series.stroke.pattern()) {
                        self.curve(&dash, style::BAND_LINE, series.stroke.colour())?;
                    }
                }
            }
        }
        Ok(())
    }
}
