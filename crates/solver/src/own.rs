//! Laws of a program.

/// A law that is written outside of slipgap: S of a contact at the end of a step, in units of force. The example `own_law` has one that
/// yields; here is a dashpot with S = 2 rdot, under which a mass of 1 with the speed 3 comes to rest after 3/2:
///
/// ```
/// use slipgap_solver::{
///     AverageAcceleration, Contact, ContactLaw, Direction, Node, Own, OwnAnswer, OwnLaw, OwnState, OwnStep, Structure,
///     StructureLaw, run,
/// };
///
/// #[derive(Debug)]
/// struct Dashpot;
///
/// impl OwnLaw for Dashpot {
///     fn answer(&self, step: &OwnStep, state: &OwnState) -> OwnAnswer {
///         OwnAnswer { force: 2.0 * step.to[1], slopes: [0.0, 2.0], state: *state }
///     }
///
///     fn largest_stiffness(&self) -> f64 {
///         0.0
///     }
/// }
///
/// let mut mass = Structure::new(vec![Node { name: "mass".into(), mass: 1.0, direction: Direction::X }]);
/// let law = StructureLaw::new(ContactLaw::Own(Own::new(&Dashpot)), None);
/// mass.contacts.push(Contact { name: "dashpot".into(), along: vec![(0, 1.0)], gap: 0.0, law });
/// mass.velocity[0] = 3.0;
/// let motion = run(&mass, &AverageAcceleration.into(), 0.01, 2000)?;
/// assert!((motion.displacement[2000][0] - 1.5).abs() < 1e-12);
/// # Ok::<(), slipgap_solver::Unsolvable>(())
/// ```
#[doc(inline)]
pub use slipgap_contact::contact::OwnLaw;

/// What makes a [`crate::ContactLaw`] of an [`OwnLaw`]. The law lives as long as the program, since each case copies the reference: a
/// `static`, or `Box::leak`.
///
/// ```
/// # use slipgap_solver::{OwnAnswer, OwnLaw, OwnState, OwnStep};
/// # #[derive(Debug)]
/// # struct Spring;
/// # impl OwnLaw for Spring {
/// #     fn answer(&self, step: &OwnStep, state: &OwnState) -> OwnAnswer {
/// #         OwnAnswer { force: 4.0 * step.to[0], slopes: [4.0, 0.0], state: *state }
/// #     }
/// #     fn largest_stiffness(&self) -> f64 { 4.0 }
/// # }
/// use slipgap_solver::{ContactKind, ContactLaw, Own};
///
/// // A law with `struct Spring;` and `impl OwnLaw for Spring`.
/// let law = ContactLaw::Own(Own::new(&Spring));
/// assert_eq!(law.kind(), ContactKind::Link);
/// assert_eq!(law.properties().largest_stiffness(0.0), 4.0);
/// ```
#[doc(inline)]
pub use slipgap_contact::contact::Own;

/// What an [`OwnLaw`] is asked: r in units of displacement, rdot in units of velocity, `dt` in units of time, `limit` in units of force.
///
/// ```
/// use slipgap_solver::OwnStep;
///
/// let step = OwnStep { from: [0.0, 2.0], to: [0.5, 1.0], dt: 0.25, limit: 0.0 };
/// assert_eq!((step.to[0] - step.from[0]) / step.dt, 2.0);
/// ```
#[doc(inline)]
pub use slipgap_contact::contact::OwnStep;

/// What an [`OwnLaw`] answers: S in units of force, its slopes in force over displacement and force over velocity.
///
/// ```
/// use slipgap_solver::{OwnAnswer, OwnState};
///
/// let free = OwnAnswer { force: 0.0, slopes: [0.0; 2], state: OwnState::default() };
/// assert_eq!(free.state, [0.0; 8]);
/// ```
#[doc(inline)]
pub use slipgap_contact::contact::OwnAnswer;

/// Eight numbers of an [`OwnLaw`], in whatever units it has.
///
/// ```
/// let state = slipgap_solver::OwnState::default();
/// assert_eq!(state.len(), 8);
/// ```
#[doc(inline)]
pub use slipgap_contact::contact::OwnState;

/// Why the answer of an [`OwnLaw`] is not taken; [`crate::Unsolvable::OwnLaw`] has it with the step and the contact.
///
/// ```
/// assert_eq!(slipgap_solver::OwnFault::NotFinite.to_string(), "answers with NaN or infinity");
/// ```
#[doc(inline)]
pub use slipgap_contact::contact::OwnFault;
