//! Curves that one numeric parameter distinguishes: their order by this number, and their strokes from dark to light.

use crate::DrawnCase;
use slipgap_drawing::style::{Look, Marker, Stroke};

/// The indices of the labels by rising number, if one numeric parameter distinguishes more curves than there are markers.
pub fn order(
    named: &[usize],
    cases: &[DrawnCase],
    indices: &[usize],
    count: usize,
) -> Option<Vec<usize>> {
    let [row] = *named else {
        return None;
    };
    if count <= Marker::KINDS {
        return None;
    }
    let number = |index: usize| {
        let first = indices.iter().position(|its| *its == index)?;
        cases[first].number(row)
    };
    let numbers: Vec<f64> = (0..count).map(number).collect::<Option<_>>()?;
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|a, b| numbers[*a].total_cmp(&numbers[*b]));
    Some(order)
}

/// The strokes of labels: from dark to light by their numbers if these distinguish many in colour, or else those of the look.
pub fn strokes(look: Look, order: Option<&[usize]>, count: usize) -> Vec<Stroke> {
    match order.filter(|_| look.colour) {
        Some(order) => graded(order),
        None => (0..count).map(|i| look.stroke(i, count)).collect(),
    }
}

/// The stroke of each curve by its place in the order.
pub fn graded(order: &[usize]) -> Vec<Stroke> {
    let mut strokes = vec![Stroke::Solid; order.len()];
    for (rank, index) in order.iter().enumerate() {
        strokes[*index] = Stroke::graded(rank, order.len());
    }
    strokes
}
