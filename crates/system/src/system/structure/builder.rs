//! Builds a structure from masses, springs and contacts by their names.

use super::{Along, Contact, Direction, Load, Node, Signal, Structure, StructureLaw, between};
use std::fmt;
use std::sync::Arc;

/// Builds a [`Structure`] of masses that move along x: each by its name, the ground as `ground`.
///
/// A mass on a spring and a dashpot, in any units that belong together:
///
/// ```
/// use slipgap_system::system::structure::Structure;
///
/// let builder = Structure::builder().mass("deck", 100.0);
/// let builder = builder.spring(["ground", "deck"], 4000.0).damper(["ground", "deck"], 60.0);
/// let alone = builder.clone().build()?;
/// assert_eq!((alone.len(), alone.contacts.len()), (1, 0));
/// # Ok::<(), slipgap_system::system::structure::BuildFault>(())
/// ```
///
/// A second mass with a gap of 0.02 between both, which a stiff spring closes, and friction of 150 under the deck. An impact pushes
/// its two bodies apart where r = u_j - u_i + gap < 0:
///
/// ```
/// # use slipgap_contact::contact::ClippedLine;
/// # use slipgap_system::system::structure::{Limit, Signal, Structure, StructureLaw};
/// # let builder = Structure::builder().mass("deck", 100.0);
/// # let builder = builder.spring(["ground", "deck"], 4000.0).damper(["ground", "deck"], 60.0);
/// let spring = StructureLaw::new(ClippedLine::Spring { stiffness: 1e6 }, Limit::constant(0.0));
/// let friction = StructureLaw::new(ClippedLine::Coulomb, Limit::constant(150.0));
/// let structure = builder
///     .mass("next", 80.0)
///     .spring(["ground", "next"], 9000.0)
///     .contact("joint", ["deck", "next"], 0.02, spring)
///     .contact("bearing", ["ground", "deck"], 0.0, friction)
///     .ground(&Signal::Sine { amplitude: 3.0, omega: 6.0, phase: 0.0 })
///     .start("deck", [0.01, 0.0])
///     .build()?;
/// let r = structure.relative(0, &[0.05, 0.02]) + structure.contacts[0].gap;
/// assert!((r - (0.02 - 0.05 + 0.02)).abs() < 1e-15);
/// # Ok::<(), slipgap_system::system::structure::BuildFault>(())
/// ```
///
/// `slipgap_solver::run` steps it, `slipgap_solver::exact` gives its exact motion.
#[derive(Debug, Clone, Default)]
pub struct StructureBuilder {
    nodes: Vec<Node>,
    springs: Vec<([String; 2], f64)>,
    dampers: Vec<([String; 2], f64)>,
    contacts: Vec<(String, [String; 2], f64, StructureLaw)>,
    loads: Vec<(String, Arc<Signal>)>,
    ground: Vec<Arc<Signal>>,
    starts: Vec<(String, [f64; 2])>,
}

/// Why a structure cannot be built.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum BuildFault {
    /// No mass has this name.
    Unknown(String),
    /// Several masses, or several contacts, have this name, or a mass is called `ground`.
    Taken(String),
}

impl fmt::Display for BuildFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BuildFault::Unknown(name) => write!(f, "no mass is called \"{name}\""),
            BuildFault::Taken(name) => write!(f, "the name \"{name}\" is taken"),
        }
    }
}

impl std::error::Error for BuildFault {}

/// Name of the ground.
const GROUND: &str = "ground";

impl Structure {
    /// A structure from masses, springs and contacts by their names.
    pub fn builder() -> StructureBuilder {
        StructureBuilder::default()
    }
}

impl StructureBuilder {
    /// A mass; 0 for a node that follows its springs and contacts.
    #[must_use]
    pub fn mass(mut self, name: &str, mass: f64) -> StructureBuilder {
        self.nodes.push(Node {
            name: name.to_owned(),
            mass,
            direction: Direction::X,
        });
        self
    }

    /// A spring with a stiffness in force over length.
    #[must_use]
    pub fn spring(mut self, ends: [&str; 2], stiffness: f64) -> StructureBuilder {
        self.springs.push((ends.map(str::to_owned), stiffness));
        self
    }

    /// A dashpot in force over velocity.
    #[must_use]
    pub fn damper(mut self, ends: [&str; 2], damping: f64) -> StructureBuilder {
        self.dampers.push((ends.map(str::to_owned), damping));
        self
    }

    /// A contact between i and j: r = u_j - u_i + gap.
    #[must_use]
    pub fn contact(
        mut self,
        name: &str,
        ends: [&str; 2],
        gap: f64,
        law: StructureLaw,
    ) -> StructureBuilder {
        let ends = ends.map(str::to_owned);
        self.contacts.push((name.to_owned(), ends, gap, law));
        self
    }

    /// A force on a mass.
    #[must_use]
    pub fn load(mut self, mass: &str, force: &Signal) -> StructureBuilder {
        self.loads.push((mass.to_owned(), force.clone().into()));
        self
    }

    /// An acceleration of the ground, so that displacements are relative to it.
    #[must_use]
    pub fn ground(mut self, acceleration: &Signal) -> StructureBuilder {
        self.ground.push(acceleration.clone().into());
        self
    }

    /// Displacement and velocity of a mass at t = 0.
    #[must_use]
    pub fn start(mut self, mass: &str, state: [f64; 2]) -> StructureBuilder {
        self.starts.push((mass.to_owned(), state));
        self
    }

    /// The structure.
    ///
    /// # Errors
    /// A name that no mass has, and one that is taken.
    pub fn build(self) -> Result<Structure, BuildFault> {
        let masses = self.nodes.iter().map(|node| node.name.as_str());
        unique(masses.chain([GROUND]))?;
        unique(self.contacts.iter().map(|contact| contact.0.as_str()))?;
        let mut structure = Structure::new(self.nodes);
        let nodes = structure.nodes.clone();
        let index_of = |name: &str| {
            let found = nodes.iter().position(|node| node.name == name);
            found.ok_or_else(|| BuildFault::Unknown(name.to_owned()))
        };
        let end = |name: &String| match name == GROUND {
            true => Ok(None),
            false => index_of(name).map(Some),
        };
        let ends = |[i, j]: &[String; 2]| Ok([end(i)?, end(j)?]);
        for (between, stiffness) in &self.springs {
            structure.stiffness.add_spring(ends(between)?, *stiffness);
        }
        for (between, damping) in &self.dampers {
            structure.damping.add_spring(ends(between)?, *damping);
        }
        for (name, nodes, gap, law) in self.contacts {
            let along: Along = between(ends(&nodes)?);
            structure.contacts.push(Contact {
                name,
                along,
                gap,
                law,
            });
        }
        for (mass, signal) in self.loads {
            let pattern = vec![(index_of(&mass)?, 1.0)];
            structure.loads.push(Load { pattern, signal });
        }
        for signal in self.ground {
            let numbered = nodes.iter().enumerate();
            let pattern = numbered.map(|(i, node)| (i, -node.mass)).collect();
            structure.loads.push(Load { pattern, signal });
        }
        for (mass, [u, v]) in self.starts {
            let node = index_of(&mass)?;
            structure.displacement[node] = u;
            structure.velocity[node] = v;
        }
        Ok(structure)
    }
}

/// That no two names are the same.
fn unique<'a>(names: impl Iterator<Item = &'a str>) -> Result<(), BuildFault> {
    let mut known = std::collections::BTreeSet::new();
    let mut names = names;
    let taken = names.find(|name| !known.insert(*name));
    taken.map_or(Ok(()), |name| Err(BuildFault::Taken(name.to_owned())))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::structure::Limit;
    use slipgap_contact::contact::ClippedLine;

    #[test]
    fn names_give_the_matrices_of_the_textbook() {
        let law = StructureLaw::new(ClippedLine::Coulomb, Limit::constant(1.0));
        let built = Structure::builder()
            .mass("a", 2.0)
            .mass("b", 3.0)
            .spring(["ground", "a"], 5.0)
            .spring(["b", "a"], 7.0)
            .damper(["a", "b"], 0.5)
            .contact("c", ["a", "b"], 0.1, law)
            .load("b", &Signal::constant(4.0))
            .ground(&Signal::constant(9.0))
            .start("b", [0.2, -0.3])
            .build()
            .unwrap();
        let dense = |matrix: &super::super::Symmetric| -> Vec<_> { matrix.entries().collect() };
        assert_eq!(
            dense(&built.stiffness),
            [((0, 0), 12.0), ((1, 0), -7.0), ((1, 1), 7.0)]
        );
        assert_eq!(
            dense(&built.damping),
            [((0, 0), 0.5), ((1, 0), -0.5), ((1, 1), 0.5)]
        );
        assert_eq!(built.contacts[0].along, [(0, -1.0), (1, 1.0)]);
        // -m a, and the force on b.
        let mut force = [0.0; 2];
        built.add_loads(1.0, &mut force);
        assert_eq!(force, [-18.0, 4.0 - 27.0]);
        assert_eq!(
            (&built.displacement[..], &built.velocity[..]),
            (&[0.0, 0.2][..], &[0.0, -0.3][..])
        );
    }

    #[test]
    fn a_name_that_no_mass_has_or_that_is_taken_is_refused() {
        let law = || StructureLaw::new(ClippedLine::Coulomb, Limit::constant(1.0));
        let one = || Structure::builder().mass("a", 1.0);
        let unknown = |name: &str| Err(BuildFault::Unknown(name.to_owned()));
        let fault = |builder: StructureBuilder| builder.build().map(|_| ());
        assert_eq!(fault(one().spring(["a", "b"], 1.0)), unknown("b"));
        assert_eq!(fault(one().start("ground", [0.0; 2])), unknown("ground"));
        assert_eq!(fault(one().load("x", &Signal::constant(1.0))), unknown("x"));
        let taken = |name: &str| Err(BuildFault::Taken(name.to_owned()));
        assert_eq!(fault(one().mass("a", 2.0)), taken("a"));
        assert_eq!(fault(one().mass("ground", 2.0)), taken("ground"));
        let twice = one().contact("c", ["a", "ground"], 0.0, law());
        assert_eq!(
            fault(twice.contact("c", ["a", "ground"], 0.0, law())),
            taken("c")
        );
    }
}
