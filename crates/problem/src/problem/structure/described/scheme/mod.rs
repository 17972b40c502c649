//! The structure of a case as a scheme: what is connected to what, as plain data for a picture.

pub mod model;
pub mod picture;

use crate::contact::ContactKind;
use crate::problem::Case;
use crate::problem::structure::given::amount::Amount;
use crate::problem::structure::given::node::NodeRef;
use crate::problem::structure::given::supports::Support;
use crate::problem::structure::model::assemble::MOST_NODES;
use crate::problem::structure::parts::along::Term;
use crate::problem::structure::parts::contact_law::law_named;
use crate::problem::structure::parts::template::{Moved, Spring, SpringNumbers, Template};
use crate::system::import::Dofs;
use crate::system::structure::Direction;
use model::Model;
use picture::{End, Link, LinkKind, Part, Place, Scheme};

/// The scheme of a structure in a case; `None` if a number of it breaks a rule.
pub fn scheme(template: &Template, case: &Case) -> Option<Scheme> {
    let mut draft = Draft::new(template, case)?;
    let mut links = Vec::new();
    for spring in &template.springs {
        let [elastic, viscous] = acts(spring, case)?;
        if elastic || viscous {
            let kind = LinkKind::Spring { elastic, viscous };
            links.push(draft.link(kind, String::new(), &spring.along, case)?);
        }
    }
    for contact in &template.contacts {
        let law = law_named(contact.law.name(case))?;
        let kind = match law.kind {
            ContactKind::Friction => LinkKind::Friction,
            ContactKind::Impact => LinkKind::Impact,
            ContactKind::Link => LinkKind::Spring {
                elastic: !law.of_velocity,
                viscous: law.of_velocity,
            },
        };
        links.push(draft.link(kind, contact.name.clone(), &contact.along, case)?);
    }
    // Those that do nothing; a support is ground, but may move.
    links.retain(|link| {
        let moves = link.supports.iter().any(Option::is_some);
        moves || link.between[0] != link.between[1]
    });
    let mut loads: Vec<End> = Vec::new();
    for load in &template.loads {
        let name = match &load.at {
            Moved::Node(name) => name,
            Moved::Tied(terms) if !terms.is_empty() => &terms[0].1,
            Moved::Bar(_) | Moved::Rows(..) | Moved::Tied(_) => continue,
        };
        let loaded = draft.end(name.node);
        if !loads.contains(&loaded) {
            loads.push(loaded);
        }
    }
    let of_ground = template.ground.iter().map(|(direction, _)| *direction);
    let moved = of_ground.chain(template.supports.iter().map(|support| support.direction));
    let mut ground: Vec<Direction> = Vec::new();
    for direction in moved {
        if !ground.contains(&direction) {
            ground.push(direction);
        }
    }
    Some(Scheme {
        links,
        loads,
        parts: draft.parts,
        ground,
    })
}

/// The parts of a scheme, with the interfaces of matrices as far as they are known.
struct Draft<'a> {
    template: &'a Template,
    parts: Vec<Part>,
    masses: usize,
    /// Place of the first matrices in the list of parts.
    blocks: usize,
    /// The rows of matrices, and the node of each.
    rows: Vec<(&'a Dofs, Vec<usize>)>,
}

impl<'a> Draft<'a> {
    fn new(template: &'a Template, case: &Case) -> Option<Draft<'a>> {
        let part = |name: &String| Part {
            name: name.clone(),
            elements: None,
            model: None,
        };
        let mut parts: Vec<Part> = template
            .masses
            .iter()
            .map(|mass| part(&mass.name))
            .collect();
        for bar in &template.bars {
            let elements = bar.elements.whole(case, 1, MOST_NODES);
            parts.push(Part {
                elements: Some(elements.ok()?),
                ..part(&bar.name)
            });
        }
        let blocks = parts.len();
        let mut rows = Vec::new();
        for matrices in &template.matrices {
            let (nodes, count) = model::nodes_of_rows(&matrices.imported.dofs);
            parts.push(Part {
                model: Some(Model::new(matrices.in_case(case), &nodes, count)),
                ..part(&matrices.name)
            });
            rows.push((&*matrices.imported.dofs, nodes));
        }
        Some(Draft {
            template,
            parts,
            masses: template.masses.len(),
            blocks,
            rows,
        })
    }

    fn end(&mut self, node: NodeRef) -> End {
        match node {
            // A support is drawn as ground.
            NodeRef::Ground | NodeRef::Support(_) => End::Ground,
            NodeRef::Mass(mass) => End::Part(mass, Place::Mass),
            NodeRef::Left(bar) => End::Part(self.masses + bar, Place::Left),
            NodeRef::Right(bar) => End::Part(self.masses + bar, Place::Right),
            NodeRef::Inner(bar, node) => {
                let elements = self.parts[self.masses + bar].elements.unwrap_or(1);
                let share = f64::from(node) / f64::from(elements);
                End::Part(self.masses + bar, Place::Inner(share))
            }
            NodeRef::Dof(matrices, row) => {
                let (dofs, nodes) = &self.rows[matrices];
                let part = self.blocks + matrices;
                let model = self.parts[part].model.get_or_insert_default();
                End::Part(part, Place::Dof(model.named(dofs, row, nodes[row])))
            }
        }
    }

    /// A link whose r or extension is the sum of these terms. Its ends are the first point that moves against it, and the first
    /// that moves with it, by the largest factor of each point; the factors of rotations are levers, and count alone.
    fn link(&mut self, kind: LinkKind, name: String, along: &[Term], case: &Case) -> Option<Link> {
        let mut points: Vec<Point> = Vec::new();
        for term in along {
            let factor = term.factor.value(case).ok()?;
            if factor != 0.0 {
                self.add(term.node.node, factor, &mut points);
            }
        }
        let side = |sign: f64| points.iter().find(|point| point.factor * sign > 0.0);
        let sides = [side(-1.0), side(1.0)];
        let direction = match sides {
            [_, Some(j)] if j.direction != [0.0; 3] => j.direction,
            [Some(i), _] => i.direction.map(|x| 0.0 - x),
            _ => [0.0; 3],
        };
        let nodes = sides.map(|point| point.map_or(NodeRef::Ground, |point| point.node));
        let support = |node| match node {
            NodeRef::Support(support) => self.template.supports.get(support),
            NodeRef::Ground
            | NodeRef::Mass(_)
            | NodeRef::Left(_)
            | NodeRef::Right(_)
            | NodeRef::Inner(..)
            | NodeRef::Dof(..) => None,
        };
        Some(Link {
            kind,
            name,
            supports: nodes.map(|node| support(node).map(Support::full_name)),
            between: nodes.map(|node| self.end(node)),
            direction,
        })
    }

    /// Adds a term to its point.
    fn add(&self, node: NodeRef, factor: f64, points: &mut Vec<Point>) {
        let mut direction = [0.0; 3];
        let mut key = node;
        let mut turns = false;
        if let NodeRef::Dof(matrices, row) = node {
            let (dofs, nodes) = &self.rows[matrices];
            key = NodeRef::Dof(matrices, nodes[row]);
            let along = dofs.rows()[row].direction;
            turns = !Direction::TRANSLATIONS.contains(&along);
            let axes = Direction::TRANSLATIONS.iter().zip(&mut direction);
            for (_, x) in axes.filter(|(axis, _)| **axis == along) {
                *x = factor;
            }
        }
        match points.iter_mut().find(|point| point.key == key) {
            None => points.push(Point {
                key,
                node,
                factor,
                turns,
                direction,
            }),
            Some(point) => {
                for (sum, x) in point.direction.iter_mut().zip(direction) {
                    *sum += x;
                }
                let is_larger = factor.abs() > point.factor.abs();
                if point.turns && !turns || point.turns == turns && is_larger {
                    (point.node, point.factor, point.turns) = (node, factor, turns);
                }
            }
        }
    }
}

/// The terms of a link at one point: a node of matrices may have several.
struct Point {
    /// The node; for matrices, its number instead of a row.
    key: NodeRef,
    /// The node or row with the largest factor.
    node: NodeRef,
    /// This factor.
    factor: f64,
    /// Whether this is a rotation.
    turns: bool,
    /// Sum of factors by X, Y, Z.
    direction: [f64; 3],
}

/// Whether a spring has a stiffness and a dashpot in a case.
fn acts(spring: &Spring, case: &Case) -> Option<[bool; 2]> {
    let positive = |amount: &Option<Amount>| match amount {
        Some(amount) => Some(amount.value(case).ok()? > 0.0),
        None => Some(false),
    };
    Some(match &spring.numbers {
        SpringNumbers::Stiffness { k, c } => [k.value(case).ok()? > 0.0, positive(c)?],
        SpringNumbers::Period { ratio, .. } => [true, positive(ratio)?],
    })
}
