//! Recorded motions, and what metrics compare.

use crate::problem::Case;
use crate::problem::structure::channels::channel::{Channel, Number};
use crate::problem::structure::channels::measured_channels::Compared;
use crate::problem::structure::given::node::Numbering;
use crate::system::structure::Structure;
use std::collections::{HashMap, HashSet};

/// Quantities of a motion at the steps 0..=N, one list for each number.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Recorded {
    /// Their values.
    series: Vec<Vec<f64>>,
    /// Number of values of each, N + 1.
    len: usize,
    /// Which quantities.
    numbers: Vec<Number>,
    /// The places of their values, if they are many.
    places: HashMap<Number, usize>,
}

impl Recorded {
    /// Number of values of each quantity.
    pub fn count(&self) -> usize {
        self.len
    }

    /// `len` values of each of these quantities.
    pub fn new(numbers: &[Number], series: Vec<Vec<f64>>, len: usize) -> Recorded {
        let places = match numbers.len() > FEW {
            true => numbers.iter().enumerate(),
            false => [].iter().enumerate(),
        };
        Recorded {
            places: places.map(|(row, number)| (*number, row)).collect(),
            numbers: numbers.to_vec(),
            series,
            len,
        }
    }

    /// The values of a quantity; none if it is not recorded.
    pub fn of(&self, number: Number) -> &[f64] {
        let row = match self.numbers.len() > FEW {
            true => self.places.get(&number).copied(),
            false => self.numbers.iter().position(|known| *known == number),
        };
        row.map_or(&[], |i| &self.series[i])
    }

    /// The values of a channel of a structure with this numbering; none if a quantity of it is not recorded.
    pub fn channel(&self, channel: &Channel, numbering: &Numbering) -> Vec<f64> {
        let mut sum = vec![0.0; self.len];
        if channel
            .numbers(numbering)
            .any(|number| self.of(number).is_empty())
        {
            return Vec::new();
        }
        for (sign, term) in &channel.terms {
            if let Ok(Some(number)) = term.number(numbering) {
                for (sum, x) in sum.iter_mut().zip(self.of(number)) {
                    *sum += sign * x;
                }
            }
        }
        sum
    }
}

/// The motions that metrics compare; those that no metric needs are missing.
#[derive(Debug, Default)]
pub struct Motions {
    /// By the time steps.
    pub computed: Recorded,
    /// By the time steps, from a start and with loads that are 1e-10 larger.
    pub perturbed: Option<Recorded>,
    /// Exact, with the softened laws.
    pub softened: Option<Recorded>,
    /// The same at every third step and the last one, if it is integrated: with a coarser tolerance.
    pub coarse: Option<Recorded>,
    /// The metrics `reference_error` with their values.
    pub reference_errors: Vec<(String, f64)>,
    /// Exact, with the rigid laws.
    pub rigid: Option<Recorded>,
    /// Exact, with the softened laws on a finer mesh, and the numbering of that mesh.
    pub finer: Option<(Recorded, Numbering)>,
    /// By the same time steps with the whole matrices, and the numbering of that structure.
    pub unreduced: Option<(Recorded, Numbering)>,
    /// Energies of the computed motion.
    pub energies: Option<Energies>,
}

/// What the motions are of.
#[derive(Debug, Clone, Copy)]
pub struct MetricContext<'a> {
    /// The case.
    pub case: &'a Case,
    /// The structure.
    pub structure: &'a Structure,
    /// Numbers of its nodes.
    pub numbering: &'a Numbering,
    /// What was measured, if a metric compares with it.
    pub compared: Option<&'a Compared<'a>>,
    /// Time step.
    pub dt: f64,
    /// Whether errors are against the motion of the rigid laws.
    pub against_rigid: bool,
    /// Whether rigid contacts act by impulses.
    pub impulses: bool,
}

/// Numbers of which each is found faster one after the other than by a hash.
pub const FEW: usize = 32;

/// Each number once, in the order of their first places.
pub fn distinct(numbers: impl IntoIterator<Item = Number>) -> Vec<Number> {
    let numbers: Vec<Number> = numbers.into_iter().collect();
    if numbers.len() > FEW {
        let mut known = HashSet::new();
        let first = |number: &Number| known.insert(*number);
        return numbers.into_iter().filter(first).collect();
    }
    let mut distinct = Vec::with_capacity(numbers.len());
    for number in numbers {
        if !distinct.contains(&number) {
            distinct.push(number);
        }
    }
    distinct
}

/// Energies of a run over the largest energy; NaN if an energy overflows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Energies {
    /// Energy error.
    pub error: f64,
    /// Numerical dissipation up to the last step.
    pub dissipation: f64,
}
