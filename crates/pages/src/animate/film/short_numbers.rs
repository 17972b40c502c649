//! Numbers in the page: few digits, and short lists.

/// Largest absolute value.
pub fn peak(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, x| most.max(x.abs()))
}

/// The first number, then the differences: short in a page.
pub fn differences(numbers: impl Iterator<Item = i64>) -> Vec<i64> {
    let mut before = 0;
    numbers
        .map(|x| {
            let difference = x - before;
            before = x;
            difference
        })
        .collect()
}

/// A number with few significant digits.
pub fn digits(x: f64, count: usize) -> f64 {
    let text = format!("{x:.*e}", count.saturating_sub(1));
    text.parse().unwrap_or(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_digits_are_left() {
        assert_eq!(digits(123_456.0, 3), 123_000.0);
        assert_eq!(digits(-0.001_234_56, 4), -0.001_235);
    }
}
