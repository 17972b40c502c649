//! The cases of a study that its figures show.

use crate::groups::sobol::DesignMetrics;
use crate::{DrawnCase, GroupResults, Needed, PartResult, ShownCases};
use slipgap_figures::FigureData;
use slipgap_figures::style;
use slipgap_problem::problem::Case;
use slipgap_study::{ColumnRef, Figure, Study};

/// Whether a figure shows the case.
fn show(study: &Study, case: &Case) -> bool {
    let shows = |figure: &Figure| figure.filter.matches(case);
    study.figures.iter().any(shows)
}

/// Whether a figure shows histories.
pub fn show_histories(study: &Study) -> bool {
    let mut figures = study.figures.iter();
    figures.any(|figure| figure.kind.draws_histories())
}

/// Whether a figure shows the history of the case.
pub fn show_history(study: &Study, case: &Case) -> bool {
    let shows = |figure: &Figure| figure.kind.draws_histories() && figure.filter.matches(case);
    study.figures.iter().any(shows)
}

/// The columns that the figures of a study read.
pub fn needed(study: &Study) -> Needed {
    let mut needed = Needed {
        parameters: vec![false; study.problem.parameters().len()],
        measures: vec![false; study.measures.len()],
    };
    for figure in &study.figures {
        let measures = figure.kind.measures(&*study.problem);
        let reduces = measures.iter().any(|row| study.reduction(*row).is_some());
        let Some(columns) = figure.kind.columns().filter(|_| !reduces) else {
            needed.parameters.fill(true);
            needed.measures.fill(true);
            return needed;
        };
        for column in columns {
            match column {
                ColumnRef::Parameter(row) => needed.parameters[row] = true,
                ColumnRef::Metric(row) => needed.measures[row] = true,
            }
        }
        let filtered = figure.filter.0.iter();
        filtered.for_each(|(row, _)| needed.parameters[*row] = true);
    }
    needed
}

/// Adds the cases of a part that a figure shows; `needed` is what [`needed`] gives.
pub fn add(study: &Study, needed: &Needed, part: &mut PartResult, shown: &mut ShownCases) {
    if study.figures.is_empty() {
        return;
    }
    let indices = 0..part.len() as u32;
    let rows: Vec<u32> = match study
        .figures
        .iter()
        .any(|figure| figure.filter.0.is_empty())
    {
        true => indices.collect(),
        false => {
            let mut cases = part.cases.shown();
            indices
                .filter(|row| show(study, cases.at(*row as usize)))
                .collect()
        }
    };
    let PartResult {
        cases,
        metrics,
        solutions,
        ..
    } = part;
    shown.add(cases, metrics, solutions, &rows, needed);
}

/// Solves cases from the store again if a figure shows their histories.
pub fn add_histories(study: &Study, shown: &mut ShownCases) {
    if !show_histories(study) {
        return;
    }
    for row in 0..shown.len() {
        let drawn = shown.at(row);
        if drawn.solution().is_some() || shown.has_failed(row) {
            continue;
        }
        let case = drawn.case();
        if show_history(study, &case)
            && let Ok(solution) = study.solve(&case)
        {
            shown.set_solution(row, solution);
        }
    }
}

/// The result of `draw` for what a figure shows: its cases, or one case of each group if it shows reductions, and the results
/// over groups of them. Sobol' indices are those of `designs`.
pub fn with_data<T>(
    study: &Study,
    figure: &Figure,
    shown: &ShownCases,
    designs: &DesignMetrics,
    draw: impl FnOnce(&FigureData) -> T,
) -> T {
    let draw = |cases: &[DrawnCase]| {
        let groups = GroupResults::new(study, figure, cases, designs);
        draw(&FigureData {
            study,
            figure,
            cases,
            groups: &groups,
            black: false,
            dpi: style::DPI,
        })
    };
    let indices = 0..shown.len() as u32;
    let rows: Vec<u32> = match figure.filter.0.is_empty() {
        true => indices.collect(),
        false => {
            let mut cases = shown.cases().shown();
            indices
                .filter(|row| figure.filter.matches(cases.at(*row as usize)))
                .collect()
        }
    };
    let measures = figure.kind.measures(&*study.problem);
    let reduced = slipgap_study::reduced_cases(study, &measures, |take| {
        let mut cases = shown.cases().shown();
        for row in &rows {
            let row = *row as usize;
            take(cases.at(row), &|metric| shown.at(row).metric(metric));
        }
    });
    if let Some(reduced) = reduced {
        let mut shown = ShownCases::new(study.problem.schema());
        let cases = reduced.iter();
        cases.for_each(|reduced_case| shown.push(&reduced_case.case, &reduced_case.metrics, None));
        return draw(&with_snapshots(study, figure, shown).all());
    }
    if figure.kind.draws_snapshots() {
        return draw(&with_snapshots(study, figure, shown.only(&rows)).all());
    }
    let cases = rows.into_iter().map(|row| shown.at(row as usize));
    draw(&cases.collect::<Vec<_>>())
}

/// The cases with the profiles that a figure shows; none of a case that could not be solved.
fn with_snapshots(study: &Study, figure: &Figure, mut shown: ShownCases) -> ShownCases {
    for row in 0..shown.len() {
        let case = shown.at(row).case();
        let times = figure.kind.snapshot_times(&case);
        if !times.is_empty() && !shown.has_failed(row) {
            shown.set_snapshots(
                row,
                study
                    .problem
                    .as_textbook()
                    .map_or(Vec::new(), |textbook| textbook.snapshots(&case, &times)),
            );
        }
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::RunOptions;
    use slipgap_figures as figures;
    use slipgap_study::parse;

    /// Outcomes with made-up errors: the x0 of the case, times its step, plus the distance of its width from 0.3.
    fn outcomes(study: &Study) -> ShownCases {
        let row = |name: &str| study.measures.iter().position(|m| m.name == name).unwrap();
        let mut shown = ShownCases::new(study.problem.schema());
        for case in study.cases() {
            let number = |name: &str| case.number(name);
            let width = number("alpha").or(number("beta")).unwrap();
            let (x0, step) = (number("x0").unwrap(), number("dT").unwrap());
            let mut metrics = vec![None; study.measures.len()];
            metrics[row("rms_error")] = Some(x0 * step + (width - 0.3).abs());
            metrics[row("max_error")] = (width > 0.3).then_some(x0);
            shown.push(&case, &metrics, None);
        }
        shown
    }

    fn study(figure: &str) -> Study {
        let text = format!(
            r#"{{"problem": "friction-oscillator", "blocks": [
              {{"parameters": {{"law": "displacement-control", "alpha": [0.1, 0.2, 1], "dT": [0.5, 0.25], "x0": [8, 12],
                               "duration": 9}}}},
              {{"parameters": {{"law": "velocity-control", "beta": [0.3, 0.4], "dT": [0.5, 0.25], "x0": 8, "duration": 9}}}}],
              "reductions": ["least rms_error over beta, alpha", "worst max_error over alpha, beta"],
              "figures": [{{"name": "f", {figure}}}]}}"#
        );
        parse("s", &text).unwrap_or_else(|e| panic!("{e}"))
    }

    /// Label and points of the curves of each panel.
    fn curves(study: &Study) -> Vec<Vec<(String, Vec<[f64; 2]>)>> {
        let outcomes = outcomes(study);
        let figure = &study.figures[0];
        let designs = DesignMetrics::new(study);
        let sheet = with_data(study, figure, &outcomes, &designs, figures::sheet);
        let last = &sheet.small_print.last().unwrap().text;
        let words = ["smallest", "worst"].map(|of| format!("Each value is the {of} of "));
        let is_in = |text: &str| words.iter().any(|words| text.contains(words));
        assert!(is_in(last) && is_in(&sheet.description), "{last}");
        let panel = |panel: &figures::sheet::Panel| {
            let series = panel.series.iter();
            series
                .map(|series| (series.label.clone(), series.points.clone()))
                .collect()
        };
        sheet.panels.iter().map(panel).collect()
    }

    #[test]
    fn figures_of_columns_are_drawn_from_these_alone() {
        let figures = [
            (
                r#""kind": "map", "x": "alpha", "y": "dT", "z": "rms_error", "where": {"x0": 8}"#,
                [3, 1],
            ),
            (
                r#""kind": "scatter", "x": "x0", "y": "rms_error", "colour": "max_error""#,
                [1, 2],
            ),
            (r#""kind": "samples", "y": "rms_error""#, [2, 1]),
            (
                r#""kind": "sobol", "y": ["rms_error", "max_error"]"#,
                [0, 2],
            ),
        ];
        let grid = r#""parameters": {"law": "displacement-control", "alpha": [0.1, 0.2, 1], "dT": [0.5, 0.25, 0.1],
            "x0": [8, 12], "duration": 9}"#;
        let design = r#""parameters": {"law": "displacement-control", "alpha": {"uniform": [0.1, 1]}, "dT": 0.25,
            "x0": {"uniform": [8, 12]}, "duration": 9}, "design": {"kind": "saltelli", "n": 8}"#;
        for (figure, [parameters, measures]) in figures {
            let designed = figure.contains("samples") || figure.contains("sobol");
            let cases = if designed { design } else { grid };
            let text = format!(
                r#"{{"problem": "friction-oscillator", {cases}, "figures": [{{"name": "f", {figure}}}]}}"#
            );
            let study = parse("s", &text).unwrap_or_else(|e| panic!("{e}"));
            let drawn = |needed: &Needed| {
                let mut shown = ShownCases::new(study.problem.schema());
                let mut designs = DesignMetrics::new(&study);
                let bar = indicatif::ProgressBar::hidden();
                crate::run(&study, &bar, &RunOptions::METRICS, |mut part| {
                    designs.add(part.first, &part.cases, &part.metrics);
                    add(&study, needed, &mut part, &mut shown);
                    Ok(())
                })
                .unwrap();
                let figure = &study.figures[0];
                with_data(&study, figure, &shown, &designs, |data| {
                    figures::svg(&figures::sheet(data), 192).unwrap()
                })
            };
            let needed_columns = needed(&study);
            let count = |needed: &[bool]| needed.iter().filter(|needed| **needed).count();
            assert_eq!(
                [
                    count(&needed_columns.parameters),
                    count(&needed_columns.measures)
                ],
                [parameters, measures]
            );
            let every_column = Needed {
                parameters: vec![true; needed_columns.parameters.len()],
                measures: vec![true; needed_columns.measures.len()],
            };
            assert_eq!(drawn(&needed_columns), drawn(&every_column));
        }
    }

    #[test]
    fn curves_have_one_point_for_each_group_and_no_label_of_what_is_reduced() {
        let reductions =
            r#""y": ["least rms_error over beta, alpha", "worst max_error over alpha, beta"]"#;
        let study = study(&format!(
            r#""kind": "metric", "x": "dT", {reductions}, "where": {{"x0": 8}}"#
        ));
        let drawn = curves(&study);
        // The best widths are 0.2 and 0.3: errors of 8 dT + 0.1 and 8 dT.
        assert_eq!(
            drawn[0],
            [
                (
                    "displacement control".into(),
                    vec![
                        [0.25, 2.0 + (0.2_f64 - 0.3).abs()],
                        [0.5, 4.0 + (0.2_f64 - 0.3).abs()]
                    ]
                ),
                ("velocity control".into(), vec![[0.25, 2.0], [0.5, 4.0]])
            ]
        );
        assert_eq!(drawn[1][0].1, [[0.25, 8.0], [0.5, 8.0]]);
    }

    #[test]
    fn the_filter_chooses_cases_before_they_are_reduced() {
        let study = study(
            r#""kind": "convergence", "by": "law", "y": "worst max_error over alpha, beta",
                "where": {"x0": 8, "alpha": [0.1, 0.2]}"#,
        );
        let [panel] = &curves(&study)[..] else {
            panic!("one panel");
        };
        // No width above 0.3 is left, so that the group has no value; velocity-control has no alpha.
        let points = &panel[0].1;
        assert_eq!(points.iter().map(|p| p[0]).collect::<Vec<_>>(), [0.25, 0.5]);
        assert!(points.iter().all(|point| point[1].is_nan()));
        let of_laws = panel.iter().filter(|(label, _)| label.contains("control"));
        assert!(of_laws.count() <= 1);
    }

    #[test]
    fn groups_keep_what_their_cases_share_and_lose_the_rest() {
        let study = study(
            r#""kind": "front", "x": "worst max_error over alpha, beta", "y": "least rms_error over beta, alpha", "by": "law""#,
        );
        let outcomes = outcomes(&study);
        let (figure, designs) = (&study.figures[0], DesignMetrics::new(&study));
        let cases = with_data(&study, figure, &outcomes, &designs, |data| {
            data.cases
                .iter()
                .map(|shown| {
                    let metrics = (0..study.measures.len()).map(|row| shown.metric(row));
                    (shown.case(), metrics.collect::<Vec<_>>())
                })
                .collect::<Vec<_>>()
        });
        assert_eq!(cases.len(), 6);
        for (case, metrics) in &cases {
            assert_eq!([case.number("alpha"), case.number("beta")], [None, None]);
            let (x0, step) = (case.number("x0").unwrap(), case.number("dT").unwrap());
            let off = match case.choice("law") {
                "velocity-control" => 0.0,
                _ => (0.2_f64 - 0.3).abs(),
            };
            let found: Vec<Option<f64>> =
                study.reductions().map(|(row, ..)| metrics[row]).collect();
            assert_eq!(found, [Some(x0 * step + off), Some(x0)]);
        }
    }
}
