//! The straight line of least squares.

use crate::{CONFIDENCE, student};

/// y = `y` + `slope` (x - `x`) + e, with e normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// The mean of x.
    pub x: f64,
    /// The mean of y.
    pub y: f64,
    /// The slope.
    pub slope: f64,
    /// The standard deviation of e (n - 2).
    pub deviation: f64,
    /// The sum of the squares of x less its mean.
    pub sxx: f64,
    /// Number of points.
    pub count: f64,
}

impl Line {
    /// The line through points (x, y); `None` for less than three, and if all have the same x.
    pub fn through(points: &[[f64; 2]]) -> Option<Line> {
        let count = points.len() as f64;
        let mean = |j: usize| points.iter().map(|z| z[j]).sum::<f64>() / count;
        let [x, y] = [mean(0), mean(1)];
        let product = |i: usize, j: usize| -> f64 {
            let means = [x, y];
            let of = |z: &[f64; 2]| (z[i] - means[i]) * (z[j] - means[j]);
            points.iter().map(of).sum()
        };
        let sxx = product(0, 0);
        if points.len() < 3 || sxx.is_nan() || sxx <= 0.0 {
            return None;
        }
        let mut line = Line {
            x,
            y,
            slope: product(0, 1) / sxx,
            deviation: 0.0,
            sxx,
            count,
        };
        let squared = |z: &[f64; 2]| line.residual(*z) * line.residual(*z);
        let squares: f64 = points.iter().map(squared).sum();
        line.deviation = (squares / line.free()).sqrt();
        Some(line)
    }

    /// Degrees of freedom of the deviation.
    pub fn free(&self) -> f64 {
        self.count - 2.0
    }

    /// How far a point is above the line.
    pub fn residual(&self, [x, y]: [f64; 2]) -> f64 {
        y - self.y - self.slope * (x - self.x)
    }

    /// The probability of a slope at least as far from zero for points without one (Student's t).
    pub fn p_of_slope(&self) -> f64 {
        student::beyond(self.slope * self.sxx.sqrt() / self.deviation, self.free())
    }

    /// Half of the 95 % interval of the height of the line, over sqrt(1/n + (x - mean)^2/Sxx).
    pub fn width(&self) -> f64 {
        student::quantile(self.free(), CONFIDENCE) * self.deviation
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_has_the_numbers_of_scipy() {
        let x = [5.9, 6.2, 6.5, 6.5, 6.9, 7.1, 7.4, 6.0];
        let y = [0.11, -0.3, 0.25, 0.02, 0.31, -0.08, 0.4, -0.15];
        let points: Vec<[f64; 2]> = x.into_iter().zip(y).map(|(x, y)| [x, y]).collect();
        let line = Line::through(&points).unwrap();
        // scipy.stats.linregress: sums of eight terms, and a continued fraction.
        let expected = [0.2501563477173235, 0.15621537380998599];
        let found = [line.slope, line.p_of_slope()];
        for (number, expected) in found.into_iter().zip(expected) {
            assert!(
                (number / expected - 1.0).abs() < 1e-12,
                "{number} {expected}"
            );
        }
        assert_eq!(Line::through(&points[..2]), None);
        assert_eq!(Line::through(&[[1.0, 2.0], [1.0, 3.0], [1.0, 4.0]]), None);
    }
}
