//! Roots of contacts in series.

/// Two neighbours with a root between them, and the values there.
pub(crate) struct Bracket {
    pub(crate) x: [f64; 2],
    pub(crate) f: [f64; 2],
}

/// Narrows a bracket until its ends are neighbours. Values of 0 are right of the root, or left of it.
pub(crate) fn search(
    mut bracket: Bracket,
    value: impl Fn(f64) -> f64,
    least: f64,
    zero_is_left: bool,
) -> Bracket {
    let mut last_side = 2;
    // Values for the next line, of which the one that stays is halved.
    let mut line = bracket.f;
    for turn in 0..TRIES {
        let Bracket {
            x: [l, r],
            f: [left, right],
        } = bracket;
        let width = r - l;
        if width <= (NEAR * l.abs().max(r.abs())).max(least) {
            break;
        }
        let middle = l + 0.5 * width;
        let of_line = r - line[1] * (width / (line[1] - line[0]));
        let flat = left == 0.0 || right == 0.0;
        let next = match turn % 4 == 3 || flat || !of_line.is_finite() {
            true => middle,
            // Not too near to an end: the other one would not move.
            false => of_line.clamp(
                l + 0.25 * NEAR * l.abs().max(least),
                r - 0.25 * NEAR * r.abs().max(least),
            ),
        };
        let x = if next > l && next < r { next } else { middle };
        if x <= l || x >= r {
            break;
        }
        let f = value(x);
        let side = match f > 0.0 || (f == 0.0 && !zero_is_left) {
            true => 1,
            false => 0,
        };
        (bracket.x[side], bracket.f[side]) = (x, f);
        line[side] = f;
        if side == last_side {
            line[1 - side] *= 0.5;
        } else {
            line = bracket.f;
        }
        last_side = side;
    }
    bracket
}

/// Numbers in these intervals with this sum: all the same, as far as their intervals allow.
pub(crate) fn filled(intervals: &[[f64; 2]], sum: f64) -> Vec<f64> {
    let at = |level: f64| {
        intervals
            .iter()
            .map(move |[low, high]| level.min(*high).max(*low))
    };
    let mut ends: Vec<f64> = intervals
        .iter()
        .flatten()
        .copied()
        .filter(|end| end.is_finite())
        .collect();
    ends.sort_by(f64::total_cmp);
    // The ends around the level.
    let above = ends.partition_point(|end| at(*end).sum::<f64>() < sum);
    let below = above.checked_sub(1).map_or(f64::NEG_INFINITY, |i| ends[i]);
    let above = ends.get(above).copied().unwrap_or(f64::INFINITY);
    let is_free = |[low, high]: &[f64; 2]| *low <= below && *high >= above;
    let count = intervals
        .iter()
        .filter(|interval| is_free(interval))
        .count();
    if count == 0 {
        return at(if above.is_finite() { above } else { below }).collect();
    }
    let fixed: f64 = intervals
        .iter()
        .filter(|interval| !is_free(interval))
        .map(|[low, high]| if *high <= below { *high } else { *low })
        .sum();
    let level = (sum - fixed) / count as f64;
    at(level).collect()
}

/// Relative distance of two neighbours at which a search ends: the unit round-off twice.
pub(crate) const NEAR: f64 = 2.0 * f64::EPSILON;

/// Most evaluations of a search; bisection alone needs about 100.
pub(crate) const TRIES: usize = 400;
