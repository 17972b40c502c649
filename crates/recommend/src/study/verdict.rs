//! What becomes of a candidate, and what further tests of it show.

/// What becomes of a candidate.
#[derive(Debug, Clone, PartialEq)]
pub enum State {
    /// It keeps every metric.
    Keeps,
    /// It misses a tolerance.
    Misses,
    /// It gains or loses too much energy.
    Energy,
    /// One of its contacts may make energy, as its warnings say.
    ContactEnergy,
    /// A case has no solution, for this reason.
    Unsolved(String),
    /// It does not have all physical cases.
    Incomplete,
}

/// The largest quotients of error and tolerance in further tests of a candidate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trial {
    /// With finer steps.
    pub step: f64,
    /// With the next finer mesh.
    pub mesh: Mesh,
    /// Of its neighbours; 0 if it needs none.
    pub neighbours: f64,
    /// With fresh seeds; `None` if the study has none, and for a candidate that fails before.
    pub fresh: Option<f64>,
}

impl Trial {
    /// Whether it keeps the metrics with a finer step and mesh.
    pub fn is_converged(&self) -> bool {
        self.step <= 1.0 && self.mesh.holds()
    }

    /// Whether its neighbours and fresh seeds keep the metrics, too.
    pub(super) fn is_robust(&self) -> bool {
        self.neighbours <= 1.0 && self.fresh.is_none_or(|quotient| quotient <= 1.0)
    }

    /// Whether the metrics are kept in all tests.
    pub fn holds(&self) -> bool {
        self.is_converged() && self.is_robust()
    }
}

/// What a finer mesh shows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Mesh {
    /// The study does not choose a mesh.
    NotChosen,
    /// No candidate has a finer one.
    Finest,
    /// The largest quotient with the next finer one among the candidates.
    Next(f64),
}

impl Mesh {
    /// Whether the metrics are kept there, too.
    pub(super) fn holds(self) -> bool {
        match self {
            Mesh::NotChosen => true,
            Mesh::Finest => false,
            Mesh::Next(quotient) => quotient <= 1.0,
        }
    }
}
