//! Sizes of the parts of a scheme, and the places of links on their upper and lower sides.

use super::super::part::{self, AROUND_NODES, BESIDE, extent, has_places, is_node, longest};
use super::super::symbols::{self, NAME_GAP, length};
use super::join::{Join, end};
use super::relations::Relations;
use slipgap_drawing::style;
use slipgap_drawing::text;
use slipgap_problem::problem::structure::described::scheme::picture::{Link, Part, Place, Scheme};

/// Least width of a mass and of a bar.
const LEAST: [f64; 2] = [36.0, 104.0];
/// Least height of a part.
const HEIGHT: f64 = 23.0;
/// Distance of neighbouring symbols.
const BETWEEN: f64 = 8.0;
/// Distance of the first symbol from the end of a bar.
const INSET: f64 = 3.0;
/// Space left and right of a name inside a part.
const MARGIN: f64 = 6.0;

/// The place of a link on the upper or lower side of a part.
#[derive(Debug, Clone, Copy)]
pub struct Slot {
    /// The part that gives its place.
    pub of: usize,
    /// Where it begins: at an end or inner node of a bar, or in the middle of a mass.
    pub place: Place,
    /// Distance to the right of this place.
    pub x: f64,
    /// Whether the name is right of the symbol.
    pub name_right: bool,
}

/// Sizes of parts and places of links.
pub struct Sizes {
    /// Width of each part.
    pub width: Vec<f64>,
    /// Height of each part.
    pub height: Vec<f64>,
    /// The place of each link between an upper and a lower part.
    pub slots: Vec<Option<Slot>>,
}

/// What a bar shows: its name, and its number of elements if it has too many ticks.
pub fn label(scheme: &Scheme, part: usize) -> String {
    let part = &scheme.parts[part];
    let name = text::markup::escape(&part.name);
    match part.elements {
        Some(n) if n > symbols::MOST_TICKS => format!("{name} (*n* = {n})"),
        _ => name,
    }
}

/// Width and height of a part that is drawn as nodes.
fn nodes(part: &Part) -> Option<[f64; 2]> {
    let model = part.model.as_ref().filter(|_| has_places(part))?;
    Some([0, 1].map(|axis| {
        let [low, high] = extent(&model.nodes, axis);
        high - low + 2.0 * AROUND_NODES
    }))
}

/// Width of the names at the edges of a block; 0 for other parts.
fn room(scheme: &Scheme, relations: &Relations, part: usize) -> f64 {
    let has_part = |join: &&Join| matches!(**join, Join::Over(a, b) if a == part || b == part);
    let over = relations.joins.iter().filter(has_part).count().max(1);
    match longest(&scheme.parts[part]) {
        0.0 => 0.0,
        longest => 2.0 * over as f64 * (longest + BESIDE),
    }
}

/// Width of a symbol with its name.
fn with_name(link: &Link) -> f64 {
    let name = match link.name.is_empty() {
        true => 0.0,
        false => NAME_GAP + length(&link.name),
    };
    symbols::across(link.kind) + name
}

/// Width between two faces with these links.
pub fn interval<'a>(links: impl Iterator<Item = &'a Link>) -> f64 {
    let least = |link: &Link| symbols::along(link.kind).max(length(&link.name) + 8.0);
    links.map(least).fold(0.0, f64::max)
}

/// Height of a link between two faces, with its name over it.
pub fn lane(link: &Link) -> f64 {
    let name = if link.name.is_empty() {
        0.0
    } else {
        style::LABEL + 1.0
    };
    symbols::height(link.kind) + name
}

impl Sizes {
    /// The sizes, with bars that are longer by `longer`.
    pub fn of(scheme: &Scheme, relations: &Relations, longer: &[f64]) -> Sizes {
        let count = scheme.parts.len();
        let mut sizes = Sizes {
            width: (0..count)
                .map(|part| {
                    if is_node(&scheme.parts[part]) {
                        return part::NODE;
                    }
                    let is_bar = usize::from(scheme.parts[part].elements.is_some());
                    let label = text::width(&label(scheme, part), style::LABEL);
                    let least = LEAST[is_bar].max(label + 2.0 * MARGIN);
                    match nodes(&scheme.parts[part]) {
                        None => least + room(scheme, relations, part),
                        Some([width, _]) => width,
                    }
                })
                .collect(),
            height: scheme
                .parts
                .iter()
                .map(|part| match (nodes(part), &part.model) {
                    (Some([_, height]), _) => height,
                    (None, Some(_)) => HEIGHT + 2.0 * style::LABEL,
                    (None, None) if is_node(part) => part::NODE,
                    (None, None) => HEIGHT,
                })
                .collect(),
            slots: vec![None; scheme.links.len()],
        };
        for (part, longer) in longer.iter().enumerate() {
            match scheme.parts[part].elements {
                Some(_) => {
                    sizes.bar(scheme, relations, part);
                    sizes.width[part] += longer;
                }
                None => sizes.mass(scheme, relations, part),
            }
            for side in [0, 1] {
                let at_face = |join: &Join| match *join {
                    Join::Beside(parts) => parts[1 - side] == Some(part),
                    Join::Above(..) | Join::Over(..) => false,
                };
                let links = scheme.links.iter().zip(&relations.joins);
                let needed = links
                    .filter(|(_, join)| at_face(join))
                    .map(|(link, _)| lane(link));
                let lanes: f64 = needed.sum::<f64>() + 4.0;
                sizes.height[part] = sizes.height[part].max(lanes);
            }
        }
        sizes
    }

    /// The links on the sides of a bar: from its ends inwards, and at inner nodes.
    fn bar(&mut self, scheme: &Scheme, relations: &Relations, bar: usize) {
        let mut longest = 0.0_f64;
        for is_upper in [true, false] {
            // Lengths taken at the places that have links.
            let mut taken: Vec<(Place, f64)> = vec![(Place::Left, INSET), (Place::Right, INSET)];
            for (l, link) in scheme.links.iter().enumerate() {
                let of = match relations.joins[l] {
                    Join::Above(_, upper) if is_upper => upper == bar,
                    Join::Above(Some(lower), upper) => {
                        lower == bar && scheme.parts[upper].elements.is_none()
                    }
                    Join::Beside(_) | Join::Above(..) | Join::Over(..) => false,
                };
                if !of {
                    continue;
                }
                let part_end = [0, 1]
                    .into_iter()
                    .filter_map(|k| end(link, k))
                    .find(|end| end.0 == bar);
                let half = symbols::across(link.kind) / 2.0;
                let at = part_end.map_or(Place::Left, |end| end.1);
                let known = taken.iter().position(|taken| taken.0 == at);
                let index = known.unwrap_or_else(|| {
                    taken.push((at, -half));
                    taken.len() - 1
                });
                let length = &mut taken[index].1;
                let x = match at {
                    Place::Right => -(*length + half),
                    Place::Left | Place::Inner(_) | Place::Mass | Place::Dof(_) => *length + half,
                };
                *length += with_name(link) + BETWEEN;
                self.slots[l] = Some(Slot {
                    of: bar,
                    place: at,
                    x,
                    name_right: at != Place::Right,
                });
            }
            longest = longest.max(taken.iter().map(|taken| taken.1.max(0.0)).sum());
        }
        self.width[bar] = self.width[bar].max(longest + MARGIN);
    }

    /// Distance of a slot from the left edge of its part.
    pub fn offset(&self, slot: Slot) -> f64 {
        let width = self.width[slot.of];
        slot.x
            + match slot.place {
                Place::Left => 0.0,
                Place::Right => width,
                Place::Inner(part) => part * width,
                Place::Mass | Place::Dof(_) => width / 2.0,
            }
    }

    /// The links below a mass, except those that a bar gives a place.
    fn mass(&mut self, scheme: &Scheme, relations: &Relations, mass: usize) {
        let is_own = |l: &usize| match relations.joins[*l] {
            Join::Above(lower, upper) => {
                upper == mass && lower.is_none_or(|lower| scheme.parts[lower].elements.is_none())
            }
            Join::Beside(_) | Join::Over(..) => false,
        };
        let own_links: Vec<usize> = (0..scheme.links.len()).filter(is_own).collect();
        let longest = longest(&scheme.parts[mass]);
        let wide = |l: usize| with_name(&scheme.links[l]).max(longest);
        let sums = own_links.iter().map(|l| wide(*l) + BETWEEN);
        let total = sums.sum::<f64>() - BETWEEN;
        let mut x = -total / 2.0;
        let mut widest = total;
        for l in &own_links {
            let link = &scheme.links[*l];
            let across = symbols::across(link.kind);
            let alone = own_links.len() == 1;
            if alone {
                // The symbol is in the middle, its name right of it.
                x = -across / 2.0;
                widest = 2.0 * with_name(link) - across;
            }
            self.slots[*l] = Some(Slot {
                of: mass,
                place: Place::Mass,
                x: x + across / 2.0,
                name_right: true,
            });
            x += wide(*l) + BETWEEN;
            if let Join::Above(Some(lower), _) = relations.joins[*l] {
                self.width[lower] = self.width[lower].max(widest);
            }
        }
        self.width[mass] = self.width[mass].max(widest);
    }
}
