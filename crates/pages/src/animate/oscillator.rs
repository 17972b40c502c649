//! The film of the oscillator: a mass on a spring that slides on a surface.

use super::film::Film;
use super::film::contact_history::Contact;
use super::film::scene::{Link, Mover, Point, Scene};
use slipgap_motion::history::History;
use std::borrow::Cow;

/// The mass: left, top, width, height.
const MASS: [f64; 4] = [120.0, 20.0, 70.0, 34.0];

/// Where the wall is.
const WALL: f64 = 0.0;

/// The film of a motion with displacement, velocity and force as its channels.
pub fn film(history: &History) -> Film<'_> {
    let [left, top, width, height] = MASS;
    let (floor, middle) = (top + height, top + height / 2.0);
    let by = Mover::right(Some(0));
    let friction: [Point; 2] = [
        [left + width / 2.0, floor + 4.0],
        [left + width / 2.0, floor],
    ];
    let scene = Scene {
        masses: vec![(MASS, by, "m".into())],
        links: vec![
            Link {
                kind: "spring",
                contact: None,
                name: (String::new(), [0.0; 2], "none"),
                ends: [([WALL, middle], Mover::default()), ([left, middle], by)],
                direction: [1.0, 0.0],
                opening: None,
                rods: Vec::new(),
            },
            Link {
                kind: "surface",
                contact: Some(0),
                name: ("friction".into(), [left + width + 6.0, floor - 4.0], "none"),
                ends: [(friction[0], Mover::default()), (friction[1], by)],
                direction: [1.0, 0.0],
                opening: None,
                rods: Vec::new(),
            },
        ],
        grounds: vec![
            (
                [[WALL, top - 6.0], [WALL, floor + 4.0]],
                [-1.0, 0.0],
                Mover::default(),
            ),
            (
                [[WALL, floor + 4.0], [2.0 * left + width, floor + 4.0]],
                [0.0, 1.0],
                Mover::default(),
            ),
        ],
        distances: vec![(left - WALL - 30.0, [None, Some(0)])],
        ..Scene::default()
    };
    let contact = Contact::friction(
        "friction",
        Cow::Borrowed(history.force()),
        history.velocity(),
        None,
    );
    Film {
        last: history.len().saturating_sub(1) as u64,
        scene,
        steps: (0..history.len() as u64).collect(),
        moves: vec![Cow::Borrowed(history.displacement())],
        places: 1,
        contacts: vec![contact],
        ..Film::default()
    }
}
