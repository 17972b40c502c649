//! The friction laws as [F] Fig. 3 draws them, over the rigid law of [F] Fig. 2: force over slip and over velocity.

use super::Shown;
use super::guides;
use super::label;
use super::layout;
use super::legend::Key;
use super::sheet::{Anchor, Axis, Panel, Series, Sheet, Words};
use super::style::{self, Marker, Stroke};
use super::ticks;
use crate::study::{Figure, Study};

const HEIGHT: f64 = 150.0;

/// The sheet of a `law` figure: a panel for each of the two models that the cases have.
pub fn sheet(study: &Study, figure: &Figure, cases: &[Shown]) -> Sheet {
    let widths = |name: &str| -> Vec<(f64, String)> {
        let table = study.problem.parameters();
        let Some(row) = table.iter().position(|p| p.name == name) else {
            return Vec::new();
        };
        let values = label::values(cases, row).into_iter().flatten();
        let mut widths: Vec<_> = values
            .filter_map(|value| {
                Some((
                    value.as_f64()?,
                    label::said(&table[row], value, label::digits(cases, row)),
                ))
            })
            .collect();
        widths.sort_by(|a, b| a.0.total_cmp(&b.0));
        widths
    };
    let models = [
        (
            widths("alpha"),
            displacement as fn(f64, f64) -> Curve,
            "*r*/Δ",
        ),
        (
            widths("beta"),
            velocity as fn(f64, f64) -> Curve,
            "*ṙ*/(*ω*_n_Δ)",
        ),
    ];
    let models: Vec<_> = models.into_iter().filter(|m| !m.0.is_empty()).collect();
    let columns = layout::side_by_side(models.len().max(1), figure.width);
    let width = figure.width.unwrap_or(match columns > 1 {
        true => style::DOUBLE,
        false => style::SINGLE,
    });
    let force = Axis {
        range: [-1.65, 1.65],
        ..ticks::linear("*S*/*νN*", [-1.0, 1.0], 2.0)
    };
    let grid = layout::grid(
        width,
        columns,
        &vec![HEIGHT; models.len().max(1).div_ceil(columns)],
        std::slice::from_ref(&force),
        4.0,
    );
    let mut sheet = Sheet {
        width,
        ..Sheet::default()
    };
    let mut keys = Vec::new();
    for (k, (widths, model, title)) in models.into_iter().enumerate() {
        let widest = widths.iter().fold(0.0, |a: f64, b| a.max(b.0));
        let reach = 1.6 * widest;
        let most = grid.width / 32.0;
        let x = ticks::linear(title, [-1.2 * reach, 1.2 * reach], most);
        let mut y = force.clone();
        if k % columns > 0 {
            y.title.clear();
            y.numbered = false;
        }
        let mut frame = grid.frames[k / columns][k % columns];
        // Each row has its own horizontal axis.
        frame.top += (k / columns) as f64 * layout::below(&x).ceil();
        let mut panel = Panel::new(frame, grid.margin, x, y);
        panel.zero = true;
        panel.series.push(Series {
            label: "rigid (Coulomb)".into(),
            points: model(0.0, reach).0,
            stroke: Stroke::Solid,
            width: style::EXACT_LINE,
            marker: None,
            marked: Vec::new(),
        });
        for (look, (width, label)) in widths.into_iter().enumerate() {
            let (points, marked) = model(width, reach);
            panel.series.push(Series {
                label,
                points,
                stroke: Stroke::of_case(look),
                width: style::CASE_LINE,
                marker: Some(Marker::of_case(look)),
                marked,
            });
        }
        let curves = panel.series.iter().map(Key::of);
        keys.push(
            curves
                .chain(guides::key(std::slice::from_ref(&panel), None))
                .collect::<Vec<Key>>(),
        );
        if title.starts_with("*r*") {
            dimension(&mut panel, widest, [1.0, 1.25], "*r*^E^/Δ = *α*");
            dimension(&mut panel, reach - widest, [0.0, -1.25], "*r*^S^/Δ");
        } else {
            dimension(&mut panel, widest, [1.0, 1.25], "*ṙ*^E^/(*ω*_n_Δ) = *β*");
        }
        sheet.panels.push(panel);
    }
    layout::letters(&mut sheet.panels);
    // Below one another they share a legend.
    if columns == 1 {
        let mut all: Vec<Key> = Vec::new();
        for key in std::mem::take(&mut keys).into_iter().flatten() {
            if !all.iter().any(|other| other.label == key.label) {
                all.push(key);
            }
        }
        keys = vec![all];
    }
    layout::finish(&mut sheet, keys, figure.title.as_deref());
    sheet
}

/// A curve of a law: its points, and which of them carry a marker.
type Curve = (Vec<[f64; 2]>, Vec<usize>);

/// S over r from rest through a whole cycle of slip between -`reach` and `reach` [F (9)]; width 0 is the rigid law.
fn displacement(width: f64, reach: f64) -> Curve {
    let unloading = |t: f64| [reach - 2.0 * width * t, 1.0 - 2.0 * t];
    let loading = |t: f64| [2.0 * width * t - reach, 2.0 * t - 1.0];
    let points = vec![
        [0.0, 0.0],
        [width, 1.0],
        unloading(0.0),
        unloading(0.3),
        unloading(0.7),
        unloading(1.0),
        loading(0.0),
        loading(0.3),
        loading(0.7),
        loading(1.0),
        [width, 1.0],
    ];
    (points, vec![3, 4, 7, 8])
}

/// S over rdot [F (16)]; width 0 is the rigid law.
fn velocity(width: f64, reach: f64) -> Curve {
    let points = vec![
        [-1.1 * reach, -1.0],
        [-width, -1.0],
        [-0.6 * width, -0.6],
        [0.6 * width, 0.6],
        [width, 1.0],
        [1.1 * reach, 1.0],
    ];
    (points, vec![2, 3])
}

/// A dimension line from the origin to `reach` at height `to`, with thin lines from the height `from` and words beyond.
fn dimension(panel: &mut Panel, reach: f64, [from, to]: [f64; 2], text: &str) {
    for x in [0.0, reach] {
        let rule = Series::rule([[x, from], [x, 1.06 * to]]);
        panel.series.push(rule);
    }
    panel.arrows.push([[0.0, to], [reach, to]]);
    let [x, y] = panel.place([reach / 2.0, to]);
    let gap = if to > 0.0 { -3.5 } else { style::LABEL + 1.0 };
    panel.notes.push(Words {
        at: [x, y + gap],
        anchor: Anchor::Middle,
        text: text.into(),
        size: style::LABEL,
    });
}
