//! The drawing at rest, as data: lengths in points, and which displacement moves what.

use serde_json::{Value, json};

/// A point of the drawing.
pub type Point = [f64; 2];

/// The displacements of the film that move a point to the right and down; `None` for one that stays.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Mover(pub Option<usize>, pub Option<usize>);

impl Mover {
    /// One that moves to the right with a displacement.
    pub fn right(channel: Option<usize>) -> Mover {
        Mover(channel, None)
    }

    fn data(self) -> Value {
        json!([self.0, self.1])
    }
}

/// A rectangle: left, top, width, height.
pub type Rect = [f64; 4];

/// The drawing.
#[derive(Debug, Clone, Default)]
pub struct Scene {
    /// Masses, with their names.
    pub masses: Vec<(Rect, Mover, String)>,
    /// Bars.
    pub bars: Vec<Bar>,
    /// Springs and contacts.
    pub links: Vec<Link>,
    /// Surfaces of the ground: from, to, the hatched side, what moves them.
    pub grounds: Vec<([Point; 2], Point, Mover)>,
    /// Forces: tail and head of an arrow.
    pub forces: Vec<([Point; 2], Mover)>,
    /// Nodes of matrices.
    pub nodes: Vec<(Point, Mover)>,
    /// Those of them of which the history has nothing, because a reduction left them out.
    pub left_out: Vec<usize>,
    /// Lines between these nodes.
    pub lines: Vec<[usize; 2]>,
    /// Other names: where, how, what moves them.
    pub words: Vec<(Point, &'static str, Mover, String)>,
    /// Pairs that must stay clear of each other: their distance at rest in points, and the displacements of the left and the
    /// right one.
    pub distances: Vec<(f64, [Option<usize>; 2])>,
}

/// A bar.
#[derive(Debug, Clone)]
pub struct Bar {
    /// Its place.
    pub rect: Rect,
    /// Its name.
    pub name: String,
    /// Displacements of evenly spaced nodes from its left to its right end.
    pub nodes: Vec<Option<usize>>,
    /// Axial forces of as many equal pieces.
    pub stresses: Vec<usize>,
}

/// A spring or a contact.
#[derive(Debug, Clone)]
pub struct Link {
    /// `spring`, `damper`, `both`, `impact` or `friction`.
    pub kind: &'static str,
    /// Place of the contact in the film; `None` for a spring.
    pub contact: Option<usize>,
    /// Name of a contact with its place.
    pub name: (String, Point, &'static str),
    /// The ends, with what moves each.
    pub ends: [(Point, Mover); 2],
    /// Direction in which an impact opens and in which friction slides, from the first to the second end.
    pub direction: Point,
    /// The distance r of an impact.
    pub opening: Option<usize>,
    /// Rods, each with the end that moves it.
    pub rods: Vec<(usize, Vec<Point>)>,
}

impl Scene {
    /// The drawing in the page.
    pub fn data(&self) -> Value {
        let masses = self.masses.iter().map(
            |(rect, mover, name)| json!({"rect": points(rect), "by": mover.data(), "name": name}),
        );
        let bars = self.bars.iter().map(|bar| {
            json!({"rect": points(&bar.rect), "name": bar.name, "nodes": bar.nodes, "stresses": bar.stresses})
        });
        let grounds = self.grounds.iter().map(|(ends, away, mover)| {
            json!({"ends": ends.map(|end| points(&end)), "away": away, "by": mover.data()})
        });
        let forces = self.forces.iter().map(
            |(arrow, mover)| json!({"arrow": arrow.map(|end| points(&end)), "by": mover.data()}),
        );
        let nodes = self
            .nodes
            .iter()
            .map(|([x, y], Mover(right, down))| json!([rounded(*x), rounded(*y), right, down]));
        let words = self.words.iter().map(|(at, align, mover, text)| {
            json!({"at": points(at), "align": align, "by": mover.data(), "text": text})
        });
        json!({
            "masses": masses.collect::<Vec<_>>(),
            "bars": bars.collect::<Vec<_>>(),
            "links": self.links.iter().map(Link::data).collect::<Vec<_>>(),
            "grounds": grounds.collect::<Vec<_>>(),
            "forces": forces.collect::<Vec<_>>(),
            "nodes": nodes.collect::<Vec<_>>(),
            "left_out": self.left_out,
            "lines": self.lines,
            "words": words.collect::<Vec<_>>(),
        })
    }

    /// Left, top, right and bottom of what is drawn at rest.
    pub fn bounds(&self) -> [f64; 4] {
        let mut found = [
            f64::INFINITY,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::NEG_INFINITY,
        ];
        let mut add = |[x, y]: Point| {
            found = [
                found[0].min(x),
                found[1].min(y),
                found[2].max(x),
                found[3].max(y),
            ];
        };
        let rects = self.masses.iter().map(|mass| mass.0);
        for [x, y, width, height] in rects.chain(self.bars.iter().map(|bar| bar.rect)) {
            add([x, y]);
            add([x + width, y + height]);
        }
        for link in &self.links {
            link.ends.iter().for_each(|end| add(end.0));
            let [x, y] = link.name.1;
            // About the height and half the length of a name.
            let half = if link.name.0.is_empty() { 0.0 } else { 12.0 };
            add([x - half, y - 8.0]);
            add([x + half, y]);
            for (_, points) in &link.rods {
                points.iter().for_each(|point| add(*point));
            }
        }
        for (ends, away, _) in &self.grounds {
            for [x, y] in ends {
                add([x + 6.0 * away[0], y + 6.0 * away[1]]);
            }
        }
        self.forces
            .iter()
            .flat_map(|force| force.0)
            .for_each(&mut add);
        self.nodes.iter().for_each(|node| add(node.0));
        self.words.iter().for_each(|word| add(word.0));
        match found[0] <= found[2] {
            true => found,
            false => [0.0, 0.0, 1.0, 1.0],
        }
    }
}

impl Link {
    fn data(&self) -> Value {
        let rods = self.rods.iter().map(|(end, points)| {
            json!([
                end,
                points
                    .iter()
                    .map(|line| self::points(line))
                    .collect::<Vec<_>>()
            ])
        });
        json!({
            "kind": self.kind,
            "contact": self.contact,
            "name": self.name.0,
            "at": points(&self.name.1),
            "align": self.name.2,
            "ends": self.ends.map(|(end, mover)| json!([points(&end), mover.data()])),
            "direction": points(&self.direction),
            "opening": self.opening,
            "rods": rods.collect::<Vec<_>>(),
        })
    }
}

/// Lengths in hundredths of a point.
pub fn points(lengths: &[f64]) -> Vec<f64> {
    lengths.iter().map(|x| rounded(*x)).collect()
}

fn rounded(x: f64) -> f64 {
    // No minus before 0.
    (100.0 * x).round() / 100.0 + 0.0
}
