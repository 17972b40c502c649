//! Response spectra of the ground motions of the cases: a panel for each ordinate, a curve for each motion and damping ratio.

use crate::kind::Draw;
use crate::label;
use crate::{DrawnCase, FigureData};
use libm::pow;
use slipgap_drawing::layout;
use slipgap_drawing::layout::axis::Axis;
use slipgap_drawing::layout::legend::Key;
use slipgap_drawing::layout::limits;
use slipgap_drawing::layout::sheet::{Panel, Series, Sheet};
use slipgap_drawing::style;
use slipgap_drawing::text::markup;
use slipgap_drawing::text::number::Form;
use slipgap_problem::problem::Quantity;
use slipgap_problem::problem::numbers::unit::Dimension;
use slipgap_problem::problem::structure::GroundMotion;
use slipgap_study::kinds::{Ordinate, Spectrum};
use slipgap_study::{Scale, Study};
use slipgap_system::system::loads::spectrum::{self, spectrum};
use slipgap_system::system::structure::Table;

/// Points of a curve: about one typographic point apart.
const POINTS: usize = 240;

/// Every how many points there is a marker.
const MARKED: usize = 30;

impl Draw for Spectrum {
    fn sheet(&self, data: &FigureData) -> Sheet {
        let FigureData {
            study,
            figure,
            cases,
            ..
        } = *data;
        let of = self.of.map(|row| &study.problem.schema().quantities[row]);
        let (motions, shown) = motions(study, cases, of);
        // Without its unit.
        let of = of.map(|of| {
            of.title
                .rsplit_once(", ")
                .map_or(&*of.title, |parts| parts.0)
        });
        let named = label::labels(study.problem.parameters(), &shown, None, &[]);
        let ratios = Form::of(self.damping.iter().copied());
        let periods = over_periods(self.periods);
        let mut curves: Vec<(String, Vec<spectrum::Ordinate>)> = Vec::new();
        let curve_count = motions.len() * self.damping.len();
        for (motion, name) in motions.iter().zip(&named) {
            for ratio in &self.damping {
                let Some(ordinates) = spectrum(&motion.acceleration, &periods, *ratio) else {
                    continue;
                };
                let ratio = format!("*ζ* = {}", ratios.write(*ratio));
                let words = [
                    of.map(str::to_owned),
                    (motions.len() > 1).then(|| name.clone()),
                    (self.damping.len() > 1 || motions.len() == 1).then_some(ratio),
                ];
                let parts: Vec<String> = words.into_iter().flatten().collect();
                curves.push((parts.join(", "), ordinates));
            }
        }
        let drawable = curves.len();
        curves.truncate(style::MOST_STYLES);
        let (look, count) = (data.look(), curves.len());
        let series = |y: Ordinate| -> Vec<Series> {
            let curve =
                |(i, (label, ordinates)): (usize, &(String, Vec<spectrum::Ordinate>))| Series {
                    label: label.clone(),
                    points: ordinates
                        .iter()
                        .map(|at| [at.period, value(y, at)])
                        .collect(),
                    stroke: look.stroke(i, count),
                    width: style::CASE_LINE,
                    marker: look.marker(i),
                    marked: (i * MARKED / count.max(1)..=POINTS)
                        .step_by(MARKED)
                        .collect(),
                };
            curves.iter().enumerate().map(curve).collect()
        };
        let units = motions
            .first()
            .map(|motion| motion.units.clone())
            .unwrap_or_default();
        let panels: Vec<Vec<Series>> = self.y.iter().map(|y| series(*y)).collect();
        let height = if self.y.len() == 1 { 190.0 } else { 130.0 };
        let axis = |(y, series): (&Ordinate, &Vec<Series>)| -> Axis {
            // Zero belongs to the axis.
            let values = limits::points(series.iter())
                .map(|point| point[1])
                .chain([0.0]);
            let mut axis = limits::axis(
                &title(*y, &units),
                values,
                Scale::Linear,
                None,
                height / 24.0,
            );
            axis.range[0] = 0.0;
            axis.ticks.retain(|tick| tick.at >= 0.0);
            axis
        };
        let axes: Vec<Axis> = self.y.iter().zip(&panels).map(axis).collect();
        let width = figure.width.unwrap_or(1.2 * style::SINGLE);
        let grid = layout::grid(width, 1, &vec![height; axes.len()], &axes, 4.0);
        let across = with_unit("Period *T*", &markup::escape(&units[1]));
        let range = Some(self.periods);
        let across = limits::axis(
            &across,
            [].into_iter(),
            Scale::Log,
            range,
            grid.width / 40.0,
        );
        let mut sheet = Sheet {
            width,
            ..Sheet::default()
        };
        let last = axes.len().saturating_sub(1);
        for (i, (series, y)) in panels.into_iter().zip(axes).enumerate() {
            let x = across.clone().labelled(i == last);
            let mut panel = Panel::new(grid.frames[i][0], grid.margin, x, y);
            panel.series = series;
            sheet.panels.push(panel);
        }
        layout::letter_panels(&mut sheet.panels);
        layout::left_out(&mut sheet, count, drawable.max(curve_count));
        let first = sheet.panels.first();
        let keys: Vec<Key> = first
            .iter()
            .flat_map(|panel| panel.series.iter().map(Key::of))
            .collect();
        layout::finish(&mut sheet, vec![keys], figure.title.as_deref());
        sheet
    }
}

/// The periods, evenly spaced on a log scale.
pub(super) fn over_periods([first, last]: [f64; 2]) -> Vec<f64> {
    let period = |i| match i {
        0 => first,
        POINTS => last,
        _ => first * pow(last / first, i as f64 / POINTS as f64),
    };
    (0..=POINTS).map(period).collect()
}

/// The different motions of the ground in the cases, or of this quantity, each with the first case that has it.
fn motions<'a>(
    study: &Study,
    cases: &[DrawnCase<'a>],
    of: Option<&Quantity>,
) -> (Vec<GroundMotion>, Vec<DrawnCase<'a>>) {
    let (mut motions, mut first) = (Vec::new(), Vec::new());
    let structure = study.problem.as_structure();
    let unit = |dimension| structure.and_then(|structure| structure.unit_name(dimension));
    let units =
        [Dimension::Length, Dimension::Time].map(|dimension| unit(dimension).unwrap_or_default());
    let motion = |shown: &DrawnCase| match of {
        None => structure?.ground_motion(&shown.case()),
        Some(of) => {
            let computed = &shown.solution()?.computed;
            let values = computed.channel(of.channel).to_vec();
            Some(GroundMotion {
                acceleration: Table::new(computed.time.clone(), values)?,
                units: units.clone(),
            })
        }
    };
    for shown in cases {
        if let Some(motion) = motion(shown)
            && !motions.contains(&motion)
        {
            motions.push(motion);
            first.push(*shown);
        }
    }
    (motions, first)
}

fn value(y: Ordinate, at: &spectrum::Ordinate) -> f64 {
    match y {
        Ordinate::Displacement => at.displacement,
        Ordinate::PseudoVelocity => at.pseudo_velocity(),
        Ordinate::PseudoAcceleration => at.pseudo_acceleration(),
    }
}

pub(super) fn title(y: Ordinate, [length, time]: &[String; 2]) -> String {
    let over = |power: &str| match length.is_empty() || time.is_empty() {
        true => String::new(),
        false => format!("{length}/{time}{power}"),
    };
    let (title, unit) = match y {
        Ordinate::Displacement => ("Displacement *S*_d_", length.clone()),
        Ordinate::PseudoVelocity => ("Pseudo-velocity *S*_v_", over("")),
        Ordinate::PseudoAcceleration => ("Pseudo-acceleration *S*_a_", over("2")),
    };
    with_unit(title, &unit)
}

/// A title with a unit.
fn with_unit(title: &str, unit: &str) -> String {
    markup::in_unit(title, &markup::unit(unit))
}
