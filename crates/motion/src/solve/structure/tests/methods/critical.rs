//! The critical step of central differences.

use super::*;
use crate::contact::offer::Form;
use crate::contact::{ClippedLine, ContactLaw, Dahl, KelvinVoigt};
use crate::solve::Unsolvable;
use crate::solve::structure::critical_step;
use nalgebra::DMatrix;

const CENTRAL: Coefficients = Coefficients::central_difference();

/// A bar of n elements of length 1 and wave speed 1 with lumped masses.
fn bar(n: usize) -> Structure {
    let share = |i| if i == 0 || i == n { 0.5 } else { 1.0 };
    let mut structure = masses(&(0..=n).map(share).collect::<Vec<f64>>());
    for i in 0..n {
        structure.stiffness.add_spring([Some(i), Some(i + 1)], 1.0);
    }
    structure
}

fn runs(structure: &Structure, dt: f64) -> Result<(), Unsolvable> {
    let prepared = Prepared::by(&Method::Family(CENTRAL), structure, dt).unwrap();
    let [done] = run::<1>(&[structure], &prepared, 50, |_, _| ());
    done
}

#[test]
fn a_bar_has_the_step_of_one_element() {
    let mut bar = bar(20);
    bar.velocity[0] = 1.0;
    let critical = critical_step(&bar, &CENTRAL.into()).unwrap();
    // The number is on the safe side of the bisection, 60 halvings of [0, 4].
    assert!((critical - 1.0).abs() < 1e-11, "{critical}");
    assert_eq!(runs(&bar, 1.0), Ok(()));
    let why = runs(&bar, 1.0 + 1e-6).unwrap_err().to_string();
    assert!(
        why.contains("dt: must be at most 1, the critical step"),
        "{why}"
    );
}

#[test]
fn at_this_step_a_wave_moves_by_one_element_exactly() {
    // d'Alembert: the step that runs from a sudden velocity of the left end, as a force of impedance 1 for ever.
    let n = 30;
    let mut bar = bar(n);
    let table = Table::new(vec![0.0], vec![1.0]).unwrap();
    bar.loads = vec![Load {
        pattern: vec![(0, 1.0)],
        signal: Arc::new(Signal::Table(table)),
    }];
    books(&Method::Family(CENTRAL), &bar, 1.0, n, |step, state| {
        for i in 0..=n {
            let way = step as f64 - i as f64;
            let u = state.displacement(i).0[0];
            assert!((u - way.max(0.0)).abs() < 1e-12, "{step} {i} {u}");
        }
    });
}

#[test]
fn contacts_shorten_it() {
    let ground = ground();
    let structure = girders(3, 2.0, 1.0, &ground);
    let n = structure.len();
    let mut k = DMatrix::<f64>::zeros(n, n);
    for ((i, j), value) in structure.stiffness.entries() {
        (k[(i, j)], k[(j, i)]) = (value, value);
    }
    for c in &structure.contacts {
        let value = match c.law.line() {
            Some(ClippedLine::Spring { stiffness }) => stiffness,
            Some(ClippedLine::Elastic { stiffness }) => stiffness,
            _ => 0.0,
        };
        for (i, x) in &c.along {
            for (j, y) in &c.along {
                k[(*i, *j)] += x * y * value;
            }
        }
    }
    for i in 0..n {
        for j in 0..n {
            k[(i, j)] /= (structure.nodes[i].mass * structure.nodes[j].mass).sqrt();
        }
    }
    let omega = k.symmetric_eigenvalues().max().sqrt();
    let critical = critical_step(&structure, &CENTRAL.into()).unwrap();
    assert!((critical * omega / 2.0 - 1.0).abs() < 1e-11);
    assert_eq!(runs(&structure, 0.999 * critical), Ok(()));
    assert!(runs(&structure, 1.001 * critical).is_err());
    // Linear acceleration: omega dt = 2 sqrt 3.
    let linear = critical_step(&structure, &Coefficients::linear_acceleration().into()).unwrap();
    assert!((linear / critical - 3.0_f64.sqrt()).abs() < 1e-11);
    assert_eq!(
        critical_step(&structure, &Coefficients::newmark(0.25, 0.5).into()),
        None
    );
}

#[test]
fn a_rigid_impact_is_refused() {
    let mut structure = masses(&[1.0]);
    let law = StructureLaw::new(ClippedLine::Stop { restitution: 0.5 }, None);
    structure.contacts = vec![contact([None, Some(0)], 1.0, law)];
    let why = runs(&structure, 0.1).unwrap_err().to_string();
    assert!(
        why.contains("no stable step with rigid contact, such as 'contact'"),
        "{why}"
    );
}

#[test]
fn curved_laws_shorten_it_by_their_largest_stiffness() {
    // One mass of 1 on the ground: omega^2 = k, and the critical step of linear acceleration is 2 sqrt(3/k).
    let critical = |law: StructureLaw| {
        let mut structure = masses(&[1.0]);
        structure.contacts = vec![contact([None, Some(0)], 1.0, law)];
        critical_step(&structure, &Coefficients::linear_acceleration().into())
    };
    let step = |k: f64| 2.0 * (3.0 / k).sqrt();
    let (stiffness, restitution) = (64.0, 0.5);
    let law = ContactLaw::KelvinVoigt(KelvinVoigt::new(stiffness, restitution, 1.0));
    let found = critical(
        StructureLaw::new(Form::of(law).with_restitution(restitution), None).from_its_answer(),
    )
    .unwrap();
    assert!((found / step(stiffness) - 1.0).abs() < 1e-11, "{found}");
    // Dahl's law unloads from the limit with 2^exponent times its stiffness at S = 0.
    let law = ContactLaw::Dahl(Dahl {
        compliance: 1.0 / stiffness,
        limit: 2.0,
        exponent: 1.0,
    });
    let limit = Limit::constant(2.0);
    let found = critical(StructureLaw::new(law, limit).from_its_answer()).unwrap();
    assert!(
        (found / step(2.0 * stiffness) - 1.0).abs() < 1e-11,
        "{found}"
    );
}
