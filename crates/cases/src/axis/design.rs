//! Designs: points that fill the ranges of several parameters. The same seed gives the same points.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use sobol::Sobol;
use sobol::params::JoeKuoD6;

use slipgap_notation::Scale;
use std::sync::Arc;

/// How points are chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sampling {
    /// One point in each of n slices of every parameter.
    LatinHypercube,
    /// The Sobol' sequence with a random digital shift.
    Sobol,
    /// Two Sobol' samples A and B of n points each and, for each parameter, A with that parameter from B: n (k + 2) points,
    /// row by row A, AB_1 ... AB_k, B, from which Sobol' indices are estimated.
    Saltelli,
}

/// A design of a block.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Design {
    /// How points are chosen.
    pub sampling: Sampling,
    /// The key `n`.
    pub n: u64,
    /// The seed of the random numbers.
    pub seed: u64,
    /// Rows of `problem.parameters()` that it samples, in file order.
    pub parameters: Vec<usize>,
    /// The scale on which each of them has a uniform distribution.
    pub scales: Vec<Scale>,
}

impl Design {
    /// Number of points.
    pub fn points(&self) -> u64 {
        match self.sampling {
            Sampling::Saltelli => self.n.saturating_mul(self.parameters.len() as u64 + 2),
            Sampling::LatinHypercube | Sampling::Sobol => self.n,
        }
    }

    /// The coordinates of all points in one dimension, each in 0 < u < 1.
    pub fn coordinates(&self, dimension: usize) -> Vec<f64> {
        let coordinates = self.line(dimension);
        (0..self.points())
            .map(|point| coordinates.at(point))
            .collect()
    }

    /// The points in one dimension.
    pub fn line(&self, dimension: usize) -> Coordinates {
        match self.sampling {
            Sampling::LatinHypercube => {
                Coordinates::Listed(latin(self.n, self.random(dimension)).into())
            }
            Sampling::Sobol => Coordinates::Sobol(self.sobol(dimension)),
            Sampling::Saltelli => {
                let count = self.parameters.len();
                Coordinates::Saltelli {
                    a: self.sobol(dimension),
                    b: self.sobol(count + dimension),
                    rows: count as u64 + 2,
                    own: dimension as u64 + 1,
                }
            }
        }
    }

    /// The random numbers of one dimension. They do not depend on the number of dimensions.
    fn random(&self, dimension: usize) -> ChaCha8Rng {
        let mut random = ChaCha8Rng::seed_from_u64(self.seed);
        random.set_stream(dimension as u64);
        random
    }

    fn sobol(&self, dimension: usize) -> ShiftedSobol {
        let parameters = JoeKuoD6::minimal();
        let mut directions =
            Sobol::<f64>::init_direction_vals(dimension + 1, RESOLUTION, &parameters);
        ShiftedSobol {
            directions: directions.pop().unwrap_or_default().into(),
            shift: self.random(dimension).next_u64() >> 12,
        }
    }
}

/// Coordinates of points in one dimension. Those of a Sobol' sequence are computed when they are needed.
#[derive(Debug, Clone)]
pub enum Coordinates {
    /// One by one.
    Listed(Arc<[f64]>),
    /// A Sobol' sequence.
    Sobol(ShiftedSobol),
    /// Base by base the rows A, AB_1 ... AB_k, B of two sequences.
    Saltelli {
        /// The sequence of A.
        a: ShiftedSobol,
        /// The sequence of B.
        b: ShiftedSobol,
        /// Number of rows of a base: k + 2.
        rows: u64,
        /// The row in which this dimension comes from B, in addition to the last row.
        own: u64,
    },
}

impl Coordinates {
    /// The coordinate of a point, in 0 < u < 1.
    pub fn at(&self, point: u64) -> f64 {
        match self {
            Coordinates::Listed(points) => points[point as usize],
            Coordinates::Sobol(sequence) => sequence.at(point),
            Coordinates::Saltelli {
                a,
                b,
                rows,
                own: own_column,
            } => {
                let (base, row) = (point / rows, point % rows);
                let of_b = row == *own_column || row + 1 == *rows;
                if of_b { b.at(base) } else { a.at(base) }
            }
        }
    }
}

/// One dimension of the Sobol' sequence with a random digital shift.
#[derive(Debug, Clone)]
pub struct ShiftedSobol {
    directions: Arc<[u64]>,
    shift: u64,
}

impl ShiftedSobol {
    /// Point `index`: the sum of the directions of the bits in the Gray code of the index (Antonov and Saleev, 1979).
    fn at(&self, index: u64) -> f64 {
        let (mut gray, mut sum) = (index ^ (index >> 1), 0);
        while gray != 0 {
            sum ^= self.directions[gray.trailing_zeros() as usize];
            gray &= gray - 1;
        }
        (((sum >> 12) ^ self.shift) as f64 + 0.5) / EXACT
    }
}

/// Binary digits of a coordinate of the Sobol' sequence: those of a double.
const RESOLUTION: usize = 53;

/// Number of steps between 0 and 1 that doubles represent exactly.
const EXACT: f64 = (1_u64 << 52) as f64;

/// One point in each of `n` slices, in random order.
fn latin(n: u64, mut random: ChaCha8Rng) -> Vec<f64> {
    let mut order: Vec<u64> = (0..n).collect();
    for last in (1..order.len()).rev() {
        let up_to = last as u128 + 1;
        let other = (u128::from(random.next_u64()) * up_to) >> 64;
        order.swap(last, other as usize);
    }
    let mut within = || ((random.next_u64() >> 12) as f64 + 0.5) / EXACT;
    order
        .iter()
        .map(|slice| (*slice as f64 + within()) / n as f64)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn design(sampling: Sampling, n: u64, seed: u64, count: usize) -> Design {
        let parameters = (0..count).collect();
        Design {
            sampling,
            n,
            seed,
            parameters,
            scales: Vec::new(),
        }
    }

    #[test]
    fn a_latin_hypercube_has_one_point_in_each_slice() {
        let design = design(Sampling::LatinHypercube, 50, 7, 3);
        for dimension in 0..3 {
            let mut slices: Vec<u64> = design
                .coordinates(dimension)
                .iter()
                .map(|u| (u * 50.0) as u64)
                .collect();
            slices.sort_unstable();
            assert_eq!(slices, (0..50).collect::<Vec<_>>());
        }
    }

    #[test]
    fn sobol_points_stay_a_net_under_the_shift() {
        // Of 256 points of a (t, m, s)-net in two dimensions with t = 0, one is in each of 16 x 16 boxes, and in each
        // of 2 x 128 and 128 x 2.
        for seed in [0, 1, 99] {
            let design = design(Sampling::Sobol, 256, seed, 2);
            let (x, y) = (design.coordinates(0), design.coordinates(1));
            for (across, up) in [(16.0, 16.0), (2.0, 128.0), (128.0, 2.0)] {
                let boxes: std::collections::HashSet<(u64, u64)> = x
                    .iter()
                    .zip(&y)
                    .map(|(x, y)| ((x * across) as u64, (y * up) as u64))
                    .collect();
                assert_eq!(boxes.len(), 256);
            }
        }
    }

    /// The shift is taken out again, and its digits are those of the crate's sequence, point by point.
    #[test]
    fn points_by_their_index_are_those_of_the_sequence() {
        let design = design(Sampling::Sobol, 5000, 0, 1);
        for dimension in [0, 1, 7] {
            let sequence = Sobol::<f64>::new(dimension + 1, &JoeKuoD6::minimal());
            let line = design.sobol(dimension);
            for (index, point) in (0..5000).zip(sequence) {
                let digits = (line.at(index) * EXACT - 0.5) as u64 ^ line.shift;
                assert_eq!(digits, (point[dimension] * EXACT) as u64);
            }
        }
    }

    #[test]
    fn a_saltelli_design_exchanges_one_column_at_a_time() {
        let design = design(Sampling::Saltelli, 4, 3, 3);
        let columns: Vec<Vec<f64>> = (0..3)
            .map(|dimension| design.coordinates(dimension))
            .collect();
        assert!(columns.iter().all(|c| c.len() as u64 == design.points()));
        for base in 0..4 {
            let row = |i: usize| columns.iter().map(|c| c[5 * base + i]).collect::<Vec<_>>();
            let (a, b) = (row(0), row(4));
            assert!((0..3).all(|j| a[j] != b[j]));
            for i in 0..3 {
                let mut mixed = a.clone();
                mixed[i] = b[i];
                assert_eq!(row(1 + i), mixed);
            }
        }
    }

    #[test]
    fn a_seed_gives_its_points_and_another_others() {
        for sampling in [Sampling::LatinHypercube, Sampling::Sobol] {
            let first = design(sampling, 32, 1, 2).coordinates(1);
            assert_eq!(first, design(sampling, 32, 1, 5).coordinates(1));
            assert_ne!(first, design(sampling, 32, 2, 2).coordinates(1));
            assert!(first.iter().all(|u| *u > 0.0 && *u < 1.0));
        }
    }
}
