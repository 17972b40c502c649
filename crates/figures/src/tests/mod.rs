//! The data of the sheets first, then their pixels.

mod contents;
mod ensembles;
mod envelope;
mod extent;
mod front;
mod guides;
mod limits;
mod looks;
mod measured;
mod response;
mod samples;
mod structures;

use super::{FigureData, ShownCases, png, sheet, svg};
use crate::groups::sobol::DesignMetrics;
use crate::{DrawnCase, GroupResults};
use slipgap_drawing::layout::sheet::Sheet;
use slipgap_drawing::style::{self, Marker, Stroke};
use slipgap_motion::exact::coulomb::Coulomb;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_problem::problem::{self, Case, Snapshot, Solution};
use slipgap_study::kinds::{History, Law, Map, Metric, Profile};
use slipgap_study::{Figure, FigureKind, Filter, Scale, Study};
use std::f64::consts::PI;

const ALPHA: usize = 1;
const DT: usize = 3;
const X0: usize = 5;

/// The sheet of a figure of a study, with the snapshots of its cases.
fn drawn(study: &Study, figure: usize) -> (Sheet, Vec<Vec<Snapshot>>) {
    drawn_by(study, figure, sheet)
}

/// The same, drawn in another way.
fn drawn_by(
    study: &Study,
    figure: usize,
    draw: impl FnOnce(&FigureData) -> Sheet,
) -> (Sheet, Vec<Vec<Snapshot>>) {
    let (problem, figure) = (&study.problem, &study.figures[figure]);
    let cases: Vec<_> = study.cases().filter(|c| figure.filter.matches(c)).collect();
    let solutions: Vec<_> = cases
        .iter()
        .map(|c| problem.solve(c, &[]).unwrap())
        .collect();
    let times = figure.kind.snapshot_times(&cases[0]);
    let snapshots: Vec<_> = cases
        .iter()
        .map(|c| {
            let textbook = problem.as_textbook();
            textbook.map_or(Vec::new(), |textbook| textbook.snapshots(c, &times))
        })
        .collect();
    let mut shown = ShownCases::new(problem.schema());
    for (i, (case, solution)) in cases.iter().zip(solutions).enumerate() {
        shown.push(case, &solution.metrics.clone(), Some(solution));
        shown.set_snapshots(i, snapshots[i].clone());
    }
    let sheet = with_data(study, figure, &shown.all(), draw);
    (sheet, snapshots)
}

/// Cases with these metrics and without histories.
fn shown(study: &Study, cases: &[Case], metrics: &[Vec<Option<f64>>]) -> ShownCases {
    let mut shown = ShownCases::new(study.problem.schema());
    for (case, metrics) in cases.iter().zip(metrics) {
        shown.push(case, metrics, None);
    }
    shown
}

pub(super) struct Run {
    study: Study,
    pub(super) cases: Vec<Case>,
    solutions: Vec<Solution>,
    metrics: Vec<Vec<Option<f64>>>,
}

/// Displacement-control cases with these alpha, dT and x0, solved.
pub(super) fn run(values: &[(f64, f64, f64)]) -> Run {
    let problem = problem::find("friction-oscillator").unwrap();
    let case = |(alpha, step, x0): &(f64, f64, f64)| {
        problem.schema().case(&[
            ("law", Value::Name("displacement-control")),
            ("alpha", Value::Number(*alpha)),
            ("dT", Value::Number(*step)),
            ("duration", Value::Number(8.0 * PI)),
            ("x0", Value::Number(*x0)),
        ])
    };
    let cases: Vec<Case> = values.iter().map(case).collect();
    let solutions: Vec<_> = cases
        .iter()
        .map(|c| problem.solve(c, &[]).unwrap())
        .collect();
    let metrics = solutions.iter().map(|s| s.metrics.clone()).collect();
    let study = Study {
        once: false,
        title: "a test".into(),
        settings: Vec::new(),
        sha256: String::new(),
        read: Vec::new(),
        problem: problem.clone(),
        blocks: Vec::new(),
        ensemble: Vec::new(),
        units: None,
        measures: slipgap_study::measures(&*problem, None),
        metrics: Vec::new(),
        columns: Vec::new(),
        calibrate: None,
        recommend: None,
        figures: Vec::new(),
        checks: Vec::new(),
    };
    Run {
        study,
        cases,
        solutions,
        metrics,
    }
}

impl Run {
    fn sheet(&self, kind: FigureKind) -> Sheet {
        self.limited(kind, None, [None; 2])
    }

    /// The sheet with a width in points and limits of its axes.
    pub(super) fn limited(
        &self,
        kind: FigureKind,
        width: Option<f64>,
        ranges: [Option<[f64; 2]>; 2],
    ) -> Sheet {
        let mut shown = ShownCases::new(self.study.problem.schema());
        for (i, case) in self.cases.iter().enumerate() {
            shown.push(case, &self.metrics[i], Some(self.solutions[i].clone()));
        }
        let figure = Figure {
            name: "figure".into(),
            title: Some(
                "PlacedText over the panels that are longer than a narrow sheet is wide".into(),
            )
            .filter(|_| width.is_some()),
            note: None,
            width,
            ranges,
            colour: false,
            markers: false,
            filter: Filter::default(),
            kind,
        };
        sheet_of(&self.study, &figure, &shown.all())
    }
}

/// The sheet of a figure over these cases.
fn sheet_of(study: &Study, figure: &Figure, cases: &[DrawnCase]) -> Sheet {
    with_data(study, figure, cases, sheet)
}

/// The result of `draw` for these cases of a figure.
fn with_data<T>(
    study: &Study,
    figure: &Figure,
    cases: &[DrawnCase],
    draw: impl FnOnce(&FigureData) -> T,
) -> T {
    let designs = DesignMetrics::of_cases(study, cases);
    let groups = GroupResults::new(study, figure, cases, &designs);
    draw(&FigureData {
        black: false,
        dpi: style::DPI,
        study,
        figure,
        cases,
        groups: &groups,
    })
}

fn history(panels: Option<usize>) -> FigureKind {
    FigureKind::History(History {
        y: vec![0, 3],
        by: None,
        panels,
        in_units: false,
        stacked: false,
        inset: None,
    })
}

pub(super) fn fig5() -> Run {
    run(&[0.1, 1.0, 5.0].map(|alpha| (alpha, PI / 10.0, 12.0)))
}

#[test]
fn a_history_shows_what_was_computed() {
    let run = fig5();
    let sheet = run.sheet(history(None));
    let [response, error] = sheet.panels.as_slice() else {
        panic!("{} panels", sheet.panels.len());
    };
    let labels: Vec<_> = response.series.iter().map(|s| s.label.as_str()).collect();
    assert_eq!(labels, ["exact", "*α* = 0.1", "*α* = 1", "*α* = 5"]);
    for (i, solution) in run.solutions.iter().enumerate() {
        let (curve, miss) = (&response.series[i + 1], &error.series[i]);
        assert_eq!((curve.points.len(), miss.points.len()), (81, 81));
        for k in 0..81 {
            let (time, x) = (
                solution.computed.time[k],
                solution.computed.displacement()[k],
            );
            assert_eq!(curve.points[k], [time, x]);
            assert_eq!(miss.points[k], [time, x - solution.exact.displacement()[k]]);
        }
        assert_eq!(curve.stroke, Stroke::of_case(i));
        assert_eq!(curve.marker, Some(Marker::of_case(i)));
        assert_eq!(curve.marked, miss.marked);
        assert!((8..=11).contains(&curve.marked.len()));
    }
    let exact = &response.series[0];
    assert_eq!((exact.stroke, exact.marker), (Stroke::Solid, None));
    let coulomb = Coulomb::new(12.0);
    for [time, x] in &exact.points {
        assert_eq!(*x, coulomb.at(*time).displacement);
    }
    let ticks: Vec<_> = error.x.ticks.iter().map(|t| t.label.as_str()).collect();
    assert_eq!(
        ticks.join(" ").split_whitespace().collect::<Vec<_>>(),
        ["0", "π", "2π", "3π", "4π", "5π", "6π", "7π", "8π"]
    );
    assert_eq!([&response.caption, &error.caption], ["(a)", "(b)"]);
    assert!(response.zero && error.zero && !response.x.numbered && error.x.numbered);
    assert_eq!(sheet.description, "exact; α = 0.1; α = 1; α = 5");
}

#[test]
fn markers_of_two_curves_are_at_different_times() {
    let sheet = fig5().sheet(history(None));
    let series = &sheet.panels[0].series;
    let shared = series[1]
        .marked
        .iter()
        .filter(|i| series[2].marked.contains(i));
    assert_eq!(shared.count(), 0);
}

#[test]
fn a_crowded_legend_stands_between_the_edge_and_the_panel() {
    let run = run(&[0.1, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0].map(|alpha| (alpha, PI / 10.0, 12.0)));
    let sheet = run.sheet(FigureKind::History(History {
        y: vec![0],
        by: None,
        panels: None,
        in_units: false,
        stacked: false,
        inset: None,
    }));
    assert_eq!(sheet.legend.len(), 8);
    for entry in &sheet.legend {
        assert!(entry.at[1] - style::LEADING / 2.0 >= style::EDGE);
        assert!(entry.at[1] + style::LEADING / 2.0 <= sheet.panels[0].frame.top);
    }
}

#[test]
fn each_start_has_its_exact_curve_and_its_panel() {
    let run = run(&[
        (0.1, PI / 10.0, 12.0),
        (0.1, PI / 5.0, 12.5),
        (1.0, PI / 5.0, 12.5),
    ]);
    let together = run.sheet(history(None));
    let exact = |panel: usize, sheet: &Sheet| {
        let series = &sheet.panels[panel].series;
        series.iter().filter(|s| s.label == "exact").count()
    };
    assert_eq!(exact(0, &together), 2);
    let apart = run.sheet(history(Some(X0)));
    assert_eq!(apart.panels.len(), 4);
    assert_eq!((exact(0, &apart), exact(1, &apart)), (1, 1));
    assert_eq!(apart.panels[1].caption, "(b)  *X*_0_ = 12.5, Δ*T* = π/5");
    let index = &apart.panels[1].series[1];
    assert_eq!(
        (index.label.as_str(), index.points.len()),
        ("*α* = 0.1", 41)
    );
}

#[test]
fn a_metric_figure_has_the_metrics_and_leaves_gaps() {
    let mut run = run(&[
        (0.1, PI / 5.0, 12.0),
        (0.1, PI / 10.0, 12.0),
        (0.1, PI / 20.0, 12.0),
    ]);
    run.metrics[1][0] = None;
    let sheet = run.sheet(FigureKind::Metric(Metric {
        x: DT,
        y: vec![0],
        by: None,
        x_scale: Scale::Log,
        y_scale: Scale::Log,
        panels: None,
        checks: false,
    }));
    let points = &sheet.panels[0].series[0].points;
    // Rising in dT, whatever the order of the cases.
    assert_eq!(points[0], [PI / 20.0, run.metrics[2][0].unwrap()]);
    assert!(points[1][0] == PI / 10.0 && points[1][1].is_nan());
    assert_eq!(points[2], [PI / 5.0, run.metrics[0][0].unwrap()]);
    assert!(sheet.legend.is_empty());
    assert!(png(&sheet, style::DPI).is_ok());
}

#[test]
fn a_map_has_a_cell_for_every_case() {
    let mut values = Vec::new();
    for step in [PI / 5.0, PI / 10.0] {
        for alpha in [0.1, 1.0, 10.0] {
            values.push((alpha, step, 12.0));
        }
    }
    let run = run(&values);
    let sheet = run.sheet(FigureKind::Map(Map {
        x: ALPHA,
        y: DT,
        z: 0,
        scales: [Scale::Log; 3],
        z_range: None,
        marks: None,
        ridge: None,
    }));
    let map = sheet.panels[0].map.as_ref().unwrap();
    assert_eq!(map.cells.len(), 6);
    assert!((map.cells[0].x[1] - 0.1_f64.sqrt()).abs() < 1e-15);
    // Each round its own place, neighbours sharing their edges.
    for (cell, (case, (alpha, step, _))) in map.cells.iter().zip(run.metrics.iter().zip(&values)) {
        assert_eq!(Some(cell.value), case[0]);
        assert!(cell.x[0] < *alpha && *alpha < cell.x[1]);
        assert!(cell.y[0] < *step && *step < cell.y[1]);
    }
    assert_eq!(map.cells[0].x[1], map.cells[1].x[0]);
    assert_eq!(map.cells[0].y[0], map.cells[3].y[1]);
}

#[test]
fn laws_run_through_their_corners() {
    let sheet = fig5().sheet(FigureKind::Law(Law));
    let [panel] = sheet.panels.as_slice() else {
        panic!("one law, one panel");
    };
    let curve = &panel.series[3];
    assert_eq!(curve.label, "*α* = 5");
    assert_eq!(curve.points[..3], [[0.0, 0.0], [5.0, 1.0], [8.0, 1.0]]);
    // Unloading falls from 1 to -1 over twice the elastic width.
    assert!(curve.points.contains(&[8.0 - 10.0, -1.0]));
    assert!(curve.points.iter().all(|p| p[1].abs() <= 1.0));
}

#[test]
fn nothing_to_draw_is_drawn_all_the_same() {
    let run = run(&[]);
    let metric = |scale| {
        FigureKind::Metric(Metric {
            x: DT,
            y: vec![0, 1],
            by: None,
            x_scale: scale,
            y_scale: scale,
            panels: None,
            checks: false,
        })
    };
    let map = FigureKind::Map(Map {
        x: ALPHA,
        y: DT,
        z: 0,
        scales: [Scale::Log, Scale::Linear, Scale::Log],
        z_range: None,
        marks: None,
        ridge: None,
    });
    let profile = FigureKind::Profile(Profile {
        y: vec![],
        times: vec![],
    });
    for kind in [
        history(None),
        history(Some(X0)),
        metric(Scale::Linear),
        metric(Scale::Log),
        map,
        FigureKind::Law(Law),
        profile,
    ] {
        let sheet = run.sheet(kind);
        assert!(png(&sheet, style::DPI).is_ok() && svg(&sheet, style::DPI).is_ok());
    }
}

/// Red, green and blue of a sheet at a place.
pub(super) fn colour_at(sheet: &Sheet, point: [f64; 2]) -> [u8; 3] {
    let bytes = png(sheet, style::DPI).unwrap();
    let decoder = png::Decoder::new(std::io::Cursor::new(&bytes));
    let mut reader = decoder.read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!(info.color_type, png::ColorType::Rgb);
    let [x, y] = point.map(|at| (at * style::pixels(style::DPI)) as usize);
    let at = 3 * (y * info.width as usize + x);
    [pixels[at], pixels[at + 1], pixels[at + 2]]
}

/// A PNG's width, height, pixels in grey, and pixels a metre.
pub(super) fn decode(bytes: &[u8]) -> (usize, usize, Vec<u8>, u32) {
    let decoder = png::Decoder::new(std::io::Cursor::new(bytes));
    let mut reader = decoder.read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!(info.color_type, png::ColorType::Grayscale);
    let per_metre = reader.info().pixel_dims.unwrap().xppu;
    (info.width as usize, info.height as usize, pixels, per_metre)
}

#[test]
fn pixels_are_where_the_sheet_says() {
    let sheet = fig5().sheet(history(None));
    let bytes = png(&sheet, style::DPI).unwrap();
    assert_eq!(bytes, png(&sheet, style::DPI).unwrap());
    let (width, height, pixels, per_metre) = decode(&bytes);
    assert_eq!(
        width,
        (sheet.width * style::pixels(style::DPI)).round() as usize
    );
    assert_eq!(
        height,
        (sheet.height * style::pixels(style::DPI)).round() as usize
    );
    assert_eq!(per_metre, 7559);
    let darkest = |[x, y]: [f64; 2]| {
        let (x, y) = (
            (x * style::pixels(style::DPI)) as usize,
            (y * style::pixels(style::DPI)) as usize,
        );
        let near = (y - 1..=y + 1).flat_map(|y| (x - 1..=x + 1).map(move |x| (x, y)));
        near.map(|(x, y)| pixels[y * width + x]).min().unwrap()
    };
    let panel = &sheet.panels[0];
    let frame = &panel.frame;
    assert_eq!(darkest([frame.left, frame.top + 30.0]), 0);
    assert_eq!(darkest([frame.right(), frame.top + 30.0]), 0);
    assert_eq!(darkest([frame.left + 60.0, frame.bottom()]), 0);
    assert!(darkest(panel.place([5.0 * PI, -2.0])) < 100);
    // Between the curves, and in the margin, there is nothing.
    assert_eq!(darkest(panel.place([0.5 * PI, 10.0])), 255);
    assert_eq!(darkest([2.0, 2.0]), 255);
}

#[test]
fn a_peak_out_of_range_has_no_flat_top() {
    let mut sheet = fig5().sheet(history(None));
    let panel = &mut sheet.panels[0];
    panel.series.truncate(1);
    panel.y.range = [-4.0, 4.0];
    panel.y.ticks.clear();
    let top = panel.frame.top;
    let (frame, crossing) = (panel.frame, panel.place([2.0 * PI, 0.0])[0]);
    assert!(frame.contains([crossing, top]));
    let (width, _, pixels, _) = decode(&png(&sheet, style::DPI).unwrap());
    // Just below the frame over the peak at 2 pi, which lies outside, all is white but the tick.
    let y = ((top + style::MAJOR_TICK + 1.0) * style::pixels(style::DPI)) as usize;
    let x = (crossing * style::pixels(style::DPI)) as usize;
    assert!(
        pixels[y * width + x - 12..y * width + x + 12]
            .iter()
            .all(|p| *p == 255)
    );
}

#[test]
fn svg_is_whole_and_needs_no_font() {
    let run = fig5();
    let sheet = run.sheet(history(None));
    let text = svg(&sheet, style::DPI).unwrap();
    assert_eq!(text, svg(&sheet, style::DPI).unwrap());
    assert!(text.starts_with("<svg ") && text.ends_with("</svg>\n"));
    assert!(text.contains("<title>a test</title>"));
    assert!(text.contains("<desc>exact; α = 0.1; α = 1; α = 5</desc>"));
    assert!(!text.contains("NaN") && !text.contains("inf") && !text.contains("font"));
    for reference in text.split("href=\"#").skip(1) {
        let name = reference.split('"').next().unwrap();
        assert!(text.contains(&format!("<path id=\"{name}\"")), "{name}");
    }
}
