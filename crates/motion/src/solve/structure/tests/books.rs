//! The energy books.

use super::*;
use crate::contact::ClippedLine;
use crate::solve::structure::{Books, Prepared, run};

fn energy_error(structure: &Structure, dt: f64, steps: usize) -> f64 {
    let prepared = Prepared::new(structure, dt).unwrap();
    let mut books: Option<Books<1>> = None;
    let [done] = run::<1>(
        &[structure],
        &prepared,
        steps,
        |_, state| match &mut books {
            Some(books) => books.add(state),
            None => books = Some(Books::new(state)),
        },
    );
    done.unwrap();
    books.unwrap().energy_error().0[0]
}

#[test]
fn the_books_balance_to_round_off() {
    let ground = ground();
    for n in [1, 10] {
        for (dt, steps) in [(0.001, 5000), (1e-5, 50_000)] {
            for structure in [girders(n, 0.25, 0.5, &ground), mixed(n, 2.0, &ground)] {
                let error = energy_error(&structure, dt, steps);
                assert!(error < 1e-12, "{n} {dt} {error}");
            }
        }
    }
}

#[test]
fn the_work_of_friction_is_the_limit_times_the_way() {
    let mut structure = masses(&[1.0]);
    structure.velocity[0] = 2.0;
    structure.contacts = vec![contact(
        [None, Some(0)],
        0.0,
        displacement_control(1e4, 1.0),
    )];
    let prepared = Prepared::new(&structure, 1e-5).unwrap();
    let (mut books, mut slip): (Option<Books<1>>, f64) = (None, 0.0);
    let [done] = run::<1>(&[&structure], &prepared, 250_000, |_, state| {
        slip = slip.max(state.contact(0).slip.0[0]);
        match &mut books {
            Some(books) => books.add(state),
            None => books = Some(Books::new(state)),
        }
    });
    done.unwrap();
    let (books, state) = (books.unwrap(), slip);
    // v^2/2 = 2 is lost along 2; an elastic vibration with an energy of at most 1/(2 k) remains, and S = 0 in half of the first step.
    assert!((state - 2.0).abs() < 1e-4, "{state}");
    assert!((books.work(0).0[0] - 2.0).abs() < 1e-4);
}

#[test]
fn energies_that_overflow_are_not_numbers_and_no_energy_is_no_error() {
    use crate::methods::{AverageAcceleration, Bathe, Method, MoreauJean};
    for (v, expected) in [(-1e200, None), (0.0, Some(0.0)), (-1e150, Some(1e-12))] {
        for method in [
            Method::AverageAcceleration(AverageAcceleration),
            Method::Bathe(Bathe),
            Method::MoreauJean(MoreauJean { theta: 0.5 }),
        ] {
            let mut structure = masses(&[1.0, 2.0]);
            structure.stiffness.add_spring([None, Some(0)], 4.0);
            structure.velocity[0] = v;
            let law = StructureLaw::new(ClippedLine::Spring { stiffness: 100.0 }, None);
            structure.contacts = vec![contact([Some(1), Some(0)], 0.1, law)];
            let prepared = Prepared::by(&method, &structure, 0.01).unwrap();
            let mut books: Option<Books<1>> = None;
            let [done] = run::<1>(&[&structure], &prepared, 50, |_, state| match &mut books {
                Some(books) => books.add(state),
                None => books = Some(Books::new(state)),
            });
            // The motion itself is finite.
            done.unwrap();
            let books = books.unwrap();
            let [error, taken] = [books.energy_error(), books.relative_dissipation()];
            match expected {
                None => assert!(error.0[0].is_nan() && taken.0[0].is_nan(), "{method:?}"),
                Some(most) => {
                    assert!(
                        error.0[0] <= most && taken.0[0].is_finite(),
                        "{method:?} {error:?}"
                    );
                }
            }
        }
    }
}
