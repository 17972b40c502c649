//! Curves that would hide one another: which is drawn first, and how two that coincide are seen as two.

mod cells;
#[cfg(test)]
mod tests;

use crate::layout;
use crate::layout::clip::{self, Line};
use crate::layout::sheet::{Gap, Panel, Series, Sheet};
use crate::style::{self, Marker, Stroke};
use cells::{Cells, LEAST, Path, distance};

/// Distance of the markers of black curves that coincide.
const APART: f64 = 60.0;

/// A dash longer than this is seen: 3 mm.
const SEEN: f64 = 3.0 * 72.0 / 25.4;

/// What alternating dashes mean.
pub const MEANING: &str = "Alternating dashes: curves that coincide.";

/// Finds where the curves of a finished sheet coincide, and adds what their dashes mean under it.
pub fn find(sheet: &mut Sheet) {
    for panel in &mut sheet.panels {
        let curves: Vec<bool> = panel.series.iter().map(is_curve).collect();
        panel.gaps = gaps(panel, &curves);
        if let Some(inset) = &mut panel.inset {
            inset.gaps = gaps(inset, &curves);
        }
        for (label, marker) in mark(panel) {
            let entries = sheet.legend.iter_mut();
            let with_label = entries.filter(|entry| entry.label == label);
            with_label.for_each(|entry| entry.marker = Some(marker));
        }
    }
    if let Some(meaning) = meaning(sheet) {
        layout::small_print(sheet, meaning);
    }
}

/// What the dashes of a sheet mean; `None` if it has none that are seen.
pub fn meaning(sheet: &Sheet) -> Option<&'static str> {
    let mut gaps = sheet.panels_and_insets().flat_map(|panel| &panel.gaps);
    gaps.any(|gap| gap.ends[1] - gap.ends[0] > SEEN)
        .then_some(MEANING)
}

/// The curves of a panel in the order in which they are drawn: the longest of the dense ones first, because other lines are seen on
/// them, but they hide others.
pub fn order(panel: &Panel) -> Vec<usize> {
    let cells = Cells::of(panel);
    let extent = |series: &Series| match cells.is_long(panel, series) {
        true => cells.dense(&cells.path(panel, series)).unwrap_or(0.0),
        false => 0.0,
    };
    let extents: Vec<f64> = panel.series.iter().map(extent).collect();
    let mut order: Vec<usize> = (0..extents.len()).collect();
    order.sort_by(|a, b| extents[*b].total_cmp(&extents[*a]));
    order
}

/// The dashes of the visible lines of a curve: its own, and those in turn where it coincides with others.
pub fn dashes(panel: &Panel, series: usize, lines: &[Line]) -> Vec<Line> {
    let gaps: Vec<&Gap> = panel
        .gaps
        .iter()
        .filter(|gap| gap.series == series)
        .collect();
    let pattern = panel.series[series].stroke.pattern();
    let banded = panel.envelopes.iter().any(|band| band.series == series);
    if gaps.is_empty() || banded {
        return lines
            .iter()
            .flat_map(|line| clip::dashes(line, pattern))
            .collect();
    }
    let ends = gaps.iter().map(|gap| gap.ends);
    let starts = std::iter::once(0.0).chain(ends.clone().map(|[_, to]| to));
    let ends = ends.map(|[from, _]| from).chain([f64::INFINITY]);
    let parts: Vec<[f64; 2]> = starts.zip(ends).map(|(from, to)| [from, to]).collect();
    clip::between(lines, &parts)
}

/// The points of a line at equal distances, the first at the part `first` of one.
pub fn at_distances(places: &[[f64; 2]], spacing: f64, first: f64) -> Vec<usize> {
    let mut marked = Vec::new();
    let (mut next, mut reached) = (spacing * first, 0.0);
    for (i, pair) in places.windows(2).enumerate() {
        reached += Some(distance(pair[0], pair[1]))
            .filter(|d| d.is_finite())
            .unwrap_or(0.0);
        if reached >= next {
            marked.push(i + 1);
            next += spacing * ((reached - next) / spacing).floor() + spacing;
        }
    }
    marked
}

/// Whether it is a curve, and no rule, order, contour, interval or thin grey background.
pub fn is_curve(series: &Series) -> bool {
    let in_colour = matches!(series.stroke, Stroke::Colour(_) | Stroke::Graded(_));
    let least = match series.stroke {
        Stroke::Grey => style::MEASURED_LINE,
        _ if in_colour && series.label.is_empty() => style::CASE_LINE,
        Stroke::Solid
        | Stroke::Dashed
        | Stroke::DashDot
        | Stroke::Dotted
        | Stroke::DashDotDot
        | Stroke::LongDash
        | Stroke::Graded(_)
        | Stroke::Colour(_) => f64::MIN_POSITIVE,
    };
    series.width >= least && (!series.label.is_empty() || in_colour)
}

/// A curve with the cells along it and those that its line covers.
struct Covering {
    series: usize,
    path: Path,
    covered: Vec<bool>,
    /// Of a dense one the cells without those of an oscillation, in which any other curve would coincide with it.
    thin: Option<Vec<bool>>,
}

impl Covering {
    /// The cells in which another curve coincides with it. In two oscillations any parts do, unless one is nearly everywhere in the
    /// other.
    fn cells(&self, other: &Covering) -> &[bool] {
        let is_in = |a: &Covering, b: &Covering| a.path.is_in(&b.covered);
        match (&self.thin, &other.thin) {
            (Some(_), Some(_)) if is_in(self, other) || is_in(other, self) => &self.covered,
            (Some(thin), _) => thin,
            (None, _) => &self.covered,
        }
    }
}

/// The curves of a panel in the order of drawing, if they are more than one.
fn covering(panel: &Panel, curves: &[bool]) -> Vec<Covering> {
    let order = Vec::from_iter(order(panel).into_iter().filter(|k| curves[*k]));
    let cells = Cells::of(panel);
    let of = |series: &usize| {
        let path = cells.path(panel, &panel.series[*series]);
        let covered = cells.covered(&path);
        let dense = cells.dense(&path);
        Covering {
            series: *series,
            thin: dense.map(|_| cells.thin(&path, &covered)),
            path,
            covered,
        }
    };
    match order.len() {
        0 | 1 => Vec::new(),
        _ => order.iter().map(of).collect(),
    }
}

/// The parts of the curves of a panel that are not drawn, because curves under them show there.
fn gaps(panel: &Panel, curves: &[bool]) -> Vec<Gap> {
    let (cells, coverings) = (Cells::of(panel), covering(panel, curves));
    // Whether dashes in turn can tell two curves apart.
    let alternate = |under: &Covering, over: &Covering| {
        let [a, b] = [under, over].map(|covering| &panel.series[covering.series]);
        let open = b.stroke.pattern().is_empty() && a.width < 2.0 * b.width;
        let apart = a.stroke.colour() != b.stroke.colour();
        open && apart
    };
    let mut gaps = Vec::new();
    for (j, covering) in coverings.iter().enumerate() {
        let lower = coverings[..j]
            .iter()
            .filter(|under| alternate(under, covering));
        let under: Vec<&[bool]> = lower.map(|under| under.cells(covering)).collect();
        let upper = coverings[j + 1..]
            .iter()
            .filter(|over| alternate(covering, over));
        let over: Vec<&[bool]> = upper.map(|over| over.cells(covering)).collect();
        if under.is_empty() {
            continue;
        }
        let ends = cells.shown_by_others(&covering.path, [&under, &over]);
        let series = covering.series;
        gaps.extend(ends.into_iter().map(|ends| Gap { series, ends }));
    }
    gaps
}

/// Gives black curves without markers that coincide nearly everywhere markers in turn; the label and marker of each.
fn mark(panel: &mut Panel) -> Vec<(String, Marker)> {
    let is_bare = |series: &Series| {
        is_curve(series) && series.marker.is_none() && series.stroke.colour() == [0; 3]
    };
    let bare: Vec<bool> = panel.series.iter().map(is_bare).collect();
    let coverings = covering(panel, &bare);
    let coincide = |a: &Covering, b: &Covering| {
        let widths = [a, b].map(|covering| panel.series[covering.series].width);
        widths[0] == widths[1] && a.path.length >= LEAST && a.path.is_in(&b.covered)
    };
    let others = |(i, covering): (usize, &Covering)| {
        let under = coverings[..i].iter().any(|under| coincide(under, covering));
        let over = coverings[i + 1..]
            .iter()
            .any(|over| coincide(covering, over));
        (under || over).then_some(covering.series)
    };
    let group: Vec<usize> = coverings.iter().enumerate().filter_map(others).collect();
    let mut given = Vec::new();
    for (turn, k) in group.iter().enumerate() {
        let series = &panel.series[*k];
        let places: Vec<[f64; 2]> = series.points.iter().map(|p| panel.place(*p)).collect();
        let first = (turn as f64 + 0.5) / group.len() as f64;
        let marked = at_distances(&places, APART, first);
        let series = &mut panel.series[*k];
        let marker = Marker::of_case(turn);
        (series.marker, series.marked) = (Some(marker), marked);
        given.push((series.label.clone(), marker));
    }
    given
}
