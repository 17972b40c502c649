//! Errors over the time step, with the observed order.

use super::Curves;
use crate::FigureData;
use crate::kind::Draw;
use slipgap_drawing::layout::sheet::Sheet;
use slipgap_study::Scale;
use slipgap_study::kinds::Convergence;

impl Draw for Convergence {
    fn sheet(&self, data: &FigureData) -> Sheet {
        let curves = Curves {
            x: self.x,
            y: &self.y,
            by: self.by,
            scales: [Scale::Log; 2],
            orders: true,
            panels: None,
            checks: false,
        };
        curves.sheet(data)
    }
}
