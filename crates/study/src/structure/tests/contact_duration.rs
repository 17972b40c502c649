//! The estimated duration of a contact.

use crate::parse;
use slipgap_contact::contact::{
    ClippedLine, ContactLaw, Hertz, HertzDamp, HuntCrossley, Jankowski, KelvinVoigt, Ye,
};
use slipgap_problem::problem::structure::model::contact_duration;
use slipgap_system::system::structure::{Contact, Node, Structure, StructureLaw, between};

const MASSES: [f64; 2] = [2.0, 3.0];

/// The estimate for a law, over the `contact_time` of a run with fine steps: two free bodies that meet at 0.7.
fn ratio(law: StructureLaw, keys: &str) -> f64 {
    let [a, b] = MASSES;
    let text = format!(
        r#"{{"problem": "structure", "parameters": {{"dt": 0.00001, "duration": 0.2}},
          "structure": {{"masses": {{"a": {a}, "b": {b}}}, "contacts": {{"c": {{{keys}, "between": ["a", "b"]}}}},
          "start": {{"a": {{"v": 0.7}}}}}}, "metrics": ["contact_time(c)", "min(c.r)"]}}"#
    );
    let study = parse("s", &text).unwrap_or_else(|e| panic!("{e}"));
    let solution = study.problem.solve(&study.case(0).unwrap(), &[]);
    let metrics = solution.unwrap().metrics;
    let node = |mass| Node {
        name: String::new(),
        mass,
        direction: Default::default(),
    };
    let contact = Contact {
        name: String::new(),
        along: between([Some(0), Some(1)]),
        gap: 0.0,
        law,
    };
    let structure = Structure::new(MASSES.map(node).to_vec());
    let time = contact_duration::time(&structure, &contact, metrics[1].map(|r| -r));
    time.unwrap() / metrics[0].unwrap()
}

#[test]
fn free_bodies_touch_for_the_estimated_time() {
    // A step more or less at both ends, of 1e-5 s: of 0.03 s for the linear laws, and of 0.06 s for the others.
    let near = |ratio: f64| assert!((ratio - 1.0).abs() < 1e-3, "{ratio}");
    let stiffness = 4000.0;
    let spring = StructureLaw::new(ClippedLine::Spring { stiffness }, None);
    near(ratio(spring, r#""law": "impact-spring", "k": 4000"#));
    let curved = |law: ContactLaw| StructureLaw::new(law, None).from_its_answer();
    let k_h = 90_000.0;
    let hertz = curved(ContactLaw::Hertz(Hertz { stiffness: k_h }));
    near(ratio(hertz, r#""law": "hertz", "k_h": 90000"#));
    // With m = 1.2 of the bodies xi is 0.22 and 0.69; with the larger one it is 3.
    for (e, m) in [(0.5, 1.2), (0.05, 1.2), (0.05, 22.7)] {
        let law = curved(ContactLaw::KelvinVoigt(KelvinVoigt::new(stiffness, e, m)));
        near(ratio(
            law,
            &format!(
                r#""law": "kelvin-voigt", "k": 4000, "restitution": {e}, "colliding_mass": {m}"#
            ),
        ));
    }
    // Damping delays the separation: they touch for longer, but less than twice as long.
    let e = 0.6;
    for (law, name) in [
        (ContactLaw::HertzDamp(HertzDamp::new(k_h, e)), "hertz-damp"),
        (
            ContactLaw::HuntCrossley(HuntCrossley::new(k_h, e)),
            "hunt-crossley",
        ),
        (ContactLaw::Ye(Ye::new(k_h, e)), "ye"),
        (
            ContactLaw::Jankowski(Jankowski::new(k_h, e, 1.2)),
            "jankowski",
        ),
    ] {
        let mass = match name {
            "jankowski" => r#", "colliding_mass": 1.2"#,
            _ => "",
        };
        let keys = format!(r#""law": "{name}", "k_h": 90000, "restitution": {e}{mass}"#);
        let ratio = ratio(curved(law), &keys);
        assert!((0.5..1.2).contains(&ratio), "{name}: {ratio}");
    }
}
