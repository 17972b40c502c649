//! The F distribution: of the quotient of two independent mean squares of normal values.

use super::beta::{regularised, root};

/// Halvings of an interval of probabilities: the ends are exact to the rounding of numbers near 0.
const HALVINGS: usize = 200;

/// The probability of a quotient below `f`, with `d1` and `d2` degrees of freedom (DLMF 8.17: I_x(d1/2, d2/2) for
/// x = d1 f/(d1 f + d2)).
pub fn cumulative(f: f64, d1: f64, d2: f64) -> f64 {
    if f <= 0.0 {
        return 0.0;
    }
    regularised(d1 / 2.0, d2 / 2.0, d1 * f / (d1 * f + d2))
}

/// The quotient below which the probability is `p`, for 0 < p < 1 and degrees of freedom > 0, which need not be whole.
pub fn quantile(p: f64, d1: f64, d2: f64) -> f64 {
    // x near 1 loses the digits of 1 - x, which is found by itself then.
    let middle = regularised(d1 / 2.0, d2 / 2.0, 0.5);
    match p <= middle {
        true => {
            let x = root(|x| regularised(d1 / 2.0, d2 / 2.0, x), p, 0.5, HALVINGS);
            d2 * x / (d1 * (1.0 - x))
        }
        false => {
            let y = root(
                |y| regularised(d2 / 2.0, d1 / 2.0, y),
                1.0 - p,
                0.5,
                HALVINGS,
            );
            d2 * (1.0 - y) / (d1 * y)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_scipy() {
        // Logarithms of gamma functions of the size of the degrees of freedom are rounded, which is 1e-16 d2 relative to p.
        for (p, d1, d2, expected) in SCIPY {
            let found = quantile(p, d1, d2);
            assert!(
                (found / expected - 1.0).abs() < 1e-9,
                "{p} {d1} {d2}: {found}"
            );
            assert!((cumulative(found, d1, d2) - p).abs() < 1e-10);
        }
    }

    /// scipy 1.17.1: probability, degrees of freedom, stats.f.ppf.
    const SCIPY: [(f64, f64, f64, f64); 12] = [
        (0.95, 1.0, 1.0, 161.4476387975882),
        (0.95, 1.0, 10.0, 4.964602743730711),
        (0.95, 1.0, 496.0, 3.860275111548497),
        (0.95, 1.0, 4997.0, 3.8433204323851893),
        (0.95, 4.0, 7.5, 3.9668834940295015),
        (0.95, 4.0, 196.0, 2.417725182061361),
        (0.99, 2.0, 30.0, 5.390345863177884),
        (0.5, 3.0, 3.0, 1.0),
        (0.05, 5.0, 2.0, 0.17282693758579049),
        (0.95, 1.0, 0.5, 27079.227901310966),
        (0.95, 1.0, 99_996.0, 3.841551817406707),
        (0.999, 10.0, 1.0, 605620.971223909),
    ];

    #[test]
    fn quantiles_are_those_of_the_printed_tables() {
        // Upper 5 % points as printed in textbooks, with three and four digits.
        for (d1, d2, printed, digit) in [
            (1.0, 5.0, 6.61, 0.01),
            (2.0, 10.0, 4.10, 0.01),
            (4.0, 20.0, 2.87, 0.01),
            (1.0, 120.0, 3.92, 0.01),
            (10.0, 60.0, 1.99, 0.01),
        ] {
            assert!((quantile(0.95, d1, d2) - printed).abs() <= 0.5 * digit + 1e-9);
        }
    }

    #[test]
    fn one_degree_of_freedom_is_the_square_of_a_quantile_of_t() {
        // Two degrees of freedom: t = (2 p - 1)/sqrt(2 p (1 - p)), and t with p = 0.975 squared is F with 0.95.
        let t = 0.95 / (2.0_f64 * 0.975 * 0.025).sqrt();
        assert!((quantile(0.95, 1.0, 2.0) - t * t).abs() < 1e-12 * t * t);
        // For many: the square of the normal quantile, with a relative difference of about (z^2 + 1)/(2 d2).
        let z = crate::normal::quantile(0.975);
        assert!((quantile(0.95, 1.0, 1e6) / (z * z) - 1.0).abs() < 3e-6);
    }
}
