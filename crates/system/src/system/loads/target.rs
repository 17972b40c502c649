//! Target spectra of pseudo-acceleration, and the factor of a motion that is nearest to one.

use libm::{exp, log, pow};

/// A target spectrum.
#[derive(Debug, Clone, PartialEq)]
pub enum Target {
    /// Straight lines between periods, which rise, and ordinates; constant beyond.
    Table {
        /// Periods.
        periods: Vec<f64>,
        /// Ordinates.
        ordinates: Vec<f64>,
    },
    /// Horizontal elastic response spectrum of EN 1998-1:2004, 3.2.2.2.
    En1998 {
        /// Design ground acceleration a_g.
        ag: f64,
        /// Soil factor.
        soil: f64,
        /// Corner periods T_B, T_C and T_D.
        corners: [f64; 3],
        /// Damping ratio.
        ratio: f64,
    },
    /// Design response spectrum of ASCE 7-16, 11.4.6.
    Asce7 {
        /// S_DS.
        short: f64,
        /// S_D1, at 1 s.
        one: f64,
        /// Long-period transition T_L.
        long: f64,
    },
}

impl Target {
    /// The ordinate at a period.
    pub fn at(&self, period: f64) -> f64 {
        match self {
            Target::Table { periods, ordinates } => {
                let next = periods.partition_point(|known| *known <= period);
                match (next.checked_sub(1), periods.get(next)) {
                    (None, _) => ordinates.first().copied().unwrap_or_default(),
                    (Some(before), None) => ordinates[before],
                    (Some(before), Some(after)) => {
                        let part = (period - periods[before]) / (after - periods[before]);
                        ordinates[before] + (ordinates[next] - ordinates[before]) * part
                    }
                }
            }
            Target::En1998 {
                ag,
                soil,
                corners: [b, c, d],
                ratio,
            } => {
                // Damping correction (3.6), in per cent.
                let eta = (10.0 / (5.0 + 100.0 * ratio)).sqrt().max(0.55);
                let plateau = 2.5 * eta;
                let shape = if period < *b {
                    1.0 + period / b * (plateau - 1.0) // (3.2)
                } else if period <= *c {
                    plateau // (3.3)
                } else if period <= *d {
                    plateau * c / period // (3.4)
                } else {
                    plateau * c * d / (period * period) // (3.5)
                };
                ag * soil * shape
            }
            Target::Asce7 { short, one, long } => {
                let corner = one / short;
                let rise = 0.2 * corner;
                if period < rise {
                    short * (0.4 + 0.6 * period / rise) // (11.4-5)
                } else if period <= corner {
                    *short
                } else if period <= *long {
                    one / period // (11.4-6)
                } else {
                    one * long / (period * period) // (11.4-7)
                }
            }
        }
    }
}

/// Number of periods at which a motion is compared with a target.
const PERIODS: u32 = 101;

/// Which squares are the least ones where a motion is scaled to a target.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Fit {
    /// Those of the differences of ordinates, at evenly spaced periods.
    #[default]
    Linear,
    /// Those of the differences of their logarithms, at periods with evenly spaced logarithms.
    Logarithmic,
}

impl Fit {
    /// Both.
    pub const ALL: [Fit; 2] = [Fit::Linear, Fit::Logarithmic];

    /// Its name in studies.
    pub fn name(self) -> &'static str {
        match self {
            Fit::Linear => "linear",
            Fit::Logarithmic => "logarithmic",
        }
    }

    /// The periods at which a motion is compared with a target, both ends included.
    pub fn periods(self, [from, to]: [f64; 2]) -> Vec<f64> {
        let steps = f64::from(PERIODS - 1);
        let between = |i: u32| match self {
            Fit::Linear => from + (to - from) * (f64::from(i) / steps),
            Fit::Logarithmic if i == PERIODS - 1 => to,
            Fit::Logarithmic => from * pow(to / from, f64::from(i) / steps),
        };
        (0..PERIODS).map(between).collect()
    }

    /// The factor of `own` with the smallest sum of squares.
    pub fn nearest(self, ordinates: &[f64], wanted: &[f64]) -> f64 {
        let both = ordinates.iter().zip(wanted);
        match self {
            Fit::Linear => {
                let products = both.map(|(ordinate, wanted)| ordinate * wanted);
                products.sum::<f64>()
                    / ordinates
                        .iter()
                        .map(|ordinate| ordinate * ordinate)
                        .sum::<f64>()
            }
            Fit::Logarithmic => {
                let logarithms = both.map(|(ordinate, wanted)| log(wanted / ordinate));
                exp(logarithms.sum::<f64>() / ordinates.len() as f64)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_spectrum_of_en_1998_has_the_ordinates_of_its_figures() {
        // Type 1, ground type B: S 1.2, T_B 0.15, T_C 0.5, T_D 2; a_g = 1. The plateau is 2.5 S, and S at T = 0.
        let of = |ratio: f64| Target::En1998 {
            ag: 1.0,
            soil: 1.2,
            corners: [0.15, 0.5, 2.0],
            ratio,
        };
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-14, "{a} {b}");
        for (period, expected) in [
            (0.0, 1.2),
            (0.075, 1.2 * 1.75),
            (0.15, 3.0),
            (0.5, 3.0),
            (1.0, 1.5),
            (2.0, 0.75),
            (4.0, 0.1875),
        ] {
            near(of(0.05).at(period), expected);
        }
        // eta = sqrt(10/15) for 10 %, and not below 0.55.
        near(of(0.10).at(0.3), 3.0 * (2.0_f64 / 3.0).sqrt());
        near(of(0.50).at(0.3), 3.0 * 0.55);
    }

    #[test]
    fn the_spectrum_of_asce_7_has_its_branches() {
        let target = Target::Asce7 {
            short: 1.0,
            one: 0.6,
            long: 8.0,
        };
        for (period, expected) in [
            (0.0, 0.4),
            (0.06, 0.7),
            (0.12, 1.0),
            (0.6, 1.0),
            (1.0, 0.6),
            (8.0, 0.075),
            (16.0, 0.6 * 8.0 / 256.0),
        ] {
            assert!((target.at(period) - expected).abs() < 1e-14, "{period}");
        }
    }

    #[test]
    fn a_table_is_straight_and_constant_beyond() {
        let target = Target::Table {
            periods: vec![0.5, 1.0, 3.0],
            ordinates: vec![2.0, 4.0, 0.0],
        };
        let at = [0.1, 0.5, 0.75, 1.0, 2.0, 3.0, 9.0].map(|period| target.at(period));
        assert_eq!(at, [2.0, 2.0, 3.0, 4.0, 2.0, 0.0, 0.0]);
    }

    #[test]
    fn the_nearest_factor_has_the_smallest_squares() {
        let (ordinates, wanted) = ([1.0, 2.0, 4.0], [3.0, 3.0, 9.0]);
        let squares = |f: f64| -> f64 {
            let both = ordinates.iter().zip(wanted);
            both.map(|(ordinate, wanted)| (f * ordinate - wanted) * (f * ordinate - wanted))
                .sum()
        };
        let best = Fit::Linear.nearest(&ordinates, &wanted);
        assert!((best - 45.0 / 21.0).abs() < 1e-15);
        assert!(squares(best) < squares(best + 1e-3) && squares(best) < squares(best - 1e-3));
        for fit in Fit::ALL {
            let periods = fit.periods([0.2, 2.0]);
            assert_eq!((periods[0], periods[100], periods.len()), (0.2, 2.0, 101));
        }
        // sqrt(0.2 2) is in the middle of the logarithms, and the geometric mean of 3, 1.5 and 2.25 the factor.
        assert!((Fit::Logarithmic.periods([0.2, 2.0])[50] - 0.4_f64.sqrt()).abs() < 1e-15);
        let best = Fit::Logarithmic.nearest(&ordinates, &wanted);
        assert!((best - (3.0 * 1.5 * 2.25_f64).cbrt()).abs() < 1e-14);
    }
}
