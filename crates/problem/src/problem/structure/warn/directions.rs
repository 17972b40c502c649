//! Friction by two contacts in two directions, whose limit is a polygon in place of a disc.

use super::doubt::Doubt;
use crate::contact::ContactKind;
use crate::problem::Case;
use crate::problem::structure::given::amount::Amount;
use crate::problem::structure::given::node::NodeRef;
use crate::problem::structure::parts::contact::Contact;
use crate::problem::structure::parts::contact_law::law_named;
use crate::problem::structure::parts::template::Template;
use crate::solve::Warning;
use crate::system::structure::Direction;
use std::sync::Arc;

/// Sine of the angle between directions that are parallel but for round-off.
const PARALLEL: f64 = 1e-9;

/// What a contact joins, without its direction.
#[derive(Debug, PartialEq)]
enum Body<'a> {
    /// A mass by its name without the direction, and its place.
    Mass(&'a str, usize),
    /// A node of matrices.
    Node(usize, &'a str),
    Bar(usize),
    Support(&'a str),
}

/// A body of a contact, and the direction in which the contact moves it.
type Joined<'a> = (Body<'a>, [f64; 3]);

/// Two friction contacts of different directions that join the same bodies.
pub fn of_one_body(template: &Template, case: &Case) -> Option<Doubt> {
    let rubs = |contact: &&Contact| {
        let law = law_named(contact.law.name(case));
        contact.row.is_none() && law.is_some_and(|law| law.kind == ContactKind::Friction)
    };
    let contacts = template.contacts.iter().filter(rubs);
    let joining: Vec<(&Contact, Vec<Joined>)> = contacts
        .filter_map(|contact| Some((contact, bodies(template, case, contact)?)))
        .filter(|(_, bodies)| !bodies.is_empty())
        .collect();
    for (i, joined) in joining.iter().enumerate() {
        let mut fan = vec![joined];
        // Those of other directions than all before.
        for other in &joining[i + 1..] {
            let differs = |known: &&(&Contact, Vec<Joined>)| {
                directions_differ(template, case, &known.1, &other.1) == Some(true)
            };
            if fan.iter().all(differs) {
                fan.push(other);
            }
        }
        if let [first, .., last] = &fan[..] {
            return Some((
                Warning::FrictionDirections,
                fan_words(first, last, fan.len()),
            ));
        }
    }
    None
}

/// The contacts of a fan, and the form of its limit if it is no square.
fn fan_words(
    (first, a): &(&Contact, Vec<Joined>),
    (last, b): &(&Contact, Vec<Joined>),
    count: usize,
) -> String {
    let [of, to] = [a, b].map(|bodies| words(bodies[0].1));
    let [first, last] = [&first.name, &last.name];
    match count {
        2 => format!("contacts {first} in {of} and {last} in {to}"),
        _ => format!(
            "{count} contacts from {first} in {of} to {last} in {to}, a polygon of {} sides",
            2 * count
        ),
    }
}

/// Whether two contacts that join the same bodies have different directions; `None` for those of other bodies.
fn directions_differ(template: &Template, case: &Case, a: &[Joined], b: &[Joined]) -> Option<bool> {
    let mut differ = false;
    let mut pairs = a.iter().map(|(body, x)| {
        let other = b
            .iter()
            .find(|(other, _)| is_same(template, case, body, other))?;
        differ |= !are_parallel(*x, other.1);
        Some(())
    });
    (a.len() == b.len() && pairs.all(|pair| pair.is_some())).then_some(differ)
}

/// The bodies of a contact without the ground; `None` where it turns one.
fn bodies<'a>(
    template: &'a Template,
    case: &Case,
    contact: &'a Contact,
) -> Option<Vec<Joined<'a>>> {
    let mut found: Vec<Joined> = Vec::new();
    for (i, term) in contact.along.iter().enumerate() {
        if let Some(tied) = &term.tied {
            let before = i
                .checked_sub(1)
                .and_then(|i| contact.along[i].tied.as_ref());
            if !before.is_some_and(|before| Arc::ptr_eq(before, tied)) {
                let body = Body::Node(tied.matrices, &tied.node);
                add(
                    template,
                    case,
                    &mut found,
                    (body, tied.direction, &tied.factor),
                )?;
            }
            continue;
        }
        let (direction, body) = match term.node.node {
            NodeRef::Ground => continue,
            NodeRef::Mass(index) => {
                let mass = &template.masses[index];
                let name = mass.name.split('.').next().unwrap_or_default();
                (mass.direction, Body::Mass(name, index))
            }
            NodeRef::Left(bar) | NodeRef::Right(bar) | NodeRef::Inner(bar, _) => {
                (template.bars[bar].direction, Body::Bar(bar))
            }
            NodeRef::Dof(matrices, row) => {
                let dof = template.matrices[matrices].imported.dofs.rows().get(row)?;
                (dof.direction, Body::Node(matrices, &dof.node))
            }
            NodeRef::Support(index) => {
                let support = &template.supports[index];
                (support.direction, Body::Support(&support.name))
            }
        };
        add(template, case, &mut found, (body, direction, &term.factor))?;
    }
    found.retain(|(_, moved)| *moved != [0.0; 3]);
    Some(found)
}

/// Adds a direction in which a contact moves a body; `None` where it turns it.
fn add<'a>(
    template: &Template,
    case: &Case,
    found: &mut Vec<Joined<'a>>,
    (body, direction, factor): (Body<'a>, Direction, &Amount),
) -> Option<()> {
    let mut translations = Direction::TRANSLATIONS.iter();
    let axis = translations.position(|translation| *translation == direction)?;
    let factor = factor.value(case).ok()?;
    let known = found
        .iter_mut()
        .find(|(other, moved)| moved[axis] == 0.0 && is_same(template, case, other, &body));
    match known {
        Some((_, moved)) => moved[axis] = factor,
        None => {
            let mut moved = [0.0; 3];
            moved[axis] = factor;
            found.push((body, moved));
        }
    }
    Some(())
}

/// Masses of one name are one body; so may be two masses of the same size that move in different directions.
fn is_same(template: &Template, case: &Case, first: &Body, second: &Body) -> bool {
    match (first, second) {
        (Body::Mass(a, i), Body::Mass(b, j)) => {
            let [mass, other] = [*i, *j].map(|index| &template.masses[index]);
            let are_whole = !mass.name.contains('.') && !other.name.contains('.');
            let [m, n] = [mass, other].map(|part| part.mass.value(case));
            a == b || are_whole && mass.direction != other.direction && m.is_ok() && m == n
        }
        (Body::Node(matrices, a), Body::Node(other, b)) => {
            let dofs = &template.matrices[*matrices].imported.dofs;
            // Two nodes at one point of a rigid link move as one.
            let both = Direction::TRANSLATIONS
                .map(|direction| [a, b].map(|node| dofs.rows_of(node, direction)));
            let moves = both.iter().flatten().any(Option::is_some);
            matrices == other && (a == b || moves && both.iter().all(|[a, b]| a == b))
        }
        (first, second) => first == second,
    }
}

fn are_parallel(a: [f64; 3], b: [f64; 3]) -> bool {
    let product = |i: usize, j: usize| a[i] * b[j] - a[j] * b[i];
    let size = |x: [f64; 3]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
    size([product(0, 1), product(1, 2), product(2, 0)]) <= PARALLEL * size(a) * size(b)
}

/// A direction as x, or by its components.
fn words(direction: [f64; 3]) -> String {
    let names = Direction::TRANSLATIONS.map(Direction::name);
    let components = direction.into_iter().zip(names);
    let not_zero = components.filter(|(factor, _)| *factor != 0.0);
    let parts: Vec<(f64, &str)> = not_zero.collect();
    match parts[..] {
        [(_, name)] => name.to_owned(),
        _ => {
            let parts = parts
                .iter()
                .map(|(factor, name)| format!("{factor:.3} {name}"));
            format!("({})", parts.collect::<Vec<_>>().join(", "))
        }
    }
}
