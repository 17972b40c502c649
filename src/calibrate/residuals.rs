//! Whether what is left of the misfit is noise: the correlation of neighbouring residuals.

/// Bound of the correlation of white residuals at 99 %, times the root of their number.
const WHITE: f64 = 2.58;

/// Correlation from which on residuals say nothing about intervals.
const SMOOTH: f64 = 0.9;

/// The residuals of the best point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Residuals {
    /// Their number N.
    pub count: usize,
    /// rho_1: the sum of the products of neighbours over the sum of squares.
    pub correlation: f64,
}

impl Residuals {
    /// Those of several tests; neighbours are of one test.
    pub fn of(tests: &[Vec<f64>]) -> Option<Residuals> {
        let (mut squares, mut products) = (0.0, 0.0);
        for test in tests {
            squares = test.iter().fold(squares, |sum, e| sum + e * e);
            let pairs = test.iter().zip(&test[1.min(test.len())..]);
            products = pairs.fold(products, |sum, (a, b)| sum + a * b);
        }
        let correlation = products / squares;
        correlation.is_finite().then(|| Residuals {
            count: tests.iter().map(Vec::len).sum(),
            correlation,
        })
    }

    /// Whether they are white: not correlated.
    pub fn are_white(&self) -> bool {
        self.correlation.abs() <= WHITE / (self.count as f64).sqrt()
    }

    /// N, or of correlated ones N (1 - rho_1)/(1 + rho_1), at most N.
    pub fn effective(&self) -> f64 {
        let count = self.count as f64;
        let rho = self.correlation;
        match self.are_white() {
            true => count,
            false => (count * (1.0 - rho) / (1.0 + rho)).min(count),
        }
    }

    /// The same, if they say how sharply parameters are determined.
    pub fn for_intervals(&self) -> Option<f64> {
        (self.correlation <= SMOOTH).then(|| self.effective())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn correlation_is_that_of_neighbours_in_one_test() {
        // Products 1*2 + 2*(-1) and 1*1; squares 1 + 4 + 1 and 1 + 1.
        let found = Residuals::of(&[vec![1.0, 2.0, -1.0], vec![1.0, 1.0]]).unwrap();
        assert_eq!((found.count, found.correlation), (5, 1.0 / 8.0));
        assert!(found.are_white());
        assert_eq!(Residuals::of(&[vec![0.0; 10]]), None);
    }

    #[test]
    fn the_effective_number_is_that_of_a_first_order_process() {
        let found = |correlation: f64| Residuals {
            count: 1000,
            correlation,
        };
        assert_eq!(found(0.5).effective(), 1000.0 / 3.0);
        // Below 2.58/sqrt(1000) = 0.0816, and of alternating ones not more than there are.
        assert_eq!(found(0.08).effective(), 1000.0);
        assert_eq!(found(-0.5).effective(), 1000.0);
        assert_eq!(found(0.95).for_intervals(), None);
    }
}
