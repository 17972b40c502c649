//! What may be a mistake in a structure, though it can be solved.

use crate::source::faults::{Faults, join};
use crate::source::object::Object;
use crate::source::tree::{Node, Tree};
use slipgap_solver::contact::ContactKind;
use slipgap_solver::problem::structure::amount::Source;
use slipgap_solver::problem::structure::contacts::law_named;
use slipgap_solver::problem::structure::names::Names;
use slipgap_solver::problem::structure::node::NodeRef;
use slipgap_solver::problem::structure::template::{Chosen, Contact, Template, Term};
use slipgap_solver::system::structure::Direction;

/// Coordinates that differ by less than this part of them are one.
const SAME: f64 = 1e-9;

/// The doubts of a structure, in words.
pub(super) fn notes(template: &Template, names: &Names, structure: &Node) -> Vec<String> {
    let mut notes = Vec::new();
    let sampled = super::names::has_key(structure, &["record", "synthetic"]);
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
    let exchanged = template.contacts.iter();
    notes.extend(exchanged.filter_map(|contact| exchanged_nodes(contact, names)));
    notes
}

/// Ground motion in a direction in which no node moves.
pub(super) fn refuse_idle_ground(template: &Template, object: &Object, faults: &mut Faults) {
    let masses = template.masses.iter().map(|own| own.direction);
    let bars = template.bars.iter().map(|own| own.direction);
    let rows = template.matrices.iter();
    let rows = rows.flat_map(|own| own.imported.dofs.rows());
    let all: Vec<Direction> = masses
        .chain(bars)
        .chain(rows.map(|dof| dof.direction))
        .collect();
    let Some(node) = object.get("ground") else {
        return;
    };
    for (direction, _) in &template.ground {
        if all.is_empty() || all.contains(direction) {
            continue;
        }
        let path = object.path("ground");
        let own = match &node.tree {
            Tree::Object(members) => members.iter().find(|own| own.key == direction.name()),
            _ => None,
        };
        let (at, path) = match own {
            Some(own) => (own.at, join(&path, &own.key)),
            None => (node.at, path),
        };
        let known = Direction::TRANSLATIONS
            .into_iter()
            .filter(|one| all.contains(one));
        let known: Vec<&str> = known.map(Direction::name).collect();
        let message = format!(
            "no node moves in {}; nodes move in {}",
            direction.name(),
            crate::source::faults::any_of(&known)
        );
        faults.add(at, &path, message);
    }
}

fn nothing_moves(template: &Template) -> bool {
    template.ground.is_empty()
        && template.supports.is_empty()
        && template.loads.is_empty()
        && template.at_rest.is_empty()
        && template.start.is_empty()
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
    let (i, j) = match (factor(first)?, factor(second)?) {
        (-1.0, 1.0) => (first, second),
        (1.0, -1.0) => (second, first),
        _ => return None,
    };
    let place = |term: &Term| {
        let NodeRef::Dof(matrices, row) = term.node.node else {
            return None;
        };
        let (part, own) = names.matrices.get(matrices)?;
        let dof = own.dofs.rows().get(row)?;
        let axis = Direction::TRANSLATIONS
            .iter()
            .position(|one| *one == dof.direction)?;
        Some((
            axis,
            dof.at?[axis],
            format!("{part}.{}", own.dofs.name(row)),
        ))
    };
    let ((axis, x_i, name_i), (other, x_j, name_j)) = (place(i)?, place(j)?);
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
