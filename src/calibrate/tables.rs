//! The tables of a calibration as CSV.

use super::words;
use super::{Calibration, Fit};
use slipgap_problem::problem::numbers::parameter::{Parameter, real};
use slipgap_recommend::calibrate::End;
use slipgap_study::Free;
use slipgap_study::error::Error;

/// calibration.csv: each free parameter of each alternative with its best value and how sharply it is determined.
pub fn parameters(found: &Calibration) -> Result<Vec<u8>, Error> {
    let header = [
        "alternative",
        "parameter",
        "best",
        "from",
        "to",
        "from_tenth",
        "to_tenth",
        "lowest",
        "highest",
        "state",
    ];
    let table = found.study.problem.parameters();
    let row = |fit: &Fit, index: usize, free: &Free| {
        let profile = fit.found.profiles.get(index);
        let ends = |ends: Option<[End; 2]>| {
            let ends = ends.map(|ends| ends.map(|end| fit.value(index, end)));
            ends.unwrap_or_default().map(cell)
        };
        let interval = ends(profile.and_then(|profile| profile.interval));
        let tenth = ends(profile.map(|profile| profile.within_tenth));
        let solved = fit.misfit().is_finite();
        let best = cell(fit.values.get(index).copied().filter(|_| solved));
        let state = fit.state(index).map_or("", words::state_name);
        [
            name_of(fit),
            table[free.parameter].column_name().to_string(),
            best,
        ]
        .into_iter()
        .chain(interval)
        .chain(tenth)
        .chain(free.range.ends.map(real))
        .chain([state.to_owned()])
        .collect()
    };
    let unused = |fit: &Fit, free: &Free| {
        let name = table[free.parameter].column_name().to_string();
        let empty = std::iter::repeat_n(String::new(), 5);
        [name_of(fit), name]
            .into_iter()
            .chain(empty)
            .chain(free.range.ends.map(real))
            .chain(["not used".to_owned()])
            .collect()
    };
    let rows = found.fits.iter().flat_map(|fit| {
        let free_parameters = fit.free.iter().enumerate();
        let used = free_parameters.map(|(index, free)| row(fit, index, free));
        used.chain(fit.unused.iter().map(|free| unused(fit, free)))
            .collect::<Vec<Vec<String>>>()
    });
    csv(header.map(String::from).to_vec(), rows)
}

/// alternatives.csv: each alternative with its misfit, what of it may be numerical, its residuals and the cases spent.
pub fn alternatives(found: &Calibration) -> Result<Vec<u8>, Error> {
    let header = [
        "alternative",
        "misfit",
        "numerical",
        "numerical_from",
        "residuals",
        "rho_1",
        "effective_residuals",
        "information",
        "widened",
        "free",
        "cases",
        "starts_at_best",
        "starts",
        "spent",
        "verdict",
    ];
    let rows = found.order.iter().map(|at| {
        let fit = &found.fits[*at];
        let (numerical, residuals) = (fit.numerical.as_ref(), fit.residuals.as_ref());
        let [at_best, starts] = fit.found.best.starts;
        let solved = fit.misfit().is_finite();
        vec![
            name_of(fit),
            cell(Some(fit.misfit()).filter(|_| solved)),
            cell(numerical.map(super::Numerical::total)),
            numerical.map_or(String::new(), |numerical| numerical.source().to_owned()),
            residuals.map_or(String::new(), |residuals| residuals.count.to_string()),
            cell(residuals.map(|residuals| residuals.correlation)),
            cell(residuals.map(super::Residuals::effective)),
            cell(words::information(found, *at)),
            cell(Some(fit.found.widened).filter(|_| !fit.found.profiles.is_empty())),
            fit.free.len().to_string(),
            fit.solved.to_string(),
            at_best.to_string(),
            starts.to_string(),
            fit.found.best.spent.to_string(),
            words::verdict(found, *at).to_owned(),
        ]
    });
    csv(header.map(String::from).to_vec(), rows)
}

/// profiles.csv: the smallest misfit over each free parameter, with the values of the others there.
pub fn profiles(found: &Calibration) -> Result<Vec<u8>, Error> {
    let free = all_free(found);
    let mut header = ["alternative", "parameter", "misfit"]
        .map(String::from)
        .to_vec();
    header.extend(names(found, &free));
    let mut rows = Vec::new();
    for fit in &found.fits {
        for (index, profile) in fit.found.profiles.iter().enumerate() {
            let name = column(found, &fit.free[index]);
            for point in &profile.points {
                let mut others = point.others.iter();
                let at_point = fit.free.iter().enumerate().map(|(k, other_free)| {
                    let u = if k == index {
                        Some(&point.at)
                    } else {
                        others.next()
                    };
                    (other_free.parameter, u.map(|u| other_free.range.at(*u)))
                });
                let values: Vec<(usize, Option<f64>)> = at_point.collect();
                let value = |free: &Free| {
                    let value = values.iter().find(|pair| pair.0 == free.parameter);
                    cell(value.and_then(|pair| pair.1))
                };
                let misfit = cell(Some(point.misfit).filter(|x| x.is_finite()));
                let mut row = vec![name_of(fit), name.clone(), misfit];
                row.extend(free.iter().map(value));
                rows.push(row);
            }
        }
    }
    csv(header, rows.into_iter())
}

/// correlation.csv: the correlation of the free parameters of each alternative.
pub fn correlation(found: &Calibration) -> Result<Vec<u8>, Error> {
    let free = all_free(found);
    let mut header = ["alternative", "parameter"].map(String::from).to_vec();
    header.extend(names(found, &free));
    let mut rows = Vec::new();
    for fit in &found.fits {
        for (line_free, line) in fit.free.iter().zip(fit.found.correlation.iter().flatten()) {
            let value = |other: &Free| {
                let index = fit
                    .free
                    .iter()
                    .position(|known| known.parameter == other.parameter);
                cell(index.map(|index| line[index]))
            };
            let mut row = vec![name_of(fit), column(found, line_free)];
            row.extend(free.iter().map(value));
            rows.push(row);
        }
    }
    csv(header, rows.into_iter())
}

/// each-test.csv: each free parameter in each test fitted alone.
pub fn each_test(found: &Calibration) -> Result<Vec<u8>, Error> {
    let header = ["alternative", "test", "parameter", "best", "from", "to"];
    let row = |fit: &Fit, index: usize| {
        let profile = fit.found.profiles.get(index);
        let interval = profile.and_then(|profile| profile.interval);
        let ends = interval.map(|ends| ends.map(|end| fit.value(index, end)));
        let solved = fit.misfit().is_finite();
        let best = fit.values.get(index).copied().filter(|_| solved);
        let names = [
            name_of(fit),
            fit.alternative.tests.join(" "),
            column(found, &fit.free[index]),
        ];
        names
            .into_iter()
            .chain([cell(best)])
            .chain(ends.unwrap_or_default().map(cell))
            .collect()
    };
    let each = found.fits.iter().flat_map(|fit| &fit.each);
    let rows = each.flat_map(|fit| (0..fit.free.len()).map(move |index| row(fit, index)));
    csv(header.map(String::from).to_vec(), rows)
}

/// scatter.csv: mean and scatter of each free parameter between the tests; empty where a test has no interval.
pub fn scatter(found: &Calibration) -> Result<Vec<u8>, Error> {
    let header = [
        "alternative",
        "parameter",
        "varies",
        "tests",
        "mean",
        "mean_low",
        "mean_high",
        "scatter",
        "scatter_low",
        "scatter_high",
        "p_common",
    ];
    let row = |fit: &Fit, free: &Free| {
        let scatter = fit.scatter(found, free);
        let calibrate = found.study.calibrate.as_ref();
        let varies = calibrate.is_some_and(|calibrate| calibrate.varies.contains(&free.parameter));
        let between = scatter.filter(|_| varies).map(|scatter| scatter.between);
        let mean = scatter.map(|scatter| scatter.mean().map(Some));
        let ends = between.map(|between| between.scatter_interval.map(Some));
        [
            name_of(fit),
            column(found, free),
            varies.to_string(),
            fit.each.len().to_string(),
        ]
        .into_iter()
        .chain(mean.unwrap_or_default().map(cell))
        .chain([cell(between.map(|between| between.scatter))])
        .chain(ends.unwrap_or_default().map(cell))
        .chain([cell(scatter.map(|scatter| scatter.between.p_common))])
        .collect()
    };
    let fits = found.fits.iter().filter(|fit| !fit.each.is_empty());
    let rows = fits.flat_map(|fit| fit.free.iter().map(move |free| row(fit, free)));
    csv(header.map(String::from).to_vec(), rows)
}

/// All free parameters of the study.
fn all_free(found: &Calibration) -> Vec<Free> {
    let calibrate = found.study.calibrate.as_ref();
    calibrate.map_or(Vec::new(), |calibrate| calibrate.free.clone())
}

fn names(found: &Calibration, free: &[Free]) -> Vec<String> {
    free.iter().map(|free| column(found, free)).collect()
}

fn column(found: &Calibration, free: &Free) -> String {
    let parameter: &Parameter = &found.study.problem.parameters()[free.parameter];
    parameter.column_name().to_string()
}

fn name_of(fit: &Fit) -> String {
    fit.label().to_owned()
}

fn cell(x: Option<f64>) -> String {
    x.map_or(String::new(), real)
}

fn csv(header: Vec<String>, rows: impl Iterator<Item = Vec<String>>) -> Result<Vec<u8>, Error> {
    let failed = |e: csv::Error| Error::Internal(e.to_string());
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(&header).map_err(failed)?;
    for row in rows {
        writer.write_record(&row).map_err(failed)?;
    }
    writer
        .into_inner()
        .map_err(|e| Error::Internal(e.to_string()))
}
