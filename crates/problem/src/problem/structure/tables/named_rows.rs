//! The rows of matrices that a study names, and what a reduction keeps.

use super::schema::Drawn;
use crate::problem::Case;
use crate::problem::numbers::short::short;
use crate::problem::structure::given::node::NodeRef;
use crate::problem::structure::metrics::metric::StructureMetric;
use crate::problem::structure::parts::template::{Moved, StaticLoad, Template};

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
    let given = loads
        .chain(at_rest)
        .chain(template.start.iter().map(|start| &start.of));
    let moved = given.flat_map(|moved| match moved {
        Moved::Node(name) => vec![name.node],
        Moved::Tied(terms) => terms.iter().map(|(_, name)| name.node).collect(),
        Moved::Bar(_) | Moved::Rows(..) => Vec::new(),
    });
    let of_metrics = metrics.iter().filter_map(|metric| metric.channel.as_ref());
    let channels = of_metrics.chain(drawn.iter().map(|drawn| &drawn.channel));
    let of_channels = channels.flat_map(|channel| &channel.terms);
    let terms = of_channels.filter_map(|(_, term)| term.node());
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

/// What a reduction keeps in a case, for people.
pub fn described(template: &Template, case: &Case) -> String {
    let mut text = String::new();
    for matrices in &template.matrices {
        let Some(Ok(reduced)) = matrices
            .reduce
            .as_ref()
            .map(|reduction| reduction.reduced(case))
        else {
            continue;
        };
        let [last, next] = reduced.frequencies().map(|frequency| frequency.map(short));
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
