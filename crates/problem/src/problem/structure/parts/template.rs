//! The structure of a study: nodes, bars, springs, contacts, loads and start, with numbers that may depend on the parameters.

use super::along::Term;
use super::contact::{Contact, Normal};
use super::damping::{ModalDamping, Rayleigh};
use super::reduce::Reduce;
use crate::problem::Case;
use crate::problem::structure::channels::measured_channels::Measured;
use crate::problem::structure::channels::sample::Sample;
use crate::problem::structure::given::amount::Amount;
use crate::problem::structure::given::motion_set::Set;
use crate::problem::structure::given::node::{NodeName, NodeRef};
use crate::problem::structure::given::rows::Rows;
use crate::problem::structure::given::shape::Scaled;
use crate::problem::structure::given::source::Source;
use crate::problem::structure::given::supports::Support;
use crate::system::import::Imported;
use crate::system::structure::Direction;
use std::sync::Arc;

/// The structure of all cases of a study.
#[derive(Debug, Clone, Default)]
pub struct Template {
    /// Units of mass, force, length and time, as the study writes them; empty if it does not.
    pub units: String,
    /// Length unit in m, for the acceleration units of records.
    pub metre: f64,
    /// Lumped masses.
    pub masses: Vec<Mass>,
    /// Bars of finite elements.
    pub bars: Vec<Bar>,
    /// Matrices of other programs.
    pub matrices: Vec<Matrices>,
    /// Springs and dashpots.
    pub springs: Vec<Spring>,
    /// C += mass M + stiffness K.
    pub rayleigh: Rayleigh,
    /// Damping ratios of the modes of the structure.
    pub modal_damping: Option<ModalDamping>,
    /// The stiffness of Rayleigh and modal damping.
    pub damping_stiffness: DampingStiffness,
    /// The contacts.
    pub contacts: Vec<Contact>,
    /// Forces on nodes.
    pub loads: Vec<Load>,
    /// Accelerations of the ground, each in its direction.
    pub ground: Vec<(Direction, Scaled)>,
    /// Motions of supports, one for each support and direction.
    pub supports: Vec<Support>,
    /// Loads whose equilibrium is the structure's place at t = 0.
    pub at_rest: Vec<StaticLoad>,
    /// Accelerations of all masses from t = 0 on, each in its direction.
    pub gravity: Vec<(Direction, Amount)>,
    /// Displacements and velocities at t = 0.
    pub start: Vec<Start>,
    /// The reference, if the study asks for one.
    pub reference: Option<Reference>,
    /// What was measured, if the study has it.
    pub measured: Option<Measured>,
    /// The tests that are compared as a sample, if the study has them.
    pub sample: Option<Sample>,
    /// Whether a channel needs more of a structure than its equations.
    pub observed: bool,
}

impl Template {
    /// Whether a node of a case may be without mass.
    pub fn has_massless_nodes(&self, case: &Case) -> bool {
        let none = |mass: &Mass| mass.mass.value(case) == Ok(0.0);
        let has_massless = |matrices: &Matrices| matrices.in_case(case).massless_rows() > 0;
        self.matrices.iter().any(has_massless) || self.masses.iter().any(none)
    }

    /// The accelerations of all masses by gravity, at rest or from t = 0 on.
    pub fn gravities(&self) -> impl Iterator<Item = (Direction, &Amount)> {
        let at_rest = self.at_rest.iter().filter_map(|load| match load {
            StaticLoad::Gravity(direction, amount) => Some((*direction, amount)),
            StaticLoad::Force(..) => None,
        });
        let falling = self.gravity.iter();
        at_rest.chain(falling.map(|(direction, amount)| (*direction, amount)))
    }

    /// Whether a mass or a row of matrices has no mass in a case.
    pub fn is_massless(&self, node: NodeRef, case: &Case) -> bool {
        match node {
            NodeRef::Mass(mass) => self.masses[mass].mass.value(case) == Ok(0.0),
            NodeRef::Dof(matrices, row) => {
                let imported = self.matrices[matrices].in_case(case);
                !imported
                    .mass
                    .entries()
                    .any(|((i, j), m)| m != 0.0 && (i == row || j == row))
            }
            NodeRef::Ground
            | NodeRef::Left(_)
            | NodeRef::Right(_)
            | NodeRef::Inner(..)
            | NodeRef::Support(_) => false,
        }
    }

    /// Byte offset of the mass or the matrices of a node in the study, by its name.
    pub fn place_of(&self, node: &str) -> Option<usize> {
        let mass = self.masses.iter().find(|mass| mass.name == node);
        mass.map(|mass| mass.mass.at)
    }

    /// The first motion of the ground with a set, and this set.
    pub fn set(&self) -> Option<(&Scaled, &Set)> {
        self.ground.iter().find_map(|(_, motion)| {
            let scale_to = motion.shape.scale_to.as_ref()?;
            Some((motion, scale_to.set.as_deref()?))
        })
    }

    /// The functions of time whose signals are computed sample by sample.
    pub fn sampled(&self) -> impl Iterator<Item = &Source> {
        let loads = self.loads.iter().map(|load| &load.force.source);
        let ground = self.ground.iter().map(|(_, ground)| &ground.source);
        let normals = self
            .contacts
            .iter()
            .filter_map(|contact| match &contact.normal {
                Some(Normal::Table(source)) => Some(source),
                Some(Normal::Weight { vertical, .. }) => Some(&vertical.source),
                Some(Normal::Constant(_) | Normal::Parts(_)) | None => None,
            });
        let accelerations = self.supports.iter().filter_map(Support::acceleration);
        let supports = accelerations.map(|acceleration| &acceleration.source);
        let sources = loads.chain(ground).chain(supports).chain(normals);
        sources.filter(|source| source.is_sampled())
    }
}

/// The stiffness K in Rayleigh and modal damping.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum DampingStiffness {
    /// K without the contacts.
    #[default]
    WithoutContacts,
    /// K with the elastic contacts at their initial stiffness.
    Initial,
}

/// Which exact motion histories and error metrics compare with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reference {
    /// That of the same softened laws.
    Softened,
    /// That of the rigid laws, with Coulomb friction and impacts without compliance.
    Rigid,
}

/// A node with its mass.
#[derive(Debug, Clone)]
pub struct Mass {
    /// Name of the node.
    pub name: String,
    /// Its mass, >= 0.
    pub mass: Amount,
    /// The direction in which it moves.
    pub direction: Direction,
}

/// Matrices of another program.
#[derive(Debug, Clone)]
pub struct Matrices {
    /// Its name.
    pub name: String,
    /// Its place in the study, and its path there.
    pub place: (usize, String),
    /// The first of the variants; all have the same rows.
    pub imported: Arc<Imported>,
    /// The matrices by the files that parameters choose.
    pub variants: Vec<Variant>,
    /// Which rows are nodes.
    pub rows: Arc<Rows>,
    /// Their reduction, if the study asks for one.
    pub reduce: Option<Reduce>,
}

/// Matrices, and the rows of the parameters that choose their files with the names of these files.
pub type Variant = (Vec<(usize, &'static str)>, Arc<Imported>);

impl Matrices {
    /// The matrices of a case.
    pub fn in_case(&self, case: &Case) -> &Imported {
        let chosen = |of: &&Variant| of.0.iter().all(|(row, file)| case.name_at(*row) == *file);
        let variant = self.variants.iter().find(chosen);
        variant.map_or(&self.imported, |variant| &variant.1)
    }
}

/// A uniform bar of n two-node elements with lumped masses.
#[derive(Debug, Clone)]
pub struct Bar {
    /// Its name.
    pub name: String,
    /// Length L.
    pub length: Amount,
    /// Axial stiffness E A.
    pub stiffness: Amount,
    /// Mass of the whole bar.
    pub mass: Amount,
    /// Number of elements n.
    pub elements: Amount,
    /// Dashpot of an element over its stiffness; a time.
    pub stiffness_damping: Option<Amount>,
    /// The direction in which its nodes move.
    pub direction: Direction,
}

/// A spring with a dashpot.
#[derive(Debug, Clone)]
pub struct Spring {
    /// Its name; empty without one.
    pub name: String,
    /// The nodes whose displacements make its extension.
    pub along: Vec<Term>,
    /// Its numbers.
    pub numbers: SpringNumbers,
}

/// How a spring is given.
#[derive(Debug, Clone)]
pub enum SpringNumbers {
    /// Stiffness k and dashpot c.
    Stiffness {
        /// k; below 0 where other parts hold the nodes.
        k: Amount,
        /// c, >= 0; none for 0.
        c: Option<Amount>,
    },
    /// k = mass (2 pi/period)^2, c = 2 ratio (2 pi/period) mass.
    Period {
        /// Mass, > 0.
        mass: Amount,
        /// Period, > 0.
        period: Amount,
        /// Damping ratio, >= 0; none for 0.
        ratio: Option<Amount>,
    },
}

/// A force on nodes.
#[derive(Debug, Clone)]
pub struct Load {
    /// The node, or all nodes with the same force on each.
    pub at: Moved,
    /// The force.
    pub force: Scaled,
}

/// A static load, which acts before t = 0 and stays.
#[derive(Debug, Clone)]
pub enum StaticLoad {
    /// A force on one node, or on each of several.
    Force(Moved, Amount),
    /// An acceleration of all masses in a direction, such as -9.81 in y.
    Gravity(Direction, Amount),
}

/// Displacement and velocity at t = 0 of one node, or of several.
#[derive(Debug, Clone)]
pub struct Start {
    /// Where.
    pub of: Moved,
    /// u(0); none for 0.
    pub u: Option<Amount>,
    /// u'(0); none for 0.
    pub v: Option<Amount>,
}

/// What a start moves, or a load acts on.
#[derive(Debug, Clone)]
pub enum Moved {
    /// A node.
    Node(NodeName),
    /// All nodes of a bar, by its place in the list.
    Bar(usize),
    /// All rows of matrices of a direction, by the place of the matrices in the list.
    Rows(usize, Direction),
    /// A tied dof of matrices: the rows of which it is the sum, with their factors.
    Tied(Vec<(f64, NodeName)>),
}
