//! The symbols of a scheme: springs, dashpots, contacts, ground.

use slipgap_drawing::layout::sheet::{Picture, Rect, Shape};
use slipgap_drawing::style;
use slipgap_drawing::text;
use slipgap_problem::problem::structure::described::scheme::picture::LinkKind;

/// Width of outlines.
pub const OUTLINE: f64 = 0.9;
/// Width of faces that touch.
pub const FACE: f64 = 1.6;
/// Width of hatching.
pub const HATCH: f64 = 0.4;
/// Length of a spring or dashpot between its rods.
pub const LONG: f64 = 17.0;
/// Half the distance of spring and dashpot.
const APART: f64 = 6.0;
/// Depth of the hatching of the ground.
pub const DEPTH: f64 = 5.0;
/// Half the length of a sliding surface.
const SLIDING: f64 = 10.0;
/// Half the distance of faces.
pub const GAP: f64 = 3.5;
/// Distance of a name from its symbol.
pub const NAME_GAP: f64 = 3.0;

/// Length of a name in the type of labels.
pub fn length(name: &str) -> f64 {
    text::width(&text::markup::escape(name), style::LABEL)
}

/// Size of a symbol across its line, without its name.
pub fn across(kind: LinkKind) -> f64 {
    match kind {
        LinkKind::Spring {
            elastic: true,
            viscous: true,
        } => 2.0 * APART + 8.0,
        LinkKind::Spring { .. } => 9.0,
        LinkKind::Impact => 11.0,
        LinkKind::Friction => 2.0 * SLIDING,
    }
}

/// Least length of a horizontal symbol along its line.
pub fn along(kind: LinkKind) -> f64 {
    match kind {
        LinkKind::Spring { .. } => LONG + 12.0,
        LinkKind::Impact => 20.0,
        LinkKind::Friction => 2.0 * SLIDING + 8.0,
    }
}

/// Height of a horizontal symbol.
pub fn height(kind: LinkKind) -> f64 {
    match kind {
        LinkKind::Friction => 9.0,
        LinkKind::Spring { .. } | LinkKind::Impact => across(kind),
    }
}

/// Places along and across a line from one end to the other, which is horizontal or vertical.
struct Track {
    from: [f64; 2],
    unit: [f64; 2],
    length: f64,
}

impl Track {
    fn new(from: [f64; 2], to: [f64; 2]) -> Track {
        let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        let length = libm::hypot(dx, dy).max(f64::MIN_POSITIVE);
        Track {
            from,
            unit: [dx / length, dy / length],
            length,
        }
    }

    fn at(&self, along: f64, across: f64) -> [f64; 2] {
        let [ux, uy] = self.unit;
        [
            self.from[0] + along * ux - across * uy,
            self.from[1] + along * uy + across * ux,
        ]
    }

    fn line(&self, points: &[[f64; 2]], width: f64) -> Shape {
        let points = points
            .iter()
            .map(|[along, across]| self.at(*along, *across));
        Shape::Line(points.collect(), width)
    }
}

/// A link along a straight line from end I or J to the other; `opens` is +1 if the part at the second end is the one that moves
/// to the right where the contact opens, else -1.
pub fn link(picture: &mut Picture, kind: LinkKind, ends: [[f64; 2]; 2], opens: f64) {
    let track = Track::new(ends[0], ends[1]);
    let horizontal = track.unit[1].abs() < 0.5;
    let shapes = match kind {
        LinkKind::Spring { elastic, viscous } => spring(&track, elastic, viscous),
        LinkKind::Impact if horizontal => faces(&track),
        LinkKind::Impact => posts(&track, opens),
        LinkKind::Friction => sliding(&track, horizontal),
    };
    picture.shapes.extend(shapes);
}

/// A spring in any direction.
pub fn spring_between(picture: &mut Picture, kind: LinkKind, ends: [[f64; 2]; 2]) {
    if let LinkKind::Spring { elastic, viscous } = kind {
        let track = Track::new(ends[0], ends[1]);
        picture.shapes.extend(spring(&track, elastic, viscous));
    }
}

fn spring(track: &Track, elastic: bool, viscous: bool) -> Vec<Shape> {
    let middle = track.length / 2.0;
    let [from, to] = [middle - LONG / 2.0, middle + LONG / 2.0];
    let mut shapes = Vec::new();
    let apart = if elastic && viscous { APART } else { 0.0 };
    if elastic {
        const TEETH: usize = 8;
        let mut zigzag = vec![[from, -apart]];
        for i in 0..TEETH {
            let side = if i % 2 == 0 { 3.2 } else { -3.2 };
            let tooth = from + LONG * (i as f64 + 0.5) / TEETH as f64;
            zigzag.push([tooth, side - apart]);
        }
        zigzag.push([to, -apart]);
        shapes.push(track.line(&zigzag, OUTLINE));
    }
    if viscous {
        let cup = [
            [middle + 3.5, apart + 3.2],
            [middle - 3.5, apart + 3.2],
            [middle - 3.5, apart - 3.2],
            [middle + 3.5, apart - 3.2],
        ];
        shapes.push(track.line(&cup, OUTLINE));
        shapes.push(track.line(&[[from, apart], [middle - 3.5, apart]], OUTLINE));
        shapes.push(track.line(
            &[[middle + 0.5, apart - 2.2], [middle + 0.5, apart + 2.2]],
            OUTLINE,
        ));
        shapes.push(track.line(&[[middle + 0.5, apart], [to, apart]], OUTLINE));
    }
    if apart > 0.0 {
        for end in [from, to] {
            shapes.push(track.line(&[[end, -apart], [end, apart]], OUTLINE));
        }
    }
    shapes.push(track.line(&[[0.0, 0.0], [from, 0.0]], OUTLINE));
    shapes.push(track.line(&[[to, 0.0], [track.length, 0.0]], OUTLINE));
    shapes
}

/// Two vertical faces with a gap.
fn faces(track: &Track) -> Vec<Shape> {
    let middle = track.length / 2.0;
    [(0.0, middle - GAP), (track.length, middle + GAP)]
        .into_iter()
        .flat_map(|(end, face)| {
            [
                track.line(&[[end, 0.0], [face, 0.0]], OUTLINE),
                track.line(&[[face, -4.0], [face, 4.0]], FACE),
            ]
        })
        .collect()
}

/// Two posts with a gap between their vertical faces.
fn posts(track: &Track, opens: f64) -> Vec<Shape> {
    let middle = track.length / 2.0;
    let post = |end: f64, to: f64, side: f64| {
        let reach = middle + to;
        [
            track.line(&[[end, side], [reach, side]], OUTLINE),
            track.line(&[[middle - 5.0, side], [middle + 5.0, side]], FACE),
        ]
    };
    // The track goes up or down: across is to the right if it goes up.
    let right = if track.unit[1] < 0.0 { 1.0 } else { -1.0 };
    let side = right * opens * GAP;
    let both = [post(0.0, 5.0, -side), post(track.length, -5.0, side)];
    both.into_iter().flatten().collect()
}

/// Two plates that slide on one another.
fn sliding(track: &Track, horizontal: bool) -> Vec<Shape> {
    let middle = track.at(track.length / 2.0, 0.0);
    let half = 1.8;
    let plate = |y: f64| [[middle[0] - SLIDING, y], [middle[0] + SLIDING, y]].to_vec();
    let [start, end] = [track.at(0.0, 0.0), track.at(track.length, 0.0)];
    let mut shapes = Vec::new();
    // The rods lead to the lower plate from below or the left, to the upper one from above or the right.
    for corner in [start, end] {
        let lower = if horizontal {
            corner[0] < middle[0]
        } else {
            corner[1] > middle[1]
        };
        let y = middle[1] + if lower { half } else { -half };
        let line = if horizontal {
            let side = if lower { -SLIDING } else { SLIDING };
            vec![corner, [middle[0] + side, corner[1]], [middle[0] + side, y]]
        } else {
            vec![corner, [middle[0], y]]
        };
        shapes.push(Shape::Line(line, OUTLINE));
        shapes.push(Shape::Line(plate(y), OUTLINE));
    }
    let count = 6_u32;
    for i in 0..count {
        let x =
            middle[0] - SLIDING + 2.0 * (SLIDING - half) * (f64::from(i) + 0.25) / f64::from(count);
        shapes.push(Shape::Line(
            vec![[x, middle[1] + half], [x + 2.0 * half, middle[1] - half]],
            HATCH,
        ));
    }
    shapes
}

/// A surface of the ground from one point to the other, hatched on the side `away`.
pub fn ground(picture: &mut Picture, ends: [[f64; 2]; 2], away: [f64; 2]) {
    picture.shapes.push(Shape::Line(ends.to_vec(), 1.2));
    let track = Track::new(ends[0], ends[1]);
    let count = (track.length / 4.5).floor().max(1.0);
    for i in 0..count as usize {
        let [x, y] = track.at(track.length * (i as f64 + 0.5) / count, 0.0);
        let foot = [
            x + DEPTH * (away[0] - 0.6 * track.unit[0].abs()),
            y + DEPTH * (away[1] + 0.6 * track.unit[1].abs()),
        ];
        picture.shapes.push(Shape::Line(vec![[x, y], foot], HATCH));
    }
}

/// Most elements with a tick each.
pub const MOST_TICKS: u32 = 20;

/// A bar with ticks at the ends of its elements; of many elements only at the first and last ones.
pub fn bar(picture: &mut Picture, rect: Rect, elements: u32) {
    picture.shapes.push(Shape::Box(rect, 255));
    let drawn = (1..elements).filter(|i| elements <= MOST_TICKS || *i < 4 || elements - *i < 4);
    // The first ticks of many elements have the distance of 40 elements.
    let shown = f64::from(elements.min(2 * MOST_TICKS));
    for i in drawn {
        let from_left = match i < 4 || elements <= MOST_TICKS {
            true => f64::from(i) / shown,
            false => 1.0 - f64::from(elements - i) / shown,
        };
        let x = rect.left + rect.width * from_left;
        for [y, to] in [[rect.top, 1.0], [rect.bottom(), -1.0]] {
            let tick = vec![[x, y], [x, y + 3.0 * to]];
            picture.shapes.push(Shape::Line(tick, style::FRAME_LINE));
        }
    }
}
