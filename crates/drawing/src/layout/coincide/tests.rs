//! Curves at known distances from one another.

use super::*;
use crate::draw::draw;
use crate::draw::raster::Raster;
use crate::layout::sheet::Rect;
use crate::layout::ticks;
use crate::style::{self, Look};
use crate::svg;
use std::cell::RefCell;
use std::rc::Rc;

/// A panel of 200 by 100 points whose axes are in points, with these curves.
fn panel(curves: Vec<Series>) -> Panel {
    let frame = Rect {
        width: 200.0,
        height: 100.0,
        ..Rect::default()
    };
    let axis = |end: f64| {
        let mut axis = ticks::linear("", [0.0, end], 5.0);
        axis.range = [0.0, end];
        axis.ticks.clear();
        axis
    };
    let mut panel = Panel::new(frame, 0.0, axis(200.0), axis(100.0));
    panel.series = curves;
    panel
}

fn sheet(panel: Panel) -> Sheet {
    let mut sheet = Sheet {
        width: 200.0,
        height: 100.0,
        panels: vec![panel],
        ..Sheet::default()
    };
    find(&mut sheet);
    sheet
}

/// Curve `i` of a look, without a marker.
fn curve(colour: bool, i: usize, of: impl Fn(f64) -> f64) -> Series {
    let look = Look {
        colour,
        markers: false,
    };
    let at = |k: u32| f64::from(k) / 10.0;
    Series {
        label: format!("curve {i}"),
        points: (0..=2000).map(|k| [at(k), of(at(k))]).collect(),
        stroke: look.stroke(i, 6),
        width: style::CASE_LINE,
        marker: None,
        marked: Vec::new(),
    }
}

/// A wave of 30 points over 80.
fn wave(x: f64) -> f64 {
    50.0 + 15.0 * libm::sin(x / 12.0)
}

/// Curve 0, and curve 1 by `off` above it.
fn pair(off: impl Fn(f64) -> f64) -> Sheet {
    let over = curve(true, 1, |x| wave(x) + off(x));
    sheet(panel(vec![curve(true, 0, wave), over]))
}

/// How many pixels of a sheet have each of the first colours of curves.
fn pixels(sheet: &Sheet, colours: u8) -> Vec<usize> {
    let blank = Raster::new(sheet.width, sheet.height, 600).unwrap();
    let raster = Rc::new(RefCell::new(blank));
    draw(sheet, &raster, 600).unwrap();
    let (_, rgb) = raster.borrow().rgb();
    let count = |colour: [u8; 3]| {
        rgb.chunks_exact(3)
            .filter(|pixel| **pixel == colour)
            .count()
    };
    (0..colours)
        .map(|i| count(Stroke::Colour(i).colour()))
        .collect()
}

#[test]
fn curves_that_coincide_have_equal_parts_of_the_line() {
    for count in [2, 3, 6] {
        let parts = |of: fn(f64) -> f64| {
            // Half as large again as the other panels, for 34 fields of 9 points.
            let mut large = panel((0..count).map(|i| curve(true, i, of)).collect());
            (large.frame.width, large.frame.height) = (300.0, 150.0);
            let mut sheet = sheet(large);
            (sheet.width, sheet.height) = (300.0, 150.0);
            assert!(sheet.panels[0].gaps.iter().all(|gap| gap.series > 0));
            assert_eq!(sheet.small_print[0].text, MEANING);
            pixels(&sheet, count as u8)
        };
        // 34 fields along a level line: of six curves each has five or six, less mixed pixels at the ends.
        let level = parts(|_| 50.0);
        let [least, most] = [level.iter().min(), level.iter().max()].map(|x| *x.unwrap() as f64);
        assert!(least > 0.75 * most, "{level:?}");
        // A wave crosses fields at their corners: parts are between half and twice as long as equal ones.
        let wave = parts(wave);
        let equal = wave.iter().sum::<usize>() as f64 / count as f64;
        let off = wave
            .iter()
            .map(|length_of_part| *length_of_part as f64 / equal);
        assert!(
            off.clone().all(|part| (0.5..2.0).contains(&part)),
            "{wave:?}"
        );
    }
}

#[test]
fn curves_that_are_told_apart_stay_unbroken() {
    let dashed = |sheet: &Sheet| usize::from(!sheet.panels[0].gaps.is_empty());
    // Half a line, and four.
    assert_eq!(dashed(&pair(|_| 0.5 * style::CASE_LINE)), 1);
    let apart = pair(|_| 4.0 * style::CASE_LINE);
    assert_eq!(dashed(&apart), 0);
    assert!(apart.small_print.is_empty() && meaning(&apart).is_none());
    // Curves that only cross: at a slope of 1 within a line for 2 to 3 points.
    assert_eq!(dashed(&pair(|x| 0.5 * (x - 100.0))), 0);
    // A wide line under a narrow one shows, and a rule is no curve.
    let mut wide = curve(true, 0, wave);
    wide.width = 5.0;
    let over = curve(true, 1, wave);
    assert_eq!(dashed(&sheet(panel(vec![wide, over.clone()]))), 0);
    let rule = Series::rule([[0.0, 50.0], [200.0, 50.0]]);
    let level = curve(true, 1, |_| 50.0);
    assert_eq!(dashed(&sheet(panel(vec![rule, level]))), 0);
    // A thin exact curve under a computed one does not.
    let exact = Series::exact(over.points.clone());
    assert_eq!(dashed(&sheet(panel(vec![exact, over]))), 1);
}

#[test]
fn only_the_stretch_in_which_curves_coincide_is_dashed() {
    // Level up to x = 100; from there one rises by 1 in 2, so that the two are a line apart 1 to 2 points later.
    let level = |_| 50.0;
    let rising = |x: f64| 50.0 + 0.5 * (x - 100.0).max(0.0);
    for curves in [
        vec![curve(true, 0, level), curve(true, 1, rising)],
        vec![curve(true, 0, rising), curve(true, 1, level)],
    ] {
        let sheet = sheet(panel(curves));
        let panel = &sheet.panels[0];
        // Some 5 of 11 fields of 9 points: those of the curve under it.
        let ends: Vec<[f64; 2]> = panel.gaps.iter().map(|gap| gap.ends).collect();
        assert!(panel.gaps.iter().all(|gap| gap.series == 1));
        assert!((5..=6).contains(&ends.len()), "{ends:?}");
        // A field ends in a cell of 0.45 points.
        let inside = &ends[1..ends.len() - 1];
        assert!(
            inside
                .iter()
                .all(|[from, to]| (to - from - 9.0).abs() < 0.5),
            "{ends:?}"
        );
        let apart = ends.windows(2).map(|pair| pair[1][0] - pair[0][0]);
        assert!(
            apart.map(|d| (d - 18.0).abs()).all(|off| off < 1.0),
            "{ends:?}"
        );
        assert!(ends[ends.len() - 1][1] < 103.0);
        let over = &panel.series[1];
        let places: Vec<[f64; 2]> = over.points.iter().map(|p| panel.place(*p)).collect();
        let drawn = dashes(panel, 1, std::slice::from_ref(&places));
        let length = |line: &[[f64; 2]]| -> f64 {
            line.windows(2).map(|pair| distance(pair[0], pair[1])).sum()
        };
        let drawn_length: f64 = drawn.iter().map(|line| length(line)).sum();
        let gaps: f64 = ends.iter().map(|[from, to]| to - from).sum();
        assert!((drawn_length + gaps - length(&places)).abs() < 1e-6);
    }
}

#[test]
fn parts_of_lines_go_on_from_line_to_line() {
    let lines = [
        vec![[0.0, 0.0], [3.0, 0.0], [3.0, 4.0]],
        vec![[9.0, 0.0], [14.0, 0.0]],
    ];
    // 7 and 5 long: from 2 to 5 round the corner, from 6 over the end to 8, and the end from 11.
    let found = clip::between(&lines, &[[2.0, 5.0], [6.0, 8.0], [11.0, f64::INFINITY]]);
    let expected = [
        vec![[2.0, 0.0], [3.0, 0.0], [3.0, 2.0]],
        vec![[3.0, 3.0], [3.0, 4.0]],
        vec![[9.0, 0.0], [10.0, 0.0]],
        vec![[13.0, 0.0], [14.0, 0.0]],
    ];
    assert_eq!(found, expected);
}

#[test]
fn black_curves_that_coincide_have_markers_in_turn() {
    let curves: Vec<Series> = (0..2).map(|i| curve(false, i, wave)).collect();
    let drawn = sheet(panel(curves.clone()));
    let [a, b] = &drawn.panels[0].series[..] else {
        panic!("two curves");
    };
    assert_eq!(
        [a.marker, b.marker],
        [0, 1].map(|i| Some(Marker::of_case(i)))
    );
    // Each half-way between two of the other: the path is 230 points long at most, with a marker each 60.
    assert!(a.marked.len() >= 3 && b.marked.len() >= 3);
    assert!(
        a.marked
            .iter()
            .zip(&b.marked)
            .all(|(a, b)| b - a > 150 && b - a < 310)
    );
    assert!(drawn.panels[0].gaps.is_empty() && drawn.small_print.is_empty());
    // Those that have markers keep them.
    let mut marked = curves;
    for (i, series) in marked.iter_mut().enumerate() {
        (series.marker, series.marked) = (Some(Marker::Square), vec![100 * i]);
    }
    assert_eq!(sheet(panel(marked.clone())).panels[0].series, marked);
}

#[test]
fn a_dense_curve_is_drawn_under_the_others() {
    let dense = |swing: f64| move |x: f64| 50.0 + swing * libm::sin(5.0 * x);
    let curves = vec![
        curve(true, 0, wave),
        curve(true, 1, dense(20.0)),
        curve(true, 2, dense(40.0)),
    ];
    let sheet = sheet(panel(curves));
    assert_eq!(order(&sheet.panels[0]), [2, 1, 0]);
    let drawn = svg(&sheet, style::DPI).unwrap();
    let at = |i: u8| {
        let [r, g, b] = Stroke::Colour(i).colour();
        drawn
            .find(&format!("stroke=\"#{r:02x}{g:02x}{b:02x}\""))
            .unwrap()
    };
    assert!(at(2) < at(1) && at(1) < at(0));
    // Others keep the order of the legend.
    let plain = panel((0..3).map(|i| curve(true, i, wave)).collect());
    assert_eq!(order(&plain), [0, 1, 2]);
}

#[test]
fn a_line_among_an_oscillation_does_not_coincide_with_it() {
    let dense = |x: f64| 40.0 * libm::sin(5.0 * x);
    let half = move |x: f64| 50.0 + if x < 100.0 { dense(x) } else { 0.0 };
    let level = |_| 50.0;
    let drawn = sheet(panel(vec![curve(true, 0, level), curve(true, 1, half)]));
    let panel_of = &drawn.panels[0];
    assert_eq!(order(panel_of), [1, 0]);
    // Only after the oscillation, and half a square of 5.4 points later, the two are one line.
    let gaps = &panel_of.gaps;
    assert!(gaps.len() >= 4 && gaps.iter().all(|gap| gap.series == 0));
    assert!(gaps[0].ends[0] > 99.0, "{:?}", gaps[0]);
    // A loop that is run many times is long and not dense.
    let mut again = curve(true, 0, wave);
    let there = again.points.clone();
    for round in 1..20 {
        let mut next = there.clone();
        if round % 2 == 1 {
            next.reverse();
        }
        again.points.extend(next);
    }
    assert_eq!(order(&panel(vec![curve(true, 1, level), again])), [0, 1]);
}

#[test]
fn a_point_alone_is_a_dot() {
    let mut series = curve(true, 0, wave);
    series.points = vec![[50.0, 50.0], [f64::NAN; 2], [100.0, 50.0], [150.0, 50.0]];
    let drawn = svg(&sheet(panel(vec![series.clone()])), style::DPI).unwrap();
    assert_eq!(drawn.matches("<circle").count(), 1);
    series.points.remove(0);
    let drawn = svg(&sheet(panel(vec![series])), style::DPI).unwrap();
    assert_eq!(drawn.matches("<circle").count(), 0);
}

#[test]
fn spikes_and_crossings_are_not_dashed() {
    // Two spikes of 90 points over 6 to 9: both flanks of the one coincide nearly everywhere with those of the other, and are
    // steeper than 80 degrees (90 / 3 is 88 degrees). The level parts beside them are one line.
    let spike = |top: f64| move |x: f64| 5.0 + top * (1.0 - (x - 100.0).abs() / 3.0).max(0.0);
    let drawn = sheet(panel(vec![
        curve(true, 0, spike(90.0)),
        curve(true, 1, spike(88.0)),
    ]));
    let spikes = &drawn.panels[0];
    assert!(!spikes.gaps.is_empty());
    // Arc of curve 1: 97 points, and two flanks of 88.
    let flank = 97.0..97.0 + 2.0 * 88.0;
    let on_flank = |x: &f64| flank.contains(x);
    assert!(
        spikes.gaps.iter().all(|gap| !gap.ends.iter().any(on_flank)),
        "{:?}",
        spikes.gaps
    );
    // Two waves of one height and other periods cross at their flanks, within 30 points of arc.
    let waves = |period: f64| move |x: f64| 50.0 + 40.0 * libm::sin(x * period);
    let crossing = sheet(panel(vec![
        curve(true, 0, waves(0.20)),
        curve(true, 1, waves(0.23)),
    ]));
    assert!(crossing.panels[0].gaps.iter().all(|gap| {
        // Only from the common start.
        gap.ends[1] < 40.0
    }));
    // A rise of 79 degrees still has dashes, one of 81 none.
    let rising = |degrees: f64| {
        let slope = libm::tan(degrees.to_radians());
        let line = move |x: f64| 5.0 + slope * (x - 90.0).clamp(0.0, 90.0 / slope);
        let mut pair = [curve(true, 0, line), curve(true, 1, line)].to_vec();
        for series in &mut pair {
            series
                .points
                .retain(|[x, _]| (90.0..=90.0 + 90.0 / slope).contains(x));
        }
        sheet(panel(pair)).panels[0].gaps.len()
    };
    assert!(rising(79.0) > 2);
    assert_eq!(rising(81.0), 0);
}

#[test]
fn only_dashes_longer_than_3_mm_have_a_note() {
    let mut short = sheet(panel(vec![curve(true, 0, wave)]));
    // 3 mm are 8.504 points.
    for (length, noted) in [(8.4, None), (8.6, Some(MEANING))] {
        let gap = Gap {
            series: 0,
            ends: [20.0, 20.0 + length],
        };
        short.panels[0].gaps = vec![gap];
        assert_eq!(meaning(&short), noted);
    }
}
