//! Coulomb friction with a static limit above the kinetic one in a plane, beside the same on a line, the exact motion and an independent
//! integration.

use super::*;
use crate::exact::adaptive;

/// Friction of the ground on two nodes.
fn slide_in_plane(structure: &mut Structure, nodes: [usize; 2], law: StructureLaw) {
    let rows = law.in_plane().unwrap();
    for (node, law) in nodes.into_iter().zip(rows) {
        structure
            .contacts
            .push(contact([None, Some(node)], 0.0, law));
    }
}

fn load(structure: &mut Structure, pattern: Vec<(usize, f64)>, signal: Signal) {
    structure.loads.push(Load {
        pattern,
        signal: Arc::new(signal),
    });
}

fn wave(amplitude: f64, omega: f64, phase: f64) -> Signal {
    Signal::Sine {
        amplitude,
        omega,
        phase,
    }
}

fn constant(value: f64) -> Signal {
    Signal::Table(Table::new(vec![0.0], vec![value]).unwrap())
}

/// Blocks on springs that a frame pulls: on a line, or along this direction in a plane, in which block i has the nodes 2 i and 2 i + 1.
fn blocks(
    direction: Option<[f64; 2]>,
    ratios: &[f64],
    limit: impl Fn(usize) -> Limit,
) -> Structure {
    let n = ratios.len();
    let parts: &[f64] = match &direction {
        None => &[1.0],
        Some(direction) => direction,
    };
    let d = parts.len();
    let mass = |node: usize| 1.0 + 0.1 * (node / d) as f64;
    let mut blocks = masses(&(0..d * n).map(mass).collect::<Vec<_>>());
    for (i, ratio) in ratios.iter().enumerate() {
        for way in 0..d {
            let node = d * i + way;
            if i + 1 < n {
                blocks
                    .stiffness
                    .add_spring([Some(node), Some(node + d)], 30.0);
            }
            blocks.stiffness.add_spring([None, Some(node)], 20.0);
        }
        let law = two_limits(limit(i), *ratio);
        match direction {
            Some(_) => slide_in_plane(&mut blocks, [2 * i, 2 * i + 1], law),
            None => blocks.contacts.push(contact([None, Some(i)], 0.0, law)),
        }
    }
    let pull = Table::new(vec![0.0, 6.0, 12.0], vec![0.0, 12.0, -5.0]).unwrap();
    let factor = |node: usize| (node, (1.0 + 0.03 * (node / d) as f64) * parts[node % d]);
    load(
        &mut blocks,
        (0..d * n).map(factor).collect(),
        Signal::Table(pull),
    );
    blocks
}

/// u of all nodes and S of all contacts at the steps, and the energy error.
fn steps(method: &Method, s: &Structure, dt: f64, end: f64) -> (Vec<Vec<f64>>, Vec<Vec<f64>>, f64) {
    let prepared = Prepared::by(method, s, dt).unwrap();
    let (mut u, mut forces, mut books) = (Vec::new(), Vec::new(), None::<Books<1>>);
    let count = (end / dt).round() as usize;
    let at_start = |contact: &Contact| contact.law.limit().map_or(0.0, |limit| limit.at(0.0));
    let mut limits: Vec<f64> = s.contacts.iter().map(at_start).collect();
    let [done] = run::<1>(&[s], &prepared, count, |_, state| {
        u.push((0..s.len()).map(|i| state.displacement(i).0[0]).collect());
        let of = |c| state.contact(c);
        let force: Vec<f64> = (0..s.contacts.len()).map(|c| of(c).force.0[0]).collect();
        for c in (0..s.contacts.len()).filter(|c| s.contacts[*c].law.row().is_some() && c % 2 == 0)
        {
            // The mean force over the step, up to the mean limit.
            let now = of(c).limit.0[0];
            let mean = 0.5 * (limits[c] + now);
            limits[c] = now;
            let limit = s.contacts[c].law.static_ratio() * mean;
            let size = force[c].hypot(force[c + 1]);
            // Round-off.
            assert!(size <= limit * (1.0 + 1e-12), "{c} {size} {limit}");
        }
        forces.push(force);
        match &mut books {
            Some(books) => books.add(state),
            None => books = Some(Books::new(state)),
        }
    });
    done.unwrap();
    (u, forces, books.unwrap().energy_error().0[0])
}

/// u and v of all nodes, and S of all contacts, in the exact motion.
fn exact(s: &Structure, times: &[f64]) -> Vec<[Vec<f64>; 3]> {
    let nodes: Vec<usize> = (0..s.len()).collect();
    let mut states = Vec::new();
    adaptive::run_of(s, &nodes, times, adaptive::TOLERANCE, |_, state| {
        states.push([state.u, state.v, state.force].map(<[f64]>::to_vec));
    })
    .unwrap();
    states
}

fn times(dt: f64, end: f64) -> Vec<f64> {
    let count = (end / dt).round() as usize;
    (0..=count).map(|i| i as f64 * dt).collect()
}

/// The largest distances of steps of these lengths from the exact motion, at times of which they are parts.
fn errors<const N: usize>(method: &Method, s: &Structure, dts: [f64; N], end: f64) -> [f64; N] {
    let exact = exact(s, &times(COMMON, end));
    dts.map(|dt| {
        let (u, _, energy) = steps(method, s, dt, end);
        if *method == AVERAGE {
            assert!(energy < 1e-12, "{energy}");
        }
        let every = (COMMON / dt).round() as usize;
        let mut error: f64 = 0.0;
        for (u, [exact, ..]) in u.iter().step_by(every).zip(&exact) {
            for (computed, exact) in u.iter().zip(exact) {
                error = error.max((computed - exact).abs());
            }
        }
        error
    })
}

/// A multiple of the steps.
const COMMON: f64 = 0.1;

const WAYS: [[f64; 2]; 4] = [[1.0, 0.0], [0.0, -1.0], [0.6, 0.8], [-0.28, 0.96]];

fn limit(i: usize) -> Limit {
    Limit::constant(1.0 + 0.13 * i as f64)
}

fn varying(i: usize) -> Limit {
    Limit {
        varying: Some((0.3, Arc::new(sine(1.3 + 0.2 * i as f64)))),
        ..limit(i)
    }
}

/// Along any line the steps are those of contacts with one direction, and so is the exact motion.
#[test]
fn motion_along_a_line_is_that_of_one_direction() {
    for limit in [limit, varying] {
        let ratios = [1.5, 1.2, 2.0];
        let line = blocks(None, &ratios, limit);
        let ends = times(0.5, 9.0);
        let mut by_events = Vec::new();
        events::run(&line, &ends, |_, state| by_events.push(state.u.to_vec())).unwrap();
        // As such a contact beside laws that the motion by events does not know.
        for (alone, [adaptive, ..]) in by_events.iter().zip(&exact(&line, &ends)) {
            for (u, same) in alone.iter().zip(adaptive) {
                assert!((u - same).abs() < 1e-8, "{u} {same}");
            }
        }
        for way in WAYS {
            let plane = blocks(Some(way), &ratios, limit);
            for method in [AVERAGE, IMPULSES] {
                let [alone, both] = [&line, &plane].map(|s| steps(&method, s, 0.003, 9.0).0);
                for (alone, both) in alone.iter().zip(&both) {
                    for (i, u) in alone.iter().enumerate() {
                        let [x, y] = [both[2 * i], both[2 * i + 1]];
                        let apart = (x - u * way[0]).hypot(y - u * way[1]);
                        // Round-off of some thousand steps.
                        assert!(apart < 1e-10, "{way:?} {method:?} {apart}");
                    }
                }
            }
            let in_plane = exact(&plane, &ends);
            for (alone, [both, ..]) in by_events.iter().zip(&in_plane) {
                for (i, u) in alone.iter().enumerate() {
                    let [x, y] = [both[2 * i], both[2 * i + 1]];
                    let apart = (x - u * way[0]).hypot(y - u * way[1]);
                    // A contact stops at 1e-9 of its largest speed.
                    assert!(apart < 1e-8, "{way:?} {apart}");
                }
            }
        }
    }
}

/// A mass on unequal springs under a load that turns: it breaks loose, stops and breaks loose again.
fn turned(limit: Limit, ratio: f64) -> Structure {
    let mut s = masses(&[1.0, 1.0]);
    s.stiffness.add_spring([None, Some(0)], 20.0);
    s.stiffness.add_spring([None, Some(1)], 33.0);
    slide_in_plane(&mut s, [0, 1], two_limits(limit, ratio));
    load(&mut s, vec![(0, 1.0)], wave(3.1, 1.3, 0.0));
    load(&mut s, vec![(1, 1.0)], wave(2.6, 1.9, 0.4));
    load(&mut s, vec![(1, 1.0)], constant(-2.6 * libm::sin(0.4)));
    s
}

/// u and v by a Runge-Kutta method of order 4 of this mass with L = 1, Ls = 1.4, in steps of s with dt = |v|/(1 + |v|) ds, and by
/// bisection of |p - K u| = Ls: steps twice as long differ by 2e-13. It slides from 0.250989 to 3.833556, from 4.400096 to 5.518971 and
/// from 6.044051 on.
const BY_RUNGE_KUTTA: [[f64; 4]; 8] = [
    [
        0.140078265328,
        0.057258287465,
        0.198093533950,
        -0.061594047620,
    ],
    [
        0.123403207367,
        -0.085809389622,
        -0.127494225203,
        -0.128883858465,
    ],
    [
        -0.074171300113,
        -0.066996443317,
        -0.234070373009,
        0.159627654348,
    ],
    [-0.152588416648, 0.020658742800, 0.0, 0.0],
    [
        -0.013798276751,
        -0.049887728608,
        0.430821593202,
        -0.251761939827,
    ],
    [0.125657409267, -0.118903642868, 0.0, 0.0],
    [
        0.104074723636,
        0.038921399788,
        -0.133403652165,
        0.044437998939,
    ],
    [
        -0.110665673939,
        0.000785108220,
        -0.172471036399,
        -0.156156668620,
    ],
];

#[test]
fn the_exact_motion_is_that_of_an_independent_integration() {
    let s = turned(Limit::constant(1.0), 1.4);
    let states = exact(&s, &times(1.0, 8.0));
    for ([u, v, _], wanted) in states[1..].iter().zip(BY_RUNGE_KUTTA) {
        for (value, wanted) in u.iter().chain(v).zip(wanted) {
            // The rest of a velocity that a stop takes is 1e-9 of the largest.
            assert!((value - wanted).abs() < 1e-9, "{value} {wanted}");
        }
    }
}

/// A contact breaks loose within a step: order 1.
#[test]
fn steps_tend_to_the_exact_motion_with_order_one() {
    let mut two = blocks(Some([0.6, 0.8]), &[1.5, 1.3], varying);
    // It pulls in another direction as well.
    load(&mut two, vec![(0, 1.0), (3, -0.7)], wave(4.0, 2.1, 0.0));
    // It opens and closes while it moves, and starts with a velocity.
    let opening = Limit {
        varying: Some((1.5, Arc::new(sine(1.1)))),
        ..limit(0)
    };
    let mut launched = turned(Limit::constant(0.6), 3.0);
    launched.velocity = vec![0.7, -0.4];
    for s in [
        turned(Limit::constant(1.0), 1.4),
        turned(varying(0), 1.2),
        turned(opening, 1.3),
        launched,
        two,
    ] {
        for method in [AVERAGE, IMPULSES] {
            let errors = errors(&method, &s, [1e-2, 1e-3, 1e-4], 8.0);
            // Of displacements of about 0.3; the place in the step at which contacts break loose scatters.
            assert!(
                errors[0] < 0.05 && errors[1] < 5e-3 && errors[2] < 5e-4,
                "{method:?} {errors:?}"
            );
            assert!(errors[2] < 0.05 * errors[0], "{method:?} {errors:?}");
        }
    }
}

/// A spring whose end moves with a constant velocity: the mass slips while the force falls by 2 (Ls - L), in the time
/// 2/w (pi - atan(w (Ls - L)/(k V))).
#[test]
fn a_pulled_mass_sticks_and_slips_as_the_closed_form() {
    let (k, pace, ratio) = (9.0, 0.2, 1.7);
    for way in WAYS {
        let mut s = masses(&[1.0, 1.0]);
        s.stiffness.add_spring([None, Some(0)], k);
        s.stiffness.add_spring([None, Some(1)], k);
        slide_in_plane(&mut s, [0, 1], two_limits(Limit::constant(1.0), ratio));
        let pull = Table::new(vec![0.0, 100.0], vec![0.0, 100.0 * k * pace]).unwrap();
        load(&mut s, vec![(0, way[0]), (1, way[1])], Signal::Table(pull));
        let w = 3.0;
        let begin = ratio / (k * pace);
        let slips = 2.0 / w * (PI - libm::atan(w * (ratio - 1.0) / (k * pace)));
        let sticks = 2.0 * (ratio - 1.0) / (k * pace);
        let period = slips + sticks;
        let at = [
            0.0,
            begin - 1e-6,
            begin + slips + 1e-6,
            begin + period - 1e-6,
            begin + period + slips + 1e-6,
            begin + 4.0 * period + slips + 1e-6,
        ];
        let states = exact(&s, &at);
        for (i, (slipped, force)) in [
            (0, ratio),
            (1, 2.0 - ratio),
            (1, ratio),
            (2, 2.0 - ratio),
            (5, 2.0 - ratio),
        ]
        .into_iter()
        .enumerate()
        {
            let [u, v, forces] = &states[i + 1];
            let moved = f64::from(slipped) * pace * period;
            for axis in 0..2 {
                // 1e-6 of time before or after the event are k V 1e-6 = 1.8e-6 of force.
                assert!(
                    (forces[axis] - force * way[axis]).abs() < 2e-6,
                    "{i} {forces:?}"
                );
                assert!((u[axis] - moved * way[axis]).abs() < 1e-8, "{i} {u:?}");
                assert_eq!(v[axis], 0.0, "{i}");
            }
        }
        // Steps: the amplitude, with the force that one step adds.
        for method in [AVERAGE, IMPULSES] {
            let (_, forces, _) = steps(&method, &s, 1e-4, 4.0);
            let sizes = forces.iter().map(|force| force[0].hypot(force[1]));
            let most = sizes.fold(0.0, f64::max);
            assert!((most - ratio).abs() < 2.0 * k * pace * 1e-4, "{most}");
        }
    }
}

/// A load that grows in an oblique direction: the mass breaks loose at Ls, and goes along the load with (Ls - L)/m.
#[test]
fn it_breaks_loose_at_the_static_limit_in_every_direction() {
    for angle in [0.0, 0.3, 0.8, 1.9, 4.0] {
        let way: [f64; 2] = [libm::cos(angle), libm::sin(angle)];
        let mut s = masses(&[2.0, 2.0]);
        slide_in_plane(&mut s, [0, 1], two_limits(Limit::constant(3.0), 1.5));
        let grows = Table::new(vec![0.0, 10.0], vec![0.0, 10.0]).unwrap();
        load(&mut s, vec![(0, way[0]), (1, way[1])], Signal::Table(grows));
        // m v = (Ls - L) t + t^2/2 from t = Ls = 4.5 on.
        let states = exact(&s, &[0.0, 4.499, 5.5]);
        let [before, after] = [&states[1], &states[2]];
        let speed = (1.5 + 0.5) / 2.0;
        for axis in 0..2 {
            // Round-off of the equilibrium, twice integrated.
            assert!(before[0][axis].abs() < 1e-14);
            assert!((before[2][axis] - 4.499 * way[axis]).abs() < 1e-9);
            assert!(
                (after[1][axis] - speed * way[axis]).abs() < 1e-8,
                "{after:?}"
            );
            assert!((after[2][axis] - 3.0 * way[axis]).abs() < 1e-8, "{after:?}");
        }
    }
}

/// Friction takes energy: S . v >= 0 at all times of the exact motion, and S is at L where the contact slides and not above Ls.
#[test]
fn friction_never_creates_energy() {
    let s = turned(varying(0), 1.4);
    let at = times(0.01, 8.0);
    let limit = s.contacts[0].law.limit().unwrap().clone();
    for ([_, v, force], t) in exact(&s, &at).iter().zip(&at) {
        let power = force[0] * v[0] + force[1] * v[1];
        let (speed, size, kinetic) = (v[0].hypot(v[1]), force[0].hypot(force[1]), limit.at(*t));
        assert!(power >= 0.0, "{t} {power}");
        match speed > 1e-6 {
            true => assert!((size - kinetic).abs() < 1e-9, "{t} {size} {kinetic}"),
            false => assert!(size <= 1.4 * kinetic * (1.0 + 1e-8), "{t} {size} {kinetic}"),
        }
    }
    // Free vibrations end, at rest within the static limit, and never above the energy before.
    let mut free = turned(Limit::constant(1.0), 1.4);
    free.loads.clear();
    free.displacement = vec![0.5, -0.4];
    free.velocity = vec![1.0, 2.0];
    let energy = |u: &[f64], v: &[f64]| {
        10.0 * u[0] * u[0] + 16.5 * u[1] * u[1] + 0.5 * (v[0] * v[0] + v[1] * v[1])
    };
    let mut last = f64::INFINITY;
    let states = exact(&free, &times(0.01, 6.0));
    for [u, v, _] in &states {
        let now = energy(u, v);
        assert!(now <= last * (1.0 + 1e-12), "{now} {last}");
        last = now;
    }
    let [u, v, force] = states.last().unwrap();
    assert_eq!(v[..], [0.0, 0.0]);
    assert!((force[0] + 20.0 * u[0]).abs() < 1e-9 && (force[1] + 33.0 * u[1]).abs() < 1e-9);
}

/// Mirrored, scaled by powers of two and in another order, and beside an idle contact, the motion is the same.
#[test]
fn signs_units_and_order_do_not_matter() {
    let given = turned(Limit::constant(1.0), 1.4);
    let mut mirrored = given.clone();
    for load in &mut mirrored.loads {
        load.pattern
            .iter_mut()
            .for_each(|(_, factor)| *factor = -*factor);
    }
    let mut scaled = turned(Limit::constant(8.0), 1.4);
    for load in &mut scaled.loads {
        load.pattern
            .iter_mut()
            .for_each(|(_, factor)| *factor *= 8.0);
    }
    let mut other = masses(&[1.0, 1.0]);
    other.stiffness.add_spring([None, Some(1)], 20.0);
    other.stiffness.add_spring([None, Some(0)], 33.0);
    slide_in_plane(&mut other, [1, 0], two_limits(Limit::constant(1.0), 1.4));
    other.loads.clone_from(&given.loads);
    for load in &mut other.loads {
        load.pattern
            .iter_mut()
            .for_each(|(node, _)| *node = 1 - *node);
    }
    let mut beside = given.clone();
    slide_in_plane(&mut beside, [0, 1], displacement_control(1.0, 0.0));
    for method in [AVERAGE, IMPULSES] {
        let of = |s: &Structure| steps(&method, s, 0.003, 8.0).0;
        let cases = [&given, &mirrored, &scaled, &other, &beside].map(of);
        for (step, given) in cases[0].iter().enumerate() {
            let [mirrored, scaled, other, beside] = [1, 2, 3, 4].map(|c| &cases[c][step]);
            for i in 0..2 {
                assert_eq!(given[i], -mirrored[i], "{method:?} {step}");
                assert_eq!(8.0 * given[i], scaled[i]);
                // Other sums have other round-off.
                assert!((given[i] - other[1 - i]).abs() < 1e-11, "{method:?}");
                assert!((given[i] - beside[i]).abs() < 1e-11, "{method:?}");
            }
        }
    }
}

/// Lanes with ratios of 1 and above have the bits that they have alone, and a ratio of 1 those of a law without.
#[test]
fn lanes_with_other_ratios_do_not_meet() {
    let cases = [1.4, 1.0, 2.0, 1.05].map(|ratio| turned(Limit::constant(1.0), ratio));
    for method in [AVERAGE, IMPULSES] {
        let prepared = Prepared::by(&method, &cases[0], 0.003).unwrap();
        let [a, b, c, d] = &cases;
        let mut together = Vec::new();
        let done = run::<4>(&[a, b, c, d], &prepared, 2000, |_, state| {
            together.push([0, 1].map(|i| state.displacement(i)));
        });
        assert!(done.iter().all(Result::is_ok));
        for (l, case) in cases.iter().enumerate() {
            let mut step = 0;
            let [done] = run::<1>(&[case], &prepared, 2000, |_, state| {
                for (i, both) in together[step].iter().enumerate() {
                    let Lane([u]) = state.displacement(i);
                    assert!(u.to_bits() == both.0[l].to_bits(), "{method:?} {l} {step}");
                }
                step += 1;
            });
            done.unwrap();
        }
    }
}

/// A contact that slides and stops under a load between both limits, against it: it holds the load for ever. A load across it does not
/// stop it.
#[test]
fn a_load_between_both_limits_holds_what_stops_and_turns_what_slides() {
    let sliding = |load_way: [f64; 2]| {
        let mut s = masses(&[1.0, 1.0]);
        s.velocity = vec![0.6, 0.8];
        slide_in_plane(&mut s, [0, 1], two_limits(Limit::constant(1.0), 2.0));
        load(
            &mut s,
            vec![(0, 1.5 * load_way[0]), (1, 1.5 * load_way[1])],
            constant(1.0),
        );
        s
    };
    for method in [AVERAGE, IMPULSES] {
        let s = sliding([-0.6, -0.8]);
        let (u, forces, _) = steps(&method, &s, 0.01, 2.0);
        // v^2/(2 (1 + 1.5)).
        assert!((u[200][0].hypot(u[200][1]) - 0.2).abs() < 1e-3, "{u:?}");
        for force in &forces[60..] {
            assert!((force[0] + 0.9).abs() < 1e-9 && (force[1] + 1.2).abs() < 1e-9);
        }
        let across = sliding([-0.8, 0.6]);
        let errors = errors(&method, &across, [1e-2, 1e-3], 3.0);
        // The force is along the velocity at the end of a step: order 1, of 4.
        assert!(
            errors[0] < 1e-2 && errors[1] < 0.11 * errors[0],
            "{errors:?}"
        );
    }
    let held = exact(&sliding([-0.6, -0.8]), &[0.0, 2.0]);
    assert!((held[1][0][0] - 0.12).abs() < 1e-9 && (held[1][0][1] - 0.16).abs() < 1e-9);
}
