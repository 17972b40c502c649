//! The last columns of fragility.csv, which are the same in all rows of a curve.

use crate::groups::fragility::FragilityCurve;
use crate::output::failures_and_histories::cell;
use slipgap_study::kinds::{Fit, Fragility};
use slipgap_study::{ColumnRef, Study};

/// The ends of intervals, by formulas and by the jackknife.
const ENDS: [&str; 8] = [
    "median_low",
    "median_high",
    "dispersion_low",
    "dispersion_high",
    "median_low_jackknife",
    "median_high_jackknife",
    "dispersion_low_jackknife",
    "dispersion_high_jackknife",
];

/// Of capacities: members without one, whose bounds are known.
const BOUNDED: [&str; 2] = ["beyond", "before"];

/// Of clouds.
const CLOUD: [&str; 2] = ["slope", "deviation"];

/// With a hazard curve.
const ANNUAL: [&str; 5] = [
    "frequency",
    "frequency_low_jackknife",
    "frequency_high_jackknife",
    "frequency_outside",
    "frequency_closed_form",
];

/// Which of the columns the figures of a study have.
pub(super) struct Numbers {
    bounded: bool,
    cloud: bool,
    collapsed: bool,
    /// The columns over which a figure tests residuals.
    against: Vec<ColumnRef>,
    annual: bool,
}

impl Numbers {
    pub(super) fn new(figures: &[&Fragility]) -> Numbers {
        let mut against: Vec<ColumnRef> = Vec::new();
        for column in figures.iter().flat_map(|figure| &figure.against) {
            if !against.contains(column) {
                against.push(*column);
            }
        }
        let any = |is: fn(&Fragility) -> bool| figures.iter().any(|figure| is(figure));
        Numbers {
            bounded: any(|figure| figure.fit == Fit::Incremental),
            cloud: any(|figure| figure.fit == Fit::Cloud),
            collapsed: any(|figure| figure.collapse.is_some()),
            against,
            annual: any(|figure| !figure.hazard.is_empty()),
        }
    }

    pub(super) fn names(&self, study: &Study) -> Vec<String> {
        let table = study.problem.parameters();
        let trend = |column: &ColumnRef| {
            let name = match column {
                ColumnRef::Parameter(row) => table[*row].column_name(),
                ColumnRef::Metric(row) => &study.measures[*row].name,
            };
            ["slope", "p"].map(|what| format!("residual_{what}({name})"))
        };
        let text = |name: &str| name.to_owned();
        let mut names: Vec<String> = ENDS.map(text).into();
        names.extend(BOUNDED.map(text).into_iter().filter(|_| self.bounded));
        names.extend(CLOUD.map(text).into_iter().filter(|_| self.cloud));
        names.extend(self.collapsed.then(|| "collapsed".to_owned()));
        names.extend(self.against.iter().flat_map(trend));
        names.extend(ANNUAL.map(text).into_iter().filter(|_| self.annual));
        names
    }

    pub(super) fn of(&self, figure: &Fragility, curve: &FragilityCurve) -> Vec<String> {
        let ends = [curve.intervals(), curve.jackknife]
            .map(|ends| ends.map_or([None; 4], |[[a, b], [c, d]]| [a, b, c, d].map(Some)));
        let mut cells: Vec<String> = ends.concat().into_iter().map(cell).collect();
        let count = |count: usize, has: bool| match has {
            true => count.to_string(),
            false => String::new(),
        };
        if self.bounded {
            let is_incremental = figure.fit == Fit::Incremental;
            cells.extend(curve.bounded.map(|members| count(members, is_incremental)));
        }
        if self.cloud {
            let fitted = curve.fit.as_ref().ok().and_then(|fit| fit.line);
            let line = [
                fitted.map(|line| line.slope),
                fitted.map(|line| line.deviation),
            ];
            cells.extend(line.map(cell));
        }
        if self.collapsed {
            cells.push(count(curve.collapsed, figure.collapse.is_some()));
        }
        for column in &self.against {
            let index = figure.against.iter().position(|known| known == column);
            let line = index.and_then(|i| curve.trends[i]);
            let trend = [
                line.map(|line| line.slope),
                line.map(|line| line.p_of_slope()),
            ];
            cells.extend(trend.map(cell));
        }
        if self.annual {
            let found = curve.annual.as_ref();
            let annual = [
                found.map(|annual| annual.frequency),
                found.and_then(|annual| Some(annual.interval?[0])),
                found.and_then(|annual| Some(annual.interval?[1])),
                found.map(|annual| annual.outside),
                found.map(|annual| annual.closed_form),
            ];
            cells.extend(annual.map(cell));
        }
        cells
    }
}
