//! Which alternatives are told apart: their misfits must differ by more than their numerical parts, and by more than noise can cause.

use super::Fit;
use super::residuals::Residuals;

/// The best alternative and another one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Comparison {
    /// Positions of the better and of the worse fit.
    pub fits: [usize; 2],
    /// Whether they are told apart.
    pub verdict: Verdict,
}

/// Whether two alternatives are told apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// The misfit of the first with its numerical part is below that of the second without its own, and noise does not explain it.
    Better,
    /// Their misfits differ by less than their numerical parts.
    NotToldApart,
    /// The information criterion says no more than noise can.
    WithinNoise,
    /// A numerical part is unknown.
    Unknown,
}

/// Difference of the information criterion from which on it counts as decisive (Kass and Raftery 1995).
pub const DECISIVE: f64 = 10.0;

/// The order of fits by their misfits, and each of them compared with the best one.
pub fn compare(fits: &[Fit]) -> (Vec<usize>, Vec<Comparison>) {
    let mut order: Vec<usize> = (0..fits.len()).collect();
    // Of equal misfits, the first in the study is first.
    order.sort_by(|a, b| fits[*a].misfit().total_cmp(&fits[*b].misfit()));
    let part = |at: usize| {
        let own = fits[at].numerical.map(|own| own.total());
        (fits[at].misfit(), own)
    };
    let solved = order
        .iter()
        .copied()
        .filter(|at| fits[*at].misfit().is_finite());
    let solved: Vec<usize> = solved.collect();
    let information = information(fits);
    let comparisons = solved.iter().skip(1).map(|at| Comparison {
        fits: [solved[0], *at],
        verdict: verdict(
            part(solved[0]),
            part(*at),
            difference(&information, solved[0], *at),
        ),
    });
    let comparisons = comparisons.collect();
    (order, comparisons)
}

/// Whether the first of two misfits with their numerical parts is smaller; `information` is by how much the criterion of the second is
/// above that of the first, if both have one.
fn verdict(
    better: (f64, Option<f64>),
    worse: (f64, Option<f64>),
    information: Option<f64>,
) -> Verdict {
    let (Some(of_better), Some(of_worse)) = (better.1, worse.1) else {
        return Verdict::Unknown;
    };
    let by_numbers = better.0 + of_better < worse.0 - of_worse;
    match (by_numbers, information) {
        (false, _) => Verdict::NotToldApart,
        (true, Some(difference)) if difference < DECISIVE => Verdict::WithinNoise,
        (true, _) => Verdict::Better,
    }
}

/// By how much the information criterion of a fit is above that of another one.
pub fn difference(information: &[Option<f64>], least: usize, other: usize) -> Option<f64> {
    Some(information[other]? - information[least]?)
}

/// N ln(misfit^2) + p ln N of each fit with the same N, the smallest effective number of residuals; `None` for another metric than
/// `rms_error`, and for a misfit of 0.
pub fn information(fits: &[Fit]) -> Vec<Option<f64>> {
    let effective = fits.iter().filter_map(|fit| fit.residuals.as_ref());
    let count = effective
        .map(Residuals::effective)
        .fold(f64::INFINITY, f64::min);
    let value = |fit: &Fit| {
        fit.residuals?;
        let misfit = fit.misfit();
        let value = count * libm::log(misfit * misfit) + fit.free.len() as f64 * libm::log(count);
        Some(value).filter(|x| x.is_finite())
    };
    fits.iter().map(value).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_difference_below_the_numerical_parts_is_no_verdict() {
        let of = |parts: [f64; 2]| verdict((1.0, Some(parts[0])), (1.3, Some(parts[1])), None);
        assert_eq!(of([0.1, 0.1]), Verdict::Better);
        assert_eq!(of([0.2, 0.2]), Verdict::NotToldApart);
        let unknown = verdict((1.0, None), (9.0, Some(0.0)), None);
        assert_eq!(unknown, Verdict::Unknown);
    }

    #[test]
    fn a_difference_that_noise_can_cause_is_no_verdict() {
        let of = |information| {
            let exact = |misfit| (misfit, Some(0.0));
            verdict(exact(1.0), exact(1.001), Some(information))
        };
        assert_eq!(of(9.0), Verdict::WithinNoise);
        assert_eq!(of(11.0), Verdict::Better);
    }
}
