//! The properties of all laws, as a table.
//!
//! Most properties have a default, so that a law says only what it has. A new law whose author forgets an answer compiles and gets the
//! default: the table shows it to whoever reviews `properties.txt`, and a default that changes shows in every line that it reaches.

use super::{made_with, sample};
use slipgap_contact::contact::{
    ContactLaw, Flexibility, LAWS, Own, OwnAnswer, OwnLaw, OwnState, OwnStep, StepFlexibility,
    StoredEnergy, VelocityControl, WhichLaw, plane::slides_in_plane,
};
use slipgap_contact::lane::Lane;

const REVIEWED: &str = include_str!("properties.txt");

fn number(x: f64) -> String {
    match x {
        0.0 => "0".to_owned(),
        x if x.is_finite() => format!("{x:.4e}"),
        x => x.to_string(),
    }
}

fn option(x: Option<f64>) -> String {
    x.map_or("-".to_owned(), number)
}

fn all(numbers: &[f64]) -> String {
    let numbers: Vec<String> = numbers.iter().map(|x| number(*x)).collect();
    numbers.join(",")
}

fn yes(is: bool) -> String {
    if is { "yes" } else { "-" }.to_owned()
}

/// Every property with its name, at an overlap of 0.1 or under a force of -0.3.
fn properties(law: &ContactLaw) -> Vec<(&'static str, String)> {
    let properties = law.properties();
    let end = Flexibility {
        h: Lane([0.4]),
        h_rate: Lane([8.0]),
    };
    let on = StepFlexibility {
        start: end,
        end,
        dt: Lane([0.1]),
        by_impulse: false,
    };
    let numbers = properties.shown().into_iter();
    let shown: Vec<String> = numbers
        .map(|(name, x)| format!("{} {}", name.trim_end_matches(" ="), number(x)))
        .collect();
    let [r, rdot, s] = [-0.1, 0.7, -0.3];
    let evolution = law.evolution().map(|evolution| {
        let z = evolution.state(s, r);
        [
            z,
            evolution.rate(z, rdot),
            evolution.force(z, r, rdot),
            evolution.bound(),
        ]
    });
    let deflection = law.deflection(s);
    vec![
        ("law", format!("{:?}", law.which())),
        ("name", law.name().to_owned()),
        ("kind", format!("{:?}", law.kind())),
        ("of velocity", yes(law.of_velocity())),
        ("shown", shown.join(", ")),
        (
            "largest stiffness",
            number(properties.largest_stiffness(0.1)),
        ),
        (
            "initial stiffness",
            number(properties.initial_stiffness(0.1)),
        ),
        ("open", number(properties.initial_stiffness(0.0))),
        ("reach", number(properties.reach())),
        ("bounds", all(&properties.bounds())),
        ("over velocity", yes(properties.over_velocity())),
        ("falls", yes(properties.falls())),
        ("one root", yes(properties.has_one_root(&on))),
        ("rigid form", yes(properties.has_rigid_form())),
        (
            "by closing speed",
            yes(properties.divides_by_closing_speed()),
        ),
        ("unbent force", option(properties.unbent_force(rdot))),
        (
            "touching time",
            option(properties.touching_time(2.0, Some(0.1))),
        ),
        ("stored energy", number(law.stored_energy(r, s))),
        ("conservative force", number(law.conservative_force(r, s))),
        (
            "deflection and slope",
            deflection.map_or("-".to_owned(), |deflection| {
                all(&[deflection.r, deflection.slope])
            }),
        ),
        (
            "z, dz/dt, S, bound",
            evolution.map_or("-".to_owned(), |numbers| all(&numbers)),
        ),
        ("corner", number(properties.corner(rdot))),
        (
            "only in steps",
            properties.only_in_steps().unwrap_or("-").to_owned(),
        ),
        ("printed", yes(properties.element(r, s).is_some())),
        ("driven", option(law.driven(0.6, 0.5))),
        (
            "restitution",
            option(
                law.collision(0.5, 1.0)
                    .map(|collision| collision.restitution),
            ),
        ),
        ("at limit 1", all(&law.at_limit(1.0).properties().bounds())),
        ("vertical", yes(properties.is_vertical())),
        (
            "without damper",
            law.without_damper()
                .map_or("-".to_owned(), |undamped| undamped.name().to_owned()),
        ),
        ("in a plane", yes(slides_in_plane(law))),
        ("straight lines", yes(properties.straight().is_some())),
        (
            "clipped line",
            properties
                .line()
                .map_or("-".to_owned(), |line| format!("{line:?}").replace(' ', "")),
        ),
    ]
}

/// A law of a user's program: a spring with a dashpot.
#[derive(Debug)]
struct Spring;

static SPRING: Spring = Spring;

impl OwnLaw for Spring {
    fn answer(&self, step: &OwnStep, state: &OwnState) -> OwnAnswer {
        let [r, rdot] = step.to;
        OwnAnswer {
            force: 2.0 * r + 0.5 * rdot,
            slopes: [2.0, 0.5],
            state: *state,
        }
    }

    fn largest_stiffness(&self) -> f64 {
        2.0
    }

    fn stored_energy(&self, r: f64, _: f64) -> f64 {
        r * r
    }
}

/// The laws of all names, and those that only other numbers of a name make.
fn laws() -> Vec<(String, ContactLaw)> {
    let named = LAWS.iter().filter_map(|law| {
        let made = made_with(law, sample)?;
        Some((law.offer.name.to_owned(), made))
    });
    let mut laws: Vec<_> = named.collect();
    let control = VelocityControl {
        compliance: 0.25,
        limit: 2.0,
    };
    let viscous = ContactLaw::VelocityControl(control);
    laws.push(("velocity-control, constant".to_owned(), viscous));
    laws.push(("own".to_owned(), ContactLaw::Own(Own::new(&SPRING))));
    laws
}

#[test]
fn the_properties_of_all_laws_are_those_of_the_reviewed_table() {
    let laws = laws();
    for which in WhichLaw::ALL {
        assert!(
            laws.iter().any(|(_, law)| law.which() == *which),
            "{which:?}"
        );
    }
    let rows: Vec<Vec<(&str, String)>> = laws
        .iter()
        .map(|(name, law)| {
            let offered = ("offered as", name.clone());
            std::iter::once(offered).chain(properties(law)).collect()
        })
        .collect();
    let mut lines = vec![String::new(); rows.len() + 1];
    for column in 0..rows[0].len() {
        let heading = rows[0][column].0;
        let cells = std::iter::once(heading).chain(rows.iter().map(|row| row[column].1.as_str()));
        let width = cells.clone().map(str::len).max().unwrap_or(0);
        for (line, cell) in lines.iter_mut().zip(cells) {
            *line += &format!("{cell:width$}  ");
        }
    }
    let lines: Vec<&str> = lines.iter().map(|line| line.trim_end()).collect();
    let table = lines.join("\n") + "\n";
    assert!(
        table == REVIEWED,
        "not the table of properties.txt; if each difference is right, it becomes:\n{table}"
    );
}
