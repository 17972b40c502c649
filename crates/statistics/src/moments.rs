//! Mean and standard deviation.

/// The mean; `None` without values.
pub fn mean(values: &[f64]) -> Option<f64> {
    let count = values.len() as f64;
    (!values.is_empty()).then(|| values.iter().sum::<f64>() / count)
}

/// The standard deviation with n - 1; `None` for fewer than two values.
pub fn standard_deviation(values: &[f64]) -> Option<f64> {
    let mean = mean(values).filter(|_| values.len() > 1)?;
    let squares: f64 = values.iter().map(|x| (x - mean) * (x - mean)).sum();
    Some((squares / (values.len() as f64 - 1.0)).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_small_sample_has_its_moments() {
        // By hand: mean 5, squares 9 + 1 + 1 + 9 = 20 over 3.
        let values = [2.0, 4.0, 6.0, 8.0];
        assert_eq!(mean(&values), Some(5.0));
        assert_eq!(standard_deviation(&values), Some((20.0_f64 / 3.0).sqrt()));
        assert_eq!([mean(&[]), standard_deviation(&[3.0])], [None, None]);
    }
}
