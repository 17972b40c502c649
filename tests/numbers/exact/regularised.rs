//! The motions with softened laws in continuous time, compared with an adaptive integration, the balance of energy and limits.

use proptest::prelude::*;
use slipgap::exact::State;
use slipgap::exact::coulomb::Coulomb;
use slipgap::exact::regularised::Regularised;
use std::f64::consts::PI;

/// Law, width, x0, S(0): the cases of the papers and extreme ones.
#[derive(Debug, Clone, Copy)]
enum Release {
    Displacement { alpha: f64, x0: f64, force: f64 },
    Velocity { beta: f64, x0: f64 },
}

use Release::{Displacement, Velocity};

impl Release {
    fn motion(self) -> Regularised {
        match self {
            Displacement { alpha, x0, force } => Regularised::displacement(x0, alpha, force),
            Velocity { beta, x0 } => Regularised::velocity(x0, beta),
        }
    }

    fn x0(self) -> f64 {
        match self {
            Displacement { x0, .. } | Velocity { x0, .. } => x0,
        }
    }

    /// Energy of mass, spring and, for displacement-control, the friction spring.
    fn energy(self, state: &State) -> f64 {
        let (x, v, s) = (state.displacement, state.velocity, state.force);
        let elastic = match self {
            Displacement { alpha, .. } => alpha * s * s,
            Velocity { .. } => 0.0,
        };
        0.5 * (x * x + v * v + elastic)
    }
}

fn releases() -> Vec<Release> {
    let mut releases = Vec::new();
    for x0 in [12.0, 12.5, -11.2, 3.0, 0.6, 100.7] {
        for width in [
            1e-6, 0.01, 0.1, 0.499, 0.5, 0.500001, 1.0, 5.0, 40.0, 1000.0,
        ] {
            for force in [0.0, f64::signum(x0), -f64::signum(x0)] {
                releases.push(Displacement {
                    alpha: width,
                    x0,
                    force,
                });
            }
            releases.push(Velocity { beta: width, x0 });
        }
    }
    releases
}

/// Samples without those with an event within `margin`.
fn away_from_events(release: Release, margin: f64) -> Vec<f64> {
    let mut motion = release.motion();
    let samples = (1..900).map(|i| f64::from(i) * 0.0331);
    samples
        .filter(|t| {
            motion.at(t - margin);
            motion.next_event() > t + margin
        })
        .collect()
}

#[test]
fn satisfies_its_equation_between_events() {
    for release in releases() {
        // The difference of V has an error of omega^2: the step is much smaller than the period.
        let fastest = match release {
            Displacement { alpha, .. } => (1.0 + 1.0 / alpha).sqrt(),
            Velocity { beta, .. } => 1.0 / beta,
        };
        let d = 1e-4 / fastest.max(1.0);
        let (mut before, mut now, mut after) =
            (release.motion(), release.motion(), release.motion());
        let times = away_from_events(release, 2.0 * d);
        assert!(times.len() > 500, "{release:?}");
        for t in times {
            let (b, n, a) = (before.at(t - d), now.at(t), after.at(t + d));
            let scale = release.x0().abs().max(1.0);
            let slope = (a.displacement - b.displacement) / (2.0 * d);
            // d^2/6 times the third derivative, which is within fastest^2 of V; and round-off of X and of t over d.
            let tolerance = (1e-8 + 1e-14 / d) * scale;
            assert!((slope - n.velocity).abs() < tolerance, "{release:?} {t}");
            let acceleration = (a.velocity - b.velocity) / (2.0 * d);
            let rest = acceleration + n.displacement + n.force;
            assert!(
                rest.abs() < tolerance * fastest.max(1.0),
                "{release:?} {t}: {rest:e}"
            );
            assert!(n.force.abs() <= 1.0 + 1e-12);
            let law = match release {
                Displacement { alpha, .. } if n.force.abs() < 1.0 - 1e-9 => {
                    (a.force - b.force) / (2.0 * d) * alpha - n.velocity
                }
                Displacement { .. } => 0.0,
                Velocity { beta, .. } => n.force - (n.velocity / beta).clamp(-1.0, 1.0),
            };
            assert!(law.abs() < tolerance, "{release:?} {t}: law {law:e}");
        }
    }
}

#[test]
fn the_state_is_continuous_at_events() {
    for release in releases() {
        let (mut motion, mut count) = (release.motion(), 0);
        let scale = release.x0().abs().max(1.0);
        while motion.next_event() < 300.0 {
            let event = motion.next_event();
            let before = motion.at(event);
            let after = motion.at(event * (1.0 + 4.0 * f64::EPSILON) + 1e-300);
            let tiny = 1e-12 * scale;
            assert!(
                (before.displacement - after.displacement).abs() < tiny,
                "{release:?} {event}"
            );
            assert!(
                (before.velocity - after.velocity).abs() < tiny,
                "{release:?} {event}"
            );
            let width = match release {
                Displacement { alpha, .. } => alpha.sqrt(),
                Velocity { beta, .. } => beta,
            };
            let jump = (before.force - after.force).abs();
            assert!(
                jump < tiny + 1e-12 * scale / width,
                "{release:?} {event}: {jump:e}"
            );
            count += 1;
        }
        // At most two events in a half-cycle and one at the start. With alpha > 1 there is a little sliding at every turn, at the
        // frequency of sticking.
        let fastest = match release {
            Displacement { alpha, .. } => (1.0 + 1.0 / alpha.max(1.0)).sqrt(),
            Velocity { .. } => 1.0,
        };
        assert!(
            f64::from(count) < 600.0 / PI * fastest + 3.0,
            "{release:?}: {count} events"
        );
    }
}

#[test]
fn a_release_leaves_the_viscous_zone_if_its_highest_velocity_does() {
    // X'' + X'/beta + X = 0 from rest at x0, beta < 1/2: with the rates a < b of its two exponentials, a b = 1, the highest
    // velocity is x0 (exp(-a t) - exp(-b t))/(b - a) at t = log(b/a)/(b - a).
    for beta in [0.05, 0.2, 0.4, 0.49] {
        let root = f64::sqrt(1.0 / (beta * beta) - 4.0);
        let (a, b) = (0.5 * (1.0 / beta - root), 0.5 * (1.0 / beta + root));
        let crest = libm::log(b / a) / (b - a);
        let highest = (libm::exp(-a * crest) - libm::exp(-b * crest)) / (b - a);
        for (over, leaves) in [(1.0 + 1e-6, true), (1.0 - 1e-6, false)] {
            let first = Regularised::velocity(over * beta / highest, beta).next_event();
            assert_eq!(first.is_finite(), leaves, "beta = {beta}, {over}: {first}");
            // Near the crest v falls short of its height by (t - crest)^2/2 times the curvature: a few thousandths away.
            assert!(
                !leaves || (first - crest).abs() < 0.01,
                "beta = {beta}: {first}, {crest}"
            );
        }
    }
}

#[test]
fn energy_is_lost_to_friction() {
    // Simpson's rule for the power S V between events, where it is smooth; alpha S'S is kept in the energy.
    for release in releases() {
        let stiff = match release {
            Displacement { alpha, .. } => alpha < 0.05,
            Velocity { beta, .. } => beta < 0.05,
        };
        if stiff {
            continue;
        }
        let mut motion = release.motion();
        let (mut from, mut lost) = (0.0, 0.0);
        let start = release.energy(&motion.at(0.0));
        let end = 40.0;
        let last = loop {
            let to = motion.next_event().min(end);
            // In sticking the force of displacement-control is elastic and dissipates nothing.
            let middle = motion.at(0.5 * (from + to)).force.abs();
            let elastic = matches!(release, Displacement { .. }) && middle < 1.0;
            let panels = 4000;
            let h = (to - from) / f64::from(2 * panels);
            for i in 0..=2 * panels {
                let state = motion.at(from + f64::from(i) * h);
                let weight = match i {
                    0 => 1.0,
                    i if i == 2 * panels => 1.0,
                    i if i % 2 == 1 => 4.0,
                    _ => 2.0,
                };
                if !elastic {
                    lost += weight * state.force * state.velocity * h / 3.0;
                }
            }
            if to >= end {
                break motion.at(end);
            }
            motion.at(to * (1.0 + 4.0 * f64::EPSILON) + 1e-300);
            from = to;
        };
        let balance = release.energy(&last) + lost - start;
        let scale = release.x0().powi(2).max(1.0);
        assert!(balance.abs() < 1e-8 * scale, "{release:?}: {balance:e}");
    }
}

/// The model as a right-hand side for X, V, S, without events.
fn rate(release: Release, [x, v, s]: [f64; 3]) -> [f64; 3] {
    match release {
        // The force is constant if it is at its limit and the motion would increase it.
        Displacement { .. } if s.abs() >= 1.0 && s * v > 0.0 => [v, -x - s, 0.0],
        Displacement { alpha, .. } => [v, -x - s, v / alpha],
        Velocity { beta, .. } => [v, -x - (v / beta).clamp(-1.0, 1.0), 0.0],
    }
}

/// One step of the classical Runge-Kutta method.
fn runge_kutta(release: Release, y: [f64; 3], h: f64) -> [f64; 3] {
    let ahead = |k: [f64; 3], h: f64| [y[0] + h * k[0], y[1] + h * k[1], y[2] + h * k[2]];
    let a = rate(release, y);
    let b = rate(release, ahead(a, 0.5 * h));
    let c = rate(release, ahead(b, 0.5 * h));
    let d = rate(release, ahead(c, h));
    let sum: Vec<f64> = (0..3)
        .map(|i| a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i])
        .collect();
    ahead([sum[0], sum[1], sum[2]], h / 6.0)
}

/// X, V, S at the multiples of `apart`, by step doubling with the tolerance of 1e-13 a step.
fn integrated(release: Release, apart: f64, rows: usize) -> Vec<[f64; 3]> {
    let s = match release {
        Displacement { force, .. } => force,
        Velocity { .. } => 0.0,
    };
    let (mut y, mut h, mut states) = ([release.x0(), 0.0, s], 1e-3_f64, vec![]);
    for row in 0..rows {
        let (mut t, end) = (row as f64 * apart, (row + 1) as f64 * apart);
        while t < end {
            let step = h.min(end - t);
            let middle = runge_kutta(release, y, 0.5 * step);
            let fine = runge_kutta(release, middle, 0.5 * step);
            let coarse = runge_kutta(release, y, step);
            let error = (0..3)
                .map(|i| (fine[i] - coarse[i]).abs())
                .fold(0.0, f64::max)
                / 15.0;
            let tolerance = 1e-13 * release.x0().abs().max(1.0);
            if error <= tolerance || step <= 1e-11 {
                y = std::array::from_fn(|i| fine[i] + (fine[i] - coarse[i]) / 15.0);
                t = if step == end - t { end } else { t + step };
            }
            let factor = 0.9 * (tolerance / error.max(1e-30)).powf(0.2);
            h = (step * factor.clamp(0.2, 4.0)).clamp(1e-11, 0.05);
        }
        states.push(y);
    }
    states
}

#[test]
fn agrees_with_an_adaptive_integration() {
    for release in releases() {
        let width = match release {
            Displacement { alpha, .. } => alpha,
            Velocity { beta, .. } => beta,
        };
        if width < 0.01 {
            continue;
        }
        let mut motion = release.motion();
        let apart = PI / 7.0;
        let mut largest: f64 = 0.0;
        for (i, [x, v, s]) in integrated(release, apart, 56).into_iter().enumerate() {
            let state = motion.at((i + 1) as f64 * apart);
            let force = match release {
                Displacement { .. } => (s - state.force).abs() * width.min(1.0),
                Velocity { .. } => 0.0,
            };
            largest = largest
                .max((x - state.displacement).abs())
                .max((v - state.velocity).abs())
                .max(force);
        }
        assert!(
            largest < 1e-9 * release.x0().abs().max(1.0),
            "{release:?}: {largest:e}"
        );
    }
}

#[test]
fn peaks_follow_from_energy() {
    // From peak P_k > alpha with S at its limit to the next: half of (P_k^2 + alpha) less the way slid, P_k + P_(k+1)
    // - 2 alpha, so P_(k+1) = sqrt((P_k - 1)^2 + 4 alpha) - 1 until a peak at or below alpha.
    for alpha in [1e-4, 0.1, 1.0, 5.0] {
        for x0 in [12.0, 12.5, 100.7, 2000.3] {
            let mut motion = Regularised::displacement(x0, alpha, 1.0);
            let (mut peak, mut side, mut peaks) = (x0, 1.0, 0);
            while peak > alpha * (1.0 + 1e-9) && peaks < 1500 {
                // Sticking, then sliding, which ends at the peak.
                motion.at(motion.next_event() * (1.0 + 4.0 * f64::EPSILON));
                let state = motion.at(motion.next_event());
                peak = ((peak - 1.0) * (peak - 1.0) + 4.0 * alpha).sqrt() - 1.0;
                side = -side;
                peaks += 1;
                motion.at(motion.next_event() * (1.0 + 4.0 * f64::EPSILON));
                assert!(
                    (state.displacement - side * peak).abs() < 1e-11 * x0,
                    "{alpha} {x0} {peaks}: {} {peak}",
                    state.displacement
                );
            }
            assert!(peaks >= 5);
        }
    }
}

#[test]
fn converges_to_coulomb() {
    // Displacement-control with the root of its width, which is the order of the time of a turn; velocity-control with its width.
    for x0 in [12.0, 12.5, -31.7] {
        let error = |mut motion: Regularised| {
            let exact = Coulomb::new(x0);
            (0..=2000)
                .map(|i| f64::from(i) * 0.01)
                .map(|t| (motion.at(t).displacement - exact.at(t).displacement).abs())
                .fold(0.0, f64::max)
        };
        for width in [1e-2, 1e-4, 1e-6, 1e-9] {
            let displacement = error(Regularised::displacement(x0, width, 0.0)) / width.sqrt();
            assert!(
                (2.4..2.6).contains(&displacement),
                "{x0} {width}: {displacement}"
            );
            let velocity = error(Regularised::velocity(x0, width)) / width;
            assert!((0.01..0.6).contains(&velocity), "{x0} {width}: {velocity}");
        }
    }
}

#[test]
fn turns_come_early_by_the_root_of_alpha() {
    // From a peak P the next comes after pi less 8/3 sqrt(alpha) P^(-3/2) for alpha << 1 << P.
    for (alpha, peak) in [(1e-6, 100.0_f64), (1e-4, 400.0), (1e-8, 1000.0)] {
        let mut motion = Regularised::displacement(peak, alpha, 1.0);
        motion.at(motion.next_event() * (1.0 + 4.0 * f64::EPSILON));
        let early = (PI - motion.next_event()) / alpha.sqrt() * peak * peak.sqrt();
        assert!(
            (early * 3.0 / 8.0 - 1.0).abs() < 3.0 / peak,
            "{alpha} {peak}: {early}"
        );
    }
}

#[test]
fn velocity_control_hardly_moves_a_turn() {
    // The delay before a turn and the gain after it, each by separation of variables in the zone, nearly cancel: from
    // P to P - 2 takes pi + 2/3 beta/(P - 1)^3.
    let (peak, beta) = (20.0, 1e-4);
    let mut motion = Regularised::velocity(peak, beta);
    // Out of the zone at the release, in again, out at the turn.
    motion.at(motion.next_event() * (1.0 + 4.0 * f64::EPSILON));
    let (mut before, mut after) = (motion.next_event(), motion.next_event() + beta);
    motion.at(before * (1.0 + 4.0 * f64::EPSILON));
    // Within one piece times may be in any order.
    after = after.min(motion.next_event());
    for _ in 0..60 {
        let middle = 0.5 * (before + after);
        if motion.clone().at(middle).velocity < 0.0 {
            before = middle;
        } else {
            after = middle;
        }
    }
    let late = (after - PI) * f64::powi(peak - 1.0, 3) / beta;
    assert!((late * 1.5 - 1.0).abs() < 0.02, "{late}");
}

#[test]
fn release_at_the_limit_stays_or_goes_once() {
    // From rest without force the spring turns at S = -2 x0/(1 + alpha): x0 = (1 + alpha)/2 only reaches the limit.
    for alpha in [1e-6, 0.1, 1.0, 7.0] {
        let edge = 0.5 * (1.0 + alpha);
        for (x0, slides) in [(edge, false), (edge * (1.0 + 1e-14), true), (-edge, false)] {
            let mut motion = Regularised::displacement(x0, alpha, 0.0);
            assert_eq!(motion.next_event().is_finite(), slides, "{alpha} {x0}");
            let mut events = 0;
            while motion.next_event() < 1000.0 && events < 10 {
                motion.at(motion.next_event() * (1.0 + 1e-15));
                events += 1;
            }
            assert!(events <= 4, "{alpha} {x0}: {events} events");
            assert!(motion.at(1000.0).displacement.abs() <= x0.abs() * (1.0 + 1e-12));
        }
    }
    // In equilibrium of spring and friction it stays at rest.
    let mut rest = Regularised::displacement(0.7, 0.1, -0.7);
    assert_eq!(rest.at(50.0).displacement, 0.7);
    let mut edge = Regularised::displacement(1.0, 0.1, -1.0);
    assert_eq!(
        (edge.at(50.0).displacement, edge.at(50.0).velocity),
        (1.0, 0.0)
    );
}

#[test]
fn narrow_laws_are_coulomb_friction_and_wide_ones_no_friction() {
    // x0 = 12.5 rests at 0.5. The force of a narrow law turns within sqrt(alpha) or beta, which moves X by about as much;
    // a wide one is too weak for any. Round-off of X over 8 periods.
    for k in [2, 8, 30, 60, 100] {
        let small = f64::powi(10.0, -k);
        let worst = |mut motion: Regularised, other: &dyn Fn(f64) -> f64| {
            let times = (0..=400).map(|i| f64::from(i) * 0.0628);
            times.fold(0.0, |worst: f64, t| {
                let off = (motion.at(t).displacement - other(t)).abs();
                // NaN would pass as no error.
                assert!(off.is_finite(), "{k} {t}");
                worst.max(off)
            })
        };
        let coulomb = Coulomb::new(12.5);
        let rubs = |t: f64| coulomb.at(t).displacement;
        let flies = |t: f64| 12.5 * t.cos();
        for (motion, other, limit) in [
            (
                Regularised::displacement(12.5, small, 0.0),
                &rubs as &dyn Fn(f64) -> f64,
                4.0 * small.sqrt(),
            ),
            (Regularised::velocity(12.5, small), &rubs, 4.0 * small),
            (
                Regularised::displacement(12.5, 1.0 / small, 0.0),
                &flies,
                200.0 * small,
            ),
            (
                Regularised::velocity(12.5, 1.0 / small),
                &flies,
                200.0 * small,
            ),
        ] {
            let off = worst(motion, other);
            assert!(off < limit + 1e-13, "{k}: {off:e}");
        }
    }
}

#[test]
fn the_range_is_as_documented() {
    use slipgap::exact::regularised::holds;
    for (x0, width, force, end, wanted) in [
        (12.0, 1e-100, 0.0, 1e7, true),
        (12.0, 1e-101, 0.0, 10.0, false),
        (12.0, 1e100, 0.0, 10.0, true),
        (12.0, 1e101, 0.0, 10.0, false),
        (12.0, 0.1, 0.0, 1.0001e7, false),
        (-1e100, 0.1, 1.0, 10.0, true),
        (-1e101, 0.1, 1.0, 10.0, false),
        (1e-200, 0.1, 0.0, 10.0, true),
        (1e-6, 0.1, -1.0, 10.0, true),
        (-0.9e-6, 0.1, 1.0, 10.0, false),
    ] {
        assert_eq!(
            holds(x0, width, force, end),
            wanted,
            "{x0} {width} {force} {end}"
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn loses_energy_from_event_to_event(
        x0 in 0.01..1000.0f64, exponent in -8.0..4.0f64, force in -1.0..=1.0f64, velocity: bool,
    ) {
        let width = 10f64.powf(exponent);
        let release = if velocity {
            Velocity { beta: width, x0 }
        } else {
            Displacement { alpha: width, x0, force }
        };
        let mut motion = release.motion();
        let mut before = release.energy(&motion.at(0.0));
        let bound = before * (1.0 + 1e-12);
        for i in 1..2000 {
            let energy = release.energy(&motion.at(f64::from(i) * 0.05));
            prop_assert!(energy <= before + 1e-12 * bound, "{energy} > {before}");
            before = energy;
        }
    }
}
