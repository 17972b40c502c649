//! The friction laws as [F] Fig. 3 draws them, over the rigid law of [F] Fig. 2: force over slip and over velocity.

use crate::label;
use crate::{DrawnCase, FigureData};
use slipgap_contact::contact::numbers::oscillator::{ALPHA, BETA};
use slipgap_contact::contact::{Cycle, DisplacementControl, Law as _, VelocityControl};
use slipgap_drawing::layout;
use slipgap_drawing::layout::axis::Axis;
use slipgap_drawing::layout::legend::Key;
use slipgap_drawing::layout::sheet::{Anchor, Panel, PlacedText, Series, Sheet};
use slipgap_drawing::layout::ticks;
use slipgap_drawing::style::{self, Stroke};
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_study::Study;

const HEIGHT: f64 = 150.0;

/// A panel for each of both models.
pub fn sheet(data: &FigureData) -> Sheet {
    let FigureData {
        study,
        figure,
        cases,
        ..
    } = *data;
    let look = data.look();
    let panels = MODELS.map(|model| (model, widths(model, study, cases)));
    let models: Vec<_> = panels.into_iter().filter(|p| !p.1.is_empty()).collect();
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
    for (k, (model, widths)) in models.into_iter().enumerate() {
        let widest = widths.iter().fold(0.0, |a: f64, b| a.max(b.0));
        let reach = 1.6 * widest;
        let most = grid.width / 32.0;
        let x = ticks::linear(model.title(), [-1.2 * reach, 1.2 * reach], most);
        let y = force.clone().labelled(k % columns == 0);
        let mut frame = grid.frames[k / columns][k % columns];
        // Each row has a horizontal axis.
        frame.top += (k / columns) as f64 * layout::below(&x).ceil();
        let mut panel = Panel::new(frame, grid.margin, x, y);
        panel.zero = true;
        panel.series.push(Series {
            label: "rigid (Coulomb)".into(),
            points: model.curve(0.0, reach).0,
            stroke: Stroke::Solid,
            width: style::EXACT_LINE,
            marker: None,
            marked: Vec::new(),
        });
        for (index, (width, label)) in widths.into_iter().enumerate() {
            let (points, marked) = model.curve(width, reach);
            panel.series.push(Series {
                label,
                points,
                stroke: look.stroke(index, style::MOST_STYLES),
                width: style::CASE_LINE,
                marker: look.marker(index),
                marked,
            });
        }
        keys.push(panel.series.iter().map(Key::of).collect::<Vec<Key>>());
        model.write_dimensions(&mut panel, widest, reach);
        sheet.panels.push(panel);
    }
    layout::letter_panels(&mut sheet.panels);
    // Panels below one another share a legend.
    if columns == 1 {
        let mut shared: Vec<Key> = Vec::new();
        for key in std::mem::take(&mut keys).into_iter().flatten() {
            if !shared.iter().any(|other| other.label == key.label) {
                shared.push(key);
            }
        }
        keys = vec![shared];
    }
    layout::finish(&mut sheet, keys, figure.title.as_deref());
    sheet
}

/// The softened laws of friction.
const MODELS: [Model; 2] = [Model::DisplacementControl, Model::VelocityControl];

/// A softened law of friction, a panel each.
#[derive(Clone, Copy)]
enum Model {
    DisplacementControl,
    VelocityControl,
}

impl Model {
    /// The parameter that is its elastic width.
    fn parameter(self) -> &'static str {
        match self {
            Model::DisplacementControl => ALPHA.key,
            Model::VelocityControl => BETA.key,
        }
    }

    /// Title of the horizontal axis.
    fn title(self) -> &'static str {
        match self {
            Model::DisplacementControl => "*r*/Δ",
            Model::VelocityControl => "*ṙ*/(*ω*_n_Δ)",
        }
    }

    /// The curve of this elastic width, between -`reach` and `reach`; width 0 is the rigid law.
    fn curve(self, width: f64, reach: f64) -> Cycle {
        let (compliance, limit) = (width, 1.0);
        match self {
            Model::DisplacementControl => DisplacementControl { compliance, limit }.cycle(reach),
            Model::VelocityControl => VelocityControl { compliance, limit }.cycle(reach),
        }
    }

    /// Writes the dimensions of the curve of this width.
    fn write_dimensions(self, panel: &mut Panel, width: f64, reach: f64) {
        match self {
            Model::DisplacementControl => {
                dimension(panel, width, [1.0, 1.25], "*r*^E^/Δ = *α*");
                dimension(panel, reach - width, [0.0, -1.25], "*r*^S^/Δ");
            }
            Model::VelocityControl => {
                dimension(panel, width, [1.0, 1.25], "*ṙ*^E^/(*ω*_n_Δ) = *β*");
            }
        }
    }
}

/// The widths of a law in the cases, rising, each with its label.
fn widths(model: Model, study: &Study, cases: &[DrawnCase]) -> Vec<(f64, String)> {
    let table = study.problem.parameters();
    let Some(row) = table.iter().position(|p| p.name == model.parameter()) else {
        return Vec::new();
    };
    let form = label::form(cases, row);
    let labelled = |value: Value| {
        Some((
            value.as_f64()?,
            label::value_label(&table[row], value, form),
        ))
    };
    let values = label::values(cases, row).into_iter().flatten();
    let mut widths: Vec<_> = values.filter_map(labelled).collect();
    widths.sort_by(|a, b| a.0.total_cmp(&b.0));
    widths
}

/// A dimension line from the origin to `reach` at height `to`, with thin lines from the height `from` and a label beyond.
fn dimension(panel: &mut Panel, reach: f64, [from, to]: [f64; 2], text: &str) {
    for x in [0.0, reach] {
        let rule = Series::rule([[x, from], [x, 1.06 * to]]);
        panel.series.push(rule);
    }
    panel.arrows.push([[0.0, to], [reach, to]]);
    let [x, y] = panel.place([reach / 2.0, to]);
    let gap = if to > 0.0 { -3.5 } else { style::LABEL + 1.0 };
    panel.notes.push(PlacedText {
        at: [x, y + gap],
        anchor: Anchor::Middle,
        text: text.into(),
        size: style::LABEL,
    });
}
