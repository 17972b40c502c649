//! Places of names between nodes and symbols.

use super::super::mesh;
use super::super::symbols::NAME_GAP;
use slipgap_drawing::layout::sheet::{Anchor, PlacedText, Rect};
use slipgap_drawing::style;
use slipgap_drawing::text::{self, markup};
use slipgap_problem::problem::structure::described::scheme::model::Model;
use slipgap_problem::problem::structure::described::scheme::picture::Link;

/// A point of the picture.
type Point = [f64; 2];

/// Most steps away from a symbol that a name may have.
const STEPS: u32 = 8;
/// Points of a line that are looked at.
const POINTS: u32 = 12;

/// Names, and what they must not cover.
pub struct Labels {
    /// The names so far.
    pub words: Vec<PlacedText>,
    symbols: Vec<Rect>,
    /// Points of the lines between nodes.
    lines: Vec<Point>,
}

impl Labels {
    /// No names among nodes.
    pub fn new(model: &Model, places: &[Point]) -> Labels {
        let mut labels = Labels {
            words: Vec::new(),
            symbols: Vec::new(),
            lines: Vec::new(),
        };
        for [a, b] in mesh::shown(model, places) {
            labels.crossed([places[a], places[b]]);
        }
        labels
    }

    /// A line takes these places.
    pub fn crossed(&mut self, [from, to]: [Point; 2]) {
        self.lines.extend((0..=POINTS).map(|i| {
            let part = f64::from(i) / f64::from(POINTS);
            [0, 1].map(|k| from[k] + part * (to[k] - from[k]))
        }));
    }

    /// A symbol takes this place.
    pub fn taken(&mut self, rect: Rect) {
        self.symbols.push(rect);
    }

    /// A name below a point, in its middle or beside it.
    pub fn below(&mut self, [x, y]: Point, text: String) {
        let y = y + NAME_GAP + style::LABEL;
        let half = text::width(&text, style::LABEL) / 2.0 + NAME_GAP;
        self.place(text, Anchor::Middle, |step| {
            let beside = [0.0, half, -half][step as usize % 3];
            [x + beside, y + 11.0 * f64::from(step / 3)]
        });
    }

    /// A name right of a point.
    pub fn near(&mut self, [x, y]: Point, text: String) {
        let y = y - NAME_GAP;
        self.place(text, Anchor::Start, |step| {
            [x + NAME_GAP, y - 5.0 * f64::from(step)]
        });
    }

    /// The names of links. Contacts of one table, such as `face.1` and `face.2`, have one name with their number.
    pub fn links(&mut self, links: &[Link], middles: &[Point]) {
        let mut tables: Vec<(&str, Vec<usize>)> = Vec::new();
        for (l, link) in links.iter().enumerate() {
            let table = link.name.split('.').next().unwrap_or_default();
            match tables.iter_mut().find(|entry| entry.0 == table) {
                Some(entry) => entry.1.push(l),
                None => tables.push((table, vec![l])),
            }
        }
        for (table, of_table) in tables.into_iter().filter(|entry| !entry.0.is_empty()) {
            let text = match of_table.as_slice() {
                [one] => markup::escape(&links[*one].name),
                _ => format!("{} ({})", markup::escape(table), of_table.len()),
            };
            let heights = of_table.iter().map(|l| middles[*l]);
            let highest = heights.reduce(|a, b| if b[1] < a[1] { b } else { a });
            let places = of_table.iter().map(|l| middles[*l]);
            let lowest = places.reduce(|a, b| if b[1] > a[1] { b } else { a });
            let (Some(high), Some(low)) = (highest, lowest) else {
                continue;
            };
            // Above, then below, ever farther away.
            self.place(text, Anchor::Middle, |step| {
                let by = 7.0 + 5.0 * f64::from(step / 2);
                match step % 2 {
                    0 => [high[0], high[1] - by],
                    _ => [low[0], low[1] + by + style::CAP_HEIGHT * style::LABEL],
                }
            });
        }
    }

    /// Puts a name at the place of the fewest collisions, the first one of equal places.
    fn place(&mut self, text: String, anchor: Anchor, at: impl Fn(u32) -> Point) {
        let size = style::LABEL;
        let length = text::width(&text, size);
        let rect = |[x, y]: Point| Rect {
            left: match anchor {
                Anchor::Start => x,
                Anchor::Middle => x - length / 2.0,
                Anchor::End => x - length,
            } - 1.0,
            top: y - 0.75 * size,
            width: length + 2.0,
            height: 0.95 * size,
        };
        let cost = |point: Point| {
            let bounds = rect(point);
            let hidden = self.symbols.iter().filter(|other| bounds.overlaps(other));
            let lines = self.lines.iter().filter(|point| bounds.contains(**point));
            1000 * hidden.count() + lines.count()
        };
        let best = (0..2 * STEPS).map(at).min_by_key(|point| cost(*point));
        let Some(at) = best else {
            return;
        };
        self.symbols.push(rect(at));
        self.words.push(PlacedText {
            at,
            anchor,
            text,
            size,
        });
    }
}
