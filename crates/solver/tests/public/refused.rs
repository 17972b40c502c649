//! Structures and times that fit no motion are refused, in words.

use slipgap_solver::{
    AverageAcceleration, Contact, Direction, Load, Node, Signal, Structure, StructureLaw,
    Symmetric, Unsolvable, events, exact, laws::Viscous, run,
};

fn mass() -> Structure {
    Structure::new(vec![Node {
        name: "mass".into(),
        mass: 1.0,
        direction: Direction::X,
    }])
}

/// Why steps and exact motions are refused.
fn refused(structure: &Structure) -> String {
    let why = run(structure, &AverageAcceleration.into(), 0.1, 10).unwrap_err();
    assert!(matches!(why, Unsolvable::BrokenRules(_)));
    assert_eq!(exact(structure, &[1.0]).unwrap_err(), why);
    assert_eq!(events(structure, 1.0).unwrap_err(), why);
    why.to_string()
}

#[test]
fn lists_of_another_length_are_refused() {
    let mut structure = mass();
    structure.velocity.push(1.0);
    assert!(refused(&structure).contains("velocity must have the size 1, got 2"));
    let mut structure = mass();
    structure.stiffness = Symmetric::zeros(3);
    assert!(refused(&structure).contains("stiffness must have the size 1, got 3"));
    let mut structure = mass();
    structure.preload.load = vec![1.0; 2];
    assert!(refused(&structure).contains("preload.load"));
}

#[test]
fn nodes_that_are_none_are_refused() {
    let mut structure = mass();
    structure.loads.push(Load {
        pattern: vec![(4, 1.0)],
        signal: Signal::constant(1.0).into(),
    });
    assert!(refused(&structure).contains("a node must be below 1, got 4"));
    let mut structure = mass();
    let damper = Viscous {
        viscosity: 1.0,
        exponent: 1.0,
    };
    structure.contacts.push(Contact {
        name: "damper".into(),
        along: vec![(1, 1.0)],
        gap: 0.0,
        law: StructureLaw::new(slipgap_solver::ContactLaw::Viscous(damper), None),
    });
    assert!(refused(&structure).contains("a node must be below 1, got 1"));
}

#[test]
fn times_that_are_none_are_refused() {
    for dt in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let why = run(&mass(), &AverageAcceleration.into(), dt, 1).unwrap_err();
        assert!(matches!(why, Unsolvable::BrokenRules(_)), "{dt}");
        assert!(events(&mass(), dt).is_err(), "{dt}");
    }
    for times in [[1.0, 0.5], [-1.0, 1.0], [0.0, f64::NAN]] {
        assert!(exact(&mass(), &times).is_err(), "{times:?}");
    }
    assert!(exact(&mass(), &[0.0]).is_err() && exact(&mass(), &[]).is_err());
    let mut held = mass();
    held.stiffness.add_spring([Some(0), None], 1.0);
    held.displacement[0] = 2.0;
    assert_eq!(exact(&held, &[0.0, 1.0]).unwrap().displacement[0], [2.0]);
}
