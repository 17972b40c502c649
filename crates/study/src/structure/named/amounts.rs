//! The numbers in the brackets of metrics: of windows, and of measures of the ground.

use crate::source::faults::{Faults, quoted};
use crate::source::tree::{Node, Tree};
use crate::structure::reading::reader::Reader;
use slipgap_problem::problem::numbers::parameter::Range;
use slipgap_problem::problem::structure::given::shape::Scaled;
use slipgap_problem::problem::structure::given::source::Kind;
use slipgap_problem::problem::structure::metrics::metric::StructureMetric;
use slipgap_problem::problem::structure::parts::template::Template;

/// Gives windows and measures of the ground their numbers, and reports those of a ground that the study does not have.
pub(in crate::structure) fn amounts(
    metrics: &mut [StructureMetric],
    template: &Template,
    reader: &Reader,
    faults: &mut Faults,
) {
    for metric in metrics {
        window(metric, reader, faults);
        let Some(ground) = &mut metric.ground else {
            continue;
        };
        let (at, path) = &metric.place;
        let name = quoted(&metric.name);
        match ground.of(metric.reduction, template) {
            Ok(Scaled { source, .. }) if matches!(source.kind(), Kind::Sine { .. }) => {
                let message = format!("{name}: a sine has no end, so that it has no such measure");
                faults.add(*at, path, message);
            }
            Ok(_) => {}
            Err(why) => faults.add(*at, path, format!("{name}: {why}")),
        }
        let ranges = [Range::Positive, Range::UpToOne];
        let amount = |(text, range): (&String, Range)| {
            let node = Node {
                at: *at,
                tree: Tree::Text(text.clone()),
            };
            reader.amount(&node, path, range, faults)
        };
        ground.amounts = ground.texts.iter().zip(ranges).filter_map(amount).collect();
    }
}

/// Gives the window of a metric its numbers.
fn window(metric: &mut StructureMetric, reader: &Reader, faults: &mut Faults) {
    let (at, path) = &metric.place;
    for (text, amount) in metric.window.texts.iter().zip(&mut metric.window.amounts) {
        let as_node = |text: &String| Node {
            at: *at,
            tree: Tree::Text(text.clone()),
        };
        let node = text.as_ref().map(as_node);
        *amount = node.and_then(|node| reader.amount(&node, path, Range::NotNegative, faults));
    }
}
