//! Metrics that compare with what was measured: whether it was.

use crate::source::faults::{Faults, quoted};
use crate::source::object::Object;
use crate::structure::keys::KEY;
use slipgap_problem::problem::structure::channels::measured_channels::{Measured, measured_loop};
use slipgap_problem::problem::structure::channels::sample::Sample;
use slipgap_problem::problem::structure::metrics::metric::StructureMetric;
use slipgap_problem::problem::structure::metrics::reduction::Reduction;
use slipgap_problem::problem::structure::metrics::window::within;

/// Reports metrics of what was not measured.
pub(in crate::structure) fn report_not_measured(
    root: &Object,
    metrics: &[StructureMetric],
    (measured, sample): (Option<&Measured>, Option<&Sample>),
    faults: &mut Faults,
) {
    if let Some(sample) = sample {
        let is_in_tests = |metric: &StructureMetric| {
            let channel = metric.channel.as_ref();
            let measured = channel.is_some_and(|channel| sample.channel(channel).is_some());
            measured && !metric.measured && metric.reduction.is_of_values()
        };
        for metric in metrics.iter().filter(|metric| is_in_tests(metric)) {
            let (Some(limits), Some(channel)) = (metric.window.constant(), &metric.channel) else {
                continue;
            };
            let mut tests = sample.channel(channel).into_iter().flatten();
            if tests.any(|(times, _)| within(limits, times).is_none()) {
                let (at, path) = &metric.place;
                let message = format!(
                    "{}: a test has no time in this window",
                    quoted(&metric.name)
                );
                faults.add(*at, path, message);
            }
        }
        if !metrics.is_empty() && !metrics.iter().any(is_in_tests) {
            let of_values = Reduction::all().filter(|reduction| reduction.is_of_values());
            let names = of_values
                .map(Reduction::name)
                .collect::<Vec<_>>()
                .join(", ");
            let message =
                format!("no metric of the study is of a measured channel and one of {names}");
            let at = root.get(KEY.0).map_or(0, |node| node.at);
            faults.add(at, KEY.0, message);
        }
    }
    let needs = metrics.iter().filter(|metric| metric.measured);
    for metric in needs {
        let (at, path) = &metric.place;
        let name = quoted(&metric.name);
        let Some(measured) = measured else {
            // With a fault of its own, the key says why.
            if sample.is_some() {
                let message = format!(
                    "{name} compares point by point, \"{}\" as a distribution",
                    KEY.0
                );
                faults.add(*at, path, message);
            } else if root.get(KEY.0).is_none() {
                let message = format!("{name} needs the key \"{}\" of the study", KEY.0);
                faults.add(*at, path, message);
            }
            continue;
        };
        let of_contact = metric.contact.map(measured_loop).into_iter().flatten();
        let channels = metric.channel.iter().chain(&metric.second).cloned();
        for channel in channels.chain(of_contact) {
            if measured.channel(&channel).is_none() {
                let columns = measured.channels.iter();
                let known: Vec<&str> = columns.map(|column| column.0.name.as_str()).collect();
                let channel = match metric.contact {
                    Some(_) => format!("{}.{}", contact_of(&metric.name), channel.name),
                    None => channel.name,
                };
                let message = format!(
                    "{name}: {channel} is not among the columns of \"{}\"; there are {}",
                    KEY.0,
                    known.join(", ")
                );
                faults.add(*at, path, message);
            }
        }
    }
}

/// The contact in the text of a metric, without its quantity.
fn contact_of(metric: &str) -> &str {
    let (_, inside) = metric.split_once('(').unwrap_or_default();
    let first = inside.split(',').next().unwrap_or_default().trim();
    match first.rsplit_once('.') {
        Some((contact, "r" | "S" | "rdot" | "slip" | "limit")) => contact,
        _ => first,
    }
}
