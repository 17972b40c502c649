//! The assembled structure as text, for `explain`.

use super::lists::{count, lines, list};
use crate::contact::{ClippedLine, ContactKind, ContactLaw};
use crate::problem::numbers::short::short;
use crate::problem::structure::model::contact_duration;
use crate::problem::structure::model::damping::{Modes, modes};
use crate::problem::structure::parts::damping::{rigid_below, vibrating};
use crate::problem::structure::parts::models::Models;
use crate::problem::structure::warn::Restitution;
use crate::solve::{FEWEST_STEPS, TOO_FEW_STEPS};
use crate::system::structure::{
    Contact, Direction, Limit, Load, Motion, Signal, Structure, StructureLaw,
};
use std::f64::consts::PI;

/// Nodes and masses, natural periods without contacts and with elastic ones, contacts, and parts that nothing holds.
/// Matrices have masses by direction, each with a line of its own.
pub fn describe(
    structure: &Structure,
    models: &Models,
    [dt, end]: [f64; 2],
    units: &str,
    restitutions: &[Option<Restitution>],
) -> String {
    let mass = match &models.total {
        Some(total) => by_direction(total),
        None => short(structure.nodes.iter().map(|node| node.mass).sum()),
    };
    let units = match units {
        "" => String::new(),
        units => format!(" (units: {units})"),
    };
    let mut text = format!(
        "structure: {}, total mass {}, {}, {}{units}\n",
        count(structure.len(), "node"),
        mass,
        count(structure.contacts.len(), "contact"),
        count(loads(structure), "load"),
    );
    for summary in &models.each {
        text += &format!(
            "matrices {}: {}, {} of them without mass, mass {}\n",
            summary.name,
            count(summary.dofs, "dof"),
            summary.massless,
            by_direction(&summary.mass),
        );
    }
    let nodes = structure
        .nodes
        .iter()
        .map(|node| format!("{} {}", node.name, short(node.mass)));
    text += &list("nodes and masses", nodes.collect());
    if let Some(modes) = modes(structure, &structure.stiffness) {
        text += &periods("without contacts", &modes, structure);
    }
    let elastic = |contact: &Contact| contact.initial_stiffness() > 0.0;
    if structure.contacts.iter().any(elastic)
        && let Some(modes) = modes(structure, &structure.initial_stiffness())
    {
        text += &periods(
            "with the elastic contacts at their initial stiffness",
            &modes,
            structure,
        );
    }
    let contacts = structure
        .contacts
        .iter()
        .enumerate()
        .map(|(index, contact)| {
            let law = law(&contact.law);
            let gap = match contact.gap {
                0.0 => String::new(),
                gap => format!(", gap {}", short(gap)),
            };
            let touch = touch(structure, contact, dt);
            let of_contact = restitutions.get(index).copied().flatten();
            let restitution = of_contact.map_or(String::new(), |stated| format!(", {stated}"));
            format!(
                "{}: {}{gap}, {law}{restitution}{touch}{}",
                contact.name,
                ends(structure, index),
                closes(structure, contact),
            )
        });
    text += &lines("contacts", contacts.collect());
    let supports = structure.supports.iter().map(|support| {
        let [u, v] = largest(&support.motion, end);
        let start = support.motion.start();
        format!(
            "{}: moves from t = {} on, largest |u| {}, |v| {} up to t = {}",
            support.name,
            short(start),
            short(u),
            short(v),
            short(end),
        )
    });
    text += &lines("supports", supports.collect());
    for part in structure.unheld_parts() {
        text += &format!("nothing holds {part}: without contact and load it moves on freely\n");
    }
    text += "for a picture of the structure, add {\"name\": \"scheme\", \"kind\": \"scheme\"} to \"figures\"\n";
    text
}

/// Number of loads that are not of supports.
fn loads(structure: &Structure) -> usize {
    let is_load = |load: &&Load| !matches!(*load.signal, Signal::Motion(..));
    structure.loads.iter().filter(is_load).count()
}

/// The largest |u| and |v| of a motion up to a time, at its points and at some between.
fn largest(motion: &Motion, end: f64) -> [f64; 2] {
    const TIMES: u32 = 2000;
    let evenly = (0..=TIMES).map(|i| end * f64::from(i) / f64::from(TIMES));
    let times = evenly.chain(motion.points()).filter(|t| *t <= end);
    times.fold([0.0; 2], |[u, v], t| {
        let [own_u, own_v, _] = motion.at(t);
        [u.max(own_u.abs()), v.max(own_v.abs())]
    })
}

/// Masses by direction, such as `x 156, y 156`.
fn by_direction(mass: &[(Direction, f64)]) -> String {
    let each = mass
        .iter()
        .map(|(direction, mass)| format!("{} {}", direction.name(), short(*mass)));
    match mass.is_empty() {
        true => "0".to_owned(),
        false => each.collect::<Vec<_>>().join(", "),
    }
}

/// The two ends of a contact, or its nodes with their factors.
fn ends(structure: &Structure, contact: usize) -> String {
    let along = &structure.contacts[contact].along;
    let nodes = along
        .iter()
        .map(|(node, factor)| (&structure.nodes[*node].name, *factor));
    let supports = structure.supports.iter().filter_map(|support| {
        let carried = along
            .iter()
            .map(|(node, factor)| factor * support.carried[*node]);
        let gap = support.gaps[contact] - carried.sum::<f64>();
        // Round-off of what the nodes are carried.
        let rounded = (gap * 1e9).round() / 1e9;
        (rounded != 0.0).then_some((&support.name, rounded))
    });
    let mut terms: Vec<(&String, f64)> = nodes.chain(supports).collect();
    if let [(_, 1.0), (_, -1.0)] = terms[..] {
        terms.reverse();
    }
    match terms[..] {
        [(i, -1.0), (j, 1.0)] => format!("{i} to {j}"),
        [(i, -1.0)] => format!("{i} to ground"),
        [(j, 1.0)] => format!("ground to {j}"),
        _ => {
            let terms = terms
                .iter()
                .map(|(name, x)| format!("{} {name}", short(*x)));
            format!("along {}", terms.collect::<Vec<_>>().join(", "))
        }
    }
}

/// The motions that close an impact contact between two nodes of matrices, whose directions are not those of the picture.
fn closes(structure: &Structure, contact: &Contact) -> String {
    let is_impact = contact.law.kind() == ContactKind::Impact;
    let name = |node: usize| &structure.nodes[node].name;
    let of_matrices = |node: usize| name(node).matches('.').count() > 1;
    match contact.along[..] {
        [(a, x), (b, y)] if is_impact && of_matrices(a) && of_matrices(b) => {
            let sign = |factor: f64| if factor > 0.0 { "-" } else { "+" };
            let (a, x, b, y) = (name(a), sign(x), name(b), sign(y));
            format!("; closes when {a} moves {x} or {b} moves {y}")
        }
        _ => String::new(),
    }
}

/// The periods of these squares of natural frequencies, and the number of rigid-body modes.
fn periods(which: &str, modes: &Modes, structure: &Structure) -> String {
    let omega2 = &modes.omega2;
    let round_off = rigid_below(omega2);
    let free = omega2.iter().filter(|x| x.abs() <= round_off).count();
    let held = vibrating(omega2);
    let periods = held
        .iter()
        .map(|mode| short(2.0 * PI / omega2[*mode].sqrt()));
    let mut text = list(&format!("natural periods {which}"), periods.collect());
    if let Some(ratios) = modes.ratios(structure) {
        let ratios = held.iter().map(|mode| short(ratios[*mode])).collect();
        text += &list(&format!("damping ratios of these modes {which}"), ratios);
    }
    if free > 0 {
        text += &format!("rigid-body modes {which}: {free}\n");
    }
    let mut pulled: Vec<usize> = (0..omega2.len())
        .filter(|k| omega2[*k] < -round_off)
        .collect();
    pulled.sort_by(|a, b| omega2[*a].total_cmp(&omega2[*b]));
    let pulled = pulled.iter().map(|k| {
        let time = short(1.0 / (-omega2[*k]).sqrt());
        let node = &structure.nodes[modes.most_moved(*k)].name;
        format!("mostly {node}, grows by e in {time}")
    });
    let name = format!("modes that the stiffness pulls away {which}");
    text + &list(&name, pulled.collect())
}

fn law(relation: &StructureLaw) -> String {
    let pressing = |limit: &Limit| {
        let pressed_by = limit.pressed_by.as_ref();
        pressed_by.map_or(0, |parts| parts.contacts.len() + parts.springs.len())
    };
    let limit = |limit: &Limit| match limit.varying {
        _ if pressing(limit) == 1 => "limit by the force of another part".to_owned(),
        _ if pressing(limit) > 1 => format!("limit by the forces of {} parts", pressing(limit)),
        None => format!("limit {}", short(limit.at(0.0))),
        Some(_) => format!("limit {} at t = 0, varying", short(limit.at(0.0))),
    };
    let given = relation.as_given();
    let text = match relation.line() {
        Some(ClippedLine::Spring { stiffness }) => {
            format!("impact spring k = {}", short(stiffness))
        }
        Some(ClippedLine::Stop { restitution }) => {
            let e = short(restitution);
            format!("rigid impact, restitution {e} in the exact motion; the time steps ignore it")
        }
        Some(ClippedLine::Elastic { stiffness }) => {
            format!("{} k = {}", given.name(), short(stiffness))
        }
        Some(ClippedLine::Viscous { viscosity }) => {
            format!("{} c = {}", given.name(), short(viscosity))
        }
        _ if relation.is_rigid() => "Coulomb friction".to_owned(),
        _ => curved(&given),
    };
    let plane = relation.row().map_or("", |_| " in a plane");
    let limit = relation.limit().map(|bound| format!(", {}", limit(bound)));
    let static_ratio = match relation.static_ratio() {
        1.0 => String::new(),
        ratio => format!(", sticks up to {} times it", short(ratio)),
    };
    format!("{text}{plane}{}{static_ratio}", limit.unwrap_or_default())
}

/// A law that is not a clipped line, with its numbers.
fn curved(law: &ContactLaw) -> String {
    let shown = law.properties().shown();
    let numbers = shown
        .iter()
        .map(|(name, x)| format!("{name} {}", short(*x)));
    format!("{} {}", law.name(), numbers.collect::<Vec<_>>().join(", "))
}

/// How long the nodes of an impact touch, as two free masses, and whether the step resolves it; empty if only the motion says it.
fn touch(structure: &Structure, contact: &Contact, dt: f64) -> String {
    let Some(time) = contact_duration::time(structure, contact, None) else {
        return String::new();
    };
    let steps = time / dt;
    let warning = match steps < FEWEST_STEPS {
        true => format!("; {TOO_FEW_STEPS}"),
        false => String::new(),
    };
    format!(
        ", its nodes touch for {} = {steps:.1} steps{warning}",
        short(time)
    )
}
