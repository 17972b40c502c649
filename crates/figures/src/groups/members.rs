//! The members of the ensemble of a fragility curve, and the function that some of them give.

use super::point::value;
use crate::DrawnCase;
use libm::{exp, log};
use slipgap_statistics::fragility::{Capacities, Cloud, Fit, Fragility as Function, NoFit};
use slipgap_statistics::fragility::{Line, Trials, of_trials};
use slipgap_statistics::moments::mean;
use slipgap_study::kinds::{Fit as Way, Fragility};
use slipgap_study::{ColumnRef, alike};

/// A member of the ensemble.
pub struct Member<'a> {
    /// Its first case.
    pub first: DrawnCase<'a>,
    /// The cases with a value, by rising place: place and metric, infinite if it has collapsed.
    pub cases: Vec<(DrawnCase<'a>, [f64; 2])>,
    /// Where it reaches the limit.
    pub capacity: Capacity,
    /// Its cases as a cloud.
    cloud: Cloud,
    /// Its cases as trials: which place, and whether it exceeds the limit.
    trials: Vec<(usize, bool)>,
}

/// Where a member of an ensemble reaches a limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Capacity {
    /// It has no case with a value.
    None,
    /// Its first case, which is here, exceeds it.
    Before(f64),
    /// No case exceeds it; the last one is here.
    Beyond(f64),
    /// Here, straight between its last case before and its first one that exceeds, which are at these places.
    At(f64, [f64; 2]),
}

impl Capacity {
    fn of(points: &[[f64; 2]], limit: f64) -> Capacity {
        match points.iter().position(|point| point[1] > limit) {
            Some(0) => Capacity::Before(points[0][0]),
            Some(i) => {
                let ([x0, y0], [x1, y1]) = (points[i - 1], points[i]);
                Capacity::At(x0 + (x1 - x0) * ((limit - y0) / (y1 - y0)), [x0, x1])
            }
            None => points
                .last()
                .map_or(Capacity::None, |last| Capacity::Beyond(last[0])),
        }
    }
}

/// What a column of the results has in a case.
pub fn column(column: ColumnRef, shown: &DrawnCase) -> Option<f64> {
    match column {
        ColumnRef::Parameter(row) => shown.number(row),
        ColumnRef::Metric(row) => shown.metric(row),
    }
}

/// Place and metric of a case that has both.
pub fn point(figure: &Fragility, shown: &DrawnCase) -> Option<[f64; 2]> {
    Some([column(figure.x, shown)?, value(figure, shown)?])
}

/// The members of the ensemble of a curve.
pub struct Members<'a> {
    figure: &'a Fragility,
    pub all: Vec<Member<'a>>,
    /// The places of all cases, rising.
    places: Vec<f64>,
}

impl<'a> Members<'a> {
    /// Those among the cases of a curve.
    pub fn new(figure: &'a Fragility, ensemble: &[usize], cases: &[&DrawnCase<'a>]) -> Self {
        let groups = alike::grouped(cases, |shown| shown.identity(ensemble));
        let member = |group: Vec<&&DrawnCase<'a>>| Member::of(figure, &group);
        let mut found: Vec<Member> = groups.into_iter().filter_map(member).collect();
        let trials = found.iter().flat_map(|member| &member.cases);
        let mut places: Vec<f64> = trials.map(|(_, point)| point[0]).collect();
        places.sort_by(f64::total_cmp);
        places.dedup();
        for member in &mut found {
            let index = |x: f64| places.partition_point(|known| *known < x);
            let trial = |(_, [x, y]): &(DrawnCase, [f64; 2])| (index(*x), *y > figure.limit);
            member.trials = member.cases.iter().map(trial).collect();
        }
        Members {
            figure,
            all: found,
            places,
        }
    }

    /// The function of all members.
    pub fn fit(&self) -> Result<Fit, NoFit> {
        self.fit_of(&self.all.iter().collect::<Vec<_>>())
    }

    /// The functions of all members but one each; `None` if one of them has none.
    pub fn without_one(&self) -> Option<Vec<Function>> {
        let without = |left_out: usize| {
            let others = self.all.iter().enumerate().filter(|(i, _)| *i != left_out);
            let others: Vec<&Member> = others.map(|(_, member)| member).collect();
            Some(self.fit_of(&others).ok()?.function)
        };
        (0..self.all.len()).map(without).collect()
    }

    fn fit_of(&self, members: &[&Member]) -> Result<Fit, NoFit> {
        match self.figure.fit {
            Way::Likelihood => of_trials(&self.trials(members)),
            Way::Incremental => capacities(members).fit(),
            Way::Cloud => {
                let clouds = members.iter().map(|member| &member.cloud);
                let Fragility {
                    limit, collapse, ..
                } = *self.figure;
                Cloud::together(clouds).fit(limit, collapse.unwrap_or(limit))
            }
        }
    }

    /// The trials at each place.
    fn trials(&self, members: &[&Member]) -> Vec<Trials> {
        let none = |at: &f64| Trials {
            at: *at,
            exceeded: 0,
            count: 0,
        };
        let mut by_place: Vec<Trials> = self.places.iter().map(none).collect();
        for (index, exceeds) in members.iter().flat_map(|member| &member.trials) {
            by_place[*index].count += 1;
            by_place[*index].exceeded += u64::from(*exceeds);
        }
        by_place.retain(|trials| trials.count > 0);
        by_place
    }
}

/// The capacities of members, by rising value.
fn capacities(members: &[&Member]) -> Capacities {
    let mut capacities = Capacities::default();
    for member in members {
        match member.capacity {
            Capacity::None => {}
            Capacity::Before(x) => capacities.before.push(x),
            Capacity::Beyond(x) => capacities.beyond.push(x),
            Capacity::At(x, _) => capacities.reached.push(x),
        }
    }
    capacities.reached.sort_by(f64::total_cmp);
    capacities
}

impl<'a> Member<'a> {
    fn of(figure: &Fragility, cases: &[&&DrawnCase<'a>]) -> Option<Member<'a>> {
        let first = ***cases.first()?;
        let mut cases: Vec<(DrawnCase, [f64; 2])> = cases
            .iter()
            .filter_map(|shown| Some((***shown, point(figure, shown)?)))
            .collect();
        cases.sort_by(|a, b| a.1[0].total_cmp(&b.1[0]));
        let points: Vec<[f64; 2]> = cases.iter().map(|(_, point)| *point).collect();
        Some(Member {
            first,
            capacity: Capacity::of(&points, figure.limit),
            cloud: match figure.fit {
                Way::Cloud => Cloud::new(&points),
                Way::Likelihood | Way::Incremental => Cloud::default(),
            },
            trials: Vec::new(),
            cases,
        })
    }

    /// Between which values its capacity lies, twice the same if it is known; `None` without a case. Of a cloud it is where the
    /// line through its cases, parallel to that of all, reaches the limit.
    pub fn bounds(&self, figure: &Fragility, fit: &Fit) -> Option<[f64; 2]> {
        let between = match self.capacity {
            Capacity::None => return None,
            Capacity::Before(x) => [0.0, x],
            Capacity::Beyond(x) => [x, f64::INFINITY],
            Capacity::At(x, _) if figure.fit == Way::Incremental => [x, x],
            Capacity::At(_, between) => between,
        };
        let line = fit
            .line
            .and_then(|line| Some((line, self.residual(&line)?)));
        Some(line.map_or(between, |(line, above)| {
            [exp(line.x + (log(figure.limit) - line.y - above) / line.slope); 2]
        }))
    }

    /// How far its cases of a cloud are above the line, on average.
    pub fn residual(&self, line: &Line) -> Option<f64> {
        let points = self.cloud.logarithms().iter();
        let residuals: Vec<f64> = points.map(|point| line.residual(*point)).collect();
        mean(&residuals)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_capacity_is_between_the_last_case_before_and_the_first_that_exceeds() {
        let points = [[1.0, 0.5], [2.0, 1.5], [3.0, 0.9], [4.0, 9.0]];
        assert_eq!(Capacity::of(&points, 1.0), Capacity::At(1.5, [1.0, 2.0]));
        assert_eq!(Capacity::of(&points, 0.4), Capacity::Before(1.0));
        assert_eq!(Capacity::of(&points, 9.0), Capacity::Beyond(4.0));
        assert_eq!(Capacity::of(&[], 1.0), Capacity::None);
        // A collapse is beyond the limit by an unknown amount: the last case before is the safe side.
        let collapsed = [[1.0, 0.5], [2.0, f64::INFINITY]];
        assert_eq!(Capacity::of(&collapsed, 1.0), Capacity::At(1.0, [1.0, 2.0]));
    }
}
