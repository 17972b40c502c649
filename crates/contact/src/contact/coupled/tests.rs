//! Many steps of many structures: the conditions of the minimum, all patterns one by one, other patterns at the start.

mod proximal;

use super::*;
use nalgebra::{DMatrix, DVector};
use std::array::from_fn;

/// SplitMix64.
pub(in crate::contact) struct Random(pub(in crate::contact) u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// From 0 to 1.
    pub(super) fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// From -1 to 1.
    pub(in crate::contact) fn even(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    pub(in crate::contact) fn below(&mut self, end: usize) -> usize {
        (self.bits() % end as u64) as usize
    }

    /// 10^-decades to 10^decades, evenly in its logarithm.
    pub(in crate::contact) fn decades(&mut self, decades: f64) -> f64 {
        libm::pow(10.0, decades * self.even())
    }

    pub(super) fn list(
        &mut self,
        length: usize,
        mut number: impl FnMut(&mut Random) -> f64,
    ) -> Vec<f64> {
        (0..length).map(|_| number(self)).collect()
    }

    /// Number of contacts: mostly few.
    pub(super) fn contacts(&mut self) -> usize {
        match self.below(20) {
            0 => 11 + self.below(40),
            1..5 => 6 + self.below(5),
            _ => 1 + self.below(5),
        }
    }
}

/// A = H + diag(g).
#[derive(Debug, Clone)]
pub(super) struct Problem {
    pub(super) h: DMatrix<f64>,
    pub(super) g: Vec<f64>,
}

impl Problem {
    pub(super) fn contacts(&self) -> usize {
        self.g.len()
    }

    pub(super) fn matrix(&self) -> DMatrix<f64> {
        &self.h + DMatrix::from_diagonal(&DVector::from_column_slice(&self.g))
    }

    pub(super) fn forces(&self) -> CoupledForces {
        CoupledForces::new(self.matrix().as_slice().to_vec(), self.contacts())
    }

    /// H = X X^T of a random X with fewer columns than rows or as many; g over 12 decades, or 0 if H is regular.
    pub(super) fn dense(random: &mut Random) -> Problem {
        let m = random.contacts();
        let rank = 1 + random.below(2 * m);
        let shift = [0.0, 2.0][random.below(2)];
        let mut x = DMatrix::from_fn(m, rank, |_, _| random.even() + shift * random.unit());
        for mut row in x.row_iter_mut() {
            row *= random.decades(2.0);
        }
        let h = &x * x.transpose();
        let g = (0..m).map(|i| h[(i, i)] * random.decades(6.0)).collect();
        Problem { h, g }
    }

    /// H = B^T (4/dt^2 M + 2/dt C + K)^-1 B of a chain with springs to the ground; contacts between any nodes, so that H is
    /// singular as soon as they share too many.
    pub(super) fn chain(random: &mut Random) -> Problem {
        let [n, m] = [1 + random.below(12), random.contacts()];
        let dt = random.decades(3.0);
        let mut effective = DMatrix::<f64>::zeros(n, n);
        for i in 0..n {
            effective[(i, i)] += 4.0 / (dt * dt) * random.decades(2.0);
            // The spring from the node before or from the ground, with a dashpot in proportion.
            let k = random.decades(3.0) * (1.0 + random.unit() / dt);
            effective[(i, i)] += k;
            if i > 0 && random.below(5) > 0 {
                effective[(i - 1, i - 1)] += k;
                effective[(i, i - 1)] -= k;
                effective[(i - 1, i)] -= k;
            }
        }
        let mut b = DMatrix::<f64>::zeros(n, m);
        for contact in 0..m {
            let [i, j] = [random.below(n + 1), random.below(n)];
            b[(j, contact)] += 1.0;
            if i < n && i != j {
                b[(i, contact)] -= 1.0;
            }
        }
        let moved = effective.cholesky().unwrap().solve(&b);
        let product: DMatrix<f64> = b.transpose() * moved;
        let h = (&product + product.transpose()) * 0.5;
        // A spring k, a dashpot c: 1/k, dt/(2 c).
        let drawn = random.list(m, |random| match random.below(2) {
            0 => random.decades(6.0),
            _ => 0.5 * dt * random.decades(3.0),
        });
        // Ratios of stiffness up to 1e12.
        let g = (0..m)
            .map(|i| drawn[i].clamp(1e-12 * h[(i, i)], 1e12 * h[(i, i)]))
            .collect();
        Problem { h, g }
    }
}

/// The numbers of a step.
#[derive(Debug, Clone)]
struct Numbers {
    d: Vec<f64>,
    low: Vec<f64>,
    high: Vec<f64>,
    size: Vec<f64>,
}

impl Numbers {
    /// Limits of friction, impacts, open contacts, springs, and others.
    fn limits(random: &mut Random, scale: &[f64]) -> [Vec<f64>; 2] {
        let pairs = scale.iter().map(|scale| {
            let [a, b] = from_fn(|_| scale * random.even());
            match random.below(8) {
                0..3 => [-a.abs(), a.abs()],
                3 | 4 => [f64::NEG_INFINITY, 0.0],
                5 => [0.0, 0.0],
                6 => [f64::NEG_INFINITY, f64::INFINITY],
                _ => [a.min(b), a.max(b)],
            }
        });
        let limits = Vec::from_iter(pairs);
        from_fn(|end| limits.iter().map(|limits| limits[end]).collect())
    }

    /// d = r* - c, a difference of numbers that are up to 1e6 times as large.
    fn random(random: &mut Random, problem: &Problem) -> Numbers {
        let a = problem.matrix();
        let m = problem.contacts();
        let force = random.list(m, |random| random.even() * random.decades(1.0));
        let scale = Vec::from_iter(
            (0..m).map(|i| (0..m).map(|j| (a[(i, j)] * force[j]).abs()).sum::<f64>()),
        );
        let large = random.decades(3.0).max(1.0) * random.decades(3.0).max(1.0);
        let c = Vec::from_iter(scale.iter().map(|scale| large * scale * random.even()));
        let star = Vec::from_iter((0..m).map(|i| c[i] + scale[i] * random.even()));
        let [low, high] = Numbers::limits(random, &force);
        Numbers {
            d: (0..m).map(|i| star[i] - c[i]).collect(),
            size: (0..m).map(|i| star[i].abs() + c[i].abs()).collect(),
            low,
            high,
        }
    }

    /// d = A S of forces that are at their limits, so that q is round-off everywhere; or zero, with limits of zero.
    fn tied(random: &mut Random, problem: &Problem) -> Numbers {
        let m = problem.contacts();
        let scale = random.list(m, |random| random.decades(2.0));
        let [mut low, mut high] = Numbers::limits(random, &scale);
        let mut force = Vec::from_iter((0..m).map(|i| match random.below(4) {
            0 if low[i].is_finite() => low[i],
            1 if high[i].is_finite() => high[i],
            2 => 0.0_f64.clamp(low[i], high[i]),
            _ => scale[i].clamp(low[i], high[i]),
        }));
        if m > 1 && random.below(2) == 0 {
            // d_i is a small difference of the large parts of many forces.
            let i = random.below(m);
            let j = (i + 1 + random.below(m - 1)) % m;
            let a = problem.matrix();
            let others = (0..m)
                .filter(|k| *k != j)
                .map(|k| a[(i, k)] * force[k])
                .sum::<f64>();
            if a[(i, j)] != 0.0 {
                force[j] = -others / a[(i, j)];
                [low[j], high[j]] = [low[j].min(force[j]), high[j].max(force[j])];
                [low[i], high[i]] = [force[i], force[i] + scale[i]];
            }
        }
        for i in 0..m {
            // A limit that the force has just reached, from outside or from inside.
            match random.below(6) {
                0 => low[i] = force[i],
                1 => high[i] = force[i],
                2 => [low[i], high[i]] = [force[i]; 2],
                _ => (),
            }
        }
        let product = problem.matrix() * DVector::from_column_slice(&force);
        let mut d = product.as_slice().to_vec();
        for d in &mut d {
            match random.below(6) {
                0 => *d = 0.0,
                1 => *d *= 1.0 + 1e-15 * random.even(),
                _ => (),
            }
        }
        let size = d.iter().map(|d| d.abs()).collect();
        Numbers { d, low, high, size }
    }
}

/// size_i + sum_j |A_ij| (|S_j| + size_j/A_jj): the numbers that q_i and the forces in it are differences of.
fn terms(a: &DMatrix<f64>, numbers: &Numbers, force: &[f64], i: usize) -> f64 {
    let part = |j| a[(i, j)].abs() * (force[j].abs() + numbers.size[j] / a[(j, j)]);
    numbers.size[i] + (0..force.len()).map(part).sum::<f64>()
}

/// The largest residual of the conditions of the minimum, as part of the sum of the terms of q; forces outside the box are
/// infinitely wrong.
fn residual(a: &DMatrix<f64>, numbers: &Numbers, force: &[f64]) -> f64 {
    let mut worst = 0.0_f64;
    for i in 0..force.len() {
        let [low, high] = [numbers.low[i], numbers.high[i]];
        if !(low <= force[i] && force[i] <= high) {
            return f64::INFINITY;
        }
        let q = numbers.d[i] - (0..force.len()).map(|j| a[(i, j)] * force[j]).sum::<f64>();
        let size = terms(a, numbers, force, i);
        // At low q has to be <= 0, at high >= 0, between them 0.
        let wrong = match () {
            _ if low == high => 0.0,
            _ if force[i] == low => q.max(0.0),
            _ if force[i] == high => (-q).max(0.0),
            _ => q.abs(),
        };
        if wrong > 0.0 {
            worst = worst.max(wrong / size);
        }
    }
    worst
}

/// Bound of the distance of two forces whose residuals are round-off t: for convexity, with e = S - S',
/// sum g e^2 <= e^T A e <= sum 2 t |e|, so that sum g e^2 <= sum 4 t^2/g.
fn assert_equal(problem: &Problem, numbers: &Numbers, force: &[f64], other: &[f64]) {
    let a = problem.matrix();
    let [mut distance, mut bound] = [0.0, 0.0];
    for (i, g) in problem.g.iter().enumerate() {
        let t = 1e-13 * terms(&a, numbers, force, i);
        distance += g * (force[i] - other[i]) * (force[i] - other[i]);
        bound += 4.0 * t * t / g;
    }
    assert!(
        distance <= bound,
        "{force:?} {other:?} {problem:?} {numbers:?}"
    );
}

/// The forces of the pattern, of all 3^m, with the smallest residual.
fn enumeration(problem: &Problem, numbers: &Numbers) -> Vec<f64> {
    let (a, m) = (problem.matrix(), problem.contacts());
    let mut best = (f64::INFINITY, Vec::new());
    for pattern in 0..3_usize.pow(m as u32) {
        let places = Vec::from_iter((0..m).map(|i| pattern / 3_usize.pow(i as u32) % 3));
        let free = Vec::from_iter((0..m).filter(|i| places[*i] == 2));
        let mut force =
            Vec::from_iter((0..m).map(|i| [numbers.low[i], numbers.high[i], 0.0][places[i]]));
        if force.iter().any(|s| s.is_infinite()) {
            continue;
        }
        let rest = DVector::from_column_slice(&numbers.d) - &a * DVector::from_column_slice(&force);
        let block = a.select_rows(&free).select_columns(&free);
        let solution = match free.is_empty() {
            true => Some(DVector::zeros(0)),
            false => block
                .cholesky()
                .map(|factor| factor.solve(&rest.select_rows(&free))),
        };
        let Some(solved) = solution else {
            continue;
        };
        for (i, s) in free.iter().zip(solved.iter()) {
            // A tie is in the box but for the round-off of S, which the bound of the comparison contains.
            let [low, high] = [numbers.low[*i], numbers.high[*i]];
            let near = 1e-13 * (numbers.size[*i] + rest[*i].abs()) / a[(*i, *i)];
            force[*i] = if *s < low && *s >= low - near {
                low
            } else if *s > high && *s <= high + near {
                high
            } else {
                *s
            };
        }
        let residual = residual(&a, numbers, &force);
        if residual < best.0 {
            best = (residual, force);
        }
    }
    best.1
}

/// What many steps need.
#[derive(Debug, Default)]
struct Counts {
    steps: usize,
    rounds: usize,
    most: usize,
    residual: f64,
    enumerated: usize,
}

/// Solves ten steps each of many problems, from the pattern of the step before and from a random one.
fn solve_many(
    seed: u64,
    problems: usize,
    make: fn(&mut Random) -> Problem,
    step: fn(&mut Random, &Problem) -> Numbers,
) -> Counts {
    let (mut random, mut counts) = (Random(seed), Counts::default());
    for _ in 0..problems {
        let problem = make(&mut random);
        let (a, m) = (problem.matrix(), problem.contacts());
        let mut forces = problem.forces();
        for k in 0..10 {
            let numbers = step(&mut random, &problem);
            let force = solve(&mut forces, &numbers);
            let Ok(force) = force else {
                panic!("{force:?} {problem:?} {numbers:?}");
            };
            counts.steps += 1;
            counts.rounds += forces.rounds();
            counts.most = counts.most.max(forces.rounds());
            let residual = residual(&a, &numbers, &force);
            // The round-off that the method allows for at a tie; without ties the residual is below 1e-14.
            assert!(residual <= 1e-13, "{residual:e} {problem:?} {numbers:?}");
            counts.residual = counts.residual.max(residual);

            let mut other = problem.forces();
            shuffle(&mut random, &mut other, m);
            match solve(&mut other, &numbers) {
                Ok(other) => assert_equal(&problem, &numbers, &force, &other),
                error => panic!("{error:?} {problem:?} {numbers:?}"),
            }
            if k == 0 && m <= 5 {
                assert_equal(&problem, &numbers, &force, &enumeration(&problem, &numbers));
                counts.enumerated += 1;
            }
        }
    }
    println!("{counts:?}");
    counts
}

fn solve(forces: &mut CoupledForces, numbers: &Numbers) -> Result<Vec<f64>, Unsolved> {
    let Numbers { d, low, high, size } = numbers;
    let mut force = vec![f64::NAN; d.len()];
    forces.solve(d, low, high, size, &mut force)?;
    Ok(force)
}

/// A random pattern at the start.
fn shuffle(random: &mut Random, forces: &mut CoupledForces, contacts: usize) {
    for i in 0..contacts {
        let at = [At::Low, At::Free, At::High][random.below(3)];
        forces.pattern.put(i, at);
    }
}

#[test]
fn random_steps_have_the_forces_of_the_minimum() {
    for (seed, make) in [(1, Problem::dense as fn(&mut _) -> _), (2, Problem::chain)] {
        let counts = solve_many(seed, 6000, make, Numbers::random);
        assert_eq!(counts.steps, 60_000);
        assert!(counts.enumerated > 3000);
    }
}

#[test]
fn tied_steps_have_the_forces_of_the_minimum() {
    for (seed, make) in [(3, Problem::dense as fn(&mut _) -> _), (4, Problem::chain)] {
        let counts = solve_many(seed, 2000, make, Numbers::tied);
        assert_eq!(counts.steps, 20_000);
        assert!(counts.enumerated > 1000);
    }
}

/// H = B^T M^-1 B of masses that are powers of 2, which is exact, for rigid contacts.
fn rigid(random: &mut Random) -> Problem {
    let [n, m] = [1 + random.below(4), 1 + random.below(6)];
    let mut b = DMatrix::<f64>::zeros(n, m);
    for contact in 0..m {
        let [i, j] = [random.below(n + 1), random.below(n)];
        b[(j, contact)] += 1.0;
        if i < n && i != j {
            b[(i, contact)] -= 1.0;
        }
    }
    let mass = DMatrix::from_diagonal(&DVector::from_fn(n, |_, _| {
        [0.5, 1.0, 2.0][random.below(3)]
    }));
    let h = b.transpose() * mass * b;
    Problem { h, g: vec![0.0; m] }
}

#[test]
fn rigid_contacts_have_forces_only_if_these_are_unique() {
    let mut random = Random(5);
    let [mut solved, mut dependent, mut singular] = [0; 3];
    for k in 0..20_000 {
        let problem = rigid(&mut random);
        let (a, m) = (problem.matrix(), problem.contacts());
        let numbers = match k % 2 {
            0 => Numbers::random(&mut random, &problem),
            _ => Numbers::tied(&mut random, &problem),
        };
        let mut forces = problem.forces();
        shuffle(&mut random, &mut forces, m);
        // Ranks of matrices of small integers: the least singular value that is not 0 is above 1e-3.
        let rank = |block: &DMatrix<f64>| block.clone().svd(false, false).rank(1e-9);
        let regular = rank(&a) == m;
        match solve(&mut forces, &numbers) {
            Ok(force) => {
                assert!(residual(&a, &numbers, &force) <= 1e-13);
                // Contacts that are not pressed against a limit can move; if they are regular, nothing else is a minimum.
                let can_move = (0..m).filter(|i| {
                    let q = numbers.d[*i] - (0..m).map(|j| a[(*i, j)] * force[j]).sum::<f64>();
                    let t = 1e-13 * terms(&a, &numbers, &force, *i);
                    numbers.low[*i] < numbers.high[*i] && q.abs() <= 0.5 * t
                });
                let movable = Vec::from_iter(can_move);
                let block = a.select_rows(&movable).select_columns(&movable);
                assert!(
                    movable.is_empty() || rank(&block) == movable.len(),
                    "{problem:?} {numbers:?}"
                );
                solved += 1;
                dependent += usize::from(!regular);
            }
            Err(error) => {
                assert_eq!(error, Unsolved::Singular);
                assert!(!regular, "{problem:?} {numbers:?}");
                singular += 1;
            }
        }
    }
    println!("{solved} {dependent} {singular}");
    assert!(solved > 5000 && dependent > 1000 && singular > 1000);
}

const FREE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

#[test]
fn two_contacts_between_the_same_nodes_share_a_force_only_if_they_slip() {
    let forces = |limit: f64, d: f64| {
        let mut forces = CoupledForces::new(vec![1.0; 4], 2);
        let numbers = Numbers {
            d: vec![d; 2],
            low: vec![-limit; 2],
            high: vec![limit; 2],
            size: vec![d.abs(); 2],
        };
        solve(&mut forces, &numbers)
    };
    assert_eq!(forces(0.5, 1.5), Ok(vec![0.5; 2]));
    assert_eq!(forces(0.5, -1.5), Ok(vec![-0.5; 2]));
    assert_eq!(forces(1.0, 1.5), Err(Unsolved::Singular));
    assert_eq!(forces(1.0, -0.5), Err(Unsolved::Singular));
    assert_eq!(forces(0.0, 1.5), Ok(vec![0.0; 2]));
    // Both are at their limits, but nothing presses them there: one could give way to the other only from outside.
    assert_eq!(forces(0.75, 1.5), Err(Unsolved::Singular));
}

#[test]
fn a_mass_between_two_rigid_stops_meets_one_of_them() {
    // r = u + 1 and 1 - u: H of both is singular.
    let mut forces = CoupledForces::new(vec![0.5, -0.5, -0.5, 0.5], 2);
    for u in [0.0, 2.0, -3.0, 1.5, 0.5, 2.0] {
        let numbers = Numbers {
            d: vec![u + 1.0, 1.0 - u],
            low: vec![f64::NEG_INFINITY; 2],
            high: vec![0.0; 2],
            size: vec![4.0; 2],
        };
        // S = r/h of the stop that it has passed.
        let expected = vec![2.0 * (u + 1.0_f64).min(0.0), 2.0 * (1.0 - u).min(0.0)];
        assert_eq!(solve(&mut forces, &numbers), Ok(expected), "{u}");
    }
}

#[test]
fn one_contact_has_the_clipped_quotient_exactly() {
    let mut random = Random(6);
    for _ in 0..10_000 {
        let [a, d] = [random.decades(12.0), random.even() * random.decades(12.0)];
        let limit = random.decades(6.0);
        let mut forces = CoupledForces::new(vec![a], 1);
        for [low, high] in [[-limit, limit], [f64::NEG_INFINITY, 0.0], [0.0, 0.0], FREE] {
            let mut force = [f64::NAN];
            let solved = forces.solve(&[d], &[low], &[high], &[d.abs()], &mut force);
            assert_eq!(solved, Ok(()));
            assert_eq!(force, [(d / a).max(low).min(high)]);
            assert_eq!(forces.is_free(0), low < force[0] && force[0] < high);
        }
    }
}

#[test]
fn numbers_without_an_answer_give_an_error() {
    let solve = |matrix: &[f64], d: &[f64], [low, high]: [f64; 2]| {
        let m = d.len();
        let numbers = Numbers {
            d: d.to_vec(),
            low: vec![low; m],
            high: vec![high; m],
            size: vec![1.0; m],
        };
        solve(&mut CoupledForces::new(matrix.to_vec(), m), &numbers)
    };
    assert_eq!(solve(&[], &[], FREE), Ok(Vec::new()));
    assert_eq!(solve(&[0.0], &[1.0], FREE), Err(Unsolved::Singular));
    assert_eq!(solve(&[0.0], &[0.0], [-1.0, 1.0]), Err(Unsolved::Singular));
    assert_eq!(solve(&[0.0], &[1.0], [0.0, 0.0]), Ok(vec![0.0]));
    assert_eq!(
        solve(&[1.0], &[f64::NAN], [-1.0, 1.0]),
        Err(Unsolved::TooManyRounds)
    );
    let identity = [1.0, 0.0, 0.0, 1.0];
    for bad in [f64::NAN, f64::INFINITY] {
        assert_eq!(
            solve(&identity, &[0.5, bad], FREE),
            Err(Unsolved::TooManyRounds)
        );
    }
    assert_eq!(
        solve(&identity, &[0.5, f64::NAN], [-1.0, 1.0]),
        Err(Unsolved::TooManyRounds)
    );
    assert_eq!(solve(&[0.0; 4], &[1.0, 1.0], FREE), Err(Unsolved::Singular));
    assert_eq!(solve(&[0.0; 4], &[1.0, 1.0], [0.0, 0.0]), Ok(vec![0.0; 2]));
    assert_eq!(
        solve(&[f64::NAN; 4], &[1.0, 1.0], FREE),
        Err(Unsolved::Singular)
    );
    for error in [Unsolved::Singular, Unsolved::TooManyRounds] {
        assert!(
            error.to_string().starts_with("the contact forces")
                || error.to_string().starts_with("no contact forces")
        );
    }
}

#[test]
fn the_pattern_is_kept_from_step_to_step() {
    // Two contacts that do not touch each other.
    let mut forces = CoupledForces::new(vec![2.0, 0.0, 0.0, 4.0], 2);
    let mut numbers = Numbers {
        d: vec![1.0, 8.0],
        low: vec![-1.0; 2],
        high: vec![1.0; 2],
        size: vec![8.0; 2],
    };
    assert_eq!(solve(&mut forces, &numbers), Ok(vec![0.5, 1.0]));
    assert_eq!([forces.is_free(0), forces.is_free(1)], [true, false]);
    for d in [1.0, 0.5, -1.5] {
        numbers.d[0] = d;
        assert_eq!(solve(&mut forces, &numbers), Ok(vec![0.5 * d, 1.0]));
        assert_eq!(forces.rounds(), 1);
    }
}
