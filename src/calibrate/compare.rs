//! Which alternatives are told apart: their misfits must differ by more than their numerical parts, and by more than noise can cause.

use super::Fit;

/// The best alternative and another one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Comparison {
    /// Positions of the better and of the worse fit.
    pub fits: [usize; 2],
    /// Whether they are told apart.
    pub verdict: Verdict,
    /// By how much the information criterion of the worse is above that of the better; `None` for another metric than `rms_error`, and
    /// for a misfit of 0.
    pub information: Option<f64>,
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
    let comparisons = solved.iter().skip(1).map(|at| {
        let [best, other] = [&fits[solved[0]], &fits[*at]];
        let information = information(best, other);
        Comparison {
            fits: [solved[0], *at],
            verdict: verdict(part(solved[0]), part(*at), information),
            information,
        }
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

/// By how much N ln(misfit^2) + p ln N of the second fit is above that of the first, N the smaller effective number of residuals of the
/// two.
fn information(first: &Fit, second: &Fit) -> Option<f64> {
    let effective = |fit: &Fit| Some(fit.residuals.as_ref()?.effective());
    let count = effective(first)?.min(effective(second)?).max(1.0);
    let criterion = |fit: &Fit| {
        let misfit = fit.misfit();
        count * libm::log(misfit * misfit) + fit.free.len() as f64 * libm::log(count)
    };
    Some(criterion(second) - criterion(first)).filter(|x| x.is_finite())
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
