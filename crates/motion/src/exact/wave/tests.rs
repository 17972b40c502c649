//! Exact impacts: textbook cases, the equations of the bars, energy and momentum along the bars.

use super::*;

/// z, theta, gap: equal and unequal bars, with and without a gap, irrational ratios, walls.
const CASES: [[f64; 3]; 8] = [
    [1.0, 1.0, 0.0],
    [1.0, 1.0, 0.3],
    [2.0, 1.0, 0.0],
    [1.0, 2.0, 0.1],
    [0.4, 0.37, 0.25],
    [3.0, 1.7, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 1.0, 0.21],
];

const END: f64 = 6.0;

/// Checks each case with its shares d_i and travel times T_i, computed here again, and the number of bars.
fn each(check: impl Fn(&Wave, [f64; 2], [f64; 2], usize)) {
    for [z, theta, gap] in CASES {
        let bars = Bars {
            impedance_ratio: z,
            time_ratio: theta,
            gap,
        };
        let count = if z == 0.0 { 1 } else { 2 };
        let share = [1.0 / (1.0 + z), z / (1.0 + z)];
        check(&bars.solve(END), share, [1.0, theta], count);
    }
}

/// Times without an event in any case: multiples of an irrational number.
fn times() -> impl Iterator<Item = f64> {
    (0..400).map(|i| f64::from(i) * 0.0141421356 + 1e-4)
}

/// Sums of a few numbers of order 1, which are sums over the fronts.
const ROUND_OFF: f64 = 1e-13;

#[test]
fn equal_bars_and_a_wall_agree_with_textbooks() {
    let wave = |z, gap| {
        Bars {
            impedance_ratio: z,
            time_ratio: 1.0,
            gap,
        }
        .solve(3.0)
    };
    for z in [0.0, 1.0] {
        for gap in [0.0, 0.5] {
            let (wave, touch) = (wave(z, gap), 0.5 * gap);
            for (t, r, rdot, force) in [
                (0.5 * touch, 0.5 * gap, -1.0, 0.0),
                (touch + 0.5, 0.0, 0.0, 1.0),
                (touch + 1.25, 0.5, 1.0, 0.0),
            ] {
                let state = State {
                    displacement: r,
                    velocity: rdot,
                    force,
                };
                if t > 0.0 {
                    assert_eq!(wave.at(t), state, "z = {z}, gap = {gap}, t = {t}");
                }
            }
            assert_eq!(wave.durations(), [Some(touch + 1.0); 2]);
            assert_eq!(wave.impulse(touch + 0.25), 0.25);
            assert_eq!(wave.impulse(3.0), 1.0);
        }
    }
}

#[test]
fn each_side_of_a_jump_has_its_own_limit() {
    let wave = Bars {
        impedance_ratio: 1.0,
        time_ratio: 1.0,
        gap: 0.5,
    }
    .solve(2.0);
    for (t, before, after) in [(0.25, -1.0, 0.0), (1.25, 0.0, 1.0)] {
        assert_eq!(
            (wave.before(t).velocity, wave.at(t).velocity),
            (before, after)
        );
        // Elsewhere there is no jump.
        assert_eq!(wave.before(t + 0.1), wave.at(t + 0.1));
    }
    assert_eq!(wave.before(0.0).velocity, -1.0);
    // The line has both sides of both jumps: at t = 1/4, which is one of the times, and at 5/4, which is not.
    let line = wave.line(&[0.0, 0.25, 1.0, 2.0]);
    assert!(line.time.is_sorted());
    for jump in [0.25, 1.25] {
        let at: Vec<f64> = (0..line.len())
            .filter(|&i| line.time[i] == jump)
            .map(|i| line.velocity()[i])
            .collect();
        assert_eq!(
            at[..2],
            [wave.before(jump).velocity, wave.at(jump).velocity]
        );
    }
}

#[test]
fn contact_satisfies_the_equations_of_the_bars_and_never_pulls() {
    each(|wave, share, travel, count| {
        for t in times() {
            let (
                State {
                    displacement,
                    velocity,
                    force,
                },
                free,
            ) = (wave.at(t), wave.piece(t).free);
            let rdot = free[1] + share[1] * force - (free[0] - share[0] * force);
            assert!((velocity - rdot).abs() < ROUND_OFF);
            assert!(force >= 0.0 && displacement >= -ROUND_OFF);
            // There is a force only if they touch and do not separate.
            assert!(force * displacement.abs() < ROUND_OFF && force * velocity.abs() < ROUND_OFF);
            for i in 0..count {
                let back = t - travel[i];
                if back > 0.0 {
                    let was = wave.piece(back);
                    let sign = [-2.0, 2.0][i];
                    let delayed = was.free[i] + sign * share[i] * was.force;
                    assert!((free[i] - delayed).abs() < ROUND_OFF, "t = {t}, bar {i}");
                }
            }
            // r is continuous and the integral of 2 rdot, within a piece and across its end.
            let step = 1e-5;
            if wave.before(t + step).velocity == velocity {
                let moved = wave.at(t + step).displacement - displacement;
                assert!((moved - 2.0 * velocity * step).abs() < ROUND_OFF);
            }
        }
        for piece in &wave.pieces[1..] {
            let gap = wave.at(piece.start).displacement - wave.before(piece.start).displacement;
            assert!(gap.abs() < ROUND_OFF);
        }
    });
}

#[test]
fn profiles_conserve_energy_and_momentum() {
    // Z_i is proportional to 1/d_i, the energy of a length to Z_i T_i (v^2 + (d_i sigma)^2), its momentum to Z_i T_i v.
    each(|wave, share, travel, count| {
        let sums = |t: f64| {
            let (mut energy, mut momentum) = (0.0, 0.0);
            for i in 0..count {
                for pair in wave.profile(i, t).chunks(2) {
                    let [[from, v, sigma], [to, ..]] = [pair[0], pair[1]];
                    let weight = travel[i] / share[i] * (to - from);
                    energy += weight * (v * v + share[i] * share[i] * sigma * sigma);
                    momentum += weight * v;
                }
            }
            (energy, momentum)
        };
        let (energy, momentum) = sums(0.0);
        for t in times() {
            let (e, p) = sums(t);
            assert!((e / energy - 1.0).abs() < 1e-11, "t = {t}: {e} {energy}");
            if count == 2 {
                assert!((p - momentum).abs() < 1e-11 * energy, "t = {t}");
            }
        }
    });
}

#[test]
fn fronts_travel_with_c0_and_jump_by_the_impedance() {
    each(|wave, share, travel, count| {
        for t in times() {
            for i in 0..count {
                let profile = wave.profile(i, t);
                let (first, last) = (profile[0], profile[profile.len() - 1]);
                assert_eq!((first[0], last[0]), (0.0, 1.0));
                assert!(last[2].abs() < ROUND_OFF, "stress at the free end");
                let contact = wave.at(t);
                assert!((first[2] + contact.force).abs() < ROUND_OFF);
                let end = wave.piece(t).free[i] + [-1.0, 1.0][i] * share[i] * contact.force;
                assert!((first[1] - end).abs() < ROUND_OFF);
                for pair in profile[1..profile.len() - 1].chunks(2) {
                    let [[s, v0, sigma0], [_, v1, sigma1]] = [pair[0], pair[1]];
                    // The position of the front 1e-6 later gives its direction.
                    let step = 1e-6 / (0.5 * travel[i]);
                    let later = wave.profile(i, t + 1e-6);
                    let goes = |to: f64| later.iter().any(|c| (c[0] - to).abs() < 1e-3 * step);
                    let (out, back) = (goes(s + step), goes(s - step));
                    assert!(out || back || !(step..1.0 - step).contains(&s));
                    if out != back {
                        // For waves that leave the contact the force is -Z v to the right and Z v to the left.
                        let sign = if out { -1.0 } else { 1.0 } * [-1.0, 1.0][i];
                        let jump = share[i] * (sigma1 - sigma0) - sign * (v1 - v0);
                        assert!(jump.abs() < ROUND_OFF, "t = {t}, s = {s}: {jump}");
                    }
                    let [v, sigma] = wave.inside(i, s - 1e-6, t);
                    assert_eq!([v, sigma], [v0, sigma0]);
                }
            }
        }
    });
}

#[test]
fn fronts_are_at_an_end_when_they_reach_it() {
    // Equal bars that touch at t = 0: one front in each bar, at the free end at T_I/2 and back at T_I, then none.
    let equal = Bars {
        impedance_ratio: 1.0,
        time_ratio: 1.0,
        gap: 0.0,
    };
    let wave = equal.solve(1.5);
    for (t, front) in [
        (0.0, Some(0.0)),
        (0.125, Some(0.25)),
        (0.49, Some(0.98)),
        (0.5, Some(1.0)),
        (0.51, Some(0.98)),
        (0.75, Some(0.5)),
        (1.0, Some(0.0)),
        (1.2, None),
    ] {
        for i in [0, 1] {
            let fronts = wave.fronts(i, t);
            match front {
                Some(front) => assert!(
                    !fronts.is_empty() && fronts.iter().all(|s| (s - front).abs() < ROUND_OFF),
                    "t = {t}: {fronts:?}"
                ),
                None => assert!(fronts.is_empty(), "t = {t}: {fronts:?}"),
            }
        }
    }
}

#[test]
fn jumps_of_profiles_and_fronts_inside_are_the_same() {
    each(|wave, _, _, count| {
        for (t, i) in times().flat_map(|t| (0..count).map(move |i| (t, i))) {
            let line = wave.profile(i, t);
            let inside = line[1..line.len() - 1].chunks(2);
            let jumps: Vec<f64> = inside
                .filter(|pair| {
                    (pair[0][1] - pair[1][1]).abs() + (pair[0][2] - pair[1][2]).abs() > 1e-9
                })
                .map(|pair| pair[0][0])
                .collect();
            let fronts = wave.fronts(i, t);
            let near = |positions: &[f64], s: f64| positions.iter().any(|x| (x - s).abs() < 1e-9);
            for s in &jumps {
                assert!(near(&fronts, *s), "t = {t}, s = {s}: {fronts:?}");
            }
            for s in fronts
                .into_iter()
                .filter(|s| (1e-9..1.0 - 1e-9).contains(s))
            {
                assert!(near(&jumps, s), "t = {t}, s = {s}: {jumps:?}");
            }
        }
    });
}
