//! Quantities along the structure: a row of panels for each time, a column for each quantity, the exact profile thin
//! under the cases ([I] Fig. 6).

use crate::kind::Draw;
use crate::label;
use crate::{DrawnCase, FigureData};
use slipgap_drawing::layout;
use slipgap_drawing::layout::axis::Axis;
use slipgap_drawing::layout::legend::{self, Key};
use slipgap_drawing::layout::limits;
use slipgap_drawing::layout::sheet::{Panel, Series, Sheet};
use slipgap_drawing::style::{self, Look};
use slipgap_drawing::text::number::{self, Form};
use slipgap_study::kinds::Profile;
use slipgap_study::{Scale, Study};

/// Most markers along a part of the structure.
const MARKERS: usize = 12;

impl Draw for Profile {
    fn sheet(&self, data: &FigureData) -> Sheet {
        let FigureData {
            study,
            figure,
            cases,
            ..
        } = *data;
        let Profile { y, times } = self;
        let problem = &*study.problem;
        let width = figure.width.unwrap_or(style::DOUBLE);
        let [x_range, y_range] = figure.ranges;
        let given = cases.iter().copied();
        let solved: Vec<DrawnCase> = given
            .filter(|c| c.snapshots().len() == times.len())
            .collect();
        let drawn = &solved[..solved.len().min(style::MOST_STYLES)];
        let labels = label::labels(problem.parameters(), drawn, None, &[]);
        let (indices, labels) = label::numbered(&labels);
        let panels: Vec<Vec<Vec<Series>>> = (0..times.len())
            .map(|row| {
                let panel = |quantity| curves(data.look(), drawn, &indices, &labels, row, quantity);
                y.iter().map(|quantity| panel(*quantity)).collect()
            })
            .collect();
        let height = if times.len() > 1 { 92.0 } else { 160.0 };
        let along = |k: usize| limits::points(panels.iter().flat_map(move |row| &row[k]));
        let axes: Vec<Axis> = (0..y.len())
            .map(|k| {
                let title = &problem.schema().profiles[y[k]].title;
                let heights = limits::heights(along(k), x_range).into_iter();
                limits::axis(title, heights, Scale::Linear, y_range, height / 17.0)
            })
            .collect();
        // A column for each quantity, or all panels below one another.
        let across = layout::own_axes(y.len(), figure.width);
        let grids = match across {
            true => layout::columns(width, &vec![height; times.len()], &axes),
            false => {
                let heights = vec![height; times.len() * y.len()];
                vec![layout::grid(width, 1, &heights, &axes, 6.0)]
            }
        };
        let places = (0..y.len()).flat_map(along).map(|point| point[0]);
        let most = grids.first().map_or(1.0, |grid| grid.width / 32.0);
        let title = &problem.schema().place_title;
        let position = limits::axis(title, places, Scale::Linear, x_range, most);
        let ends = ends(drawn);

        let mut sheet = Sheet {
            width,
            ..Sheet::default()
        };
        for (r, row) in panels.into_iter().enumerate() {
            for (k, series) in row.into_iter().enumerate() {
                let (grid, frame) = match across {
                    true => (&grids[k], grids[k].frames[r][0]),
                    false => (&grids[0], grids[0].frames[r * y.len() + k][0]),
                };
                let is_lowest = r + 1 >= times.len() && (across || k + 1 >= y.len());
                let x = position.clone().labelled(is_lowest);
                let [low, high] = axes[k].range;
                let mut panel = Panel::new(frame, grid.margin, x, axes[k].clone());
                panel.zero = low < 0.0 && high > 0.0;
                // The contact and the free ends.
                let rules = ends
                    .iter()
                    .map(|end| Series::rule([[*end, low], [*end, high]]));
                panel.series = rules.chain(series).collect();
                if k == 0 {
                    panel.caption = moment(study, drawn, r);
                }
                sheet.panels.push(panel);
            }
        }
        layout::letter_panels(&mut sheet.panels);
        layout::left_out(&mut sheet, drawn.len(), solved.len());
        let mut keys = legend::keys(sheet.panels.get(..1).unwrap_or_default());
        keys.extend((!ends.is_empty()).then(|| Key::thin("ends of the bars")));
        layout::finish(&mut sheet, vec![keys], figure.title.as_deref());
        sheet
    }

    fn has_dense_curves(&self) -> bool {
        true
    }
}

/// The curves of one panel, the exact ones first.
fn curves(
    look: Look,
    cases: &[DrawnCase],
    indices: &[usize],
    labels: &[String],
    row: usize,
    quantity: usize,
) -> Vec<Series> {
    let mut exact: Vec<Series> = Vec::new();
    let mut computed = Vec::new();
    for (shown, index) in cases.iter().zip(indices) {
        let lines = &shown.snapshots()[row].profiles[quantity];
        let points = joined(&lines.exact);
        if !exact.iter().any(|series| alike(&series.points, &points)) {
            exact.push(Series::exact(points));
        }
        computed.push(Series {
            label: labels[*index].clone(),
            points: joined(&lines.computed),
            stroke: look.stroke(*index, labels.len()),
            width: style::CASE_LINE,
            marker: look.marker(*index),
            marked: marked(&lines.computed, *index, labels.len()),
        });
    }
    exact.extend(computed);
    exact
}

/// The lines of all parts as one series, with a gap between them.
fn joined(lines: &[Vec<[f64; 2]>]) -> Vec<[f64; 2]> {
    lines.join(&[f64::NAN; 2])
}

/// Whether two series have the same points, gaps included.
fn alike(a: &[[f64; 2]], b: &[[f64; 2]]) -> bool {
    let same = |a: f64, b: f64| a == b || (a.is_nan() && b.is_nan());
    let pairs = a.iter().flatten().zip(b.iter().flatten());
    a.len() == b.len() && pairs.into_iter().all(|(a, b)| same(*a, *b))
}

/// The points of the joined lines with a marker: of many, every second, third, ..., different ones for each curve.
fn marked(lines: &[Vec<[f64; 2]>], index: usize, indices: usize) -> Vec<usize> {
    let mut marked = Vec::new();
    let mut start = 0;
    for line in lines {
        let every = line.len().div_ceil(MARKERS).max(1);
        let first = index * every / indices.max(1);
        marked.extend((first..line.len()).step_by(every).map(|i| start + i));
        // The next point is the gap.
        start += line.len() + 1;
    }
    marked
}

/// The ends of the parts of the structure, each once.
fn ends(cases: &[DrawnCase]) -> Vec<f64> {
    let snapshots = cases.iter().flat_map(|c| c.snapshots());
    let lines = snapshots.flat_map(|s| &s.profiles).flat_map(|p| &p.exact);
    let both = lines.flat_map(|line| line.first().into_iter().chain(line.last()));
    let mut ends: Vec<f64> = both.map(|point| point[0]).collect();
    ends.sort_by(f64::total_cmp);
    ends.dedup_by(|a, b| (*a - *b).abs() <= 1e-9);
    ends
}

/// The time of a row: those of the steps of the cases.
fn moment(study: &Study, cases: &[DrawnCase], row: usize) -> String {
    let mut times: Vec<f64> = cases.iter().map(|c| c.snapshots()[row].time).collect();
    times.sort_by(f64::total_cmp);
    times.dedup_by(|a, b| (*a - *b).abs() <= 1e-9);
    let title = &study.problem.schema().time.title;
    let symbol = title.strip_prefix("Time ").unwrap_or(title);
    let form = Form::of(times.iter().copied());
    let times: Vec<String> = times
        .into_iter()
        .map(|time| number::fraction(time, form))
        .collect();
    format!("{symbol} = {}", times.join(", "))
}
