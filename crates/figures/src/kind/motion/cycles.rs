//! The motion of a case at the cycles of its excitation, as points.

use crate::DrawnCase;
use slipgap_drawing::layout::sheet::Series;
use slipgap_drawing::style::{self, Marker, Stroke};
use slipgap_motion::history::History;
use slipgap_problem::problem::Quantity;
use slipgap_study::Study;
use slipgap_study::kinds::Each;
use slipgap_system::system::loads::cycles::Cycles;

/// The whole cycles of the excitation of a case.
pub fn of_case(study: &Study, shown: &DrawnCase) -> Vec<Cycles> {
    let structure = study.problem.as_structure();
    let cycles = structure.and_then(|structure| structure.cycles(&shown.case()).ok());
    cycles.unwrap_or_default()
}

/// The value at a time, straight between the steps.
pub fn at(time: &[f64], values: &[f64], t: f64) -> f64 {
    let last = time.len().min(values.len()).saturating_sub(1);
    let after = time
        .partition_point(|step| *step <= t)
        .clamp(1, last.max(1));
    let (Some([t0, t1]), Some([v0, v1])) = (
        time.get(after - 1..=after).and_then(<[f64]>::first_chunk),
        values.get(after - 1..=after).and_then(<[f64]>::first_chunk),
    ) else {
        return f64::NAN;
    };
    v0 + (v1 - v0) * ((t - t0) / (t1 - t0))
}

/// What is drawn of the cycle between two times.
pub fn of_cycle(each: Each, time: &[f64], values: &[f64], [start, end]: [f64; 2]) -> f64 {
    let ends = [start, end].map(|t| at(time, values, t));
    let inner = time.partition_point(|t| *t < start)..time.partition_point(|t| *t <= end);
    let steps = values.get(inner).unwrap_or_default().iter().copied();
    let inside = steps.chain(ends);
    match each {
        Each::Peak => inside.fold(0.0, |peak: f64, value| peak.max(value.abs())),
        Each::Max => inside.fold(f64::NEG_INFINITY, f64::max),
        Each::Min => inside.fold(f64::INFINITY, f64::min),
        Each::Start => ends[0],
    }
}

/// The values of a quantity at the steps.
pub fn values(quantity: &Quantity, computed: &History, exact: &History) -> Vec<f64> {
    let values = computed.channel(quantity.channel);
    if !quantity.error {
        return values.to_vec();
    }
    let pairs = values.iter().zip(exact.channel(quantity.channel));
    pairs.map(|(c, e)| c - e).collect()
}

/// Points without a line: dots if the case of this number is the only one, or else markers.
pub fn scattered(
    points: &[[f64; 2]],
    label: &str,
    stroke: Stroke,
    (i, count): (usize, usize),
) -> Series {
    let gap = [f64::NAN; 2];
    let apart = points.iter().flat_map(|point| [*point, gap]);
    Series {
        label: label.to_owned(),
        points: apart.collect(),
        stroke,
        width: if count == 1 { style::CASE_LINE } else { 0.0 },
        marker: (count > 1).then(|| Marker::of_case(i)),
        marked: (0..points.len()).map(|point| 2 * point).collect(),
    }
}
