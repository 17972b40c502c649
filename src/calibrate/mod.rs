//! Calibration: the values of free parameters with which a study comes nearest to what was measured, for each of its alternatives.
//!
//! Each alternative, such as a law, has a search of its own over its free parameters (`misfit` solves the cases), then a profile of
//! the misfit for each of them. `numerics` says how much of the misfit the time step and the mesh may be, `residuals` whether what is
//! left is noise, `scatter` how parameters vary from test to test, `compare` which alternatives are told apart.

mod channel;
mod compare;
mod explain;
mod figure_data;
mod fit;
mod misfit;
mod numerics;
mod residuals;
mod scatter;
mod sentences;
mod tables;
mod words;
mod write;

pub use compare::{Comparison, Verdict};
pub use explain::explained;
pub use fit::{Fit, State};
pub use numerics::Numerical;
pub use residuals::Residuals;
pub use scatter::Scatter;
pub use sentences::sentences;
pub use words::{state_name, text, verdict};
pub use write::{check_folder, studies, write};

use crate::run::Source;
use indicatif::ProgressBar;
use slipgap_recommend::Stop;
use slipgap_recommend::study::usage;
use slipgap_study::error::Error;
use slipgap_study::{Alternative, Free, MOST_CASES, Study};

/// What a calibration found.
#[derive(Debug)]
pub struct Calibration {
    /// The study with the metric that is minimised as its only one.
    pub study: Study,
    /// One for each alternative, in the order of the study.
    pub fits: Vec<Fit>,
    /// Positions in `fits`, the smallest misfit first; those without a solution are last.
    pub order: Vec<usize>,
    /// The best alternative with each of the others that have a solution.
    pub comparisons: Vec<Comparison>,
}

impl Calibration {
    /// The best fit; `None` if no alternative has a solution.
    pub fn best(&self) -> Option<&Fit> {
        let first = self.order.first().map(|at| &self.fits[*at]);
        first.filter(|fit| fit.misfit().is_finite())
    }

    /// Number of cases solved.
    pub fn solved(&self) -> u64 {
        let each = self.fits.iter().flat_map(|fit| &fit.each);
        self.fits.iter().chain(each).map(|fit| fit.solved).sum()
    }
}

/// The free parameters that an alternative uses, and those that it does not.
fn used(study: &Study, alternative: &Alternative) -> [Vec<Free>; 2] {
    let minimised: Vec<usize> = study
        .calibrate
        .iter()
        .map(|calibrate| calibrate.minimise)
        .collect();
    usage::used(study, alternative, &study.free_of(alternative), &minimised)
}

/// Calibrates a study. `bar` counts the cases.
///
/// # Errors
/// The study has no `calibrate`, or `stop` ended the search.
pub fn calibrate(source: &Source, bar: &ProgressBar, stop: &Stop) -> Result<Calibration, Error> {
    let none = || {
        Error::Usage(source.line(
            "the study has no key \"calibrate\", which names the free parameters, as in \"calibrate\": {\"k_h\": {\"log\": [1e4, 1e7]}, \
             \"minimise\": \"rms_error(deck.u, measured)\"}",
        ))
    };
    source.study.calibrate.as_ref().ok_or_else(none)?;
    let input = source.input();
    let study = input.search_study(MOST_CASES)?;
    // Its rows of measures are others than those of the whole study.
    let calibrate = study.calibrate.as_ref().ok_or_else(none)?;
    let errors = numerics::error_study(&input, &study);
    let mut fits = Vec::new();
    for alternative in study.alternatives() {
        let search = fit::Search {
            study: &study,
            errors: errors.as_ref(),
            calibrate,
            bar,
            stop,
        };
        let fit = search.fit_each(alternative);
        fits.push(fit.map_err(|_| Error::Interrupted)?);
    }
    let (order, comparisons) = compare::compare(&fits);
    Ok(Calibration {
        study,
        fits,
        order,
        comparisons,
    })
}
