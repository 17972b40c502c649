//! Nodes without mass: what holds them, where they are at t = 0, and the contacts that they may have.

use super::independent::IndependentRows;
use crate::methods::Method;
use crate::system::structure::sparse::factor::{Factor, NotPositive};
use crate::system::structure::{Along, Contact, Structure};

/// Stiffness of the spring that keeps the place of a node which only contacts hold, over the smallest stiffness of these contacts.
/// It changes their forces by about this part, and the round-off of the forces grows by its inverse.
const KEEPS_PLACE: f64 = 1e-7;

/// Gives the nodes without mass that only contacts hold weak springs parallel to their softest contacts: while all of its contacts are
/// open or slide, no equation says where such a node is. The springs are independent, so that they hold nodes with a common softest
/// contact, too. The steps need none for the nodes between contacts in series ([`Structure::chains`]).
pub fn hold(structure: &mut Structure) {
    if !structure.has_mass_everywhere() {
        let is_between = structure.chain_nodes();
        hold_others(structure, &is_between);
    }
}

/// The structure with such springs at the nodes between contacts in series, too, for an exact motion, which has a matrix of them;
/// `None` without such nodes.
pub fn with_springs_in_series(structure: &Structure) -> Option<Structure> {
    if structure.chains().is_empty() {
        return None;
    }
    let mut held = structure.clone();
    hold_others(&mut held, &vec![false; structure.len()]);
    Some(held)
}

/// Holds nodes but those which are held already.
fn hold_others(structure: &mut Structure, is_between: &[bool]) {
    if structure.has_mass_everywhere() {
        return;
    }
    // Supports come after the nodes.
    let is_held = structure.stiffness.nonzero_rows();
    let mass = |node: usize| structure.nodes[node].mass;
    let nodes = 0..structure.len();
    let is_between = |node: usize| is_between.get(node) == Some(&true);
    let is_alone: Vec<bool> = nodes
        .map(|i| mass(i) == 0.0 && !is_held[i] && !is_between(i))
        .collect();
    let mut contacts: Vec<(f64, &Along)> = structure
        .contacts
        .iter()
        .filter(|contact| contact.along.iter().any(|(node, _)| is_alone[*node]))
        .filter_map(|contact| Some((stiffness(contact)?, &contact.along)))
        .collect();
    // In the order of the contacts, but for choosing.
    let mut softest_first: Vec<usize> = (0..contacts.len()).collect();
    softest_first.sort_by(|i, j| contacts[*i].0.total_cmp(&contacts[*j].0));
    let mut chosen = vec![false; contacts.len()];
    let mut rows = IndependentRows::default();
    for i in softest_first {
        let along = contacts[i].1.iter().filter(|(node, _)| is_alone[*node]);
        chosen[i] = rows.add(along.copied());
    }
    let mut chosen = chosen.into_iter();
    contacts.retain(|_| chosen.next() == Some(true));
    let springs = contacts
        .into_iter()
        .map(|(k, along)| (KEEPS_PLACE * k, along.clone()));
    for (k, along) in springs.collect::<Vec<_>>() {
        structure.stiffness.add_along(&along, k);
    }
}

/// The stiffness of a contact with a spring where it presses, or before it slides.
fn stiffness(contact: &Contact) -> Option<f64> {
    if let Some(stiffness) = contact.law.spring() {
        return Some(stiffness);
    }
    let limit = contact.law.limit().map_or(0.0, |limit| limit.at(0.0));
    let law = contact.law.law(limit);
    let overlap = match contact.gap {
        0.0 => 1.0,
        gap => gap.abs(),
    };
    let k = law.properties().initial_stiffness(overlap);
    (k > 0.0 && k.is_finite()).then_some(k)
}

/// The first node without mass that nothing holds, or that the method cannot have: its index, and why.
pub fn fault(structure: &Structure, method: &Method) -> Option<(usize, String)> {
    let massless = structure.massless();
    let node = massless.iter().position(|massless| *massless)?;
    let needs = match (method.has_impulses(), method.corrects()) {
        (true, _) => Some("impulses need one"),
        (false, true) => Some("the correction of displacements needs one"),
        (false, false) => None,
    };
    if let Some(needs) = needs {
        let why = format!("has no mass: {needs}; choose another method, or give it a mass");
        return Some((node, why));
    }
    match condensed(structure, &massless) {
        Ok(_) => None,
        Err(node) => Some((
            node,
            "has no mass, and nothing holds it; give it a mass, a spring or a contact".into(),
        )),
    }
}

/// The nodes without mass but those between contacts in series, and the factor of their K; else a node that nothing holds.
fn condensed(structure: &Structure, massless: &[bool]) -> Result<(Vec<usize>, Factor), usize> {
    let is_between = structure.chain_nodes();
    let nodes: Vec<usize> = (0..structure.len())
        .filter(|node| massless[*node] && !is_between[*node])
        .collect();
    let block = structure.stiffness.block(&nodes);
    let factor =
        Factor::new(&block, &vec![false; nodes.len()]).map_err(|NotPositive { row }| nodes[row])?;
    Ok((nodes, factor))
}

/// Puts the nodes without mass where K u = p holds at t = 0 without contact forces, and stops them. Contacts that are pressed there
/// push them in the first step.
pub fn place(structure: &mut Structure) {
    if structure.has_mass_everywhere() {
        return;
    }
    let massless = structure.massless();
    if !massless.contains(&true) {
        return;
    }
    let Ok((nodes, factor)) = condensed(structure, &massless) else {
        return;
    };
    for (node, _) in massless
        .iter()
        .enumerate()
        .filter(|(_, massless)| **massless)
    {
        (structure.displacement[node], structure.velocity[node]) = (0.0, 0.0);
    }
    let mut loads = vec![0.0; structure.len()];
    structure.add_loads(0.0, &mut loads);
    let mut inner = vec![0.0; structure.len()];
    structure
        .stiffness
        .add_product(&structure.displacement, &mut inner);
    let mut u: Vec<f64> = nodes
        .iter()
        .map(|node| loads[*node] - inner[*node])
        .collect();
    factor.solve(&mut u);
    for (node, u) in nodes.iter().zip(u) {
        structure.displacement[*node] = u;
    }
    spread(structure);
}

/// Puts the nodes between contacts in series where the motion of the ends is shared equally.
fn spread(structure: &mut Structure) {
    for chain in structure.chains() {
        let u = &structure.displacement;
        let leaders = chain.leaders();
        let ends = leaders.map(|leader| leader.sign * structure.relative(leader.contact, u));
        let share = ends.sum::<f64>() / chain.links.len() as f64;
        for (member, inner) in chain.leaders().zip(&chain.nodes) {
            let r = structure.relative(member.contact, &structure.displacement);
            structure.displacement[inner.node] += inner.factor * (member.sign * share - r);
        }
    }
}
