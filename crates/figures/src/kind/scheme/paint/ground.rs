//! The ground that links need: walls and floors.

use super::super::arrange::join::Join;
use super::super::arrange::sizes;
use super::painter::Painter;

/// A point of the picture.
type Point = [f64; 2];

/// A surface of the ground from one point to the other, hatched on the side `away`.
pub struct GroundPlace {
    /// The points.
    pub ends: [Point; 2],
    /// See above.
    pub away: Point,
}

impl Painter<'_> {
    /// The surfaces of the ground: walls, then floors.
    pub fn ground_places(&self) -> Vec<GroundPlace> {
        let mut floors: Vec<[f64; 2]> = Vec::new();
        let mut walls: Vec<(usize, usize)> = Vec::new();
        for l in 0..self.scheme.links.len() {
            match self.relations.joins[l] {
                Join::Above(None, upper) => floors.extend(self.floor_below(l, upper)),
                Join::Beside([left, right]) if left.is_none() || right.is_none() => {
                    walls.extend(left.map(|part| (part, 1)));
                    walls.extend(right.map(|part| (part, 0)));
                }
                Join::Above(..) | Join::Beside(_) | Join::Over(..) => {}
            }
        }
        let wall = |(part, side): (usize, usize)| {
            let (x, rect) = (self.wall(part, side), self.rects[part]);
            GroundPlace {
                ends: [[x, rect.top - 2.0], [x, rect.bottom() + 2.0]],
                away: [2.0 * side as f64 - 1.0, 0.0],
            }
        };
        let mut places: Vec<GroundPlace> = walls.into_iter().map(wall).collect();
        floors.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let mut joined: Vec<[f64; 2]> = Vec::new();
        for [from, to] in floors {
            match joined.last_mut() {
                Some(last) if from < last[1] + 120.0 => last[1] = last[1].max(to),
                _ => joined.push([from, to]),
            }
        }
        let floor = |[from, to]: [f64; 2]| GroundPlace {
            ends: [[from, self.floor], [to, self.floor]],
            away: [0.0, 1.0],
        };
        places.extend(joined.into_iter().map(floor));
        places
    }

    /// The ground that a vertical link needs, from left to right.
    fn floor_below(&self, l: usize, upper: usize) -> Option<[f64; 2]> {
        let x = self.middles[l]?;
        let rect = &self.rects[upper];
        let is_led_around = self.straight(l) != Some(x);
        let is_bar = self.scheme.parts[upper].elements.is_some();
        Some(match is_bar || is_led_around {
            true => [x - 18.0, x + 18.0],
            false => [rect.left - 6.0, rect.right() + 6.0],
        })
    }

    /// Where the wall at a side of a part is.
    pub fn wall(&self, part: usize, side: usize) -> f64 {
        let width = sizes::interval(self.at_face(part, side).map(|l| &self.scheme.links[l]));
        match side {
            0 => self.rects[part].left - width,
            _ => self.rects[part].right() + width,
        }
    }

    /// Horizontal links at a side of a part.
    pub fn at_face(&self, part: usize, side: usize) -> impl Iterator<Item = usize> + '_ {
        let joins = self.relations.joins.iter().enumerate();
        joins.filter_map(move |(l, join)| match *join {
            Join::Beside(parts) => (parts[1 - side] == Some(part)).then_some(l),
            Join::Above(..) | Join::Over(..) => None,
        })
    }
}
