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
use slipgap_system::system::{Linear, System};
use std::f64::consts::PI;

type Given = Vec<(&'static str, Value)>;

fn numbers(of: &[(&'static str, f64)]) -> Given {
    of.iter()
        .map(|(name, x)| (*name, Value::Number(*x)))
        .collect()
}

/// r, rdot and S at the steps of a structure by the general solver, with the method and the steps of a system.
fn general(structure: &Structure, system: &System) -> Vec<[f64; 3]> {
    let prepared = Prepared::by(&system.method, structure, system.step).unwrap();
    let mut rows = Vec::new();
    let last = system.last as usize;
    let [done] = run(&[structure], &prepared, last, |_, state: &State<1>| {
        let contact = state.contact(0);
        rows.push([contact.displacement, contact.velocity, contact.force].map(|lane| lane.0[0]));
    });
    done.map(|()| rows).unwrap()
}

/// The largest difference of two motions in each column over the largest value of the first one.
fn difference(a: &[[f64; 3]], b: &[[f64; 3]]) -> [f64; 3] {
    assert_eq!(a.len(), b.len());
    std::array::from_fn(|column| {
        let size = a
            .iter()
            .fold(0.0, |size: f64, row| size.max(row[column].abs()));
        let each = a.iter().zip(b).map(|(a, b)| (a[column] - b[column]).abs());
        each.fold(0.0, f64::max) / size
    })
}

/// The structure with every sign turned.
fn mirrored(structure: &Structure) -> Structure {
    let mut other = structure.clone();
    let forces = other.preload.forces.iter_mut().flatten();
    let values = other.displacement.iter_mut().chain(&mut other.velocity);
    values.chain(forces).for_each(|x| *x = -*x);
    other
}

/// The structure with a contact at all of its nodes that never closes.
fn with_idle_contact(structure: &Structure) -> Structure {
    let mut other = structure.clone();
    other.contacts.push(Contact {
        name: "idle".into(),
        gap: 1e6,
        law: StructureLaw::new(ClippedLine::Spring { stiffness: 1e-6 }, None),
        ..structure.contacts[0].clone()
    });
    other.preload.forces.push(None);
    other
}

/// The structure with the coordinates of its nodes turned: its contacts have the same motion.
fn turned(structure: &Structure) -> Structure {
    let mut other = structure.clone();
    let along = other
        .contacts
        .iter_mut()
        .flat_map(|contact| &mut contact.along);
    let start = other.displacement.iter_mut().chain(&mut other.velocity);
    let values = along.map(|term| &mut term.1).chain(start);
    values.for_each(|x| *x = -*x);
    other
}

/// Largest difference over the largest value. Both sum the same terms in another order, some units of the last place in a step, and
/// stiff forces have the round-off of displacements times a stiffness.
const ROUND_OFF: f64 = 1e-12;

/// Compares the motions of these cases by the general solver with those of the lanes, with all methods that take them; `is_odd` laws are
/// mirrored, too. Returns the number of cases.
fn compare(problem: &str, cases: &[Given], is_odd: bool) -> usize {
    let problem = find(problem).unwrap();
    let mut count = 0;
    for (given, method) in cases
        .iter()
        .flat_map(|row| METHODS.iter().map(move |m| (row, m)))
    {
        let given = [&given[..], &[("method", Value::Name(method.name))]].concat();
        let (case, broken) = Case::given(&*problem, &given);
        // Rigid bodies part by chance, but by impulses.
        let is_rigid = given.contains(&("law", Value::Name("rigid")));
        if !broken.is_empty() || is_rigid && method.name != "moreau-jean" {
            continue;
        }
        count += 1;
        let mut system = problem.as_textbook().unwrap().system(&case).unwrap();
        let structure = problem.structure(&case).unwrap();
        let solve = |model: &Structure| general(model, &system);
        let direct = solve(&structure);
        let mut others = vec![
            solve(&turned(&structure)),
            solve(&with_idle_contact(&structure)),
        ];
        if is_odd {
            let back = solve(&mirrored(&structure)).into_iter();
            others.push(back.map(|row| row.map(|x| -x)).collect());
        }
        if structure.contacts[0].law.is_rigid() {
            // Without compliance S(0) of a structure follows from its equilibrium; in the textbook problem it is 0.
            system.force = direct[0][2];
        }
        let lanes = solve::run::<ContactTrack>(&system).unwrap().track.0;
        for (index, rows) in [direct].iter().chain(&others).enumerate() {
            let found = difference(&lanes, rows);
            let is_same = found.iter().all(|x| *x < ROUND_OFF);
            assert!(is_same, "{given:?} {index}: {found:?}");
        }
    }
    count
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
    let mut cases = Vec::new();
    for (law, pairs) in laws {
        let mut given = numbers(&pairs);
        given.push(("law", Value::Name(law)));
        given.extend(numbers(&[("dT", PI / 40.0), ("duration", 8.0 * PI)]));
        if law == "displacement-control" {
            for slip in ["pulled", "sliding"] {
                let slip = ("initial_slip", Value::Name(slip));
                cases.push([&given[..], &[slip]].concat());
            }
        }
        cases.push(given);
    }
    cases
}

/// Impact laws with their numbers, between equal and other bars and at a wall.
fn impacts() -> Vec<Given> {
    let mut cases = Vec::new();
    for (law, pairs) in [
        ("rigid", &[][..]),
        ("impact-spring", &[("gamma", 0.5)]),
        ("hertz", &[("gamma", 0.5)]),
        ("kelvin-voigt", &[("gamma", 0.5), ("restitution", 0.5)]),
        ("hunt-crossley", &[("gamma", 0.5), ("restitution", 0.5)]),
        ("jankowski", &[("gamma", 0.5), ("restitution", 0.5)]),
    ] {
        let mut given = numbers(pairs);
        given.push(("law", Value::Name(law)));
        let step = [("n", 10.0), ("dt", 0.004), ("duration", 1.6)];
        given.extend(numbers(&step));
        let wall = [("right", Value::Name("wall"))];
        let consistent = [("mass", Value::Name("consistent"))];
        let longer = numbers(&[("right.L", 17.0), ("right.n", 12.0), ("gap", 0.1)]);
        for other in [&[][..], &wall, &consistent, &longer] {
            cases.push([&given[..], other].concat());
        }
    }
    cases
}

#[test]
fn the_general_solver_has_the_motion_of_the_oscillator() {
    assert_eq!(compare("friction-oscillator", &friction(), true), 99);
}

#[test]
fn the_general_solver_has_the_motion_of_the_bars() {
    assert_eq!(compare("bar-impact", &impacts(), false), 184);
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
        let (case, rows) = by_events(&*problem, given, &times);
        let textbook = problem
            .as_textbook()
            .unwrap()
            .exact_of_law(&case, &times)
            .unwrap();
        let closed: Vec<[f64; 3]> = (0..times.len())
            .map(|i| [0, 1, 2].map(|channel| textbook.channel(channel)[i]))
            .collect();
        let found = difference(&closed, &rows);
        assert!(found.iter().all(|x| *x < ROUND_OFF), "{given:?} {found:?}");
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
        let system = problem.as_textbook().unwrap().system(&case).unwrap();
        let Linear::Bars(pair) = system.linear else {
            unreachable!()
        };
        let Some(ClippedLine::Spring { stiffness }) = problem
            .as_textbook()
            .unwrap()
            .contact_law(&case)
            .unwrap()
            .line()
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
        assert!(found.iter().all(|x| *x < ROUND_OFF), "{given:?} {found:?}");
    }
}
