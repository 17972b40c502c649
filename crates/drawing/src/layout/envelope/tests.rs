//! Bands of curves whose periods and envelopes are known.

use super::*;
use crate::layout::clip;
use crate::layout::sheet::{Rect, Series};
use crate::layout::ticks;
use crate::style::{self, Stroke};
use crate::svg;
use std::f64::consts::PI;

/// Width of the frame of the tests, in points; x is in points from its left edge.
const WIDTH: f64 = 400.0;

/// Pixels an inch: few, so that few points make a dense curve.
const DPI: u32 = 20;

/// The shortest period, a pixel: with two turns in each period, shorter ones have more than two in a pixel.
const SHORTEST: f64 = 3.6;

/// Points of a curve: 180 or more a period of the shortest.
const POINTS: usize = 20_000;

/// A panel with one curve; one unit of y is 10 points.
fn panel(of: impl Fn(f64) -> f64) -> Panel {
    sampled(POINTS, of)
}

/// The same with a curve of so many points.
fn sampled(count: usize, of: impl Fn(f64) -> f64) -> Panel {
    let frame = Rect {
        width: WIDTH,
        height: 100.0,
        ..Rect::default()
    };
    let mut axes = [
        ticks::linear("", [0.0, WIDTH], 5.0),
        ticks::linear("", [-5.0, 5.0], 5.0),
    ];
    (axes[0].range, axes[1].range) = ([0.0, WIDTH], [-5.0, 5.0]);
    let [x, y] = axes;
    let mut panel = Panel::new(frame, 0.0, x, y);
    let at = |i: usize| WIDTH * i as f64 / count as f64;
    panel.series = vec![Series {
        label: "a curve".into(),
        points: (0..=count).map(|i| [at(i), of(at(i))]).collect(),
        stroke: Stroke::Dashed,
        width: style::CASE_LINE,
        marker: None,
        marked: Vec::new(),
    }];
    panel.envelopes = super::of(&panel, SHORTEST);
    panel
}

/// The height of an edge at a place, straight between its points.
fn height(panel: &Panel, edge: &[usize], x: f64) -> f64 {
    let points = &panel.series[0].points;
    let next = edge.partition_point(|i| points[*i][0] < x).max(1);
    let [a, b] = [points[edge[next - 1]], points[edge[next]]];
    a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0])
}

/// Sines whose local period falls evenly from 12 points at the left edge to 2 at the right one.
const FALL: f64 = 10.0 / WIDTH;

fn period(x: f64) -> f64 {
    12.0 - FALL * x
}

fn chirp(x: f64) -> f64 {
    // The phase is the integral of 2 pi / period.
    libm::sin(-2.0 * PI / FALL * libm::log(period(x) / 12.0))
}

#[test]
fn the_band_of_a_chirp_begins_where_its_period_gets_too_short() {
    let panel = panel(chirp);
    let [band] = panel.envelopes.as_slice() else {
        panic!("{} bands", panel.envelopes.len());
    };
    let points = &panel.series[0].points;
    let [first, last] = [band.upper[0], *band.upper.last().unwrap()];
    assert_eq!([first, last], [band.lower[0], *band.lower.last().unwrap()]);
    // A period from x takes period(x) (1 - exp(-FALL)) / FALL. The band begins where that is 1.1 of the shortest: further
    // along it is less.
    let least_period = 1.1 * SHORTEST * FALL / (1.0 - libm::exp(-FALL));
    let begin = (12.0 - least_period) / FALL;
    // The band begins at the first turn after that place, and ends at the last turn. A period between samples is 0.02
    // points off at most, which moves the place by 0.02 / FALL.
    let (half, off) = (period(begin) / 2.0, 0.02 / FALL);
    let found = points[first][0];
    assert!(
        (begin - off..begin + half + off).contains(&found),
        "{found}"
    );
    assert!((WIDTH - 1.0..WIDTH).contains(&points[last][0]));
    for i in [first, last] {
        // A sample of 0.02 points at most from a peak whose period is 2 points or more.
        assert!(
            points[i][1].abs() > libm::cos(0.02 * PI),
            "{}",
            points[i][1]
        );
    }
}

#[test]
fn a_band_contains_every_point_and_touches_every_peak() {
    // The envelope rises evenly: peaks under a straight line.
    let envelope = |x: f64| 1.0 + 2.0 * x / WIDTH;
    let panel = panel(|x| envelope(x) * chirp(x));
    let [band] = panel.envelopes.as_slice() else {
        panic!("{} bands", panel.envelopes.len());
    };
    let points = &panel.series[0].points;
    let [first, last] = [band.upper[0], *band.upper.last().unwrap()];
    for [x, y] in &points[first..=last] {
        let [low, high] = [&band.lower, &band.upper].map(|edge| height(&panel, edge, *x));
        assert!(low <= y + 1e-12 && *y <= high + 1e-12, "{low} {y} {high}");
    }
    let extreme = |pick: fn(f64, f64) -> f64, edge: &[usize]| {
        let extreme = points[first..=last].iter().map(|p| p[1]).reduce(pick);
        let touched = edge.iter().map(|i| points[*i][1]).reduce(pick);
        (extreme, touched)
    };
    let ((top, upper), (bottom, lower)) = (
        extreme(f64::max, &band.upper),
        extreme(f64::min, &band.lower),
    );
    assert_eq!((top, bottom), (upper, lower));
    // Away from the ends the edges are the envelope. Samples are 0.02 points from a peak, so that its loss is
    // 1 - cos(0.02 pi); between peaks of one column and the next the line is straight.
    for x in [345.0, 365.0, 385.0] {
        let [low, high] = [&band.lower, &band.upper].map(|edge| height(&panel, edge, x));
        assert!((high / envelope(x) - 1.0).abs() < 2.5e-3, "{high}");
        assert!((low / envelope(x) + 1.0).abs() < 2.5e-3, "{low}");
    }
}

#[test]
fn a_curve_that_can_be_drawn_has_no_band() {
    let sine =
        |period: f64, swing: f64| move |x: f64| swing / 20.0 * libm::sin(2.0 * PI * x / period);
    // Just under and over two turns in a pixel; just under and over the least swing, 2 lines of 0.9 points.
    assert!(panel(sine(3.65, 40.0)).envelopes.is_empty());
    assert_eq!(panel(sine(3.55, 40.0)).envelopes.len(), 1);
    // With as many pixels as figures have, 0.375 points each, the same curve is drawn.
    assert!(super::of(&panel(sine(3.55, 40.0)), 1.0 / style::pixels(style::DPI)).is_empty());
    assert!(panel(sine(1.0, 1.75)).envelopes.is_empty());
    assert_eq!(panel(sine(1.0, 1.85)).envelopes.len(), 1);
    // Three dense periods are a few strokes; a slow swing between dense ones is drawn.
    let within = |x: f64, from: f64, to: f64| (from..to).contains(&x);
    let dense = sine(2.0, 40.0);
    assert!(
        panel(|x| if within(x, 100.0, 106.0) {
            dense(x)
        } else {
            0.0
        })
        .envelopes
        .is_empty()
    );
    let slow = panel(|x| match within(x, 100.0, 200.0) {
        true => 2.0 * libm::cos(2.0 * PI * x / 100.0),
        false => dense(x),
    });
    let ends: Vec<[f64; 2]> = slow
        .envelopes
        .iter()
        .map(|band| [band.upper[0], *band.upper.last().unwrap()])
        .map(|ends| ends.map(|i| slow.series[0].points[i][0]))
        .collect();
    assert_eq!(ends.len(), 2);
    assert!(ends.iter().all(|[from, to]| *to < 101.0 || *from > 199.0));
}

#[test]
fn a_jump_after_an_oscillation_is_drawn() {
    // A jump of 4.5 after swings of 2, then a shoulder, all as narrow as the periods before.
    let corners = [
        [200.0, 0.0],
        [201.0, 3.5],
        [202.0, 2.0],
        [203.0, 2.3],
        [400.0, -3.0],
    ];
    let straight = |x: f64| {
        let next = corners.partition_point(|corner| corner[0] < x).max(1);
        let [a, b] = [corners[next - 1], corners[next]];
        a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0])
    };
    let panel = panel(|x| {
        if x < 200.0 {
            libm::sin(PI * x)
        } else {
            straight(x)
        }
    });
    let [band] = panel.envelopes.as_slice() else {
        panic!("{} bands", panel.envelopes.len());
    };
    // The last turn before the jump.
    let last = panel.series[0].points[*band.upper.last().unwrap()];
    assert!((last[0] - 199.5).abs() < 0.02 && (last[1] + 1.0).abs() < 1e-12);
}

#[test]
fn a_band_does_not_come_and_go_with_the_samples_of_a_curve() {
    // Samples 0.5 points apart: five periods of 3.59 points are 17.5 to 18.5 points long, and the limit is 18.
    let panel = sampled(800, |x| 2.0 * libm::sin(2.0 * PI * x / 3.59));
    let [band] = panel.envelopes.as_slice() else {
        panic!("{} bands", panel.envelopes.len());
    };
    let points = &panel.series[0].points;
    let ends = [band.upper[0], *band.upper.last().unwrap()].map(|i| points[i][0]);
    // A period of 3.5 or 4 points ends it; one of 4 is longer than 1.1 of the shortest.
    let near = 3.0 * 3.59;
    assert!(ends[0] < near && ends[1] > WIDTH - near, "{ends:?}");
}

#[test]
fn a_gap_ends_a_band_and_a_curve_without_order_has_none() {
    let dense = |x: f64| 2.0 * libm::sin(PI * x);
    let gap = panel(|x| {
        if (200.0..201.0).contains(&x) {
            f64::NAN
        } else {
            dense(x)
        }
    });
    assert_eq!(gap.envelopes.len(), 2);
    let mut back = panel(dense);
    back.series[0].points.reverse();
    assert!(super::of(&back, SHORTEST).is_empty());
}

#[test]
fn only_the_dense_part_of_a_curve_is_replaced() {
    let panel = panel(chirp);
    let band = &panel.envelopes[0];
    let [first, last] = [band.upper[0], *band.upper.last().unwrap()];
    let places: Vec<[f64; 2]> = panel.series[0].points.clone();
    let parts = drawn(&panel.envelopes, 0, &places);
    assert_eq!(parts, [places[..=first].to_vec(), places[last..].to_vec()]);
    assert_eq!(drawn(&[], 0, &places), std::slice::from_ref(&places));
    assert_eq!(drawn(&panel.envelopes, 1, &places), [places]);
    let mut sheet = Sheet {
        width: WIDTH,
        height: 100.0,
        panels: vec![panel],
        ..Sheet::default()
    };
    find(&mut sheet, DPI);
    let lines: Vec<&str> = sheet
        .small_print
        .iter()
        .map(|line| line.text.as_str())
        .collect();
    assert_eq!(lines.join(" "), MEANING);
    // Hatched as dashed curves are, without a fill; in colour one area in a light shade of it.
    let filled = |sheet: &Sheet, [r, g, b]: [u8; 3]| {
        let colour = format!("fill=\"#{r:02x}{g:02x}{b:02x}\"");
        svg(sheet, style::DPI).unwrap().matches(&colour).count()
    };
    assert_eq!(filled(&sheet, Stroke::Dashed.fill().0), 0);
    let width = format!("stroke-width=\"{}\"", style::units(style::HATCH_LINE));
    assert!(svg(&sheet, style::DPI).unwrap().contains(&width));
    let blue = Stroke::Colour(0);
    sheet.panels[0].series[0].stroke = blue;
    sheet.small_print.clear();
    find(&mut sheet, DPI);
    let lines: Vec<&str> = sheet
        .small_print
        .iter()
        .map(|line| line.text.as_str())
        .collect();
    assert_eq!(lines.join(" "), IN_COLOUR);
    assert_eq!(filled(&sheet, blue.fill().0), 1);
    assert!(svg(&sheet, style::DPI).unwrap().contains("fill-opacity"));
    assert!(!svg(&sheet, style::DPI).unwrap().contains(&width));
    // What was measured has noise, not a band.
    let points = sheet.panels[0].series[0].points.clone();
    sheet.panels[0].series[0] = Series::measured(points);
    sheet.small_print.clear();
    find(&mut sheet, DPI);
    assert!(sheet.panels[0].envelopes.is_empty() && sheet.small_print.is_empty());
}

#[test]
fn a_band_ends_at_the_frame() {
    let frame = Rect {
        left: 0.0,
        top: 0.0,
        width: 10.0,
        height: 10.0,
    };
    // A triangle that a corner of the frame cuts: by hand.
    let mut cut = clip::polygon(&[[5.0, 5.0], [15.0, 5.0], [5.0, 15.0]], &frame);
    cut.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    cut.dedup();
    assert_eq!(cut, [[5.0, 5.0], [5.0, 10.0], [10.0, 5.0], [10.0, 10.0]]);
    assert!(clip::polygon(&[[20.0, 1.0], [30.0, 1.0], [20.0, 9.0]], &frame).is_empty());
}
