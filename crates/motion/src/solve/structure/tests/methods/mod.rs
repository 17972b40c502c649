//! The other methods.

mod between_steps;
mod blocks;
mod critical;
mod dampers;
mod energy;
mod impulses;
mod order;
mod textbook;
mod two_forms;
mod vibration;

use super::*;
use crate::methods::{
    AverageAcceleration, Bathe, Coefficients, ContactStabilized, Method, MoreauJean,
};
use crate::solve::structure::{Books, Prepared, State, run};

/// Every method but constant average acceleration, with its name.
fn methods() -> [(&'static str, Method); 9] {
    let family = Method::Family;
    [
        (
            "linear-acceleration",
            family(Coefficients::linear_acceleration()),
        ),
        ("newmark", family(Coefficients::newmark(0.3025, 0.6))),
        ("hht", family(Coefficients::hht(-0.2))),
        (
            "generalized-alpha",
            family(Coefficients::generalized_alpha(0.7)),
        ),
        ("bathe", Method::Bathe(Bathe)),
        (
            "central-difference",
            family(Coefficients::central_difference()),
        ),
        ("moreau-jean", Method::MoreauJean(MoreauJean { theta: 0.5 })),
        (
            "moreau-jean 0.7",
            Method::MoreauJean(MoreauJean { theta: 0.7 }),
        ),
        (
            "contact-stabilized-newmark",
            Method::ContactStabilized(ContactStabilized),
        ),
    ]
}

/// Steps a structure; returns its books.
fn books(
    method: &Method,
    structure: &Structure,
    dt: f64,
    steps: usize,
    mut visit: impl FnMut(usize, &State<1>),
) -> Books<1> {
    let prepared = Prepared::by(method, structure, dt).unwrap();
    let mut books: Option<Books<1>> = None;
    let [done] = run::<1>(&[structure], &prepared, steps, |step, state| {
        visit(step, state);
        match &mut books {
            Some(books) => books.add(state),
            None => books = Some(Books::new(state)),
        }
    });
    done.unwrap();
    books.unwrap()
}

/// r, rdot, S of a contact.
fn contact_of(state: &State<1>, contact: usize) -> [f64; 3] {
    let now = state.contact(contact);
    [now.displacement, now.velocity, now.force].map(|x| x.0[0])
}
