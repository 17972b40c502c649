//! One quantity over another: a row of panels for each quantity, the exact solution thin under the cases, what was measured
//! in grey under both.

use super::Draw;
use super::history::arrangement::Arrangement;
use super::history::curves::{members, sizes, unmark_alone};
use super::history::measured::Measured;
use crate::figures::label;
use crate::figures::{DrawnCase, FigureData};
use slipgap_drawing::layout;
use slipgap_drawing::layout::axis::Axis;
use slipgap_drawing::layout::guides;
use slipgap_drawing::layout::legend;
use slipgap_drawing::layout::limits;
use slipgap_drawing::layout::sheet::{Panel, Series, Sheet};
use slipgap_drawing::style;
use slipgap_solver::history::History;
use slipgap_solver::problem::{Quantity, Solution};
use slipgap_study::kinds::Curve;
use slipgap_study::{Scale, Study};

/// Fewest and most points of an exact curve, and points for each step between them.
const EXACT_POINTS: [usize; 2] = [800, 20_000];
/// See `EXACT_POINTS`.
const FOR_EACH_STEP: usize = 4;

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
pub(super) struct Look {
    /// Whether both axes have one scale.
    pub(super) equal: bool,
    /// The disc of forces.
    pub(super) disc: Option<Series>,
}

/// The panels of a figure that draws one curve over another.
pub(super) trait DrawWith {
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
        let solved = cases.iter().copied().filter(|c| c.solution().is_some());
        let solved: Vec<DrawnCase> = solved.collect();
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
        let all = &study.problem.schema().quantities;
        let quantities: Vec<&Quantity> = self.y.iter().map(|row| &all[*row]).collect();
        let pairs = Pairs {
            study,
            x: &all[self.x],
            in_units: units.is_some(),
            times: self.times,
        };
        let curve = |quantity, i: usize| Series {
            label: labels[indices[i]].clone(),
            points: pairs.computed(quantity, &drawn[i]),
            stroke: look.stroke(indices[i], labels.len()),
            width: style::CASE_LINE,
            marker: look.marker(indices[i]),
            marked: Vec::new(),
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
            let own = vec![height; rows.len()];
            height = layout::grid(width, columns, &own, &axes, 4.0).width;
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
                    Some(own) if grids.len() > 1 => (own, own.frames[r][0]),
                    _ => (&grids[0], grids[0].frames[r][column]),
                };
                let (mut x, mut y) = (across.clone(), axes[cell.quantity].clone());
                if column > 0 && grids.len() == 1 {
                    y.title.clear();
                    y.numbered = false;
                }
                if r + 1 < rows.len() {
                    x.title.clear();
                    x.numbered = false;
                }
                let mut panel = Panel::new(frame, grid.margin, x, y);
                panel.zero = panel.y.range[0] < 0.0 && panel.y.range[1] > 0.0;
                panel.series = series[cell.quantity][cell.group].clone();
                mark(&mut panel, &labels);
                if panel.x.range[0] < 0.0 && panel.x.range[1] > 0.0 {
                    let zero = Series::rule(panel.y.range.map(|y| [0.0, y]));
                    panel.series.insert(0, zero);
                }
                if let (0, Some(first)) = (cell.quantity, groups[cell.group].first()) {
                    panel.caption =
                        label::value_labels(table, drawn, &except, &drawn[*first].case());
                }
                sheet.panels.push(panel);
            }
        }
        layout::letter_panels(&mut sheet.panels);
        layout::left_out(&mut sheet, drawn.len(), solved.len());
        let mut keys = legend::keys(&sheet.panels);
        keys.extend(guides::key(&sheet.panels, None));
        layout::finish(&mut sheet, vec![keys], figure.title.as_deref());
        sheet
    }
}

/// The horizontal quantity, which each of the others is paired with.
struct Pairs<'a> {
    study: &'a Study,
    x: &'a Quantity,
    in_units: bool,
    /// First and last time in the unit of the axes, if not all.
    times: Option<[f64; 2]>,
}

impl Pairs<'_> {
    fn title(&self, quantity: &Quantity) -> String {
        let problem = &*self.study.problem;
        let dimension = problem.schema().channels[quantity.channel].dimension;
        match self.study.units.as_ref().filter(|_| self.in_units) {
            Some(units) => units.title(problem, &quantity.title, dimension),
            None => quantity.title.to_string(),
        }
    }

    /// Points of two lists of values, in the units of the axes.
    fn points(&self, y: &Quantity, shown: &DrawnCase, values: [Vec<f64>; 2]) -> Vec<[f64; 2]> {
        let size = |quantity| sizes(self.study, self.in_units, &shown.case(), quantity)[1];
        let [across, up] = [self.x, y].map(size);
        let [xs, ys] = values;
        let pairs = xs.into_iter().zip(ys);
        pairs.map(|(x, y)| [x * across, y * up]).collect()
    }

    fn computed(&self, y: &Quantity, shown: &DrawnCase) -> Vec<[f64; 2]> {
        let Some(solution) = shown.solution() else {
            return Vec::new();
        };
        let both = [self.x, y].map(|quantity| values(quantity, solution));
        let points = self.points(y, shown, both);
        self.within(shown, &solution.computed.time, points)
    }

    /// The points at the times shown.
    fn within(&self, shown: &DrawnCase, time: &[f64], points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
        let Some([first, last]) = self.times else {
            return points;
        };
        let size = sizes(self.study, self.in_units, &shown.case(), self.x)[0];
        let pairs = time.iter().zip(points);
        let inside = pairs.filter(|(t, _)| (first..=last).contains(&(**t * size)));
        inside.map(|(_, point)| point).collect()
    }

    /// The measured curves of a group of cases, equal ones once, where both quantities were measured.
    fn measured(&self, y: &Quantity, drawn: &[DrawnCase], group: &[usize]) -> Vec<Series> {
        let mut found: Vec<Series> = Vec::new();
        for shown in group.iter().map(|i| &drawn[*i]) {
            let measured = Measured::of(self.study, &shown.case());
            let [Some((time, xs)), Some((_, ys))] = [self.x, y].map(|own| measured.quantity(own))
            else {
                continue;
            };
            let computed = shown.solution().map(|solution| &solution.computed.time[..]);
            let end = computed.and_then(<[f64]>::last).copied();
            let points = self.points(y, shown, [xs.to_vec(), ys.to_vec()]);
            let moving =
                time.partition_point(|t| *t < 0.0)..time.partition_point(|t| Some(*t) <= end);
            let points = self.within(shown, &time[moving.clone()], points[moving].to_vec());
            if !points.is_empty() && found.iter().all(|other| other.points != points) {
                found.push(Series::measured(points));
            }
        }
        found
    }

    /// The exact curves of a group of cases, equal ones once; none for an error.
    fn exact(&self, y: &Quantity, drawn: &[DrawnCase], group: &[usize]) -> Vec<Series> {
        let mut found: Vec<Series> = Vec::new();
        for shown in group.iter().map(|i| &drawn[*i]) {
            let exact = match self.x.error || y.error {
                true => None,
                false => self.history(shown),
            };
            let Some(exact) = exact else { continue };
            let both = [self.x, y].map(|quantity| exact.channel(quantity.channel).to_vec());
            let points = self.points(y, shown, both);
            let points = self.within(shown, &exact.time, points);
            if !points.is_empty() && found.iter().all(|other| other.points != points) {
                found.push(Series::exact(points));
            }
        }
        found
    }

    /// The exact motion, at more times than the computed one.
    fn history(&self, shown: &DrawnCase) -> Option<History> {
        let time = &shown.solution()?.computed.time;
        let end = *time.last()?;
        let [fewest, most] = EXACT_POINTS;
        let count = (FOR_EACH_STEP * time.len()).clamp(fewest, most);
        let time = |i| end * i as f64 / count as f64;
        let times: Vec<f64> = (0..=count).map(time).collect();
        self.study.problem.exact(&shown.case(), &times)
    }
}

/// The values of a quantity at the steps.
fn values(quantity: &Quantity, solution: &Solution) -> Vec<f64> {
    let computed = solution.computed.channel(quantity.channel);
    if !quantity.error {
        return computed.to_vec();
    }
    let exact = solution.exact.channel(quantity.channel);
    computed.iter().zip(exact).map(|(c, e)| c - e).collect()
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
        let lengths: Vec<f64> = places
            .windows(2)
            .map(|pair| libm::hypot(pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]))
            .collect();
        let spacing = lengths.iter().sum::<f64>() / MARKERS;
        if !(spacing > 0.0 && spacing.is_finite()) {
            continue;
        }
        let mut next = spacing * ((index % count) as f64 + 0.5) / count as f64;
        let mut reached = 0.0;
        for (i, length) in lengths.iter().enumerate() {
            reached += length;
            if reached >= next {
                curve.marked.push(i + 1);
                next += spacing * ((reached - next) / spacing).floor() + spacing;
            }
        }
    }
    panel.series = series;
}
