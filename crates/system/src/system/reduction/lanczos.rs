//! The lowest modes by Lanczos's method for K^-1 M.
//!
//! Several start vectors make a band (Ruhe 1979), so that a few equal frequencies are found at once. Every vector is made orthogonal
//! to all others in the product a^T M b, and before that to the last ones, of which it has most. When the modes have converged, new
//! start vectors look for those that were missed.

use super::ReductionFault;
use super::held::Held;
use super::mode::Mode;
use super::vectors::{Scattered, add, dot};
use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// Start vectors at a time.
const BAND: usize = 4;

/// Vectors after which new start vectors would show a mode that was missed.
const SEARCH: usize = 12 * BAND;

/// Number of last vectors of which an image has more than round-off.
const LAST: usize = 16 * BAND;

/// Largest residual of a mode of K^-1 M over its eigenvalue. The error of the frequency is about its square.
const TOLERANCE: f64 = 1e-11;

/// Largest change of an eigenvalue by new start vectors.
const UNCHANGED: f64 = 1e-9;

/// A vector whose norm falls to this part by the orthogonalisation is a combination of the others.
const DEPENDENT: f64 = 1e-10;

/// The space that grows, and K^-1 M in it.
struct Space<'a> {
    of: &'a Held,
    mass: Vec<((usize, usize), f64)>,
    stiffness: Vec<((usize, usize), f64)>,
    /// Vectors v, orthonormal in the product with M.
    vectors: Vec<Vec<f64>>,
    /// For the first vectors: K^-1 M v as a combination of the vectors.
    images: Vec<Vec<f64>>,
    scattered: Scattered,
}

/// Approximations of modes in the space.
struct Ritz {
    /// 1/omega^2, falling.
    values: Vec<f64>,
    /// Combinations of the vectors, as columns.
    combinations: DMatrix<f64>,
    /// Which columns, in the order of the values.
    order: Vec<usize>,
    /// Whether all of them have converged.
    converged: bool,
}

/// The lowest `wanted` modes.
pub(super) fn lowest(of: &Held, wanted: usize) -> Result<Vec<Mode>, ReductionFault> {
    let mut space = Space {
        of,
        mass: of.mass.entries().collect(),
        stiffness: of.stiffness.entries().collect(),
        vectors: Vec::new(),
        images: Vec::new(),
        scattered: Scattered::new(),
    };
    let most = of.massive.len();
    let step = (wanted / 4).max(4 * BAND);
    let mut known: Option<Vec<f64>> = None;
    space.start();
    let mut target = 2 * wanted + 4 * BAND;
    loop {
        let is_whole = !space.grow(target.min(most));
        let ritz = space.ritz(wanted);
        let unchanged = |values: &Vec<f64>| {
            let mut pairs = values.iter().zip(&ritz.values);
            pairs.all(|(a, b)| (a - b).abs() <= UNCHANGED * a)
        };
        if is_whole || ritz.converged && known.as_ref().is_some_and(unchanged) {
            return space.modes(&ritz, wanted);
        }
        if space.images.len() >= most {
            return Err(ReductionFault::NotConverged);
        }
        target += step;
        if ritz.converged {
            space.start();
            target = space.images.len() + SEARCH;
            known = Some(ritz.values);
        }
    }
}

impl Space<'_> {
    /// Adds start vectors; whether there was room for one.
    fn start(&mut self) -> bool {
        let before = self.vectors.len();
        for _ in 0..BAND {
            let mut x = self.scattered.vector(self.of.free.len());
            // Rows without mass follow the others from here on.
            self.apply(&mut x);
            self.append(&mut x, 0);
        }
        self.vectors.len() > before
    }

    /// Grows until `target` vectors have an image; false if the space is whole.
    fn grow(&mut self, target: usize) -> bool {
        while self.images.len() < target {
            if self.images.len() == self.vectors.len() && !self.start() {
                return false;
            }
            let mut image = self.vectors[self.images.len()].clone();
            self.apply(&mut image);
            let last = self.images.len().saturating_sub(LAST);
            let combination = self.append(&mut image, last);
            self.images.push(combination);
        }
        true
    }

    /// Replaces x by K^-1 M x.
    fn apply(&self, x: &mut [f64]) {
        let force = self.times_mass(x);
        x.copy_from_slice(&force);
        self.of.factor.solve(x);
    }

    fn times_mass(&self, x: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; x.len()];
        for ((i, j), m) in &self.mass {
            product[*i] += m * x[*j];
            if i != j {
                product[*j] += m * x[*i];
            }
        }
        product
    }

    /// Adds the direction of x that is new to the vectors; x as a combination of them. It is made orthogonal to the vectors from
    /// `last` on, then to all.
    fn append(&mut self, x: &mut [f64], last: usize) -> Vec<f64> {
        let norm = |x: &[f64], force: &[f64]| dot(x, force).max(0.0).sqrt();
        let mut force = self.times_mass(x);
        let before = norm(x, &force);
        let mut combination = vec![0.0; self.vectors.len()];
        for first in [last, 0] {
            let vectors = combination.iter_mut().zip(&self.vectors).skip(first);
            for (factor, vector) in vectors {
                let part = dot(&force, vector);
                *factor += part;
                add(x, -part, vector);
            }
            force = self.times_mass(x);
        }
        let after = norm(x, &force);
        if after > DEPENDENT * before && after > 0.0 {
            self.vectors.push(x.iter().map(|x| x / after).collect());
            combination.push(after);
        }
        combination
    }

    /// The approximations of the largest `wanted` eigenvalues of K^-1 M.
    fn ritz(&self, wanted: usize) -> Ritz {
        let size = self.images.len();
        let mut matrix = DMatrix::zeros(size, size);
        for (j, image) in self.images.iter().enumerate() {
            for (i, x) in image.iter().enumerate().take(size) {
                // Of both triangles the one that is known: a vector is orthogonal to the images before it only to round-off.
                if i >= j || self.images[i].len() <= j {
                    matrix[(i, j)] = *x;
                    matrix[(j, i)] = *x;
                }
            }
        }
        let eigen = SymmetricEigen::new(matrix);
        let mut order: Vec<usize> = (0..size).collect();
        order.sort_by(|a, b| eigen.eigenvalues[*b].total_cmp(&eigen.eigenvalues[*a]));
        order.truncate(wanted);
        // The residual is what the images have in the vectors that have no image yet.
        let open = self.vectors.len() - size;
        let mut left = DMatrix::zeros(open, size);
        for (j, image) in self.images.iter().enumerate() {
            for (i, x) in image.iter().enumerate().skip(size) {
                left[(i - size, j)] = *x;
            }
        }
        let residual = |column: usize| {
            let column: DVector<f64> = eigen.eigenvectors.column(column).into_owned();
            (&left * column).norm()
        };
        let mut columns = order.iter();
        let converged = order.len() == wanted
            && columns.all(|column| residual(*column) <= TOLERANCE * eigen.eigenvalues[*column]);
        Ritz {
            values: order
                .iter()
                .map(|column| eigen.eigenvalues[*column])
                .collect(),
            combinations: eigen.eigenvectors,
            order,
            converged,
        }
    }

    /// The modes of the approximations.
    fn modes(&self, ritz: &Ritz, wanted: usize) -> Result<Vec<Mode>, ReductionFault> {
        if ritz.order.len() < wanted {
            return Err(ReductionFault::NotConverged);
        }
        let mode = |(value, column): (&f64, &usize)| {
            let mut shape = vec![0.0; self.of.free.len()];
            for (factor, vector) in ritz.combinations.column(*column).iter().zip(&self.vectors) {
                add(&mut shape, *factor, vector);
            }
            let mode = Mode {
                omega2: 1.0 / value,
                shape,
            };
            match self.is_mode(&mode) {
                true => Ok(mode),
                false => Err(ReductionFault::NotConverged),
            }
        };
        ritz.values.iter().zip(&ritz.order).map(mode).collect()
    }

    /// Whether K phi = omega^2 M phi, to round-off of both sides.
    fn is_mode(&self, mode: &Mode) -> bool {
        let (mut force, mut terms) = (vec![0.0; mode.shape.len()], vec![0.0; mode.shape.len()]);
        for ((i, j), k) in &self.stiffness {
            let [a, b] = [k * mode.shape[*j], k * mode.shape[*i]];
            force[*i] += a;
            terms[*i] += a.abs();
            if i != j {
                force[*j] += b;
                terms[*j] += b.abs();
            }
        }
        let inertia = self.times_mass(&mode.shape);
        // The terms of K phi cancel.
        let size = dot(&inertia, &inertia).sqrt() * mode.omega2 * 1e-6
            + dot(&terms, &terms).sqrt() * 1e-10;
        add(&mut force, -mode.omega2, &inertia);
        dot(&force, &force).sqrt() <= size && mode.omega2.is_finite()
    }
}
