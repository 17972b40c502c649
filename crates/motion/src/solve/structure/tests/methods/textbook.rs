//! The printed forms of the methods with full matrices, and all patterns of the contacts.

use super::super::dense::{all_patterns, full};
use super::*;
use crate::contact::ClippedLine;
use nalgebra::{DMatrix, DVector};

/// A structure with full matrices.
struct Dense<'a> {
    structure: &'a Structure,
    m: DMatrix<f64>,
    k: DMatrix<f64>,
    c: DMatrix<f64>,
    b: DMatrix<f64>,
    u: DVector<f64>,
    v: DVector<f64>,
    a: DVector<f64>,
    s: DVector<f64>,
}

/// matrix x' = right - s1 B S' with u' = x' and v' = by_u u' + rest; a' from both.
struct Equation {
    matrix: DMatrix<f64>,
    right: DVector<f64>,
    s1: f64,
    by_u: f64,
    rest: DVector<f64>,
}

impl Dense<'_> {
    fn new(structure: &Structure) -> Dense<'_> {
        let (n, count) = (structure.len(), structure.contacts.len());
        let masses = structure.nodes.iter().map(|node| node.mass);
        let mut b = DMatrix::zeros(n, count);
        for c in 0..count {
            for (node, sign) in structure.column(c) {
                b[(node, c)] = sign;
            }
        }
        Dense {
            structure,
            m: DMatrix::from_diagonal(&DVector::from_iterator(n, masses)),
            k: full(&structure.stiffness),
            c: full(&structure.damping),
            b,
            u: DVector::from_column_slice(&structure.displacement),
            v: DVector::from_column_slice(&structure.velocity),
            a: DVector::zeros(n),
            s: DVector::zeros(count),
        }
    }

    fn loads(&self, t: f64) -> DVector<f64> {
        let mut p = DVector::zeros(self.structure.len());
        self.structure.add_loads(t, p.as_mut_slice());
        p
    }

    fn balance(&self, t: f64) -> DVector<f64> {
        let force = self.loads(t) - &self.c * &self.v - &self.k * &self.u - &self.b * &self.s;
        self.m.clone().lu().solve(&force).unwrap()
    }

    fn gaps(&self) -> DVector<f64> {
        let gaps = self.structure.contacts.iter().map(|c| c.gap);
        DVector::from_iterator(self.s.len(), gaps)
    }

    fn bounds(&self, t: f64) -> [DVector<f64>; 2] {
        let of = |k: usize| {
            let bound = |c: &Contact| match c.law.limit() {
                Some(limit) => [-limit.at(t), limit.at(t)][k],
                None => [f64::NEG_INFINITY, 0.0][k],
            };
            DVector::from_iterator(self.s.len(), self.structure.contacts.iter().map(bound))
        };
        [of(0), of(1)]
    }

    /// Solves a step in displacements.
    fn solve(&mut self, t: f64, equation: Equation) {
        let Equation {
            matrix,
            right,
            s1,
            by_u,
            rest,
        } = equation;
        let lu = matrix.lu();
        let free = lu.solve(&right).unwrap();
        let d = lu.solve(&(&self.b * s1)).unwrap();
        let bt = self.b.transpose();
        let gaps = self.gaps();
        let (r, rest_of) = (&bt * &self.u + &gaps, &bt * &rest);
        let count = self.s.len();
        let (mut g, mut center) = (DVector::zeros(count), DVector::zeros(count));
        for (i, contact) in self.structure.contacts.iter().enumerate() {
            // rdot = by_u (r - gap) + rest.
            let still = gaps[i] - rest_of[i] / by_u;
            (g[i], center[i]) = match contact.law.line() {
                None => unreachable!(),
                Some(ClippedLine::Spring { stiffness }) => (1.0 / stiffness, 0.0),
                Some(ClippedLine::Stop { .. }) => (0.0, 0.0),
                Some(ClippedLine::Elastic { stiffness }) => {
                    (1.0 / stiffness, r[i] - self.s[i] / stiffness)
                }
                Some(ClippedLine::Viscous { viscosity }) => (1.0 / (viscosity * by_u), still),
                Some(ClippedLine::Coulomb) => (0.0, still),
            };
        }
        let [low, high] = self.bounds(t);
        let a = &bt * &d + DMatrix::from_diagonal(&g);
        self.s = all_patterns(&a, &(&bt * &free + gaps - center), &low, &high);
        self.u = free - d * &self.s;
        self.v = &self.u * by_u + rest;
    }

    /// Newmark's family in displacements, beta > 0: a' = (u' - u - dt v)/(beta dt^2) - (1/(2 beta) - 1) a.
    fn family(&mut self, of: &Coefficients, t: f64, dt: f64) {
        let Coefficients {
            alpha_m,
            alpha_f,
            beta,
            gamma,
        } = *of;
        let (m, f) = (1.0 - alpha_m, 1.0 - alpha_f);
        let (a0, a1) = (1.0 / (beta * dt * dt), gamma / (beta * dt));
        let (u, v, a) = (self.u.clone(), self.v.clone(), self.a.clone());
        let known_a = -(&u * a0) - &v / (beta * dt) - &a * (0.5 / beta - 1.0);
        let known_v = &v + (&a * (1.0 - gamma) + &known_a * gamma) * dt;
        let right = self.loads(t) * f + self.loads(t - dt) * alpha_f
            - &self.m * (&known_a * m + &a * alpha_m)
            - &self.c * (&known_v * f + &v * alpha_f)
            - &self.k * &u * alpha_f
            - &self.b * &self.s * alpha_f;
        let matrix = &self.m * (m * a0) + &self.c * (f * a1) + &self.k * f;
        self.solve(
            t,
            Equation {
                matrix,
                right,
                s1: f,
                by_u: a1,
                rest: known_v,
            },
        );
        self.a = &self.u * a0 + known_a;
    }

    /// Bathe and Baig (2005), equations in displacements.
    fn bathe(&mut self, t: f64, dt: f64) {
        let (u, v) = (self.u.clone(), self.v.clone());
        let trapezoidal = Coefficients::newmark(0.25, 0.5);
        self.family(&trapezoidal, t - 0.5 * dt, 0.5 * dt);
        let (um, vm) = (self.u.clone(), self.v.clone());
        let rest = (&u - &um * 4.0) / dt;
        let known_a = (&v - &vm * 4.0) / dt + &rest * (3.0 / dt);
        let right = self.loads(t) - &self.m * &known_a - &self.c * &rest;
        let matrix = &self.m * (9.0 / (dt * dt)) + &self.c * (3.0 / dt) + &self.k;
        self.solve(
            t,
            Equation {
                matrix,
                right,
                s1: 1.0,
                by_u: 3.0 / dt,
                rest,
            },
        );
        self.a = &self.u * (9.0 / (dt * dt)) + known_a;
    }

    /// Moreau and Jean's method in velocities. Stops are active whose gap, predicted for the middle of the step, is not positive.
    fn moreau_jean(&mut self, theta: f64, t: f64, dt: f64) {
        let (u, v) = (self.u.clone(), self.v.clone());
        let (bt, count) = (self.b.transpose(), self.s.len());
        let matrix = &self.m + &self.c * (theta * dt) + &self.k * (theta * theta * dt * dt);
        let lu = matrix.lu();
        let force = self.loads(t) * theta + self.loads(t - dt) * (1.0 - theta)
            - &self.c * &v
            - &self.k * (&u + &v * (theta * dt));
        let free = &v + lu.solve(&(force * dt)).unwrap();
        let d = lu.solve(&(&self.b * dt)).unwrap();
        let (r, rdot) = (&bt * &u + self.gaps(), &bt * &v);
        let still = (&r + &rdot * ((1.0 - theta) * dt)) / (theta * dt);
        let (mut g, mut center) = (DVector::zeros(count), DVector::zeros(count));
        for (i, contact) in self.structure.contacts.iter().enumerate() {
            (g[i], center[i]) = match contact.law.line() {
                None => unreachable!(),
                Some(ClippedLine::Spring { stiffness }) => {
                    (1.0 / (stiffness * theta * dt), -still[i])
                }
                Some(ClippedLine::Elastic { stiffness }) => {
                    let g = 1.0 / (stiffness * theta * dt);
                    (g, (r[i] / (theta * dt) - still[i]) - self.s[i] * g)
                }
                Some(ClippedLine::Viscous { viscosity }) => (1.0 / viscosity, 0.0),
                Some(ClippedLine::Coulomb) => (0.0, 0.0),
                Some(ClippedLine::Stop { restitution }) => (0.0, -restitution * rdot[i]),
            };
        }
        let [mut low, high] = self.bounds(t);
        for (i, contact) in self.structure.contacts.iter().enumerate() {
            if contact.law.is_stop() {
                let active = r[i] + 0.5 * dt * rdot[i] <= 0.0;
                low[i] = if active { f64::NEG_INFINITY } else { 0.0 };
            }
        }
        let a = &bt * &d + DMatrix::from_diagonal(&g);
        self.s = all_patterns(&a, &(&bt * &free - &center), &low, &high);
        self.v = &free - &d * &self.s;
        self.u = &u + (&v * (1.0 - theta) + &self.v * theta) * dt;
    }

    /// The contact-stabilised method in displacements: rigid stops move u first, in the norm of M, until none overlaps.
    fn contact_stabilized(&mut self, t: f64, dt: f64) {
        let bt = self.b.transpose();
        let push = self.m.clone().lu().solve(&self.b).unwrap() * (dt * dt);
        let overlaps = &bt * (&self.u + &self.v * dt) + self.gaps();
        let none = DVector::zeros(self.s.len());
        let mut low = none.clone();
        for (i, contact) in self.structure.contacts.iter().enumerate() {
            if contact.law.is_stop() {
                low[i] = f64::NEG_INFINITY;
            }
        }
        let lambda = all_patterns(&(&bt * &push), &overlaps, &low, &none);
        let (u, v) = (self.u.clone(), self.v.clone());
        let moved = &u - push * lambda;
        let load = (self.loads(t) + self.loads(t - dt)) * 0.5;
        let known = &self.m * (&moved * (2.0 / (dt * dt)) + &v * (2.0 / dt));
        self.solve(
            t,
            Equation {
                matrix: &self.m * (2.0 / (dt * dt)) + &self.c / dt + &self.k * 0.5,
                right: load + known + &self.c * &moved / dt - &self.k * &u * 0.5,
                s1: 1.0,
                by_u: 2.0 / dt,
                rest: &moved * (-2.0 / dt) - &v,
            },
        );
    }

    /// Central differences of displacements at three times; `last` is u(i-1). Gives u(i+1), and v(i) and S(i) become those of i.
    fn central(&mut self, last: &DVector<f64>, t: f64, dt: f64) -> DVector<f64> {
        let bt = self.b.transpose();
        let count = self.s.len();
        let matrix = &self.m / (dt * dt) + &self.c / (2.0 * dt);
        let lu = matrix.lu();
        let right = self.loads(t) - &self.k * &self.u
            + &self.m * (&self.u * 2.0 - last) / (dt * dt)
            + &self.c * last / (2.0 * dt);
        let free = lu.solve(&right).unwrap();
        let d = lu.solve(&self.b).unwrap();
        let r = &bt * &self.u + self.gaps();
        let before = &bt * last + self.gaps();
        let [mut low, mut high] = self.bounds(t);
        let mut g = DVector::zeros(count);
        for (i, contact) in self.structure.contacts.iter().enumerate() {
            let unclipped = match contact.law.line() {
                None => unreachable!(),
                Some(ClippedLine::Spring { stiffness }) => stiffness * r[i],
                Some(ClippedLine::Elastic { stiffness }) => {
                    self.s[i] + stiffness * (r[i] - before[i])
                }
                Some(ClippedLine::Viscous { viscosity }) => {
                    g[i] = 2.0 * dt / viscosity;
                    continue;
                }
                _ => continue,
            };
            let known = unclipped.clamp(low[i], high[i]);
            (low[i], high[i]) = (known, known);
        }
        // 2 dt rdot = r(i+1) - r(i-1).
        let a = &bt * &d + DMatrix::from_diagonal(&g);
        self.s = all_patterns(&a, &(&bt * (&free - last)), &low, &high);
        let next = free - d * &self.s;
        self.v = (&next - last) / (2.0 * dt);
        next
    }
}

/// SplitMix64, between 0 and 1.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// Six masses with springs and dashpots between any of them, four contacts, a moving limit and two loads.
fn random(seed: u64, rigid: bool) -> Structure {
    let mut random = Random(seed);
    let n = 6;
    let masses: Vec<f64> = (0..n).map(|_| random.between(0.5, 2.0)).collect();
    let mut structure = super::masses(&masses);
    for i in 0..n {
        for j in [None, Some((i + 1) % n), Some((i + 3) % n)] {
            let (k, c) = (random.between(0.0, 30.0), random.between(0.0, 0.5));
            structure.stiffness.add_spring([Some(i), j], k);
            structure.damping.add_spring([Some(i), j], c);
        }
        structure.displacement[i] = random.between(-0.1, 0.1);
        structure.velocity[i] = random.between(-1.0, 1.0);
    }
    let sine = |omega: f64, phase: f64| {
        Arc::new(Signal::Sine {
            amplitude: 1.0,
            omega,
            phase,
        })
    };
    for nodes in [[0, 3], [2, 5]] {
        let pattern = nodes.map(|i| (i, random.between(-20.0, 20.0)));
        structure.loads.push(Load {
            pattern: pattern.to_vec(),
            signal: sine(random.between(1.0, 6.0), random.between(0.0, 3.0)),
        });
    }
    let limit = Limit {
        constant: random.between(0.5, 2.0),
        varying: Some((1.5, sine(random.between(1.0, 5.0), 0.0))),
        ..Limit::constant(0.0)
    };
    let impact = match rigid {
        true => StructureLaw::new(
            ClippedLine::Stop {
                restitution: random.next(),
            },
            None,
        ),
        false => StructureLaw::new(
            ClippedLine::Spring {
                stiffness: random.between(50.0, 500.0),
            },
            None,
        ),
    };
    let stiffness = random.between(20.0, 200.0);
    structure.contacts = vec![
        contact([Some(0), Some(2)], 0.2, impact.clone()),
        contact(
            [Some(1), Some(4)],
            0.0,
            StructureLaw::new(ClippedLine::Elastic { stiffness }, limit),
        ),
        contact(
            [None, Some(3)],
            0.0,
            velocity_control(random.between(1.0, 9.0), 1.0),
        ),
        contact([Some(4), None], 0.2, impact),
    ];
    if rigid {
        let limit = Limit::constant(random.between(0.5, 2.0));
        structure.contacts[2].law = StructureLaw::new(ClippedLine::Coulomb, limit);
    }
    structure
}

/// Compares two motions: the largest difference of u, v and S over the largest value of each.
#[derive(Default)]
struct Comparison {
    worst: [f64; 3],
    size: [f64; 3],
}

impl Comparison {
    fn add(&mut self, state: &State<1>, [u, v, s]: [&DVector<f64>; 3]) {
        let mut compare = |k: usize, a: f64, b: f64| {
            self.worst[k] = self.worst[k].max((a - b).abs());
            self.size[k] = self.size[k].max(b.abs());
        };
        for node in 0..state.nodes() {
            compare(0, state.displacement(node).0[0], u[node]);
            compare(1, state.velocity(node).0[0], v[node]);
        }
        for c in 0..state.contacts() {
            compare(2, contact_of(state, c)[2], s[c]);
        }
    }

    fn relative(&self) -> f64 {
        let relative = self.worst.iter().zip(self.size).map(|(x, size)| x / size);
        relative.fold(0.0, f64::max)
    }
}

#[test]
fn the_textbook_forms_move_alike() {
    let dt = 0.05;
    for (name, method) in methods() {
        let mut worst = [0.0_f64; 2];
        for seed in 0..12 {
            // These two have a critical step, which is 0 for a rigid impact.
            let conditional = ["linear-acceleration", "central-difference"].contains(&name);
            let rigid = seed % 3 == 0 && !conditional;
            let structure = random(seed, rigid);
            let mut dense = Dense::new(&structure);
            let mut comparison = Comparison::default();
            // Central differences need u(-1), and know v and S one step later.
            let mut last = dense.u.clone();
            let mut next = dense.u.clone();
            let steps = if rigid { 60 } else { 150 };
            books(&method, &structure, dt, steps, |step, state| {
                let t = step as f64 * dt;
                if step == 0 {
                    let forces = (0..state.contacts()).map(|c| contact_of(state, c)[2]);
                    dense.s = DVector::from_iterator(dense.s.len(), forces);
                    dense.a = dense.balance(0.0);
                    last = &dense.u - &dense.v * dt + &dense.a * (0.5 * dt * dt);
                    if name == "central-difference" {
                        next = &dense.u + &dense.v * dt + &dense.a * (0.5 * dt * dt);
                    }
                    return;
                }
                match &method {
                    Method::Family(of) if of.beta == 0.0 => {
                        last = std::mem::replace(&mut dense.u, next.clone());
                        next = dense.central(&last, t, dt);
                    }
                    Method::Family(of) => dense.family(of, t, dt),
                    Method::Bathe(Bathe) => dense.bathe(t, dt),
                    Method::MoreauJean(MoreauJean { theta }) => dense.moreau_jean(*theta, t, dt),
                    Method::ContactStabilized(ContactStabilized) => {
                        dense.contact_stabilized(t, dt);
                    }
                    Method::AverageAcceleration(AverageAcceleration) => unreachable!(),
                }
                comparison.add(state, [&dense.u, &dense.v, &dense.s]);
            });
            let worst = &mut worst[usize::from(rigid)];
            *worst = worst.max(comparison.relative());
        }
        // The textbook forms divide by dt^2. Without compliance S is an acceleration, and its round-off grows from impact to
        // impact.
        assert!(worst[0] < 1e-12 && worst[1] < 1e-5, "{name} {worst:?}");
    }
}
