//! What is done to the function of a motion: `start`, `end`, `baseline`, `scale_to` and `delay`.

use super::scale_to::of_motion;
use crate::source::faults::Faults;
use crate::source::object::Object;
use crate::structure::reading::reader::Reader;
use slipgap_problem::problem::structure::given::shape::Shape;
use slipgap_system::system::structure::Baseline;

/// What an object does to its function.
pub(in crate::structure) fn shape(
    object: &Object,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Box<Shape>> {
    let before = faults.count();
    let mut time = |key| reader.number(object, key, faults);
    let mut shape = Box::<Shape>::default();
    shape.start = time("start");
    shape.end = time("end");
    shape.delay = time("delay");
    shape.baseline = object
        .choice("baseline", &Baseline::ALL, faults)
        .unwrap_or_default();
    if let Some((node, path)) = object.given("scale_to", faults)
        && let Some((scale_to, pair)) = of_motion(node, &path, reader, faults)
    {
        (shape.scale_to, shape.pair) = (Some(scale_to), pair);
    }
    (faults.count() == before).then_some(shape)
}
