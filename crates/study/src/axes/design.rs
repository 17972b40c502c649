//! The key `design` of a block.

use super::draft::{BlockDraft, ParameterDraft};
use super::interval::Interval;
use crate::source::faults::Faults;
use crate::source::field::{Keys, Kind, MOST_SEED, field, fields, needed};
use crate::source::object::Object;
use crate::source::tree::Node;
use slipgap_cases::axis::design::{Design, Sampling};
use slipgap_cases::axis::values::Sampled;
use slipgap_problem::problem::numbers::parameter::Parameter;

/// The keys of a design, each with its meaning.
pub(crate) const KEYS: Keys = Keys::new(&fields![
    /// how the points are chosen
    needed("kind", Kind::Meant(|| &KINDS)),
    /// the number of points, of saltelli base points; for Sobol' sequences best a power of 2
    needed("n", Kind::Whole([2, 1_000_000])),
    /// seed of the random numbers, a whole number; default 0
    field("seed", Kind::Whole([0, MOST_SEED])),
]);

/// The kinds of design, in the order of [`Sampling`].
pub(crate) const KINDS: [(&str, &str); 3] = [
    (
        "latin-hypercube",
        "one point in each of n equal slices of every parameter",
    ),
    ("sobol", "the Sobol' sequence, shifted at random"),
    (
        "saltelli",
        "n (k + 2) points from which Sobol' indices of every metric are estimated",
    ),
];

impl BlockDraft {
    /// Decodes the design of the block, and finds the parameters that it samples.
    pub fn design(&mut self, object: &Object, faults: &mut Faults) {
        let sampled = |given: &&ParameterDraft| given.interval.is_some();
        let ranges = self.parameters.iter().filter(sampled);
        let rows: Vec<usize> = ranges.map(|given| given.parameter).collect();
        let path = object.path("design");
        let Some(node) = object.get("design") else {
            for given in self.parameters.iter().filter(sampled) {
                let message = "needs a \"design\" next to \"parameters\", which chooses the points";
                faults.add(given.at, &given.path, message);
            }
            // Parameters without points cause no further faults.
            self.faulty.extend(&rows);
            self.parameters.retain(|given| given.interval.is_none());
            return;
        };
        let decoded = decode(node, &path, faults);
        if rows.is_empty() && self.faulty.is_empty() {
            let message = "samples nothing: give parameters as {\"uniform\": [a, b]} or {\"loguniform\": [a, b]}";
            faults.add(node.at, &path, message);
        }
        let others = self.parameters.iter().any(|given| given.values.len() > 1);
        let saltelli = |d: &Design| d.sampling == Sampling::Saltelli;
        if decoded.as_ref().is_some_and(saltelli) && (others || self.when.is_some()) {
            let message = "a saltelli design allows no other axis and no \"when\" in its block";
            faults.add(node.at, &path, message);
        }
        match decoded {
            Some(mut design) if !rows.is_empty() => {
                design.parameters = rows;
                let intervals = self.parameters.iter().filter_map(|given| given.interval);
                design.scales = intervals.map(Interval::scale).collect();
                self.design = Some(design);
            }
            Some(_) | None => {
                self.faulty.extend(&rows);
                self.parameters.retain(|given| given.interval.is_none());
            }
        }
    }

    /// Sets the values of the parameters that the design samples.
    pub fn sample(&mut self, table: &[Parameter]) {
        let Some(design) = &self.design else {
            return;
        };
        for given in &mut self.parameters {
            let mut sampled = design.parameters.iter();
            let dimension = sampled.position(|row| *row == given.parameter);
            if let (Some(dimension), Some(interval)) = (dimension, given.interval) {
                given.sampled = Some(Sampled {
                    coordinates: design.line(dimension),
                    points: design.points(),
                    distribution: interval.distribution(&table[given.parameter]),
                });
            }
        }
    }
}

/// Decodes a design, without the parameters that it samples.
fn decode(node: &Node, path: &str, faults: &mut Faults) -> Option<Design> {
    let before = faults.count();
    let object = Object::open(node, path, &KEYS, faults)?;
    let kind = object.word("kind", faults);
    let n = object.whole("n", faults);
    let seed = object.whole("seed", faults).unwrap_or(0);
    let sampling = [
        Sampling::LatinHypercube,
        Sampling::Sobol,
        Sampling::Saltelli,
    ][kind?];
    (faults.count() == before).then_some(Design {
        sampling,
        n: n?,
        seed,
        parameters: Vec::new(),
        scales: Vec::new(),
    })
}
