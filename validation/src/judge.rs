//! The test of a reading by the cases of its study.

use super::Finding;
use super::ledger::{Demand, Expect, Reading};
use super::within::{Limits, Met, share_within, short, within};
use slipgap_problem::problem::{Lines, Problem, Snapshot};
use slipgap_study::{CaseMetrics, Reference, Study};

/// Tests everything that a reading expects.
pub fn reading(study: &Study, outcomes: &[CaseMetrics], reading: &Reading) -> Finding {
    let results = reading
        .expect
        .iter()
        .map(|e| expectation(study, outcomes, e));
    finding(results.collect())
}

/// The finding of a reading from the results of its expectations.
fn finding(met_list: Vec<Met>) -> Finding {
    let holds = met_list.iter().all(|met| met.holds);
    let near: Vec<String> = match holds {
        true => met_list.iter().filter(|met| !met.narrower).collect(),
        // It would hold with wider limits: those not met now are near theirs.
        false if met_list.iter().all(|met| met.wider) => {
            met_list.iter().filter(|met| !met.holds).collect()
        }
        false => Vec::new(),
    }
    .into_iter()
    .map(|met: &Met| met.found.clone())
    .collect();
    let found = met_list.into_iter().map(|met| met.found).collect();
    Finding { holds, found, near }
}

fn expectation(study: &Study, outcomes: &[CaseMetrics], expect: &Expect) -> Met {
    let matching = outcomes.iter().filter(|o| expect.filter.matches(&o.case));
    let mut cases: Vec<&CaseMetrics> = matching.collect();
    let reductions = match expect.demand {
        Demand::Within { metric, .. }
        | Demand::Trend { metric, .. }
        | Demand::LeastAt { metric, .. } => {
            let each: Vec<&CaseMetrics> = outcomes.iter().collect();
            reduced(study, metric, &cases).zip(reduced(study, metric, &each))
        }
        Demand::AwayFromFronts { .. } | Demand::LaterEvent { .. } => None,
    };
    let mut others = outcomes;
    // A reduction is divided by that of other cases, which `where` need not choose.
    if let Some((chosen, every)) = &reductions {
        cases = chosen.iter().collect();
        others = every;
    }
    let problem = &*study.problem;
    let metric_of = |o: &CaseMetrics, metric: usize| o.metrics[metric].filter(|x| x.is_finite());
    let value = |o: &CaseMetrics, metric: usize| match &expect.over {
        None => metric_of(o, metric),
        Some(over) => {
            let other = metric_of(partner(over, o, others)?, metric)?;
            Some(metric_of(o, metric)? / other).filter(|x| x.is_finite())
        }
    };
    let named = |metric: usize| {
        let name = format!("`{}`", study.measures[metric].name);
        match &expect.over {
            None => name,
            Some(over) => {
                let other = over.text(problem.parameters());
                format!("{name} over that with {other}")
            }
        }
    };
    match &expect.demand {
        Demand::Within {
            metric,
            min,
            max,
            share,
        } => {
            let values: Vec<_> = cases.iter().map(|o| value(o, *metric)).collect();
            let mut name = named(*metric);
            if expect.over.is_some() {
                name.push(':');
            }
            match share {
                Some(share) => share_within(&values, &name, [*min, *max], *share),
                None => within(&values, &name, *min, *max),
            }
        }
        Demand::Trend {
            metric,
            along,
            rising,
        } => {
            let line = ordered(&cases, *along, |o| value(o, *metric));
            let follows = |pair: &[[f64; 2]]| {
                (pair[1][1] > pair[0][1]) == *rising && pair[1][1] != pair[0][1]
            };
            let holds = line
                .as_ref()
                .is_some_and(|line| line.windows(2).all(follows));
            let name = named(*metric);
            let parameter = &problem.parameters()[*along].name;
            let found = format!("{name} along `{parameter}`: {}", listed(&line));
            Met::plain(holds, found)
        }
        Demand::LeastAt {
            metric,
            along,
            range,
        } => {
            let line = ordered(&cases, *along, |o| value(o, *metric));
            let least = line.and_then(|line| line.into_iter().min_by(|a, b| a[1].total_cmp(&b[1])));
            let name = named(*metric);
            let Some([at, x]) = least else {
                return Met::plain(false, format!("{name} undefined"));
            };
            let parameter = &problem.parameters()[*along].name;
            let found = format!(
                "{name} least at `{parameter}` = {}: {}",
                short(at),
                short(x)
            );
            let [min, max] = range.map(Some);
            Met::of(&[Some(at)], Limits { min, max }, found)
        }
        Demand::AwayFromFronts {
            profile,
            times,
            away,
            max,
        } => {
            let errors: Vec<_> = cases
                .iter()
                .map(|o| away_from_fronts(problem, o, *profile, times, *away))
                .collect();
            let name = format!("`{}`", problem.schema().profiles[*profile].name);
            within(&errors, &name, None, Some(*max))
        }
        Demand::LaterEvent {
            later,
            flights,
            min,
            max,
        } => {
            let errors: Vec<_> = cases
                .iter()
                .map(|o| later_error(problem, o, *later, flights))
                .collect();
            let name = format!("difference of `{}`", problem.schema().later[*later]);
            within(&errors, &name, *min, *max)
        }
    }
}

/// The cases reduced to one for each group, if the metric is a reduction.
fn reduced(study: &Study, metric: usize, cases: &[&CaseMetrics]) -> Option<Vec<CaseMetrics>> {
    slipgap_study::reduced_cases(study, &[metric], |take| {
        for outcome in cases {
            take(&outcome.case, &|row| {
                outcome.metrics.get(row).copied().flatten()
            });
        }
    })
}

/// The case that a metric is divided by.
fn partner<'a>(
    over: &Reference,
    outcome: &CaseMetrics,
    cases: &'a [CaseMetrics],
) -> Option<&'a CaseMetrics> {
    cases
        .iter()
        .find(|other| over.pairs(&outcome.case, &other.case))
}

/// Parameter and value of every case in rising order of the parameter; `None` if a value is undefined.
fn ordered(
    cases: &[&CaseMetrics],
    along: usize,
    value: impl Fn(&CaseMetrics) -> Option<f64>,
) -> Option<Vec<[f64; 2]>> {
    let point = |o: &&CaseMetrics| Some([o.case.values[along]?.as_f64()?, value(o)?]);
    let mut line = cases.iter().map(point).collect::<Option<Vec<_>>>()?;
    line.sort_by(|a, b| a[0].total_cmp(&b[0]));
    Some(line)
}

fn listed(line: &Option<Vec<[f64; 2]>>) -> String {
    match line {
        None => "undefined".into(),
        Some(line) => {
            let each = line
                .iter()
                .map(|[at, x]| format!("{} at {}", short(*x), short(*at)));
            each.collect::<Vec<_>>().join(", ")
        }
    }
}

/// Root mean square of the error of a profile further than `away` from every front.
fn away_from_fronts(
    problem: &dyn Problem,
    outcome: &CaseMetrics,
    row: usize,
    times: &[f64],
    away: f64,
) -> Option<f64> {
    let (mut sum, mut count) = (0.0, 0_u32);
    for snapshot in problem.as_textbook().map_or(Vec::new(), |textbook| {
        textbook.snapshots(&outcome.case, times)
    }) {
        let Snapshot {
            profiles, fronts, ..
        } = snapshot;
        let Lines { computed, exact } = profiles.get(row)?;
        for (points, line) in computed.iter().zip(exact) {
            for [x, y] in points {
                let far = fronts.iter().all(|front| (x - front).abs() > away);
                if let (true, Some(e)) = (far, at(line, *x)) {
                    sum += (y - e) * (y - e);
                    count += 1;
                }
            }
        }
    }
    (count > 0).then(|| (sum / f64::from(count)).sqrt())
}

/// Root mean square over the flights of the error of a number about the later event. The exact solution has 1.
fn later_error(
    problem: &dyn Problem,
    outcome: &CaseMetrics,
    row: usize,
    flights: &[f64],
) -> Option<f64> {
    let mut sum = 0.0;
    for flight in flights {
        let x = (*problem
            .as_textbook()
            .map_or(Vec::new(), |textbook| {
                textbook.after(&outcome.case, *flight)
            })
            .get(row)?)?;
        sum += (x - 1.0) * (x - 1.0);
    }
    Some((sum / flights.len() as f64).sqrt())
}

/// The value of a line at `x`.
fn at(line: &[[f64; 2]], x: f64) -> Option<f64> {
    let pair = line.windows(2).find(|pair| {
        let (a, b) = (pair[0][0].min(pair[1][0]), pair[0][0].max(pair[1][0]));
        a < b && (a..=b).contains(&x)
    })?;
    let part = (x - pair[0][0]) / (pair[1][0] - pair[0][0]);
    Some(pair[0][1] + part * (pair[1][1] - pair[0][1]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reading_is_near_its_limit_if_moved_limits_change_its_verdict() {
        let met = |x: f64| within(&[Some(x)], "x", Some(0.9), Some(1.1));
        let near = |values: &[f64]| finding(values.iter().map(|x| met(*x)).collect()).near.len();
        // Holds: each value near a limit counts. Fails: only if no value is far outside.
        assert_eq!(near(&[1.0, 1.05]), 0);
        assert_eq!(near(&[1.0, 1.095, 0.905]), 2);
        assert_eq!(near(&[1.095, 1.105]), 1);
        assert_eq!(near(&[1.105, 1.2]), 0);
    }

    #[test]
    fn lines_have_a_value_on_each_side_of_a_jump() {
        let line = [[0.0, 1.0], [0.4, 1.0], [0.4, -1.0], [1.0, -1.0]];
        assert_eq!((at(&line, 0.2), at(&line, 0.7)), (Some(1.0), Some(-1.0)));
        assert_eq!(at(&line, 1.5), None);
        // From right to left as well.
        assert_eq!(at(&[[1.0, 3.0], [0.0, 1.0]], 0.25), Some(1.5));
    }
}
