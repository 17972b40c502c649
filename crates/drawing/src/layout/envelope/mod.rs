//! Bands instead of curves that oscillate too fast to draw: their places and edges.
//!
//! Turns are those of the curve on the sheet. A turn counts if the curve swings farther than strokes
//! are apart. Where `PERIODS` periods in a row are shorter than a pixel, so that it has more than two extremes, a band replaces the
//! curve, as far as periods are hardly longer. Its edges are hulls of the points, so the band contains every point and touches every
//! peak.

#[cfg(test)]
mod tests;

use crate::layout;
use crate::layout::sheet::{Envelope, Panel, Sheet};
use crate::style::{self, Stroke};

/// How much longer than a pixel periods may be along a band, so that it does not break where they are near it.
const LONGER: f64 = 1.1;

/// Least swing between turns, in line widths: a lower one is not dense.
const SWING: f64 = 2.0;

/// Periods in a row that make a band: fewer strokes can be distinguished.
const PERIODS: usize = 5;

/// Ratio of the two swings of the first and last period of a band at most: a jump or a shoulder is no oscillation.
const ALIKE: f64 = 2.0;

/// Width of the columns whose highest and lowest points the edges join, in pixels: each has a peak.
const COLUMN: f64 = 2.0;

/// What a band of a black curve means.
pub const MEANING: &str = "Band: between the envelopes of an oscillation too dense to draw; its edges have the dashes of \
                     its curve.";

/// What a band of a curve in colour means.
pub const IN_COLOUR: &str =
    "Band: between the envelopes of an oscillation too dense to draw, in the colour of its curve.";

/// Most curves of a panel with filled bands; of others only the edges are drawn.
const MOST_FILLED: usize = 2;

/// Finds the bands of a finished sheet with `dpi` pixels an inch, and adds their meaning under it.
pub fn find(sheet: &mut Sheet, dpi: u32) {
    let pixel = 1.0 / style::pixels(dpi);
    for panel in &mut sheet.panels {
        panel.envelopes = of(panel, pixel);
        if let Some(inset) = &mut panel.inset {
            inset.envelopes = of(inset, pixel);
        }
    }
    if let Some(meaning) = meaning(sheet) {
        layout::small_print(sheet, meaning);
    }
}

/// What the bands of a sheet mean; `None` if it has none.
pub fn meaning(sheet: &Sheet) -> Option<&'static str> {
    let band = |panel: &Panel| {
        panel
            .envelopes
            .first()
            .map(|band| panel.series[band.series].stroke)
    };
    let stroke = sheet.panels_and_insets().find_map(band)?;
    Some(match stroke.hatching() {
        [] => IN_COLOUR,
        _ => MEANING,
    })
}

/// The bands of a panel that are filled.
pub fn filled(panel: &Panel) -> impl Iterator<Item = &Envelope> {
    let mut curves: Vec<usize> = Vec::new();
    panel.envelopes.iter().filter(move |band| {
        if !curves.contains(&band.series) && curves.len() < MOST_FILLED {
            curves.push(band.series);
        }
        curves.contains(&band.series)
    })
}

/// The bands of a panel, the largest first, so that none hides another.
fn of(panel: &Panel, pixel: f64) -> Vec<Envelope> {
    let mut found: Vec<(f64, Envelope)> = Vec::new();
    // A band of noise would look like an oscillation.
    let curves = panel.series.iter().enumerate();
    for (series, curve) in curves.filter(|(_, curve)| curve.stroke != Stroke::Grey) {
        let places: Vec<[f64; 2]> = curve.points.iter().map(|p| panel.place(*p)).collect();
        for (first, last) in runs(&places) {
            let run = &places[first..=last];
            for (from, to) in stretches(run, &turns(run, SWING * curve.width), pixel) {
                let edge = |side| edge(&places, [first + from, first + to], pixel, side);
                let (upper, lower) = (edge(-1.0), edge(1.0));
                let area = under(&places, &lower) - under(&places, &upper);
                let envelope = Envelope {
                    series,
                    upper,
                    lower,
                };
                found.push((area, envelope));
            }
        }
    }
    found.sort_by(|a, b| b.0.total_cmp(&a.0));
    found.into_iter().map(|(_, envelope)| envelope).collect()
}

/// The parts of a curve that no band replaces: all of it where there is none.
pub fn drawn(envelopes: &[Envelope], series: usize, places: &[[f64; 2]]) -> Vec<Vec<[f64; 2]>> {
    let bands = envelopes.iter().filter(|band| band.series == series);
    let mut hidden: Vec<(usize, usize)> = bands
        .filter_map(|band| Some((*band.upper.first()?, *band.upper.last()?)))
        .collect();
    hidden.sort_unstable();
    let starts = std::iter::once(0).chain(hidden.iter().map(|(_, to)| *to));
    let end = places.len().saturating_sub(1);
    let ends = hidden.iter().map(|(from, _)| *from).chain([end]);
    let parts = starts.zip(ends).filter_map(|(a, b)| places.get(a..=b));
    parts.map(<[_]>::to_vec).collect()
}

/// First and last points of the parts of a curve that have a place and go from left to right.
fn runs(places: &[[f64; 2]]) -> Vec<(usize, usize)> {
    let has_place = |p: &[f64; 2]| p.iter().all(|v| v.is_finite());
    let mut runs: Vec<(usize, usize)> = Vec::new();
    for (i, point) in places.iter().enumerate().filter(|(_, p)| has_place(p)) {
        match runs.last_mut() {
            Some((_, last)) if *last + 1 == i && places[*last][0] <= point[0] => *last = i,
            _ => runs.push((i, i)),
        }
    }
    runs
}

/// The points where a curve turns, between swings of at least `swing`; its ends are no turns.
fn turns(places: &[[f64; 2]], swing: f64) -> Vec<usize> {
    let mut turns = Vec::new();
    // Extreme points since the last turn, and whether the curve falls or rises since then.
    let (mut least, mut greatest) = (0, 0);
    let mut rises: Option<bool> = None;
    for (i, [_, y]) in places.iter().enumerate() {
        if *y < places[least][1] {
            least = i;
        }
        if *y > places[greatest][1] {
            greatest = i;
        }
        if rises != Some(false) && places[greatest][1] - y >= swing {
            turns.push(greatest);
            (rises, least) = (Some(false), i);
        } else if rises != Some(true) && y - places[least][1] >= swing {
            turns.push(least);
            (rises, greatest) = (Some(true), i);
        }
    }
    turns.retain(|turn| *turn > 0);
    turns
}

/// First and last points of the stretches with periods shorter than a pixel.
fn stretches(places: &[[f64; 2]], turns: &[usize], shortest: f64) -> Vec<(usize, usize)> {
    let room = |a: usize, b: usize| places[turns[b]][0] - places[turns[a]][0];
    // First and last turn, and whether periods are too short somewhere between them.
    let mut stretches: Vec<(usize, usize, bool)> = Vec::new();
    // The mean period of several, because points next to a peak move each turn a little.
    for to in 2 * PERIODS..turns.len() {
        let from = to - 2 * PERIODS;
        let period = room(from, to) / PERIODS as f64;
        // Not across a stroke that can be seen between dense ones.
        let stroke = |turn| room(turn, turn + 1) >= shortest;
        if period >= LONGER * shortest || (from..to).any(stroke) {
            continue;
        }
        let dense = period < shortest;
        match stretches.last_mut() {
            Some((_, end, before)) if from <= *end => (*end, *before) = (to, *before || dense),
            _ => stretches.push((from, to, dense)),
        }
    }
    let swing = |a: usize| (places[turns[a + 1]][1] - places[turns[a]][1]).abs();
    let alike = |a: f64, b: f64| a <= ALIKE * b && b <= ALIKE * a;
    // Whether the period from turn `a` on may be the first or last of a band.
    let fits = |a: usize| room(a, a + 2) < LONGER * shortest && alike(swing(a), swing(a + 1));
    let dense = stretches.into_iter().filter(|(.., dense)| *dense);
    let trimmed = dense.filter_map(|(mut from, mut to, _)| {
        while to >= from + 2 && !fits(from) {
            from += 1;
        }
        while to >= from + 2 && !fits(to - 2) {
            to -= 1;
        }
        (to >= from + 2 * PERIODS).then(|| (turns[from], turns[to]))
    });
    trimmed.collect()
}

/// The points of one edge of a band, `side` -1 for the upper one and 1 for the lower one: hulls between the extreme
/// points of neighbouring columns.
fn edge(places: &[[f64; 2]], [from, to]: [usize; 2], pixel: f64, side: f64) -> Vec<usize> {
    let column = |i: usize| (places[i][0] / (COLUMN * pixel)).floor();
    let mut knots = vec![from];
    for i in from + 1..to {
        match knots.last_mut() {
            Some(last) if *last > from && column(*last) == column(i) => {
                if side * places[i][1] > side * places[*last][1] {
                    *last = i;
                }
            }
            _ => knots.push(i),
        }
    }
    knots.push(to);
    let mut edge = vec![from];
    for pair in knots.windows(2) {
        let start = edge.len() - 1;
        for i in pair[0] + 1..=pair[1] {
            while let [.., a, b] = edge[start..] {
                let [[ax, ay], [bx, by], [cx, cy]] = [places[a], places[b], places[i]];
                // Whether the middle one of three points lies inside of the line through the others.
                if side * ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) < 0.0 {
                    break;
                }
                edge.pop();
            }
            edge.push(i);
        }
    }
    edge
}

/// The area between a line through points and the upper edge of the sheet.
fn under(places: &[[f64; 2]], line: &[usize]) -> f64 {
    let piece = |pair: &[usize]| {
        let [[ax, ay], [bx, by]] = [places[pair[0]], places[pair[1]]];
        (bx - ax) * (ay + by) / 2.0
    };
    line.windows(2).map(piece).sum()
}
