//! Target spectra: periods and ordinates, or the shape of a code.

use super::table::table;
use crate::source::faults::Faults;
use crate::source::object::Object;
use crate::source::tree::Node;
use crate::structure::keys::{SPECTRUM, TARGET, TARGET_TABLE};
use crate::structure::reading::reader::Reader;
use slipgap_problem::problem::structure::given::amount::Amount;
use slipgap_problem::problem::structure::given::target_spectrum::TargetSpectrum;

/// A target spectrum: periods and ordinates, or the shape of a code.
pub(super) fn target(
    node: &Node,
    path: &str,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<TargetSpectrum> {
    let object = Object::open(node, path, &TARGET, faults)?;
    let mut codes = SPECTRUM.fields();
    let code = codes.find(|code| object.get(code.name).is_some());
    let Some(code) = code else {
        let table = table(node, path, &TARGET_TABLE, reader, faults);
        return table.map(TargetSpectrum::Table);
    };
    if object.members.len() > 1 {
        let message = "must have T and Sa, or one of EN 1998-1, ASCE 7";
        object.fault(message, faults);
        return None;
    }
    let of_code = object.object(code.name, faults)?;
    let fields = of_code.keys().fields();
    // All are read, so that every fault is reported.
    let read: Vec<Option<Amount>> = fields
        .map(|field| reader.number(&of_code, field.name, faults))
        .collect();
    let numbers = read.into_iter().collect::<Option<Vec<Amount>>>()?;
    match <[Amount; 5]>::try_from(numbers) {
        Ok(five) => Some(TargetSpectrum::En1998(Box::new(five))),
        Err(three) => Some(TargetSpectrum::Asce7(Box::new(three.try_into().ok()?))),
    }
}
