//! Matrices of other programs: the files of M, K and C, and the names of their rows.

use super::files;
use super::keys::MATRICES;
use super::parts::Part;
use super::reader::{Reader, open};
use crate::source::faults::Faults;
use crate::source::object::Object;
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
            |bytes| supported(Dofs::parse(bytes)?, reader),
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

/// Rows whose supports the study gives.
fn supported(dofs: Dofs, reader: &Reader) -> Result<Dofs, ImportFault> {
    let given = &reader.names.supports;
    let is_given = |support: usize| {
        let name = &dofs.supports[support];
        given.iter().any(|own| own.0 == *name)
    };
    let mut rows = dofs.rows().iter();
    let unknown = rows.find_map(|dof| Some((dof, dof.support.filter(|own| !is_given(*own))?)));
    let Some((dof, support)) = unknown else {
        return Ok(dofs);
    };
    let names: Vec<&str> = given.iter().map(|own| own.0.as_str()).collect();
    let message = match names.is_empty() {
        true => format!(
            "the study has no \"supports\", which give the motion of support {}",
            dofs.supports[support]
        ),
        false => format!(
            "no support {} under \"supports\"; there are {}",
            dofs.supports[support],
            names.join(", ")
        ),
    };
    Err(ImportFault {
        line: dof.line,
        message,
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
