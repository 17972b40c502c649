//! The curves of a fragility figure: in how many cases a metric exceeds a limit, and the lognormal function of the largest
//! likelihood, of capacities or of a cloud.

use super::annual::Annual;
use super::members::{Capacity, Member, Members, column, point};
use super::point::{FragilityPoint, Probability};
use crate::DrawnCase;
use libm::log;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_statistics::fragility::hazard::Hazard;
use slipgap_statistics::fragility::{Fit, Fragility as Function, Line, NoFit, jackknife};
use slipgap_statistics::moments::mean;
use slipgap_study::kinds::{Fit as Way, Fragility};
use slipgap_study::{ColumnRef, Study, alike};

/// One curve.
#[derive(Debug, Clone, PartialEq)]
pub struct FragilityCurve {
    /// For each parameter of the problem the value that all cases of the curve have.
    pub shared: Vec<Option<Value>>,
    /// By rising value of the parameter along the axis.
    pub points: Vec<FragilityPoint>,
    /// The fitted function, or why there is none.
    pub fit: Result<Fit, NoFit>,
    /// 95 % intervals of its median and its dispersion by the jackknife over the members of the ensemble; `None` if there is no fit
    /// without one of them.
    pub jackknife: Option<[[f64; 2]; 2]>,
    /// The lines through the residuals over the columns that the figure names.
    pub trends: Vec<Option<Line>>,
    /// With a hazard curve, the mean annual frequency.
    pub annual: Option<Annual>,
    /// How many cases have collapsed.
    pub collapsed: usize,
    /// How many members do not reach the limit, and how many exceed it at their smallest value.
    pub bounded: [usize; 2],
}

impl FragilityCurve {
    /// The fitted function.
    pub fn function(&self) -> Option<Function> {
        self.fit.as_ref().ok().map(|fit| fit.function)
    }

    /// 95 % intervals of its median and its dispersion.
    pub fn intervals(&self) -> Option<[[f64; 2]; 2]> {
        self.fit.as_ref().ok().map(Fit::intervals)
    }
}

/// The curves of a figure: the cases of each value of its `by`, or else of each set of values of the parameters that vary and
/// change neither with the ensemble nor along the axis, or all cases over a metric; in the order of the first cases.
pub fn curves(study: &Study, figure: &Fragility, cases: &[DrawnCase]) -> Vec<FragilityCurve> {
    let rows = match (figure.by, figure.parameter()) {
        (Some(row), _) => vec![row],
        (None, Some(x)) => study.outside_ensemble(&[x]),
        (None, None) => Vec::new(),
    };
    let grouped = alike::grouped(cases, |shown| shown.identity(&rows));
    let groups = grouped.iter();
    groups.map(|cases| curve(study, figure, cases)).collect()
}

fn curve(study: &Study, figure: &Fragility, cases: &[&DrawnCase]) -> FragilityCurve {
    let members = Members::new(figure, &study.ensemble, cases);
    let fit = members.fit();
    let without = fit.as_ref().ok().and_then(|_| members.without_one());
    let interval = |of: &dyn Fn(&Function) -> f64| {
        let without: Vec<f64> = without.as_ref()?.iter().map(of).collect();
        jackknife::interval(of(&fit.as_ref().ok()?.function), &without)
    };
    let members = members.all;
    let of_cases = members.iter().flat_map(|member| &member.cases);
    let collapsed = of_cases.filter(|(_, point)| point[1].is_infinite());
    let bounded =
        |is: fn(&Capacity) -> bool| members.iter().filter(|member| is(&member.capacity)).count();
    let fitted = fit.as_ref().ok();
    let trend = |column: &ColumnRef| Line::through(&residuals(fitted?, *column, &members));
    let annual = fitted
        .zip(Hazard::new(&figure.hazard))
        .map(|(fit, hazard)| {
            let interval = interval(&|function| hazard.annual(function));
            Annual::new(figure, &hazard, &study.ensemble, fit, &members, interval)
        });
    FragilityCurve {
        shared: shared(study.problem.parameters().len(), cases),
        points: match (figure.fit, figure.parameter()) {
            (Way::Likelihood, Some(x)) => by_parts(figure, x, cases),
            (Way::Incremental, _) => by_capacities(&members),
            (Way::Cloud | Way::Likelihood, _) => by_cases(figure, cases),
        },
        jackknife: interval(&|function| function.median)
            .zip(interval(&|function| function.dispersion))
            .map(<[_; 2]>::from),
        trends: figure.against.iter().map(trend).collect(),
        annual,
        collapsed: collapsed.count(),
        bounded: [
            bounded(|capacity| matches!(capacity, Capacity::Beyond(_))),
            bounded(|capacity| matches!(capacity, Capacity::Before(_))),
        ],
        fit,
    }
}

/// For each member the mean of a column over its cases, and the logarithm by which its capacity, or the mean of its cases of a
/// cloud, is above the function. Cases of one member are not independent, members are.
fn residuals(fit: &Fit, of: ColumnRef, members: &[Member]) -> Vec<[f64; 2]> {
    let residual = |member: &Member| {
        let drawn = member.cases.iter();
        let columns: Option<Vec<f64>> = drawn.map(|(shown, _)| column(of, shown)).collect();
        let above = match (fit.line, member.capacity) {
            (Some(line), _) => member.residual(&line)?,
            (None, Capacity::At(x, _)) => log(x / fit.function.median),
            (None, _) => return None,
        };
        Some([mean(&columns?)?, above])
    };
    members.iter().filter_map(residual).collect()
}

/// The parts that exceed at each value of a parameter.
fn by_parts(figure: &Fragility, x: usize, cases: &[&DrawnCase]) -> Vec<FragilityPoint> {
    let along = |shown: &DrawnCase| shown.value(x).filter(|x| x.as_f64().is_some());
    let placed = cases.iter().filter(|shown| along(shown).is_some());
    let groups = alike::grouped(placed, |shown| along(shown).map(Value::identity));
    let point = |cases: Vec<&&DrawnCase>| {
        let at = along(cases.first()?)?.as_f64()?;
        Some(FragilityPoint::new(figure, at, &cases))
    };
    let mut points: Vec<FragilityPoint> = groups.into_iter().filter_map(point).collect();
    points.sort_by(|a, b| a.at.total_cmp(&b.at));
    points
}

/// The parts of the members that have reached the limit, at each place where one does.
fn by_capacities(members: &[Member]) -> Vec<FragilityPoint> {
    let (mut reached, mut empty, mut before) = (Vec::new(), 0, 0);
    for member in members {
        match member.capacity {
            Capacity::None => empty += 1,
            Capacity::Before(_) => before += 1,
            Capacity::Beyond(_) => {}
            Capacity::At(x, _) => reached.push(x),
        }
    }
    reached.sort_by(f64::total_cmp);
    let cases = members.len() as u64;
    let point = |at: f64, exceeded: u64| FragilityPoint {
        at,
        cases,
        empty,
        exceeded,
        probability: (!at.is_nan()).then(|| Probability::of(exceeded, cases - empty)),
    };
    if reached.is_empty() {
        // At no place; its row says why.
        return vec![point(f64::NAN, before)];
    }
    let places = reached.iter().zip(before + 1..);
    places.map(|(at, exceeded)| point(*at, exceeded)).collect()
}

/// Each case, 1 if it exceeds.
fn by_cases(figure: &Fragility, cases: &[&DrawnCase]) -> Vec<FragilityPoint> {
    let of = |[at, y]: [f64; 2]| {
        let exceeded = u64::from(y > figure.limit);
        let value = exceeded as f64;
        FragilityPoint {
            at,
            cases: 1,
            empty: 0,
            exceeded,
            probability: Some(Probability {
                value,
                low: value,
                high: value,
            }),
        }
    };
    let drawn = cases.iter().filter_map(|shown| point(figure, shown));
    let mut points: Vec<FragilityPoint> = drawn.map(of).collect();
    points.sort_by(|a, b| a.at.total_cmp(&b.at));
    points
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
