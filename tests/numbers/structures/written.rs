//! The motion of a structure does not depend on how the structure is written: seen from the other side, in another order, in other
//! units, or with a mass beside it that touches nothing.

use serde_json::{Map, Value as Json, json};
use slipgap::study;

/// Number of random models, and the first one; `SLIPGAP_MODELS` and `SLIPGAP_FIRST` may give other ones.
const MODELS: u64 = 40;

/// SplitMix64.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn number(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn below(&mut self, count: usize) -> usize {
        (self.next() % count as u64) as usize
    }

    /// Between the powers of 10.
    fn power(&mut self, low: f64, high: f64) -> f64 {
        10.0_f64.powf(self.number(low, high))
    }

    fn once_in(&mut self, count: usize) -> bool {
        self.below(count) == 0
    }
}

/// All laws with a stiffness, a damper or a limit, but those that fall fast.
fn law(random: &mut Random) -> Json {
    let k = random.power(2.5, 4.5);
    let [k_h, limit] = [random.power(4.0, 6.0), random.number(0.5, 5.0)];
    let restitution = random.number(0.4, 0.9);
    let mut law = match random.below(24) {
        0 => json!({"law": "impact-spring", "k": k}),
        1 => {
            json!({"law": "kelvin-voigt", "k": k, "restitution": restitution, "colliding_mass": 1})
        }
        2 => json!({"law": "hertz", "k_h": k_h}),
        3 => json!({"law": "hertz-damp", "k_h": k_h, "restitution": restitution}),
        4 => json!({"law": "hunt-crossley", "k_h": k_h, "restitution": restitution}),
        5 => json!({"law": "ye", "k_h": k_h, "restitution": restitution}),
        6 => {
            json!({"law": "jankowski", "k_h": k_h, "restitution": restitution, "colliding_mass": 1})
        }
        7 => json!({"law": "gap-yield", "k": k, "Fy": limit, "hardening": 0.05}),
        8 => json!({"law": "hyperbolic-gap", "k": k, "Fult": limit, "k_unloading": 2.0 * k}),
        9 => json!({"law": "impact-yield", "k1": k, "k2": 0.2 * k, "delta_y": limit / k}),
        10 => json!({"law": "displacement-control", "k": k, "limit": limit}),
        11 => json!({"law": "velocity-control", "c": random.number(5.0, 50.0), "limit": limit}),
        12 => json!({"law": "coulomb", "limit": limit}),
        13 => json!({"law": "tanh", "c": random.number(5.0, 50.0), "limit": limit}),
        14 => {
            let beta = random.number(0.1, 2.0);
            json!({"law": "bouc-wen", "k": k, "limit": limit, "exponent": 1 + random.below(2), "beta": beta})
        }
        15 => json!({"law": "dahl", "k": k, "limit": limit, "exponent": 1.5}),
        16 => {
            json!({"law": "lugre", "sigma0": k, "sigma1": random.number(0.0, 10.0), "limit": limit})
        }
        17 => json!({"law": "pendulum", "k": k, "nu": 0.1, "N": 10.0 * limit, "R": 1}),
        18 => json!({"law": "bilinear", "k1": k, "Fy": limit, "k2": 0.05 * k}),
        19 => json!({"law": "restrainer", "slack": random.number(0.0, 0.01), "k": k, "Fy": limit}),
        20 => {
            json!({"law": "viscous", "c": random.number(1.0, 20.0), "a": 0.5 * (1 + random.below(4)) as f64})
        }
        21 => {
            json!({"law": "stribeck-hyperbolic", "c": random.number(5.0, 50.0), "limit": limit, "static_ratio": 1.2, "stribeck_velocity": 5})
        }
        22 => {
            json!({"law": "imk-bilinear", "k": k, "Fy": limit, "Up": 9.0 * limit / k, "Upc": 1e3 * limit / k, "Fcap_ratio": 1.2, "lambda_S": 500.0 * limit / k, "lambda_K": 900.0 * limit / k})
        }
        _ => {
            json!({"law": "multilinear", "table": {"r": [limit / k, 3.0 * limit / k, 9.0 * limit / k], "S": [limit, 1.5 * limit, 2.0 * limit]}})
        }
    };
    if random.once_in(3) {
        law["gap"] = json!(random.number(-0.005, 0.01));
    }
    law
}

/// One to four masses on springs, some nodes without mass on springs, contacts of one to three laws.
fn model(random: &mut Random) -> Json {
    let names: Vec<String> = (0..1 + random.below(4)).map(|i| format!("m{i}")).collect();
    let mut nodes = names.clone();
    let mut masses = Map::new();
    let mut springs = Vec::new();
    let mut start = Map::new();
    let begins = !random.once_in(5);
    for (i, name) in names.iter().enumerate() {
        masses.insert(name.clone(), json!(random.number(0.5, 3.0)));
        let to = if i == 0 {
            "ground".into()
        } else {
            names[i - 1].clone()
        };
        springs.push(json!({"between": [to, name], "k": random.number(50.0, 1000.0), "c": random.number(0.0, 1.0)}));
        if begins {
            let [u, v] = [random.number(-0.02, 0.02), random.number(-0.5, 0.5)];
            start.insert(name.clone(), json!({"u": u, "v": v}));
        }
    }
    if random.once_in(3) {
        masses.insert("z".into(), json!(0));
        let to = &names[random.below(names.len())];
        springs.push(json!({"between": [to, "z"], "k": random.power(2.0, 4.0)}));
        nodes.push("z".into());
    }
    nodes.push("ground".into());
    let mut contacts = Map::new();
    for j in 0..1 + random.below(2) {
        let from = random.below(nodes.len());
        let to = (from + 1 + random.below(nodes.len() - 1)) % nodes.len();
        let mut contact = match random.below(4) {
            0 => law(random),
            laws => {
                let laws: Vec<Json> = (0..laws.max(2)).map(|_| law(random)).collect();
                json!({"series": laws})
            }
        };
        contact["between"] = json!([nodes[from], nodes[to]]);
        contacts.insert(format!("c{j}"), contact);
    }
    let mut structure =
        json!({"masses": masses, "springs": springs, "start": start, "contacts": contacts});
    if !begins || random.once_in(3) {
        let [amplitude, omega] = [random.number(1.0, 5.0), random.number(5.0, 30.0)];
        structure["loads"] = json!([{"at": names[0], "sine": {"amplitude": amplitude, "omega": omega, "phase": 0.5}}]);
    }
    structure
}

/// Displacements and contact forces, in the order of the first writing.
#[derive(Clone)]
struct Channels {
    u: Vec<String>,
    forces: Vec<String>,
}

fn channels(structure: &Json) -> Channels {
    let object = |key: &str| structure[key].as_object().unwrap();
    let force = |(name, contact): (&String, &Json)| match contact["series"].as_array() {
        Some(laws) => (1..=laws.len()).map(|i| format!("{name}.{i}.S")).collect(),
        None => vec![format!("{name}.S")],
    };
    let masses = object("masses").keys().filter(|name| *name != "z");
    Channels {
        u: masses.cloned().collect(),
        forces: object("contacts").iter().flat_map(force).collect(),
    }
}

struct Motion {
    u: Vec<Vec<f64>>,
    forces: Vec<Vec<f64>>,
    energy_error: f64,
}

fn solve(structure: &Json, channels: &Channels) -> Result<Motion, String> {
    let y: Vec<&String> = channels.u.iter().chain(&channels.forces).collect();
    let text = json!({
        "problem": "structure", "parameters": {"dt": 0.001, "duration": 0.2}, "structure": structure,
        "metrics": ["energy_error"], "figures": [{"name": "h", "kind": "history", "y": y}]
    });
    let study = study::parse("study.json", &text.to_string()).map_err(|why| why.to_string())?;
    let case = study.case(0).unwrap();
    let solution = study
        .problem
        .solve(&case, &study.metrics)
        .map_err(|why| why.to_string())?;
    let channel = |i: usize| solution.computed.channel(i).to_vec();
    let first = channels.u.len();
    Ok(Motion {
        u: (0..first).map(channel).collect(),
        forces: (first..y.len()).map(channel).collect(),
        energy_error: solution.metrics[0].unwrap_or(0.0),
    })
}

fn parts(structure: &mut Json) -> impl Iterator<Item = &mut Json> {
    structure["contacts"].as_object_mut().unwrap().values_mut()
}

/// Everything seen from the other side: displacements change their signs, r does not.
fn mirrored(structure: &Json, channels: &Channels) -> (Json, Channels) {
    let mut other = structure.clone();
    for start in other["start"].as_object_mut().unwrap().values_mut() {
        for key in ["u", "v"] {
            start[key] = json!(-start[key].as_f64().unwrap());
        }
    }
    if let Some(load) = other.pointer_mut("/loads/0/sine/amplitude") {
        *load = json!(-load.as_f64().unwrap());
    }
    for contact in parts(&mut other) {
        contact["between"].as_array_mut().unwrap().reverse();
        if let Some(laws) = contact.get_mut("series").and_then(Json::as_array_mut) {
            laws.reverse();
        }
    }
    let mut names = channels.clone();
    for (name, contact) in structure["contacts"].as_object().unwrap() {
        if let Some(laws) = contact["series"].as_array() {
            for i in 1..=laws.len() {
                let column = channels
                    .forces
                    .iter()
                    .position(|channel| *channel == format!("{name}.{i}.S"));
                names.forces[column.unwrap()] = format!("{name}.{}.S", laws.len() + 1 - i);
            }
        }
    }
    (other, names)
}

fn reordered(structure: &Json) -> Json {
    let mut other = structure.clone();
    for key in ["masses", "contacts"] {
        let members = structure[key].as_object().unwrap();
        other[key] = members
            .iter()
            .rev()
            .map(|(name, value)| (name.clone(), value.clone()))
            .collect();
    }
    other["springs"].as_array_mut().unwrap().reverse();
    other
}

fn with_a_mass_beside(structure: &Json) -> Json {
    let mut other = structure.clone();
    let mut masses = Map::from_iter([("a".to_owned(), json!(1.3))]);
    masses.extend(structure["masses"].as_object().unwrap().clone());
    other["masses"] = masses.into();
    let spring = json!({"between": ["ground", "a"], "k": 100});
    other["springs"].as_array_mut().unwrap().insert(0, spring);
    other
}

/// Factors of length and of force.
const UNITS: [f64; 2] = [37.3, 0.0291];

/// The dimension of a key as powers of length and force.
fn dimension(key: &str, law: &Json) -> [f64; 2] {
    match key {
        "u" | "v" | "gap" | "slack" | "delta_y" | "R" | "r" => [1.0, 0.0],
        "limit" | "Fy" | "Fult" | "N" | "S" | "amplitude" => [0.0, 1.0],
        "k_h" => [-1.5, 1.0],
        "c" if law["law"] == "viscous" => [-law["a"].as_f64().unwrap(), 1.0],
        "k" | "k1" | "k2" | "k_unloading" | "c" | "sigma0" | "sigma1" | "colliding_mass" => {
            [-1.0, 1.0]
        }
        "Up" | "Upc" | "lambda_S" | "lambda_K" | "stribeck_velocity" => [1.0, 0.0],
        "restitution" | "hardening" | "exponent" | "beta" | "nu" | "a" | "omega" | "phase"
        | "static_ratio" | "Fcap_ratio" => [0.0; 2],
        _ => panic!("{key}"),
    }
}

fn in_units(of: &Json, key: &str, law: &Json) -> Json {
    match of {
        Json::Object(members) => members
            .iter()
            .map(|(key, value)| (key.clone(), in_units(value, key, of)))
            .collect(),
        Json::Array(items) => items
            .iter()
            .map(|value| in_units(value, key, law))
            .collect(),
        Json::Number(number) => {
            let [length, force] = dimension(key, law);
            json!(number.as_f64().unwrap() * UNITS[0].powf(length) * UNITS[1].powf(force))
        }
        Json::Null | Json::Bool(_) | Json::String(_) => of.clone(),
    }
}

fn scaled(structure: &Json) -> Json {
    let mut other = structure.clone();
    for key in ["springs", "start", "contacts", "loads"] {
        if let Some(given) = other.get_mut(key) {
            *given = in_units(given, key, &Json::Null);
        }
    }
    for mass in other["masses"].as_object_mut().unwrap().values_mut() {
        *mass = json!(mass.as_f64().unwrap() * UNITS[1] / UNITS[0]);
    }
    other
}

fn largest(of: &[Vec<f64>]) -> f64 {
    of.iter()
        .flatten()
        .fold(0.0, |most: f64, x| most.max(x.abs()))
}

/// The largest difference as part of the largest value, or of `least`.
fn difference(of: &[Vec<f64>], other: &[Vec<f64>], factor: f64, least: f64) -> f64 {
    let pairs = of.iter().flatten().zip(other.iter().flatten());
    let most = pairs.fold(0.0, |most: f64, (a, b)| most.max((a - b / factor).abs()));
    most / largest(of).max(least)
}

/// The force of the softest spring under the largest displacement.
fn spring_force(structure: &Json, motion: &Motion) -> f64 {
    let springs = structure["springs"].as_array().unwrap().iter();
    let softest = springs
        .map(|spring| spring["k"].as_f64().unwrap())
        .fold(f64::INFINITY, f64::min);
    softest * largest(&motion.u)
}

fn from_environment(key: &str, usual: u64) -> u64 {
    let given = std::env::var(key).ok();
    given.map_or(usual, |text| text.parse().unwrap())
}

#[test]
fn writing_a_structure_in_another_way_does_not_change_its_motion() {
    let first = from_environment("SLIPGAP_FIRST", 0);
    let mut bad = Vec::new();
    for seed in first..first + from_environment("SLIPGAP_MODELS", MODELS) {
        let structure = model(&mut Random(seed));
        let names = channels(&structure);
        let (mirror, mirror_names) = mirrored(&structure, &names);
        let others = [
            ("mirrored", mirror, &mirror_names, [-1.0, 1.0]),
            ("reordered", reordered(&structure), &names, [1.0, 1.0]),
            (
                "mass beside",
                with_a_mass_beside(&structure),
                &names,
                [1.0, 1.0],
            ),
            ("scaled", scaled(&structure), &names, UNITS),
        ];
        let motion = solve(&structure, &names);
        let least = motion
            .as_ref()
            .map_or(0.0, |solved| spring_force(&structure, solved));
        if let Ok(solved) = &motion {
            // Contacts in series have one force, but for their signs, at every step. A structure that friction holds has no energy.
            let error = if largest(&solved.u) > 1e-9 {
                solved.energy_error
            } else {
                0.0
            };
            let holds = error < 1e-8 && has_one_force(&structure, solved);
            if !holds {
                bad.push(format!("{seed} energy error {error:e} {structure}"));
            }
        }
        for (how, other, names, [length, force]) in others {
            let there = solve(&other, names);
            let difference = match (&motion, &there) {
                (Ok(here), Ok(there)) => difference(&here.u, &there.u, length, 1e-9)
                    .max(difference(&here.forces, &there.forces, force, least)),
                (Err(_), Err(_)) => 0.0,
                _ => f64::INFINITY,
            };
            let agrees = difference < 1e-9;
            if !agrees {
                let refused = [motion.as_ref().err(), there.as_ref().err()];
                bad.push(format!(
                    "{seed} {how} {difference:e} {refused:?} {structure}"
                ));
            }
        }
    }
    assert!(bad.is_empty(), "{}", bad.join("\n"));
}

/// Whether the contacts of every series have the same forces.
fn has_one_force(structure: &Json, motion: &Motion) -> bool {
    let mut forces = motion.forces.iter();
    let contacts = structure["contacts"].as_object().unwrap().values();
    let counts = contacts.map(|laws| laws["series"].as_array().map_or(1, Vec::len));
    counts.into_iter().all(|count| {
        let of_contact: Vec<_> = forces.by_ref().take(count).collect();
        of_contact.windows(2).all(|pair| pair[0] == pair[1])
    })
}
