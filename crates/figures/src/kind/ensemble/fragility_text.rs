//! The words of a fragility figure: its legend and small print.

use super::ensembles::without_value;
use crate::FigureData;
use crate::groups::fragility::FragilityCurve;
use slipgap_drawing::layout;
use slipgap_drawing::layout::sheet::Sheet;
use slipgap_drawing::text::number;
use slipgap_statistics::fragility::Fragility as Function;
use slipgap_study::kinds::{Fit, Fragility};

/// What points and intervals, and what curves are.
fn words(fit: Fit) -> [&'static str; 2] {
    match fit {
        Fit::Likelihood => [
            "Points: fraction of the cases that exceed, with 95 % intervals (Clopper and Pearson).",
            "Curves: lognormal function, fitted by maximum likelihood; in brackets 95 % intervals.",
        ],
        Fit::Incremental => [
            "Points: fraction of the ensemble that has reached the limit, with 95 % intervals (Clopper and Pearson).",
            "Curves: the lognormal function of the values at which it does; in brackets 95 % intervals.",
        ],
        Fit::Cloud => [
            "Points: the cases, at 1 if they exceed.",
            "Curves: the lognormal function of a line through the logarithms of the cases; in brackets 95 % intervals.",
        ],
    }
}

/// Adds what points and curves are, and which cases and members are known by bounds only; `shown` of the curves are drawn.
pub(super) fn small_print(
    figure: &Fragility,
    data: &FigureData,
    curves: &[FragilityCurve],
    shown: usize,
    sheet: &mut Sheet,
) {
    let fitted = curves.iter().take(shown).any(|of| of.fit.is_ok());
    let [points_are, curves_are] = words(figure.fit);
    let sentences = [Some(points_are), fitted.then_some(curves_are)];
    let parts: Vec<&str> = sentences.into_iter().flatten().collect();
    layout::small_print(sheet, &parts.join(" "));
    match figure.collapse {
        Some(_) => {
            let collapsed: usize = curves.iter().map(|curve| curve.collapsed).sum();
            let words = format!("{collapsed} of {} cases have collapsed.", data.cases.len());
            layout::small_print(sheet, &words);
        }
        None => without_value(sheet, data.study, data.cases, &[figure.y]),
    }
    if figure.fit == Fit::Incremental {
        without_capacity(sheet, curves);
    }
}

/// Small print of members whose capacities are known by bounds only.
fn without_capacity(sheet: &mut Sheet, curves: &[FragilityCurve]) {
    let fitted = curves.iter().filter(|curve| curve.fit.is_ok());
    let [beyond, before] = fitted.fold([0, 0], |sum, curve| {
        [0, 1].map(|i| sum[i] + curve.bounded[i])
    });
    if beyond + before > 0 {
        let words = format!(
            "Members of the ensemble that do not reach the limit: {beyond}; that exceed it at the smallest value: {before}. With these bounds the functions are fitted by maximum likelihood."
        );
        layout::small_print(sheet, &words);
    }
}

/// The label of an ensemble with its fit.
pub(super) fn label(name: &str, curve: &FragilityCurve) -> String {
    let fit = match &curve.fit {
        Ok(fit) => {
            let rounded = |x| number::rounded(x, 3);
            let intervals = fit.intervals();
            let ends = |i: usize| {
                let [low, high] = intervals[i].map(rounded);
                format!(" [{low}, {high}]")
            };
            let Function { median, dispersion } = fit.function;
            let [median, dispersion] = [median, dispersion].map(rounded);
            format!(
                "median {median}{}, dispersion {dispersion}{}",
                ends(0),
                ends(1)
            )
        }
        Err(why) => format!("no fit, {why}"),
    };
    match name {
        "" => fit,
        name => format!("{name}: {fit}"),
    }
}
