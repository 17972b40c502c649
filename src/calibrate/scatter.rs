//! How free parameters vary from test to test: every test is fitted alone, then their values with their errors have a mean and a scatter.

use super::{Calibration, Fit};
use slipgap_recommend::calibrate::{Between, End};
use slipgap_recommend::format::digits;
use slipgap_statistics::{CONFIDENCE, fisher};
use slipgap_study::Free;

/// Probability below which a common parameter is doubted.
const LEVEL: f64 = 0.05;

/// What the tests of an alternative say about a free parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scatter {
    /// Whether it varies from test to test by the study.
    pub varies: bool,
    /// Mean and scatter; of a logarithmic range those of the natural logarithm.
    pub between: Between,
    /// Whether its range is logarithmic.
    pub log: bool,
}

impl Scatter {
    /// The mean and its interval in the unit of the parameter.
    pub fn mean(&self) -> [f64; 3] {
        let [low, high] = self.between.mean_interval;
        [self.between.mean, low, high].map(|x| if self.log { libm::exp(x) } else { x })
    }
}

impl Fit {
    /// What the tests, each fitted alone, say about a free parameter; `None` if one of them has no interval of it.
    pub fn scatter(&self, found: &Calibration, free: &Free) -> Option<Scatter> {
        let each = self.each.iter().map(|test| test.estimate(free));
        let (values, errors): (Vec<f64>, Vec<f64>) =
            each.collect::<Option<Vec<_>>>()?.into_iter().unzip();
        let calibrate = found.study.calibrate.as_ref()?;
        let varies = calibrate.varies.contains(&free.parameter);
        Some(Scatter {
            varies,
            between: Between::of(&values, &errors, varies)?,
            log: free.range.log,
        })
    }

    /// The best value of a free parameter with its standard error, half of the 95 % interval over t; of a logarithmic range those of the
    /// natural logarithm. `None` without an interval.
    fn estimate(&self, free: &Free) -> Option<(f64, f64)> {
        let index = self.free.iter().position(|known| known == free)?;
        let Some([End::At(low), End::At(high)]) = self.found.profiles.get(index)?.interval else {
            return None;
        };
        let scaled = |x: f64| if free.range.log { libm::log(x) } else { x };
        let freedom = self.residuals?.for_intervals()? - self.free.len() as f64;
        let t = fisher::quantile(CONFIDENCE, 1.0, freedom).sqrt();
        let [low, high] = [low, high].map(|u| scaled(free.range.at(u)));
        Some((scaled(self.values[index]), (high - low) / (2.0 * t)))
    }
}

/// What the tests say, in words.
pub(super) fn sentences(found: &Calibration, fit: &Fit, prefix: &str) -> Vec<String> {
    let table = found.study.problem.parameters();
    let tests = fit.each.len();
    let one = |free: &Free| {
        let name = &table[free.parameter].name;
        let calibrate = found.study.calibrate.as_ref();
        let varies = calibrate.is_some_and(|calibrate| calibrate.varies.contains(&free.parameter));
        let Some(scatter) = fit.scatter(found, free) else {
            let mut each = fit.each.iter();
            let test = each
                .find(|test| test.estimate(free).is_none())
                .and_then(|test| test.alternative.tests.first())
                .map_or("", String::as_str);
            return varies.then(|| {
                format!("{prefix}{name} has no scatter, because it has no 95 % interval with two ends in the test {test}")
            });
        };
        let (between, [mean, low, high]) = (scatter.between, scatter.mean().map(digits));
        let [least, most] = between.scatter_interval.map(digits);
        let what = if scatter.log {
            "scatter of ln"
        } else {
            "scatter"
        };
        match varies {
            true => Some(format!(
                "{prefix}{name} varies between {tests} tests: mean {mean} ({low} to {high}), {what} {} ({least} to {most})",
                digits(between.scatter)
            )),
            false if between.p_common < LEVEL => Some(format!(
                "{prefix}{name} differs between the tests by more than its errors (p = {}); it may be one that \"varies\"",
                digits(between.p_common)
            )),
            false => None,
        }
    };
    fit.free
        .iter()
        .filter(|_| tests > 0)
        .filter_map(one)
        .collect()
}
