//! The structure of a case as a scheme: what is connected to what, as plain data for a picture.

use super::amount::Amount;
use super::contacts::law_named;
use super::node::NodeRef;
use super::template::{Moved, Spring, SpringNumbers, Template, Term};
use crate::contact::ContactKind;
use crate::problem::Case;

/// The structure of a case, for a picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Scheme {
    /// Masses, then bars.
    pub parts: Vec<Part>,
    /// Springs, then contacts.
    pub links: Vec<Link>,
    /// Ends with a force, each once.
    pub loads: Vec<End>,
    /// Whether the ground moves.
    pub ground_moves: bool,
}

/// A mass or a bar.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Its name.
    pub name: String,
    /// Number of elements of a bar; `None` for a mass.
    pub elements: Option<u32>,
}

/// A spring or a contact.
#[derive(Debug, Clone, PartialEq)]
pub struct Link {
    /// What it is.
    pub kind: LinkKind,
    /// Name of a contact; empty for a spring.
    pub name: String,
    /// Ends I and J.
    pub between: [End; 2],
}

/// The kinds of links.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LinkKind {
    /// A spring, a dashpot or both.
    Spring {
        /// Whether k > 0.
        elastic: bool,
        /// Whether c > 0.
        viscous: bool,
    },
    /// An impact contact.
    Impact,
    /// A friction contact.
    Friction,
}

/// An end of a link.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum End {
    /// The ground.
    Ground,
    /// A part, by its place in the list.
    Part(usize, Place),
}

/// A place of a part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// A mass as a point.
    Mass,
    /// The left end of a bar.
    Left,
    /// The right end of a bar.
    Right,
    /// A node between the ends of a bar: its distance from the left end over the length.
    Inner(f64),
}

/// The scheme of a structure in a case; `None` if a number of it breaks a rule.
pub fn scheme(template: &Template, case: &Case) -> Option<Scheme> {
    let masses = template.masses.iter().map(|mass| Part {
        name: mass.name.clone(),
        elements: None,
    });
    let mut parts: Vec<Part> = masses.collect();
    for bar in &template.bars {
        parts.push(Part {
            name: bar.name.clone(),
            elements: Some(
                bar.elements
                    .whole(case, 1, super::assemble::MOST_NODES)
                    .ok()?,
            ),
        });
    }
    let blocks = parts.len();
    parts.extend(template.matrices.iter().map(|own| Part {
        name: own.name.clone(),
        elements: None,
    }));
    let masses = template.masses.len();
    let end = |node: NodeRef| match node {
        // A support is drawn as ground.
        NodeRef::Ground | NodeRef::Support(_) => End::Ground,
        NodeRef::Mass(mass) => End::Part(mass, Place::Mass),
        NodeRef::Left(bar) => End::Part(masses + bar, Place::Left),
        NodeRef::Right(bar) => End::Part(masses + bar, Place::Right),
        NodeRef::Dof(matrices, _) => End::Part(blocks + matrices, Place::Mass),
        NodeRef::Inner(bar, node) => {
            let elements = parts[masses + bar].elements.unwrap_or(1);
            let place = f64::from(node) / f64::from(elements);
            End::Part(masses + bar, Place::Inner(place))
        }
    };
    let mut links = Vec::new();
    for spring in &template.springs {
        let [elastic, viscous] = acts(spring, case)?;
        if elastic || viscous {
            links.push(Link {
                kind: LinkKind::Spring { elastic, viscous },
                name: String::new(),
                between: ends(&spring.along, case, end)?,
            });
        }
    }
    for contact in &template.contacts {
        let kind = match law_named(contact.law.name(case))?.kind {
            ContactKind::Friction => LinkKind::Friction,
            ContactKind::Impact => LinkKind::Impact,
            ContactKind::Link => LinkKind::Spring {
                elastic: false,
                viscous: true,
            },
        };
        links.push(Link {
            kind,
            name: contact.name.clone(),
            between: ends(&contact.along, case, end)?,
        });
    }
    // They do nothing.
    links.retain(|link| link.between[0] != link.between[1]);
    let mut loads: Vec<End> = Vec::new();
    for load in &template.loads {
        let Moved::Node(name) = &load.at else {
            continue;
        };
        let loaded = end(name.node);
        if !loads.contains(&loaded) {
            loads.push(loaded);
        }
    }
    Some(Scheme {
        links,
        loads,
        parts,
        ground_moves: !template.ground.is_empty() || !template.supports.is_empty(),
    })
}

/// The ends of a link: the first node that moves against it, and the first that moves with it.
fn ends(along: &[Term], case: &Case, end: impl Fn(NodeRef) -> End) -> Option<[End; 2]> {
    let mut ends = [None; 2];
    for term in along {
        let factor = term.factor.value(case).ok()?;
        let side = &mut ends[usize::from(factor > 0.0)];
        if factor != 0.0 && side.is_none() {
            *side = Some(end(term.node.node));
        }
    }
    Some(ends.map(|end| end.unwrap_or(End::Ground)))
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
