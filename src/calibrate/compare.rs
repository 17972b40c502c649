//! Which alternatives are told apart: their misfits must differ by more than their numerical parts, and by more than noise can cause.

use super::{Fit, Residuals};

/// The best alternative and another one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Comparison {
    /// Positions of the better and of the worse fit.
    pub fits: [usize; 2],
    /// Whether they are told apart.
    pub verdict: Verdict,
    /// By how much the information criterion of the worse is above that of the better, with the points of the better, so that all
    /// alternatives have the same number of points and, with as many free parameters, the order of their misfits; `None` for another metric than `rms_error`, and
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
        let numerical_error = fits[at].numerical.map(|numerical| numerical.total());
        (fits[at].misfit(), numerical_error)
    };
    let solved: Vec<usize> = order
        .iter()
        .copied()
        .filter(|at| fits[*at].misfit().is_finite())
        .collect();
    let with_best = solved.iter().skip(1).map(|at| {
        let [best, other] = [&fits[solved[0]], &fits[*at]];
        let information = information(&judged(best), &judged(other));
        Comparison {
            fits: [solved[0], *at],
            verdict: verdict(part(solved[0]), part(*at), information),
            information,
        }
    });
    let comparisons = with_best.collect();
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

/// What the criterion needs of a fit.
#[derive(Debug, Clone, Copy)]
struct Judged {
    misfit: f64,
    /// Effective number of residuals.
    effective: Option<f64>,
    /// Number of free parameters.
    free: usize,
}

fn judged(fit: &Fit) -> Judged {
    Judged {
        misfit: fit.misfit(),
        effective: fit.residuals.as_ref().map(Residuals::effective),
        free: fit.free.len(),
    }
}

/// By how much N ln(misfit^2) + p ln N of a fit is above that of the best one, N the effective number of residuals of the best one: what
/// it leaves is nearest to noise. The residuals of a wrong law are correlated because the law is wrong, which must not count for it.
fn information(best: &Judged, other: &Judged) -> Option<f64> {
    let count = best.effective?.max(1.0);
    let criterion = |fit: &Judged| {
        count * libm::log(fit.misfit * fit.misfit) + fit.free as f64 * libm::log(count)
    };
    Some(criterion(other) - criterion(best)).filter(|x| x.is_finite())
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

    #[test]
    fn the_criterion_orders_fits_as_their_misfits_at_equal_numbers_of_parameters() {
        let of = |misfit, effective, free| Judged {
            misfit,
            effective: Some(effective),
            free,
        };
        let best = of(1.0, 900.0, 3);
        // The worse a law, the more correlated what it leaves.
        let others = [(1.2, 800.0), (1.5, 40.0), (4.0, 5.0), (9.0, 1.0)];
        let found = others.map(|(misfit, effective)| {
            let found = information(&best, &of(misfit, effective, 3)).unwrap();
            // N ln(misfit^2) with N = 900; round-off of the logarithms.
            assert!((found - 1800.0 * f64::ln(misfit)).abs() < 1e-10);
            found
        });
        assert!(found.is_sorted(), "{found:?}");
        // A parameter more costs ln N.
        let more = information(&best, &of(1.2, 800.0, 4)).unwrap();
        assert!((more - found[0] - f64::ln(900.0)).abs() < 1e-10);
        assert_eq!(information(&best, &of(0.0, 800.0, 3)), None);
    }
}
