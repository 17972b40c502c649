//! What is done to the function of a motion: `start`, `end`, `baseline`, `scale_to` and `delay`.

use super::scale_to::of_motion;
use crate::source::faults::Faults;
use crate::source::object::Object;
use crate::structure::keys::{FUNCTION, range};
use crate::structure::reading::reader::Reader;
use crate::value::name;
use slipgap_problem::problem::structure::given::shape::Shape;
use slipgap_system::system::structure::Baseline;

/// What an object does to its function.
pub(in crate::structure) fn shape(
    object: &Object,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Box<Shape>> {
    let before = faults.count();
    let mut time = |key| reader.optional(object, key, range(FUNCTION, key), faults);
    let mut shape = Box::<Shape>::default();
    shape.start = time("start");
    shape.end = time("end");
    shape.delay = time("delay");
    shape.baseline = baseline(object, faults).unwrap_or_default();
    if let Some(node) = object.get("scale_to")
        && let Some((scale_to, pair)) = of_motion(node, &object.path("scale_to"), reader, faults)
    {
        (shape.scale_to, shape.pair) = (Some(scale_to), pair);
    }
    (faults.count() == before).then_some(shape)
}

/// The baseline of an object.
pub(in crate::structure) fn baseline(object: &Object, faults: &mut Faults) -> Option<Baseline> {
    let node = object.get("baseline")?;
    let names = Baseline::ALL.map(Baseline::name);
    let index = name(node, &object.path("baseline"), "baseline", &names, faults)?;
    Some(Baseline::ALL[index])
}
