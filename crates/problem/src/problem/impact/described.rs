//! The bars as a structure that a study describes, for programs of others, in the scales of the problem.

use super::scaled::Scaled;
use super::tables::law_parameters::rows;
use super::tables::{LAW, MassMatrix};
use crate::contact::StoredEnergy;
use crate::lane::Lane;
use crate::metrics::impact::Track;
use crate::problem::structure::parts::contact_law::written_numbers;
use crate::problem::{Case, Described};
use crate::system::bar::Bar;
use serde_json::{Map, json};

/// The channels before the velocities of the nodes: the contact, and the energies of the bars and the spring.
const CONTACT: [&str; 3] = ["contact.r", "contact.rdot", "contact.S"];
const ENERGIES: [&str; 2] = ["energy.kinetic", "energy.elastic"];

/// The structure of a completed case. The common mass centre is at rest.
///
/// # Errors
/// What a structure does not have.
pub fn described(case: &Case) -> Result<Described, String> {
    let scaled = Scaled::new(case).ok_or("a parameter is not given")?;
    if MassMatrix::of(case) != Some(MassMatrix::Lumped) {
        let mass = case.choice("mass");
        return Err(format!(
            "mass {mass}: bars of a structure have the masses lumped; allowed: lumped"
        ));
    }
    let pair = &scaled.pair;
    let law = case.name_at(LAW);
    let reduced = pair.right.map_or(pair.left.mass, |right| {
        pair.left.mass * right.mass / (pair.left.mass + right.mass)
    });
    let number = |key: &str| match key {
        "k" => Some(scaled.spring),
        "k_h" => Some(scaled.spring * scaled.spring.sqrt()),
        "restitution" | "e" => case.at(LAW + rows::RESTITUTION),
        "colliding_mass" => Some(reduced),
        _ => None,
    };
    let mut contact = written_numbers(law, number);
    let other = match pair.right {
        Some(_) => "right.left",
        None => "ground",
    };
    contact.insert("between".into(), json!(["left.right", other]));
    contact.insert("law".into(), law.into());
    contact.insert("gap".into(), scaled.bars.gap.into());
    // The relative velocity is the closing speed, shared so that the momentum is 0; a wall does not move.
    let speed = -pair.velocity;
    let bar = |bar: &Bar| json!({ "L": 1, "EA": 4.0 * bar.mass / (bar.travel_time * bar.travel_time), "mass": bar.mass, "n": bar.elements });
    let mut bars = Map::from_iter([("left".to_owned(), bar(&pair.left))]);
    let mut start = Map::from_iter([(
        "left".to_owned(),
        json!({ "v": speed * reduced / pair.left.mass }),
    )]);
    let mut velocities = nodes("left", &pair.left);
    if let Some(right) = &pair.right {
        bars.insert("right".to_owned(), bar(right));
        start.insert(
            "right".to_owned(),
            json!({ "v": -speed * reduced / right.mass }),
        );
        velocities.extend(nodes("right", right));
    }
    let first = CONTACT.into_iter().chain(ENERGIES).map(str::to_owned);
    let velocities = velocities.iter().map(|node| format!("{node}.v"));
    Ok(Described {
        channels: first.chain(velocities).collect(),
        structure: json!({ "bars": bars, "contacts": { "contact": contact }, "start": start }),
    })
}

/// The names of the nodes of a bar.
fn nodes(name: &str, bar: &Bar) -> Vec<String> {
    let inner = (1..bar.elements).map(|i| format!("{name}.{i}"));
    let ends = ["left", "right"].map(|end| format!("{name}.{end}"));
    let [left, right] = ends;
    [left].into_iter().chain(inner).chain([right]).collect()
}

/// The contact, the energy with what the damping of the contact has taken, and the relative velocity of the mass centres at the end over
/// c, of the channels of a motion.
pub fn read(scaled: &Scaled, channels: &[Vec<f64>]) -> Option<(Track<1>, Vec<f64>, f64)> {
    let (contact, rest) = channels.split_at_checked(CONTACT.len())?;
    let (energies, velocities) = rest.split_at_checked(ENERGIES.len())?;
    let [r, rdot, force] = contact else {
        return None;
    };
    let mut track = Track::default();
    for ((r, rdot), s) in r.iter().zip(rdot).zip(force) {
        track.displacement.push(Lane([*r]));
        track.velocity.push(Lane([0.5 * rdot]));
        track.force.push(Lane([0.0 - s]));
    }
    let damping = |i: usize| force[i] - scaled.law.conservative_force(r[i], force[i]);
    let mut damped = 0.0;
    let sum = |i: usize| {
        if i > 0 {
            damped += 0.5 * (damping(i - 1) + damping(i)) * (r[i] - r[i - 1]);
        }
        energies.iter().map(|energy| energy[i]).sum::<f64>() + damped
    };
    let energy = (0..r.len()).map(sum).collect();
    // Half of an element is at each end of a bar.
    let centre = |of_bar: &[Vec<f64>]| {
        let last: Vec<f64> = of_bar.iter().filter_map(|v| v.last().copied()).collect();
        let ends = last.first().zip(last.last());
        let halves = ends.map_or(0.0, |(first, last)| 0.5 * (first + last));
        (last.iter().sum::<f64>() - halves) / (last.len() as f64 - 1.0)
    };
    let (left, right) = velocities.split_at_checked(scaled.pair.left.elements as usize + 1)?;
    let of_right = if right.is_empty() { 0.0 } else { centre(right) };
    Some((track, energy, 0.5 * (of_right - centre(left))))
}
