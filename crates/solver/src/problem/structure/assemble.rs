//! The structure of a case: masses, bars and springs as matrices, with contacts, loads and start.

use super::amount::Amount;
use super::contacts;
use super::damping::MOST_MODES;
use super::massless;
use super::node::{NodeName, Numbering, RowsInCase};
use super::reduce::Start as DirectionStart;
use super::template::{DampingStiffness, Matrices, Moved, Scaled, SpringNumbers, Template, Term};
use crate::problem::{Case, Violation};
use crate::system::reduction::Reduced;
use crate::system::structure::Direction;
use crate::system::structure::{Along, Load, Node, Structure, StructureLaw, Symmetric};
use std::borrow::Cow;
use std::f64::consts::PI;
use std::sync::Arc;

/// Most elements of a bar, and most nodes of a structure.
pub const MOST_NODES: u32 = 100_000;

/// Which model of a case is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Model {
    /// That of the study.
    Study,
    /// With so many times the elements in each bar; the contacts are those of the study.
    Finer(u32),
    /// With the whole matrices, not reduced ones.
    Unreduced,
}

/// What of a structure is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Detail {
    /// Nothing: its numbers are checked.
    Numbers,
    /// All but sampled loads, which are checked.
    WithoutSamples,
    /// All.
    Whole,
}

/// A structure under construction, with all rules that it breaks.
struct Draft<'a> {
    detail: Detail,
    template: &'a Template,
    case: &'a Case,
    numbering: Numbering,
    /// The reduction of each of the matrices.
    reduced: Vec<Option<Reduced>>,
    structure: Structure,
    violations: Vec<Violation>,
}

/// The numbers of the nodes of a case.
///
/// # Errors
/// Every rule that the case breaks.
pub fn check(template: &Template, case: &Case) -> Result<Numbering, Vec<Violation>> {
    draft(template, case, Model::Study, Detail::Numbers).map(|(_, numbering)| numbering)
}

/// The structure of a case, without modal damping, and the numbers of its nodes.
///
/// # Errors
/// Every rule that the case breaks.
pub fn assemble(
    template: &Template,
    case: &Case,
    model: Model,
) -> Result<(Structure, Numbering), Vec<Violation>> {
    draft(template, case, model, Detail::Whole)
}

/// The structure of a case without its sampled loads, for the cost of its motion.
///
/// # Errors
/// Every rule that the case breaks.
pub fn outline(
    template: &Template,
    case: &Case,
    model: Model,
) -> Result<Structure, Vec<Violation>> {
    draft(template, case, model, Detail::WithoutSamples).map(|(structure, _)| structure)
}

fn draft(
    template: &Template,
    case: &Case,
    model: Model,
    detail: Detail,
) -> Result<(Structure, Numbering), Vec<Violation>> {
    let mut violations = Vec::new();
    let mut elements = Vec::new();
    for bar in &template.bars {
        match bar.elements.whole(case, 1, MOST_NODES) {
            Ok(n) => elements.push(n),
            Err(violation) => violations.push(violation),
        }
    }
    let nodes = elements.iter().fold(0u64, |sum, n| sum + u64::from(*n) + 1);
    if violations.is_empty() && nodes > u64::from(MOST_NODES) {
        let first = template.bars.first();
        violations.extend(first.map(|bar| {
            bar.elements.violation(format!(
                "gives {nodes} nodes, at most {MOST_NODES} are allowed"
            ))
        }));
    }
    let mut reduced = Vec::with_capacity(template.matrices.len());
    for Matrices { reduce, .. } in &template.matrices {
        let wanted = reduce.as_ref().filter(|_| model != Model::Unreduced);
        match wanted.map(|own| own.reduced(case)).transpose() {
            Ok(own) => reduced.push(own),
            Err(violation) => violations.push(violation),
        }
    }
    if !violations.is_empty() {
        return Err(violations);
    }
    let rows = template.matrices.iter().zip(&reduced);
    let rows = rows.map(|(own, reduced)| match reduced {
        Some(reduced) => RowsInCase::kept(&own.rows, reduced.kept(), reduced.modes()),
        None => RowsInCase::All(own.rows.clone()),
    });
    let finer = match model {
        Model::Finer(finer) => finer,
        Model::Study | Model::Unreduced => 1,
    };
    let numbering = Numbering::new(template.masses.len(), elements, finer, rows.collect());
    let nodes = numbering.nodes();
    // The supports come after the nodes, until their motions are prescribed.
    let size = match detail {
        Detail::Numbers => 0,
        Detail::WithoutSamples | Detail::Whole => nodes + template.supports.len(),
    };
    let mut draft = Draft {
        detail,
        template,
        case,
        numbering,
        reduced,
        structure: Structure {
            nodes: Vec::with_capacity(size),
            coupled_mass: Symmetric::zeros(size),
            stiffness: Symmetric::zeros(size),
            damping: Symmetric::zeros(size),
            contacts: Vec::new(),
            loads: Vec::new(),
            // Overlaps are checked also where nothing is built.
            displacement: vec![0.0; nodes],
            velocity: vec![0.0; nodes],
            supports: Vec::new(),
        },
        violations,
    };
    draft.masses();
    draft.bars();
    draft.matrices();
    draft.springs();
    draft.contacts();
    if draft.is_built() {
        massless::hold(&mut draft.structure);
    }
    draft.rayleigh();
    draft.loads();
    draft.supports();
    draft.start();
    draft.modal_damping();
    draft.overlaps();
    match draft.violations.is_empty() {
        true => Ok((draft.structure, draft.numbering)),
        false => Err(draft.violations),
    }
}

/// The K of Rayleigh and modal damping.
pub fn damping_stiffness<'a>(template: &Template, structure: &'a Structure) -> Cow<'a, Symmetric> {
    match template.damping_stiffness {
        DampingStiffness::WithoutContacts => Cow::Borrowed(&structure.stiffness),
        DampingStiffness::Initial => Cow::Owned(structure.initial_stiffness()),
    }
}

/// Adds M, K and C with these numbers of their rows to those of a structure that has the nodes. Rows without a number are left out.
fn add_matrices(
    to: &mut Structure,
    number: impl Fn(usize) -> Option<usize> + Copy,
    [mass, stiffness]: [&Symmetric; 2],
    damping: Option<&Symmetric>,
) {
    for ((i, j), m) in mass.entries() {
        let (Some(i), Some(j)) = (number(i), number(j)) else {
            continue;
        };
        match to.nodes.get_mut(i) {
            Some(node) if i == j => node.mass = m,
            _ if i != j && m != 0.0 => to.coupled_mass.add(i, j, m),
            _ => {}
        }
    }
    add_block(stiffness, number, &mut to.stiffness);
    if let Some(damping) = damping {
        add_block(damping, number, &mut to.damping);
    }
}

/// Adds the entries of a matrix to another one with these numbers of its rows; those of rows without a number are left out.
fn add_block(from: &Symmetric, number: impl Fn(usize) -> Option<usize>, to: &mut Symmetric) {
    for ((i, j), value) in from.entries().filter(|(_, value)| *value != 0.0) {
        if let (Some(i), Some(j)) = (number(i), number(j)) {
            to.add(i, j, value);
        }
    }
}

impl Draft<'_> {
    /// Whether matrices and nodes are made.
    fn is_built(&self) -> bool {
        self.detail != Detail::Numbers
    }

    /// The value, or 0 with the rule that it breaks.
    fn value(&mut self, amount: &Amount) -> f64 {
        let value = amount.value(self.case);
        self.checked(value).unwrap_or_default()
    }

    fn optional(&mut self, amount: &Option<Amount>) -> f64 {
        amount.as_ref().map_or(0.0, |amount| self.value(amount))
    }

    fn node(&mut self, name: &NodeName) -> Option<usize> {
        let node = self.numbering.of(name);
        self.checked(node).flatten()
    }

    fn checked<T>(&mut self, result: Result<T, Violation>) -> Option<T> {
        result
            .map_err(|violation| self.violations.push(violation))
            .ok()
    }

    fn masses(&mut self) {
        for mass in &self.template.masses {
            let node = Node {
                name: mass.name.clone(),
                mass: self.value(&mass.mass),
                direction: mass.direction,
            };
            self.structure.nodes.push(node);
        }
    }

    /// Lumped masses m/n, half of it at the ends; stiffness n E A/L of each element.
    fn bars(&mut self) {
        for (b, bar) in self.template.bars.iter().enumerate() {
            let n = self.numbering.elements()[b];
            let elements = f64::from(n);
            let (length, stiffness) = (self.value(&bar.length), self.value(&bar.stiffness));
            let element = self.value(&bar.mass) / elements;
            let k = elements * stiffness / length;
            let c = self.optional(&bar.stiffness_damping) * k;
            let first = self.numbering.first(b);
            for i in if self.is_built() { 0..n + 1 } else { 0..0 } {
                let (place, mass) = match i {
                    0 => ("left".to_owned(), 0.5 * element),
                    i if i == n => ("right".to_owned(), 0.5 * element),
                    i => (i.to_string(), element),
                };
                let name = format!("{}.{place}", bar.name);
                let direction = bar.direction;
                self.structure.nodes.push(Node {
                    name,
                    mass,
                    direction,
                });
            }
            for i in if self.is_built() {
                first..first + n as usize
            } else {
                0..0
            } {
                self.add(&[(i, -1.0), (i + 1, 1.0)], k, c);
            }
        }
    }

    /// The matrices of other programs on the diagonal of M, C and K.
    fn matrices(&mut self) {
        if !self.is_built() {
            return;
        }
        for (place, matrices) in self.template.matrices.iter().enumerate() {
            let first = self.numbering.first_row(place);
            let own = matrices.in_case(self.case);
            let node = |row: usize| Node {
                name: format!("{}.{}", matrices.name, own.dofs.name(row)),
                mass: 0.0,
                direction: own.dofs.rows()[row].direction,
            };
            let nodes = &mut self.structure.nodes;
            match &self.reduced[place] {
                None => {
                    nodes.extend(matrices.rows.nodes().map(node));
                    let numbers: Vec<_> = (0..own.len())
                        .map(|row| self.numbering.row(place, row))
                        .collect();
                    add_matrices(
                        &mut self.structure,
                        |row| numbers[row],
                        [&own.mass, &own.stiffness],
                        own.damping.as_deref(),
                    );
                }
                Some(reduced) => {
                    let kept = reduced.kept();
                    let own_rows: Vec<usize> = matrices.rows.nodes().collect();
                    let are_nodes = kept
                        .iter()
                        .filter(|row| own_rows.binary_search(row).is_ok());
                    let before = nodes.len();
                    nodes.extend(are_nodes.map(|row| node(*row)));
                    let first_mode = first + (nodes.len() - before);
                    nodes.extend((1..=reduced.modes()).map(|mode| Node {
                        name: format!("{}.mode{mode}", matrices.name),
                        mass: 0.0,
                        direction: Direction::Modal,
                    }));
                    let (mass, stiffness) = (reduced.mass(), reduced.stiffness());
                    let damping = reduced.damping();
                    add_matrices(
                        &mut self.structure,
                        |row| match kept.get(row) {
                            Some(row) => self.numbering.row(place, *row),
                            None => Some(first_mode + (row - kept.len())),
                        },
                        [&mass, &stiffness],
                        damping.as_ref(),
                    );
                }
            }
        }
    }

    fn add(&mut self, along: &[(usize, f64)], k: f64, c: f64) {
        if !self.is_built() {
            return;
        }
        self.structure.stiffness.add_along(along, k);
        if c != 0.0 {
            self.structure.damping.add_along(along, c);
        }
    }

    /// The factors of the nodes; the ground has none.
    fn along(&mut self, terms: &[Term]) -> Along {
        let mut along: Along = Vec::with_capacity(terms.len());
        for term in terms {
            let factor = self.value(&term.factor);
            let Some(node) = self.node(&term.node) else {
                continue;
            };
            match along.iter_mut().find(|(known, _)| *known == node) {
                Some((_, sum)) => *sum += factor,
                None => along.push((node, factor)),
            }
        }
        along.retain(|(_, factor)| *factor != 0.0);
        along
    }

    fn springs(&mut self) {
        for spring in &self.template.springs {
            let along = self.along(&spring.along);
            let (k, c) = match &spring.numbers {
                SpringNumbers::Stiffness { k, c } => (self.value(k), self.optional(c)),
                SpringNumbers::Period {
                    mass,
                    period,
                    ratio,
                } => {
                    let (mass, period) = (self.value(mass), self.value(period));
                    let omega = 2.0 * PI / period;
                    let c = 2.0 * self.optional(ratio) * omega * mass;
                    (mass * omega * omega, c)
                }
            };
            self.add(&along, k, c);
        }
    }

    /// C += mass M + stiffness K.
    fn rayleigh(&mut self) {
        let [mass, stiffness] = &self.template.rayleigh;
        let (mass, stiffness) = (self.optional(mass), self.optional(stiffness));
        if stiffness != 0.0 && self.is_built() {
            let k = damping_stiffness(self.template, &self.structure).into_owned();
            self.structure.damping.add_matrix(&k, stiffness);
        }
        if mass != 0.0 && self.is_built() {
            let Structure {
                nodes,
                coupled_mass,
                damping,
                ..
            } = &mut self.structure;
            for (i, node) in nodes.iter().enumerate() {
                damping.add(i, i, mass * node.mass);
            }
            damping.add_matrix(coupled_mass, mass);
        }
    }

    fn contacts(&mut self) {
        for contact in &self.template.contacts {
            let along = self.along(&contact.along);
            let nodes = self.numbering.nodes();
            if along.iter().all(|(node, _)| *node >= nodes) && self.violations.is_empty() {
                let message = match along.is_empty() {
                    true => "a contact needs two different nodes",
                    false => "a contact needs a node that is not a support",
                };
                self.violations.push(contacts::violation(contact, message));
            }
            let gap = self.optional(&contact.gap);
            let law = contacts::relation(
                contact,
                self.case,
                self.template.metre,
                self.detail == Detail::Whole,
            );
            if let Some(law) = self.checked(law) {
                self.structure
                    .contacts
                    .push(crate::system::structure::Contact {
                        name: contact.name.clone(),
                        along,
                        gap,
                        law,
                    });
            }
        }
    }

    fn loads(&mut self) {
        for load in &self.template.loads {
            let nodes = self.loaded(&load.at);
            self.load(&load.force, |_, scale| {
                nodes
                    .iter()
                    .map(|(node, share)| (*node, scale * share))
                    .collect()
            });
        }
        for (direction, ground) in &self.template.ground {
            // u is relative to the ground: the load is -M a_g in the nodes of its direction.
            let shaken = match self.detail {
                Detail::Whole => self.shaken(*direction),
                Detail::Numbers | Detail::WithoutSamples => Vec::new(),
            };
            self.load(ground, |_, scale| {
                let masses = shaken.iter().enumerate().filter(|(_, mass)| **mass != 0.0);
                masses.map(|(i, mass)| (i, -scale * mass)).collect()
            });
        }
    }

    /// M times 1 in the nodes of a direction and 0 in the others.
    fn shaken(&self, direction: Direction) -> Vec<f64> {
        let is_shaken = |i: usize| self.structure.nodes[i].direction == direction;
        let nodes = self.structure.nodes.iter().enumerate();
        let mut shaken: Vec<f64> = nodes
            .map(|(i, node)| if is_shaken(i) { node.mass } else { 0.0 })
            .collect();
        for ((i, j), mass) in self.structure.coupled_mass.entries() {
            for (row, column) in [(i, j), (j, i)] {
                if is_shaken(column) {
                    shaken[row] += mass;
                }
            }
        }
        for (place, reduced) in self.reduced.iter().enumerate() {
            if let Some(reduced) = reduced {
                let inertia = reduced.inertia(direction).into_iter();
                for (node, inertia) in self.coordinates(place, reduced).into_iter().zip(inertia) {
                    if let Some(node) = node {
                        shaken[node] = inertia;
                    }
                }
            }
        }
        shaken
    }

    /// The nodes of the kept rows and the modes of reduced matrices; `None` for a row of a support.
    fn coordinates(&self, place: usize, reduced: &Reduced) -> Vec<Option<usize>> {
        let nodes = self.numbering.nodes();
        let kept = reduced.kept().iter().map(|row| {
            let node = self.numbering.row(place, *row);
            node.filter(|node| *node < nodes)
        });
        let end = self.numbering.first_row(place + 1);
        let modes = (end - reduced.modes()..end).map(Some);
        kept.chain(modes).collect()
    }

    /// Prescribes the motions of the supports.
    fn supports(&mut self) {
        let mut motions = Vec::with_capacity(self.template.supports.len());
        for support in &self.template.supports {
            let motion =
                support.in_case(self.case, self.template.metre, self.detail == Detail::Whole);
            if let Some(motion) = self.checked(motion) {
                motions.push((support.full_name(), Arc::new(motion)));
            }
        }
        if self.is_built() && self.violations.is_empty() {
            self.structure.prescribe(motions);
        }
        let nodes = self.numbering.nodes();
        for contact in &mut self.structure.contacts {
            contact.along.retain(|(node, _)| *node < nodes);
        }
    }

    /// The nodes on which a load acts, with the forces of a load of 1.
    fn loaded(&mut self, of: &Moved) -> Vec<(usize, f64)> {
        if let Moved::Rows(matrices, direction) = of
            && let Some(reduced) = &self.reduced[*matrices]
        {
            let forces = match self.is_built() {
                true => reduced.forces(*direction),
                false => Vec::new(),
            };
            let nodes = self.coordinates(*matrices, reduced).into_iter();
            return nodes
                .zip(forces)
                .filter_map(|(node, force)| Some((node?, force)))
                .collect();
        }
        self.moved(of).into_iter().map(|node| (node, 1.0)).collect()
    }

    /// The nodes that a start moves, or on which a load acts; of reduced matrices the kept ones.
    fn moved(&mut self, of: &Moved) -> Vec<usize> {
        match of {
            Moved::Node(name) => self.node(name).into_iter().collect(),
            Moved::Bar(bar) => {
                let first = self.numbering.first(*bar);
                (first..first + self.numbering.elements()[*bar] as usize + 1).collect()
            }
            Moved::Rows(matrices, direction) => {
                let rows = self.template.matrices[*matrices].imported.dofs.rows();
                let rows = rows.iter().enumerate();
                let own = rows.filter(|(_, dof)| dof.direction == *direction);
                let own = own.filter_map(|(row, _)| self.numbering.row(*matrices, row));
                // Those behind the nodes are supports.
                own.filter(|node| *node < self.numbering.nodes()).collect()
            }
        }
    }

    fn load(&mut self, force: &Scaled, pattern: impl Fn(&[Node], f64) -> Vec<(usize, f64)>) {
        if self.detail != Detail::Whole && force.source.is_sampled() {
            let checked = force.check(self.case, self.template.metre);
            self.checked(checked);
            return;
        }
        let found = force.in_case(self.case, self.template.metre);
        if let Some((signal, scale)) = self.checked(found) {
            let pattern = pattern(&self.structure.nodes, scale);
            self.structure.loads.push(Load { pattern, signal });
        }
    }

    fn start(&mut self) {
        let mut starts = vec![DirectionStart::default(); self.reduced.len()];
        for start in &self.template.start {
            let mut given =
                |amount: &Option<Amount>| amount.as_ref().map(|amount| self.value(amount));
            let (u, v) = (given(&start.u), given(&start.v));
            for node in self.moved(&start.of) {
                let Structure {
                    displacement,
                    velocity,
                    ..
                } = &mut self.structure;
                displacement[node] = u.unwrap_or(displacement[node]);
                velocity[node] = v.unwrap_or(velocity[node]);
            }
            if let Moved::Rows(matrices, direction) = &start.of {
                starts[*matrices].set(*direction, [u, v]);
            }
        }
        if !self.is_built() {
            return;
        }
        for (place, start) in starts.iter().enumerate() {
            if let Some(reduced) = &self.reduced[place] {
                let nodes = self.coordinates(place, reduced);
                let Structure {
                    displacement,
                    velocity,
                    ..
                } = &mut self.structure;
                start.project(reduced, &nodes, [displacement, velocity]);
            }
        }
    }

    fn modal_damping(&mut self) {
        let Some(ratio) = &self.template.modal_damping else {
            return;
        };
        self.value(ratio);
        let nodes = self.numbering.nodes();
        if nodes > MOST_MODES {
            let message =
                format!("modal damping is allowed for at most {MOST_MODES} nodes, got {nodes}");
            self.violations.push(ratio.violation(message));
        }
    }

    /// A rigid contact must not overlap at t = 0: it would part at a speed of overlap over time step.
    fn overlaps(&mut self) {
        if !self.violations.is_empty() {
            return;
        }
        for (c, contact) in self.template.contacts.iter().enumerate() {
            let own = &self.structure.contacts[c];
            let r = self.structure.relative(c, &self.structure.displacement) + own.gap;
            if matches!(own.law, StructureLaw::RigidStop { .. }) && r < 0.0 {
                let message = format!("a rigid contact must start with r >= 0, got {r}");
                self.violations.push(contacts::violation(contact, message));
            }
        }
    }
}
