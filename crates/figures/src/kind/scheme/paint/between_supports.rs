//! Links that no part has: between the ground and a support that moves, or between two supports.

use super::super::arrange::join::end;
use super::super::symbols::{self, NAME_GAP, along, height, length, link};
use slipgap_drawing::layout::sheet::{Anchor, Picture, PlacedText};
use slipgap_drawing::style;
use slipgap_drawing::text::markup;
use slipgap_problem::problem::structure::described::scheme::picture::{Link, Scheme};

/// Distance from the rest of the picture.
const APART: f64 = 24.0;
/// Half the height of a wall.
const HALF: f64 = 16.0;
/// Length of the rods on both sides of a symbol.
const ROD: f64 = 14.0;

/// Draws these links one below the other right of a picture of this width, each between two walls with the names of the supports.
pub fn draw(picture: &mut Picture, width: f64, scheme: &Scheme) {
    let has_no_part = |link: &&Link| end(link, 0).is_none() && end(link, 1).is_none();
    let links: Vec<&Link> = scheme.links.iter().filter(has_no_part).collect();
    let first_names = links.iter().filter_map(|link| link.supports[0].as_deref());
    let longest = first_names.map(length).fold(0.0, f64::max);
    let left = width + APART + longest;
    let mut word = |at, anchor, name: &str| {
        picture.words.push(PlacedText {
            at,
            anchor,
            text: markup::escape(name),
            size: style::LABEL,
        });
    };
    let mut places = Vec::new();
    let mut y = 0.0;
    for link in links {
        y += HALF + style::LEADING;
        let right = left + along(link.kind) + 2.0 * ROD;
        places.push((link.kind, [[left, y], [right, y]]));
        let over = y - height(link.kind) / 2.0 - 2.0;
        word([(left + right) / 2.0, over], Anchor::Middle, &link.name);
        let line = y + style::CAP_HEIGHT * style::LABEL / 2.0;
        let beside = [
            (left - 2.0 * NAME_GAP, Anchor::End),
            (right + 2.0 * NAME_GAP, Anchor::Start),
        ];
        for (support, (x, anchor)) in link.supports.iter().zip(beside) {
            if let Some(name) = support {
                word([x, line], anchor, name);
            }
        }
        y += HALF;
    }
    for (kind, ends) in places {
        link(picture, kind, ends, 1.0);
        for ([x, y], away) in ends.into_iter().zip([-1.0, 1.0]) {
            let wall = [[x, y - HALF], [x, y + HALF]];
            symbols::ground(picture, wall, [away, 0.0]);
        }
    }
}
