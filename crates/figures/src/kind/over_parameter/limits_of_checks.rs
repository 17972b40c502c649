//! The limits of the study's checks of a metric, as vertical intervals at the cases that they apply to.

use crate::DrawnCase;
use slipgap_drawing::layout::legend::Key;
use slipgap_drawing::layout::sheet::{Panel, Series};
use slipgap_drawing::style::{self, Stroke};
use slipgap_study::Check;

/// Half the length of the cap at an end, in points.
const CAP: f64 = 4.0;

/// Length of the stem at the end of an interval without another end, in points.
const STEM: f64 = 9.0;

/// The limits at one place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Value of the parameter along the axis.
    pub at: f64,
    /// Smallest value allowed.
    pub min: Option<f64>,
    /// Largest value allowed.
    pub max: Option<f64>,
}

/// The limits of a metric at the cases, equal ones once.
pub fn of<'a>(
    checks: &[Check],
    metric: usize,
    cases: impl Iterator<Item = DrawnCase<'a>>,
    at: impl Fn(&DrawnCase) -> Option<f64>,
) -> Vec<Limits> {
    let of_metric: Vec<&Check> = checks
        .iter()
        .filter(|check| check.metric == metric)
        .collect();
    let mut found: Vec<Limits> = Vec::new();
    for shown in cases.filter(|_| !of_metric.is_empty()) {
        let case = shown.case();
        for check in of_metric.iter().filter(|check| check.filter.matches(&case)) {
            let Some(at) = at(&shown) else { continue };
            let limits = Limits {
                at,
                min: check.min,
                max: check.max,
            };
            if !found.contains(&limits) {
                found.push(limits);
            }
        }
    }
    found
}

/// The entry of the legend.
pub fn key() -> Key {
    Key {
        label: "limits of the checks".into(),
        stroke: Stroke::Solid,
        width: style::EXACT_LINE,
        marker: None,
    }
}

impl Limits {
    /// Adds the interval to a panel: a line with a cap at each end; a stem where it has no other end.
    pub fn draw(&self, panel: &mut Panel) {
        let centre = panel.x.fraction(self.at);
        let [left, right] = [-CAP, CAP].map(|by| panel.x.value(centre + by / panel.frame.width));
        let moved = |y: f64, by: f64| panel.y.value(panel.y.fraction(y) + by / panel.frame.height);
        let stem = match (self.min, self.max) {
            (Some(min), Some(max)) => [min, max],
            (Some(min), None) => [min, moved(min, STEM)],
            (None, Some(max)) => [moved(max, -STEM), max],
            (None, None) => return,
        };
        let limits = self.min.into_iter().chain(self.max);
        let caps = limits.map(|y| [[left, y], [right, y]]);
        let lines: Vec<_> = std::iter::once(stem.map(|y| [self.at, y]))
            .chain(caps)
            .collect();
        panel.series.extend(lines.into_iter().map(|ends| Series {
            width: style::EXACT_LINE,
            ..Series::rule(ends)
        }));
    }
}
