//! The textbook problems as structures: the general solver gives the motions of the lanes, and the exact motion by events is the closed
//! form.

use slipgap_contact::contact::ClippedLine;
use slipgap_motion::exact::events;
use slipgap_motion::exact::mesh::Mesh;
use slipgap_motion::solve::structure::{Prepared, State, run};
use slipgap_motion::solve::{self, ContactTrack};
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_problem::problem::{Case, Problem, find};
use slipgap_system::methods::METHODS;
use slipgap_system::system::structure::{Contact, Structure, StructureLaw};
use std::f64::consts::PI;

type Given = Vec<(&'static str, Value)>;

fn numbers(of: &[(&'static str, f64)]) -> Given {
    of.iter()
        .map(|(name, x)| (*name, Value::Number(*x)))
        .collect()
}

/// r, rdot and S at the steps of a structure by the general solver; without a solution none.
fn general(structure: &Structure, prepared: &Prepared, last: u64) -> Vec<[f64; 3]> {
    let mut rows = Vec::new();
    let [done] = run(
        &[structure],
        prepared,
        last as usize,
        |_, state: &State<1>| {
            let own = state.contact(0);
            rows.push([own.displacement, own.velocity, own.force].map(|lane| lane.0[0]));
        },
    );
    done.map(|()| rows).unwrap()
}

/// The largest difference of two motions in each column over the largest value of the first one.
fn difference(a: &[[f64; 3]], b: &[[f64; 3]]) -> [f64; 3] {
    assert_eq!(a.len(), b.len());
    std::array::from_fn(|column| {
        let size = a
            .iter()
            .fold(0.0, |size: f64, own| size.max(own[column].abs()));
        let each = a.iter().zip(b).map(|(a, b)| (a[column] - b[column]).abs());
        each.fold(0.0, f64::max) / size
    })
}

/// The structure with every sign turned.
fn mirrored(structure: &Structure) -> Structure {
    let mut other = structure.clone();
    let forces = other.preload.forces.iter_mut().flatten();
    let all = other.displacement.iter_mut().chain(&mut other.velocity);
    all.chain(forces).for_each(|x| *x = -*x);
    other
}

/// The structure with a contact at all of its nodes that never closes.
fn with_idle_contact(structure: &Structure) -> Structure {
    let mut other = structure.clone();
    other.contacts.push(Contact {
        name: "idle".into(),
        gap: 1e6,
        law: StructureLaw::new(ClippedLine::Spring { stiffness: 1e3 }, None),
        ..structure.contacts[0].clone()
    });
    other.preload.forces.push(None);
    other
}

/// The largest difference of the motions of all these cases by the general solver and by lanes; `odd` laws are mirrored, too.
fn compared(problem: &str, cases: &[Given], odd: bool) -> (f64, usize) {
    let problem = find(problem).unwrap();
    let (mut worst, mut count) = (0.0_f64, 0);
    for given in cases {
        for method in METHODS {
            let mut given = given.clone();
            given.push(("method", Value::Name(method.name)));
            let (case, broken) = Case::given(&*problem, &given);
            if !broken.is_empty() {
                continue;
            }
            count += 1;
            let system = problem.system(&case).unwrap();
            let structure = problem.structure(&case).unwrap();
            let lanes = solve::run::<ContactTrack>(&system).unwrap().track.0;
            let mut add = |own: &[[f64; 3]], what: &str| {
                let [r, rdot, s] = difference(&lanes, own);
                println!("{given:?} {what}: {r:.1e} {rdot:.1e} {s:.1e}");
                worst = worst.max(r).max(rdot);
            };
            let prepare = |own: &Structure| Prepared::by(&system.method, own, system.step).unwrap();
            let prepared = prepare(&structure);
            add(&general(&structure, &prepared, system.last), "as given");
            if odd {
                let own = general(&mirrored(&structure), &prepared, system.last);
                let back: Vec<_> = own.iter().map(|row| row.map(|x| -x)).collect();
                add(&back, "mirrored");
            }
            let idle = with_idle_contact(&structure);
            add(
                &general(&idle, &prepare(&idle), system.last),
                "with an idle contact",
            );
        }
    }
    (worst, count)
}

/// Friction laws with their numbers.
fn friction() -> Vec<Given> {
    let falling = [("static_ratio", 1.2), ("stribeck_velocity", 1.0)];
    let lugre = [("sigma0", 10.0), ("sigma1", 0.5), ("sigma2", 0.1)];
    let bearing = [("beta", 0.5), ("nu_ratio", 0.5), ("nu_rate", 1.0)];
    let laws = [
        ("coulomb", vec![]),
        ("displacement-control", vec![("alpha", 0.1)]),
        ("velocity-control", vec![("beta", 0.1)]),
        ("velocity-control", bearing.to_vec()),
        ("bouc-wen", vec![("alpha", 0.5), ("exponent", 2.0)]),
        ("dahl", vec![("alpha", 0.5), ("exponent", 1.0)]),
        ("lugre", [&lugre[..], &falling].concat()),
        ("tanh", vec![("beta", 0.5)]),
        ("stribeck", [&[("beta", 0.5)][..], &falling].concat()),
    ];
    let mut all = Vec::new();
    for (law, own) in laws {
        let mut given = numbers(&own);
        given.push(("law", Value::Name(law)));
        given.extend(numbers(&[("dT", PI / 40.0), ("duration", 8.0 * PI)]));
        if law == "displacement-control" {
            for slip in ["pulled", "sliding"] {
                let slip = ("initial_slip", Value::Name(slip));
                all.push([&given[..], &[slip]].concat());
            }
        }
        all.push(given);
    }
    all
}

/// Impact laws with their numbers, between equal and other bars and at a wall.
fn impacts() -> Vec<Given> {
    let mut all = Vec::new();
    for (law, own) in [
        ("rigid", &[][..]),
        ("impact-spring", &[("gamma", 0.5)]),
        ("hertz", &[("gamma", 0.5)]),
        ("kelvin-voigt", &[("gamma", 0.5), ("restitution", 0.5)]),
        ("hunt-crossley", &[("gamma", 0.5), ("restitution", 0.5)]),
        ("jankowski", &[("gamma", 0.5), ("restitution", 0.5)]),
    ] {
        let mut given = numbers(own);
        given.push(("law", Value::Name(law)));
        let step = [("n", 10.0), ("dt", 0.004), ("duration", 1.6)];
        given.extend(numbers(&step));
        let wall = [("right", Value::Name("wall"))];
        let consistent = [("mass", Value::Name("consistent"))];
        let longer = numbers(&[("right.L", 17.0), ("right.n", 12.0), ("gap", 0.1)]);
        for other in [&[][..], &wall, &consistent, &longer] {
            all.push([&given[..], other].concat());
        }
    }
    all
}

#[test]
fn the_general_solver_has_the_motion_of_the_oscillator() {
    let (worst, count) = compared("friction-oscillator", &friction(), true);
    println!("{worst:e} {count}");
    assert!(count > 60, "{count}");
    assert!(worst < 1e-10, "{worst:e}");
}

#[test]
fn the_general_solver_has_the_motion_of_the_bars() {
    let (worst, count) = compared("bar-impact", &impacts(), false);
    println!("{worst:e} {count}");
    assert!(count > 60, "{count}");
    assert!(worst < 1e-10, "{worst:e}");
}

/// The case, and r, rdot and S of its structure by events at these times.
fn by_events(problem: &dyn Problem, given: &Given, times: &[f64]) -> (Case, Vec<[f64; 3]>) {
    let (case, broken) = Case::given(problem, given);
    assert_eq!(broken, []);
    let structure = problem.structure(&case).unwrap();
    let mut rows = Vec::new();
    events::run_of(&structure, &[], times, |_, state| {
        rows.push([state.r[0], state.rate[0], state.force[0]]);
    })
    .unwrap();
    (case, rows)
}

#[test]
fn events_of_the_oscillator_are_the_closed_forms() {
    let problem = find("friction-oscillator").unwrap();
    // No time is an event, where the force of Coulomb friction jumps.
    let times: Vec<f64> = (0..700).map(|i| 0.0371 * f64::from(i)).collect();
    for given in &friction()[..5] {
        let own: Given = given.clone();
        if own.iter().any(|own| own.0 == "nu_ratio") {
            continue;
        }
        let (case, rows) = by_events(&*problem, given, &times);
        let closed = problem.exact_of_law(&case, &times).unwrap();
        let closed: Vec<[f64; 3]> = (0..times.len())
            .map(|i| [0, 1, 2].map(|channel| closed.channel(channel)[i]))
            .collect();
        let found = difference(&closed, &rows);
        println!("{given:?} {found:?}");
        assert!(found[0] < 1e-11 && found[1] < 1e-11, "{given:?} {found:?}");
    }
}

#[test]
fn events_of_the_bars_are_the_mesh_in_closed_form() {
    let problem = find("bar-impact").unwrap();
    let times: Vec<f64> = (0..300).map(|i| 0.00531 * f64::from(i)).collect();
    for (gamma, mass, gap) in [
        (0.5, "lumped", 0.0),
        (2.0, "consistent", 0.2),
        (8.0, "lumped", 0.0),
    ] {
        let mut given = numbers(&[("gamma", gamma), ("n", 10.0), ("dt", 0.01), ("gap", gap)]);
        given.extend(numbers(&[("duration", 1.6)]));
        given.push(("mass", Value::Name(mass)));
        let (case, rows) = by_events(&*problem, &given, &times);
        let system = problem.system(&case).unwrap();
        let slipgap_system::system::Linear::Bars(pair) = system.linear else {
            unreachable!()
        };
        let Some(ClippedLine::Spring { stiffness }) = problem.contact_law(&case).unwrap().line()
        else {
            unreachable!()
        };
        let mut mesh = Mesh::new(&pair.left, stiffness, gap).unwrap();
        let closed: Vec<[f64; 3]> = times
            .iter()
            .map(|time| {
                let [r, rdot, force] = mesh.at(*time).unwrap().values();
                [r, 2.0 * rdot, -force]
            })
            .collect();
        let found = difference(&closed, &rows);
        println!("{given:?} {found:?}");
        assert!(found.iter().all(|x| *x < 1e-9), "{given:?} {found:?}");
    }
}
