//! The path of a contact in a plane: a curve with equal scales, and the disc of its limit where it is of forces.

use super::curve::{DrawWith, Look};
use crate::kind::Draw;
use crate::{DrawnCase, FigureData};
use slipgap_drawing::layout::sheet::{Series, Sheet};
use slipgap_problem::problem::Quantity;
use slipgap_study::Study;
use slipgap_study::kinds::Orbit;
use std::f64::consts::TAU;

/// Points of a circle.
const POINTS: u32 = 360;

impl Draw for Orbit {
    fn sheet(&self, data: &FigureData) -> Sheet {
        let quantities = &data.study.problem.schema().quantities;
        let of = &quantities[self.0.x];
        let solved = data.cases.iter().filter(|c| c.solution().is_some());
        let limits = solved.filter_map(|shown| limit(data.study, of, shown));
        let largest = limits.fold(0.0, f64::max);
        let disc = (largest > 0.0).then(|| {
            let angle = |i: u32| TAU * f64::from(i) / f64::from(POINTS);
            let point = |i| [largest * libm::cos(angle(i)), largest * libm::sin(angle(i))];
            Series {
                label: "limit".into(),
                ..Series::exact((0..=POINTS).map(point).collect())
            }
        });
        self.0.sheet_with(data, &Look { equal: true, disc })
    }
}

/// The largest limit of the contact that a force of a direction is of; `None` for other quantities.
fn limit(study: &Study, of: &Quantity, shown: &DrawnCase) -> Option<f64> {
    let contact = of
        .name
        .strip_suffix(".S.1")
        .or(of.name.strip_suffix(".S.2"))?;
    let (case, solution) = (shown.case(), shown.solution()?);
    let columns = study.problem.history_columns(&case);
    let names: Vec<&str> = columns.iter().map(|shown| &*shown.column.name).collect();
    // Each contact has one rdot; lengths have one besides.
    let is_length = |name: &str| names.contains(&&*format!("{name}.1"));
    let mut rates = names.iter().filter(|name| {
        let plain = name.trim_end_matches(".1").trim_end_matches(".2");
        plain.ends_with(".rdot") && !is_length(name)
    });
    let row = rates.position(|name| **name == format!("{contact}.rdot.1"))?;
    let limits = study
        .problem
        .as_structure()
        .map_or(Vec::new(), |structure| {
            structure.friction_limits(&case, &solution.computed)
        });
    let limit = limits.get(row)?.as_ref()?;
    Some(limit.iter().copied().fold(0.0, f64::max))
}
