//! Results over groups of cases that a figure shows and its table has: Sobol' indices and fragility functions.

pub mod annual;
pub mod fragility;
mod members;
pub mod point;
pub mod sobol;

use crate::DrawnCase;
use fragility::FragilityCurve;
use slipgap_study::kinds::FigureKind;
use slipgap_study::{Figure, Study};
use sobol::{DesignMetrics, Estimates};

/// What a figure shows besides its cases.
#[derive(Debug, Default)]
pub enum GroupResults<'a> {
    /// Nothing.
    #[default]
    None,
    /// Sobol' indices of a design.
    Indices {
        /// The block with the design.
        block: usize,
        /// The indices of each metric of the figure.
        estimates: Vec<&'a Estimates>,
    },
    /// The curves of a fragility figure.
    Fragility(Vec<FragilityCurve>),
}

impl<'a> GroupResults<'a> {
    /// Computes them for the cases that the figure shows, in their order. Indices are those of `designs`.
    pub fn new(
        study: &Study,
        figure: &Figure,
        cases: &[DrawnCase],
        designs: &'a DesignMetrics,
    ) -> GroupResults<'a> {
        if let FigureKind::Sobol(kind) = &figure.kind {
            return designs.indices(study, figure, cases.len(), &kind.y);
        }
        match figure.kind.fragility() {
            Some(kind) => GroupResults::Fragility(fragility::curves(study, kind, cases)),
            None => GroupResults::None,
        }
    }
}
