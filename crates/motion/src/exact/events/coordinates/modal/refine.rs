//! Squared frequencies by Rayleigh's quotient with twice the digits.
//!
//! An eigensolver has the round-off of the largest eigenvalue in all of them. The slow modes of stiff structures would have lost
//! many digits, which drift apart from the motion as time goes on. The error of the quotient is the square of that of the shape, if
//! the cancellation of its large terms leaves no round-off.

/// A sum without round-off to twice the digits of a number.
#[derive(Debug, Clone, Copy, Default)]
struct Sum {
    high: f64,
    low: f64,
}

impl Sum {
    fn add(&mut self, x: f64) {
        // Knuth: the round-off of a sum is a number.
        let sum = self.high + x;
        let part = sum - self.high;
        self.low += (self.high - (sum - part)) + (x - part);
        self.high = sum;
    }
}

/// Two halves of the digits of a number.
fn halves(x: f64) -> [f64; 2] {
    let shifted = 134_217_729.0 * x;
    let high = shifted - (shifted - x);
    [high, x - high]
}

/// A product and its round-off (Dekker).
fn product(a: f64, b: f64) -> [f64; 2] {
    let p = a * b;
    let ([a1, a0], [b1, b0]) = (halves(a), halves(b));
    [p, ((a1 * b1 - p) + a1 * b0 + a0 * b1) + a0 * b0]
}

/// x^T A x for the entries of A on and below the diagonal.
pub fn form(entries: impl Iterator<Item = ((usize, usize), f64)>, x: &[f64]) -> f64 {
    let mut sum = Sum::default();
    for ((i, j), value) in entries {
        let value = if i == j { value } else { 2.0 * value };
        let [p, p_low] = product(value, x[i]);
        let [q, q_low] = product(p, x[j]);
        sum.add(q);
        sum.low += q_low + p_low * x[j];
    }
    sum.high + sum.low
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_form_of_a_stiff_spring_keeps_the_digits_of_a_small_extension() {
        // 3e9 (x0 - x1)^2 + x0^2/8: the terms are 1e9 times the sum.
        let x = [1.0 + 2.0_f64.powi(-30), 1.0];
        let k = 3e9;
        let entries = [((0, 0), k + 0.125), ((1, 0), -k), ((1, 1), k)];
        let exact = k * 2.0_f64.powi(-60) + 0.125 * x[0] * x[0];
        let value = form(entries.into_iter(), &x);
        assert!((value / exact - 1.0).abs() < 1e-15, "{value} {exact}");
    }
}
