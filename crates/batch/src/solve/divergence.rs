//! In how many cases of a study of structures a change of 1e-10 in start and loads reaches 1 % of the motion.

use super::cost::total;
use rayon::prelude::*;
use slipgap_problem::problem::Case;
use slipgap_study::Study;
use std::fmt;

/// Most cases that are looked at.
const MOST: u64 = 64;

/// Most work of these cases, unless it is only one: some seconds.
const WORK: f64 = 1e8;

/// The number of cases that diverge.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Divergence {
    /// Cases of the study.
    pub cases: u64,
    /// Those that were looked at and could be solved.
    pub looked_at: u64,
    /// Those of them that diverge.
    pub diverging: u64,
}

impl Divergence {
    /// Adds a case of the study; `None` where it is unknown whether it diverges.
    pub fn add(&mut self, diverges: Option<bool>) {
        self.cases += 1;
        self.looked_at += u64::from(diverges.is_some());
        self.diverging += u64::from(diverges == Some(true));
    }
}

/// Evenly spaced cases of a study of structures, the same ones on every machine; `None` for another problem.
pub fn sampled(study: &Study) -> Option<Divergence> {
    sampled_if(study, MOST, |_| true)
}

/// The same of at most so many cases that need no other sampled signals than this case, which is one of them; `None` if none may be
/// looked at.
pub fn sampled_like(study: &Study, number: u64, most: u64) -> Option<Divergence> {
    if most == 0 {
        return None;
    }
    let case = study.case(number)?;
    let signals = study.samples(&case);
    let found = sampled_if(study, most.min(MOST), |other| {
        study.samples(other) == signals
    })?;
    if found.looked_at > 0 {
        return Some(found);
    }
    let mut only = Divergence::default();
    only.add(diverges(study, &case));
    Some(Divergence {
        cases: found.cases,
        ..only
    })
}

/// Whether a small change in start and loads of a case grows; `None` where it is unknown.
fn diverges(study: &Study, case: &Case) -> Option<bool> {
    study.problem.as_structure()?.diverges(case)
}

fn sampled_if(
    study: &Study,
    most: u64,
    wanted: impl Fn(&Case) -> bool + Sync,
) -> Option<Divergence> {
    if !study.problem.schema().described {
        return None;
    }
    let cases = study.len();
    let numbers = numbers(cases, most, total(study));
    let sampled = numbers.par_iter().map(|number| {
        let case = study.case(*number).filter(|case| wanted(case))?;
        diverges(study, &case)
    });
    let found: Vec<Option<bool>> = sampled.collect();
    let mut sum = Divergence::default();
    found.into_iter().for_each(|found| sum.add(found));
    Some(Divergence { cases, ..sum })
}

/// The numbers of the cases that are looked at, `most` of them at most, of a study with so much work.
fn numbers(cases: u64, most: u64, total: f64) -> Vec<u64> {
    let affordable = WORK / total * cases as f64;
    let count = cases.min(most).min((affordable as u64).max(1));
    (0..count)
        .map(|i| (u128::from(i) * u128::from(cases) / u128::from(count)) as u64)
        .collect()
}

impl fmt::Display for Divergence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Divergence {
            cases,
            looked_at,
            diverging,
        } = self;
        f.write_str("a change of 1e-10 in start and loads reaches 1 % of the peak in ")?;
        match looked_at {
            0 => {
                return write!(
                    f,
                    "an unknown number of {cases} cases; none could be solved"
                );
            }
            _ if looked_at == cases => write!(f, "{diverging} of {cases} cases"),
            _ => write!(f, "{diverging} of {looked_at} cases looked at, of {cases}"),
        }?;
        match diverging {
            0 => Ok(()),
            _ => f.write_str("; after that their histories are not reproducible"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipgap_study::parse;

    /// An oscillator that is driven against a stop: chaotic at omega = 2.85, periodic at 3.
    fn study(omega: &str, metrics: &str) -> Study {
        let text = format!(
            r#"{{"problem": "structure", "parameters": {{"omega": {omega}, "dt": 0.005, "duration": 250}},
              "structure": {{"masses": {{"x": 1}}, "springs": [{{"between": ["ground", "x"], "k": 1, "c": 0.02}}],
              "contacts": {{"stop": {{"law": "impact", "between": ["x", "ground"], "k": 1000}}}},
              "loads": [{{"at": "x", "sine": {{"amplitude": 1, "omega": "omega"}}}}], "start": {{"x": {{"u": 0.01}}}}}},
              "metrics": [{metrics}]}}"#
        );
        parse("s", &text).unwrap()
    }

    #[test]
    fn the_cases_looked_at_are_evenly_spaced_and_fewer_if_they_are_much_work() {
        assert_eq!(numbers(3, MOST, 1.0), [0, 1, 2]);
        let chosen = numbers(6400, MOST, 1.0);
        assert!(chosen.iter().enumerate().all(|(i, n)| *n == 100 * i as u64));
        assert_eq!(chosen.len(), 64);
        // 10 of 100 cases are 1e8.
        assert_eq!(
            numbers(100, MOST, 1e9),
            [0, 10, 20, 30, 40, 50, 60, 70, 80, 90]
        );
        assert_eq!(numbers(7, MOST, 1e30), [0]);
        assert_eq!(numbers(100, 2, 1.0), [0, 50]);
        assert_eq!(numbers(0, MOST, 0.0), [0; 0]);
    }

    #[test]
    fn round_off_of_a_body_that_friction_holds_is_no_motion() {
        // The limit is above the largest force of the ground, so that the displacement is round-off of a step.
        let study = |limit: f64| {
            let text = format!(
                r#"{{"problem": "structure", "parameters": {{"dt": 0.002, "duration": 0.6, "method": ["linear-acceleration", "generalized-alpha"]}},
                  "structure": {{"masses": {{"m": 2.687}}, "springs": [{{"between": ["ground", "m"], "k": 1839, "c": 0.8812}}],
                  "ground": {{"pulse": {{"cosine": {{"amplitude": 1.042, "period": 0.2812, "sampled": 0.01}}}}}},
                  "contacts": {{"c": {{"law": "coulomb", "limit": {limit}, "between": ["m", "ground"]}}}}}},
                  "metrics": ["peak(m)", "difference(m)", "divergence(m, 0.01)", "difference(c.rdot)"]}}"#
            );
            parse("s", &text).unwrap()
        };
        let (stuck, slides) = (study(8.246), study(0.5));
        let of = |study: &Study| {
            let found = sampled(study).unwrap();
            assert_eq!((found.looked_at, found.diverging), (2, 0), "{found:?}");
            let case = study.case(0).unwrap();
            study.problem.solve(&case, &study.metrics).unwrap().metrics
        };
        let [peak, rest @ ..] = &of(&stuck)[..] else {
            panic!();
        };
        assert!(
            peak.unwrap() < 1e-15 && rest.iter().all(Option::is_none),
            "{peak:?} {rest:?}"
        );
        // Where it slides, the difference is that of the start and the loads.
        let moving = of(&slides);
        assert!(
            moving[1].unwrap() < 1e-8 && moving[3].unwrap() < 1e-8,
            "{moving:?}"
        );
    }

    #[test]
    fn the_cases_that_diverge_are_those_of_the_metrics() {
        // By displacement, by the contact alone, and by no part at all.
        for metrics in [
            r#""divergence(x, 0.01)", "difference(x)""#,
            r#""impacts(stop)""#,
            r#""energy_error""#,
        ] {
            let study = study("[2.85, 3]", metrics);
            let found = sampled(&study).unwrap();
            let expected = Divergence {
                cases: 2,
                looked_at: 2,
                diverging: 1,
            };
            assert_eq!(found, expected, "{metrics}");
            let says = |case| {
                let metrics = study.problem.solve(&case, &[]).unwrap().metrics;
                study
                    .problem
                    .as_structure()
                    .and_then(|structure| structure.diverges_by(&metrics))
            };
            let said: Vec<Option<bool>> = study.cases().map(says).collect();
            let expected = match metrics.contains("divergence") {
                true => [Some(true), Some(false)],
                false => [None, None],
            };
            assert_eq!(said, expected, "{metrics}");
        }
        let known = |text| parse("s", text).unwrap();
        let other = known(
            r#"{"problem": "friction-oscillator", "parameters": {"law": "displacement-control", "alpha": 1, "dT": 0.5, "duration": 3}}"#,
        );
        assert_eq!(sampled(&other), None);
    }

    #[test]
    fn the_numbers_are_written_in_one_line() {
        let text = |cases, looked_at, diverging| {
            let divergence = Divergence {
                cases,
                looked_at,
                diverging,
            };
            divergence.to_string()
        };
        let change = "a change of 1e-10 in start and loads reaches 1 % of the peak in";
        let meaning = "after that their histories are not reproducible";
        assert_eq!(text(9, 9, 0), format!("{change} 0 of 9 cases"));
        assert_eq!(
            text(2000, 64, 7),
            format!("{change} 7 of 64 cases looked at, of 2000; {meaning}")
        );
    }
}
