//! What is removed from the acceleration of a motion.

use crate::system::structure::Table;

/// What is removed from an acceleration up to its last point, after which it is 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Baseline {
    /// Nothing.
    #[default]
    None,
    /// The mean of its points.
    Mean,
    /// Its mean over time from 0 on, which is the mean slope of the velocity, so that the velocity is 0 at the end.
    Linear,
}

/// That a function has no end after t = 0, up to which something could be removed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NoEnd;

impl Baseline {
    /// All of them.
    pub const ALL: [Baseline; 3] = [Baseline::None, Baseline::Mean, Baseline::Linear];

    /// Its name in a study.
    pub fn name(self) -> &'static str {
        match self {
            Baseline::None => "none",
            Baseline::Mean => "mean",
            Baseline::Linear => "linear",
        }
    }

    /// The points of `scale` times an acceleration from t = 0 on, without the baseline. Two points of one time make a jump.
    ///
    /// # Errors
    /// The acceleration has no end.
    pub fn removed(self, table: &Table, scale: f64) -> Result<Vec<(f64, f64)>, NoEnd> {
        let mut points = vec![(0.0, scale * table.at(0.0))];
        let points_of_table = table.times().iter().zip(table.values());
        let later_points = points_of_table.filter(|(time, _)| **time > 0.0);
        points.extend(later_points.map(|(time, a)| (*time, scale * a)));
        let end = points.last().map_or(0.0, |last| last.0);
        if self == Baseline::None {
            return Ok(points);
        }
        if end <= 0.0 {
            return Err(NoEnd);
        }
        let mean = match self {
            Baseline::Mean => {
                let values = table.own_points().1;
                scale * (values.iter().sum::<f64>() / values.len() as f64)
            }
            Baseline::None | Baseline::Linear => {
                let areas = points
                    .windows(2)
                    .map(|pair| 0.5 * (pair[0].1 + pair[1].1) * (pair[1].0 - pair[0].0));
                areas.sum::<f64>() / end
            }
        };
        points.iter_mut().for_each(|(_, a)| *a -= mean);
        // A jump to 0; a table has at most two points of one time.
        let last = points.len() - 1;
        if last > 0 && points[last - 1].0 == end {
            points.truncate(last);
        }
        points.push((end, 0.0));
        Ok(points)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mean_is_that_of_the_points_and_the_slope_that_over_time() {
        let table = Table::new(vec![0.0, 1.0, 3.0, 3.0], vec![1.0, 3.0, 2.0, 0.0]).unwrap();
        let points = |baseline: Baseline| baseline.removed(&table, 2.0);
        let none = vec![(0.0, 2.0), (1.0, 6.0), (3.0, 4.0), (3.0, 0.0)];
        assert_eq!(points(Baseline::None), Ok(none));
        // 1, 3 and 2 have the mean 2; the jump to 0 is none of the points.
        let mean = vec![(0.0, -2.0), (1.0, 2.0), (3.0, 0.0), (3.0, 0.0)];
        assert_eq!(points(Baseline::Mean), Ok(mean));
        // The area is 2 (2 + 5), over 3 s.
        let linear = points(Baseline::Linear).unwrap();
        let expected = [(0.0, 2.0), (1.0, 6.0), (3.0, 4.0)].map(|(t, a)| (t, a - 14.0 / 3.0));
        assert_eq!(linear[..3], expected);
        assert_eq!(linear[3..], [(3.0, 0.0)]);
        let point = Table::new(vec![0.0], vec![1.0]).unwrap();
        assert_eq!(Baseline::Linear.removed(&point, 1.0), Err(NoEnd));
    }
}
