//! Metrics over a parameter.

use super::Draw;
use super::over_parameter::Curves;
use crate::figures::DrawnCase;
use slipgap_drawing::layout::sheet::Sheet;
use slipgap_study::kinds::Metric;
use slipgap_study::{Figure, Study};

impl Draw for Metric {
    fn sheet(&self, study: &Study, figure: &Figure, cases: &[DrawnCase]) -> Sheet {
        let curves = Curves {
            x: self.x,
            y: &self.y,
            by: self.by,
            scales: [self.x_scale, self.y_scale],
            orders: false,
        };
        curves.sheet(study, figure, cases)
    }
}
