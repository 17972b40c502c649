//! One quantity over another: a row of panels for each quantity, the exact solution thin under the cases, what was measured
//! in grey under both.

mod pairs;

use super::cycles::scattered;
use super::history::arrangement::Arrangement;
use super::history::curves::{members, unmark_alone};
use crate::FigureData;
use crate::kind::Draw;
use crate::kind::order::{order, strokes};
use crate::label;
use pairs::Pairs;
use slipgap_drawing::layout;
use slipgap_drawing::layout::axis::Axis;
use slipgap_drawing::layout::coincide;
use slipgap_drawing::layout::legend;
use slipgap_drawing::layout::limits;
use slipgap_drawing::layout::sheet::{Panel, Series, Sheet};
use slipgap_drawing::style;
use slipgap_problem::problem::Quantity;
use slipgap_study::Scale;
use slipgap_study::kinds::Curve;

/// Largest value of an axis of an orbit over that of the path, and the height of a panel for its first layout.
const MARGIN: f64 = 1.08;
const SQUARE: f64 = 200.0;

/// Markers along a curve.
const MARKERS: f64 = 8.3;

impl Draw for Curve {
    fn sheet(&self, data: &FigureData) -> Sheet {
        self.sheet_with(data, &Look::default())
    }
}

/// What an orbit has more than a curve.
#[derive(Debug, Default)]
pub(in crate::kind) struct Look {
    /// Whether both axes have one scale.
    pub(in crate::kind) equal: bool,
    /// The disc of forces.
    pub(in crate::kind) disc: Option<Series>,
}

/// The panels of a figure that draws one curve over another.
pub(in crate::kind) trait DrawWith {
    /// The sheet with this look.
    fn sheet_with(&self, data: &FigureData, with: &Look) -> Sheet;
}

impl DrawWith for Curve {
    fn sheet_with(&self, data: &FigureData, with: &Look) -> Sheet {
        let FigureData {
            study,
            figure,
            cases,
            ..
        } = *data;
        let look = data.look();
        let units = study.units.as_ref().filter(|_| self.in_units);
        let solved = Vec::from_iter(cases.iter().copied().filter(|c| c.solution().is_some()));
        let drawn = &solved[..solved.len().min(style::MOST_STYLES)];
        let table = study.problem.parameters();
        let bound = |row| label::bound(table, drawn, row);
        let except = self.panels.map_or(Vec::new(), bound);
        let (indices, labels) = label::numbered(&label::labels(table, drawn, self.by, &except));
        let groups = match self.panels {
            Some(row) if !drawn.is_empty() => label::values(drawn, row),
            Some(_) | None => vec![None],
        };
        let arranged = Arrangement::of(self.y.len(), groups.len(), figure.width);
        let columns = arranged.columns(self.y.len(), groups.len());
        let rows = arranged.rows(self.y.len(), groups.len());
        let offered = &study.problem.schema().quantities;
        let quantities: Vec<&Quantity> = self.y.iter().map(|row| &offered[*row]).collect();
        let pairs = Pairs {
            study,
            x: &offered[self.x],
            in_units: units.is_some(),
            times: self.times,
            section: self.section,
        };
        let named = label::named(table, drawn, self.by, &except);
        let order = order(&named, drawn, &indices, labels.len());
        let strokes = strokes(look, order.as_deref(), labels.len());
        let curve = |quantity, i: usize| {
            let (index, count) = (indices[i], labels.len());
            let (points, stroke) = (pairs.computed(quantity, &drawn[i]), strokes[index]);
            if self.section {
                return scattered(&points, &labels[index], stroke, (index, count));
            }
            Series {
                label: labels[index].clone(),
                points,
                stroke,
                width: style::CASE_LINE,
                marker: look.marker(index),
                marked: Vec::new(),
            }
        };
        let group = |value| members(drawn, self.panels.map(|row| (row, value)));
        let groups: Vec<Vec<usize>> = groups.into_iter().map(group).collect();
        let series = |quantity| {
            let of_group = |group: &Vec<usize>| {
                let curves = group.iter().map(|i| curve(quantity, *i));
                let measured = pairs.measured(quantity, drawn, group).into_iter();
                let exact = pairs.exact(quantity, drawn, group);
                let disc = with.disc.clone();
                measured.chain(exact).chain(disc).chain(curves).collect()
            };
            groups.iter().map(of_group).collect()
        };
        let mut series: Vec<Vec<Vec<Series>>> = quantities.iter().copied().map(series).collect();
        unmark_alone(series.iter_mut().flatten().flatten(), &labels);

        let [mut x_range, mut y_range] = figure.ranges;
        let mut height = if rows.len() == 1 { 160.0 } else { 130.0 };
        if with.equal {
            let points = limits::points(series.iter().flatten().flatten());
            let most = points.fold(0.0, |most: f64, [x, y]| most.max(x.abs()).max(y.abs()));
            let range = Some([-MARGIN * most, MARGIN * most]).filter(|_| most > 0.0);
            [x_range, y_range] = [range; 2];
            height = SQUARE;
        }
        let axes: Vec<Axis> = quantities
            .iter()
            .zip(&series)
            .map(|(quantity, groups)| {
                let points = limits::points(groups.iter().flatten());
                let values = limits::heights(points, x_range).into_iter();
                let title = pairs.title(quantity);
                limits::axis(&title, values, Scale::Linear, y_range, height / 17.0)
            })
            .collect();
        let width = figure.width.unwrap_or(match columns {
            1 => 1.2 * style::SINGLE,
            _ => style::DOUBLE,
        });
        if with.equal {
            let heights = vec![height; rows.len()];
            height = layout::grid(width, columns, &heights, &axes, 4.0).width;
        }
        let heights = vec![height; rows.len()];
        let grids = match arranged {
            Arrangement::QuantitiesAcross => layout::columns(width, &heights, &axes),
            Arrangement::Stack | Arrangement::GroupsAcross => {
                vec![layout::grid(width, columns, &heights, &axes, 4.0)]
            }
        };
        let places = limits::points(series.iter().flatten().flatten());
        let most = grids.first().map_or(1.0, |grid| grid.width / 38.0);
        let title = pairs.title(pairs.x);
        let places = places.map(|point| point[0]);
        let across = limits::axis(&title, places, Scale::Linear, x_range, most);
        let mut sheet = Sheet {
            width,
            ..Sheet::default()
        };
        for (r, row) in rows.iter().enumerate() {
            for (column, cell) in row.iter().enumerate() {
                let (grid, frame) = match grids.get(column) {
                    Some(grid) if grids.len() > 1 => (grid, grid.frames[r][0]),
                    _ => (&grids[0], grids[0].frames[r][column]),
                };
                let x = across.clone().labelled(r + 1 == rows.len());
                let y = axes[cell.quantity]
                    .clone()
                    .labelled(column == 0 || grids.len() > 1);
                let mut panel = Panel::new(frame, grid.margin, x, y);
                panel.zero = panel.y.range[0] < 0.0 && panel.y.range[1] > 0.0;
                panel.series = series[cell.quantity][cell.group].clone();
                if !self.section {
                    mark(&mut panel, &labels);
                }
                if panel.x.range[0] < 0.0 && panel.x.range[1] > 0.0 {
                    let zero = Series::rule(panel.y.range.map(|y| [0.0, y]));
                    panel.series.insert(0, zero);
                }
                if let (0, Some(first)) = (cell.quantity, groups[cell.group].first()) {
                    panel.caption =
                        label::caption(table, drawn, &except, &drawn[*first].case(), frame.width);
                }
                sheet.panels.push(panel);
            }
        }
        layout::letter_panels(&mut sheet.panels);
        layout::left_out(&mut sheet, drawn.len(), solved.len());
        let mut keys = legend::keys(&sheet.panels);
        keys.retain(|_| !self.section || labels.len() > 1);
        layout::finish(&mut sheet, vec![keys], figure.title.as_deref());
        sheet
    }
}

/// Marks the curves of cases at equal distances along the line, each curve at other places.
fn mark(panel: &mut Panel, labels: &[String]) {
    let mut series = std::mem::take(&mut panel.series);
    let count = labels.len().clamp(1, 8);
    for curve in &mut series {
        let Some(index) = labels.iter().position(|label| *label == curve.label) else {
            continue;
        };
        let places: Vec<[f64; 2]> = curve.points.iter().map(|p| panel.place(*p)).collect();
        let steps = places.windows(2).map(|pair| {
            let [a, b] = [pair[0], pair[1]];
            libm::hypot(b[0] - a[0], b[1] - a[1])
        });
        let spacing = steps.sum::<f64>() / MARKERS;
        if spacing > 0.0 && spacing.is_finite() {
            let first = ((index % count) as f64 + 0.5) / count as f64;
            curve.marked = coincide::at_distances(&places, spacing, first);
        }
    }
    panel.series = series;
}
