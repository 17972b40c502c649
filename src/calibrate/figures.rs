//! The data of the figures of a calibration.

use super::words::label;
use super::{Calibration, Fit};
use crate::figures::{MeasuredMotion, MeasuredPanel, MisfitCurve, MisfitPanel, Misfits};
use slipgap_recommend::calibrate::End;
use slipgap_solver::problem::{MeasuredChannel, escape};
use slipgap_study::Free;

/// Most tests with panels of their own.
const MOST_TESTS: usize = 4;

/// The misfit over each free parameter.
pub fn misfits(found: &Calibration) -> Misfits {
    let calibrate = found.study.calibrate.as_ref();
    let free = calibrate.map_or(&[][..], |own| &own.free);
    let is_used = |free: &&Free| {
        let mut fits = found.fits.iter();
        fits.any(|fit| place(fit, free).is_some_and(|place| place < fit.found.profiles.len()))
    };
    let measure = calibrate.map(|own| &found.study.measures[own.minimise]);
    let best = found.best().map(Fit::misfit);
    Misfits {
        title: format!("{}: misfit over the free parameters", found.study.title),
        axis: measure.map_or(String::new(), |own| own.symbol.clone()),
        limit: best.map(|best| 1.1 * best),
        panels: free
            .iter()
            .filter(is_used)
            .map(|free| panel(found, free))
            .collect(),
    }
}

fn place(fit: &Fit, free: &Free) -> Option<usize> {
    fit.free
        .iter()
        .position(|own| own.parameter == free.parameter)
}

fn panel(found: &Calibration, free: &Free) -> MisfitPanel {
    let parameter = &found.study.problem.parameters()[free.parameter];
    let curve = |(index, fit): (usize, &Fit)| {
        let place = place(fit, free)?;
        let profile = fit.found.profiles.get(place)?;
        let points = profile.points.iter();
        let points = points.map(|point| [free.range.at(point.at), point.misfit]);
        let end = |i: usize, end: End| fit.value(place, end).unwrap_or(free.range.ends[i]);
        Some(MisfitCurve {
            index,
            label: escape(label(fit)),
            points: points.collect(),
            best: [fit.values[place], fit.misfit()],
            interval: profile
                .interval
                .map(|[from, to]| [end(0, from), end(1, to)]),
        })
    };
    MisfitPanel {
        title: parameter.title(),
        range: free.range.ends,
        log: free.range.log,
        curves: found.fits.iter().enumerate().filter_map(curve).collect(),
    }
}

/// What was measured, and what is computed with the best values of each alternative; `None` without measurements.
pub fn measured(found: &Calibration) -> Option<MeasuredMotion> {
    let best = found.best()?;
    let tests = best.tests.len();
    let mut panels = Vec::new();
    for test in 0..tests.min(MOST_TESTS) {
        for channel in 0..best.tests[test].measured.len() {
            panels.push(motion(found, best, test, channel)?);
        }
    }
    (!panels.is_empty()).then(|| MeasuredMotion {
        title: format!("{}: measured and computed", found.study.title),
        time: found.study.problem.schema().time.title.to_string(),
        left_out: tests.saturating_sub(MOST_TESTS),
        panels,
    })
}

fn motion(found: &Calibration, best: &Fit, test: usize, channel: usize) -> Option<MeasuredPanel> {
    let problem = &found.study.problem;
    let own = best.tests[test].measured.get(channel)?;
    let mut quantities = problem.schema().quantities.iter();
    let quantity = quantities.find(|quantity| quantity.channel == own.column);
    let curve = |(index, fit): (usize, &Fit)| {
        let own = fit.tests.get(test)?;
        let computed = &own.solution.as_ref()?.computed;
        let column = own.measured.get(channel)?.column;
        let points = computed.time.iter().zip(computed.channel(column));
        let points = points.map(|(t, x)| [*t, *x]).collect();
        Some((index, escape(label(fit)), points))
    };
    let caption = best
        .alternative
        .tests
        .get(test)
        .filter(|_| best.tests.len() > 1);
    Some(MeasuredPanel {
        title: quantity.map_or_else(|| escape(&own.name), |own| own.title.to_string()),
        caption: caption.map_or(String::new(), |name| escape(name)),
        measured: points(own),
        curves: found.fits.iter().enumerate().filter_map(curve).collect(),
    })
}

/// The points that metrics compare.
fn points(measured: &MeasuredChannel) -> Vec<[f64; 2]> {
    let points = measured.compared.clone();
    let times = measured.time[points.clone()].iter();
    let pairs = times.zip(&measured.values[points]);
    pairs.map(|(t, x)| [*t, *x]).collect()
}
