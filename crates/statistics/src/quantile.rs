//! Quantiles of a sample.

/// The quantile of `rising` values at `p` from 0 to 1, straight between the order statistics: definition 7 of Hyndman and
/// Fan (1996), the usual one of R, numpy and spreadsheets. `None` without values.
pub fn quantile(rising: &[f64], p: f64) -> Option<f64> {
    let last = rising.len().checked_sub(1)?;
    let rank = p * last as f64;
    let below = (rank.floor() as usize).min(last);
    let above = (below + 1).min(last);
    let part = rank - below as f64;
    Some(match part > 0.0 {
        true => rising[below] + part * (rising[above] - rising[below]),
        false => rising[below],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_definition_7() {
        // By hand: places 0.25 * 3 = 0.75, 0.5 * 3 = 1.5 and 0.9 * 3 = 2.7 among 0 .. 3.
        let rising = [1.0, 2.0, 4.0, 8.0];
        let of = |p| quantile(&rising, p).unwrap();
        assert_eq!([of(0.0), of(0.25), of(0.5), of(1.0)], [1.0, 1.75, 3.0, 8.0]);
        assert!((of(0.9) - 6.8).abs() < 1e-15);
        assert_eq!(quantile(&[3.0], 0.3), Some(3.0));
        assert_eq!(quantile(&[], 0.5), None);
    }
}
