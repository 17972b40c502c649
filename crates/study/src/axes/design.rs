//! The key `design` of a block.

use super::draft::{BlockDraft, ParameterDraft};
use super::interval::Interval;
use crate::source::faults::Faults;
use crate::source::object::Object;
use crate::source::tree::Node;
use crate::value::{name, number};
use slipgap_cases::axis::design::{Design, Sampling};
use slipgap_cases::axis::values::Sampled;
use slipgap_problem::problem::numbers::parameter::{Parameter, Range, shortest};

/// The keys of a design, each with its meaning.
pub(crate) const KEYS: [(&str, &str); 3] = [
    ("kind", "how the points are chosen"),
    (
        "n",
        "number of points; saltelli: base points; a power of 2 is best for Sobol' sequences",
    ),
    (
        "seed",
        "a whole number that selects the sequence of random numbers; if left out, 0",
    ),
];

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

/// Most points of a design.
const MOST: f64 = 1e6;

/// Largest seed: every whole number up to it is a double.
const LARGEST_SEED: f64 = 9_007_199_254_740_992.0;

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
    let object = Object::open(node, path, &KEYS.map(|key| key.0), faults)?;
    let names = KINDS.map(|kind| kind.0);
    let kind = object
        .need("kind", &format!("one of {}", names.join(", ")), faults)
        .and_then(|node| name(node, &object.path("kind"), "kind", &names, faults));
    let mut whole = |key: &str, min: f64, max: f64| {
        let node = object.get(key)?;
        let path = object.path(key);
        let x = number(node, &path, Range::Any, faults)?;
        if x.fract() == 0.0 && (min..=max).contains(&x) {
            return Some(x as u64);
        }
        let allowed = format!("a whole number from {min} to {max}");
        faults.add(
            node.at,
            &path,
            format!("must be {allowed}, got {}", shortest(x)),
        );
        None
    };
    let n = whole("n", 2.0, MOST);
    let seed = whole("seed", 0.0, LARGEST_SEED).unwrap_or(0);
    if object.get("n").is_none() {
        object.missing("n", "the number of points", faults);
    }
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
