//! Metrics over a parameter.

use super::Curves;
use crate::FigureData;
use crate::kind::Draw;
use slipgap_drawing::layout::sheet::Sheet;
use slipgap_study::kinds::Metric;

impl Draw for Metric {
    fn sheet(&self, data: &FigureData) -> Sheet {
        let curves = Curves {
            x: self.x,
            y: &self.y,
            by: self.by,
            panels: self.panels,
            scales: [self.x_scale, self.y_scale],
            orders: false,
            checks: self.checks,
        };
        curves.sheet(data)
    }
}
