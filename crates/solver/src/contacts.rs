//! Contacts and their laws.

/// A place where a force S acts on the nodes of `along` by their factors, with r = factors times u + `gap` in the unit of u: a gap that
/// closes, a sliding surface or a part between two nodes.
///
/// A block that slides with 2 against a friction of 1 stops after u = v^2/2:
///
/// ```
/// use slipgap_solver::{ClippedLine, Contact, Direction, Limit, Node, Structure, StructureLaw, exact};
///
/// let mut block = Structure::new(vec![Node { name: "block".into(), mass: 1.0, direction: Direction::X }]);
/// let law = StructureLaw::new(ClippedLine::Coulomb, Limit::constant(1.0));
/// block.contacts.push(Contact { name: "floor".into(), along: vec![(0, 1.0)], gap: 0.0, law });
/// block.velocity[0] = 2.0;
/// assert_eq!(exact(&block, &[5.0])?.displacement, [[2.0]]);
/// # Ok::<(), slipgap_solver::Unsolvable>(())
/// ```
#[doc(inline)]
pub use slipgap_system::system::structure::Contact;

/// A law with what the structure adds: the friction limit, and for a rigid form the restitution that it aims at.
///
/// ```
/// use slipgap_solver::{ContactKind, Limit, StructureLaw, laws::Tanh};
///
/// let law = Tanh { compliance: 0.1, limit: 2.0, ratio: 1.0, rate: 0.0 };
/// let friction = StructureLaw::new(slipgap_solver::ContactLaw::Tanh(law), Limit::constant(2.0));
/// assert_eq!(friction.kind(), ContactKind::Friction);
/// assert!(friction.clone().rigid_form().is_rigid());
/// ```
#[doc(inline)]
pub use slipgap_system::system::structure::StructureLaw;

/// The laws with an exact motion from event to event: stiffness in force over length, viscosity in force over velocity, restitution
/// without unit.
///
/// ```
/// use slipgap_solver::ClippedLine;
///
/// assert_eq!(ClippedLine::Spring { stiffness: 4.0 }.stiffness(), Some(4.0));
/// assert!(ClippedLine::Stop { restitution: 1.0 }.is_rigid());
/// ```
#[doc(inline)]
pub use slipgap_contact::contact::ClippedLine;

/// Any law, of those in [`crate::laws`], of the clipped lines or of a program.
///
/// A spring of 4 gives back what a mass of 1 with the speed 3 brings, after half a period:
///
/// ```
/// use slipgap_solver::{ContactLaw, laws::KelvinVoigt};
///
/// let law = ContactLaw::KelvinVoigt(KelvinVoigt { stiffness: 4.0, damping: 0.0 });
/// let impact = law.collision(1.0, 3.0).expect("a law of impact");
/// assert!((impact.restitution - 1.0).abs() < 1e-15 && (impact.overlap - 1.5).abs() < 1e-15);
/// ```
#[doc(inline)]
pub use slipgap_contact::contact::ContactLaw;

/// Impacts have S <= 0 and no limit, friction has a limit, links have neither.
///
/// ```
/// use slipgap_solver::{ClippedLine, ContactKind};
///
/// assert_eq!(ClippedLine::Coulomb.law().kind(), ContactKind::Friction);
/// ```
#[doc(inline)]
pub use slipgap_contact::contact::ContactKind;

/// The error of laws that not all numbers make.
///
/// ```
/// use slipgap_solver::{LawFault, laws::Multilinear};
///
/// assert_eq!(Multilinear::new(&[[2.0, 1.0], [1.0, 2.0]]), Err(LawFault::Table("r must rise")));
/// ```
#[doc(inline)]
pub use slipgap_contact::contact::LawFault;

/// nu N in units of force: a constant, with a part that follows a signal of the normal force.
///
/// ```
/// use slipgap_solver::{Limit, Signal};
///
/// let sine = Signal::Sine { amplitude: 1.0, omega: 1.0, phase: 0.0 };
/// let limit = Limit { varying: Some((3.0, sine.into())), ..Limit::constant(2.0) };
/// assert_eq!(limit.at(0.0), 2.0);
/// // Where nothing presses, the contact is open.
/// assert_eq!(limit.at(-std::f64::consts::FRAC_PI_2), 0.0);
/// ```
#[doc(inline)]
pub use slipgap_system::system::structure::Limit;

/// How the coefficient of friction falls with the force that presses: `at_rest` in units of force, `exponent` without unit.
///
/// ```
/// use slipgap_solver::Pressure;
///
/// let pressure = Pressure { at_rest: 1.0, exponent: 0.5 };
/// assert_eq!(pressure.limit(4.0), 2.0);
/// ```
#[doc(inline)]
pub use slipgap_system::system::structure::Pressure;
