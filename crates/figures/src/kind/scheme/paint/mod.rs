//! Draws a scheme: its parts and symbols.

pub(super) mod around;
pub(super) mod attach;
pub(super) mod bars_and_masses;
pub(super) mod between_supports;
pub(super) mod ground;
pub(super) mod ground_motion;
pub(super) mod joints;
pub(super) mod links;
pub(super) mod loads;
pub(super) mod painter;

use super::arrange::columns;
use super::arrange::relations::Relations;
use super::nodes::places::Placed;
use painter::Painter;
use slipgap_drawing::layout::sheet::{Anchor, Picture, Shape};
use slipgap_drawing::text;
use slipgap_problem::problem::structure::described::scheme::picture::Scheme;

/// The horizontal and the vertical axis of a structure without places: its row along X.
const ROW: [usize; 2] = [0, 2];

/// The picture of a scheme with its upper left corner at 0, and its size.
pub fn paint(scheme: &Scheme) -> (Picture, [f64; 2]) {
    let (drawn, axes) = with_places(scheme, |mut painter, placed| {
        painter.parts();
        painter.links();
        painter.joints();
        painter.loads();
        if let Some(placed) = placed {
            painter.nodes(placed);
        }
        (painter.picture, placed.map_or(ROW, |placed| placed.axes))
    });
    let (mut alone, [width, _]) = boxed(drawn);
    between_supports::draw(&mut alone, width, scheme);
    let (mut picture, mut size) = boxed(alone);
    if !scheme.ground.is_empty() {
        size[1] = ground_motion::draw(&mut picture, size, &scheme.ground, axes);
    }
    (picture, size)
}

/// The result of `draw` for a painter that knows the places of the parts and has drawn nothing, and the matrices with places.
pub fn with_places<T>(scheme: &Scheme, draw: impl FnOnce(Painter<'_>, Option<&Placed>) -> T) -> T {
    let placed = Placed::of(scheme);
    let scheme = placed.as_ref().map_or(scheme, |placed| &placed.outer);
    let relations = Relations::of(scheme);
    let (sizes, left) = columns::place(scheme, &relations);
    let mut painter = Painter {
        scheme,
        relations: &relations,
        sizes: &sizes,
        rects: Vec::new(),
        floor: 0.0,
        middles: Vec::new(),
        joined: Vec::new(),
        picture: Picture::default(),
    };
    painter.stack(&left);
    painter.middles = painter.vertical();
    draw(painter, placed.as_ref())
}

/// The picture with its upper left corner at 0, and its size.
fn boxed(mut picture: Picture) -> (Picture, [f64; 2]) {
    let mut corners: Vec<[f64; 2]> = Vec::new();
    for shape in &picture.shapes {
        match shape {
            Shape::Line(points, _) => corners.extend(points),
            Shape::Box(rect, _) => {
                corners.extend([[rect.left, rect.top], [rect.right(), rect.bottom()]])
            }
            Shape::Arrow(ends) | Shape::DoubleArrow(ends) => corners.extend(ends),
        }
    }
    for words in &picture.words {
        let length = text::width(&words.text, words.size);
        let start = match words.anchor {
            Anchor::Start => words.at[0],
            Anchor::Middle => words.at[0] - length / 2.0,
            Anchor::End => words.at[0] - length,
        };
        corners.extend([
            [start, words.at[1] - 0.8 * words.size],
            [start + length, words.at[1] + 0.25 * words.size],
        ]);
    }
    let [mut low, mut high] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    for corner in corners {
        for k in 0..2 {
            low[k] = low[k].min(corner[k]);
            high[k] = high[k].max(corner[k]);
        }
    }
    // Half a line at every side.
    let low = low.map(|x| if x.is_finite() { x - 1.0 } else { 0.0 });
    let size = [0, 1].map(|k| (high[k] + 1.0 - low[k]).max(1.0));
    transform(&mut picture, 1.0, [-low[0], -low[1]]);
    (picture, size)
}

/// The picture smaller by a factor, with its corner at a place.
pub fn transform(picture: &mut Picture, factor: f64, [left, top]: [f64; 2]) {
    let moved = |[x, y]: [f64; 2]| [left + factor * x, top + factor * y];
    for shape in &mut picture.shapes {
        match shape {
            Shape::Line(points, width) => {
                points.iter_mut().for_each(|point| *point = moved(*point));
                *width *= factor;
            }
            Shape::Box(rect, _) => {
                [rect.left, rect.top] = moved([rect.left, rect.top]);
                rect.width *= factor;
                rect.height *= factor;
            }
            Shape::Arrow(ends) | Shape::DoubleArrow(ends) => *ends = ends.map(moved),
        }
    }
    for words in &mut picture.words {
        words.at = moved(words.at);
        words.size *= factor;
    }
}
