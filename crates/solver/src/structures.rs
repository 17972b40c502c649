//! Structures, their loads and supports.

/// M u'' + C u' + K u + B S = p(t): with n nodes and m contacts, matrices of n by n numbers, `displacement` and `velocity` of n numbers
/// and m `contacts`, in any units that belong together. [`crate::run`] refuses other sizes, and a node that is none.
///
/// Two masses of 1 between springs of 1 have the frequencies 1 and 3^(1/2):
///
/// ```
/// use slipgap_solver::{Direction, Node, Structure, exact};
///
/// let node = |name: &str| Node { name: name.into(), mass: 1.0, direction: Direction::X };
/// let mut chain = Structure::new(vec![node("left"), node("right")]);
/// for ends in [[None, Some(0)], [Some(0), Some(1)], [Some(1), None]] {
///     chain.stiffness.add_spring(ends, 1.0);
/// }
/// chain.displacement = vec![1.0, 1.0];
/// let motion = exact(&chain, &[std::f64::consts::PI])?;
/// assert!((motion.displacement[0][1] + 1.0).abs() < 1e-12);
/// # Ok::<(), slipgap_solver::Unsolvable>(())
/// ```
#[doc(inline)]
pub use slipgap_system::system::structure::Structure;

/// Masses, springs and contacts by their names: the way from a mass to a case with two contacts.
///
/// A mass of 1 on a spring of 4 swings with the frequency 2:
///
/// ```
/// use slipgap_solver::{Structure, exact};
///
/// let mass = Structure::builder().mass("mass", 1.0).spring(["ground", "mass"], 4.0);
/// let motion = exact(&mass.start("mass", [1.0, 0.0]).build()?, &[std::f64::consts::FRAC_PI_2])?;
/// assert!((motion.displacement[0][0] + 1.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(inline)]
pub use slipgap_system::system::structure::StructureBuilder;

/// Why a structure cannot be built.
///
/// ```
/// use slipgap_solver::{BuildFault, Structure};
///
/// let fault = Structure::builder().mass("a", 1.0).spring(["a", "b"], 4.0).build().err();
/// assert_eq!(fault, Some(BuildFault::Unknown("b".into())));
/// ```
#[doc(inline)]
pub use slipgap_system::system::structure::BuildFault;

/// `mass` in force over acceleration, or a moment of inertia for a rotation; 0 for a node that follows its springs and contacts.
///
/// ```
/// use slipgap_solver::{Direction, Node, Structure};
///
/// let slab = Node { name: "slab".into(), mass: 2.5, direction: Direction::Y };
/// assert_eq!(Structure::new(vec![slab]).mass().entries().next(), Some(((0, 0), 2.5)));
/// ```
#[doc(inline)]
pub use slipgap_system::system::structure::Node;

/// The direction of a node, which loads and reports use. Equations do not: each node has one displacement.
///
/// ```
/// use slipgap_solver::Direction;
///
/// assert_eq!(Direction::named("rz"), Some(Direction::Rz));
/// assert_eq!(Direction::ALL.len(), 6);
/// ```
#[doc(inline)]
pub use slipgap_system::system::structure::Direction;

/// M, C or K: n by n, of which entries that are not zero take room. Entries (i, j) and (j, i) are one.
///
/// ```
/// use slipgap_solver::Symmetric;
///
/// let mut stiffness = Symmetric::zeros(2);
/// stiffness.add_spring([Some(0), Some(1)], 3.0);
/// let entries: Vec<_> = stiffness.entries().collect();
/// assert_eq!(entries, [((0, 0), 3.0), ((1, 0), -3.0), ((1, 1), 3.0)]);
/// ```
#[doc(inline)]
pub use slipgap_system::system::structure::Symmetric;

/// p(t) = pattern times signal: (node, force for a signal of 1). The ground's acceleration has the pattern -mass.
///
/// A force of 1 on a mass of 1 moves it by t^2/2:
///
/// ```
/// use slipgap_solver::{Direction, Load, Node, Signal, Structure, exact};
///
/// let mut mass = Structure::new(vec![Node { name: "mass".into(), mass: 1.0, direction: Direction::X }]);
/// mass.loads.push(Load { pattern: vec![(0, 1.0)], signal: Signal::constant(1.0).into() });
/// assert!((exact(&mass, &[4.0])?.displacement[0][0] - 8.0).abs() < 1e-12);
/// # Ok::<(), slipgap_solver::Unsolvable>(())
/// ```
#[doc(inline)]
pub use slipgap_system::system::structure::Load;

/// A load, a normal force or an acceleration over time, in the unit of what it multiplies.
///
/// ```
/// use slipgap_solver::Signal;
///
/// let sine = Signal::Sine { amplitude: 2.0, omega: 1.0, phase: 0.0 };
/// assert!((sine.at(std::f64::consts::FRAC_PI_2) - 2.0).abs() < 1e-15);
/// assert_eq!(Signal::constant(3.0).at(7.0), 3.0);
/// ```
#[doc(inline)]
pub use slipgap_system::system::structure::Signal;

/// A record, or any other points: as many times as values. [`Table::new`] gives `None` for other lengths, for times that fall and for
/// numbers that are not finite.
///
/// ```
/// use slipgap_solver::Table;
///
/// let ramp = Table::new(vec![0.0, 2.0], vec![0.0, 5.0]).expect("times that rise");
/// assert_eq!([ramp.at(1.0), ramp.at(9.0)], [2.5, 5.0]);
/// assert_eq!(Table::new(vec![1.0, 0.0], vec![0.0; 2]), None);
/// ```
#[doc(inline)]
pub use slipgap_system::system::structure::Table;

/// u, v and a of a support. [`Motion::new`] fails for a sine with a baseline, for a table that ends at t = 0 with one, and for numbers that
/// are not finite.
///
/// An acceleration of 2 from t = 1 on:
///
/// ```
/// use slipgap_solver::{Baseline, Motion, Signal};
///
/// let motion = Motion::new(&Signal::constant(2.0), 1.0, 1.0, Baseline::None).expect("a motion");
/// assert_eq!(motion.at(4.0), [9.0, 6.0, 2.0]);
/// ```
#[doc(inline)]
pub use slipgap_system::system::structure::Motion;

/// What a [`Motion`] takes from the acceleration of a table, so that its velocity does not grow.
///
/// ```
/// use slipgap_solver::{Baseline, Motion, Signal, Table};
///
/// let table = Table::new(vec![0.0, 1.0, 2.0], vec![1.0, 3.0, 2.0]).expect("a table");
/// let motion = Motion::new(&Signal::Table(table), 1.0, 0.0, Baseline::Linear).expect("a motion");
/// assert!(motion.at(2.0)[1].abs() < 1e-15);
/// ```
#[doc(inline)]
pub use slipgap_system::system::structure::Baseline;

/// A support of a [`Structure`] that moves: `carried` has a number for each node, `gaps` one for each contact. [`Structure::prescribe`] makes
/// them from matrices whose last rows are those of the supports.
///
/// A mass on a spring whose other end moves by t^2:
///
/// ```
/// use slipgap_solver::{Baseline, Direction, Motion, Node, Signal, Structure};
///
/// let mut mass = Structure::new(vec![Node { name: "mass".into(), mass: 1.0, direction: Direction::X }]);
/// mass.stiffness = slipgap_solver::Symmetric::zeros(2);
/// mass.stiffness.add_spring([Some(0), Some(1)], 4.0);
/// let motion = Motion::new(&Signal::constant(2.0), 1.0, 0.0, Baseline::None).expect("a motion");
/// mass.prescribe(vec![("ground".into(), motion.into())]);
/// assert_eq!(mass.supports[0].carried, [1.0]);
/// // The whole displacement of a mass that has not moved against the support yet.
/// assert_eq!(mass.total(0, 3.0, 0, &[0.0]), 9.0);
/// ```
#[doc(inline)]
pub use slipgap_system::system::structure::Support;

/// Static loads: `load` has a force for each node, or is empty. [`crate::run`] and [`crate::exact`] find the equilibrium, and fail with
/// [`crate::Unsolvable::NoEquilibrium`] where there is none. A static load acts on after t = 0, so that it is among the loads, too.
///
/// ```
/// use slipgap_solver::{Direction, Load, Node, Signal, Structure, exact};
///
/// let mut mass = Structure::new(vec![Node { name: "mass".into(), mass: 1.0, direction: Direction::X }]);
/// mass.stiffness.add_spring([Some(0), None], 4.0);
/// mass.preload.load = vec![2.0];
/// mass.loads.push(Load { pattern: vec![(0, 2.0)], signal: Signal::constant(1.0).into() });
/// assert!((exact(&mass, &[3.0])?.displacement[0][0] - 0.5).abs() < 1e-12);
/// # Ok::<(), slipgap_solver::Unsolvable>(())
/// ```
#[doc(inline)]
pub use slipgap_system::system::structure::Preload;
