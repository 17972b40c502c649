//! What may be a mistake in a structure, though it can be solved.

use super::keys::RULES;
use super::reading::given;
use crate::source::faults::any_of;
use crate::source::tree::Node;
use slipgap_contact::contact::ContactKind;
use slipgap_problem::problem::structure::channels::names::Names;
use slipgap_problem::problem::structure::given::amount::Source;
use slipgap_problem::problem::structure::given::chosen::Chosen;
use slipgap_problem::problem::structure::given::node::NodeRef;
use slipgap_problem::problem::structure::parts::along::Term;
use slipgap_problem::problem::structure::parts::contact::Contact;
use slipgap_problem::problem::structure::parts::contact_law::law_named;
use slipgap_problem::problem::structure::parts::template::Template;
use slipgap_system::system::structure::Direction;

/// Coordinates that differ by less than this part of them are one.
const SAME: f64 = 1e-9;

/// The doubts of a structure, in words.
pub(super) fn notes(template: &Template, names: &Names, structure: &Node) -> Vec<String> {
    let mut notes = Vec::new();
    let sampled = given::has_key(structure, &["record", "synthetic"]);
    if template.units.is_empty() && sampled {
        notes.push(
            "without \"units\" the accelerations of records and synthetic motions are in m/s^2; \"units\" converts them".to_owned(),
        );
    }
    if nothing_moves(template) {
        notes.push(
            "nothing moves the structure: it has no ground motion, supports, loads, static loads or start".to_owned(),
        );
    }
    notes.extend(idle_ground(template));
    notes.extend(scaled_apart(structure));
    notes.extend(small_set(template));
    let exchanged = template.contacts.iter();
    notes.extend(exchanged.filter_map(|contact| exchanged_nodes(contact, names)));
    notes
}

/// A ground or a support whose motions in x and y get each a factor of its own, though it is not said.
fn scaled_apart(structure: &Node) -> Option<String> {
    let members = given::member(structure, "supports").map(given::members);
    let listed = members.unwrap_or_default().iter();
    let supports = listed.map(|support| (format!("support {}", support.key), &support.node));
    let ground = given::member(structure, "ground").map(|motion| ("ground".to_owned(), motion));
    let is_apart = |part: &(String, &Node)| {
        ["x", "y"].iter().all(|key| {
            let motion = given::member(part.1, key);
            let scale_to = motion.and_then(|node| given::member(node, "scale_to"));
            scale_to.is_some_and(|node| given::member(node, "component").is_none())
        })
    };
    let (name, _) = ground.into_iter().chain(supports).find(is_apart)?;
    let together = match &*name {
        "ground" => "\"scale_to\" of the ground with a \"component\" gives both one factor, ",
        _ => "",
    };
    Some(format!(
        "{name}: x and y get each a factor of its own by \"scale_to\", which changes their ratio; {together}\"component\": \"each\" in both ends this note"
    ))
}

/// A set with fewer motions than its rule asks for.
fn small_set(template: &Template) -> Option<String> {
    let (_, set) = template.set()?;
    let rule = RULES.iter().find(|rule| Some(rule.name) == set.rule)?;
    let count = set.members.len();
    (count < rule.motions).then(|| {
        format!(
            "{} needs at least {} motions, the set has {count}",
            rule.name, rule.motions
        )
    })
}

/// The directions of the ground in which no node moves.
fn idle_ground(template: &Template) -> Option<String> {
    let masses = template.masses.iter().map(|mass| mass.direction);
    let bars = template.bars.iter().map(|bar| bar.direction);
    let matrices = template.matrices.iter();
    let rows = matrices.flat_map(|matrices| matrices.imported.dofs.rows());
    let moving: Vec<Direction> = masses
        .chain(bars)
        .chain(rows.map(|dof| dof.direction))
        .collect();
    let names = |moves: bool, wanted: &[Direction]| {
        let matching = wanted.iter().filter(|one| moving.contains(one) == moves);
        matching.map(|one| one.name()).collect::<Vec<_>>()
    };
    let ground: Vec<Direction> = template.ground.iter().map(|pair| pair.0).collect();
    let idle = names(false, &ground);
    (!idle.is_empty()).then(|| {
        format!(
            "the ground motion in {} moves nothing: nodes move in {}",
            any_of(&idle),
            any_of(&names(true, &Direction::TRANSLATIONS))
        )
    })
}

fn nothing_moves(template: &Template) -> bool {
    template.ground.is_empty()
        && template.supports.is_empty()
        && template.loads.is_empty()
        && template.at_rest.is_empty()
        && template.start.is_empty()
        && !template.contacts.iter().any(may_press)
}

/// Whether r of a contact at rest may have a force: an impact with a gap that may be below 0, or another law with a gap. A friction law
/// has none.
fn may_press(contact: &Contact) -> bool {
    let Some(gap) = &contact.gap else {
        return false;
    };
    let kind = match &contact.law {
        Chosen::Name(law) => law_named(law).map(|law| law.kind),
        Chosen::Parameter(_) => None,
    };
    match (kind, &gap.source) {
        (Some(ContactKind::Friction), _) => false,
        (Some(ContactKind::Impact), Source::Number(gap)) => *gap < 0.0,
        (Some(ContactKind::Link) | None, Source::Number(gap)) => *gap != 0.0,
        (_, Source::Expression(_)) => true,
    }
}

/// An impact contact between nodes I and J of which I has the larger coordinate: it closes when they move apart.
fn exchanged_nodes(contact: &Contact, names: &Names) -> Option<String> {
    let Chosen::Name(law) = contact.law else {
        return None;
    };
    if law_named(law)?.kind != ContactKind::Impact {
        return None;
    }
    let factor = |term: &Term| match term.factor.source {
        Source::Number(x) => Some(x),
        _ => None,
    };
    let [first, second] = &contact.along[..] else {
        return None;
    };
    // A tied dof is elsewhere than its row.
    if first.tied.is_some() || second.tied.is_some() {
        return None;
    }
    let (i, j) = match (factor(first)?, factor(second)?) {
        (-1.0, 1.0) => (first, second),
        (1.0, -1.0) => (second, first),
        _ => return None,
    };
    let located = |term: &Term| {
        let NodeRef::Dof(matrices, row) = term.node.node else {
            return None;
        };
        let (part, imported) = names.matrices.get(matrices)?;
        let dof = imported.dofs.rows().get(row)?;
        let axis = Direction::TRANSLATIONS
            .iter()
            .position(|one| *one == dof.direction)?;
        Some((
            axis,
            dof.at?[axis],
            format!("{part}.{}", imported.dofs.name(row)),
        ))
    };
    let ((axis, x_i, name_i), (other, x_j, name_j)) = (located(i)?, located(j)?);
    let size = SAME * x_i.abs().max(x_j.abs());
    if axis != other || x_i - x_j <= size {
        return None;
    }
    let coordinate = ["X", "Y", "Z"][axis];
    Some(format!(
        "contact {}: {coordinate} of node I, {name_i}, is larger than that of node J, {name_j}, so that the contact closes when they move apart; exchange them if they are two sides of a gap",
        contact.name
    ))
}
