//! Two equal continuous bars on the impact spring, compared with their delay equation, limits and balance of momentum.

use slipgap::exact::spring::Spring;
use slipgap::exact::wave::Bars;

const STIFFNESSES: [f64; 5] = [0.41, 0.6, 2.5, 10.0, 100.0];

/// F on a grid of T_I/`count` by the classical Runge-Kutta method, from F' = 4 gamma n (1 - F - 2 F(t-1) - ...): the
/// delays are whole numbers of steps, and the middle of a delayed step is on a cubic through both ends.
fn integrated(gamma_n: f64, count: usize, end: usize) -> Vec<f64> {
    let (h, rate) = (1.0 / count as f64, 4.0 * gamma_n);
    let mut force = vec![0.0];
    let mut slope: Vec<f64> = Vec::new();
    let mut parted = false;
    for i in 0..end * count {
        let late = |at: f64| -> f64 {
            let mut sum = 0.0;
            let mut j = i as f64 + at - count as f64;
            while j >= 0.0 {
                let (k, s) = (j.floor() as usize, j.fract());
                let (a, b) = (force[k], force[k + 1]);
                let (da, db) = (slope[k] * h, slope[k + 1] * h);
                let hermite = a + s
                    * (da + s * (3.0 * (b - a) - 2.0 * da - db + s * (2.0 * (a - b) + da + db)));
                sum += if s == 0.0 { a } else { hermite };
                j -= count as f64;
            }
            sum
        };
        let f = |at: f64, y: f64| rate * (1.0 - y - 2.0 * late(at));
        let y = force[i];
        let k1 = f(0.0, y);
        let k2 = f(0.5, y + 0.5 * h * k1);
        let k3 = f(0.5, y + 0.5 * h * k2);
        let k4 = f(1.0, y + h * k3);
        let next = y + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
        slope.push(if parted { 0.0 } else { k1 });
        parted |= next <= 0.0;
        force.push(if parted { 0.0 } else { next });
    }
    force
}

#[test]
fn satisfies_the_delay_equation() {
    for gamma_n in [0.41, 1.0, 2.5] {
        let (spring, count) = (Spring::new(gamma_n, 0.0).unwrap(), 4000);
        for (i, force) in integrated(gamma_n, count, 2).into_iter().enumerate() {
            let t = i as f64 / count as f64;
            // The step in which the ends separate is not resolved; its error is up to the force of one step.
            let separation = (t - spring.contact_duration()).abs() < 2.0 / count as f64;
            let tolerance = if separation { 1e-2 } else { 1e-10 };
            let exact = spring.at(t).force;
            assert!(
                (exact - force).abs() < tolerance,
                "{gamma_n} at {t}: {exact}, not {force}"
            );
        }
    }
}

#[test]
fn displacement_is_the_integral_of_velocity_and_the_spring_of_displacement() {
    let h = 1e-5;
    for gamma_n in STIFFNESSES {
        for gap in [0.0, 0.3] {
            let spring = Spring::new(gamma_n, gap).unwrap();
            // At the first touch, at separation and after every further T_I the slope of rdot jumps.
            let kinks = [0.5 * gap, 0.5 * gap + spring.contact_duration()];
            let smooth = |t: f64| {
                let distant = |kink: &f64| (t - kink - (t - kink).round()).abs() > 2.0 * h;
                kinks.iter().all(distant)
            };
            for t in (0..5000)
                .map(|i| 0.001 * f64::from(i) + 0.0005)
                .filter(|t| smooth(*t))
            {
                let state = spring.at(t);
                let r = |t: f64| spring.at(t).displacement;
                let slope = (r(t + h) - r(t - h)) / (2.0 * h);
                // The error of the difference is a sixth of h^2 times the third derivative of r, which is below 24 (4 gamma n)^2,
                // and round-off over h.
                let tolerance = 4.0 * h * h * (4.0 * gamma_n).powi(2) + 1e-10;
                assert!(
                    (slope - 2.0 * state.velocity).abs() < tolerance,
                    "{gamma_n} at {t}"
                );
                let expected = (-2.0 * gamma_n * state.displacement).max(0.0);
                // Round-off of r, about 1e-15 after contact, times the stiffness.
                assert!(
                    (state.force - expected).abs() < 1e-14 * (1.0 + gamma_n),
                    "{gamma_n} at {t}"
                );
            }
        }
    }
}

#[test]
fn contact_lasts_as_derived() {
    // T_I + 1.67835 tau for T_I >> tau, tau = T_I/(4 gamma n).
    for gamma_n in [20.0, 200.0, 2000.0] {
        let spring = Spring::new(gamma_n, 0.0).unwrap();
        let late = (spring.contact_duration() - 1.0) * 4.0 * gamma_n;
        // Five decimals of the root of (2 s + 2) exp(-s) = 1.
        assert!((late - 1.67835).abs() < 5e-6, "{late}");
    }
    // Below gamma n = 0.404 the third front arrives in contact.
    assert_eq!(Spring::new(0.4035, 0.0), None);
    let limit = Spring::new(0.4045, 0.0).unwrap().contact_duration();
    assert!((1.99..2.0).contains(&limit), "{limit}");
}

#[test]
fn stiff_springs_converge_to_dalembert() {
    let bars = Bars {
        impedance_ratio: 1.0,
        time_ratio: 1.0,
        gap: 0.2,
    };
    let wave = bars.solve(3.0);
    for gamma_n in [1e3, 1e5] {
        let spring = Spring::new(gamma_n, 0.2).unwrap();
        for i in 0..200 {
            let t = 0.005 + 0.01 * f64::from(i);
            let (soft, hard) = (spring.at(t), wave.at(t));
            // After contact r = 2 (I - t + 2 (t - 1 - tau)) with the impulse I = 1 - 0.05 tau: the delay is 4.1 tau.
            assert!(
                (soft.displacement - hard.displacement).abs() < 1.03 / gamma_n,
                "{t}"
            );
            // Each change of rdot lasts for a few tau, much less than 0.005 T_I.
            assert!((soft.velocity - hard.velocity).abs() < 1e-6, "{t}");
        }
    }
}

#[test]
fn separates_once_and_conserves_momentum() {
    for gamma_n in STIFFNESSES {
        let spring = Spring::new(gamma_n, 0.0).unwrap();
        let mut impulse = 0.0;
        let h = 1e-4;
        for i in 0..40_000 {
            let t = h * f64::from(i);
            impulse += 0.5 * h * (spring.at(t).force + spring.at(t + h).force);
            if t > spring.contact_duration() {
                assert!(spring.at(t).velocity > 0.4, "{gamma_n} at {t}");
            }
        }
        // Over a T_I the ends move as the mass centres do: 2 (-1 + 2 I), I the impulse over F0 T_I.
        let apart = spring.at(4.0).displacement - spring.at(3.0).displacement;
        let tolerance = 1e-8 * (1.0 + 16.0 * gamma_n * gamma_n);
        assert!(
            (apart - 2.0 * (2.0 * impulse - 1.0)).abs() < tolerance,
            "{gamma_n}: {apart}"
        );
    }
}
