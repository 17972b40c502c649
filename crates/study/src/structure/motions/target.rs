//! Target spectra: periods and ordinates, or the shape of a code.

use super::table::table;
use crate::source::faults::Faults;
use crate::source::object::Object;
use crate::source::tree::Node;
use crate::structure::keys::{ASCE_7, EN_1998, Keys, SPECTRUM, TARGET_TABLE, names};
use crate::structure::reading::reader::{Reader, open};
use slipgap_problem::problem::structure::given::amount::Amount;
use slipgap_problem::problem::structure::given::target_spectrum::TargetSpectrum;

/// A target spectrum: periods and ordinates, or the shape of a code.
pub(super) fn target(
    node: &Node,
    path: &str,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<TargetSpectrum> {
    let mut keys = names(SPECTRUM);
    keys.extend(names(TARGET_TABLE));
    let object = Object::open(node, path, &keys, faults)?;
    let code = names(SPECTRUM)
        .into_iter()
        .find(|key| object.get(key).is_some());
    let Some(code) = code else {
        let table = table(node, path, (TARGET_TABLE, ["T", "Sa"]), reader, faults);
        return table.map(TargetSpectrum::Table);
    };
    if object.members.len() > 1 {
        let message = "must have T and Sa, or one of EN 1998-1, ASCE 7";
        object.fault(message, faults);
        return None;
    }
    let (node, path) = (object.get(code)?, object.path(code));
    let numbers = |keys: Keys, faults: &mut Faults| {
        let object = open(node, &path, keys, faults)?;
        let read = keys
            .iter()
            .map(|key| reader.needed(&object, keys, key.0, faults));
        // All are read, so that every fault is reported.
        let values: Vec<Option<Amount>> = read.collect();
        values.into_iter().collect::<Option<Vec<Amount>>>()
    };
    if code == SPECTRUM[0].0 {
        let five = numbers(EN_1998, faults)?.try_into().ok()?;
        return Some(TargetSpectrum::En1998(Box::new(five)));
    }
    let three = numbers(ASCE_7, faults)?.try_into().ok()?;
    Some(TargetSpectrum::Asce7(Box::new(three)))
}
