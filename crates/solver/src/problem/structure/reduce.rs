//! Reductions of matrices in a study: what is kept, with which modes, and what of it a case has.

use super::amount::Amount;
use super::metric::StructureMetric;
use super::node::NodeRef;
use super::schema::Drawn;
use super::template::{Moved, StaticLoad, Template};
use crate::problem::{Case, Violation};
use crate::system::import::Imported;
use crate::system::reduction::{Reduced, Reduction, Wanted};
use crate::system::structure::Direction;
use std::sync::Arc;

/// The reduction of matrices.
#[derive(Debug, Clone)]
pub struct Reduce {
    modes: Modes,
    reduction: Arc<Reduction>,
}

/// How a study says which modes are kept.
#[derive(Debug, Clone)]
pub enum Modes {
    /// Number of the lowest modes, >= 0.
    Number(Amount),
    /// Largest frequency in cycles per unit of time, > 0.
    UpTo(Amount),
}

impl Reduce {
    /// The reduction of matrices to these rows, which rise, and these modes.
    pub fn new(imported: Arc<Imported>, kept: Vec<usize>, modes: Modes) -> Reduce {
        let reduction = Arc::new(Reduction::new(imported, kept));
        Reduce { modes, reduction }
    }

    /// The reduced matrices in a case. Cases share what they have in common.
    ///
    /// # Errors
    /// A number is out of its range, or there is no such reduction.
    pub fn reduced(&self, case: &Case) -> Result<Reduced, Violation> {
        let (amount, wanted) = match &self.modes {
            Modes::Number(amount) => {
                let modes = amount.whole(case, 0, u32::MAX)?;
                (amount, Wanted::Modes(modes as usize))
            }
            Modes::UpTo(amount) => (amount, Wanted::UpTo(amount.value(case)?)),
        };
        let reduced = self.reduction.reduced(wanted);
        reduced.map_err(|why| amount.violation(why.to_string()))
    }
}

/// The rows of each of the matrices that stay in a reduction, rising: those that a part of the structure, a metric or a figure names,
/// and those of supports.
pub fn named_rows(
    template: &Template,
    metrics: &[StructureMetric],
    drawn: &[Drawn],
) -> Vec<Vec<usize>> {
    let springs = template.springs.iter().flat_map(|spring| &spring.along);
    let contacts = template.contacts.iter().flat_map(|contact| &contact.along);
    let along = springs.chain(contacts).map(|term| term.node.node);
    let loads = template.loads.iter().map(|load| &load.at);
    let at_rest = template.at_rest.iter().filter_map(|load| match load {
        StaticLoad::Force(at, _) => Some(at),
        StaticLoad::Gravity(..) => None,
    });
    let moved = loads.chain(at_rest);
    let moved = moved.chain(template.start.iter().map(|start| &start.of));
    let moved = moved.flat_map(|moved| match moved {
        Moved::Node(name) => vec![name.node],
        Moved::Tied(terms) => terms.iter().map(|(_, name)| name.node).collect(),
        Moved::Bar(_) | Moved::Rows(..) => Vec::new(),
    });
    let channels = metrics.iter().filter_map(|metric| metric.channel.as_ref());
    let channels = channels.chain(drawn.iter().map(|drawn| &drawn.channel));
    let terms = channels.flat_map(|channel| &channel.terms);
    let terms = terms.filter_map(|(_, term)| term.node());
    let mut named = vec![Vec::new(); template.matrices.len()];
    for node in along.chain(moved).chain(terms) {
        if let NodeRef::Dof(matrices, row) = node {
            named[matrices].push(row);
        }
    }
    for (named, matrices) in named.iter_mut().zip(&template.matrices) {
        let rows = matrices.imported.dofs.rows().iter().enumerate();
        let of_supports = rows.filter(|(_, dof)| dof.support.is_some());
        named.extend(of_supports.map(|(row, _)| row));
        named.sort_unstable();
        named.dedup();
    }
    named
}

/// The displacements and velocities at t = 0 that all rows of a direction of matrices have.
#[derive(Debug, Clone, Default)]
pub struct Start {
    directions: [Vec<(Direction, f64)>; 2],
}

impl Start {
    /// Replaces what rows of a direction have by what is given of u and v.
    pub fn set(&mut self, direction: Direction, given: [Option<f64>; 2]) {
        for (all, value) in self.directions.iter_mut().zip(given) {
            if let Some(value) = value {
                all.retain(|(known, _)| *known != direction);
                all.push((direction, value));
            }
        }
    }

    /// Sets the coordinates of the modes in u and v. `nodes` are those of the kept rows and the modes; supports are at rest.
    pub fn project(&self, reduced: &Reduced, nodes: &[Option<usize>], motion: [&mut [f64]; 2]) {
        let (kept, modes) = nodes.split_at(reduced.kept().len());
        for (all, values) in self.directions.iter().zip(motion) {
            let kept = kept
                .iter()
                .map(|node| node.map_or(0.0, |node| values[node]));
            let own = reduced.modal(&kept.collect::<Vec<_>>(), all);
            for (node, x) in modes.iter().zip(own) {
                if let Some(node) = node {
                    values[*node] = x;
                }
            }
        }
    }
}

/// What a reduction keeps in a case, for people.
pub fn described(template: &Template, case: &Case, number: impl Fn(f64) -> String) -> String {
    let mut text = String::new();
    for matrices in &template.matrices {
        let Some(Ok(reduced)) = matrices.reduce.as_ref().map(|own| own.reduced(case)) else {
            continue;
        };
        let [last, next] = reduced.frequencies().map(|own| own.map(&number));
        let last = last.map_or(String::new(), |last| format!(" up to the frequency {last}"));
        let next = match next {
            Some(next) => format!(", the first left out has {next}"),
            None => ", none is left out".to_owned(),
        };
        text += &format!(
            "reduction of {}: of {} dofs {} are kept, with {} of {} modes{last}{next} (cycles per unit of time)\n",
            matrices.name,
            matrices.imported.len(),
            reduced.kept().len(),
            reduced.modes(),
            reduced.all_modes(),
        );
    }
    text
}
