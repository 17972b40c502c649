//! Matrices of other programs: the files of M, K and C, and the names of their rows.

pub(super) mod rows;
use super::keys::{MATRICES, REDUCE};
use crate::source::faults::{Faults, join, quoted};
use crate::source::object::Object;
use crate::structure::matrices::rows::{LARGEST, inline, listed, supported, with_more};
use crate::structure::reading::files;
use crate::structure::reading::reader::Part;
use crate::structure::reading::reader::Reader;
use crate::value::text;
use slipgap_problem::problem::interned;
use slipgap_problem::problem::structure::channels::channel::Term;
use slipgap_problem::problem::structure::given::rows::Rows;
use slipgap_problem::problem::structure::metrics::{metric::StructureMetric, reduction::Reduction};
use slipgap_problem::problem::structure::parts::template::{Matrices, Template, Variant};
use slipgap_problem::problem::structure::tables::schema::Drawn;
use slipgap_problem::problem::structure::{
    parts::reduce::{Modes, Reduce},
    tables::named_rows::named_rows,
};
use slipgap_system::system::structure::Symmetric;
use slipgap_system::system::{
    import::{Dofs, ImportFault, Imported, Matrix},
    structure::sparse::factor::negative_pivot,
};
use std::sync::Arc;

/// The matrices, each with its name.
pub(super) fn matrices(parts: &[Part], reader: &Reader, faults: &mut Faults) -> Vec<Matrices> {
    let one = |(name, node, path): &Part| {
        let object = Object::open(node, path, &MATRICES, faults)?;
        let variants = variants(name, &object, reader, faults)?;
        let imported = variants.first()?.1.clone();
        let motion = |support: &str, direction| reader.names.motion(support, direction);
        Some(Matrices {
            name: name.clone(),
            rows: Arc::new(Rows::new(&imported.dofs, motion)),
            place: (node.at, path.clone()),
            imported,
            variants,
            reduce: None,
        })
    };
    parts.iter().filter_map(one).collect()
}

/// The modes that each of the matrices is reduced to; `None` without a reduction.
pub(super) fn modes(parts: &[Part], reader: &Reader, faults: &mut Faults) -> Vec<Option<Modes>> {
    let mut one = |(_, node, path): &Part| {
        let object = Object::open(node, path, &MATRICES, faults)?;
        let (node, path) = object.given("reduce", faults)?;
        let reduce = Object::open(node, &path, &REDUCE, faults)?;
        match (reduce.get("modes"), reduce.get("up_to")) {
            (Some(_), None) => reader.number(&reduce, "modes", faults).map(Modes::Number),
            (None, Some(_)) => reader.number(&reduce, "up_to", faults).map(Modes::UpTo),
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
    if reduced {
        refuse_base(metrics, drawn, faults);
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
        if matrices.variants.len() > 1 {
            let message = "a reduction needs files that no parameter chooses";
            faults.add(node.at, &join(path, "reduce"), message);
            continue;
        }
        let rows: Vec<String> = kept.iter().map(|row| row.to_string()).collect();
        reader.keep(&format!("{name}\0kept"), rows.join(",").as_bytes());
        matrices.reduce = Some(Reduce::new(matrices.imported.clone(), kept, modes));
    }
}

/// Reports channels of the force of the ground, which the coordinates of reduced matrices do not tell.
fn refuse_base(metrics: &[StructureMetric], drawn: &[Drawn], faults: &mut Faults) {
    let metrics = metrics.iter();
    let of_metrics = metrics.filter_map(|metric| Some((metric.channel.as_ref()?, &metric.place)));
    let channels = of_metrics.chain(
        drawn
            .iter()
            .map(|history| (&history.channel, &history.place)),
    );
    let is_base = |(_, term): &(f64, Term)| matches!(term, Term::Base(_));
    for (channel, (at, path)) in channels.filter(|(channel, _)| channel.terms.iter().any(is_base)) {
        let message = format!(
            "{}: reduced matrices do not tell the force of the ground; leave out \"reduce\", or name a support that moves, as in base.left",
            quoted(&channel.name)
        );
        faults.add(*at, path, message);
    }
}

/// How the content of a Matrix Market file begins.
const BEGINNING: &str = "%%MatrixMarket";

/// The file of a matrix, and the row of the parameter that chooses it.
type File = (Option<usize>, &'static str, Arc<Symmetric>);

/// M, K and C for all files that a case may choose.
fn variants(
    name: &str,
    object: &Object,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Vec<Variant>> {
    let given = object.given("dofs", faults);
    let untied = given.and_then(|(node, path)| {
        let parse = |bytes: &[u8]| supported(Dofs::parse(bytes)?, reader);
        if let Some(rows) = node.list() {
            return inline(&listed(rows), (node, &path), faults, parse);
        }
        let file = text(node, &path, faults)?;
        files::read(&file, (node, &path), LARGEST, reader, faults, parse)
    });
    let mut with = |dofs: Option<Dofs>, key: &str, parse: fn(Dofs, &[u8]) -> Result<Dofs, _>| {
        let dofs = dofs?;
        let Some((node, path)) = object.given(key, faults) else {
            return Some(dofs);
        };
        with_more((node, &path), reader, faults, |bytes| parse(dofs, bytes))
    };
    let tied = with(untied, "ties", Dofs::with_ties);
    let dofs = with(tied, "forces", Dofs::with_forces);
    let of_key = |key: &str, faults: &mut Faults| -> Option<Vec<File>> {
        let (node, path) = object.given(key, faults)?;
        let parse = |bytes: &[u8]| {
            let matrix = checked(Matrix::parse(bytes)?, name, key, dofs.as_ref())?;
            // A reduction eliminates all places that the file has.
            let keeps_zeros = object.get("reduce").is_some();
            Ok(matrix.packed(|value| keeps_zeros || value != 0.0))
        };
        if let Some(content) = node.text().filter(|text| text.starts_with(BEGINNING)) {
            let matrix = inline(content, (node, &path), faults, parse)?;
            return Some(vec![(None, "", Arc::new(matrix))]);
        }
        let given = text(node, &path, faults)?;
        let (row, names) = match reader.choices(&given) {
            Some((row, names)) => (Some(row), names.iter().map(|file| file.0).collect()),
            None => (None, vec![interned(&given)]),
        };
        let before = faults.count();
        let files = names.into_iter().filter_map(|file| {
            let matrix = files::read(file, (node, &path), LARGEST, reader, faults, parse)?;
            Some((row, file, Arc::new(matrix)))
        });
        let files: Vec<File> = files.collect();
        (faults.count() == before && !files.is_empty()).then_some(files)
    };
    let (masses, stiffnesses) = (of_key("M", faults), of_key("K", faults));
    let dampings = match object.get("C") {
        Some(_) => of_key("C", faults)?.into_iter().map(Some).collect(),
        None => vec![None],
    };
    let (masses, stiffnesses, dofs) = (masses?, stiffnesses?, Arc::new(dofs?));
    let mut variants = Vec::new();
    for mass in &masses {
        for stiffness in &stiffnesses {
            for damping in &dampings {
                let files = [Some(mass), Some(stiffness), damping.as_ref()];
                let given = files.into_iter().flatten();
                let chosen: Vec<(usize, &str)> = given
                    .filter_map(|(row, file, _)| Some(((*row)?, *file)))
                    .collect();
                let imported = Imported {
                    mass: mass.2.clone(),
                    stiffness: stiffness.2.clone(),
                    is_negative: negative_pivot(&stiffness.2).is_some(),
                    damping: damping.as_ref().map(|damping| damping.2.clone()),
                    dofs: dofs.clone(),
                };
                variants.push((chosen, Arc::new(imported)));
            }
        }
    }
    Some(variants)
}

/// A matrix that fits the rows, and M without a negative pivot. What K pulls away contacts may hold, which a case tells.
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
    if key == "M" {
        matrix.check_pivots(|row| format!("{name}.{}", dofs.name(row)))?;
    }
    Ok(matrix.matrix)
}
