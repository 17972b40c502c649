use super::fixed_interface_modes::{lowest, stage};
use super::held::Held;
use super::*;
use crate::system::import::Dofs;
use crate::system::structure::{Direction, Symmetric};
use nalgebra::{DVector, SymmetricEigen};

/// Matrices with rows n1.x, n2.x and so on.
fn imported(mass: Symmetric, stiffness: Symmetric, damping: Option<Symmetric>) -> Arc<Imported> {
    let rows = (1..=mass.size()).map(|i| format!("n{i},x\n"));
    let text = format!("node,direction\n{}", rows.collect::<String>());
    Arc::new(Imported {
        dofs: Dofs::parse(text.as_bytes()).unwrap().into(),
        mass: mass.into(),
        stiffness: stiffness.into(),
        is_negative: false,
        damping: damping.map(Into::into),
    })
}

fn diagonal(numbers: impl ExactSizeIterator<Item = f64>) -> Symmetric {
    let mut matrix = Symmetric::zeros(numbers.len());
    for (i, x) in numbers.enumerate() {
        matrix.add(i, i, x);
    }
    matrix
}

/// A chain between two walls: masses 1, springs 1. Some masses may be 0.
fn chain(masses: &[f64]) -> (Symmetric, Symmetric) {
    let n = masses.len();
    let mut k = Symmetric::zeros(n);
    k.add_spring([None, Some(0)], 1.0);
    for i in 1..n {
        k.add_spring([Some(i - 1), Some(i)], 1.0);
    }
    k.add_spring([Some(n - 1), None], 1.0);
    (diagonal(masses.iter().copied()), k)
}

/// 4 sin^2(j pi/(2 (n + 1))), j = 1..n: the squares of the frequencies of such a chain.
fn of_chain(n: usize) -> impl Iterator<Item = f64> {
    (1..=n).map(move |j| 4.0 * (j as f64 * PI / (2.0 * (n + 1) as f64)).sin().powi(2))
}

/// The largest relative difference of the first computed numbers from those in rising order.
fn difference(of: &Held, wanted: usize, mut exact: Vec<f64>) -> f64 {
    exact.sort_by(f64::total_cmp);
    let modes = lowest(of, wanted).unwrap();
    assert!(modes.len() >= wanted);
    let pairs = modes.iter().zip(&exact).take(wanted);
    let errors = pairs.map(|(mode, exact)| (mode.omega2 / exact - 1.0).abs());
    errors.fold(0.0, f64::max)
}

#[test]
fn double_frequencies_of_a_square_net_are_found() {
    // Frequencies of a net are sums of those of chains: (i, j) and (j, i) are alike.
    let n = 30;
    let mut k = Symmetric::zeros(n * n);
    let at = |i: usize, j: usize| {
        (1..=n)
            .contains(&i)
            .then(|| {
                (1..=n)
                    .contains(&j)
                    .then_some(())
                    .map(|()| (i - 1) * n + j - 1)
            })
            .flatten()
    };
    for i in 0..=n {
        for j in 1..=n {
            k.add_spring([at(i, j), at(i + 1, j)], 1.0);
            k.add_spring([at(j, i), at(j, i + 1)], 1.0);
        }
    }
    let net = imported(diagonal(vec![1.0; n * n].into_iter()), k, None);
    let held = Held::new(&net, &[]).unwrap();
    let exact: Vec<f64> = of_chain(n)
        .flat_map(|a| of_chain(n).map(move |b| a + b))
        .collect();
    for wanted in [16, 64] {
        // Round-off of a condition of 400.
        assert!(difference(&held, wanted, exact.clone()) < 1e-11);
    }
}

#[test]
fn ten_equal_chains_have_each_frequency_ten_times() {
    let (chains, n) = (10, 100);
    let mut k = Symmetric::zeros(chains * n);
    let (_, one) = chain(&vec![1.0; n]);
    for chain in 0..chains {
        for ((i, j), x) in one.entries() {
            k.add(chain * n + i, chain * n + j, x);
        }
    }
    let chains_model = imported(diagonal(vec![1.0; chains * n].into_iter()), k, None);
    let held = Held::new(&chains_model, &[]).unwrap();
    let exact: Vec<f64> = of_chain(n).flat_map(|a| [a; 10]).collect();
    // Round-off of a condition of 4000.
    assert!(difference(&held, 64, exact) < 1e-11);
}

#[test]
fn copies_of_a_mode_beyond_the_start_vectors_are_searched() {
    // Forty equal chains have their first frequency forty times. Four start vectors contain four copies of each mode, so that the first
    // 16 modes to converge are those of four frequencies.
    let (chains, n) = (40, 20);
    let mut k = Symmetric::zeros(chains * n);
    let (_, one) = chain(&vec![1.0; n]);
    for chain in 0..chains {
        for ((i, j), x) in one.entries() {
            k.add(chain * n + i, chain * n + j, x);
        }
    }
    let chains_model = imported(diagonal(vec![1.0; chains * n].into_iter()), k, None);
    let held = Held::new(&chains_model, &[]).unwrap();
    let exact: Vec<f64> = of_chain(n).flat_map(|a| [a; 40]).collect();
    // Round-off of a condition of 200.
    assert!(difference(&held, 16, exact) < 1e-11);
}

#[test]
fn the_modes_of_large_and_small_structures_solve_the_same_equation() {
    // Rows without mass follow: masses 0 between masses of 1, two springs in series.
    let n = 401;
    let masses: Vec<f64> = (0..n).map(|i| f64::from(u8::from(i % 2 == 1))).collect();
    let (m, k) = chain(&masses);
    let held = Held::new(&imported(m, k, None), &[]).unwrap();
    let exact: Vec<f64> = of_chain(n / 2).map(|x| x / 2.0).collect();
    let large = lanczos::lowest(&held, 32).unwrap();
    let small = dense::all_modes(&held).unwrap();
    assert_eq!((large.len(), small.len()), (32, n / 2));
    for ((large, small), exact) in large.iter().zip(&small).zip(exact) {
        // Round-off of a condition of 16000; that of full matrices is of the largest number.
        assert!((large.omega2 / exact - 1.0).abs() < 1e-11);
        assert!((small.omega2 - exact).abs() < 1e-12);
        let sign = (large.shape[1] * small.shape[1]).signum();
        let pairs = large.shape.iter().zip(&small.shape);
        let error = pairs.fold(0.0, |error: f64, (a, b)| error.max((a - sign * b).abs()));
        // Shapes of size 0.1; round-off over the distance of the frequencies.
        assert!(error < 1e-9, "{error}");
    }
}

#[test]
fn static_displacements_need_no_modes() {
    // Row 20 has no mass.
    let mut masses = vec![1.0; 40];
    masses[20] = 0.0;
    masses[30] = 0.0;
    let (m, k) = chain(&masses);
    let inverse = k.full().try_inverse().unwrap();
    let reduction = Reduction::new(imported(m, k, None), vec![5, 20, 39]);
    for modes in [0, 3, 37] {
        let reduced = reduction.reduced(Wanted::Modes(modes)).unwrap();
        assert_eq!(reduced.len(), 3 + modes.min(36));
        let flexibility = reduced.stiffness().full().try_inverse().unwrap();
        for (i, row) in [5, 20, 39].into_iter().enumerate() {
            for (j, column) in [5, 20, 39].into_iter().enumerate() {
                // Flexibilities up to 10, a condition of 700.
                assert!((flexibility[(i, j)] - inverse[(row, column)]).abs() < 1e-12);
            }
        }
        // Forces of 1 on all rows.
        let forces = DVector::from_vec(reduced.forces(Direction::X));
        let (computed, exact) = (flexibility * forces, &inverse * DVector::repeat(40, 1.0));
        for (i, row) in [5, 20, 39].into_iter().enumerate() {
            // Displacements up to 210.
            assert!((computed[i] - exact[row]).abs() < 1e-11);
        }
    }
}

#[test]
fn all_modes_are_the_whole_model() {
    let mut masses: Vec<f64> = (0..30).map(|i| 1.0 + 0.1 * f64::from(i)).collect();
    (masses[11], masses[20]) = (0.0, 0.0);
    let (mut m, k) = chain(&masses);
    m.add(4, 3, 0.3);
    m.add(28, 29, -0.2);
    let mut c = Symmetric::zeros(30);
    c.add_spring([Some(3), Some(9)], 0.2);
    c.add_spring([Some(29), None], 0.5);
    let whole = imported(m.clone(), k.clone(), Some(c.clone()));
    let reduction = Reduction::new(whole, vec![3, 20, 29]);
    let reduced = reduction.reduced(Wanted::Modes(100)).unwrap();
    assert_eq!(
        (reduced.modes(), reduced.all_modes(), reduced.len()),
        (26, 26, 29)
    );
    assert_eq!(reduced.frequencies()[1], None);
    // The answer of the kept rows to forces of frequency omega on them: (K + i omega C - omega^2 M)^-1, here with s = i omega real.
    let answer = |m: &Symmetric, c: &Symmetric, k: &Symmetric, s: f64| {
        (k.full() + c.full() * s + m.full() * (s * s))
            .try_inverse()
            .unwrap()
    };
    let [own_m, own_c, own_k] = [
        reduced.mass(),
        reduced.damping().unwrap(),
        reduced.stiffness(),
    ];
    for s in [0.0, 0.1, 1.0, 5.0] {
        let (computed, exact) = (answer(&own_m, &own_c, &own_k, s), answer(&m, &c, &k, s));
        for (i, row) in [3, 20, 29].into_iter().enumerate() {
            for (j, column) in [3, 20, 29].into_iter().enumerate() {
                // Up to 8, a condition of 1000.
                assert!((computed[(i, j)] - exact[(row, column)]).abs() < 1e-12);
            }
        }
        // The same for the acceleration of the ground.
        let mut inertia = vec![0.0; 30];
        m.add_product(&[1.0; 30], &mut inertia);
        let (computed, exact) = (
            computed * DVector::from_vec(reduced.inertia(Direction::X)),
            exact * DVector::from_vec(inertia),
        );
        for (i, row) in [3, 20, 29].into_iter().enumerate() {
            // Up to 300.
            assert!(
                (computed[i] - exact[row]).abs() < 1e-11,
                "{} {}",
                computed[i],
                exact[row]
            );
        }
    }
}

#[test]
fn a_start_is_the_same_motion_with_all_modes() {
    let masses: Vec<f64> = (0..20).map(|i| 1.0 + 0.1 * f64::from(i)).collect();
    let (m, k) = chain(&masses);
    let reduction = Reduction::new(imported(m.clone(), k.clone(), None), vec![0, 7]);
    let reduced = reduction.reduced(Wanted::Modes(20)).unwrap();
    let mut u = vec![0.5; 20];
    (u[0], u[7]) = (-1.0, 0.25);
    let mut q = vec![-1.0, 0.25];
    q.extend(reduced.modal(&q, &[(Direction::X, 0.5)]));
    // Energies, and momentum against the ground: quadratic forms and products of the whole motion.
    let form = |matrix: &Symmetric, u: &[f64]| {
        let mut product = vec![0.0; u.len()];
        matrix.add_product(u, &mut product);
        product.iter().zip(u).map(|(a, b)| a * b).sum::<f64>()
    };
    // Energies up to 25.
    assert!((form(&m, &u) - form(&reduced.mass(), &q)).abs() < 1e-12);
    assert!((form(&k, &u) - form(&reduced.stiffness(), &q)).abs() < 1e-12);
}

#[test]
fn modes_up_to_a_frequency_are_counted() {
    let (m, k) = chain(&vec![1.0; 1000]);
    let whole = imported(m, k, None);
    let reduction = Reduction::new(whole.clone(), vec![0]);
    // The rest is a chain of 999; the 70th frequency is below, the 71st above.
    let omegas: Vec<f64> = of_chain(999).map(f64::sqrt).collect();
    let limit = (omegas[69] + omegas[70]) / (4.0 * PI);
    let reduced = reduction.reduced(Wanted::UpTo(limit)).unwrap();
    assert_eq!(reduced.modes(), 70);
    let [last, next] = reduced
        .frequencies()
        .map(|frequency| frequency.unwrap() * 2.0 * PI);
    // Round-off of a condition of 4e5.
    assert!((last / omegas[69] - 1.0).abs() < 1e-10 && (next / omegas[70] - 1.0).abs() < 1e-10);
    // Nothing depends on what was computed before.
    let few = reduction.reduced(Wanted::Modes(5)).unwrap();
    let fresh = Reduction::new(whole, vec![0])
        .reduced(Wanted::Modes(5))
        .unwrap();
    assert_eq!(
        (few.mass(), few.stiffness()),
        (fresh.mass(), fresh.stiffness())
    );
    assert_eq!(
        (stage(5, 999), stage(16, 999), stage(700, 999)),
        (16, 32, 999)
    );
}

#[test]
fn a_part_that_nothing_holds_has_no_reduction() {
    // Two chains that are free: one row of the first is kept.
    let mut k = Symmetric::zeros(60);
    for i in (1..60).filter(|i| *i != 30) {
        k.add_spring([Some(i - 1), Some(i)], 0.7);
    }
    let whole = imported(diagonal(vec![1.0; 60].into_iter()), k, None);
    let fault = Reduction::new(whole.clone(), vec![3]).reduced(Wanted::Modes(2));
    let ReductionFault::Unheld { row } = fault.unwrap_err() else {
        panic!();
    };
    let row: usize = row
        .trim_start_matches('n')
        .trim_end_matches(".x")
        .parse()
        .unwrap();
    assert!(row > 30);
    let reduced = Reduction::new(whole, vec![3, 50])
        .reduced(Wanted::Modes(2))
        .unwrap();
    // Both move freely: K has two zeros, in its first two rows.
    let eigen = SymmetricEigen::new(reduced.stiffness().full());
    // Round-off of stiffnesses of 1.
    assert_eq!(
        eigen.eigenvalues.iter().filter(|x| x.abs() < 1e-12).count(),
        2
    );
}

#[test]
fn a_free_part_is_refused_whatever_its_round_off_is() {
    // The last pivot of a free chain is round-off, of either sign.
    let mut random = 1_u64;
    let mut number = || {
        random = random
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        0.1 + (random >> 40) as f64 / f64::from(1_u32 << 24)
    };
    for _ in 0..200 {
        let mut k = Symmetric::zeros(12);
        for i in (1..12).filter(|i| *i != 4) {
            k.add_spring([Some(i - 1), Some(i)], number());
        }
        let whole = imported(diagonal(vec![1.0; 12].into_iter()), k, None);
        let fault = Reduction::new(whole, vec![2]).reduced(Wanted::Modes(2));
        assert!(matches!(fault, Err(ReductionFault::Unheld { .. })));
    }
}

#[test]
fn supports_without_mass_hold_the_rows_between_them() {
    // A chain of 10 masses between two supports, whose rows have no mass. They are the only ones that hold it.
    let n = 12;
    let mut k = Symmetric::zeros(n);
    for i in 1..n {
        k.add_spring([Some(i - 1), Some(i)], 1.0);
    }
    let mut masses = vec![1.0; n];
    (masses[0], masses[n - 1]) = (0.0, 0.0);
    let rows = (1..=n).map(|i| {
        let support = if i == 1 || i == n { "s" } else { "" };
        format!("n{i},x,{support}\n")
    });
    let text = format!("node,direction,support\n{}", rows.collect::<String>());
    let whole = Arc::new(Imported {
        dofs: Dofs::parse(text.as_bytes()).unwrap().into(),
        mass: Arc::new(diagonal(masses.into_iter())),
        stiffness: Arc::new(k),
        is_negative: false,
        damping: None,
    });
    let kept = vec![0, 4, n - 1];
    let reduction = Reduction::new(whole, kept);
    let reduced = reduction.reduced(Wanted::Modes(100)).unwrap();
    // Nine free masses beside the kept one.
    assert_eq!((reduced.len(), reduced.modes()), (12, 9));
    // Displacements of 1 of both supports move all rows by 1, without force.
    let full = reduced.stiffness().full();
    let force = &full * DVector::from_fn(12, |i, _| if i < 3 { 1.0 } else { 0.0 });
    // Round-off of stiffnesses of 1.
    assert!(force.iter().all(|x| x.abs() < 1e-14), "{force}");
    // A displacement of one of them moves row 4 by a straight line of 11 springs: 7/11 and 4/11.
    for (column, share) in [(0, 7.0 / 11.0), (2, 4.0 / 11.0)] {
        let moved = -full[(1, column)] / full[(1, 1)];
        assert!((moved - share).abs() < 1e-14, "{moved} {share}");
    }
}
