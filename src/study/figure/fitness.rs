//! Whether a figure can show the cases it chooses.

use std::collections::HashMap;

use super::axis::Axis;
use super::taken::Values;
use super::{sampled, vary};
use crate::problem::parameter::Value;
use crate::study::report::{Faults, join};
use crate::study::scope::Scope;
use crate::study::{Column, Figure, FigureKind, Sampling, Scale};

/// Most curves that line styles can tell apart in one panel.
const MOST_CURVES: usize = 8;

/// Most cases of a figure of profiles, whose markers lie close.
const MOST_PROFILES: usize = 6;

/// What to do about too many cases.
const NARROW: &str = "narrow the cases with \"where\"";

/// Most panels that `panels`, or times and quantities of profiles, may ask for.
const MOST_PANELS: usize = 24;

/// Most steps of all histories in one figure: the histories of all its cases are held at once.
const MOST_DRAWN: u64 = 10_000_000;

/// Reports what keeps a figure from being drawn or read.
pub(super) fn check(figure: &Figure, values: &Values, scope: &Scope, faults: &mut Faults) {
    let on = |key: &'static str, row| Axis { key, row };
    let lists = matches!(
        figure.kind,
        FigureKind::Metric { .. }
            | FigureKind::Convergence { .. }
            | FigureKind::Budget { .. }
            | FigureKind::Map { .. }
    );
    if lists && sampled::refuse(figure, values, scope, faults) {
        return;
    }
    match &figure.kind {
        FigureKind::History { by, panels, .. } => {
            let by = by.map(|row| on("by", row));
            let panel = panels.map(|row| on("panels", row));
            for axis in by.iter().chain(&panel) {
                axis.has_values(figure, values, scope, faults);
            }
            if let Some(by) = by {
                let told: Vec<usize> = panel.iter().map(|axis| axis.row).chain([by.row]).collect();
                vary::check(figure, &told, values, scope, faults);
            }
            curves(figure, *panels, values, scope, faults);
        }
        FigureKind::Metric { x, by, x_scale, .. } => {
            let x = on("x", *x);
            x.has_values(figure, values, scope, faults);
            x.fits(*x_scale, figure, values, scope, faults);
            if let Some(by) = by {
                on("by", *by).has_values(figure, values, scope, faults);
                vary::check(figure, &[x.row, *by], values, scope, faults);
            }
        }
        FigureKind::Convergence { x, by, .. } => {
            let x = on("x", *x);
            x.has_values(figure, values, scope, faults);
            x.fits(Scale::Log, figure, values, scope, faults);
            if let Some(by) = by {
                on("by", *by).has_values(figure, values, scope, faults);
                vary::check(figure, &[x.row, *by], values, scope, faults);
            }
        }
        FigureKind::Budget { x, y, panels } => {
            let along = on("x", *x);
            along.has_values(figure, values, scope, faults);
            along.fits(Scale::Log, figure, values, scope, faults);
            let mut axes = vec![*x];
            if let Some(row) = panels {
                on("panels", *row).has_values(figure, values, scope, faults);
                panel_count(figure, *row, y.len(), values, scope, faults);
                axes.push(*row);
            }
            vary::check(figure, &axes, values, scope, faults);
        }
        FigureKind::Map {
            x,
            y,
            scales,
            marks,
            ..
        } => {
            let axes = [on("x", *x), on("y", *y)];
            for (axis, scale) in axes.iter().zip(scales) {
                axis.has_values(figure, values, scope, faults);
                axis.fits(*scale, figure, values, scope, faults);
            }
            if x == y {
                let path = join(values.path, "y");
                faults.add(values.at("y"), &path, "must be a parameter other than x");
            }
            vary::check(figure, &[*x, *y], values, scope, faults);
            for (i, at) in marks.iter().flat_map(|marks| &marks.at).enumerate() {
                for (axis, place) in axes.iter().zip(at) {
                    axis.reaches(*place, i, figure, values, scope, faults);
                }
            }
        }
        FigureKind::Profile { y, times } => {
            profiles(figure, y.len() * times.len(), values, scope, faults);
            within(figure, times, values, scope, faults);
        }
        FigureKind::Wave { .. } => one_case(figure, values, scope, faults),
        FigureKind::Scatter {
            x,
            y,
            colour,
            scales,
        } => {
            let columns = [("x", Some(x)), ("y", Some(y)), ("colour", colour.as_ref())];
            for ((key, column), scale) in columns.into_iter().zip(scales) {
                if let Some(Column::Parameter(row)) = column {
                    on(key, *row).has_values(figure, values, scope, faults);
                    on(key, *row).fits(*scale, figure, values, scope, faults);
                }
            }
            if x == y {
                let path = join(values.path, "y");
                faults.add(values.at("y"), &path, "must be a column other than x");
            }
            if colour.is_none() && values.has("colour_scale") {
                let path = join(values.path, "colour_scale");
                let message = "needs the key \"colour\"";
                faults.add(values.at("colour_scale"), &path, message);
            }
        }
        FigureKind::Samples { parameters, .. } => sampled::check(parameters.len(), values, faults),
        FigureKind::Sobol { .. } => saltelli(figure, values, scope, faults),
        FigureKind::Law => {}
    }
}

/// Reports more panels than fit a page.
fn panel_count(
    figure: &Figure,
    row: usize,
    rows: usize,
    values: &Values,
    scope: &Scope,
    faults: &mut Faults,
) {
    let count = rows * scope.levels(&figure.filter, row).len();
    if count > MOST_PANELS {
        let message = format!("{count} panels; allowed: at most {MOST_PANELS}; {NARROW}");
        faults.add(values.at("panels"), &join(values.path, "panels"), message);
    }
}

/// Reports more curves in a panel than can be told apart, more panels than fit a page, or more steps than fit in memory.
fn curves(
    figure: &Figure,
    panels: Option<usize>,
    values: &Values,
    scope: &Scope,
    faults: &mut Faults,
) {
    if let Some(row) = panels {
        let count = scope.levels(&figure.filter, row).len();
        if count > MOST_PANELS {
            let message = format!("{count} panels; allowed: at most {MOST_PANELS}; {NARROW}");
            faults.add(values.at("panels"), &join(values.path, "panels"), message);
            return;
        }
    }
    let mut counts: HashMap<Option<(u64, &str)>, usize> = HashMap::new();
    let mut steps = 0u64;
    let case = |index| crate::study::cases::case(&*scope.problem, &scope.blocks, index);
    for case in scope.select(&figure.filter).filter_map(case) {
        let panel = panels.and_then(|row| case.values[row]).map(Value::identity);
        let count = counts.entry(panel).or_default();
        *count += 1;
        steps = steps.saturating_add(scope.problem.steps(&case));
        let most = if *count > MOST_CURVES {
            format!("{MOST_CURVES} cases in one panel")
        } else if steps > MOST_DRAWN {
            format!("{MOST_DRAWN} steps to draw")
        } else {
            continue;
        };
        let message = format!("more than {most}; {NARROW}");
        faults.add(values.at("where"), &join(values.path, "where"), message);
        return;
    }
}

/// Reports more profiles than can be told apart, or than fit a page.
fn profiles(figure: &Figure, panels: usize, values: &Values, scope: &Scope, faults: &mut Faults) {
    if panels > MOST_PANELS {
        let message = format!("{panels} panels; allowed: at most {MOST_PANELS}");
        faults.add(values.at("times"), &join(values.path, "times"), message);
    }
    if scope.select(&figure.filter).nth(MOST_PROFILES).is_some() {
        let message = format!("more than {MOST_PROFILES} cases in one panel; {NARROW}");
        faults.add(values.at("where"), &join(values.path, "where"), message);
    }
}

/// Reports times that a case shown does not reach.
fn within(figure: &Figure, times: &[f64], values: &Values, scope: &Scope, faults: &mut Faults) {
    let table = scope.problem.parameters();
    let Some(row) = table.iter().position(|p| p.name == "duration") else {
        return;
    };
    let ends = scope.levels(&figure.filter, row);
    let end = ends.iter().filter_map(|level| level.as_f64());
    let end = end.fold(f64::INFINITY, f64::min);
    for (i, time) in times.iter().enumerate().filter(|(_, t)| **t > end) {
        let (at, path) = values.item("times", i);
        let message = format!("must be at most duration = {end}, got {time}");
        faults.add(at, &path, message);
    }
}

/// Reports cases that are not just those of one saltelli design.
fn saltelli(figure: &Figure, values: &Values, scope: &Scope, faults: &mut Faults) {
    let chosen = scope.select(&figure.filter).count() as u64;
    let whole = |block: &&crate::study::Block| {
        let design = block.design.as_ref();
        let fits =
            |d: &crate::study::Design| d.sampling == Sampling::Saltelli && d.points() == chosen;
        design.is_some_and(fits)
            && block.select(&*scope.problem, &figure.filter).count() as u64 == chosen
    };
    if !scope.blocks.iter().any(|block| whole(&block)) {
        let message = "a sobol figure shows all cases of one block with a saltelli design, and no other cases";
        faults.add(values.at("where"), &join(values.path, "where"), message);
    }
}

/// Reports more cases than the one that a wave shows.
fn one_case(figure: &Figure, values: &Values, scope: &Scope, faults: &mut Faults) {
    if scope.select(&figure.filter).nth(1).is_some() {
        let message = format!("a wave figure shows one case, but more are chosen; {NARROW}");
        faults.add(values.at("where"), &join(values.path, "where"), message);
    }
}
