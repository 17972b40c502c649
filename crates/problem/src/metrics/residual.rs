//! Means over time: of a whole part of a motion, and of the free vibration at its end.

use super::measured::{between, cycles};

/// The mean over time by trapezoids, of values at the times that `time` gives; of one value this. `None` without values.
pub fn mean(c: &[f64], time: &dyn Fn(usize) -> f64) -> Option<f64> {
    match c {
        [] => None,
        [only] => Some(*only),
        [..] => Some(mean_between(c, time, [0.0, (c.len() - 1) as f64])),
    }
}

/// What remains when the vibration at the end has gone: the mean over whole cycles in the second half of the times; of all times, if
/// the half has no whole cycle; without one, the mean of the half. `None` without values.
///
/// The cycles are those of [`cycles`]. Between them, the mean is taken from the first to the last largest value of a cycle and from the
/// first to the last smallest one, and both means count alike: of a decaying vibration with the damping ratio h and the amplitude A,
/// less than h^2 A remains, but h A between two rises.
pub fn residual(c: &[f64], time: &dyn Fn(usize) -> f64) -> Option<f64> {
    let last = c.len().checked_sub(1)?;
    let middle = 0.5 * (time(0) + time(last));
    let begin = (0..last).find(|i| time(*i) >= middle).unwrap_or(last);
    let (half, of_half) = (&c[begin..], |i: usize| time(begin + i));
    mean_of_cycles(half, &of_half)
        .or_else(|| mean_of_cycles(c, time))
        .or_else(|| mean(half, &of_half))
}

/// The mean over the whole cycles; `None` without one.
fn mean_of_cycles(c: &[f64], time: &dyn Fn(usize) -> f64) -> Option<f64> {
    let rises = cycles(c);
    let turning = |sign: f64| -> Vec<f64> {
        let pairs = rises.windows(2);
        pairs
            .map(|pair| turning_point(c, sign, pair[0], pair[1]))
            .collect()
    };
    let ends =
        [turning(1.0), turning(-1.0)].map(|places| Some([*places.first()?, *places.last()?]));
    let of = |[from, to]: [f64; 2]| (to > from).then(|| mean_between(c, time, [from, to]));
    match ends {
        [Some(largest), Some(smallest)] if rises.len() > 2 => {
            Some(0.5 * (of(largest)? + of(smallest)?))
        }
        [Some(_), _] => of([rises[0], rises[1]]),
        [None, _] => None,
    }
}

/// The place of the largest `sign` c between two places, by a parabola through it and its neighbours.
fn turning_point(c: &[f64], sign: f64, from: f64, to: f64) -> f64 {
    let inner = (from.floor() as usize + 1)..(to.ceil() as usize);
    let extreme = inner.max_by(|a, b| (sign * c[*a]).total_cmp(&(sign * c[*b])));
    let Some(most) = extreme.filter(|place| (1..c.len() - 1).contains(place)) else {
        return from;
    };
    let [before, here, after] = [c[most - 1], c[most], c[most + 1]];
    let curvature = before - 2.0 * here + after;
    let shift = match curvature == 0.0 {
        true => 0.0,
        false => 0.5 * (before - after) / curvature,
    };
    most as f64 + shift.clamp(-1.0, 1.0)
}

/// The mean over time between two places with fractions, by trapezoids.
fn mean_between(c: &[f64], time: &dyn Fn(usize) -> f64, [from, to]: [f64; 2]) -> f64 {
    let inner = (from.floor() as usize + 1)..(to.ceil() as usize);
    let at = |place: f64| {
        let below = (place.floor() as usize).min(c.len() - 2);
        let share = place - below as f64;
        let t = time(below) + share * (time(below + 1) - time(below));
        (t, between(c, place))
    };
    let inner = inner.map(|i| (time(i), c[i]));
    let points: Vec<(f64, f64)> = [at(from)]
        .into_iter()
        .chain(inner)
        .chain([at(to)])
        .collect();
    let areas = points
        .windows(2)
        .map(|p| 0.5 * (p[0].1 + p[1].1) * (p[1].0 - p[0].0));
    areas.sum::<f64>() / (points[points.len() - 1].0 - points[0].0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// 0.3 plus exp(-h t) cos(t + phase) at so many steps of dt.
    fn decaying(h: f64, phase: f64, dt: f64, count: usize) -> Vec<f64> {
        let value = |i: usize| {
            let t = i as f64 * dt;
            0.3 + libm::exp(-h * t) * libm::cos(t + phase)
        };
        (0..count).map(value).collect()
    }

    #[test]
    fn the_mean_is_that_of_straight_lines() {
        // Over the times 0, 1, 3: areas 1.5 and 8 over 3.
        let times = [0.0, 1.0, 3.0];
        let found = mean(&[1.0, 2.0, 6.0], &|i| times[i]);
        assert_eq!(found, Some(9.5 / 3.0));
        assert_eq!(mean(&[4.0], &|_| 0.0), Some(4.0));
        assert_eq!(mean(&[], &|_| 0.0), None);
    }

    #[test]
    fn the_residual_of_a_vibration_is_its_offset() {
        for (h, phase) in [(0.0, 0.2), (0.01, 1.0), (0.05, 0.0), (0.1, 2.5)] {
            for dt in [0.2, 0.1, 0.03] {
                let count = (20.0 * PI / dt) as usize;
                let c = decaying(h, phase, dt, count);
                let found = residual(&c, &|i| i as f64 * dt).unwrap();
                // At the middle of the times; a chord is below its arc by dt^2/12 of the amplitude, which the whole cycles share.
                let amplitude = libm::exp(-h * 10.0 * PI);
                let most = (h * h + 0.02 * dt * dt) * amplitude + 1e-12;
                assert!((found - 0.3).abs() < most, "{h} {dt} {found} {most}");
            }
        }
    }

    #[test]
    fn few_cycles_and_none_have_a_residual() {
        let dt = 0.01;
        // 2.2 cycles: the half has none, the whole has one between two rises; without damping, its mean is the offset.
        let c = decaying(0.0, 0.0, dt, (2.2 * 2.0 * PI / dt) as usize);
        let found = residual(&c, &|i| i as f64 * dt).unwrap();
        assert!((found - 0.3).abs() < 1e-4, "{found}");
        // At rest in the second half.
        let c: Vec<f64> = (0..=100).map(|i| if i < 40 { 9.0 } else { 2.0 }).collect();
        assert_eq!(residual(&c, &|i| i as f64), Some(2.0));
        assert_eq!(residual(&[7.0], &|_| 0.0), Some(7.0));
        assert_eq!(residual(&[], &|_| 0.0), None);
    }
}
