//! What a hazard curve makes of a fragility curve: mean annual frequencies, of all and of each member of the ensemble.

use super::members::Member;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_statistics::fragility::Fit;
use slipgap_statistics::fragility::hazard::Hazard;
use slipgap_study::kinds::Fragility;

/// The mean annual frequency of exceeding a limit.
#[derive(Debug, Clone, PartialEq)]
pub struct Annual {
    /// The integral over the whole hazard curve.
    pub frequency: f64,
    /// Its interval by the jackknife.
    pub interval: Option<[f64; 2]>,
    /// The part of it that is from beyond the ends of the curve.
    pub outside: f64,
    /// The closed form with the tangent of the curve at the median.
    pub closed_form: f64,
    /// What each member of the ensemble adds.
    pub shares: Vec<Share>,
}

/// What a member of the ensemble adds to a mean annual frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct Share {
    /// Its values of the parameters of the ensemble.
    pub member: Vec<Option<Value>>,
    /// Between which values its capacity lies.
    pub capacity: [f64; 2],
    /// The annual frequency of exceeding its capacity; where this is not known, the mean by the fitted function.
    pub frequency: f64,
    /// Its part of the sum over all members.
    pub share: f64,
}

impl Annual {
    /// The frequency of a fitted function.
    pub fn new(
        figure: &Fragility,
        hazard: &Hazard,
        ensemble: &[usize],
        fit: &Fit,
        members: &[Member],
        interval: Option<[f64; 2]>,
    ) -> Annual {
        let share = |member: &Member| {
            let capacity = member.bounds(figure, fit)?;
            let values = ensemble.iter().map(|row| member.first.value(*row));
            Some(Share {
                member: values.collect(),
                capacity,
                frequency: hazard.mean_between(&fit.function, capacity),
                share: f64::NAN,
            })
        };
        let mut shares: Vec<Share> = members.iter().filter_map(share).collect();
        let sum: f64 = shares.iter().map(|share| share.frequency).sum();
        shares
            .iter_mut()
            .for_each(|share| share.share = share.frequency / sum);
        Annual {
            frequency: hazard.annual(&fit.function),
            interval,
            outside: hazard.outside(&fit.function),
            closed_form: hazard.closed_form(&fit.function),
            shares,
        }
    }
}
