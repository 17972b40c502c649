//! The motion of the ground below a picture: an arrow for each direction in the plane, and all names where one is not in the plane.

use super::super::symbols::NAME_GAP;
use slipgap_drawing::layout::sheet::{Anchor, Picture, PlacedText, Shape};
use slipgap_drawing::style;
use slipgap_drawing::text;
use slipgap_system::system::structure::Direction;

/// Length of a horizontal arrow.
const ACROSS: f64 = 34.0;
/// Length of a vertical arrow.
const UP: f64 = 24.0;

/// Draws the motion below a picture of this size, of which `axes` are horizontal and vertical; the height with it.
pub fn draw(
    picture: &mut Picture,
    [width, height]: [f64; 2],
    directions: &[Direction],
    axes: [usize; 2],
) -> f64 {
    let axis_shown = |direction: &Direction| {
        let axis = Direction::TRANSLATIONS
            .iter()
            .position(|known| known == direction);
        axis.and_then(|axis| axes.iter().position(|shown| *shown == axis))
    };
    let along = |which: usize| {
        directions
            .iter()
            .any(|direction| axis_shown(direction) == Some(which))
    };
    let names = Vec::from_iter(directions.iter().map(|direction| direction.name()));
    let in_plane = |direction: &Direction| axis_shown(direction).is_some();
    let text = match directions.iter().all(in_plane) {
        true => "ground motion".to_owned(),
        false => format!("ground motion ({})", names.join(", ")),
    };
    let length = text::width(&text, style::LABEL);
    let [across, up] = [along(0), along(1)];
    let arrows = match (across, up) {
        (true, _) => ACROSS + 2.0 * NAME_GAP,
        (false, true) => 4.0 * NAME_GAP,
        (false, false) => 0.0,
    };
    let middle = height + if up { UP / 2.0 + 4.0 } else { 9.0 };
    let from = (width - arrows - length) / 2.0;
    if across {
        let ends = [[from, middle], [from + ACROSS, middle]];
        picture.shapes.push(Shape::DoubleArrow(ends));
    }
    if up {
        let x = from + if across { ACROSS / 2.0 } else { 2.0 };
        let ends = [[x, middle - UP / 2.0], [x, middle + UP / 2.0]];
        picture.shapes.push(Shape::DoubleArrow(ends));
    }
    picture.words.push(PlacedText {
        at: [
            from + arrows,
            middle + style::CAP_HEIGHT * style::LABEL / 2.0,
        ],
        anchor: Anchor::Start,
        text,
        size: style::LABEL,
    });
    middle + if up { UP / 2.0 + 2.0 } else { 7.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ends of the arrows, and the words.
    fn drawn(directions: &[Direction]) -> (Vec<[[f64; 2]; 2]>, String) {
        let mut picture = Picture::default();
        let height = draw(&mut picture, [200.0, 100.0], directions, [0, 2]);
        let drawn = picture.shapes.iter().map(|shape| match shape {
            Shape::DoubleArrow(ends) => *ends,
            other @ (Shape::Line(..) | Shape::Box(..) | Shape::Arrow(_)) => panic!("{other:?}"),
        });
        let arrows: Vec<_> = drawn.collect();
        for [_, y] in arrows.iter().flatten() {
            assert!((100.0..=height).contains(y));
        }
        (arrows, picture.words[0].text.clone())
    }

    #[test]
    fn arrows_have_the_directions_of_the_ground() {
        let (arrows, words) = drawn(&[Direction::X]);
        assert!(
            arrows.len() == 1 && arrows[0][0][1] == arrows[0][1][1] && words == "ground motion"
        );
        let (arrows, words) = drawn(&[Direction::Z]);
        assert!(
            arrows.len() == 1 && arrows[0][0][0] == arrows[0][1][0] && words == "ground motion"
        );
        assert_eq!(drawn(&[Direction::X, Direction::Z]).0.len(), 2);
        let (arrows, words) = drawn(&[Direction::Y]);
        assert!(arrows.is_empty() && words == "ground motion (y)");
        assert_eq!(
            drawn(&[Direction::X, Direction::Y]).1,
            "ground motion (x, y)"
        );
    }
}
