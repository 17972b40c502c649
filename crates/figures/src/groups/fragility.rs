//! The curves of a fragility figure: in how many cases a metric exceeds a limit, and the lognormal function of the largest
//! likelihood, of capacities or of a cloud.

use super::capacities;
use super::point::FragilityPoint;
use crate::DrawnCase;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_statistics::lognormal::{Fragility as Function, NoFit, Trials};
use slipgap_study::kinds::{Fit, Fragility};
use slipgap_study::{Study, alike};

/// One curve.
#[derive(Debug, Clone, PartialEq)]
pub struct FragilityCurve {
    /// For each parameter of the problem the value that all cases of the curve have.
    pub shared: Vec<Option<Value>>,
    /// By rising value of the parameter along the axis.
    pub points: Vec<FragilityPoint>,
    /// The fitted function, or why there is none.
    pub fit: Result<Function, NoFit>,
    /// 95 % intervals of its median and its dispersion, by incremental scaling and of a cloud.
    pub intervals: Option<[[f64; 2]; 2]>,
}

/// The curves of a figure: the cases of each value of its `by`, or else of each set of values of the parameters that vary and
/// change neither with the ensemble nor along the axis, or all cases over a metric; in the order of the first cases.
pub fn curves(study: &Study, figure: &Fragility, cases: &[DrawnCase]) -> Vec<FragilityCurve> {
    let rows = match (figure.by, figure.parameter()) {
        (Some(row), _) => vec![row],
        (None, Some(x)) => study.outside_ensemble(&[x]),
        (None, None) => Vec::new(),
    };
    let groups = alike::grouped(cases, |shown| shown.identity(&rows));
    let groups = groups.iter();
    groups.map(|cases| curve(study, figure, cases)).collect()
}

fn curve(study: &Study, figure: &Fragility, cases: &[&DrawnCase]) -> FragilityCurve {
    let shared = shared(study.problem.parameters().len(), cases);
    let (points, estimate) = match (figure.fit, figure.parameter()) {
        (Fit::Likelihood, Some(x)) => {
            let (points, fit) = by_parts(figure, x, cases);
            return FragilityCurve {
                shared,
                points,
                fit,
                intervals: None,
            };
        }
        (Fit::Incremental, _) => capacities::incremental(figure, &study.ensemble, cases),
        (Fit::Cloud | Fit::Likelihood, _) => capacities::cloud(figure, cases),
    };
    FragilityCurve {
        shared,
        points,
        fit: estimate.map(|own| own.function),
        intervals: estimate.ok().map(|own| [own.median, own.dispersion]),
    }
}

/// The parts that exceed at each value of a parameter, and the function of the largest likelihood.
fn by_parts(
    figure: &Fragility,
    x: usize,
    cases: &[&DrawnCase],
) -> (Vec<FragilityPoint>, Result<Function, NoFit>) {
    let along = |shown: &DrawnCase| shown.value(x).filter(|x| x.as_f64().is_some());
    let placed = cases.iter().filter(|shown| along(shown).is_some());
    let groups = alike::grouped(placed, |shown| along(shown).map(Value::identity));
    let point = |cases: Vec<&&DrawnCase>| {
        let at = along(cases.first()?)?.as_f64()?;
        Some(FragilityPoint::new(figure, at, &cases))
    };
    let mut points: Vec<FragilityPoint> = groups.into_iter().filter_map(point).collect();
    points.sort_by(|a, b| a.at.total_cmp(&b.at));
    let trials = points.iter().filter(|point| point.probability.is_some());
    let trials: Vec<Trials> = trials.map(FragilityPoint::trials).collect();
    (points, Function::fit(&trials))
}

/// For each parameter the value that all cases have.
fn shared(parameters: usize, cases: &[&DrawnCase]) -> Vec<Option<Value>> {
    let value = |row: usize| {
        let first = cases.first()?.value(row);
        let mut others = cases.iter().map(|shown| shown.value(row));
        first.filter(|_| others.all(|other| Value::identical(other, first)))
    };
    (0..parameters).map(value).collect()
}
