//! Many steps of many structures: every law holds at the motion that the forces leave.

use super::*;
use crate::contact::coupled::CoupledForces;
use crate::contact::coupled::tests::{Problem, Random};
use libm::{exp, expm1, pow, tanh};
use std::f64::consts::PI;

/// S as a function of r.
#[derive(Debug, Clone, Copy)]
enum Shape {
    /// clip(r/g, low, high).
    Line { g: f64, low: f64, high: f64 },
    /// -k d^n (1 + eta (v + b d)) of d = -r > 0, as of damped laws of Hertz.
    Power {
        k: f64,
        n: f64,
        eta: f64,
        v: f64,
        b: f64,
    },
    /// -k d^1.5 - c d^(1/4) (v + b d): vertical at d = 0.
    Quarter { k: f64, c: f64, v: f64, b: f64 },
    /// -(k d + c (v + b d)): jumps at d = 0.
    Viscous { k: f64, c: f64, v: f64, b: f64 },
    /// limit tanh((r - at)/width).
    Tanh { limit: f64, width: f64, at: f64 },
    /// Exponentials from `before` to the limits, with a corner at r = 0.
    Dahl { limit: f64, k: f64, before: f64 },
}

impl Shape {
    /// A law that reaches `force` over some `g force`.
    fn random(random: &mut Random, g: f64, force: f64) -> Shape {
        let limit = force.abs();
        let width = g * limit;
        let v = match random.below(4) {
            0 => 0.0,
            1 => random.even() * random.decades(2.0),
            2 => -random.decades(1.0),
            _ => random.decades(1.0),
        };
        let k = limit / pow(1.5 * width, 1.5);
        let b = random.decades(2.0) / width;
        match random.below(8) {
            0 => Shape::Line {
                g,
                low: -limit,
                high: limit,
            },
            1 => Shape::Line {
                g,
                low: f64::NEG_INFINITY,
                high: 0.0,
            },
            2 => Shape::Power {
                k,
                n: 1.5,
                eta: 0.0,
                v,
                b,
            },
            3 => Shape::Power {
                k,
                n: 1.5,
                eta: random.decades(1.0),
                v,
                b,
            },
            4 => Shape::Quarter {
                k,
                c: limit * random.decades(2.0) / pow(width, 0.25),
                v,
                b,
            },
            5 => Shape::Viscous {
                k: 1.0 / g,
                c: limit * random.decades(1.0),
                v,
                b,
            },
            6 => Shape::Tanh {
                limit,
                width,
                at: width * random.even() * random.decades(2.0),
            },
            _ => Shape::Dahl {
                limit,
                k: 1.0 / g,
                before: limit * random.even(),
            },
        }
    }

    fn force(&self, r: f64) -> f64 {
        let d = -r;
        match *self {
            Shape::Line { g, low, high } => (r / g).max(low).min(high),
            Shape::Tanh { limit, width, at } => limit * tanh((r - at) / width),
            Shape::Dahl { limit, k, before } => {
                let less = expm1(-k * r.abs() / limit);
                let way = if r > 0.0 {
                    before - limit
                } else {
                    before + limit
                };
                before + way * less
            }
            _ if d <= 0.0 => 0.0,
            Shape::Power { k, n, eta, v, b } => -k * pow(d, n) * (1.0 + eta * (v + b * d)).max(0.0),
            Shape::Quarter { k, c, v, b } => {
                -k * pow(d, 1.5) - c * pow(d, 0.25) * (v + b * d).max(0.0)
            }
            Shape::Viscous { k, c, v, b } => -(k * d + c * (v + b * d)).max(0.0),
        }
    }

    fn bounds(&self) -> [f64; 2] {
        match *self {
            Shape::Line { low, high, .. } => [low, high],
            Shape::Tanh { limit, .. } | Shape::Dahl { limit, .. } => [-limit, limit],
            Shape::Power { .. } | Shape::Quarter { .. } | Shape::Viscous { .. } => {
                [f64::NEG_INFINITY, 0.0]
            }
        }
    }

    /// S of r = y - a S by bisection.
    fn answer(&self, y: f64, a: f64) -> f64 {
        if let Shape::Line { g, low, high } = *self {
            return (y / (a + g)).max(low).min(high);
        }
        let there = y - a * self.force(y);
        let [mut low, mut high] = [there.min(y), there.max(y)];
        loop {
            let middle = 0.5 * (low + high);
            if !(low < middle && middle < high) {
                // Any r of a jump.
                let s = (y - middle) / a;
                return s.max(self.force(low)).min(self.force(high));
            }
            match middle + a * self.force(middle) > y {
                true => high = middle,
                false => low = middle,
            }
        }
    }
}

/// Laws with these flexibilities.
struct Shapes<'a>(&'a [Shape], Vec<f64>);

impl<'a> Shapes<'a> {
    fn new(shapes: &'a [Shape], forces: &CurvedForces) -> Shapes<'a> {
        let flexibilities = (0..shapes.len()).map(|i| forces.flexibility(i));
        Shapes(shapes, flexibilities.collect())
    }
}

impl Laws for Shapes<'_> {
    fn answer(&self, i: usize, y: f64) -> f64 {
        self.0[i].answer(y, self.1[i])
    }

    fn compliance(&self, i: usize, y: f64, s: f64, width: f64) -> f64 {
        if let Shape::Line { g, low, high } = self.0[i] {
            return if low < s && s < high {
                g
            } else {
                f64::INFINITY
            };
        }
        let r = y - self.1[i] * s;
        let [below, above] = [r - width, r + width].map(|r| self.0[i].force(r));
        2.0 * width / (above - below)
    }

    fn bounds(&self, i: usize) -> [f64; 2] {
        self.0[i].bounds()
    }
}

/// Whether each force is that of its law at r = d - H S, with the round-off of r: the laws rise, so S has to be between their
/// forces before and behind r.
fn assert_laws(h: &[f64], d: &[f64], size: &[f64], shapes: &[Shape], force: &[f64]) {
    let m = d.len();
    for i in 0..m {
        let row = &h[i * m..(i + 1) * m];
        let r = d[i] - row.iter().zip(force).map(|(h, s)| h * s).sum::<f64>();
        // The terms of r, and those of the other forces, which are answers to numbers with such terms.
        let terms = |j: usize| {
            let row = h[j * m..(j + 1) * m].iter().zip(force);
            size[j] + row.map(|(h, s)| (h * s).abs()).sum::<f64>()
        };
        let others = (0..m).map(|j| row[j].abs() * terms(j) / h[j * m + j]);
        let t = 1e-13 * (terms(i) + others.sum::<f64>());
        // A force of four or five rounded factors.
        let near = 1e-14 * force[i].abs();
        let [low, high] = [r - t, r + t].map(|r| shapes[i].force(r));
        assert!(
            low - near <= force[i] && force[i] <= high + near,
            "contact {i}: {low} {force:?} {high} {shapes:?} {h:?} {d:?}"
        );
    }
}

/// Ten steps each of many problems, each from the forces of the step before, which is not like it at all. Returns the number of
/// steps, the mean and the largest number of Newton's steps.
///
/// `rest`: about half of the contacts are at rest, where r* and all numbers that it is the difference of are 0.
fn solve_many(
    seed: u64,
    problems: usize,
    make: fn(&mut Random) -> Problem,
    rest: bool,
) -> (usize, f64, usize) {
    let mut random = Random(seed);
    let (mut count, mut sum, mut most) = (0, 0, 0);
    for _ in 0..problems {
        let Problem { h, g } = make(&mut random);
        let (m, h) = (g.len(), h.as_slice().to_vec());
        let mut forces = CurvedForces::new(h.clone(), m);
        let mut found = vec![0.0; m];
        for _ in 0..10 {
            let force = random.list(m, |random| random.even() * random.decades(1.0));
            let shape = |(g, force): (&f64, &f64)| Shape::random(&mut random, *g, *force);
            let shapes: Vec<Shape> = g.iter().zip(&force).map(shape).collect();
            let scale = |i: usize| {
                let terms = (0..m).map(|j| (h[i * m + j] * force[j]).abs());
                terms.sum::<f64>() + (g[i] * force[i]).abs()
            };
            // d is often the difference of numbers that are up to 1e6 times as large.
            let large = match random.below(3) {
                0 => random.decades(3.0).max(1.0) * random.decades(3.0).max(1.0),
                _ => random.unit(),
            };
            let (mut d, mut size) = (vec![0.0; m], vec![0.0; m]);
            for i in 0..m {
                let c = large * scale(i) * random.even();
                let star = c + scale(i) * random.even();
                (d[i], size[i]) = (star - c, star.abs() + c.abs());
                if rest && random.below(2) == 0 {
                    (d[i], size[i]) = (0.0, 0.0);
                }
            }
            if rest {
                found.fill(0.0);
            }
            let laws = Shapes::new(&shapes, &forces);
            match forces.solve(&d, &size, &laws, &mut found) {
                Ok(()) => assert_laws(&h, &d, &size, &shapes, &found),
                // Where several laws jump, the forces may not be unique.
                Err(Unsolved::Singular) => continue,
                error => panic!("{error:?} {shapes:?} {h:?} {d:?} {size:?}"),
            }
            count += 1;
            sum += forces.steps();
            most = most.max(forces.steps());
        }
    }
    (count, sum as f64 / count as f64, most)
}

#[test]
fn every_law_holds_in_random_steps() {
    for (seed, make) in [
        (11, Problem::dense as fn(&mut _) -> _),
        (12, Problem::chain),
    ] {
        let (count, mean, most) = solve_many(seed, 1500, make, false);
        println!("{count} {mean} {most}");
        assert!(count > 14_990 && mean < 3.0, "{count} {mean} {most}");
    }
}

#[test]
fn contacts_exactly_at_rest_obey_each_law() {
    for (seed, make) in [
        (15, Problem::dense as fn(&mut _) -> _),
        (16, Problem::chain),
    ] {
        let (count, mean, most) = solve_many(seed, 1000, make, true);
        println!("{count} {mean} {most}");
        assert!(count > 9_900 && mean < 4.0, "{count} {mean} {most}");
    }
}

/// The forces of two contacts by bisection in a bisection: for each S_1 the second contact has its own answer.
fn nested(h: [[f64; 2]; 2], d: [f64; 2], shapes: &[Shape]) -> [f64; 2] {
    let second = |first: f64| shapes[1].answer(d[1] - h[1][0] * first, h[1][1]);
    // S_1 - f(r_1) rises with S_1.
    let [mut low, mut high] = [-1e9, 1e9];
    for _ in 0..200 {
        let s = 0.5 * (low + high);
        let rest = d[0] - h[0][1] * second(s);
        match s > shapes[0].answer(rest, h[0][0]) {
            true => high = s,
            false => low = s,
        }
    }
    let first = 0.5 * (low + high);
    [first, second(first)]
}

#[test]
fn two_contacts_have_the_forces_of_a_nested_bisection() {
    let mut random = Random(13);
    for _ in 0..3000 {
        let [a, b, part] = [random.decades(2.0), random.decades(2.0), random.even()];
        let c = 0.9 * part * (a * b).sqrt();
        let h = [[a, c], [c, b]];
        let force = random.list(2, |random| random.even() * random.decades(1.0));
        let shapes = [a, b].map(|h| {
            let g = h * random.decades(2.0);
            Shape::random(&mut random, g, force[0])
        });
        let d = [a, b].map(|h| 2.0 * h * random.even());
        let mut forces = CurvedForces::new(vec![a, c, c, b], 2);
        let laws = Shapes::new(&shapes, &forces);
        let mut found = [0.0; 2];
        forces
            .solve(&d, &d.map(f64::abs), &laws, &mut found)
            .unwrap();
        let expected = nested(h, d, &shapes);
        for i in 0..2 {
            // The bisection starts from 1e9 and ends at 1e-7 times 2^-53; H has the condition 1e4 times that of 0.9.
            let scale = 1.0 + expected[i].abs();
            assert!(
                (found[i] - expected[i]).abs() < 1e-10 * scale,
                "{found:?} {expected:?} {shapes:?} {h:?} {d:?}"
            );
        }
    }
}

#[test]
fn clipped_lines_have_the_forces_of_the_other_search() {
    let mut random = Random(14);
    for _ in 0..3000 {
        let m = 1 + random.below(6);
        let problem = Problem::chain(&mut random);
        let (m, h) = (problem.g.len().min(m), problem.h.as_slice());
        let contacts = problem.g.len();
        let h: Vec<f64> = (0..m * m).map(|k| h[k / m * contacts + k % m]).collect();
        let g: Vec<f64> = (0..m).map(|i| h[i * m + i] * random.decades(3.0)).collect();
        let shapes: Vec<Shape> = (0..m)
            .map(|i| match random.below(2) {
                0 => Shape::Line {
                    g: g[i],
                    low: -1.0,
                    high: 1.0,
                },
                _ => Shape::Line {
                    g: g[i],
                    low: f64::NEG_INFINITY,
                    high: 0.0,
                },
            })
            .collect();
        let d: Vec<f64> = (0..m)
            .map(|i| 3.0 * (h[i * m + i] + g[i]) * random.even())
            .collect();
        let size: Vec<f64> = d.iter().map(|d| d.abs()).collect();
        let mut matrix = h.clone();
        for i in 0..m {
            matrix[i * m + i] += g[i];
        }
        let [low, high] = [0, 1].map(|k| Vec::from_iter(shapes.iter().map(|s| s.bounds()[k])));
        let [mut expected, mut found] = [vec![0.0; m], vec![0.0; m]];
        CoupledForces::new(matrix, m)
            .solve(&d, &low, &high, &size, &mut expected)
            .unwrap();
        let mut forces = CurvedForces::new(h, m);
        let laws = Shapes::new(&shapes, &forces);
        forces.solve(&d, &size, &laws, &mut found).unwrap();
        for i in 0..m {
            // The condition of A/diag(A) is below 1e5.
            let scale = 1.0 + expected[i].abs();
            assert!(
                (found[i] - expected[i]).abs() < 1e-9 * scale,
                "{found:?} {expected:?} {m}"
            );
        }
    }
}

#[test]
fn contacts_that_do_not_move_each_other_answer_alone() {
    let shapes = [
        Shape::Tanh {
            limit: 1.0,
            width: 0.1,
            at: 0.0,
        },
        Shape::Viscous {
            k: 2.0,
            c: 1.0,
            v: 3.0,
            b: 10.0,
        },
    ];
    for d in [[0.3, 0.1], [0.01, -1e-3], [-2.0, -4.0]] {
        let mut forces = CurvedForces::new(vec![0.5, 0.0, 0.0, 2.0], 2);
        assert_eq!([forces.flexibility(0), forces.flexibility(1)], [0.5, 2.0]);
        let laws = Shapes::new(&shapes, &forces);
        let mut force = [f64::NAN; 2];
        assert_eq!(forces.solve(&d, &[1.0; 2], &laws, &mut force), Ok(()));
        assert_eq!(
            force,
            [shapes[0].answer(d[0], 0.5), shapes[1].answer(d[1], 2.0)]
        );
        assert_eq!(forces.steps(), 0);
        assert_eq!([forces.argument(0), forces.argument(1)], d);
    }
}

#[test]
fn forces_that_are_not_unique_or_not_finite_are_errors() {
    let stick = Shape::Line {
        g: 0.0,
        low: -1.0,
        high: 1.0,
    };
    let smooth = Shape::Tanh {
        limit: 1.0,
        width: 0.1,
        at: 0.0,
    };
    let solve = |shapes: [Shape; 2], d: f64| {
        let mut forces = CurvedForces::new(vec![1.0; 4], 2);
        let laws = Shapes::new(&shapes, &forces);
        let mut force = [0.0; 2];
        forces
            .solve(&[d; 2], &[d.abs(); 2], &laws, &mut force)
            .map(|()| force)
    };
    // Two rigid contacts between the same nodes.
    assert_eq!(solve([stick; 2], 1.5), Err(Unsolved::Singular));
    assert_eq!(solve([stick; 2], 2.5), Ok([1.0; 2]));
    // Next to a rigid contact that sticks, the smooth one has r = 0.
    let [rigid, free] = solve([stick, smooth], 0.75).unwrap();
    assert!((rigid - 0.75).abs() < 1e-13 && free.abs() < 1e-13);
    for d in [f64::NAN, f64::INFINITY] {
        assert_eq!(solve([smooth; 2], d), Err(Unsolved::TooManyRounds));
    }
}

#[test]
fn a_mirrored_problem_has_mirrored_forces() {
    let h = vec![1.0, 0.4, -0.2, 0.4, 2.0, 0.3, -0.2, 0.3, 0.5];
    let shapes = |sign: f64| {
        [
            Shape::Tanh {
                limit: 2.0,
                width: 0.01,
                at: 0.3 * sign,
            },
            Shape::Dahl {
                limit: 1.0,
                k: 50.0,
                before: 0.5 * sign,
            },
            Shape::Line {
                g: 0.2,
                low: -1.0,
                high: 1.0,
            },
        ]
    };
    let solve = |sign: f64| {
        let shapes = shapes(sign);
        let mut forces = CurvedForces::new(h.clone(), 3);
        let laws = Shapes::new(&shapes, &forces);
        let mut force = [0.0; 3];
        let d = [1.3, -2.1, 0.7].map(|d| sign * d * exp(0.1) * PI);
        forces
            .solve(&d, &d.map(f64::abs), &laws, &mut force)
            .unwrap();
        force
    };
    // The same operations with other signs; chords have both ends.
    let [there, mirrored] = [solve(1.0), solve(-1.0)];
    for i in 0..3 {
        assert!((there[i] + mirrored[i]).abs() <= 1e-14 * (1.0 + there[i].abs()));
    }
}
