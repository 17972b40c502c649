//! The search of an alternative, and what is known at its best point.

use super::channel::{self, Test};
use super::misfit::{Misfit, Pooling};
use super::numerics::{self, ErrorStudy, Numerical};
use super::residuals::Residuals;
use indicatif::ProgressBar;
use slipgap_recommend::Stop;
use slipgap_recommend::calibrate::{
    Best, Determined, End, Objective, Options, Profile, Stopped, determine, search,
};
use slipgap_study::{Alternative, Calibrate, Free, PointCases, Study};

/// Distance in unit coordinates at which a value is at an end of its range.
const AT_END: f64 = 1e-6;

/// Profiles at most, each with the residuals of the best point of the one before it.
const ROUNDS: usize = 3;

/// Part by which numbers of residuals may differ for the same intervals.
const ALIKE: f64 = 0.05;

/// What was found for an alternative.
#[derive(Debug)]
pub struct Fit {
    /// The alternative.
    pub alternative: Alternative,
    /// The free parameters that were searched.
    pub free: Vec<Free>,
    /// Those that the alternative does not use.
    pub unused: Vec<Free>,
    /// The best point with the profiles, in unit coordinates of `free`.
    pub found: Determined,
    /// The best values of `free`.
    pub values: Vec<f64>,
    /// How much of the misfit the time step and the mesh may be; `None` if unknown.
    pub numerical: Option<Numerical>,
    /// The residuals, if the misfit is the root of their mean square.
    pub residuals: Option<Residuals>,
    /// The tests at the best point.
    pub tests: Vec<Test>,
    /// The fits of each test alone, if a parameter varies from test to test.
    pub each: Vec<Fit>,
    /// Number of cases solved, without those of each test.
    pub solved: u64,
}

/// How sharply a parameter is determined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum State {
    /// Its range of good values lies inside of the range searched.
    Determined,
    /// Only a smallest value.
    OnlyBelow,
    /// Only a largest value.
    OnlyAbove,
    /// Neither: all values of the range are about as good.
    Not,
}

/// The name of the one alternative of a study without others.
const ALONE: &str = "study";

impl Fit {
    /// The name of the alternative.
    pub(super) fn label(&self) -> &str {
        match self.alternative.name.as_str() {
            "" => ALONE,
            name => name,
        }
    }

    /// The smallest misfit; infinite without a solution.
    pub fn misfit(&self) -> f64 {
        self.found.best.misfit
    }

    /// The range of good values of a free parameter in unit coordinates: the 95 % interval, or the range with misfits at most 10 % above
    /// the best.
    pub fn range(&self, parameter: usize) -> Option<[End; 2]> {
        let profile: &Profile = self.found.profiles.get(parameter)?;
        Some(profile.interval.unwrap_or(profile.within_tenth))
    }

    /// How sharply a free parameter is determined; `None` without a profile.
    pub fn state(&self, parameter: usize) -> Option<State> {
        Some(match self.range(parameter)? {
            [End::At(_), End::At(_)] => State::Determined,
            [End::At(_), End::Open] => State::OnlyBelow,
            [End::Open, End::At(_)] => State::OnlyAbove,
            [End::Open, End::Open] => State::Not,
        })
    }

    /// The end of the range at which the best value of a free parameter is: 0 or 1.
    pub fn at_end(&self, parameter: usize) -> Option<usize> {
        let u = *self.found.best.at.get(parameter)?;
        match () {
            () if u <= AT_END => Some(0),
            () if u >= 1.0 - AT_END => Some(1),
            () => None,
        }
    }

    /// The value of an end of a range; `None` where the range is open.
    pub fn value(&self, parameter: usize, end: End) -> Option<f64> {
        match end {
            End::At(u) => Some(self.free[parameter].range.at(u)),
            End::Open => None,
        }
    }
}

/// The search of every alternative.
pub struct Search<'a> {
    /// The study with the minimised metric only.
    pub study: &'a Study,
    /// The errors of the time step and of the mesh, if they are known.
    pub errors: Option<&'a ErrorStudy>,
    /// Its `calibrate`.
    pub calibrate: &'a Calibrate,
    /// Counts cases.
    pub bar: &'a ProgressBar,
    /// Ends the search.
    pub stop: &'a Stop,
}

impl Search<'_> {
    /// Fits an alternative, and each of its tests alone if a parameter varies from test to test.
    ///
    /// # Errors
    /// The search was stopped.
    pub fn fit_each(&self, alternative: Alternative) -> Result<Fit, Stopped> {
        let tests: Vec<Alternative> = match self.calibrate.varies.is_empty() {
            true => Vec::new(),
            false => alternative.each_test().collect(),
        };
        let fits = tests.into_iter().map(|test| self.fit(test));
        let each = fits.collect::<Result<Vec<Fit>, Stopped>>()?;
        Ok(Fit {
            each,
            ..self.fit(alternative)?
        })
    }

    /// Fits an alternative.
    ///
    /// # Errors
    /// The search was stopped.
    fn fit(&self, alternative: Alternative) -> Result<Fit, Stopped> {
        let [free, unused] = super::used(self.study, &alternative);
        let cases = self.study.point_cases(&alternative, &free);
        let pooling = match channel::channel(self.study) {
            Some(_) => self.points(&cases),
            None => Pooling::Mean,
        };
        let mut misfit = Misfit {
            study: self.study,
            cases: cases.clone(),
            measure: self.calibrate.minimise,
            pooling,
            bar: self.bar,
            stop: self.stop,
            solved: 0,
        };
        let best = self.best(free.len(), &mut misfit)?;
        let mut point = self.point(&cases, &best);
        let mut found = Determined::only(best);
        if found.best.misfit.is_finite() && !free.is_empty() {
            for _ in 0..ROUNDS {
                let effective = of_intervals(point.residuals);
                found = determine(&found.best, &mut misfit, effective)?;
                // A profile may have found a better point, with other residuals.
                point = self.point(&cases, &found.best);
                if are_alike(effective, of_intervals(point.residuals)) {
                    break;
                }
            }
        }
        let numerical = match found.best.misfit.is_finite() {
            true => numerics::numerical(self.errors, &mut misfit, &alternative, &point.values)?,
            false => None,
        };
        let solved = misfit.solved;
        drop(misfit);
        drop(cases);
        Ok(Fit {
            alternative,
            free,
            unused,
            found,
            values: point.values,
            numerical,
            residuals: point.residuals,
            tests: point.tests,
            each: Vec::new(),
            solved,
        })
    }

    /// The values, the tests and the residuals of a point.
    fn point(&self, cases: &PointCases, best: &Best) -> Point {
        let values = cases.values(&best.at);
        let tests = channel::tests(self.study, cases, &values);
        let channel = channel::channel(self.study);
        Point {
            residuals: channel.and_then(|channel| of_tests(&tests, channel)),
            values,
            tests,
        }
    }

    /// The best point.
    fn best(&self, free: usize, misfit: &mut Misfit) -> Result<Best, Stopped> {
        let tests = misfit.cases.tests().max(1) as u64;
        let options = Options {
            seed: self.calibrate.seed,
            cases: self.calibrate.cases / tests,
        };
        if free > 0 {
            return search(free, misfit, &options);
        }
        let misfits = misfit.misfits(&[Vec::new()])?;
        Ok(Best {
            at: Vec::new(),
            misfit: misfits.first().copied().unwrap_or(f64::INFINITY),
            solved: 1,
            starts: [1, 1],
            spent: false,
        })
    }

    /// The points of each test.
    fn points(&self, cases: &PointCases) -> Pooling {
        let middle = vec![0.5; cases.free().len()];
        let middle_cases = cases.cases(&[middle]);
        let mut shown = middle_cases.shown();
        let count = |row: usize| {
            let measured = channel::measured_of(self.study, shown.at(row));
            measured
                .first()
                .map_or(0.0, |measured| measured.compared.len() as f64)
        };
        let counts: Vec<f64> = (0..middle_cases.len()).map(count).collect();
        match counts.len() > 1 && counts.iter().all(|count| *count > 0.0) {
            true => Pooling::Points(counts),
            false => Pooling::Mean,
        }
    }
}

/// What is known at a point.
struct Point {
    values: Vec<f64>,
    tests: Vec<Test>,
    residuals: Option<Residuals>,
}

fn of_tests(tests: &[Test], channel: &str) -> Option<Residuals> {
    let each = tests.iter().map(|test| channel::residuals(test, channel));
    Residuals::of(&each.collect::<Option<Vec<_>>>()?)
}

fn of_intervals(residuals: Option<Residuals>) -> Option<f64> {
    residuals.and_then(|residuals| residuals.for_intervals())
}

/// Whether intervals of one number of residuals are those of another one.
fn are_alike(one: Option<f64>, other: Option<f64>) -> bool {
    match (one, other) {
        (Some(one), Some(other)) => (one - other).abs() <= ALIKE * other,
        (one, other) => one.is_none() == other.is_none(),
    }
}
