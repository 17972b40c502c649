//! The names of the parts of a structure.

use crate::problem::structure::given::amount::Amount;
use crate::problem::structure::given::node::{GROUND, NodeRef, TiedDof};
use crate::system::import::{Imported, MemberForce};
use crate::system::structure::Direction;
use std::collections::HashMap;
use std::sync::Arc;

/// Names of masses, bars, matrices and contacts, each found without a search.
#[derive(Debug, Clone, Default)]
pub struct Names {
    /// Lumped masses.
    pub masses: Vec<String>,
    /// Bars.
    pub bars: Vec<String>,
    /// Matrices of other programs.
    pub matrices: Vec<(String, Arc<Imported>)>,
    /// Supports that the study gives, each with the places of its motions in x, y and z.
    pub supports: Vec<(String, [Option<usize>; 3])>,
    /// Contacts.
    pub contacts: Vec<String>,
    /// The directions in which the ground moves.
    pub ground: Vec<Direction>,
    /// The directions in which nodes move.
    pub directions: Vec<Direction>,
    /// The contacts in a plane, with the places of their first directions.
    planes: Vec<(String, usize)>,
    /// The springs that have a name, with their places in the list.
    springs: Vec<(String, usize)>,
    parts: HashMap<String, Part>,
    places: HashMap<String, usize>,
}

/// A part that has nodes.
#[derive(Debug, Clone, Copy)]
enum Part {
    Mass(usize),
    Bar(usize),
    Matrices(usize),
    Support(usize),
}

/// What a structure adds to the names.
#[derive(Debug, Clone, Default)]
pub struct StructureNames {
    /// Springs with a name, each with its place in the list.
    pub springs: Vec<(String, usize)>,
    /// Contacts in a plane, each with the place of its first direction.
    pub planes: Vec<(String, usize)>,
    /// The directions of the ground.
    pub ground: Vec<Direction>,
    /// The directions in which nodes move.
    pub directions: Vec<Direction>,
}

impl Names {
    /// The names of these parts; each name is there once.
    pub fn new(
        masses: Vec<String>,
        bars: Vec<String>,
        matrices: Vec<(String, Arc<Imported>)>,
    ) -> Names {
        let of_masses = masses
            .iter()
            .enumerate()
            .map(|(i, name)| (name, Part::Mass(i)));
        let with_bars = of_masses.chain(
            bars.iter()
                .enumerate()
                .map(|(i, name)| (name, Part::Bar(i))),
        );
        let of_matrices = matrices.iter().enumerate();
        let named = with_bars.chain(of_matrices.map(|(i, (name, _))| (name, Part::Matrices(i))));
        Names {
            parts: named.map(|(name, part)| (name.clone(), part)).collect(),
            masses,
            bars,
            matrices,
            supports: Vec::new(),
            contacts: Vec::new(),
            ground: Vec::new(),
            directions: Vec::new(),
            planes: Vec::new(),
            springs: Vec::new(),
            places: HashMap::new(),
        }
    }

    /// The same with these contacts.
    pub fn with_contacts(mut self, contacts: Vec<String>) -> Names {
        let places = contacts.iter().enumerate();
        self.places = places
            .map(|(contact, name)| (name.clone(), contact))
            .collect();
        self.contacts = contacts;
        self
    }

    /// The same with the springs, the ground and the directions of a structure.
    pub fn with_structure(self, given: StructureNames) -> Names {
        Names {
            springs: given.springs,
            planes: given.planes,
            ground: given.ground,
            directions: given.directions,
            ..self
        }
    }

    /// The place of the first direction of the contact in a plane with this name.
    pub fn plane(&self, name: &str) -> Option<usize> {
        let mut planes = self.planes.iter();
        planes.find(|plane| plane.0 == name).map(|plane| plane.1)
    }

    /// The names of contacts, of those in a plane as a whole.
    pub fn named_contacts(&self) -> impl Iterator<Item = &str> {
        let planes = self.planes.iter().map(|plane| plane.0.as_str());
        planes.chain(self.contacts.iter().map(String::as_str))
    }

    /// The place of the spring with this name.
    pub fn spring(&self, name: &str) -> Option<usize> {
        let mut springs = self.springs.iter();
        springs
            .find(|spring| spring.0 == name)
            .map(|spring| spring.1)
    }

    /// The names of springs.
    pub fn springs(&self) -> impl Iterator<Item = &str> {
        self.springs.iter().map(|spring| spring.0.as_str())
    }

    /// The same with these supports, whose motions have the directions x, y and z.
    pub fn with_supports(mut self, supports: Vec<(String, [bool; 3])>) -> Names {
        let mut motions = 0;
        for (name, directions) in supports {
            let part = Part::Support(self.supports.len());
            self.parts.insert(name.clone(), part);
            let motion = |given: bool| {
                given.then(|| {
                    motions += 1;
                    motions - 1
                })
            };
            self.supports.push((name, directions.map(motion)));
        }
        self
    }

    /// The place of the motion of a support in a direction; `None` if it does not move so.
    pub fn motion(&self, support: &str, direction: Direction) -> Option<usize> {
        let Some(Part::Support(support)) = self.parts.get(support) else {
            return None;
        };
        self.moving(*support, direction)
    }

    fn moving(&self, support: usize, direction: Direction) -> Option<usize> {
        let mut directions = Direction::TRANSLATIONS.iter();
        let axis = directions.position(|known| *known == direction)?;
        self.supports[support].1[axis]
    }

    /// Whether a name is that of a support, with or without a direction.
    pub fn is_support(&self, name: &str) -> bool {
        let part = name.split_once('.').map_or(name, |(part, _)| part);
        matches!(self.parts.get(part), Some(Part::Support(_))) && self.node(name).is_some()
    }

    /// A support as a node: where it does not move, it is the ground.
    fn support(&self, support: usize, direction: Direction) -> NodeRef {
        let motion = self.moving(support, direction);
        motion.map_or(NodeRef::Ground, NodeRef::Support)
    }

    /// The node with this name; `None` if there is none.
    pub fn node(&self, name: &str) -> Option<NodeRef> {
        if name == GROUND {
            return Some(NodeRef::Ground);
        }
        match self.parts.get(name) {
            Some(Part::Mass(mass)) => return Some(NodeRef::Mass(*mass)),
            Some(Part::Support(support)) => return Some(self.support(*support, Direction::X)),
            _ => {}
        }
        let (part, rest) = name.split_once('.')?;
        match *self.parts.get(part)? {
            Part::Mass(_) => None,
            Part::Support(support) => {
                let direction = Direction::named(rest)?;
                let moves = Direction::TRANSLATIONS.contains(&direction);
                moves.then(|| self.support(support, direction))
            }
            Part::Matrices(matrices) => {
                let row = self.matrices[matrices].1.dofs.row(rest)?;
                Some(NodeRef::Dof(matrices, row))
            }
            Part::Bar(bar) => match rest {
                "left" => Some(NodeRef::Left(bar)),
                "right" => Some(NodeRef::Right(bar)),
                _ => {
                    let digits = rest.bytes().all(|c| c.is_ascii_digit()) && !rest.starts_with('0');
                    let inner = rest.parse().ok().filter(|_| digits)?;
                    Some(NodeRef::Inner(bar, inner))
                }
            },
        }
    }

    /// The nodes of which the motion of a name is the sum, each with its factor: of a dof of matrices that is tied to rows, or one node.
    pub fn nodes(&self, name: &str) -> Option<Vec<(f64, NodeRef)>> {
        if let Some(node) = self.node(name) {
            return Some(vec![(1.0, node)]);
        }
        let (part, dof) = name.split_once('.')?;
        let matrices = self.matrices(part)?;
        let tie = self.matrices[matrices].1.dofs.tie(dof)?;
        let along = tie.along.iter();
        let terms = along.map(|(row, factor)| (*factor, NodeRef::Dof(matrices, *row)));
        Some(terms.collect())
    }

    /// The tied dof of matrices with this name and factor; `None` for other names.
    pub fn tied(&self, name: &str, factor: &Amount) -> Option<TiedDof> {
        if self.node(name).is_some() {
            return None;
        }
        let (part, dof) = name.split_once('.')?;
        let matrices = self.matrices(part)?;
        let tie = self.matrices[matrices].1.dofs.tie(dof)?;
        Some(TiedDof {
            matrices,
            node: dof.rsplit_once('.')?.0.to_owned(),
            direction: tie.direction,
            factor: factor.clone(),
        })
    }

    /// The force of members with a name such as `tower.base_shear`, and the place of its matrices.
    pub fn member_force(&self, name: &str) -> Option<(usize, &MemberForce)> {
        let (part, force) = name.split_once('.')?;
        let matrices = self.matrices(part)?;
        Some((matrices, self.matrices[matrices].1.dofs.force(force)?))
    }

    /// The place of the bar with this name.
    pub fn bar(&self, name: &str) -> Option<usize> {
        match self.parts.get(name) {
            Some(Part::Bar(bar)) => Some(*bar),
            _ => None,
        }
    }

    /// The place of the matrices with this name.
    pub fn matrices(&self, name: &str) -> Option<usize> {
        match self.parts.get(name) {
            Some(Part::Matrices(matrices)) => Some(*matrices),
            _ => None,
        }
    }

    /// The place of the contact with this name.
    pub fn contact(&self, name: &str) -> Option<usize> {
        self.places.get(name).copied()
    }

    /// Why a name such as `tower.7.q` is no node of matrices, by the directions that its node has; `None` for other names.
    pub fn why_no_dof(&self, name: &str) -> Option<String> {
        let (part, dof) = name.split_once('.')?;
        let (title, imported) = &self.matrices[self.matrices(part)?];
        let node = dof.split('.').next().unwrap_or_default();
        let of_node = imported.dofs.directions(node);
        let directions: Vec<&str> = of_node.iter().map(|one| one.name()).collect();
        Some(match directions.is_empty() {
            true => format!(
                "{title} has no node or force {node:?}; its dofs are in the file under \"dofs\", its forces in that under \"forces\""
            ),
            false => format!(
                "node {node} of {title} has the directions {}",
                directions.join(", ")
            ),
        })
    }
}
