//! Widths and limits that a study gives: what the sheets have, and that nothing leaves its place.

use super::{colour_at, decode, fig5, run};
use crate::{png, style};
use slipgap_drawing::layout::below;
use slipgap_drawing::layout::sheet::{Rect, Sheet};
use slipgap_drawing::text;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_study::error::Error;
use slipgap_study::kinds::{History, Law, Map, Metric};
use slipgap_study::{FigureKind, Scale};
use std::f64::consts::PI;

fn history(y: Vec<usize>, panels: Option<usize>) -> FigureKind {
    FigureKind::History(History {
        y,
        by: None,
        panels,
        in_units: false,
        stacked: false,
        inset: None,
    })
}

#[test]
fn curves_end_at_the_limits_given() {
    let (x, y) = ([2.0 * PI, 5.0 * PI], [-3.0, 5.0]);
    let mut sheet = fig5().limited(history(vec![0], None), None, [Some(x), Some(y)]);
    sheet.legend.clear();
    let panel = &mut sheet.panels[0];
    assert_eq!([panel.x.range, panel.y.range], [x, y]);
    for (axis, [low, high]) in [(&panel.x, x), (&panel.y, y)] {
        let inside = |at: f64| at >= low - 1e-12 && at <= high + 1e-12;
        assert!(axis.ticks.iter().all(|tick| inside(tick.at)), "{axis:?}");
    }
    // Every curve has markers where it is shown.
    for series in &panel.series[1..] {
        let shown = |i: &&usize| (x[0]..=x[1]).contains(&series.points[**i][0]);
        assert!(series.marked.iter().filter(shown).count() >= 5);
    }
    panel.series.truncate(1);
    let panel = &sheet.panels[0];
    let (width, _, pixels, _) = decode(&png(&sheet, style::DPI).unwrap());
    let dots = style::pixels(style::DPI);
    let darkest = |[x, y]: [f64; 2]| {
        let (x, y) = ((x * dots) as usize, (y * dots) as usize);
        let near = (y - 1..=y + 1).flat_map(|y| (x - 1..=x + 1).map(move |x| (x, y)));
        near.map(|(x, y)| pixels[y * width + x]).min().unwrap()
    };
    // Free motion from 12 loses 2 each half cycle: 8 at 2 pi, -6 at 3 pi, 4 at 4 pi. The first two are outside.
    assert!(darkest(panel.place([4.0 * PI, 4.0])) < 100);
    let frame = panel.frame;
    let (left, right) = (frame.left as usize + 1, frame.right() as usize);
    for x in left..right {
        for y in [frame.top - 3.0, frame.bottom() + 2.0] {
            assert_eq!(darkest([x as f64, y]), 255, "{x} {y}");
        }
    }
    for y in frame.top as usize + 1..frame.bottom() as usize {
        assert_eq!(darkest([frame.right() + 2.0, y as f64]), 255, "{y}");
    }
}

#[test]
fn the_other_axis_goes_round_what_is_left() {
    let sheet = fig5().limited(
        history(vec![0], None),
        None,
        [Some([6.0 * PI, 8.0 * PI]), None],
    );
    // alpha = 5 still swings between -6.2 and 6.6 then, and all of it began at 12.
    let [low, high] = sheet.panels[0].y.range;
    assert!(
        low < -5.0 && low > -9.0 && high > 5.0 && high < 9.0,
        "{low} {high}"
    );
}

/// Frames lie apart, with what is written under each, and all of them and their words on the sheet.
#[track_caller]
fn fits(sheet: &Sheet, width: f64) {
    assert_eq!(sheet.width, width);
    let with_axis = |k: usize| {
        let panel = &sheet.panels[k];
        Rect {
            height: panel.frame.height + below(&panel.x),
            ..panel.frame
        }
    };
    for k in 0..sheet.panels.len() {
        let frame = sheet.panels[k].frame;
        assert!(frame.width >= 60.0, "{frame:?}");
        assert!(frame.left >= 0.0 && frame.right() <= width && frame.bottom() <= sheet.height);
        for other in 0..k {
            assert!(!with_axis(k).overlaps(&with_axis(other)), "{k} {other}");
        }
    }
    for words in &sheet.heading {
        assert!(text::width(&words.text, words.size) <= width);
    }
    assert!(sheet.heading.len() > 1 || width > 300.0);
    for entry in &sheet.legend {
        let start = entry.at[0] + style::SAMPLE + style::SAMPLE_GAP;
        assert!(
            start + text::width(&entry.label, style::LABEL) <= width,
            "{entry:?}"
        );
    }
}

#[test]
fn panels_keep_their_places_at_every_width() {
    let run = run(&[0.1, 1.0, 5.0].map(|alpha| (alpha, PI / 10.0, 12.0)));
    let kinds = || {
        [
            history(vec![0, 3], None),
            history(vec![0, 3], Some(1)),
            FigureKind::Metric(Metric {
                x: 1,
                y: vec![0, 1],
                by: None,
                x_scale: Scale::Log,
                y_scale: Scale::Linear,
                panels: None,
                checks: false,
            }),
            FigureKind::Map(Map {
                x: 1,
                y: 3,
                z: 0,
                scales: [Scale::Linear; 3],
                z_range: None,
                marks: None,
                ridge: None,
            }),
        ]
    };
    // One case of the other model: alpha does not apply, beta does.
    let mut laws = fig5();
    laws.cases[2].values[1] = None;
    laws.cases[2].values[2] = Some(Value::Number(1.0));
    for mm in [70.0, 90.0, 140.0, 190.0, 400.0] {
        let width = mm * 72.0 / 25.4;
        for kind in kinds() {
            fits(&run.limited(kind, Some(width), [None; 2]), width);
        }
        let sheet = laws.limited(FigureKind::Law(Law), Some(width), [None; 2]);
        assert_eq!(sheet.panels.len(), 2);
        fits(&sheet, width);
    }
}

/// A map of errors of alpha and dT, three by three or two by two, with these values; NaN is an empty one.
fn map_of(values: &[f64], z_range: Option<[f64; 2]>) -> Sheet {
    let alphas = [0.1, 1.0, 10.0];
    let steps = [PI / 20.0, PI / 10.0, PI / 5.0];
    let side = if values.len() == 9 { 3 } else { 2 };
    let places = (0..values.len()).map(|k| (alphas[k / side], steps[k % side], 12.0));
    let mut run = run(&places.collect::<Vec<_>>());
    for (metrics, value) in run.metrics.iter_mut().zip(values) {
        metrics[0] = Some(*value).filter(|value| !value.is_nan());
    }
    let map = Map {
        x: 1,
        y: 3,
        z: 0,
        scales: [Scale::Log; 3],
        z_range,
        marks: None,
        ridge: None,
    };
    run.limited(FigureKind::Map(map), None, [None; 2])
}

#[test]
fn maps_of_one_range_share_shades_and_contours() {
    let range = Some([0.01, 1.0]);
    let narrow = map_of(&[0.02, 0.03, 0.04, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5], range);
    let mut far = [1e-5; 9];
    far[4] = 1e3;
    let wide = map_of(&far, range);
    let deep = map_of(&far.map(|z| 0.01 / z), range);
    let [map, other] = [&narrow, &wide].map(|sheet| sheet.panels[0].map.as_ref().unwrap());
    assert_eq!((&map.levels, &map.colours), (&other.levels, &other.colours));
    assert_eq!(map.colours.range, [0.01, 1.0]);
    assert!(map.levels.len() > 2);
    // Without the key each has its own.
    let free = map_of(&far, None);
    assert_eq!(
        free.panels[0].map.as_ref().unwrap().colours.range,
        [1e-5, 1e3]
    );
    // Values outside have the band of the end, as the colour of their place shows.
    let count = map.levels.len() + 1;
    let middle = wide.panels[0].place([1.0, PI / 10.0]);
    let band = |k| style::colour(style::band(k, count));
    let beside = [middle[0] + 2.5, middle[1]];
    assert_eq!(colour_at(&wide, beside), band(count - 1));
    assert_eq!(colour_at(&deep, beside), band(0));
    // The case itself is a dot.
    assert_eq!(colour_at(&wide, middle), style::colour(0.0));
    let places: Vec<[f64; 2]> = wide.panels[0]
        .cloud
        .iter()
        .flat_map(|c| &c.dots)
        .map(|d| d.at)
        .collect();
    assert_eq!(places.len(), 9);
    assert!(places.contains(&[1.0, PI / 10.0]));
    let printed = |sheet: &Sheet| -> Vec<String> {
        sheet
            .small_print
            .iter()
            .filter(|words| !words.text.starts_with("Dots"))
            .map(|words| words.text.clone())
            .collect()
    };
    assert_eq!(printed(&narrow), [""; 0]);
    assert_eq!(
        printed(&wide),
        ["Of 9 values, 8 below 0.01 and 1 above 1 lie outside of the range of colours."]
    );
    // Cells have the same limits. Shades are 128, each of the colour of its middle.
    let cells = map_of(&[1e-5, 0.1, 0.2, 1e3], range);
    let shade = |k: f64| style::colour((k + 0.5) / 128.0);
    let panel = &cells.panels[0];
    assert_eq!(panel.map.as_ref().unwrap().colours.range, [0.01, 1.0]);
    assert_eq!(colour_at(&cells, panel.place([0.1, PI / 20.0])), shade(0.0));
    assert_eq!(
        colour_at(&cells, panel.place([1.0, PI / 10.0])),
        shade(127.0)
    );
}

#[test]
fn empty_values_of_a_map_are_hatched_and_the_legend_says_so() {
    let none = f64::NAN;
    let [alphas, steps] = [[0.1, 1.0, 10.0], [PI / 20.0, PI / 10.0, PI / 5.0]];
    // The places of the last alpha: their squares, one over the other, are one rectangle.
    let contours = map_of(&[0.1, 0.2, 0.3, 0.2, 0.3, 0.4, none, none, none], None);
    let map = contours.panels[0].map.as_ref().unwrap();
    let [from, to] = [[alphas[1], steps[0]], [alphas[2], steps[2]]];
    assert_eq!(map.hatched, [[from, to]]);
    let cells = map_of(&[0.1, none, 0.3, 0.4], None);
    let map = cells.panels[0].map.as_ref().unwrap();
    let [[from, to]] = map.hatched[..] else {
        panic!("{:?}", map.hatched);
    };
    assert!(from[0] < alphas[0] && to[0] < alphas[1] && from[1] < steps[1] && steps[1] < to[1]);
    let without = map_of(&[0.1, 0.2, 0.3, 0.4], None);
    assert!(without.panels[0].map.as_ref().unwrap().hatched.is_empty());
    let labels = |sheet: &Sheet| -> Vec<String> {
        let entries = sheet.legend.iter();
        entries.map(|entry| entry.label.clone()).collect()
    };
    assert_eq!(labels(&contours), ["no value"]);
    assert_eq!(labels(&cells), ["no value"]);
    assert_eq!(labels(&without), [""; 0]);
    // Without any value all of it is hatched: dark lines over white.
    let empty = map_of(&[none; 9], None);
    assert_eq!(empty.panels[0].map.as_ref().unwrap().hatched.len(), 2);
    let frame = &empty.panels[0].frame;
    let y = frame.top + frame.height / 2.0;
    // One line crosses each distance between two lines.
    let places = (0..12).map(|k| frame.left + 50.0 + style::HATCH / 12.0 * f64::from(k));
    let greys: Vec<u8> = places.map(|x| colour_at(&empty, [x, y])[0]).collect();
    let dark = greys.iter().filter(|grey| **grey < 160).count();
    assert!((1..6).contains(&dark), "{greys:?}");
}

#[test]
fn a_long_label_takes_several_lines() {
    let words = "*α* = 0.1, *x*_0_ = 12 and a word in *two italic words* at the end";
    let lines = text::wrap(words, style::LABEL, 100.0);
    assert!(lines.len() > 1, "{lines:?}");
    assert_eq!(lines.join(" "), words);
    assert!(lines.iter().any(|line| line.contains("*two italic words*")));
}

#[test]
fn a_picture_too_large_for_memory_is_refused() {
    // 400 mm by 2 m, at 1200 pixels an inch 1.8 gigapixels.
    let sheet = Sheet {
        width: 1134.0,
        height: 5670.0,
        ..Sheet::default()
    };
    let Err(Error::Usage(message)) = png(&sheet, 1200) else {
        panic!("a picture of 1.8 gigapixels");
    };
    assert!(
        message.starts_with("a figure of 18900 x 94500 pixels;"),
        "{message}"
    );
}
