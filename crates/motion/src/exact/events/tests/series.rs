//! The polynomials of one piece satisfy the equations of motion at every time in it, written here for the displacements against a
//! fixed point: M u'' = p - K u - C v - B S with the support as a node of known motion.

use super::*;
use crate::contact::ClippedLine;
use crate::exact::events::coordinates::model::{LONGEST, Model};
use crate::exact::events::numerics::cholesky::Cholesky;
use crate::exact::events::numerics::factor::Factor;
use crate::exact::events::numerics::row::Row;
use crate::exact::events::phases::contact_phase::Phase;
use crate::exact::events::phases::contact_state::ContactState;
use crate::exact::events::pieces::series::Series;
use crate::system::structure::{Baseline, Motion};

const MASSES: [f64; 3] = [1.0, 2.0, 0.5];

/// Springs and dampers between nodes; node 3 is the support.
const SPRINGS: [(usize, usize, f64); 3] = [(3, 0, 30.0), (0, 1, 12.0), (1, 2, 7.0)];
const DAMPERS: [(usize, usize, f64); 3] = [(3, 1, 1.3), (1, 2, 0.4), (3, 0, 0.2)];

/// From node 1 to the ground, which holds it where the support moves.
const GROUND: f64 = 9.0;

const SUPPORT: [f64; 3] = [3.0, 2.2, 0.7];
const LOAD: [f64; 3] = [1.5, 3.1, 0.2];
const LIMIT: [f64; 5] = [0.8, 0.6, 0.5, 1.9, 0.4];
const STIFFNESS: f64 = 40.0;
const VISCOSITY: f64 = 2.5;
const GAP: f64 = -0.02;

/// u, v and a of the support, which starts at rest.
fn support(t: f64) -> [f64; 3] {
    let [amplitude, omega, phase] = SUPPORT;
    let (now, first) = (omega * t + phase, phase);
    let v = amplitude / omega * (first.cos() - now.cos());
    let drift = amplitude / omega * first.cos() * t;
    let u = drift - amplitude / (omega * omega) * (now.sin() - first.sin());
    [u, v, amplitude * now.sin()]
}

fn structure() -> Structure {
    let motion = Motion::new(
        &sine(SUPPORT[0], SUPPORT[1], SUPPORT[2]),
        1.0,
        0.0,
        Baseline::None,
    );
    let mut s = masses(&MASSES);
    s.coupled_mass = Symmetric::zeros(4);
    [s.stiffness, s.damping] = [SPRINGS, DAMPERS].map(|entries| {
        let mut matrix = Symmetric::zeros(4);
        for (i, j, k) in entries {
            matrix.add_spring([Some(i), Some(j)], k);
        }
        matrix
    });
    s.stiffness.add_spring([None, Some(1)], GROUND);
    let limit = Limit {
        varying: Some((LIMIT[1], Arc::new(sine(LIMIT[2], LIMIT[3], LIMIT[4])))),
        ..Limit::constant(LIMIT[0])
    };
    let mut s = s
        .load(&[(0, 1.0)], sine(LOAD[0], LOAD[1], LOAD[2]))
        .load(&[(1, 2.0)], table(&[[0.0, 1.0], [3.0, -0.5]]))
        .contact(
            [Some(3), Some(0)],
            GAP,
            StructureLaw::new(
                ClippedLine::Spring {
                    stiffness: STIFFNESS,
                },
                None,
            ),
        )
        .contact(
            [Some(0), Some(1)],
            0.0,
            StructureLaw::new(
                ClippedLine::Viscous {
                    viscosity: VISCOSITY,
                },
                Limit::constant(9.0),
            ),
        )
        .contact(
            [Some(3), Some(1)],
            0.0,
            StructureLaw::new(ClippedLine::Coulomb, limit),
        )
        .contact([Some(3), Some(2)], 0.0, coulomb(5.0));
    s.prescribe(vec![("s".into(), Arc::new(motion.unwrap()))]);
    s
}

fn at(polynomial: &[f64], s: f64) -> f64 {
    polynomial
        .iter()
        .rev()
        .fold(0.0, |sum, term| sum * s + term)
}

/// The derivative by time.
fn derivative(polynomial: &[f64], length: f64) -> Vec<f64> {
    let terms = polynomial.iter().enumerate().skip(1);
    terms.map(|(k, term)| k as f64 * term / length).collect()
}

#[test]
fn a_piece_satisfies_the_equations_of_motion() {
    let structure = structure();
    let model = Model::of_nodes(&structure);
    let phases = [
        Phase::Closed,
        Phase::Closed,
        Phase::Sliding(-1.0),
        Phase::Closed,
    ];
    let states = phases.map(ContactState::in_phase);
    let length = model.piece_length(&states);
    let start = 0.31;
    let [us, vs, _] = support(start);
    let mut series = Series::new(&model);
    let (w, v) = ([-0.1, 0.05, 0.2], [0.3, -0.7, 0.4]);
    series.begin(&model, [start, length, LONGEST], [&w, &v]);
    // Contact 3 sticks: b^T M^-1 b = 1/m.
    let factor = Factor::Symmetric(Cholesky::new(vec![1.0 / MASSES[2]], 1).unwrap());
    series.complete(&model, &states, (&[3], &factor));
    let nodes: Vec<_> = (0..3)
        .map(|i| series.combine(&Row::Sparse(vec![(i, 1.0)])))
        .collect();
    let carried = &structure.supports[0].carried;
    for s in [0.0, 0.1, 0.37, 0.72, 1.0] {
        let t = start + s * length;
        let ground = support(t);
        // u, v and a of the nodes and of the support.
        let mut motion = vec![];
        for (i, polynomial) in nodes.iter().enumerate() {
            let rate = derivative(polynomial, length);
            let second = derivative(&rate, length);
            let of_node = [at(polynomial, s), at(&rate, s), at(&second, s)];
            motion.push([0, 1, 2].map(|q| of_node[q] + carried[i] * ground[q]));
        }
        motion.push(ground);
        let force = |i: usize| at(&series.contacts[i].force, s);
        let [sine_load, sine_limit] = [LOAD, [LIMIT[2], LIMIT[3], LIMIT[4]]]
            .map(|[amplitude, omega, phase]| amplitude * (omega * t + phase).sin());
        let expected = [
            STIFFNESS * (motion[0][0] - ground[0] + GAP),
            VISCOSITY * (motion[1][1] - motion[0][1]),
            -(LIMIT[0] + LIMIT[1] * sine_limit),
        ];
        // Forces up to 40, and round-off of sums of 26 terms.
        for (i, expected) in expected.into_iter().enumerate() {
            assert!(
                (force(i) - expected).abs() < 1e-12,
                "{s} {i}: {} {expected}",
                force(i)
            );
        }
        // It sticks to the support: the difference of the velocities stays.
        let stuck = motion[2][1] - ground[1] - (v[2] + (carried[2] - 1.0) * vs);
        assert!(stuck.abs() < 1e-13, "{s} {stuck}");
        let mut sums = [0.0; 4];
        sums[0] += sine_load;
        sums[1] += 2.0 * (1.0 - 0.5 * t) - GROUND * motion[1][0];
        for (entries, quantity) in [(SPRINGS, 0), (DAMPERS, 1)] {
            for (i, j, k) in entries {
                let pull = k * (motion[j][quantity] - motion[i][quantity]);
                sums[i] += pull;
                sums[j] -= pull;
            }
        }
        for (contact, [i, j]) in [[3, 0], [0, 1], [3, 1], [3, 2]].into_iter().enumerate() {
            sums[i] += force(contact);
            sums[j] -= force(contact);
        }
        for (i, mass) in MASSES.into_iter().enumerate() {
            let residual = mass * motion[i][2] - sums[i];
            // Terms of u'' up to the order 21 times 22, over the length squared, of forces up to 40.
            assert!(residual.abs() < 1e-11, "{s} {i}: {residual}");
        }
        let r = series.contacts[0].r;
        assert!((at(&r, s) - (motion[0][0] - ground[0] + GAP)).abs() < 1e-14);
        let rate = at(&series.rate(0), s);
        assert!((rate - (motion[0][1] - ground[1])).abs() < 1e-13);
        let (mut u, mut v) = ([0.0; 3], [0.0; 3]);
        series.motion_at(s, &mut u, &mut v);
        for i in 0..3 {
            assert!((u[i] + carried[i] * ground[0] - motion[i][0]).abs() < 1e-14);
            assert!((v[i] + carried[i] * ground[1] - motion[i][1]).abs() < 1e-13);
        }
    }
    assert!((series.contacts[0].r[0] - (w[0] + (carried[0] - 1.0) * us + GAP)).abs() < 1e-15);
}
