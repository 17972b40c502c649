//! The closing speed of a damped impact that other contacts push together, and what is counted for contacts.

use super::*;
use crate::contact::offer::Form;
use crate::contact::{BoucWen, ClippedLine, ContactLaw, Dahl, HertzDamp};
use crate::methods::{AverageAcceleration, Bathe, Coefficients, Method, MoreauJean};
use crate::solve::structure::{Books, Prepared, run};

/// r, rdot, S and slip of all contacts at the steps, and the books.
fn motion(
    structure: &Structure,
    method: &Method,
    dt: f64,
    steps: usize,
) -> (Vec<Vec<[f64; 4]>>, Books<1>) {
    let prepared = Prepared::by(method, structure, dt).unwrap();
    let mut books: Option<Books<1>> = None;
    let mut rows = Vec::new();
    let [done] = run::<1>(&[structure], &prepared, steps, |_, state| {
        let contact = |c: usize| {
            let now = state.contact(c);
            [now.displacement, now.velocity, now.force, now.slip].map(|x| x.0[0])
        };
        rows.push((0..state.contacts()).map(contact).collect());
        match &mut books {
            Some(books) => books.add(state),
            None => books = Some(Books::new(state)),
        }
    });
    done.unwrap();
    (rows, books.unwrap())
}

/// v0 that the law of a damped Hertz contact had, F = k delta^1.5 (1 + kappa ddelta/v0), from its state.
fn closing_speed(law: &HertzDamp, [r, rdot, s, _]: [f64; 4]) -> f64 {
    let elastic = law.stiffness * libm::pow(-r, 1.5);
    law.damping * -rdot / (-s / elastic - 1.0)
}

#[test]
fn a_contact_that_another_one_pushes_together_has_the_speed_that_closes_its_gap() {
    // A fast body 0 strikes body 1, which is at rest before the wall: within the step body 1 overlaps the wall, though it would not
    // without the forces of the step. The mean speed that closes the gap of 0.02 in dt = 0.01 is 2.
    let law = HertzDamp::new(1e4, 0.5);
    let damped = StructureLaw::new(
        Form::of(ContactLaw::HertzDamp(law)).with_restitution(0.5),
        None,
    )
    .from_its_answer();
    let mut structure = masses(&[1.0, 0.01]);
    structure.velocity[0] = 10.0;
    structure.contacts = vec![
        contact([Some(1), None], 0.02, damped.clone()),
        contact(
            [Some(0), Some(1)],
            0.0,
            StructureLaw::new(ClippedLine::Spring { stiffness: 1e4 }, None),
        ),
    ];
    let dt = 0.01;
    let (rows, _) = motion(
        &structure,
        &Method::AverageAcceleration(AverageAcceleration),
        dt,
        1,
    );
    let state = rows[1][0];
    assert!(state[0] < -1e-3 && state[2] < 0.0, "{state:?}");
    let v0 = closing_speed(&law, state);
    // 1e-12 of a gap: the law sees an overlap that is just one.
    assert!((v0 / 2.0 - 1.0).abs() < 1e-10, "{v0}");

    // Body 1 closes with 3 > 2, while a load of 50 pulls it back by 50 dt^2/0.01/2 = 0.25 > 3 dt, and it is struck.
    structure.velocity = vec![40.0, 3.0];
    let times = vec![0.0, 1.0];
    structure.loads = vec![Load {
        pattern: vec![(1, -1.0)],
        signal: Arc::new(Signal::Table(Table::new(times, vec![50.0; 2]).unwrap())),
    }];
    let (rows, _) = motion(
        &structure,
        &Method::AverageAcceleration(AverageAcceleration),
        dt,
        1,
    );
    let state = rows[1][0];
    assert!(state[0] < -1e-3 && state[2] < 0.0, "{state:?}");
    let v0 = closing_speed(&law, state);
    assert!((v0 / 3.0 - 1.0).abs() < 1e-10, "{v0}");
}

#[test]
fn energies_are_relative_to_the_largest_one_with_that_of_the_contacts() {
    // Without sliding a friction spring is a spring, and so is an impact spring that stays shut: the same motion, and the same
    // numerical dissipation over the largest energy. A constant load of 1 from rest on k = 4, and a start with u = -1.
    let method = Method::Family(Coefficients::hht(-0.2));
    let load = |force: f64| Load {
        pattern: vec![(0, 1.0)],
        signal: Arc::new(Signal::Table(
            Table::new(vec![0.0, 1.0], vec![force; 2]).unwrap(),
        )),
    };
    for (u, force, law) in [
        (0.0, 1.0, displacement_control(4.0, 1e9)),
        (
            -1.0,
            -9.0,
            StructureLaw::new(ClippedLine::Spring { stiffness: 4.0 }, None),
        ),
        (
            -1.0,
            -1.5,
            StructureLaw::new(ClippedLine::Spring { stiffness: 4.0 }, None),
        ),
    ] {
        let mut by_contact = masses(&[1.0]);
        by_contact.displacement[0] = u;
        by_contact.loads = vec![load(force)];
        let mut by_spring = by_contact.clone();
        by_spring.stiffness.add(0, 0, 4.0);
        by_contact.contacts = vec![contact([None, Some(0)], 0.0, law)];
        let relative = [by_contact, by_spring].map(|structure| {
            let (_, books) = motion(&structure, &method, 0.05, 20);
            let dissipation = books.numerical_dissipation().0[0];
            [dissipation, books.relative_dissipation().0[0]]
        });
        let [[whole, part], [all_of_spring, part_of_spring]] = relative;
        // Work and energy of the contact are the same but for sums of 20 steps.
        assert!((whole - all_of_spring).abs() < 1e-13, "{relative:?}");
        assert!(part_of_spring > 1e-5, "{relative:?}");
        assert!(
            (part / part_of_spring - 1.0).abs() < 1e-10,
            "{u} {relative:?}"
        );
    }
}

#[test]
fn slip_is_r_but_for_displacement_control_by_every_method() {
    let (compliance, limit) = (0.1, 1.0);
    let laws = [
        ContactLaw::BoucWen(BoucWen {
            compliance,
            limit,
            exponent: 2.0,
            beta: 0.5,
        }),
        ContactLaw::Dahl(Dahl {
            compliance,
            limit,
            exponent: 1.0,
        }),
    ];
    for method in [
        Method::AverageAcceleration(AverageAcceleration),
        Method::Family(Coefficients::hht(-0.2)),
        Method::MoreauJean(MoreauJean { theta: 0.5 }),
        Method::Bathe(Bathe),
    ] {
        let mut structure = masses(&[1.0]);
        structure.velocity[0] = 1.0;
        let curved =
            laws.map(|law| StructureLaw::new(law, Limit::constant(limit)).from_its_answer());
        let lines = [displacement_control(10.0, 1.0), velocity_control(3.0, 1.0)];
        let laws = curved.into_iter().chain(lines);
        structure.contacts = laws.map(|law| contact([None, Some(0)], 0.0, law)).collect();
        let (rows, _) = motion(&structure, &method, 0.01, 30);
        for (i, row) in rows.iter().enumerate() {
            for (c, [r, _, s, slip]) in row.iter().enumerate() {
                let expected = if c == 2 { r - s / 10.0 } else { *r };
                assert!((slip - expected).abs() < 1e-15, "{method:?} {i} {c}");
            }
        }
        assert!(rows[30][2][2] > 0.1, "{:?}", rows[30]);
    }
}
