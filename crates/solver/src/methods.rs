//! Methods of integration.

/// What [`crate::run`] steps with. Its order is that of the errors in dt without a contact; a step above [`Method::stability_limit`] over
/// the highest frequency grows without bounds.
///
/// ```
/// use slipgap_solver::{AverageAcceleration, Coefficients, Method};
///
/// assert_eq!(Method::from(AverageAcceleration).order(), 2);
/// assert_eq!(Method::from(Coefficients::central_difference()).stability_limit(), 2.0);
/// ```
#[doc(inline)]
pub use slipgap_system::methods::Method;

/// Newmark's method with beta = 1/4 and gamma = 1/2 (Newmark 1959), of second order and stable for every dt. It keeps the energy of a
/// linear structure:
///
/// ```
/// use slipgap_solver::{AverageAcceleration, Direction, Node, Structure, run};
///
/// let mut mass = Structure::new(vec![Node { name: "mass".into(), mass: 1.0, direction: Direction::X }]);
/// mass.stiffness.add_spring([Some(0), None], 1.0);
/// mass.displacement[0] = 1.0;
/// let motion = run(&mass, &AverageAcceleration.into(), 0.5, 100)?;
/// let [u, v] = [motion.displacement[100][0], motion.velocity[100][0]];
/// assert!((u * u + v * v - 1.0).abs() < 1e-12);
/// # Ok::<(), slipgap_solver::Unsolvable>(())
/// ```
#[doc(inline)]
pub use slipgap_system::methods::AverageAcceleration;

/// Newmark's family and its alpha methods: numbers without units.
///
/// ```
/// use slipgap_solver::{Coefficients, Method};
///
/// // The method of Hilber, Hughes and Taylor (1977) with alpha = 0 is the average acceleration.
/// assert_eq!(Coefficients::hht(0.0), Coefficients::newmark(0.25, 0.5));
/// assert_eq!(Method::from(Coefficients::generalized_alpha(0.8)).order(), 2);
/// ```
#[doc(inline)]
pub use slipgap_system::methods::Coefficients;

/// Two sub-steps (Bathe and Baig 2005): of second order, stable for every dt; it damps frequencies that dt does not resolve.
///
/// From rest at 1 with omega dt = 1 it steps to (144 - 47)/((9 + 1) (16 + 1)):
///
/// ```
/// use slipgap_solver::{Bathe, Direction, Node, Structure, run};
///
/// let mut mass = Structure::new(vec![Node { name: "mass".into(), mass: 1.0, direction: Direction::X }]);
/// mass.stiffness.add_spring([Some(0), None], 1.0);
/// mass.displacement[0] = 1.0;
/// let motion = run(&mass, &Bathe.into(), 1.0, 1)?;
/// assert!((motion.displacement[1][0] - 97.0 / 170.0).abs() < 1e-14);
/// # Ok::<(), slipgap_solver::Unsolvable>(())
/// ```
#[doc(inline)]
pub use slipgap_system::methods::Bathe;

/// Velocities and impulses (Moreau 1988, Jean 1999): the only method with a restitution of rigid stops. theta is from 1/2 to 1.
///
/// ```
/// use slipgap_solver::{ClippedLine, Contact, Direction, MoreauJean, Node, Structure, StructureLaw, run};
///
/// let mut ball = Structure::new(vec![Node { name: "ball".into(), mass: 1.0, direction: Direction::X }]);
/// let law = StructureLaw::new(ClippedLine::Stop { restitution: 0.5 }, None);
/// ball.contacts.push(Contact { name: "wall".into(), along: vec![(0, 1.0)], gap: 0.1, law });
/// ball.velocity[0] = -2.0;
/// let motion = run(&ball, &MoreauJean { theta: 0.5 }.into(), 0.01, 20)?;
/// assert!((motion.velocity[20][0] - 1.0).abs() < 1e-12);
/// # Ok::<(), slipgap_solver::Unsolvable>(())
/// ```
#[doc(inline)]
pub use slipgap_system::methods::MoreauJean;

/// Newmark's method with the displacements of rigid contacts corrected before a step (Deuflhard, Krause and Ertel 2008). Without
/// contacts it is the average acceleration:
///
/// ```
/// use slipgap_solver::{ContactStabilized, Direction, Node, Structure, run};
///
/// let mut mass = Structure::new(vec![Node { name: "mass".into(), mass: 1.0, direction: Direction::X }]);
/// mass.velocity[0] = 3.0;
/// let motion = run(&mass, &ContactStabilized.into(), 0.1, 10)?;
/// assert!((motion.displacement[10][0] - 3.0).abs() < 1e-14);
/// # Ok::<(), slipgap_solver::Unsolvable>(())
/// ```
#[doc(inline)]
pub use slipgap_system::methods::ContactStabilized;
