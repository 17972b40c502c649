//! The parts of a table.

use super::{MOST, Parts};
use crate::contact::LawFault;

/// Relative difference of slopes that are the same.
const SAME: f64 = 1e-9;

/// A side of a table: its bends with the falls of the slope there, its first slope and its last one.
struct Side {
    bends: Vec<[f64; 2]>,
    first: f64,
    last: f64,
}

/// The numbers of a table.
pub(super) fn parts_of(table: &[[f64; 2]]) -> Result<Parts, LawFault> {
    let rising = table.windows(2).all(|two| two[0][0] < two[1][0]);
    if !rising {
        return Err(LawFault::Table("r must rise"));
    }
    if table.iter().any(|[r, s]| *r == 0.0 && *s != 0.0) {
        return Err(LawFault::Table("S must be 0 at r = 0"));
    }
    let high: Vec<[f64; 2]> = table.iter().copied().filter(|[r, _]| *r > 0.0).collect();
    let negative = table.iter().rev().filter(|[r, _]| *r < 0.0);
    let low: Vec<[f64; 2]> = negative.map(|[r, s]| [-r, -s]).collect();
    let Some(up) = side(&high)? else {
        return Err(LawFault::Table("it needs a point with r > 0"));
    };
    match side(&low)? {
        None => parts(&up, &up),
        Some(down) if (up.first - down.first).abs() > SAME * up.first => Err(LawFault::Table(
            "the slopes to the first points on both sides must be the same",
        )),
        Some(down) => parts(&down, &up),
    }
}

/// A side, by points away from 0; `None` without points.
fn side(points: &[[f64; 2]]) -> Result<Option<Side>, LawFault> {
    let mut before = [0.0; 2];
    let (mut slopes, mut bends): (Vec<f64>, Vec<[f64; 2]>) = (Vec::new(), Vec::new());
    for point in points {
        let slope = (point[1] - before[1]) / (point[0] - before[0]);
        let last = slopes.last().copied();
        let fall = last.map_or(0.0, |last| last - slope);
        // The slope of points on one line has round-off.
        let straight = last.is_some_and(|last| fall.abs() <= SAME * last);
        if slope < 0.0 || last.is_none() && slope <= 0.0 || fall < 0.0 && !straight {
            return Err(LawFault::Table(
                "S must rise from r = 0 on, and its slope must not rise away from there",
            ));
        }
        if !straight {
            if last.is_some() {
                bends.push([before[0], fall]);
            }
            slopes.push(slope);
        }
        before = *point;
    }
    let ends = slopes.first().zip(slopes.last());
    Ok(ends.map(|(first, last)| Side {
        bends,
        first: *first,
        last: *last,
    }))
}

/// The parts that yield at the bends of both sides: the first fall of the slope on each side is of the same part as far as both go,
/// and so on. Where a side falls no more, parts do not yield there.
fn parts(down: &Side, up: &Side) -> Result<Parts, LawFault> {
    let mut law = Parts {
        stiffness: down.last.min(up.last),
        parts: [0.0; MOST],
        bends: [[f64::NEG_INFINITY; MOST], [f64::INFINITY; MOST]],
    };
    let mut sides = [down, up].map(|side| side.bends.iter().copied().peekable());
    let mut used = 0;
    let mut rest = [0.0; 2];
    let mut at = [f64::INFINITY; 2];
    loop {
        for (which, side) in sides.iter_mut().enumerate() {
            if rest[which] == 0.0 {
                [at[which], rest[which]] = side.next().unwrap_or([f64::INFINITY; 2]);
            }
        }
        let k = rest[0].min(rest[1]);
        if k == f64::INFINITY {
            return Ok(law);
        }
        if used == MOST {
            return Err(LawFault::Table(
                "it has more than 6 bends, both sides together where they differ",
            ));
        }
        law.parts[used] = k;
        [law.bends[0][used], law.bends[1][used]] = [-at[0], at[1]];
        used += 1;
        // Falls of both sides that are the same leave no round-off.
        let same = (rest[0] - rest[1]).abs() <= SAME * up.first;
        for rest in &mut rest {
            *rest = if same { 0.0 } else { *rest - k };
        }
    }
}
