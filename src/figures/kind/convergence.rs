//! Errors over the time step, with the observed order.

use super::Draw;
use super::over_parameter::Curves;
use crate::figures::DrawnCase;
use slipgap_drawing::layout::sheet::Sheet;
use slipgap_study::kinds::Convergence;
use slipgap_study::{Figure, Scale, Study};

impl Draw for Convergence {
    fn sheet(&self, study: &Study, figure: &Figure, cases: &[DrawnCase]) -> Sheet {
        let curves = Curves {
            x: self.x,
            y: &self.y,
            by: self.by,
            scales: [Scale::Log; 2],
            orders: true,
        };
        curves.sheet(study, figure, cases)
    }
}
