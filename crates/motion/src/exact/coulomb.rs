//! Free vibration with Coulomb friction, exactly [F (19), (20)].
//!
//! With a0 = |x0|, half-cycle k runs over k pi <= T <= (k + 1) pi about the shifted centre s_k,
//! `X = s_k (1 + (a_k - 1) cos(T - k pi))`, a_k = a0 - 2 k, s_k = sign(x0) (-1)^k. The frequency is the undamped one, and the
//! amplitude falls by 4 Delta in a cycle. The motion stops at the first peak with |a_k| <= 1, after m half-cycles, at
//! X = s_m a_m.

use super::{State, first_step};
use libm::{ceil, cos, floor, sin};
use std::f64::consts::PI;

/// The motion after release at rest from x0, in T = omega_n t and X = x/Delta.
///
/// The case of `[F]`, x0 = 12 Delta, rests at 0 from T = 6 pi on, and friction does the work 72 nu N Delta:
///
/// ```
/// use slipgap_motion::exact::coulomb::Coulomb;
/// use std::f64::consts::PI;
///
/// let exact = Coulomb::new(12.0);
/// assert_eq!(exact.rest_time(), 6.0 * PI);
/// assert_eq!(exact.at(7.0 * PI).displacement, 0.0);
/// assert_eq!(exact.work(), 72.0);
/// // The amplitude falls by 4 in a cycle.
/// assert_eq!(exact.at(2.0 * PI).displacement, 8.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coulomb {
    sign: f64,
    a0: f64,
    m: f64,
}

impl Coulomb {
    /// Release from `x0`, finite.
    pub fn new(x0: f64) -> Coulomb {
        let a0 = x0.abs();
        Coulomb {
            sign: if x0 < 0.0 { -1.0 } else { 1.0 },
            a0,
            m: ceil((a0 - 1.0) / 2.0).max(0.0),
        }
    }

    /// Number m of half-cycles until rest, a whole number.
    pub fn half_cycles(&self) -> f64 {
        self.m
    }

    /// Time m pi at which the motion stops.
    pub fn rest_time(&self) -> f64 {
        self.m * PI
    }

    /// Amplitude a_k = a0 - 2 k of peak k = 0..=m; the last may be negative.
    pub fn amplitude(&self, k: f64) -> f64 {
        self.a0 - 2.0 * k
    }

    /// Sign s_k of half-cycle k.
    pub fn side(&self, k: f64) -> f64 {
        if k % 2.0 == 0.0 {
            self.sign
        } else {
            -self.sign
        }
    }

    /// Friction work until rest, (a0^2 - a_m^2)/2 in units of nu N Delta: the length of the path.
    pub fn work(&self) -> f64 {
        let a_m = self.amplitude(self.m);
        (self.a0 - a_m) * (self.a0 + a_m) * 0.5
    }

    /// The motion at T >= 0.
    pub fn at(&self, time: f64) -> State {
        let k = floor(time / PI);
        if k >= self.m {
            let rest = self.side(self.m) * self.amplitude(self.m);
            return State {
                displacement: rest,
                velocity: 0.0,
                force: -rest,
            };
        }
        let (side, swing, phase) = (self.side(k), self.amplitude(k) - 1.0, time - k * PI);
        State {
            displacement: side * (1.0 + swing * cos(phase)),
            // From zero, so that a peak has the velocity 0 and not -0.
            velocity: 0.0 - side * swing * sin(phase),
            force: -side,
        }
    }

    /// Displacements at T = 0, `step`, 2 `step`, .. of `count` steps: those of [`Coulomb::at`] to round-off.
    ///
    /// All half-cycles are parts of one cosine, `X = s_k + s_0 (a_k - 1) cos T`. An angle-addition recurrence gives it for eight
    /// steps at a time.
    pub fn displacements(&self, step: f64, count: usize) -> Vec<f64> {
        // From half-cycle m on the motion rests.
        let half_cycle = |i: usize| floor(i as f64 * step / PI);
        let begins = |k: f64| first_step(count, k * PI / step, |i| half_cycle(i) >= k);
        let rest = begins(self.m);
        let mut x = cosines(step, rest);
        let (mut k, mut from) = (0.0, 0);
        while from < rest {
            let to = begins(k + 1.0).min(rest);
            let (centre, swing) = (self.side(k), self.sign * (self.amplitude(k) - 1.0));
            for x in &mut x[from..to] {
                *x = centre + swing * *x;
            }
            (k, from) = (k + 1.0, to);
        }
        x.resize(count, self.side(self.m) * self.amplitude(self.m));
        x
    }
}

/// Steps of one recurrence.
const LANES: usize = 8;

/// Steps after which the recurrence restarts, so that its round-off is less than that many eps times an angle.
const RESTART: usize = 16 * LANES;

/// cos(i step), i = 0..count, by the angle-addition recurrence c' = c - (a c + b s), s' = s - (a s - b c) with
/// a = 2 sin^2(d/2), b = sin d for an increment d.
fn cosines(step: f64, count: usize) -> Vec<f64> {
    let increment = |angle: f64| (2.0 * sin(0.5 * angle) * sin(0.5 * angle), sin(angle));
    let add = |(c, s): (f64, f64), (a, b): (f64, f64)| (c - (a * c + b * s), s - (a * s - b * c));
    let (one, by_lanes) = (increment(step), increment(LANES as f64 * step));
    let mut cosines = Vec::with_capacity(count + LANES);
    while cosines.len() < count {
        let (mut lanes, angle) = ([(1.0, 0.0); LANES], cosines.len() as f64 * step);
        lanes[0] = (cos(angle), sin(angle));
        for i in 1..LANES {
            lanes[i] = add(lanes[i - 1], one);
        }
        let until = (cosines.len() + RESTART).min(count);
        while cosines.len() < until {
            cosines.extend(lanes.map(|(c, _)| c));
            lanes = lanes.map(|lane| add(lane, by_lanes));
        }
    }
    cosines.truncate(count);
    cosines
}

#[cfg(test)]
mod tests {
    use super::*;

    const STARTS: [f64; 9] = [11.2, 11.5, 12.0, 12.5, -12.5, 3.0, 1.0, 0.4, 100.7];

    #[test]
    fn rests_at_the_first_peak_below_delta() {
        let rest = |x0: f64| Coulomb::new(x0).at(1e3).displacement;
        // From a_k = a0 - 2 k, by hand.
        for (x0, x) in [(11.2, -0.8), (11.5, -0.5), (12.0, 0.0), (12.5, 0.5)] {
            assert!((rest(x0) - x).abs() < 4e-15 * x0, "{x0}: {}", rest(x0));
            assert!((rest(-x0) + x).abs() < 4e-15 * x0);
        }
        assert_eq!(rest(0.4), 0.4);
        assert_eq!(Coulomb::new(1.0).half_cycles(), 0.0);
        assert_eq!(Coulomb::new(3.0).half_cycles(), 1.0);
        assert_eq!(Coulomb::new(12.0).work(), 72.0);
    }

    #[test]
    fn displacements_at_steps_are_those_of_the_motion() {
        for x0 in STARTS {
            let exact = Coulomb::new(x0);
            for step in [PI / 10.0, 0.01, 1.0, 2.0 * PI, 7.3] {
                for (i, x) in exact.displacements(step, 1003).into_iter().enumerate() {
                    let expected = exact.at(i as f64 * step).displacement;
                    // Round-off of T itself, and of the recurrence.
                    let tolerance =
                        (4.0 + i as f64 * step) * 2.0 * f64::EPSILON * x0.abs().max(1.0);
                    assert!(
                        (x - expected).abs() < tolerance,
                        "{x0} {step} {i}: {x} {expected}"
                    );
                }
            }
        }
    }

    #[test]
    fn satisfies_its_equation() {
        // X'' by central differences of X' within half-cycles: error d^2/6 X'''' + eps X/d, d = 1e-4.
        let d = 1e-4;
        for x0 in STARTS {
            let exact = Coulomb::new(x0);
            for i in 0..400 {
                let t = 0.05 + i as f64 * 0.0712;
                let phase = t % PI;
                if phase < 2.0 * d || phase > PI - 2.0 * d {
                    continue;
                }
                let (before, now, after) = (exact.at(t - d), exact.at(t), exact.at(t + d));
                let acceleration = (after.velocity - before.velocity) / (2.0 * d);
                let velocity = (after.displacement - before.displacement) / (2.0 * d);
                let scale = x0.abs().max(1.0);
                assert!((acceleration + now.displacement + now.force).abs() < 1e-8 * scale);
                assert!((velocity - now.velocity).abs() < 1e-8 * scale);
                assert!(now.force.abs() <= 1.0);
                if now.velocity != 0.0 {
                    assert_eq!(now.force, now.velocity.signum());
                }
            }
        }
    }

    #[test]
    fn displacement_and_velocity_do_not_jump() {
        for x0 in STARTS {
            let exact = Coulomb::new(x0);
            for k in 1..=(exact.half_cycles() as i32 + 2) {
                let t = f64::from(k) * PI;
                let (before, after) = (exact.at(t - 1e-9), exact.at(t + 1e-9));
                let scale = x0.abs();
                assert!((before.displacement - after.displacement).abs() < 1e-12 * scale);
                assert!((before.velocity - after.velocity).abs() < 4e-9 * scale);
            }
        }
    }

    #[test]
    fn energy_lost_is_friction_work() {
        // Between any two times: (X^2 + V^2)/2 falls by the path length, counted from peak to peak.
        for x0 in STARTS {
            let exact = Coulomb::new(x0);
            let end = exact.at(exact.rest_time() + 1.0);
            let lost = (x0 * x0 - end.displacement * end.displacement) / 2.0;
            assert!((lost - exact.work()).abs() < 1e-12 * x0 * x0);
            let m = exact.half_cycles() as i32;
            let path: f64 = (0..m)
                .map(|k| {
                    let peak = |k: i32| exact.at(f64::from(k) * PI).displacement;
                    (peak(k + 1) - peak(k)).abs()
                })
                .sum();
            assert!((path - exact.work()).abs() < 1e-11 * x0 * x0);
        }
    }
}
