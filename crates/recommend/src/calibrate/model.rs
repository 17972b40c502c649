//! A quadratic function fitted to values round a centre, and its minimum within bounds.

use super::linear::{Eigen, block, dot, least_squares, solve, times};

/// Increases of the damping of a step at most; each is by a factor of 3.
const DAMPINGS: usize = 80;

/// value + gradient d + d^T curvature d for the displacement d from a centre.
#[derive(Debug, Clone)]
pub struct Model {
    pub value: f64,
    pub gradient: Vec<f64>,
    pub curvature: Vec<Vec<f64>>,
    /// The root of the mean square of what the fit leaves, by its degrees of freedom; zero without any.
    pub residual: f64,
}

/// Displacements, as lengths along axes.
pub type Shape = Eigen;

/// Points in units of the lengths: the centre, whole and half lengths along each axis, and pairs of axes; without `crosses` only whole
/// lengths.
pub fn design(dimensions: usize, crosses: bool) -> Vec<Vec<f64>> {
    let point = |parts: &[(usize, f64)]| {
        let mut point = vec![0.0; dimensions];
        parts.iter().for_each(|(k, x)| point[*k] = *x);
        point
    };
    let mut points = vec![point(&[])];
    let lengths: &[f64] = if crosses {
        &[-1.0, -0.5, 0.5, 1.0]
    } else {
        &[-1.0, 1.0]
    };
    for k in 0..dimensions {
        points.extend(lengths.iter().map(|x| point(&[(k, *x)])));
    }
    let half = std::f64::consts::FRAC_1_SQRT_2;
    for i in 0..if crosses { dimensions } else { 0 } {
        for j in i + 1..dimensions {
            let other = if (i + j) % 2 == 0 { half } else { -half };
            points.push(point(&[(i, half), (j, other)]));
            points.push(point(&[(i, -half), (j, -other)]));
        }
    }
    points
}

impl Model {
    /// From displacements of points and their values, which all are finite. `None` if they do not determine it.
    pub fn fit(shape: &Shape, points: &[Vec<f64>], values: &[f64], crosses: bool) -> Option<Model> {
        let n = shape.values.len();
        let pairs = |n: usize| (0..n).flat_map(move |i| (i..n).map(move |j| (i, j)));
        let kept: Vec<(usize, usize)> = pairs(n).filter(|(i, j)| crosses || i == j).collect();
        let row = |point: &Vec<f64>| {
            let axes = shape.values.iter().zip(&shape.vectors);
            let u: Vec<f64> = axes.map(|(length, b)| dot(b, point) / length).collect();
            let squares = kept.iter().map(|(i, j)| u[*i] * u[*j]);
            let mut row = vec![1.0];
            row.extend(squares);
            row.extend(&u);
            row
        };
        let rows: Vec<Vec<f64>> = points.iter().map(row).collect();
        let found = least_squares(&rows, values)?;
        let residuals = rows
            .iter()
            .zip(values)
            .map(|(row, value)| value - dot(row, &found));
        let left: f64 = residuals.map(|x| x * x).sum();
        let freedom = values.len() - found.len();
        // Back to coordinates: u = L^-1 B^T d.
        let (mut gradient, mut curvature) = (vec![0.0; n], vec![vec![0.0; n]; n]);
        let scaled: Vec<Vec<f64>> = (0..n)
            .map(|k| {
                shape.vectors[k]
                    .iter()
                    .map(|b| b / shape.values[k])
                    .collect()
            })
            .collect();
        for (slope, axis) in found[1 + kept.len()..].iter().zip(&scaled) {
            gradient
                .iter_mut()
                .zip(axis)
                .for_each(|(to, b)| *to += slope * b);
        }
        for ((i, j), value) in kept.iter().zip(&found[1..]) {
            for (row, [a, b]) in curvature
                .iter_mut()
                .zip((0..n).map(|r| [scaled[*i][r], scaled[*j][r]]))
            {
                for (column, to) in row.iter_mut().enumerate() {
                    *to += 0.5 * value * (a * scaled[*j][column] + b * scaled[*i][column]);
                }
            }
        }
        Some(Model {
            value: found[0],
            gradient,
            curvature,
            residual: if freedom == 0 {
                0.0
            } else {
                (left / freedom as f64).sqrt()
            },
        })
    }

    pub fn at(&self, d: &[f64]) -> f64 {
        self.value + dot(&self.gradient, d) + dot(d, &times(&self.curvature, d))
    }

    /// The displacement to the smallest value at a distance of `radius` lengths of `shape` at most, from `low` to `high`.
    pub fn minimum(&self, shape: &Shape, radius: f64, low: &[f64], high: &[f64]) -> Vec<f64> {
        let inverse: Vec<f64> = shape.values.iter().map(|x| 1.0 / (x * x)).collect();
        let metric = shape.with(&inverse);
        let along = shape.vectors.iter().zip(&shape.values);
        let curvatures = along.map(|(b, l)| (dot(b, &times(&self.curvature, b)) * l * l).abs());
        let axes = shape.vectors.iter().zip(&shape.values);
        let slopes = axes.map(|(b, l)| (dot(b, &self.gradient) * l).abs());
        let scale = curvatures.chain(slopes).fold(f64::MIN_POSITIVE, f64::max);
        let mut damping = 0.0;
        for _ in 0..DAMPINGS {
            let damped =
                self.curvature.iter().zip(&metric).map(|(row, more)| {
                    row.iter().zip(more).map(|(a, m)| a + damping * m).collect()
                });
            let step = bounded(&damped.collect::<Vec<_>>(), &self.gradient, low, high);
            if let Some(step) = step.filter(|d| dot(d, &times(&metric, d)) <= radius * radius) {
                return step;
            }
            damping = if damping == 0.0 {
                1e-9 * scale
            } else {
                3.0 * damping
            };
        }
        vec![0.0; low.len()]
    }
}

/// The minimum of gradient d + d^T A d within bounds: coordinates that leave them are fixed at them, one after the other.
fn bounded(a: &[Vec<f64>], gradient: &[f64], low: &[f64], high: &[f64]) -> Option<Vec<f64>> {
    let n = gradient.len();
    let mut step = vec![0.0; n];
    let mut free: Vec<usize> = (0..n).collect();
    while !free.is_empty() {
        let fixed: Vec<usize> = (0..n).filter(|i| !free.contains(i)).collect();
        let held: Vec<f64> = fixed.iter().map(|i| step[*i]).collect();
        let pull = times(&block(a, &free, &fixed), &held);
        let right = free.iter().zip(pull).map(|(i, p)| -gradient[*i] / 2.0 - p);
        let found = solve(&block(a, &free, &free), &right.collect::<Vec<_>>())?;
        free.iter().zip(found).for_each(|(i, d)| step[*i] = d);
        // The first bound on the way.
        let part = |i: usize| match step[i] {
            d if d < low[i] => low[i] / d,
            d if d > high[i] => high[i] / d,
            _ => 1.0,
        };
        let first = free
            .iter()
            .copied()
            .min_by(|i, j| part(*i).total_cmp(&part(*j)));
        match first.filter(|i| part(*i) < 1.0) {
            Some(i) => step[i] = step[i].clamp(low[i], high[i]),
            None => return Some(step),
        }
        free.retain(|i| Some(*i) != first);
    }
    Some(step)
}
