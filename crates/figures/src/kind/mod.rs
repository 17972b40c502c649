//! The kinds of figure, one file each: its sheet. Its keys and checks are in `study/figure/kinds`, where studies are read.

mod budget;
mod ensemble;
mod front;
mod map;
mod motion;
mod order;
mod over_parameter;
mod samples;
mod scatter;
pub mod scheme;
mod sobol;

use super::FigureData;
use slipgap_drawing::layout::points::{self, Point};
use slipgap_drawing::layout::sheet::Sheet;
use slipgap_study::kinds::FigureKind;

/// A kind of figure that can be drawn.
pub trait Draw {
    /// The panels with their legend.
    fn sheet(&self, data: &FigureData) -> Sheet;

    /// Whether its curves can be too dense to draw. Curves over a parameter are not: they have a marker at every point.
    fn has_dense_curves(&self) -> bool {
        false
    }

    /// The points of its sheet that show their values in a report.
    fn points(&self, _: &FigureData, sheet: &Sheet) -> Vec<Point> {
        points::of_panels(sheet)
    }
}

/// How a figure is drawn.
pub fn of(kind: &FigureKind) -> &dyn Draw {
    match kind {
        FigureKind::History(kind) => kind,
        FigureKind::Profile(kind) => kind,
        FigureKind::Wave(kind) => kind,
        FigureKind::Metric(kind) => kind,
        FigureKind::Convergence(kind) => kind,
        FigureKind::Budget(kind) => kind,
        FigureKind::Map(kind) => kind,
        FigureKind::Scatter(kind) => kind,
        FigureKind::Front(kind) => kind,
        FigureKind::Envelope(kind) => kind,
        FigureKind::Samples(kind) => kind,
        FigureKind::Sobol(kind) => kind,
        FigureKind::Distribution(kind) => kind,
        FigureKind::Quantiles(kind) => kind,
        FigureKind::Fragility(kind) => kind,
        FigureKind::Law(kind) => kind,
        FigureKind::Curve(kind) => kind,
        FigureKind::Orbit(kind) => kind,
        FigureKind::Response(kind) => kind,
        FigureKind::Spectrum(kind) => kind,
        FigureKind::Set(kind) => kind,
        FigureKind::Scheme(kind) => kind,
    }
}
