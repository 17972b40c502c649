//! The legend: in free corners of the panels, or in lines over them.

use crate::layout::sheet::{Entry, Panel, Rect, Series, Sheet};
use crate::layout::{clip, inset};
use crate::style::{self, Marker, Stroke};
use crate::text;

/// An entry of the legend without its place.
#[derive(Debug, Clone, PartialEq)]
pub struct Key {
    /// Label in markup.
    pub label: String,
    /// Pattern of the line.
    pub stroke: Stroke,
    /// Width of the line.
    pub width: f64,
    /// Marker on the line.
    pub marker: Option<Marker>,
}

impl Key {
    /// The key of a curve.
    pub fn of(series: &Series) -> Key {
        Key {
            label: series.label.clone(),
            stroke: series.stroke,
            width: series.width,
            marker: series.marker,
        }
    }

    /// The key of thin lines other than curves, such as the ends of the bars.
    pub fn thin(label: &str) -> Key {
        Key {
            label: label.into(),
            stroke: Stroke::Solid,
            width: style::ZERO_LINE,
            marker: None,
        }
    }

    /// Length of the piece of line with its label.
    pub fn length(&self) -> f64 {
        style::SAMPLE + style::SAMPLE_GAP + text::width(&self.label, style::LABEL)
    }

    /// As many lines as the label needs up to `right`, the first with the piece of line.
    fn lines(&self, [x, y]: [f64; 2], right: f64) -> Vec<Entry> {
        let room = right - x - style::SAMPLE - style::SAMPLE_GAP;
        let lines = text::wrap(&self.label, style::LABEL, room);
        let line = |(i, label): (usize, String)| Entry {
            label,
            ..match i {
                0 => self.placed([x, y]),
                _ => Entry {
                    width: 0.0,
                    marker: None,
                    ..self.placed([x, y + i as f64 * style::LEADING])
                },
            }
        };
        lines.into_iter().enumerate().map(line).collect()
    }

    fn placed(&self, at: [f64; 2]) -> Entry {
        Entry {
            at,
            label: self.label.clone(),
            stroke: self.stroke,
            width: self.width,
            marker: self.marker,
        }
    }
}

/// An entry for each label of the series of panels, in their order.
pub fn keys(panels: &[Panel]) -> Vec<Key> {
    let mut keys: Vec<Key> = Vec::new();
    let series = panels.iter().flat_map(|panel| &panel.series);
    for series in series.filter(|series| !series.label.is_empty()) {
        if !keys.iter().any(|key| key.label == series.label) {
            keys.push(Key::of(series));
        }
    }
    keys
}

/// Gives a curve that is one point a marker, and its key no line unless it is a line in another panel.
pub fn mark_single_points(panels: &mut [Panel], keys: &mut [Vec<Key>]) {
    for key in keys.iter_mut().flatten().filter(|key| key.width > 0.0) {
        let (mut has_line, mut single) = (false, None);
        let curves = panels.iter_mut().flat_map(|panel| &mut panel.series);
        for series in curves.filter(|series| series.label == key.label) {
            let is_there = |i: &usize| series.points[*i].iter().all(|x| x.is_finite());
            let points: Vec<usize> = (0..series.points.len()).filter(is_there).collect();
            match points.len() {
                0 => {}
                1 => {
                    let marker = *series.marker.get_or_insert(Marker::Circle);
                    (single, series.marked) = (Some(marker), points);
                }
                _ => has_line = true,
            }
        }
        if let (Some(marker), false) = (single, has_line) {
            (key.width, key.marker) = (0.0, Some(marker));
        }
    }
}

/// A legend in rows of `columns` keys, each `width` wide, from its upper left corner.
pub fn rows(keys: &[Key], [left, top]: [f64; 2], columns: usize, width: f64) -> Vec<Entry> {
    let entry = |(i, key): (usize, &Key)| {
        let [row, column] = [i / columns, i % columns].map(|k| k as f64);
        key.placed([left + column * width, top + (row + 0.5) * style::LEADING])
    };
    keys.iter().enumerate().map(entry).collect()
}

/// The legends in free corners of their panels; `None` if a panel has none.
pub fn within(panels: &[Panel], keys: &[Vec<Key>]) -> Option<Vec<Entry>> {
    let pairs = keys.iter().zip(panels);
    let found = pairs.map(|(keys, panel)| free_corner(panel, keys));
    let corners: Vec<Rect> = found.collect::<Option<_>>()?;
    let placed = keys.iter().zip(corners).flat_map(|(keys, corner)| {
        let line = move |(i, key): (usize, &Key)| {
            let top = corner.top + (i as f64 + 0.5) * style::LEADING;
            key.placed([corner.left, top])
        };
        keys.iter().enumerate().map(line)
    });
    Some(placed.collect())
}

/// A place for the legend of a panel where it covers nothing.
fn free_corner(panel: &Panel, keys: &[Key]) -> Option<Rect> {
    let width = keys.iter().map(Key::length).fold(0.0, f64::max);
    let height = keys.len() as f64 * style::LEADING;
    let away = style::MAJOR_TICK + 4.0;
    let inner = panel.frame.inflated(-away);
    let lefts = [
        inner.right() - width,
        inner.left,
        inner.left + (inner.width - width) / 2.0,
    ];
    let tops = [inner.top, inner.bottom() - height];
    let places = tops.iter().flat_map(|top| {
        lefts.iter().map(|left| Rect {
            left: *left,
            top: *top,
            width,
            height,
        })
    });
    places
        .filter(|rect| rect.left >= inner.left && rect.top >= inner.top)
        .find(|rect| is_free(panel, &rect.inflated(3.0)))
}

/// Whether nothing is drawn in an area of a panel.
pub fn is_free(panel: &Panel, area: &Rect) -> bool {
    let clear = |a: [f64; 2], b: [f64; 2]| clip::segment(a, b, area).is_none();
    let zero = panel.x.range.map(|x| panel.place([x, 0.0]));
    if panel.map.is_some() || (panel.zero && !clear(zero[0], zero[1])) {
        return false;
    }
    let with_markers = area.inflated(style::MARKER + 1.0);
    let notes = panel
        .notes
        .iter()
        .all(|words| !area.overlaps(&words.area()));
    let arrows = panel
        .arrows
        .iter()
        .all(|[a, b]| clear(panel.place(*a), panel.place(*b)));
    let bands = panel.bands.iter().all(|band| {
        let outline = band.upper.iter().chain(band.lower.iter().rev());
        let round: Vec<_> = outline.map(|point| panel.place(*point)).collect();
        clip::polygon(&round, area).len() < 3
    });
    let inset = panel.inset.as_ref().is_none_or(|inset| {
        let joins = inset::joins(panel, inset);
        let lines = joins.iter().flat_map(|line| line.windows(2));
        !inset::area(inset).overlaps(area) && { lines }.all(|pair| clear(pair[0], pair[1]))
    });
    notes
        && arrows
        && inset
        && bands
        && panel.series.iter().all(|series| {
            let places: Vec<_> = series.points.iter().map(|p| panel.place(*p)).collect();
            places.windows(2).all(|pair| clear(pair[0], pair[1]))
                && series
                    .marked
                    .iter()
                    .all(|i| !with_markers.contains(places[*i]))
        })
}

/// The legends in lines over their panels, and how far these must move down for them.
pub fn over(sheet: &Sheet, keys: &[Vec<Key>]) -> (Vec<Entry>, f64) {
    let alone = keys.len() == 1;
    let mut entries = Vec::new();
    let mut lowest = 0.0_f64;
    for (keys, panel) in keys.iter().zip(&sheet.panels) {
        let left = panel.frame.left;
        let right = if alone {
            sheet.width - style::EDGE
        } else {
            panel.frame.right()
        };
        let (mut x, mut y) = (left, style::EDGE + style::LEADING / 2.0);
        for key in keys {
            let length = key.length();
            if x > left && x + length > right {
                x = left;
                y += style::LEADING;
            }
            entries.extend(key.lines([x, y], right));
            y = entries.last().map_or(y, |entry| entry.at[1]);
            lowest = lowest.max(y);
            x += length + 14.0;
        }
    }
    (entries, lowest + style::LEADING / 2.0 - style::EDGE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::ticks;

    #[test]
    fn a_curve_that_is_one_point_has_the_key_of_a_point() {
        let curve = |label: &str, points: &[[f64; 2]]| Series {
            label: label.into(),
            ..Series::exact(points.to_vec())
        };
        let axis = || ticks::linear("", [0.0, 1.0], 5.0);
        let gap = [0.5, f64::NAN];
        let mut panel = Panel::new(Rect::default(), 0.0, axis(), axis());
        panel.series = vec![
            curve("line", &[[0.0, 0.0], [1.0, 1.0]]),
            curve("point", &[gap, [0.5, 0.5]]),
            curve("nothing", &[gap]),
        ];
        let mut other = panel.clone();
        let mut keys = vec![keys(std::slice::from_ref(&panel))];
        mark_single_points(std::slice::from_mut(&mut panel), &mut keys);
        let looks: Vec<_> = keys[0]
            .iter()
            .map(|key| (key.width > 0.0, key.marker))
            .collect();
        assert_eq!(
            looks,
            [(true, None), (false, Some(Marker::Circle)), (true, None)]
        );
        assert_eq!(
            (panel.series[1].marker, &panel.series[1].marked[..]),
            (Some(Marker::Circle), &[1][..])
        );
        assert_eq!(panel.series[0].marker, None);
        // It is a line in another panel, and has that key.
        other.series[1] = curve("point", &[[0.0, 1.0], [1.0, 0.0]]);
        let mut panels = [panel, other];
        panels[0].series[1].marker = None;
        let mut both = vec![super::keys(&panels)];
        mark_single_points(&mut panels, &mut both);
        assert!(both[0][1].width > 0.0 && both[0][1].marker.is_none());
        assert_eq!(panels[0].series[1].marker, Some(Marker::Circle));
        assert_eq!(panels[1].series[1].marker, None);
    }
}
