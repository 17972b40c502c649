//! The film of a structure: its scheme, moved by the histories of its nodes.

pub(super) mod displacements;
pub(super) mod nodes;
pub(super) mod words;

use super::film::Film;
use super::film::contact_history::Contact;
use super::film::scene::{Bar, Link, Mover, Point, Scene};
use displacements::{Motion, node_of_bar};
use slipgap_figures::scheme::{LinkPlace, Painter, Placed, has_places, with_places};
use slipgap_motion::history::History;
use slipgap_problem::problem::structure::described::scheme::picture::{End, Place, Scheme};
use slipgap_problem::problem::{Case, Problem};
use std::borrow::Cow;
use words::{align, kind};

/// Most nodes of a bar whose displacements are shown: between them a bar is straight.
const NODES: u32 = 8;

/// The film of a case with this scheme and motion.
pub fn film<'a>(
    problem: &dyn Problem,
    case: &Case,
    scheme: &Scheme,
    history: &'a History,
) -> Film<'a> {
    let columns = problem.history_columns(case).into_iter();
    let mut motion = Motion {
        history,
        columns: columns
            .map(|history_column| {
                (
                    history_column.column.name.into_owned(),
                    history_column.index,
                )
            })
            .collect(),
        moves: Vec::new(),
        stresses: Vec::new(),
    };
    let link_names = scheme.links.iter().map(|link| &*link.name);
    let names: Vec<&str> = link_names.filter(|name| !name.is_empty()).collect();
    let limits = problem.as_structure().map_or(Vec::new(), |structure| {
        structure.friction_limits(case, history)
    });
    let contacts: Vec<Contact> = scheme
        .links
        .iter()
        .filter(|link| !link.name.is_empty())
        .map(|link| motion.contact(link.kind, &link.name, &limits))
        .collect();
    let mut scene = with_places(scheme, |painter, placed| {
        let mut draft = Draft {
            painter: &painter,
            motion: &mut motion,
            contacts: &names,
            placed,
            scene: Scene::default(),
        };
        draft.parts();
        draft.links();
        draft.grounds();
        draft.loads();
        let mut scene = draft.scene;
        if let Some(placed) = placed {
            nodes::add(&mut scene, &painter, placed, &mut motion, &names);
        }
        scene
    });
    let places = motion.moves.len();
    let supports = scheme.links.iter().flat_map(|link| &link.supports);
    let first = supports.flatten().next();
    let support = first.map(|name| (name.clone(), motion.values(&format!("{name}.a"))));
    for link in scene.links.iter_mut().filter(|link| link.kind == "impact") {
        let column = motion.column(&format!("{}.r", link.name.0));
        link.opening = column.map(|column| motion.add(column));
    }
    Film {
        last: history.len().saturating_sub(1) as u64,
        scene,
        steps: (0..history.len() as u64).collect(),
        moves: motion
            .moves
            .iter()
            .map(|column| Cow::Borrowed(history.channel(*column)))
            .collect(),
        places,
        stresses: motion.stresses.into_iter().map(Cow::Owned).collect(),
        contacts,
        support,
        ..Film::default()
    }
}

/// A scene under way.
struct Draft<'a, 'b> {
    painter: &'a Painter<'a>,
    motion: &'a mut Motion<'b>,
    contacts: &'a [&'a str],
    placed: Option<&'a Placed>,
    scene: Scene,
}

impl Draft<'_, '_> {
    /// What moves an end of a link.
    fn mover(&mut self, end: End, support: Option<&str>) -> Option<usize> {
        match end {
            End::Ground => support.and_then(|name| self.motion.of(name)),
            End::Part(part, at) => {
                let part = &self.painter.scheme.parts[part];
                let n = part.elements.unwrap_or(1);
                let node = match at {
                    Place::Mass => part.name.clone(),
                    Place::Left => node_of_bar(&part.name, n, 0),
                    Place::Right => node_of_bar(&part.name, n, n),
                    Place::Inner(x) => {
                        node_of_bar(&part.name, n, (x * f64::from(n)).round() as u32)
                    }
                    Place::Dof(dof) => {
                        let model = part.model.as_ref()?;
                        let dof_of_part = &model.interface[dof];
                        let with_places = self.placed.filter(|_| has_places(part));
                        let matrices = with_places
                            .and_then(|placed| nodes::matrices(placed, dof_of_part.node));
                        format!("{}.{}", matrices.unwrap_or(&part.name), dof_of_part.name)
                    }
                };
                self.motion.of(&node)
            }
        }
    }

    fn parts(&mut self) {
        let painter = self.painter;
        for (i, part) in painter.scheme.parts.iter().enumerate() {
            if has_places(part) {
                continue;
            }
            let bounds = painter.rects[i];
            let rect = [bounds.left, bounds.top, bounds.width, bounds.height];
            match part.elements {
                Some(n) => {
                    let shown = n.min(NODES);
                    let node = |i: u32| node_of_bar(&part.name, n, n * i / shown);
                    let nodes = (0..=shown).map(|i| self.motion.of(&node(i))).collect();
                    self.scene.bars.push(Bar {
                        rect,
                        name: part.name.clone(),
                        nodes,
                        stresses: self.motion.stresses(&part.name, n),
                    });
                }
                None => {
                    // A block of matrices moves as the first of its named places.
                    let named = part
                        .model
                        .as_ref()
                        .and_then(|model| model.interface.first());
                    let node = match named {
                        Some(first) => format!("{}.{}", part.name, first.name),
                        None => part.name.clone(),
                    };
                    let by = Mover::right(self.motion.of(&node));
                    self.scene.masses.push((rect, by, part.name.clone()));
                }
            }
        }
    }

    fn links(&mut self) {
        for link_place in self.painter.link_places() {
            let link = self.link(&link_place);
            let [(from, a), (to, b)] = link.ends;
            if (to[1] - from[1]).abs() < (to[0] - from[0]).abs() {
                self.scene
                    .distances
                    .push((to[0] - from[0] - 5.0, [a.0, b.0]));
            }
            self.scene.links.push(link);
        }
    }

    fn link(&mut self, link_place: &LinkPlace) -> Link {
        let link = &self.painter.scheme.links[link_place.link];
        let mover = |end: usize, draft: &mut Self| {
            let which = link_place.of[end];
            let support = link.supports[which].as_deref();
            Mover::right(draft.mover(link.between[which], support))
        };
        let movers = [mover(0, self), mover(1, self)];
        let (at, anchor) = link_place.name;
        let [first, second] = &link_place.rods;
        let mut rods: Vec<(usize, Vec<Point>)> = first.iter().chain(second).cloned().collect();
        // Thin lines to nodes.
        for (end, which) in link_place.of.iter().enumerate() {
            if let End::Part(part, Place::Dof(dof)) = link.between[*which]
                && let part_of_end = &self.painter.scheme.parts[part]
                && let Some(model) = part_of_end
                    .model
                    .as_ref()
                    .filter(|_| has_places(part_of_end))
            {
                let node = model.interface[dof].node;
                let from = self.painter.node_places(part, model)[node];
                rods.push((end, vec![from, link_place.ends[end]]));
            }
        }
        Link {
            kind: kind(link.kind),
            contact: self.contacts.iter().position(|name| *name == link.name),
            name: (link.name.clone(), at, align(anchor)),
            ends: [
                (link_place.ends[0], movers[0]),
                (link_place.ends[1], movers[1]),
            ],
            direction: [link_place.opens, 0.0],
            opening: None,
            rods,
        }
    }

    /// The ground. Under supports each link has ground of its own, since they move apart.
    fn grounds(&mut self) {
        let scheme = self.painter.scheme;
        let moves =
            |link: &slipgap_problem::problem::structure::described::scheme::picture::Link| {
                link.supports.iter().any(Option::is_some)
            };
        if !scheme.links.iter().any(moves) {
            let places = self.painter.ground_places().into_iter();
            self.scene
                .grounds
                .extend(places.map(|ground| (ground.ends, ground.away, Mover::default())));
            return;
        }
        const HALF: f64 = 14.0;
        for link_place in self.painter.link_places() {
            let Some(end) = link_place.parts.iter().position(Option::is_none) else {
                continue;
            };
            let link = &scheme.links[link_place.link];
            let which = link_place.of[end];
            let support = link.supports[which].as_deref();
            let by = Mover::right(self.mover(link.between[which], support));
            let [x, y] = link_place.ends[end];
            let across: Point = [
                link_place.ends[1 - end][0] - x,
                link_place.ends[1 - end][1] - y,
            ];
            let (ends, away) = match across[0].abs() > across[1].abs() {
                true => ([[x, y - HALF], [x, y + HALF]], [-across[0].signum(), 0.0]),
                false => ([[x - HALF, y], [x + HALF, y]], [0.0, 1.0]),
            };
            self.scene.grounds.push((ends, away, by));
        }
    }

    fn loads(&mut self) {
        for load in self.painter.load_places() {
            let by = Mover::right(self.mover(load.end, None));
            self.scene.forces.push((load.arrow, by));
        }
    }
}
