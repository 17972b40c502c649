//! Matrices of other programs: the files of M, K and C, and the names of their rows.

use super::files;
use super::keys::{MATRICES, REDUCE};
use super::parts::Part;
use super::reader::{Reader, open};
use crate::source::faults::{Faults, join, quoted};
use crate::source::object::Object;
use slipgap_solver::problem::parameter::Range;
use slipgap_solver::problem::structure::metric::{Reduction, StructureMetric};
use slipgap_solver::problem::structure::reduce::{Modes, Reduce, named_rows};
use slipgap_solver::problem::structure::schema::Drawn;
use slipgap_solver::problem::structure::template::Template;
use slipgap_solver::system::import::{Dofs, ImportFault, Imported, Matrix};
use slipgap_solver::system::structure::Symmetric;
use std::sync::Arc;

/// Most bytes of a file: 10^6 rows with 80 entries each.
const LARGEST: u64 = 2 << 30;

/// The matrices, each with its name.
pub(super) fn matrices(
    parts: &[Part],
    reader: &Reader,
    faults: &mut Faults,
) -> Vec<(String, Arc<Imported>)> {
    let one = |(name, node, path): &Part| {
        let object = open(node, path, MATRICES, faults)?;
        Some((
            name.clone(),
            Arc::new(imported(name, &object, reader, faults)?),
        ))
    };
    parts.iter().filter_map(one).collect()
}

/// The modes that each of the matrices is reduced to; `None` without a reduction.
pub(super) fn modes(parts: &[Part], reader: &Reader, faults: &mut Faults) -> Vec<Option<Modes>> {
    let mut one = |(_, node, path): &Part| {
        let object = open(node, path, MATRICES, faults)?;
        let node = object.get("reduce")?;
        let reduce = open(node, &object.path("reduce"), REDUCE, faults)?;
        match (reduce.get("modes"), reduce.get("up_to")) {
            (Some(_), None) => reader
                .optional(&reduce, "modes", Range::NotNegative, faults)
                .map(Modes::Number),
            (None, Some(_)) => reader
                .optional(&reduce, "up_to", Range::Positive, faults)
                .map(Modes::UpTo),
            (Some(_), Some(_)) => {
                reduce.fault("give modes or up_to, not both", faults);
                None
            }
            (None, None) => {
                reduce.fault("missing: modes, or up_to, a frequency", faults);
                None
            }
        }
    };
    parts.iter().map(&mut one).collect()
}

/// Adds the reductions to a template, which keep what the template, the metrics and the figures name. Other kept dofs make another
/// model: their names belong to the identity of the structure.
pub(super) fn reduce(
    template: &mut Template,
    (parts, modes): (&[Part], Vec<Option<Modes>>),
    (metrics, drawn): (&[StructureMetric], &[Drawn]),
    reader: &Reader,
    faults: &mut Faults,
) {
    let reduced = modes.iter().any(Option::is_some);
    let compares = |metric: &&StructureMetric| metric.reduction == Reduction::ReductionError;
    if let (Some(metric), false) = (metrics.iter().find(compares), reduced) {
        let (at, path) = &metric.place;
        let message = format!("{} needs \"reduce\" in \"matrices\"", quoted(&metric.name));
        faults.add(*at, path, message);
    }
    let named = named_rows(template, metrics, drawn);
    let matrices = template.matrices.iter_mut().zip(named);
    for (((matrices, kept), modes), part) in matrices.zip(modes).zip(parts) {
        let Some(modes) = modes else {
            continue;
        };
        let (name, node, path) = part;
        if kept.is_empty() {
            let message = format!(
                "no dof of {name} is kept: no contact, spring, load, start, metric or figure names one"
            );
            faults.add(node.at, &join(path, "reduce"), message);
            continue;
        }
        let rows: Vec<String> = kept.iter().map(|row| row.to_string()).collect();
        reader.keep(&format!("{name}\0kept"), rows.join(",").into_bytes());
        matrices.reduce = Some(Reduce::new(matrices.imported.clone(), kept, modes));
    }
}

fn imported(name: &str, object: &Object, reader: &Reader, faults: &mut Faults) -> Option<Imported> {
    let what = |key: &str| {
        MATRICES
            .iter()
            .find(|own| own.0 == key)
            .map_or("", |own| own.1)
    };
    let dofs = object.need("dofs", what("dofs"), faults);
    let dofs = dofs.and_then(|node| {
        files::read(
            node,
            &object.path("dofs"),
            LARGEST,
            reader,
            faults,
            Dofs::parse,
        )
    });
    let of_file = |key: &str, faults: &mut Faults| -> Option<Symmetric> {
        let node = object.need(key, what(key), faults)?;
        let parse = |bytes: &[u8]| checked(Matrix::parse(bytes)?, name, key, dofs.as_ref());
        files::read(node, &object.path(key), LARGEST, reader, faults, parse)
    };
    let (mass, stiffness) = (of_file("M", faults), of_file("K", faults));
    let before = faults.count();
    let damping = match object.get("C") {
        Some(_) => of_file("C", faults),
        None => None,
    };
    (faults.count() == before).then_some(())?;
    Some(Imported {
        mass: mass?,
        stiffness: stiffness?,
        damping,
        dofs: dofs?,
    })
}

/// A matrix that fits the rows and has no negative pivot.
fn checked(
    matrix: Matrix,
    name: &str,
    key: &str,
    dofs: Option<&Dofs>,
) -> Result<Symmetric, ImportFault> {
    let Some(dofs) = dofs else {
        return Ok(matrix.matrix);
    };
    if matrix.len() != dofs.len() {
        return Err(matrix.wrong_size(dofs.len()));
    }
    if key != "C" {
        matrix.check_pivots(|row| format!("{name}.{}", dofs.name(row)))?;
    }
    Ok(matrix.matrix)
}
