//! `choose` beside `files`: of many records those whose spectra have the median and the deviation of a target.

use super::cache::Cache;
use super::ordinates::Ordinates;
use super::pattern::{Found, matching};
use super::selected;
use super::selection::{Moments, select};
use crate::source::faults::{Faults, join, quoted};
use crate::source::folder::Folder;
use crate::source::object::Object;
use crate::source::tree::Node;
use crate::structure::keys::CHOOSE;
use crate::value::{number, text};
use libm::log;
use rayon::prelude::*;
use slipgap_problem::problem::structure::given::scale_to::RATIO;
use slipgap_system::system::loads::Unit;
use slipgap_system::system::loads::pair::Component;

/// Most faults of files that are reported.
const MOST_FAULTS: usize = 5;

/// What is chosen from many records.
struct Choice {
    /// Number of motions.
    n: usize,
    /// Logarithms of the median in m/s2, and their standard deviations.
    mean: Vec<f64>,
    deviation: Vec<f64>,
    /// The place of the period at which all motions are scaled to the median first.
    at: Option<usize>,
    /// The largest factor with which they are, and one over the smallest.
    factor: f64,
    ordinates: Ordinates,
}

/// The files that are chosen under a key.
pub(super) fn chosen(
    node: &Node,
    path: &str,
    files: Found,
    folder: &Folder,
    faults: &mut Faults,
) -> Option<Found> {
    let choice = choice(node, path, faults)?;
    let motions = motions(node, path, &files, folder, faults)?;
    match choice.of(&motions, folder, &Cache::of_user()) {
        Ok(places) => Some(places.into_iter().map(|i| files[i].clone()).collect()),
        Err(why) => {
            faults.add(node.at, path, why);
            None
        }
    }
}

/// The files of each motion: its own, and that of the other direction.
fn motions<'a>(
    node: &Node,
    path: &str,
    files: &'a Found,
    folder: &Folder,
    faults: &mut Faults,
) -> Option<Vec<Vec<String>>> {
    let own = |file: &'a (String, String)| vec![file.1.clone()];
    let Some(pattern) = node.get("pair") else {
        return Some(files.iter().map(own).collect());
    };
    let path = join(path, "pair");
    let pattern_text = text(pattern, &path, faults)?;
    let with_partner = |others: Found| -> Result<Vec<Vec<String>>, String> {
        let of_pair = |(star, file): &(String, String)| {
            let partner = others.iter().find(|other| other.0 == *star);
            let missing = || format!("no file with {} for *, as {}", quoted(star), quoted(file));
            Ok(vec![file.clone(), partner.ok_or_else(missing)?.1.clone()])
        };
        files.iter().map(of_pair).collect()
    };
    let found = matching(&pattern_text, folder.path).and_then(with_partner);
    match found {
        Ok(motions) => Some(motions),
        Err(why) => {
            let message = format!("{}: {why}", quoted(&pattern_text));
            faults.add(pattern.at, &path, message);
            None
        }
    }
}

/// The choice under a key.
fn choice(node: &Node, path: &str, faults: &mut Faults) -> Option<Choice> {
    let object = Object::open(node, path, &CHOOSE, faults)?;
    let before = faults.count();
    let n = object.whole("n", faults);
    let lists = ["T", "median", "sigma"].map(|key| list(&object, key, faults));
    let unit = object.choice("unit", &Unit::ALL, faults).map(Unit::in_m_s2);
    let component = object.choice("component", &Component::ALL, faults);
    match (object.get("pair"), object.get("component")) {
        (Some(_), None) => {
            object.need("component", "of what of a pair", faults);
        }
        (None, Some(node)) => faults.add(node.at, &object.path("component"), "needs \"pair\""),
        (Some(_), Some(_)) | (None, None) => {}
    }
    let [at, factor, ratio] = ["at", "factor", "ratio"].map(|key| object.number(key, faults));
    let [Some(periods), Some(median), Some(deviation)] = lists else {
        return None;
    };
    if median.len() != periods.len() || deviation.len() != periods.len() {
        object.fault("needs as many numbers in median and sigma as in T", faults);
    }
    if !periods.is_sorted_by(|a, b| a < b) {
        object.fault("the periods in T must rise", faults);
    }
    let found = at.map(|at| periods.iter().position(|period| *period == at));
    if let (Some(None), Some(node)) = (found, object.get("at")) {
        faults.add(
            node.at,
            &object.path("at"),
            "must be one of the periods in T",
        );
    }
    if let (Some(node), None) = (object.get("factor"), at) {
        faults.add(node.at, &object.path("factor"), "needs \"at\"");
    }
    if faults.count() > before {
        return None;
    }
    let unit = unit?;
    Some(Choice {
        n: n? as usize,
        mean: median.iter().map(|a| log(a * unit)).collect(),
        deviation,
        at: found.flatten(),
        factor: factor.unwrap_or(f64::INFINITY),
        ordinates: Ordinates {
            periods,
            ratio: ratio.unwrap_or(RATIO),
            component,
        },
    })
}

/// A list of numbers that is needed.
fn list(object: &Object, key: &str, faults: &mut Faults) -> Option<Vec<f64>> {
    let (node, path) = object.given(key, faults)?;
    let Some(items) = node.list().filter(|items| !items.is_empty()) else {
        faults.must_be(node, &path, "a list of numbers");
        return None;
    };
    let items = items.iter().enumerate();
    let numbers =
        items.map(|(i, item)| number(item, &format!("{path}[{i}]"), object.range(key), faults));
    // Collected first, so that every fault is reported.
    let read: Vec<Option<f64>> = numbers.collect();
    read.into_iter().collect()
}

impl Choice {
    /// The places of the chosen motions, rising, from the files of each.
    ///
    /// # Errors
    /// Files that are no records, or too few of them.
    fn of(
        &self,
        files: &[Vec<String>],
        folder: &Folder,
        cache: &Cache,
    ) -> Result<Vec<usize>, String> {
        selected::begin(files.len());
        // Read once, on all threads; in the order of the files, so that the choice is the same everywhere.
        let spectra: Vec<Result<Vec<f64>, String>> = files
            .par_iter()
            .map(|motion| self.ordinates.logarithms(folder, motion, cache))
            .inspect(|_| selected::step())
            .collect();
        let errors = spectra.iter().filter_map(|result| result.as_ref().err());
        let wrong: Vec<&str> = errors.take(MOST_FAULTS).map(String::as_str).collect();
        if !wrong.is_empty() {
            return Err(wrong.join("; "));
        }
        let spectra = spectra.into_iter().flatten().enumerate();
        let scaled = spectra.map(|(index, spectrum)| {
            let shift = self.at.map_or(0.0, |at| self.mean[at] - spectrum[at]);
            (index, shift, spectrum.iter().map(|x| x + shift).collect())
        });
        let most = log(self.factor);
        let suitable = scaled.filter(|(_, shift, _)| shift.abs() <= most);
        let (places, spectra): (Vec<usize>, Vec<Vec<f64>>) = suitable
            .map(|(index, _, spectrum)| (index, spectrum))
            .unzip();
        if places.len() < self.n {
            return Err(format!(
                "{} motions are to be chosen, but only {} of {} are suitable",
                self.n,
                places.len(),
                files.len()
            ));
        }
        let target = Moments {
            mean: &self.mean,
            deviation: &self.deviation,
        };
        let chosen = select(&spectra, &target, self.n);
        Ok(chosen.into_iter().map(|i| places[i]).collect())
    }
}
