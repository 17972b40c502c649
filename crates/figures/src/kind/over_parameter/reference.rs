//! The exact value of a metric, if the study lists it, as a thin line under the curves.

use crate::DrawnCase;
use slipgap_drawing::layout::sheet::Series;
use slipgap_drawing::style::{self, Stroke};
use slipgap_study::Measure;

/// Its label in the legend.
pub const LABEL: &str = "exact";

/// The label of several black ones, each with the dashes of its curve.
pub const SEVERAL: &str = "exact (thin, dashed like its curve)";

/// Row of the metric that is the exact value of another, called `NAME_exact`, in units like the other or not, if it is
/// among the `listed`.
pub fn row(table: &[Measure], listed: &[usize], metric: usize) -> Option<usize> {
    let drawn = &table[metric];
    // The exact values of reduced cases are not reduced.
    if drawn.reduction.is_some() {
        return None;
    }
    let name = format!("{}_exact", table[drawn.metric?].name);
    let exact = table.iter().position(|metric| metric.name == name)?;
    let is_it = |row: &Measure| row.metric == Some(exact) && row.dimension == drawn.dimension;
    let row = table.iter().position(is_it)?;
    listed.contains(&row).then_some(row)
}

/// The lines of an exact value over a parameter: one for each curve, equal ones once. If curves are black, several
/// lines have the `strokes` of their curves, so that a reader can distinguish them.
pub fn lines(
    cases: &[DrawnCase],
    indices: &[usize],
    strokes: &[Stroke],
    at: impl Fn(&DrawnCase) -> Option<f64>,
    row: usize,
) -> Vec<Series> {
    let mut lines: Vec<Series> = Vec::new();
    let mut of_lines: Vec<Stroke> = Vec::new();
    for index in 0..indices.iter().max().map_or(0, |last| last + 1) {
        let its = cases.iter().zip(indices).filter(|(_, its)| **its == index);
        let mut points: Vec<[f64; 2]> = its
            .filter_map(|(shown, _)| Some([at(shown)?, shown.metric(row)?]))
            .collect();
        points.sort_by(|a, b| a[0].total_cmp(&b[0]));
        if !points.is_empty() && lines.iter().all(|line| line.points != points) {
            of_lines.push(strokes.get(index).copied().unwrap_or(Stroke::Solid));
            lines.push(Series {
                label: LABEL.into(),
                points,
                stroke: Stroke::Solid,
                width: style::EXACT_LINE,
                marker: None,
                marked: Vec::new(),
            });
        }
    }
    let black = of_lines
        .iter()
        .all(|stroke| stroke.colour() == Stroke::Solid.colour());
    if lines.len() > 1 && black {
        for (line, stroke) in lines.iter_mut().zip(of_lines) {
            (line.label, line.stroke) = (SEVERAL.into(), stroke);
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ShownCases;
    use slipgap_problem::problem;
    use slipgap_problem::problem::Case;
    use slipgap_problem::problem::numbers::unit::Dimension;

    /// Metrics of these names, and the same in units.
    fn table(names: [&str; 4]) -> Vec<Measure> {
        let both = [None, Some(Dimension::Force)].into_iter();
        let measure = |dimension: Option<Dimension>| {
            let one = move |(metric, name): (usize, &&str)| Measure {
                name: format!("{name}{}", dimension.map_or("", |_| "_in_N")),
                symbol: String::new(),
                unit: String::new(),
                meaning: String::new(),
                metric: Some(metric),
                dimension,
                reduction: None,
                computed: None,
            };
            names.iter().enumerate().map(one).collect::<Vec<_>>()
        };
        both.flat_map(measure).collect()
    }

    #[test]
    fn an_exact_value_is_found_by_name_and_only_where_it_is_listed() {
        let table = table(["drop", "drop_exact", "rise", "drop_exact_exact_"]);
        assert_eq!(row(&table, &[0, 1, 2], 0), Some(1));
        assert_eq!(row(&table, &[0, 2], 0), None);
        assert_eq!(row(&table, &[0, 1, 2, 3], 1), None);
        assert_eq!(row(&table, &[0, 1, 2, 3], 2), None);
        // In units it is the exact value in units.
        assert_eq!(row(&table, &[0, 4, 1, 5], 4), Some(5));
        assert_eq!(row(&table, &[0, 4, 1], 4), None);
    }

    #[test]
    fn an_exact_line_follows_x_and_is_drawn_once() {
        let problem = problem::find("friction-oscillator").unwrap();
        let table = problem.parameters();
        let x = table.iter().position(|p| p.name == "x0").unwrap();
        let places = [3.0, 1.0, 2.0];
        let case = |x0: &f64| {
            let mut case = Case::new(problem.schema());
            case.values[x] = Some(slipgap_problem::problem::numbers::parameter::Value::Number(
                *x0,
            ));
            case
        };
        let cases: Vec<Case> = places.iter().cycle().take(9).map(case).collect();
        // Curves 0 and 1 have the same exact values, 2 has others; it is unknown in one case.
        let metrics: Vec<[Option<f64>; 2]> = (0..9)
            .map(|i| {
                let off = if i < 6 { 0.0 } else { 5.0 };
                let exact = 10.0 * places[i % 3] + off;
                [Some(-1.0), (i != 8).then_some(exact)]
            })
            .collect();
        let indices = [0, 0, 0, 1, 1, 1, 2, 2, 2];
        let mut shown = ShownCases::new(problem.schema());
        for (case, metrics) in cases.iter().zip(&metrics) {
            shown.push(case, metrics, None);
        }
        let shown = shown.all();
        let at = |shown: &DrawnCase| shown.number(x);
        let strokes = [Stroke::Dotted, Stroke::Solid, Stroke::Dashed];
        let alone = lines(&shown[..6], &indices[..6], &strokes, at, 1);
        assert_eq!(alone.len(), 1);
        assert!(alone[0].stroke == Stroke::Solid && alone[0].label == LABEL);
        let lines = lines(&shown, &indices, &strokes, at, 1);
        let points: Vec<_> = lines.iter().map(|line| line.points.clone()).collect();
        let whole = vec![[1.0, 10.0], [2.0, 20.0], [3.0, 30.0]];
        assert_eq!(points, [whole, vec![[1.0, 15.0], [3.0, 35.0]]]);
        assert!(
            lines
                .iter()
                .all(|line| line.label == SEVERAL && line.marker.is_none())
        );
        assert_eq!(
            [lines[0].stroke, lines[1].stroke],
            [Stroke::Dotted, Stroke::Dashed]
        );
    }
}
