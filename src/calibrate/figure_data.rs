//! The data of the figures of a calibration.

use super::channel;
use super::{Calibration, Fit};
use crate::figures::{AlternativeMisfit, MeasuredMotion, MeasuredPanel, MisfitPanel, Misfits};
use slipgap_problem::problem::{MeasuredChannel, escape};
use slipgap_recommend::calibrate::End;

/// Most tests with panels of their own.
const MOST_TESTS: usize = 4;

/// The misfit of each alternative over each of its free parameters.
pub fn misfits(found: &Calibration) -> Misfits {
    let calibrate = found.study.calibrate.as_ref();
    let measure = calibrate.map(|calibrate| &found.study.measures[calibrate.minimise]);
    let alternative = |fit: &Fit| AlternativeMisfit {
        label: escape(fit.label()),
        least: fit.misfit(),
        panels: (0..fit.found.profiles.len())
            .map(|index| panel(found, fit, index))
            .collect(),
    };
    let solved = found.fits.iter().filter(|fit| fit.misfit().is_finite());
    Misfits {
        title: format!("{}: misfit over the free parameters", found.study.title),
        axis: measure.map_or(String::new(), |measure| measure.symbol.clone()),
        alternatives: solved.map(alternative).collect(),
    }
}

/// The profile of a free parameter of an alternative.
fn panel(found: &Calibration, fit: &Fit, index: usize) -> MisfitPanel {
    let (free, profile) = (&fit.free[index], &fit.found.profiles[index]);
    let points = profile.points.iter();
    let end = |i: usize, end: End| fit.value(index, end).unwrap_or(free.range.ends[i]);
    MisfitPanel {
        title: found.study.problem.parameters()[free.parameter].title(),
        range: free.range.ends,
        log: free.range.log,
        points: points
            .map(|point| [free.range.at(point.at), point.misfit])
            .collect(),
        best: fit.values[index],
        interval: profile
            .interval
            .map(|[from, to]| [end(0, from), end(1, to)]),
    }
}

/// What was measured, what the best alternative computes with its best values, and the residuals of all alternatives; `None` without
/// measurements.
pub fn measured(found: &Calibration) -> Option<MeasuredMotion> {
    let best = *found.order.first()?;
    let tests = &found.best()?.tests;
    let mut panels = Vec::new();
    for (number, test) in tests.iter().enumerate().take(MOST_TESTS) {
        for channel in 0..test.measured.len() {
            panels.push(motion(found, best, number, channel)?);
        }
        panels.extend(residual(found, best, number));
    }
    (!panels.is_empty()).then(|| MeasuredMotion {
        title: format!("{}: measured and computed", found.study.title),
        time: found.study.problem.schema().time.title.to_string(),
        left_out: tests.len().saturating_sub(MOST_TESTS),
        panels,
    })
}

/// A measured channel of a test with that of the best alternative.
fn motion(found: &Calibration, best: usize, test: usize, channel: usize) -> Option<MeasuredPanel> {
    let fit = &found.fits[best];
    let measured = fit.tests[test].measured.get(channel)?;
    let computed = &fit.tests[test].solution.as_ref()?.computed;
    let curve = computed
        .time
        .iter()
        .zip(computed.channel(measured.column))
        .map(|(t, x)| [*t, *x]);
    Some(MeasuredPanel {
        title: title(found, measured),
        caption: caption(fit, test),
        measured: points(measured),
        curves: vec![(best, escape(fit.label()), curve.collect())],
    })
}

/// The residuals of the minimised channel, of each alternative.
fn residual(found: &Calibration, best: usize, test: usize) -> Option<MeasuredPanel> {
    let channel = channel::channel(&found.study)?;
    let curve = |(index, fit): (usize, &Fit)| {
        let test = fit.tests.get(test)?;
        let times = points(channel::measured(test, channel)?);
        let residuals = channel::residuals(test, channel)?;
        let pairs = times.iter().zip(residuals);
        let points = pairs.map(|(point, residual)| [point[0], residual]);
        Some((index, escape(fit.label()), points.collect()))
    };
    let channel_measured = channel::measured(&found.fits[best].tests[test], channel)?;
    Some(MeasuredPanel {
        title: format!("computed - measured, {}", title(found, channel_measured)),
        caption: caption(&found.fits[best], test),
        measured: Vec::new(),
        curves: found.fits.iter().enumerate().filter_map(curve).collect(),
    })
}

/// The title of the axis of a channel, in markup.
fn title(found: &Calibration, measured: &MeasuredChannel) -> String {
    let mut quantities = found.study.problem.schema().quantities.iter();
    let quantity = quantities.find(|quantity| quantity.channel == measured.column);
    quantity.map_or_else(
        || escape(&measured.name),
        |quantity| quantity.title.to_string(),
    )
}

/// The name of a test, in markup; empty for a single one.
fn caption(fit: &Fit, test: usize) -> String {
    let several = fit.alternative.tests.len() > 1;
    let name = fit.alternative.tests.get(test).filter(|_| several);
    name.map_or(String::new(), |name| escape(name))
}

/// The points that metrics compare.
fn points(measured: &MeasuredChannel) -> Vec<[f64; 2]> {
    let points = measured.compared.clone();
    let times = measured.time[points.clone()].iter();
    let pairs = times.zip(&measured.values[points]);
    pairs.map(|(t, x)| [*t, *x]).collect()
}
