//! Surfaces of the ground that links of nodes need.

use super::super::symbols;
use super::labels::Labels;
use slipgap_drawing::layout::sheet::{Picture, Rect};

/// Surfaces of the ground that are nearer are one.
const ONE_GROUND: f64 = 60.0;

/// A link to the ground that needs a surface: which way it is, where, and along it.
pub struct Wall {
    /// Away from the node.
    pub away: [f64; 2],
    /// Where.
    pub at: f64,
    /// Along it.
    pub along: f64,
}

/// All of a picture.
#[derive(Default)]
pub struct Walls(pub Vec<Wall>);

impl Walls {
    /// Draws them.
    pub fn draw(&mut self, picture: &mut Picture, labels: &mut Labels) {
        self.0.sort_by(|a, b| a.along.total_cmp(&b.along));
        for away in [[-1.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, -1.0]] {
            let mut joined: Vec<([f64; 2], f64)> = Vec::new();
            for wall in self.0.iter().filter(|wall| wall.away == away) {
                match joined.last_mut() {
                    Some((range, at))
                        if wall.along < range[1] + ONE_GROUND && (wall.at - *at).abs() < 1.0 =>
                    {
                        range[1] = wall.along;
                    }
                    _ => joined.push(([wall.along; 2], wall.at)),
                }
            }
            for ([from, to], at) in joined {
                let ends = [from - 7.0, to + 7.0].map(|along| match away[1] == 0.0 {
                    true => [at, along],
                    false => [along, at],
                });
                symbols::ground(picture, ends, away);
                let [left, top] = [0, 1].map(|k| ends[0][k].min(ends[1][k]) - symbols::DEPTH);
                let lengths = [0, 1].map(|k| (ends[1][k] - ends[0][k]).abs());
                labels.taken(Rect {
                    left,
                    top,
                    width: lengths[0] + 2.0 * symbols::DEPTH,
                    height: lengths[1] + 2.0 * symbols::DEPTH,
                });
            }
        }
    }
}
