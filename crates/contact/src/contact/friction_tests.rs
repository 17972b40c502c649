//! Tests of the friction laws: one step, and an oscillator that a sine drives.

use super::tests::dissipated_energy;
use super::*;
use crate::lane::Lane;
use proptest::prelude::*;

const OFF: Flexibility<1> = Flexibility {
    h: Lane([0.0]),
    h_rate: Lane([0.0]),
};

fn tanh(compliance: f64, ratio: f64, rate: f64) -> Tanh {
    Tanh {
        compliance,
        limit: 1.0,
        ratio,
        rate,
    }
}

fn bearing(compliance: f64, ratio: f64, rate: f64) -> Bearing {
    Bearing {
        compliance,
        limit: 1.0,
        ratio,
        rate,
    }
}

fn stribeck(compliance: f64, static_limit: f64, stribeck_velocity: f64) -> Stribeck {
    Stribeck {
        compliance,
        limit: 1.0,
        static_limit,
        stribeck_velocity,
        decay: Decay::Exponential,
    }
}

fn hyperbolic(compliance: f64, static_limit: f64, stribeck_velocity: f64) -> Stribeck {
    Stribeck {
        decay: Decay::Hyperbolic,
        ..stribeck(compliance, static_limit, stribeck_velocity)
    }
}

fn bouc_wen(compliance: f64, exponent: f64) -> BoucWen {
    BoucWen {
        compliance,
        limit: 1.0,
        exponent,
        beta: 0.5,
    }
}

/// Bouc-Wen's model that does not unload elastically.
fn bent(compliance: f64, exponent: f64, beta: f64) -> BoucWen {
    BoucWen {
        beta,
        ..bouc_wen(compliance, exponent)
    }
}

fn dahl(compliance: f64, exponent: f64) -> Dahl {
    Dahl {
        compliance,
        limit: 1.0,
        exponent,
    }
}

fn lugre([sigma0, sigma1, sigma2, static_limit, stribeck_velocity]: [f64; 5]) -> Lugre {
    Lugre {
        sigma0,
        sigma1,
        sigma2,
        limit: 1.0,
        static_limit,
        stribeck_velocity,
    }
}

/// X'' + X + S = P sin(W T) by the constant average acceleration method: (X, X', S) of every step.
fn driven(law: impl Law, [p, w, x0, dt]: [f64; 4], steps: u32) -> Vec<[f64; 3]> {
    let shrink = 1.0 / (1.0 + 0.25 * dt * dt);
    let end = Flexibility {
        h: Lane([0.25 * dt * dt * shrink]),
        h_rate: Lane([0.5 * dt * shrink]),
    };
    let on = StepFlexibility {
        start: OFF,
        end,
        dt: Lane([dt]),
        by_impulse: false,
    };
    let step = Law::step(&[law], &on);
    let mut memory = Default::default();
    let [mut x, mut v, mut s, mut a] = [x0, 0.0, 0.0, -x0];
    let mut states = vec![[x, v, s]];
    for k in 1..=steps {
        let load = p * libm::sin(w * dt * f64::from(k));
        let free = (load - x - dt * v - 0.25 * dt * dt * a) * shrink;
        let trial = Trial {
            displacement: Lane([x]),
            velocity: Lane([v]),
            force: Lane([s]),
            change: Lane([dt * v + 0.25 * dt * dt * (a + free)]),
            rate: Lane([v + 0.5 * dt * (a + free)]),
        };
        [s] = step.force(&trial, &mut memory).0;
        let next = free - s * shrink;
        x += dt * v + 0.25 * dt * dt * (a + next);
        v += 0.5 * dt * (a + next);
        a = next;
        states.push([x, v, s]);
    }
    states
}

/// Largest differences of X, X' at T = 10 from tests/reference/friction/laws_friction.py with 2000 and 8000 steps.
fn errors(law: impl Law, [x, v, s]: [f64; 3]) -> [f64; 2] {
    [2000, 8000].map(|steps: u32| {
        let states = driven(law, [2.0, 0.8, 0.5, 10.0 / f64::from(steps)], steps);
        let end = states[steps as usize];
        (end[0] - x)
            .abs()
            .max((end[1] - v).abs())
            .max((end[2] - s).abs())
    })
}

#[test]
fn every_law_converges_with_the_second_order() {
    // X, X', S by DOP853, accurate to 2e-10: tests/reference/friction/laws_friction.py.
    let cases = [
        (
            "tanh",
            errors(tanh(0.1, 1.0, 0.0), [1.972799123487, 2.593446518895, 1.0]),
        ),
        (
            "tanh, bearing",
            errors(
                tanh(0.1, 0.4, 2.0),
                [2.427714844096, 2.563644644611, 0.996440427811],
            ),
        ),
        (
            "bearing",
            errors(
                bearing(0.1, 0.4, 2.0),
                [2.421826706108, 2.576746944696, 0.996532493437],
            ),
        ),
        (
            "stribeck",
            errors(
                stribeck(0.1, 1.5, 0.5),
                [1.153698766181, 2.436975519270, 1.005158557880],
            ),
        ),
        (
            "stribeck, hyperbolic",
            errors(
                hyperbolic(0.1, 1.5, 0.5),
                [0.883370858975, 2.209214073909, 1.097686239908],
            ),
        ),
        (
            "bouc-wen 1",
            errors(bouc_wen(0.1, 1.0), [2.160967132434, 1.971382202191, 1.0]),
        ),
        (
            "bouc-wen 2",
            errors(bouc_wen(0.1, 2.0), [2.113419632310, 2.003200834052, 1.0]),
        ),
        (
            "bouc-wen 5",
            errors(bouc_wen(0.1, 5.0), [2.088764708281, 2.019438127403, 1.0]),
        ),
        (
            "bouc-wen 1, beta 0.9",
            errors(bent(0.1, 1.0, 0.9), [2.168835833829, 2.056548306320, 1.0]),
        ),
        (
            "bouc-wen 2, beta 1.6",
            errors(bent(0.1, 2.0, 1.6), [2.123472088690, 2.126271105433, 1.0]),
        ),
        (
            "bouc-wen 2, beta 0.2",
            errors(bent(0.1, 2.0, 0.2), [2.105487198701, 1.893378063012, 1.0]),
        ),
        (
            "bouc-wen 5, beta 0.9",
            errors(bent(0.1, 5.0, 0.9), [2.091540060656, 2.056225466908, 1.0]),
        ),
        (
            "dahl 1",
            errors(dahl(0.1, 1.0), [2.170225504202, 2.070480420446, 1.0]),
        ),
        (
            "dahl 1.5",
            errors(
                dahl(0.1, 1.5),
                [2.313874746852, 2.068377420395, 0.998379657253],
            ),
        ),
        (
            "dahl 0.5",
            errors(dahl(0.1, 0.5), [2.110610274109, 2.061922674723, 1.0]),
        ),
        (
            "lugre, elastic",
            errors(
                lugre([10.0, 0.0, 0.0, 1.0, 1.0]),
                [2.170225504202, 2.070480420446, 1.0],
            ),
        ),
        (
            "lugre, damped",
            errors(
                lugre([10.0, 0.5, 0.1, 1.0, 1.0]),
                [1.665406667264, 1.873187730374, 1.187318773037],
            ),
        ),
        (
            "lugre",
            errors(
                lugre([10.0, 0.5, 0.4, 1.5, 0.5]),
                [0.762028293782, 1.232100768689, 1.493938040624],
            ),
        ),
    ];
    for (name, [coarse, fine]) in cases {
        // Both errors in units of dt^2; the phase of a reversal in its step makes them irregular.
        let [coarse, fine] = [coarse / (0.005 * 0.005), fine / (0.00125 * 0.00125)];
        assert!(coarse < 1.2 && fine < 1.2, "{name}: {coarse} {fine}");
    }
}

/// A step in L cases with flexibilities for both ends.
#[derive(Debug, Clone, Copy)]
struct Random {
    trial: Trial<1>,
    on: StepFlexibility<1>,
}

impl Random {
    /// r and rdot at the end of the step under S.
    fn motion(&self, s: f64) -> [f64; 2] {
        let Random { trial, on } = self;
        let before = trial.force.0[0];
        [
            trial.displacement.0[0] + trial.change.0[0]
                - on.start.h.0[0] * before
                - on.end.h.0[0] * s,
            trial.rate.0[0] - on.start.h_rate.0[0] * before - on.end.h_rate.0[0] * s,
        ]
    }

    fn force<W: Law>(&self, law: W) -> f64 {
        let [force] = W::step(&[law], &self.on)
            .force(&self.trial, &mut Default::default())
            .0;
        force
    }
}

prop_compose! {
    fn steps()(
        r in -3.0..3.0_f64,
        rdot in -3.0..3.0_f64,
        s in -1.0..=1.0_f64,
        change in -3.0..3.0_f64,
        rate in -3.0..3.0_f64,
        size in -6.0..0.5_f64,
        [h, h_rate] in [0.0..5.0_f64, 1e-3..5.0_f64],
        explicit in 0..4,
        at_start in 0..3,
    ) -> Random {
        let size = libm::pow(10.0, size);
        let end = Flexibility {
            h: Lane([if explicit == 0 { 0.0 } else { h }]),
            h_rate: Lane([h_rate]),
        };
        let trial = Trial {
            displacement: Lane([r]),
            velocity: Lane([rdot]),
            force: Lane([s]),
            change: Lane([size * change]),
            rate: Lane([size * rate]),
        };
        let start = if at_start == 0 { OFF } else { end };
        Random { trial, on: StepFlexibility { start, end, dt: Lane([0.1]), by_impulse: false } }
    }
}

/// L cases of one step; the lanes have different signs and sizes.
fn side_by_side<W: Law, const L: usize>(law: W, of: &Random) -> [f64; L] {
    let factors: [f64; L] = std::array::from_fn(|l| [1.0, -1.0, 0.0, 1e-3, -40.0][l % 5]);
    let lanes = |x: Lane<1>| Lane(factors.map(|f| if f == 0.0 { 0.0 } else { f * x.0[0] }));
    let same = |x: Lane<1>| Lane([x.0[0]; L]);
    let trial = Trial {
        displacement: lanes(of.trial.displacement),
        velocity: lanes(of.trial.velocity),
        force: Lane(factors.map(|f| f.clamp(-1.0, 1.0) * of.trial.force.0[0])),
        change: lanes(of.trial.change),
        rate: lanes(of.trial.rate),
    };
    let flexibility = |at: Flexibility<1>| Flexibility {
        h: same(at.h),
        h_rate: same(at.h_rate),
    };
    let on = StepFlexibility {
        start: flexibility(of.on.start),
        end: flexibility(of.on.end),
        dt: same(of.on.dt),
        by_impulse: false,
    };
    W::step(&[law; L], &on)
        .force(&trial, &mut Default::default())
        .0
}

/// The same bits in one lane and in several, and S(-x) = -S(x).
fn mirrored<W: Law>(law: W, of: &Random) -> bool {
    let single = of.force(law);
    let [a, b, ..] = side_by_side::<W, 7>(law, of);
    let [c, ..] = side_by_side::<W, 1>(law, of);
    single.to_bits() == a.to_bits() && a == -b && c.to_bits() == a.to_bits()
}

/// z after u in one direction from z(0), by the integrals of the laws' equations.
fn bouc_wen_flow(n: f64, z: f64, u: f64) -> f64 {
    if z + u <= 0.0 {
        return z + u;
    }
    let [z, u] = if z < 0.0 { [0.0, z + u] } else { [z, u] };
    if n == 1.0 {
        1.0 - (1.0 - z) * libm::exp(-u)
    } else {
        let t = libm::tanh(u);
        (z + t) / (1.0 + z * t)
    }
}

/// The same for d = beta - gamma: y' = -(1 + d y^n) for y = -z > 0 is solved by a power for n = 1 and a tangent for n = 2.
fn bent_flow(n: f64, d: f64, z: f64, u: f64) -> f64 {
    if z >= 0.0 {
        return bouc_wen_flow(n, z, u);
    }
    let root = d.abs().sqrt();
    let [to_zero, y] = match (n == 1.0, d > 0.0) {
        (true, _) => [
            libm::log1p(-d * z) / d,
            libm::exp(-d * u) * (1.0 / d - z) - 1.0 / d,
        ],
        (false, true) => {
            let from = libm::atan(-root * z);
            [from / root, libm::tan(from - root * u) / root]
        }
        (false, false) => {
            let from = libm::atanh(-root * z);
            [from / root, libm::tanh(from - root * u) / root]
        }
    };
    match u < to_zero {
        true => -y,
        false => bouc_wen_flow(n, 0.0, u - to_zero),
    }
}

fn dahl_flow(n: f64, s: f64, u: f64) -> f64 {
    let q = 1.0 - s;
    let end = if n == 1.0 {
        q * libm::exp(-u)
    } else {
        let inner = libm::pow(q, 1.0 - n) + (n - 1.0) * u;
        if inner <= 0.0 {
            0.0
        } else {
            libm::pow(inner, -1.0 / (n - 1.0))
        }
    };
    1.0 - end
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 500, ..ProptestConfig::default() })]

    #[test]
    fn forces_over_velocity_solve_their_equations(
        step in steps(),
        compliance in 1e-3..5.0_f64,
        ratio in 0.05..1.0_f64,
        rate in 0.0..20.0_f64,
        velocity in 0.01..3.0_f64,
        static_limit in 1.0..2.0_f64,
    ) {
        // The velocity is known to eps of the terms that make it, the force to this times its slope.
        let terms = 1.0 + step.trial.rate.0[0].abs() + 2.0 * step.on.end.h_rate.0[0];
        let near = |s: f64, law: &dyn Fn(f64) -> f64, slope: f64| {
            let [_, v] = step.motion(s);
            (s - law(v.abs()).copysign(v)).abs() <= 8.0 * f64::EPSILON * (1.0 + terms * slope)
        };
        let nu = |v: f64| 1.0 - (1.0 - ratio) * libm::exp(-rate * v);
        let slope = 1.0 / compliance;
        let s = step.force(tanh(compliance, 1.0, 0.0));
        prop_assert!(near(s, &|v| libm::tanh(v / compliance), slope), "tanh {s}");
        let s = step.force(tanh(compliance, ratio, rate));
        prop_assert!(near(s, &|v| nu(v) * libm::tanh(v / compliance), slope + rate), "tanh with nu {s}");
        let s = step.force(bearing(compliance, ratio, rate));
        prop_assert!(near(s, &|v| nu(v).min(v / compliance), slope + rate), "bearing {s}");
        let law = stribeck(compliance, static_limit, velocity);
        let s = step.force(law);
        let curve = |v: f64| {
            let over = v - compliance * static_limit;
            if over < 0.0 { v / compliance } else { 1.0 + (static_limit - 1.0) * libm::exp(-over / velocity) }
        };
        prop_assert!(near(s, &curve, slope + (static_limit - 1.0) / velocity), "stribeck {s}");
        let falls = hyperbolic(compliance, static_limit, velocity);
        let s = step.force(falls);
        let curve = |v: f64| {
            let over = v - compliance * static_limit;
            if over < 0.0 { v / compliance } else { 1.0 + (static_limit - 1.0) * velocity / (velocity + over) }
        };
        prop_assert!(near(s, &curve, slope + (static_limit - 1.0) / velocity), "hyperbolic {s}");
        prop_assert!(mirrored(falls, &step));
        prop_assert!(mirrored(tanh(compliance, 1.0, 0.0), &step));
        prop_assert!(mirrored(tanh(compliance, ratio, rate), &step));
        prop_assert!(mirrored(bearing(compliance, ratio, rate), &step));
        prop_assert!(mirrored(law, &step));
    }

    #[test]
    fn forces_over_displacement_solve_their_equations(
        step in steps(),
        compliance in 1e-3..5.0_f64,
        exponent in 0.0..5.0_f64,
        beta in 0.05..3.0_f64,
    ) {
        let before = step.trial.force.0[0];
        let terms = 1.0 + step.trial.change.0[0].abs() + 2.0 * step.on.end.h.0[0];
        // As above; the slope of Dahl's law is at most 2^n/compliance, and its powers lose some digits more.
        let near = |s: f64, flow: &dyn Fn(f64, f64) -> f64, slope: f64| {
            let [r, _] = step.motion(s);
            let change = step.trial.change.0[0] - step.on.start.h.0[0] * before - step.on.end.h.0[0] * s;
            prop_assert!((r - step.trial.displacement.0[0] - change).abs() < 1e-14);
            let sign = 1.0_f64.copysign(change);
            let expected = sign * flow(sign * before, change.abs() / compliance);
            prop_assert!((s - expected).abs() <= 16.0 * f64::EPSILON * (2.0 + terms * slope / compliance), "{s} {expected}");
            Ok(())
        };
        for n in [1.0, 2.0] {
            near(step.force(bouc_wen(compliance, n)), &|z, u| bouc_wen_flow(n, z, u), 1.0)?;
        }
        // Divided by a small d, or near z = -1 for a small beta, the closed form loses digits, not the law.
        let d = 2.0 * beta - 1.0;
        if d.abs() > 0.1 {
            for n in [1.0, 2.0] {
                near(step.force(bent(compliance, n, beta)), &|z, u| bent_flow(n, d, z, u), 2.0 * beta + 4.0 / beta)?;
            }
        }
        near(step.force(dahl(compliance, 1.0)), &|z, u| dahl_flow(1.0, z, u), 2.0)?;
        // Near n = 1 the powers of the closed form lose digits, not the law.
        if (exponent - 1.0).abs() > 0.1 {
            let slope = libm::pow(2.0, exponent) * 4.0 / (exponent - 1.0).abs();
            near(step.force(dahl(compliance, exponent)), &|z, u| dahl_flow(exponent, z, u), slope)?;
        }
        for n in [1.0, 2.0, 0.5 + exponent, 200.0] {
            prop_assert!(mirrored(bouc_wen(compliance, n), &step));
            prop_assert!(mirrored(bent(compliance, n, beta), &step));
        }
        for n in [1.0, exponent] {
            prop_assert!(mirrored(dahl(compliance, n), &step));
        }
        // n = 0: the displacement-control model.
        let s = step.force(dahl(compliance, 0.0));
        let plastic = step.force(DisplacementControl { compliance, limit: 1.0 });
        prop_assert!((s - plastic).abs() <= 16.0 * f64::EPSILON * (2.0 + terms / compliance), "{s} {plastic}");
        // The midpoint rule of Bouc-Wen has its own equation.
        let n = 0.5 + exponent;
        let s = step.force(bouc_wen(compliance, n));
        let change = step.trial.change.0[0] - step.on.start.h.0[0] * before - step.on.end.h.0[0] * s;
        let [z, end, u] = [before * 1.0_f64.copysign(change), s * 1.0_f64.copysign(change), change.abs() / compliance];
        let [z, u] = if z < 0.0 && end >= 0.0 { [0.0, u + z] } else { [z, u] };
        let middle = 0.5 * (z + end);
        let grown = if end <= 0.0 { u } else { u * (1.0 - libm::pow(middle, n)) };
        let near = 16.0 * f64::EPSILON * (2.0 + (1.0 + n) * terms / compliance);
        let limited = end >= 1.0 - 4.0 * f64::EPSILON;
        prop_assert!(end <= 1.0 && if limited { grown >= 1.0 - z - near } else { (end - z - grown).abs() < near }, "{end} {z} {grown}");
    }

    #[test]
    fn lugre_solves_its_equations(
        step in steps(),
        [sigma0, sigma1, sigma2] in [0.1..100.0_f64, 0.0..2.0_f64, 0.0..2.0_f64],
        static_limit in 1.0..2.0_f64,
        stribeck_velocity in 0.05..3.0_f64,
    ) {
        for (static_limit, velocity) in [(1.0, 0.0), (static_limit, 0.0), (1.0, 1.0), (static_limit, 1.0)] {
            let mut step = step;
            step.trial.velocity = step.trial.velocity * velocity;
            let law = lugre([sigma0, sigma1, sigma2, static_limit, stribeck_velocity]);
            let s = step.force(law);
            prop_assert!(mirrored(law, &step));
            // The first step: dz/dt is the difference quotient, and sigma0 z = S(i) at its start at rest. If the contact moves, z is 0.
            let force = step.trial.force.0[0];
            let before = if step.trial.velocity.0[0] == 0.0 { force } else { 0.0 };
            let change = step.trial.change.0[0] - step.on.start.h.0[0] * force - step.on.end.h.0[0] * s;
            let [_, rdot] = step.motion(s);
            let dt = 0.1;
            let v = change / dt / stribeck_velocity;
            let g = (1.0 + (static_limit - 1.0) * libm::exp(-v * v)).copysign(change);
            let bristles = g - (g - before) * libm::exp(-sigma0 * change.abs() / g.abs());
            let expected = bristles + sigma1 * (bristles - before) / (sigma0 * dt) + sigma2 * rdot;
            // 1/dt and the slopes of the law, all of which multiply the round-off of r(i+1) - r(i).
            let terms = 1.0 + 3.0 * step.on.end.h.0[0].max(step.on.end.h_rate.0[0]) * (1.0 + s.abs());
            let slope = 3.0 * (sigma0 + 10.0 / stribeck_velocity) * (1.0 + sigma1 / (sigma0 * dt)) + sigma2;
            prop_assert!((s - expected).abs() < 16.0 * f64::EPSILON * (2.0 + terms * slope), "{s} {expected}");
        }
    }

    #[test]
    fn where_one_root_is_promised_the_residual_rises(
        step in steps(),
        [sigma0, sigma1, sigma2] in [0.1..100.0_f64, 0.0..2.0_f64, 0.0..2.0_f64],
        static_limit in 1.0..2.0_f64,
        stribeck_velocity in 0.05..3.0_f64,
        shrink in 0.0..4.0_f64,
    ) {
        let shrink = libm::pow(10.0, -shrink);
        let mut step = step;
        step.on.end.h = step.on.end.h * shrink;
        let law = lugre([sigma0, sigma1, sigma2, static_limit, stribeck_velocity]);
        if law.has_one_root(&step.on) {
            let given = curve::law_of_motion(law, 0.1);
            let residual = |s: f64| {
                let change = step.trial.change.0[0] - step.on.start.h.0[0] * step.trial.force.0[0] - step.on.end.h.0[0] * s;
                let [_, rdot] = step.motion(s);
                let trial = Trial { change: Lane([change]), rate: Lane([rdot]), ..step.trial };
                s - given.force(&trial, &mut Default::default()).0[0]
            };
            let mut last = f64::NEG_INFINITY;
            for k in -300..=300 {
                let now = residual(f64::from(k) * 0.02);
                prop_assert!(now > last, "{k}: {now} {last}");
                last = now;
            }
        }
    }
}

#[test]
fn stribeck_keeps_its_branch_where_a_step_has_several_roots() {
    keeps_its_branch(stribeck(0.1, 1.5, 0.1), |x| libm::exp(-x));
    keeps_its_branch(hyperbolic(0.1, 1.5, 0.1), |x| 1.0 / (1.0 + x));
}

fn keeps_its_branch(law: Stribeck, left: impl Fn(f64) -> f64) {
    let end = Flexibility {
        h: Lane([0.1]),
        h_rate: Lane([0.6]),
    };
    let on = |h_rate: f64| StepFlexibility {
        start: OFF,
        end: Flexibility {
            h_rate: Lane([h_rate]),
            ..end
        },
        dt: Lane([0.1]),
        by_impulse: false,
    };
    // One root below h_rate = v_S/(L_s - L_k) = 0.2.
    assert!(law.has_one_root(&on(0.199)) && !law.has_one_root(&on(0.2)));
    let [mut stays, mut sticks, mut several] = [0; 3];
    for h_rate in [0.1, 0.19, 0.6, 2.0] {
        for k in 0..400 {
            let rate = f64::from(k) * 1e-2;
            let curve = |v: f64| {
                if v < 0.15 {
                    v / 0.1
                } else {
                    1.0 + 0.5 * left((v - 0.15) / 0.1)
                }
            };
            let residual = |v: f64| v + h_rate * curve(v) - rate;
            let below = |i: i32| residual(f64::from(i) * 2e-4) < 0.0;
            let changes = (0..20_000).filter(|i| below(*i) != below(i + 1));
            let roots = Vec::from_iter(changes.map(|i| f64::from(i) * 2e-4));
            assert!(h_rate > 0.2 || roots.len() <= 1);
            let velocity = |before: f64| {
                let trial = Trial {
                    displacement: Lane([0.0]),
                    velocity: Lane([before]),
                    force: Lane([0.0]),
                    change: Lane([0.0]),
                    rate: Lane([rate]),
                };
                rate - h_rate * Law::step(&[law], &on(h_rate)).force(&trial, &mut ()).0[0]
            };
            // The grid of roots is 2e-4 wide; near double roots it misses both.
            if roots.len() == 3 {
                several += 1;
                let [slow, fast] = [velocity(0.0), velocity(0.5)];
                stays += usize::from((fast - roots[2]).abs() < 4e-4);
                sticks += usize::from((slow - roots[0]).abs() < 4e-4);
                // A contact that slid the other way sticks.
                assert_eq!(velocity(-0.5), slow);
            } else if h_rate < 0.2 {
                assert_eq!(velocity(0.5), velocity(-0.5));
            }
        }
    }
    assert!(
        several > 50 && stays == several && sticks == several,
        "{several} {stays} {sticks}"
    );
}

#[test]
fn lugre_has_one_root_in_small_steps() {
    // h = dt^2/4 and h_rate = dt/2 for a free mass of 1. The term with 1/dt of the condition is bounded.
    let law = lugre([10.0, 0.5, 0.0, 1.5, 0.01]);
    let one = |dt: f64| {
        let end = Flexibility {
            h: Lane([0.25 * dt * dt]),
            h_rate: Lane([0.5 * dt]),
        };
        law.has_one_root(&StepFlexibility {
            start: OFF,
            end,
            dt: Lane([dt]),
            by_impulse: false,
        })
    };
    assert!([1e-6, 1e-3, 0.05, 0.2].into_iter().all(one) && !one(2.0));
    // By displacement the law is known without a root.
    let explicit = StepFlexibility {
        start: OFF,
        end: Flexibility {
            h: Lane([0.0]),
            h_rate: Lane([1.0]),
        },
        dt: Lane([2.0]),
        by_impulse: false,
    };
    assert!(law.has_one_root(&explicit));
}

/// Largest difference of two motions.
fn difference(a: &[[f64; 3]], b: &[[f64; 3]]) -> f64 {
    let pairs = a.iter().flatten().zip(b.iter().flatten());
    pairs.fold(0.0, |most, (a, b)| most.max((a - b).abs()))
}

#[test]
fn laws_tend_to_each_other() {
    let run = [2.0, 0.8, 0.5, 0.01];
    let close = |a: Vec<[f64; 3]>, b: Vec<[f64; 3]>, most: f64| {
        let difference = difference(&a, &b);
        assert!(difference <= most, "{difference:e} > {most:e}");
    };
    let plastic = driven(
        DisplacementControl {
            compliance: 0.1,
            limit: 1.0,
        },
        run,
        3000,
    );
    // Bouc-Wen reaches the limit by 1/n of it late.
    for n in [200.0, 2000.0] {
        close(
            driven(bouc_wen(0.1, n), run, 3000),
            plastic.clone(),
            4.0 / n,
        );
    }
    // Round-off of 3000 steps in a motion that is stable.
    close(driven(dahl(0.1, 0.0), run, 3000), plastic, 1e-11);
    let one = driven(dahl(0.1, 1.0), run, 3000);
    close(
        driven(lugre([10.0, 0.0, 0.0, 1.0, 1.0]), run, 3000),
        one.clone(),
        1e-11,
    );
    close(driven(dahl(0.1, 1.0 + 1e-9), run, 3000), one, 1e-8);
    let viscous = driven(
        VelocityControl {
            compliance: 0.1,
            limit: 1.0,
        },
        run,
        3000,
    );
    close(
        driven(bearing(0.1, 1.0, 3.0), run, 3000),
        viscous.clone(),
        1e-12,
    );
    close(driven(stribeck(0.1, 1.0, 0.3), run, 3000), viscous, 1e-12);
    let half = Tanh {
        limit: 0.5,
        ..tanh(0.2, 1.0, 0.0)
    };
    close(
        driven(tanh(0.1, 0.5, 0.0), run, 3000),
        driven(half, run, 3000),
        1e-11,
    );
    // The flow of n = 2 and the midpoint rule near n = 2: second order.
    let gap = |dt: f64, steps: u32| {
        let run = [2.0, 0.8, 0.5, dt];
        difference(
            &driven(bouc_wen(0.1, 2.0), run, steps),
            &driven(bouc_wen(0.1, 2.0 + 1e-12), run, steps),
        )
    };
    assert!(
        gap(0.01, 3000) < 4e-3 && gap(0.001, 30_000) < 4e-5,
        "{} {}",
        gap(0.01, 3000),
        gap(0.001, 30_000)
    );
}

/// S over a motion of small parts, and the energy S dr by their mean forces.
fn pushed(law: BoucWen, start: f64, change: f64, parts: u32) -> [f64; 2] {
    let on = StepFlexibility {
        start: OFF,
        end: OFF,
        dt: Lane([1.0]),
        by_impulse: false,
    };
    let step = BoucWen::step(&[law], &on);
    let (mut s, mut energy) = (start, 0.0);
    let part = change / f64::from(parts);
    for _ in 0..parts {
        let trial = Trial {
            displacement: Lane([0.0]),
            velocity: Lane([0.0]),
            force: Lane([s]),
            change: Lane([part]),
            rate: Lane([part]),
        };
        let [end] = step.force(&trial, &mut ()).0;
        energy += 0.5 * (s + end) * part;
        s = end;
    }
    [s, energy]
}

/// The energy of a cycle of z from 0 to a and back is, with d = beta - gamma, u_y L times the integral of z/(1 - z^n) - z/(1 + d z^n).
#[test]
fn a_cycle_of_bouc_wens_model_takes_the_energy_of_its_integral() {
    let (a, parts) = (0.8_f64, 20_000);
    for (n, beta) in [(1.0, 0.9), (2.0, 0.9), (2.0, 0.2), (3.0, 0.9), (2.0, 0.5)] {
        let law = bent(0.1, n, beta);
        let d = law.d();
        // Simpson's rule, of fourth order in parts of 4e-4.
        let integral = |f: &dyn Fn(f64) -> f64| {
            let h = a / 2000.0;
            let weight = |k: u32| match k {
                0 | 2000 => 1.0,
                _ if k % 2 == 1 => 4.0,
                _ => 2.0,
            };
            let terms = (0..=2000).map(|k| weight(k) * f(h * f64::from(k)));
            terms.sum::<f64>() * h / 3.0
        };
        let power = |z: f64| libm::pow(z, n);
        let up = integral(&|z| 1.0 / (1.0 - power(z)));
        let down = integral(&|z| 1.0 / (1.0 + d * power(z)));
        let expected = 0.1 * integral(&|z| z / (1.0 - power(z)) - z / (1.0 + d * power(z)));
        let [top, taken] = pushed(law, 0.0, 0.1 * up, parts);
        let [end, returned] = pushed(law, top, -0.1 * down, parts);
        // The mean force of a part has an error of the second order; so have the midpoints of n = 3.
        assert!(
            (top - a).abs() < 1e-8 && end.abs() < 1e-8,
            "{n} {beta} {top} {end}"
        );
        let energy = taken + returned;
        assert!(
            (energy - expected).abs() < 1e-8 * expected,
            "{n} {beta} {energy} {expected}"
        );
        if n == 2.0 && d != 0.0 {
            let closed = -0.05 * (libm::log1p(-a * a) + libm::log1p(d * a * a) / d);
            assert!((expected - closed).abs() < 1e-12, "{expected} {closed}");
        }
        // The slope where it begins to fall.
        let part = 1e-6;
        let slope = (top - pushed(law, top, -part, 1)[0]) / part;
        let wanted = (1.0 + d * power(top)) / 0.1;
        assert!(
            (slope / wanted - 1.0).abs() < 1e-4,
            "{n} {beta} {slope} {wanted}"
        );
    }
}

#[test]
fn without_compliance_the_velocity_control_model_is_coulombs() {
    let law = VelocityControl {
        compliance: 0.0,
        limit: 1.0,
    };
    // Under a load below the limit the mass stays; its velocity is round-off.
    for [x, v, _] in driven(law, [0.9, 0.7, 0.0, 0.01], 10_000) {
        assert!(x.abs() < 1e-13 && v.abs() < 1e-14, "{x} {v}");
    }
    // Free vibration from 12: half-cycles about +-1, -10 after the first [F (20)]. The method has the period error dt^2/12.
    let states = driven(law, [0.0, 0.0, 12.0, std::f64::consts::PI / 1000.0], 1000);
    assert!((states[1000][0] + 10.0).abs() < 1e-4, "{:?}", states[1000]);
    // It rests after the sixth half-cycle, at X = 0. There the method keeps the mean of two forces, not each of them.
    let states = driven(law, [0.0, 0.0, 12.0, std::f64::consts::PI / 1000.0], 9000);
    let [[x, v, s], [_, _, before]] = [states[9000], states[8999]];
    assert!(
        x.abs() < 1e-4 && v.abs() < 1e-13 && (x + 0.5 * (s + before)).abs() < 1e-12,
        "{x} {v} {s} {before}"
    );
}

/// r = a sin(t): the steady loop's dissipated energy, and the smallest of the steps where S keeps its sign.
fn loop_energy(law: impl Law, amplitude: f64, steps: u32) -> [f64; 2] {
    let step = curve::law_of_motion(law, std::f64::consts::TAU / f64::from(steps));
    let mut memory = Default::default();
    let [mut s, mut sum, mut least] = [0.0, 0.0, 0.0_f64];
    for k in 0..20 * steps {
        let at = |k: u32| {
            amplitude * libm::sin(std::f64::consts::TAU * f64::from(k % steps) / f64::from(steps))
        };
        let [r, next] = [at(k), at(k + 1)];
        let trial = Trial {
            displacement: Lane([r]),
            velocity: Lane([0.0]),
            force: Lane([s]),
            change: Lane([next - r]),
            rate: Lane([0.0]),
        };
        let [end] = step.force(&trial, &mut memory).0;
        let dissipated = dissipated_energy(&law, [r, s], [next, end]);
        if s * end >= 0.0 {
            least = least.min(dissipated);
        }
        if k >= 19 * steps {
            sum += dissipated;
        }
        s = end;
    }
    [sum, least]
}

#[test]
fn loops_dissipate_what_the_flow_does() {
    for amplitude in [0.05, 0.1, 0.5] {
        // Dahl, n = 1, L = sigma compliance = 1: from -Sm the branch is 1 - (1 + Sm) exp(-x/alpha), Sm = tanh(a/alpha).
        let alpha = 0.1;
        let peak = libm::tanh(amplitude / alpha);
        let area =
            2.0 * (2.0 * amplitude + (1.0 + peak) * alpha * libm::expm1(-2.0 * amplitude / alpha));
        let [energy, least] = loop_energy(dahl(alpha, 1.0), amplitude, 4000);
        // The trapezoidal work of 4000 steps.
        assert!((energy - area).abs() < 1e-5 * amplitude, "{energy} {area}");
        // Round-off of the stored energy, up to 0.05.
        assert!(least >= -1e-16, "{least}");
        for n in [0.5, 2.0, 3.0] {
            let [energy, least] = loop_energy(dahl(alpha, n), amplitude, 4000);
            assert!(energy > 0.0 && least >= -1e-16, "{energy} {least}");
        }
        for n in [1.0, 2.0, 5.0, 200.0] {
            let [energy, least] = loop_energy(bouc_wen(alpha, n), amplitude, 4000);
            assert!(energy > -1e-15 && least >= -1e-16, "{n} {energy} {least}");
        }
        let [energy, least] = loop_energy(lugre([10.0, 0.0, 0.0, 1.0, 1.0]), amplitude, 4000);
        assert!((energy - area).abs() < 1e-5 * amplitude && least >= -1e-16);
    }
}

#[test]
fn lugre_is_passive_where_its_condition_holds() {
    // S rdot - d(sigma0 z^2/2)/dt summed over rdot = V sin(t), r = V (1 - cos t), trapezoidal.
    let least = |law: Lugre, v: f64| {
        let steps = 20_000;
        let dt = std::f64::consts::TAU / f64::from(steps);
        let step = curve::law_of_motion(law, dt);
        let mut bristles = laws::friction::lugre::Bristles::<1>::default();
        let [mut s, mut least] = [0.0, f64::INFINITY];
        for k in 1..=2 * steps {
            let at = |k: i32| {
                [
                    -v * libm::cos(f64::from(k) * dt),
                    v * libm::sin(f64::from(k) * dt),
                ]
            };
            let [[r, rdot], [next, rate]] = [at(k - 1), at(k)];
            let trial = Trial {
                displacement: Lane([r]),
                velocity: Lane([rdot]),
                force: Lane([s]),
                change: Lane([next - r]),
                rate: Lane([rate]),
            };
            let before = law.bristle_energy(bristles.force.0[0]);
            let [end] = step.force(&trial, &mut bristles).0;
            let stored = law.bristle_energy(bristles.force.0[0]) - before;
            least = least.min((0.5 * (s + end) * (next - r) - stored) / dt);
            s = end;
        }
        least
    };
    // sigma2 >= sigma1 (L_s/L_k - 1).
    for v in [0.05, 1.0, 10.0] {
        assert!(least(lugre([10.0, 0.5, 0.25, 1.5, 0.5]), v) > -1e-4);
        assert!(least(lugre([10.0, 0.5, 0.0, 1.0, 0.5]), v) > -1e-4);
    }
}

#[test]
fn an_open_contact_has_no_friction() {
    let step = Random {
        trial: Trial {
            displacement: Lane([1.0]),
            velocity: Lane([0.4]),
            force: Lane([0.7]),
            change: Lane([0.3]),
            rate: Lane([0.5]),
        },
        on: StepFlexibility {
            start: OFF,
            end: Flexibility {
                h: Lane([0.2]),
                h_rate: Lane([0.4]),
            },
            dt: Lane([0.1]),
            by_impulse: false,
        },
    };
    assert_eq!(
        step.force(Tanh {
            limit: 0.0,
            ..tanh(0.1, 1.0, 0.0)
        }),
        0.0
    );
    assert_eq!(
        step.force(Tanh {
            limit: 0.0,
            ..tanh(0.1, 0.5, 1.0)
        }),
        0.0
    );
    assert_eq!(
        step.force(Bearing {
            limit: 0.0,
            ..bearing(0.1, 0.5, 1.0)
        }),
        0.0
    );
    assert_eq!(
        step.force(Stribeck {
            limit: 0.0,
            static_limit: 0.0,
            ..stribeck(0.1, 1.0, 1.0)
        }),
        0.0
    );
    for n in [1.0, 2.0, 3.5] {
        assert_eq!(
            step.force(BoucWen {
                limit: 0.0,
                ..bouc_wen(0.1, n)
            }),
            0.0
        );
        assert_eq!(
            step.force(Dahl {
                limit: 0.0,
                ..dahl(0.1, n)
            }),
            0.0
        );
    }
    let open = Lugre {
        limit: 0.0,
        static_limit: 0.0,
        ..lugre([10.0, 0.5, 0.2, 1.0, 1.0])
    };
    assert_eq!(step.force(open), 0.0);
}

#[test]
fn curves_lie_on_their_laws() {
    let (points, _) = tanh(0.1, 0.4, 2.0).cycle(1.0);
    for [v, s] in points {
        let nu = 1.0 - 0.6 * libm::exp(-2.0 * v.abs());
        assert!((s - nu * libm::tanh(v / 0.1)).abs() < 1e-15);
    }
    for (points, _) in [
        bearing(0.0, 0.4, 2.0).cycle(1.0),
        stribeck(0.0, 1.5, 0.3).cycle(1.0),
    ] {
        assert!(points.iter().all(|[v, s]| s.is_finite() && v * s >= 0.0));
    }
    // After the first branch the loop of Dahl's law from -S to S: r from -a to a.
    let (points, _) = dahl(0.1, 1.0).cycle(0.2);
    let [[_, low], [_, high]] = [points[200], points[300]];
    let expected = 1.0 - (1.0 - low) * libm::exp(-4.0);
    assert!((high - expected).abs() < 1e-14, "{high} {expected}");
    // LuGre: S is larger while the velocity grows.
    let (points, _) = lugre([100.0, 1.0, 0.1, 1.5, 0.3]).cycle(1.0);
    let [grows, falls] = [points[400 + 20], points[400 + 180]];
    assert!((grows[0] - falls[0]).abs() < 1e-12 && grows[1] > falls[1]);
}
