//! Draws the forces on parts.

use super::super::symbols;
use super::painter::Painter;
use slipgap_drawing::layout::sheet::Shape;
use slipgap_problem::problem::structure::described::scheme::picture::{End, Place};

/// Length of an arrow.
const FORCE: f64 = 22.0;

/// A point of the picture.
type Point = [f64; 2];

/// A force on a part.
pub struct LoadPlace {
    /// The end that it acts on.
    pub end: End,
    /// From its tail to its head.
    pub arrow: [Point; 2],
    /// A post on the part that carries it.
    pub post: Option<[Point; 2]>,
    /// Where its end is at the part.
    pub at: Point,
}

impl Painter<'_> {
    /// An arrow for each load: at a free face of its part, or over it.
    pub fn loads(&mut self) {
        for load in self.load_places() {
            if let Some(post) = load.post {
                let post = Shape::Line(post.to_vec(), symbols::OUTLINE);
                self.picture.shapes.push(post);
            }
            self.picture.shapes.push(Shape::Arrow(load.arrow));
            if let End::Part(part, Place::Dof(dof)) = load.end {
                self.attach_dof(part, dof, load.at);
            }
        }
    }

    /// Where the loads are.
    pub fn load_places(&self) -> Vec<LoadPlace> {
        let mut done: Vec<(usize, usize)> = Vec::new();
        let mut places = Vec::new();
        for load in &self.scheme.loads {
            let End::Part(part, at) = *load else {
                continue;
            };
            let rect = self.rects[part];
            let is_free = |side: usize| {
                let shown = done.contains(&(part, side));
                !shown && self.at_face(part, side).next().is_none()
            };
            let middle = rect.top + rect.height / 2.0;
            let side = match at {
                Place::Left | Place::Mass | Place::Dof(_) if is_free(0) => 0,
                Place::Right | Place::Mass | Place::Dof(_) if is_free(1) => 1,
                Place::Left | Place::Right | Place::Mass | Place::Inner(_) | Place::Dof(_) => 2,
            };
            done.push((part, side));
            let mut post = None;
            let arrow = match (side, at) {
                (0, _) => [[rect.left - FORCE, middle], [rect.left - 0.5, middle]],
                (1, _) => [[rect.right(), middle], [rect.right() + FORCE, middle]],
                (_, at) => {
                    let x = match at {
                        Place::Left => rect.left + 4.0,
                        Place::Right | Place::Mass | Place::Dof(_) => rect.right() - 4.0,
                        Place::Inner(part) => rect.left + part * rect.width,
                    };
                    let y = rect.top - 7.0;
                    post = Some([[x, rect.top], [x, y]]);
                    [[x, y], [x + FORCE, y]]
                }
            };
            places.push(LoadPlace {
                end: *load,
                arrow,
                post,
                at: match side {
                    0 => [rect.left, middle],
                    1 => [rect.right(), middle],
                    _ => [rect.right() - 4.0, rect.top],
                },
            });
        }
        places
    }
}
