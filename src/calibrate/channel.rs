//! A measured channel of the tests of an alternative, with what is computed for it.

use rayon::prelude::*;
use slipgap_problem::metrics::measured::at_times;
use slipgap_problem::problem::structure::metrics::window::Window;
use slipgap_problem::problem::{Case, Jumps, MeasuredChannel, Solution};
use slipgap_study::{PointCases, Study};

/// A test at a point of the free parameters.
#[derive(Debug)]
pub struct Test {
    /// Its case.
    pub case: Case,
    /// The computed motion; `None` if it has no solution.
    pub solution: Option<Solution>,
    /// Why it has none.
    pub why: Option<String>,
    /// What was measured.
    pub measured: Vec<MeasuredChannel>,
}

/// The tests of an alternative with these values of its free parameters.
pub fn tests(study: &Study, cases: &PointCases, values: &[f64]) -> Vec<Test> {
    let every_case = cases.cases_with(&[values.to_vec()]);
    let mut shown = every_case.shown();
    let each: Vec<(Case, bool)> = (0..every_case.len())
        .map(|row| (shown.at(row).clone(), every_case.may_be_solved(row)))
        .collect();
    let test = |(case, solvable): (Case, bool)| {
        let solved = study.problem.solve(&case, &study.metrics);
        let why = solved.as_ref().err().map(ToString::to_string);
        Test {
            solution: solved.ok().filter(|_| solvable),
            why,
            measured: measured_of(study, &case),
            case,
        }
    };
    each.into_par_iter().map(test).collect()
}

/// What was measured of a case, with the points that the minimised metric compares.
pub fn measured_of(study: &Study, case: &Case) -> Vec<MeasuredChannel> {
    let structure = study.problem.as_structure();
    match structure.zip(study.minimised_metric()) {
        Some((structure, metric)) => structure.measured_by(case, metric),
        None => study.measured(case),
    }
}

/// The channel of `rms_error(CHANNEL, measured)`, perhaps of a window, if the study minimises it alone.
pub fn channel(study: &Study) -> Option<&str> {
    let metric = study.minimised_metric()?;
    let name = study.problem.metrics()[metric].name.trim();
    let rest = name.strip_prefix("rms_error")?.trim_start();
    let inside = rest.strip_prefix('(')?.strip_suffix(')')?;
    let (compared, _) = Window::split(inside).ok()?;
    let (channel, against) = compared.rsplit_once(',')?;
    (against.trim() == "measured").then(|| channel.trim())
}

/// What was measured of a channel.
pub fn measured<'a>(test: &'a Test, channel: &str) -> Option<&'a MeasuredChannel> {
    let plain = |name: &str| name.replace(char::is_whitespace, "");
    let mut channels = test.measured.iter();
    channels.find(|measured| plain(&measured.name) == plain(channel))
}

/// How far the computed motion is from the exact one at the points of a channel that metrics compare: the rms of their difference, with
/// that of the straight lines between steps. `None` where no exact motion is known.
pub fn step_error(study: &Study, test: &Test, channel: &str) -> Option<f64> {
    let measured = measured(test, channel)?;
    let computed = computed(test, measured)?;
    let end = *test.solution.as_ref()?.computed.time.last()?;
    let times: Vec<f64> = measured.time[measured.compared.clone()]
        .iter()
        .map(|t| t.clamp(0.0, end))
        .collect();
    let solution = study.problem.exact(&test.case, &times, Jumps::RightLimit)?;
    let exact = solution.channel(measured.column).iter();
    let squares = computed.iter().zip(exact).map(|(c, e)| (c - e) * (c - e));
    let mean = squares.sum::<f64>() / computed.len() as f64;
    Some(mean.sqrt()).filter(|x| x.is_finite())
}

/// The differences, computed minus measured, at the points of a channel that metrics compare.
pub fn residuals(test: &Test, channel: &str) -> Option<Vec<f64>> {
    let measured = measured(test, channel)?;
    let values = &measured.values[measured.compared.clone()];
    let pairs = computed(test, measured)?.into_iter().zip(values);
    Some(pairs.map(|(c, m)| c - m).collect())
}

/// The computed motion at the points of a channel that metrics compare, as these take it: straight between steps.
fn computed(test: &Test, measured: &MeasuredChannel) -> Option<Vec<f64>> {
    let motion = &test.solution.as_ref()?.computed;
    let dt = motion.time.get(1)? - motion.time.first()?;
    let times = &measured.time[measured.compared.clone()];
    at_times(motion.channel(measured.column), dt, times)
}
