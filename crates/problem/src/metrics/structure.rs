//! Metrics of structures: reductions of a quantity over the steps to a number.

/// Largest absolute value.
pub fn peak(c: &[f64]) -> f64 {
    c.iter().fold(0.0, |peak: f64, x| peak.max(x.abs()))
}

/// Step of the first largest absolute value; `None` without steps.
pub fn step_of_peak(c: &[f64]) -> Option<usize> {
    let peak = peak(c);
    c.iter().position(|x| x.abs() == peak)
}

/// Smallest and largest value.
pub fn extent(c: &[f64]) -> [f64; 2] {
    let values = c.iter();
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| {
        [a.min(*x), b.max(*x)]
    })
}

/// sqrt(mean c^2).
pub fn rms(c: &[f64]) -> f64 {
    // Divided by the peak, so that squares neither overflow nor vanish.
    let peak = peak(c);
    if peak == 0.0 || c.is_empty() {
        return 0.0;
    }
    let sum: f64 = c.iter().map(|x| (x / peak) * (x / peak)).sum();
    peak * (sum / c.len() as f64).sqrt()
}

/// sqrt(mean (c - e)^2).
pub fn rms_error(c: &[f64], e: &[f64]) -> f64 {
    let differences: Vec<f64> = c.iter().zip(e).map(|(c, e)| c - e).collect();
    rms(&differences)
}

/// Number of times that the contact closes: S != 0 after S = 0. A contact that is closed at t = 0 counts, too, as the one before
/// it that the record does not have.
pub fn closings(force: &[f64]) -> usize {
    let closes = |pair: &&[f64]| pair[0] == 0.0 && pair[1] != 0.0;
    let starts_closed = force.first().is_some_and(|s| *s != 0.0);
    force.windows(2).filter(closes).count() + usize::from(starts_closed)
}

/// -rdot after the first impact over rdot before it, each at the step next to it with S = 0; `None` without a whole impact.
pub fn restitution(force: &[f64], velocity: &[f64]) -> Option<f64> {
    let closed = force.iter().position(|s| *s != 0.0)?;
    let before = *velocity.get(closed.checked_sub(1)?)?;
    let open = force[closed..].iter().position(|s| *s == 0.0)?;
    let after = *velocity.get(closed + open)?;
    (before < 0.0).then(|| -after / before)
}

/// Integral of abs(S) over time by trapezoids, steps of `dt` apart.
pub fn impulse(force: &[f64], dt: f64) -> f64 {
    let pairs = force.windows(2);
    0.5 * dt * pairs.map(|s| s[0].abs() + s[1].abs()).sum::<f64>()
}

/// Time of the steps that end with a value that `counts`, steps of `dt` apart.
pub fn time_where(values: &[f64], dt: f64, counts: impl Fn(f64) -> bool) -> f64 {
    let ends = values.iter().skip(1);
    dt * ends.filter(|x| counts(**x)).count() as f64
}

/// Integral of S dr by trapezoids.
pub fn work(force: &[f64], displacement: &[f64]) -> f64 {
    let steps = force.windows(2).zip(displacement.windows(2));
    steps
        .map(|(s, r)| 0.5 * (s[0] + s[1]) * (r[1] - r[0]))
        .sum()
}

/// Work of the impulses S(i+1) dt of a method, on the mean velocities of the steps.
pub fn work_of_impulses(force: &[f64], velocity: &[f64], dt: f64) -> f64 {
    let steps = force.iter().skip(1).zip(velocity.windows(2));
    steps.map(|(s, v)| s * dt * 0.5 * (v[0] + v[1])).sum()
}

/// First step at which two motions differ by more than `threshold` times the peak of the first; `None` if there is none.
pub fn divergence(c: &[f64], other: &[f64], threshold: f64) -> Option<usize> {
    let most = threshold * peak(c);
    let mut pairs = c.iter().zip(other);
    pairs.position(|(c, other)| (c - other).abs() > most)
}

/// Largest difference of two motions over the peak of the first; `None` if the first is always 0.
pub fn difference(c: &[f64], other: &[f64]) -> Option<f64> {
    let peak = peak(c);
    let differences = c.iter().zip(other).map(|(c, other)| (c - other).abs());
    (peak > 0.0).then(|| differences.fold(0.0, f64::max) / peak)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn reductions_of_a_sine_and_of_its_half_waves() {
        let n = 100_000;
        let dt = 2.0 * PI / n as f64;
        let sine: Vec<f64> = (0..=n).map(|i| 3.0 * (i as f64 * dt).sin()).collect();
        // The sums are those of trapezoids, which err by dt^2/12 at most.
        assert!((peak(&sine) - 3.0).abs() < 1e-15);
        assert_eq!(step_of_peak(&sine), Some(n / 4));
        assert!((rms(&sine) - (4.5 * n as f64 / (n + 1) as f64).sqrt()).abs() < 1e-12);
        let pushes: Vec<f64> = sine.iter().map(|x| x.min(0.0)).collect();
        assert!((impulse(&pushes, dt) - 6.0).abs() < 1e-8);
        assert_eq!(closings(&pushes), 1);
        assert!((time_where(&pushes, dt, |s| s != 0.0) - PI).abs() < 2.0 * dt);
        // S = -3 sin t on r = cos t: the work over a cycle is 3 pi.
        let r: Vec<f64> = (0..=n).map(|i| (i as f64 * dt).cos()).collect();
        let s: Vec<f64> = sine.iter().map(|x| -x).collect();
        assert!((work(&s, &r) - 3.0 * PI).abs() < 1e-7);
        assert_eq!(extent(&[2.0, -1.0, 0.5]), [-1.0, 2.0]);
    }

    #[test]
    fn the_restitution_is_of_the_first_whole_impact() {
        let v = [-2.0, -2.0, 0.5, 1.0, -1.0, 3.0];
        assert_eq!(restitution(&[0.0, 0.0, -9.0, 0.0, 0.0, 0.0], &v), Some(0.5));
        assert_eq!(
            restitution(&[0.0, 0.0, -9.0, 0.0, -1.0, 0.0], &v),
            Some(0.5)
        );
        // None, one that starts closed, one that ends closed, one of bodies that do not close.
        assert_eq!(restitution(&[0.0; 6], &v), None);
        assert_eq!(restitution(&[-1.0, 0.0, -1.0, 0.0, 0.0, 0.0], &v), None);
        assert_eq!(restitution(&[0.0, 0.0, -9.0, -9.0, -9.0, -9.0], &v), None);
        assert_eq!(restitution(&[0.0, 0.0, 0.0, 0.0, -1.0, 0.0], &v), None);
    }

    #[test]
    fn the_work_of_an_impulse_is_the_change_of_the_kinetic_energy() {
        // A mass of 2 with r = u bounces from -3 to 1.5, then is pulled to -0.5: S dt = -2 (v' - v), work -(v'^2 - v^2).
        let (dt, v) = (0.25, [-3.0, 1.5, -0.5]);
        let force = [0.0, -2.0 * 4.5 / dt, 2.0 * 2.0 / dt];
        assert_eq!(work_of_impulses(&force, &v, dt), 9.0 - 0.25);
        assert_eq!(work_of_impulses(&force[..2], &v[..2], dt), 9.0 - 2.25);
    }

    #[test]
    fn divergence_is_the_first_difference_above_the_threshold() {
        let (c, other) = ([0.0, 2.0, 1.0, 0.0], [0.0, 2.01, 1.03, 0.0]);
        assert_eq!(divergence(&c, &other, 0.01), Some(2));
        assert_eq!(divergence(&c, &other, 0.02), None);
        // The largest difference is 1.03 - 1, exact but for the round-off of 1.03.
        assert_eq!(difference(&c, &other), Some((1.03f64 - 1.0) / 2.0));
        assert_eq!(difference(&[0.0; 3], &[0.0; 3]), None);
    }
}
