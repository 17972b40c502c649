//! The structure of a case: masses, bars and springs as matrices, with contacts, loads and start.

mod contact_parts;
mod linear_parts;
mod loads;
mod matrices;
mod pressing;
mod start;

pub use linear_parts::damping_stiffness;
pub use loads::inertia;

use super::massless;
use crate::problem::structure::given::amount::Amount;
use crate::problem::structure::given::node::{NodeName, Numbering, RowsInCase};
use crate::problem::structure::parts::along::Term;
use crate::problem::structure::parts::template::{Matrices, Template};
use crate::problem::{Case, Violation};
use crate::system::reduction::Reduced;
use crate::system::structure::{Along, Structure, Symmetric};

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
        match wanted.map(|reduction| reduction.reduced(case)).transpose() {
            Ok(of_block) => reduced.push(of_block),
            Err(violation) => violations.push(violation),
        }
    }
    if !violations.is_empty() {
        return Err(violations);
    }
    let blocks = template.matrices.iter().zip(&reduced);
    let rows = blocks.map(|(matrices, reduced)| match reduced {
        Some(reduced) => RowsInCase::kept(&matrices.rows, reduced.kept(), reduced.modes()),
        None => RowsInCase::All(matrices.rows.clone()),
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
    let mut structure = Structure::new(Vec::with_capacity(size));
    structure.coupled_mass = Symmetric::zeros(size);
    structure.stiffness = Symmetric::zeros(size);
    structure.damping = Symmetric::zeros(size);
    // Overlaps are checked also where nothing is built.
    structure.displacement = vec![0.0; nodes];
    structure.velocity = vec![0.0; nodes];
    structure.observed = (template.observed && detail != Detail::Numbers).then(Box::default);
    let mut draft = Draft {
        detail,
        template,
        case,
        numbering,
        reduced,
        structure,
        violations,
    };
    draft.masses();
    draft.bars();
    draft.matrices();
    draft.springs();
    draft.contacts();
    draft.rayleigh();
    draft.static_loads();
    draft.loads();
    draft.supports();
    draft.start();
    draft.modal_damping();
    if draft.is_built() {
        massless::hold(&mut draft.structure);
    }
    draft.overlaps();
    match draft.violations.is_empty() {
        true => Ok((draft.structure, draft.numbering)),
        false => Err(draft.violations),
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
}
