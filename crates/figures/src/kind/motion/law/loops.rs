//! Loops of any laws: a panel for each law, a curve for each of its cases.

use crate::label;
use crate::{DrawnCase, FigureData, words};
use slipgap_contact::contact::ContactLaw;
use slipgap_drawing::layout::legend::Key;
use slipgap_drawing::layout::sheet::{Panel, Series, Sheet};
use slipgap_drawing::layout::{self, ticks};
use slipgap_drawing::style;
use slipgap_drawing::text::markup;
use slipgap_drawing::text::number::Form;
use slipgap_study::Study;

const HEIGHT: f64 = 120.0;

/// Points between markers.
const MARKED: usize = 25;

/// A panel for each law of the cases; `laws` has the law of each case.
pub fn sheet(data: &FigureData, laws: &[Option<ContactLaw>]) -> Sheet {
    let FigureData {
        study,
        figure,
        cases,
        ..
    } = *data;
    let look = data.look();
    let table = study.problem.parameters();
    // By the name of the law: velocity-control without compliance is Coulomb friction.
    let mut groups: Vec<(&'static str, Vec<(ContactLaw, &DrawnCase)>)> = Vec::new();
    for (law, shown) in laws.iter().zip(cases) {
        let Some(law) = law else { continue };
        let name = shown.case().choice("law");
        match groups.iter_mut().find(|group| group.0 == name) {
            Some(group) => group.1.push((*law, shown)),
            None => groups.push((name, vec![(*law, shown)])),
        }
    }
    let columns = layout::side_by_side(groups.len().clamp(1, 3), figure.width);
    let width = figure.width.unwrap_or(match columns > 1 {
        true => style::DOUBLE,
        false => style::SINGLE,
    });
    let [displacement, velocity, force] = titles(study);
    let curves: Vec<Vec<Curve>> = groups.iter().map(|group| curves(&group.1, table)).collect();
    let drawn_points = || curves.iter().flatten().flat_map(|curve| &curve.points);
    let forces = drawn_points().fold([0.0, 0.0], |[low, high]: [f64; 2], [_, s]| {
        [low.min(*s), high.max(*s)]
    });
    let y = ticks::around(force, forces.into_iter(), 6.0);
    let rows = groups.len().max(1).div_ceil(columns);
    let grid = layout::grid(
        width,
        columns,
        &vec![HEIGHT; rows],
        std::slice::from_ref(&y),
        4.0,
    );
    let mut sheet = Sheet {
        width,
        ..Sheet::default()
    };
    let mut keys = Vec::new();
    for (k, (group, curves)) in groups.iter().zip(curves).enumerate() {
        let of_x = |pick: fn(f64, f64) -> f64, from: f64| {
            let points = curves.iter().flat_map(|curve| &curve.points);
            points.fold(from, |x, point| pick(x, point[0]))
        };
        let range = [
            of_x(f64::min, f64::INFINITY),
            of_x(f64::max, f64::NEG_INFINITY),
        ];
        let title = match group.1[0].0.properties().over_velocity() {
            true => velocity,
            false => displacement,
        };
        let x = ticks::around(title, range.into_iter(), grid.width / 32.0);
        let up = y.clone().labelled(k % columns == 0);
        let mut frame = grid.frames[k / columns][k % columns];
        // Each row has a horizontal axis.
        frame.top += (k / columns) as f64 * layout::below(&x).ceil();
        let mut panel = Panel::new(frame, grid.margin, x, up);
        panel.zero = true;
        panel.caption = markup::escape(words::of(group.0));
        let count = curves.len();
        let alone = count == 1;
        for (index, curve) in curves.into_iter().enumerate() {
            let marked = (0..curve.points.len()).skip(MARKED / 2).step_by(MARKED);
            panel.series.push(Series {
                label: curve.label,
                marked: if alone { Vec::new() } else { marked.collect() },
                points: curve.points,
                stroke: look.stroke(index, count),
                width: style::CASE_LINE,
                marker: look.marker(index).filter(|_| !alone),
            });
        }
        if !alone {
            keys.extend(panel.series.iter().map(Key::of));
        }
        sheet.panels.push(panel);
    }
    layout::letter_panels(&mut sheet.panels);
    // One legend for all panels: their captions have the laws.
    layout::finish(&mut sheet, vec![keys], figure.title.as_deref());
    sheet
}

/// The curve of a case.
struct Curve {
    label: String,
    points: Vec<[f64; 2]>,
}

/// The different curves of a law, each with its name and the parameters that distinguish it.
fn curves(
    group: &[(ContactLaw, &DrawnCase)],
    table: &[slipgap_problem::problem::numbers::parameter::Parameter],
) -> Vec<Curve> {
    let reach = group
        .iter()
        .map(|(law, _)| law.properties().reach())
        .fold(0.0, f64::max);
    let mut curves: Vec<Curve> = Vec::new();
    let mut seen: Vec<ContactLaw> = Vec::new();
    for (law, shown) in group {
        if seen.contains(law) {
            continue;
        }
        seen.push(*law);
        let values = table.iter().enumerate().filter_map(|(row, parameter)| {
            let value = shown.value(row);
            let of_law =
                parameter.name == "law" || parameter.applies.is_some_and(|on| on.governor == "law");
            let varies =
                parameter.name == "law" || group.iter().any(|(_, other)| other.value(row) != value);
            (of_law && varies).then_some(())?;
            let form = Form::of(group.iter().filter_map(|(_, other)| other.number(row)));
            Some(label::value_label(parameter, value?, form))
        });
        curves.push(Curve {
            label: values.collect::<Vec<_>>().join(", "),
            points: law.cycle(reach).0,
        });
    }
    curves
}

/// Titles of displacement, velocity and force.
fn titles(study: &Study) -> [&'static str; 3] {
    match study.problem.schema().contact_metric {
        Some(_) => ["*r*/(*cT*_I_/2)", "*ṙ*/*c*", "*S*/*F*_0_"],
        None => ["*r*/Δ", "*ṙ*/(*ω*_n_Δ)", "*S*/*νN*"],
    }
}
