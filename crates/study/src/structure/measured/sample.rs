//! Tests that are compared as a sample: a list of files with the same columns.

use super::column::Column;
use super::long_test;
use crate::source::faults::Faults;
use crate::source::object::Object;
use crate::source::tree::Node;
use crate::structure::reading::reader::Reader;
use crate::value::text;
use slipgap_problem::problem::structure::channels::channel::Channel;
use slipgap_problem::problem::structure::channels::sample::{FEWEST_TESTS, Sample};
use std::sync::Arc;

/// The tests of the files at a node; `None` with a fault.
pub(super) fn sample(
    (root, object): (&Object, &Object),
    (node, path): (&Node, String),
    (time, columns): (Column, Vec<(Channel, Column)>),
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Sample> {
    let before = faults.count();
    if let Some(delay) = object.get("delay") {
        let message = "of histories that are compared point by point; leave it out";
        faults.add(delay.at, &object.path("delay"), message);
    }
    if root.get("ensemble").is_none() {
        let path = object.path("compare");
        let at = object.get("compare").map_or(node.at, |compare| compare.at);
        let message = "\"distribution\" needs the key \"ensemble\" of the study, with whose cases the tests are compared";
        faults.add(at, &path, message);
    }
    let Some(files) = node.list().filter(|files| files.len() >= FEWEST_TESTS) else {
        let wanted =
            format!("a list of at least {FEWEST_TESTS} files, or {{\"files\": ...}} with as many");
        faults.must_be(node, &path, &wanted);
        return None;
    };
    let of_channels: Vec<&Column> = columns.iter().map(|column| &column.1).collect();
    // Results of cases do not depend on the tests: their bytes are no part of the identity.
    let tests = files.iter().enumerate().filter_map(|(i, node)| {
        let path = format!("{path}[{i}]");
        let file = text(node, &path, faults)?;
        let (test, _) = long_test(&file, (node, &path), (&time, &of_channels), reader, faults)?;
        Some(Arc::new(test))
    });
    let tests = tests.collect();
    (faults.count() == before).then(|| Sample {
        tests,
        channels: columns.into_iter().map(|pair| pair.0).collect(),
    })
}
