//! How far what is at the faces of a part reaches.

use super::super::symbols;
use super::join::Join;
use super::relations::Relations;
use super::sizes::interval;
use slipgap_problem::problem::structure::described::scheme::picture::{End, Place, Scheme};

/// Room for an arrow at a face.
const ARROW: f64 = 26.0;

/// What is at the faces of a part besides other parts.
pub fn reach(scheme: &Scheme, relations: &Relations, part: usize, side: usize) -> f64 {
    let at_face = |join: &Join| match *join {
        Join::Beside(parts) => parts[1 - side] == Some(part) && parts[side].is_none(),
        Join::Above(..) | Join::Over(..) => false,
    };
    let links = scheme.links.iter().zip(&relations.joins);
    let lanes = interval(
        links
            .filter(|(_, join)| at_face(join))
            .map(|(link, _)| link),
    );
    let wall = if lanes > 0.0 {
        lanes + symbols::DEPTH
    } else {
        0.0
    };
    let loaded =
        |end: &End| matches!(*end, End::Part(loaded, at) if loaded == part && at_side(at, side));
    match scheme.loads.iter().any(loaded) {
        true => wall.max(ARROW),
        false => wall,
    }
}

/// Whether an arrow at this place may be at a side.
fn at_side(at: Place, side: usize) -> bool {
    match at {
        Place::Left => side == 0,
        Place::Right => side == 1,
        Place::Mass | Place::Dof(_) => true,
        Place::Inner(_) => false,
    }
}
