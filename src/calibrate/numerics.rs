//! How much of a misfit the time step and the mesh may be.

use super::channel::{self, Test};
use super::misfit::Misfit;
use slipgap_problem::problem::table::cases::Cases;
use slipgap_recommend::calibrate::Stopped;
use slipgap_recommend::with_finer_step;
use slipgap_study::{Alternative, Input, MOST_CASES, Study};

/// The numerical part of a misfit. Without step and mesh errors, the misfit of `rms_error` would lie within misfit +- this.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Numerical {
    /// Error of the time step.
    pub step: f64,
    /// Error of the mesh, of a structure with bars.
    pub mesh: Option<f64>,
    /// Where the error of the time step is from.
    pub from: From,
}

/// Where the error of a time step is from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum From {
    /// `step_error`: the distance from the exact motion, here at the measured points.
    StepError,
    /// The change of the misfit with half the time step.
    HalfStep,
}

impl Numerical {
    /// Both together.
    pub fn total(&self) -> f64 {
        self.step + self.mesh.unwrap_or(0.0)
    }

    /// Where it is from, in words.
    pub fn source(&self) -> &'static str {
        match (self.from, self.mesh) {
            (From::StepError, None) => "step_error",
            (From::StepError, Some(_)) => "step_error + mesh_error",
            (From::HalfStep, _) => "change with dt/2",
        }
    }
}

/// A study with the errors of the time step and of the mesh as metrics.
#[derive(Debug)]
pub struct ErrorStudy {
    study: Study,
    /// The channel whose `rms_error` is minimised.
    channel: String,
    /// Row of the error of the mesh, of a structure with bars.
    mesh: Option<usize>,
}

/// The study with the errors of the channel whose `rms_error` is minimised; `None` for another metric, and for a channel of which no
/// exact motion is known.
pub fn error_study(input: &Input, study: &Study) -> Option<ErrorStudy> {
    let channel = channel::channel(study)?;
    let mesh = input.has_bars().then(|| format!("mesh_error({channel})"));
    let step = format!("step_error({channel})");
    let names: Vec<String> = [step].into_iter().chain(mesh.clone()).collect();
    let study = input.error_study(&names, MOST_CASES).ok()?;
    let mut metrics = study.problem.metrics().iter();
    let mesh = mesh.map(|name| metrics.position(|metric| metric.name == name));
    Some(ErrorStudy {
        channel: channel.to_owned(),
        mesh: mesh.map_or(Some(None), |row| row.map(Some))?,
        study,
    })
}

/// The numerical part of the misfit at these values; `None` if a case has no solution with half the step either.
///
/// # Errors
/// The search was stopped.
pub fn numerical(
    errors: Option<&ErrorStudy>,
    misfit: &mut Misfit,
    alternative: &Alternative,
    values: &[f64],
) -> Result<Option<Numerical>, Stopped> {
    if let Some(errors) = errors
        && let Some(error) = errors.of(misfit, alternative, values)
    {
        return Ok(Some(error));
    }
    let problem = &*misfit.study.problem;
    let cases = misfit.cases.cases_with(&[values.to_vec()]);
    let mut finer = Cases::new(problem.schema());
    let mut shown = cases.shown();
    for row in 0..cases.len() {
        finer.push(&with_finer_step(problem, shown.at(row), 2));
    }
    let [given, finer] = [cases, finer].map(|cases| {
        let values = misfit.values(&cases)?;
        Ok(misfit.pooled(&values, 1).first().copied())
    });
    let change = given?
        .zip(finer?)
        .map(|(given, finer)| (given - finer).abs());
    Ok(change.filter(|x| x.is_finite()).map(|step| Numerical {
        step,
        mesh: None,
        from: From::HalfStep,
    }))
}

impl ErrorStudy {
    /// The errors, of several tests as their misfits are pooled; `None` if a test has no exact motion.
    fn of(&self, misfit: &Misfit, alternative: &Alternative, values: &[f64]) -> Option<Numerical> {
        let cases = self.study.point_cases(alternative, misfit.cases.free());
        let tests = channel::tests(&self.study, &cases, values);
        // Of several tests as their misfits.
        let pooled = |error: &dyn Fn(&Test) -> Option<f64>| {
            let errors = tests.iter().map(error).collect::<Option<Vec<f64>>>()?;
            Some(misfit.pooling.misfit(&errors)).filter(|x| x.is_finite())
        };
        let step = pooled(&|test| channel::step_error(&self.study, test, &self.channel))?;
        let mesh = match self.mesh {
            None => None,
            Some(row) => Some(pooled(&|test| test.solution.as_ref()?.metrics[row])?),
        };
        Some(Numerical {
            step,
            mesh,
            from: From::StepError,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_whole_part_is_the_sum_and_says_its_source() {
        let numerical = Numerical {
            step: 0.25,
            mesh: Some(0.5),
            from: From::StepError,
        };
        assert_eq!(
            (numerical.total(), numerical.source()),
            (0.75, "step_error + mesh_error")
        );
    }
}
