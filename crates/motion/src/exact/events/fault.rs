//! Why there is no exact motion.

use std::fmt;

/// Why there is no exact motion.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum EventsFault {
    /// The motion has too many events.
    TooManyEvents {
        /// The largest number of events.
        most: usize,
        /// The time reached.
        time: f64,
    },
    /// The motion has too many pieces: it is long compared with the shortest period, or a contact is very stiff or viscous.
    TooManyPieces {
        /// The largest number of pieces.
        most: usize,
        /// The time reached.
        time: f64,
    },
    /// A rigid contact is between a node, or the ground, and itself.
    Singular {
        /// The time.
        time: f64,
    },
    /// Contacts change their phases without end at one time.
    Unsettled {
        /// The time.
        time: f64,
    },
    /// A rigid stop starts with r < 0.
    Overlap {
        /// Name of the contact.
        contact: String,
        /// r at t = 0.
        r: f64,
    },
    /// The modes of the structure are too many to compute.
    TooManyModes {
        /// The largest number of nodes.
        most: usize,
    },
    /// M is not positive definite, or M or K is not finite.
    Mass,
    /// Supports move, and a contact is at a node without mass.
    MasslessSupports,
    /// A node without mass has damping, or mass that couples it.
    MasslessDamping {
        /// Name of the node.
        node: String,
    },
    /// Nothing holds a node without mass.
    Unheld {
        /// Name of the node.
        node: String,
    },
    /// Friction with a static limit shares its node without mass.
    SharedJump {
        /// Name of the contact.
        contact: String,
    },
    /// The exact motion does not know a law.
    Law {
        /// Name of the contact.
        contact: String,
    },
}

impl fmt::Display for EventsFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            EventsFault::TooManyEvents { most, time } => {
                write!(
                    f,
                    "the exact motion has more than {most} events up to t = {time}"
                )
            }
            EventsFault::TooManyPieces { most, time } => write!(
                f,
                "the exact motion needs more than {most} pieces up to t = {time}; the structure or a contact is too stiff or too viscous for it, or a load too fast"
            ),
            EventsFault::Singular { time } => write!(
                f,
                "a rigid contact has no force at t = {time}; it must be between two nodes, or a node and the ground"
            ),
            EventsFault::Unsettled { time } => {
                write!(
                    f,
                    "the contacts do not settle at t = {time}; give a rigid contact that shares its load with others a stiffness"
                )
            }
            EventsFault::Overlap { contact, r } => write!(
                f,
                "the rigid stop {contact} overlaps at the start: r must be >= 0, got {r}"
            ),
            EventsFault::TooManyModes { most } => write!(
                f,
                "the exact motion of a structure with coupled masses or nodes without mass takes at most {most} degrees of freedom; reduce the structure"
            ),
            EventsFault::Mass => write!(
                f,
                "the exact motion needs a mass matrix that is positive definite for the nodes with mass, and matrices of finite numbers"
            ),
            EventsFault::MasslessSupports => write!(
                f,
                "the exact motion has no supports that move where a contact is at a node without mass; give the node a mass"
            ),
            EventsFault::MasslessDamping { node } => write!(
                f,
                "node {node} without mass has a damper or a coupled mass; for the exact motion, give it a mass or remove them, as modal_damping does, or compare runs with dt and dt/2 instead"
            ),
            EventsFault::Unheld { node } => write!(
                f,
                "nothing holds node {node} without mass; give it a mass, a spring or a contact"
            ),
            EventsFault::SharedJump { contact } => write!(
                f,
                "contact {contact} has static_ratio above 1 and shares its node without mass with others, on which the jump of its force depends; for the exact motion, give the node a mass"
            ),
            EventsFault::Law { contact } => write!(
                f,
                "the law of contact {contact} is curved or damped, or its coefficient of friction varies with pressure; for friction and impacts that do not yield, possible are the references to rigid laws, with \"contacts_reference\": \"rigid\""
            ),
        }
    }
}

impl std::error::Error for EventsFault {}
