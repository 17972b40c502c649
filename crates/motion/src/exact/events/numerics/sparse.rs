//! Rows of a sparse symmetric matrix, for products, and bounds of its norm.

use crate::system::structure::Symmetric;

/// A symmetric matrix by rows.
#[derive(Debug, Clone)]
pub struct Rows {
    starts: Vec<usize>,
    entries: Vec<(usize, f64)>,
}

impl Rows {
    /// The rows of a matrix.
    pub fn new(matrix: &Symmetric) -> Rows {
        let mut rows = vec![Vec::new(); matrix.size()];
        for ((i, j), value) in matrix.entries().filter(|(_, value)| *value != 0.0) {
            rows[i].push((j, value));
            if i != j {
                rows[j].push((i, value));
            }
        }
        let mut starts = vec![0];
        for row in &rows {
            starts.push(starts[starts.len() - 1] + row.len());
        }
        Rows {
            starts,
            entries: rows.concat(),
        }
    }

    /// Number of stored entries.
    pub fn entries(&self) -> usize {
        self.entries.len()
    }

    /// Whether all entries are 0.
    pub fn is_zero(&self) -> bool {
        self.entries.is_empty()
    }

    /// The entries (column, value) of a row.
    pub fn row(&self, i: usize) -> &[(usize, f64)] {
        &self.entries[self.starts[i]..self.starts[i + 1]]
    }

    /// Subtracts `factor` times the product with `x`.
    pub fn subtract_product(&self, factor: f64, x: &[f64], from: &mut [f64]) {
        for (i, from) in from.iter_mut().enumerate() {
            let row = self.row(i).iter();
            *from -= factor * row.map(|(j, value)| value * x[*j]).sum::<f64>();
        }
    }

    /// x^T A y.
    pub fn form(&self, x: &[f64], y: &[f64]) -> f64 {
        let rows = x.iter().enumerate();
        rows.map(|(i, x)| {
            let row = self.row(i).iter();
            x * row.map(|(j, value)| value * y[*j]).sum::<f64>()
        })
        .sum()
    }
}

/// Sums of the absolute values of the rows of M^-1 A and of M^-1/2 A M^-1/2. The largest of either is a bound of the largest
/// eigenvalue of M^-1 A (Gershgorin).
#[derive(Debug, Clone)]
pub struct RowSums {
    sums: [Vec<f64>; 2],
}

impl RowSums {
    /// The sums of a matrix.
    pub fn new(matrix: &Rows, inverse_masses: &[f64]) -> RowSums {
        let mut sums = [vec![0.0; inverse_masses.len()], Vec::new()];
        sums[1] = sums[0].clone();
        for (i, w) in inverse_masses.iter().enumerate() {
            for (j, value) in matrix.row(i) {
                sums[0][i] += value.abs() * w;
                sums[1][i] += value.abs() * (w * inverse_masses[*j]).sqrt();
            }
        }
        RowSums { sums }
    }

    /// Adds a spring whose extension is the sum of factor times u.
    pub fn add_along(&mut self, along: &[(usize, f64)], k: f64, inverse_masses: &[f64]) {
        for (i, a) in along {
            let w = inverse_masses[*i];
            let others = along.iter().filter(|(j, _)| j != i);
            let [mut of_rows, mut of_roots] = [a * a, a * a * w];
            for (j, b) in others {
                let product = (a * b).abs();
                of_rows += product;
                of_roots += product * (w * inverse_masses[*j]).sqrt();
            }
            self.sums[0][*i] += k * w * of_rows;
            self.sums[1][*i] += k * of_roots;
        }
    }

    /// The bound of the largest eigenvalue.
    pub fn bound(&self) -> f64 {
        let largest = |sums: &Vec<f64>| sums.iter().copied().fold(0.0, f64::max);
        largest(&self.sums[0]).min(largest(&self.sums[1]))
    }
}
