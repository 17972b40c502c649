//! A law of a user's program moves a structure as the same law of slipgap does.

#[path = "../../examples/own_law.rs"]
mod example;

use example::{LAW, RATIO, mass_on};
use slipgap_solver::laws::{Bilinear, KelvinVoigt, Tanh};
use slipgap_solver::{
    AverageAcceleration, Bathe, Contact, ContactKind, ContactLaw, Direction, Limit, Method, Node,
    Own, OwnAnswer, OwnFault, OwnLaw, OwnState, OwnStep, Signal, Solution, Structure, StructureLaw,
    Unsolvable, exact, run,
};

fn own() -> ContactLaw {
    ContactLaw::Own(Own::new(&LAW))
}

fn bilinear() -> ContactLaw {
    ContactLaw::Bilinear(Bilinear {
        stiffness: LAW.stiffness,
        yield_force: LAW.limit,
        hardening: RATIO * LAW.stiffness,
    })
}

fn moved(law: ContactLaw, method: Method, dt: f64, steps: usize) -> Solution {
    run(&mass_on(law), &method, dt, steps).unwrap()
}

/// The largest difference of two lists.
fn difference(a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    let both = a.iter().flatten().zip(b.iter().flatten());
    both.fold(0.0, |most, (a, b)| f64::max(most, (a - b).abs()))
}

#[test]
fn an_own_law_steps_as_the_same_law_of_the_list() {
    for method in [AverageAcceleration.into(), Bathe.into()] {
        let [a, b] = [own(), bilinear()].map(|law| moved(law, method, 0.01, 1000));
        // The root of the own law is found to its last bits, and 1000 steps carry their round-off on.
        assert!(difference(&a.displacement, &b.displacement) < 1e-12);
        assert!(difference(&a.force, &b.force) < 1e-11);
        // It yields: after some cycles the mass swings about another place.
        assert!(a.force.iter().any(|s| s[0] > 1.1));
    }
}

/// F = k d + c dd/dt of an overlap d = -r, or 0 if that is negative.
#[derive(Debug)]
struct Bumper;

impl OwnLaw for Bumper {
    fn answer(&self, step: &OwnStep, state: &OwnState) -> OwnAnswer {
        let [r, rdot] = step.to;
        let force = (BUMPER.stiffness * r + BUMPER.damping * rdot).min(0.0);
        let pushes = r < 0.0 && force < 0.0;
        let slopes = [BUMPER.stiffness, BUMPER.damping];
        OwnAnswer {
            force: if pushes { force } else { 0.0 },
            slopes: if pushes { slopes } else { [0.0; 2] },
            state: *state,
        }
    }

    fn kind(&self) -> ContactKind {
        ContactKind::Impact
    }

    fn largest_stiffness(&self) -> f64 {
        BUMPER.stiffness
    }
}

const BUMPER: KelvinVoigt = KelvinVoigt {
    stiffness: 40.0,
    damping: 1.0,
};

/// Friction, limit times tanh(rdot/w).
#[derive(Debug)]
struct Smooth;

/// w for the limit that the test begins with.
const WIDTH: f64 = 0.2;

impl OwnLaw for Smooth {
    fn answer(&self, step: &OwnStep, state: &OwnState) -> OwnAnswer {
        let width = WIDTH * step.limit;
        let t = (step.to[1] / width).tanh();
        OwnAnswer {
            force: step.limit * t,
            slopes: [0.0, step.limit * (1.0 - t * t) / width],
            state: *state,
        }
    }

    fn kind(&self) -> ContactKind {
        ContactKind::Friction
    }

    fn largest_stiffness(&self) -> f64 {
        0.0
    }
}

#[test]
fn own_impacts_and_own_friction_step_as_the_same_laws_of_the_list() {
    static SMOOTH: Smooth = Smooth;
    static SOFT: Bumper = Bumper;
    let smooth = Tanh {
        compliance: WIDTH,
        limit: 1.0,
        ratio: 1.0,
        rate: 0.0,
    };
    // The normal force swings.
    let sine = Signal::Sine {
        amplitude: 0.5,
        omega: 3.0,
        phase: 0.0,
    };
    let limit = Limit {
        varying: Some((1.0, sine.into())),
        ..Limit::constant(1.0)
    };
    let moved = |law: ContactLaw, method: &Method| {
        let impact = law.kind() == ContactKind::Impact;
        let mut mass = mass_on(law);
        mass.contacts[0].law = StructureLaw::new(law, limit.clone());
        mass.stiffness.add_spring([Some(0), None], 4.0);
        mass.contacts[0].gap = if impact { 0.1 } else { 0.0 };
        run(&mass, method, 0.01, 1000).unwrap()
    };
    for (own_law, of_the_list) in [
        (Own::new(&SOFT), ContactLaw::KelvinVoigt(BUMPER)),
        (Own::new(&SMOOTH), ContactLaw::Tanh(smooth)),
    ] {
        for method in [AverageAcceleration.into(), Bathe.into()] {
            let [a, b] = [ContactLaw::Own(own_law), of_the_list].map(|law| moved(law, &method));
            assert!(
                difference(&a.displacement, &b.displacement) < 1e-12,
                "{own_law:?}"
            );
            assert!(difference(&a.force, &b.force) < 1e-10, "{own_law:?}");
            assert!(a.force.iter().any(|s| s[0].abs() > 0.5), "{own_law:?}");
        }
    }
}

#[test]
fn the_steps_of_an_own_law_converge_to_the_exact_motion_of_the_same_law() {
    let error = |steps: usize| {
        let dt = 4.0 / steps as f64;
        let motion = moved(own(), AverageAcceleration.into(), dt, steps);
        let exact = exact(&mass_on(bilinear()), &motion.time).unwrap();
        difference(&motion.displacement, &exact.displacement)
    };
    let errors = [400, 800, 1600].map(error);
    // Second order but for the steps in which the spring begins to yield, which are between 3 and 5 times better for half the step.
    for pair in errors.windows(2) {
        let ratio = pair[0] / pair[1];
        assert!((2.5..6.0).contains(&ratio), "{errors:?}");
    }
    assert!(errors[2] < 1e-5, "{errors:?}");
}

#[test]
fn an_own_law_has_no_exact_motion_and_says_so() {
    let why = exact(&mass_on(own()), &[1.0]).unwrap_err();
    assert!(matches!(why, Unsolvable::Reference(_)));
    let text = why.to_string();
    assert!(
        text.contains("spring") && text.contains("user's program"),
        "{text}"
    );
}

/// S = k r up to r = 1/2, and from there with this slope; or what else an answer may be.
#[derive(Debug)]
struct Odd(&'static str);

impl OwnLaw for Odd {
    fn answer(&self, step: &OwnStep, state: &OwnState) -> OwnAnswer {
        let r = step.to[0];
        let bent = |slope: f64| r.signum() * (2.0 + slope * (r.abs() - 0.5));
        let late = |other: f64| if r > 0.5 { other } else { 4.0 * r };
        let force = match self.0 {
            "softens" if r.abs() > 0.5 => bent(-3.0),
            "falls" => -1e6 * r,
            "nan" => late(f64::NAN),
            "nan at once" => f64::NAN,
            "infinite" => late(f64::INFINITY),
            "friction" => 50.0 * step.to[1],
            "open impact" => 4.0 * (r - 1.0),
            "varies" => {
                CALLS.with(|calls| calls.set(calls.get() + 1));
                4.0 * r + CALLS.with(std::cell::Cell::get) as f64
            }
            _ => 4.0 * r,
        };
        let slope = match self.0 {
            "steep" => 1e300,
            "flat" => 0.0,
            "negative" => -1e9,
            "no slope" => f64::NAN,
            _ => 4.0,
        };
        let failure = if self.0 == "lost" { f64::NAN } else { 0.0 };
        OwnAnswer {
            force,
            slopes: [slope, 0.0],
            state: [state[0] + failure; 8],
        }
    }

    fn kind(&self) -> ContactKind {
        match self.0 {
            "friction" => ContactKind::Friction,
            "pulls" | "open impact" => ContactKind::Impact,
            _ => ContactKind::Link,
        }
    }

    fn largest_stiffness(&self) -> f64 {
        4.0
    }
}

thread_local! {
    static CALLS: std::cell::Cell<u32> = const { std::cell::Cell::new(0) };
}

/// One mass, or two with such a contact between them, too.
fn odd(name: &'static str, masses: usize, dt: f64) -> Result<Solution, Unsolvable> {
    let law: &'static Odd = Box::leak(Box::new(Odd(name)));
    let limit = (name == "friction").then(|| Limit::constant(1.0));
    let law = StructureLaw::new(ContactLaw::Own(Own::new(law)), limit);
    let node = |i: usize| Node {
        name: format!("m{i}"),
        mass: 1.0,
        direction: Direction::X,
    };
    let mut structure = Structure::new((0..masses).map(node).collect());
    for i in 0..masses {
        structure.stiffness.add_spring([None, Some(i)], 1.0);
        let before = i.checked_sub(1).map(|before| (before, -1.0));
        let along = before.into_iter().chain([(i, 1.0)]).collect();
        let (name, law) = (format!("c{i}"), law.clone());
        structure.contacts.push(Contact {
            name,
            along,
            gap: 0.0,
            law,
        });
    }
    structure.velocity[0] = 2.0;
    run(
        &structure,
        &AverageAcceleration.into(),
        dt,
        (4.0 / dt) as usize,
    )
}

#[test]
fn the_force_of_an_own_law_is_its_answer_or_the_step_is_refused() {
    use OwnFault::{BeyondLimit, NoAnswer, NotFinite, NotPure, Pulls};
    for (name, expected) in [
        ("falls", NoAnswer),
        ("nan", NotFinite),
        ("nan at once", NotFinite),
        ("infinite", NotFinite),
        ("lost", NotFinite),
        ("friction", BeyondLimit),
        ("pulls", Pulls),
        ("open impact", Pulls),
        ("varies", NotPure),
    ] {
        for masses in [1, 2] {
            match odd(name, masses, 0.01) {
                Err(Unsolvable::OwnLaw { step, contact, why }) => {
                    assert_eq!((why, contact.as_str()), (expected, "c0"), "{name}");
                    let first = ["nan", "infinite", "falls"].contains(&name);
                    assert!(if first { step > 0 } else { step <= 1 }, "{name}");
                }
                other => panic!("{name}: {other:?}"),
            }
        }
    }
    // A law that falls less than a step has inertia has one root: the forces are the law's to round-off.
    for dt in [0.01, 0.1] {
        for masses in [1, 2] {
            let motion = odd("softens", masses, dt).unwrap();
            let law = Odd("softens");
            let mut most = 0.0;
            for (r, s) in motion.opening.iter().zip(&motion.force) {
                let to = [r[0], 0.0];
                let step = OwnStep {
                    from: to,
                    to,
                    dt,
                    limit: 0.0,
                };
                let force = law.answer(&step, &OwnState::default()).force;
                // The search for the forces of two contacts ends at 1e-12 of them.
                assert!((force - s[0]).abs() < 1e-11, "{force} {}", s[0]);
                most = f64::max(most, r[0].abs());
            }
            assert!(most > 0.6);
        }
    }
}

#[test]
fn slopes_do_not_change_the_root() {
    for masses in [1, 2] {
        let right = odd("", masses, 0.01).unwrap();
        for name in ["steep", "flat", "negative", "no slope"] {
            let moved_by_own = odd(name, masses, 0.01).unwrap();
            // Bisection ends at round-off of S, which 400 steps carry on.
            assert!(
                difference(&moved_by_own.displacement, &right.displacement) < 1e-12,
                "{name}"
            );
        }
    }
}
