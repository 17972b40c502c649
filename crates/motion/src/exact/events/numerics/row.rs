//! A column of B, or the pattern of a load, in the coordinates of a model.

/// Partial sums of a product of dense rows: enough for vector instructions, in an order that is fixed.
pub const LANES: usize = 8;

/// Numbers that belong to coordinates.
#[derive(Debug, Clone)]
pub enum Row {
    /// Few coordinates with their numbers.
    Sparse(Vec<(usize, f64)>),
    /// A number for each coordinate.
    Dense(Vec<f64>),
}

impl Row {
    /// Number of stored numbers.
    pub fn entries(&self) -> usize {
        match self {
            Row::Sparse(row) => row.len(),
            Row::Dense(row) => row.len(),
        }
    }

    /// The sum of the products with `x`.
    pub fn dot(&self, x: &[f64]) -> f64 {
        match self {
            Row::Sparse(row) => row.iter().fold(0.0, |sum, (i, value)| sum + value * x[*i]),
            Row::Dense(row) => dot(row, x),
        }
    }

    /// Adds the sizes of a factor times the row.
    pub fn add_sizes(&self, factor: f64, to: &mut [f64]) {
        match self {
            Row::Sparse(row) => {
                for (i, value) in row {
                    to[*i] += (factor * value).abs();
                }
            }
            Row::Dense(row) => {
                for (to, value) in to.iter_mut().zip(row) {
                    *to += (factor * value).abs();
                }
            }
        }
    }

    /// The sum of the sizes of the products with `x`.
    pub fn size(&self, x: &[f64]) -> f64 {
        match self {
            Row::Sparse(row) => row.iter().map(|(i, value)| (value * x[*i]).abs()).sum(),
            Row::Dense(row) => sum(row, x, |a, b| (a * b).abs()),
        }
    }

    /// The sum of the products with a row and numbers of all coordinates.
    pub fn form(&self, weights: &[f64], other: &Row) -> f64 {
        let terms = |row: &Vec<(usize, f64)>, other: &Row| -> f64 {
            let terms = row.iter();
            terms
                .map(|(i, value)| value * other.at(*i) * weights[*i])
                .sum()
        };
        match (self, other) {
            (Row::Sparse(row), other) => terms(row, other),
            (Row::Dense(a), Row::Dense(b)) => a
                .iter()
                .zip(b)
                .zip(weights)
                .map(|((a, b), w)| a * b * w)
                .sum(),
            (Row::Dense(_), Row::Sparse(_)) => other.form(weights, self),
        }
    }

    /// The number of each coordinate; none of a sparse row.
    pub fn dense(&self) -> &[f64] {
        match self {
            Row::Sparse(_) => &[],
            Row::Dense(row) => row,
        }
    }

    fn at(&self, i: usize) -> f64 {
        match self {
            Row::Sparse(row) => {
                let others = row.iter().filter(|(n, _)| *n == i);
                others.map(|(_, value)| value).sum()
            }
            Row::Dense(row) => row[i],
        }
    }

    /// Adds the row times a factor.
    pub fn add(&self, factor: f64, to: &mut [f64]) {
        match self {
            Row::Sparse(row) => row.iter().for_each(|(i, value)| to[*i] += value * factor),
            Row::Dense(row) => to
                .iter_mut()
                .zip(row)
                .for_each(|(to, value)| *to += value * factor),
        }
    }

    /// The sum of the absolute values of the products with `x`.
    pub fn terms(&self, x: &[f64]) -> f64 {
        match self {
            Row::Sparse(row) => row.iter().map(|(i, value)| (value * x[*i]).abs()).sum(),
            Row::Dense(row) => sum(row, x, |value, x| (value * x).abs()),
        }
    }

    /// Adds the absolute values of the row times a factor.
    pub fn add_terms(&self, factor: f64, to: &mut [f64]) {
        match self {
            Row::Sparse(row) => row
                .iter()
                .for_each(|(i, value)| to[*i] += (value * factor).abs()),
            Row::Dense(row) => to
                .iter_mut()
                .zip(row)
                .for_each(|(to, value)| *to += (value * factor).abs()),
        }
    }

    /// Subtracts the row times a factor and numbers of all coordinates.
    pub fn subtract_weighted(&self, weights: &[f64], factor: f64, from: &mut [f64]) {
        match self {
            Row::Sparse(row) => {
                for (i, value) in row {
                    from[*i] -= weights[*i] * value * factor;
                }
            }
            Row::Dense(row) => {
                for ((from, w), value) in from.iter_mut().zip(weights).zip(row) {
                    *from -= w * value * factor;
                }
            }
        }
    }
}

/// The sum of the products of two lists.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    sum(a, b, |a, b| a * b)
}

/// The sum of a function of two lists.
pub fn sum(a: &[f64], b: &[f64], term: impl Fn(f64, f64) -> f64) -> f64 {
    let mut sums = [0.0; LANES];
    let ((a, a_rest), (b, b_rest)) = (a.as_chunks::<LANES>(), b.as_chunks::<LANES>());
    for (a, b) in a.iter().zip(b) {
        for l in 0..LANES {
            sums[l] += term(a[l], b[l]);
        }
    }
    let rest: f64 = a_rest.iter().zip(b_rest).map(|(a, b)| term(*a, *b)).sum();
    sums.iter().sum::<f64>() + rest
}
