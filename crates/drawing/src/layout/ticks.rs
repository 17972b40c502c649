//! Axes with round numbers: linear, in multiples of pi, logarithmic.

use crate::layout::axis::Scale;
use crate::layout::axis::{Axis, Tick};
use crate::text::number;
use libm::{ceil, floor, log10, pow};
use std::f64::consts::PI;

/// The smallest number above zero.
const SMALLEST: f64 = f64::from_bits(1);

/// The finest step whose parts are numbers of full precision.
const FINEST: f64 = 1e-300;

/// Most powers of ten that each have a tick.
const MOST_DECADES: usize = 40;

/// The ticks of a decade.
const DIGITS: [i32; 9] = [1, 2, 3, 4, 5, 6, 7, 8, 9];

/// Fewest numbers along a logarithmic axis: two do not show that it is one.
const FEWEST: usize = 3;

/// A linear axis round the values, a little wider, to the next minor ticks; `most` labels at most.
pub fn around(title: &str, values: impl Iterator<Item = f64>, most: f64) -> Axis {
    let [low, high] = span(values, |x| if x == 0.0 { 1.0 } else { 0.1 * x.abs() });
    let pad = 0.03 * high - 0.03 * low;
    // The data's steps, not those of the wider range, which may be the next coarser ones.
    let (major, minor) = steps([low, high], most);
    if major < 2.0 * FINEST {
        return linear(title, [low, high], most);
    }
    let low = floor((low - pad) / minor + 1e-9) * minor;
    let high = ceil((high + pad) / minor - 1e-9) * minor;
    stepped(title, [low, high].map(finite), (major, minor))
}

/// A linear axis of exactly this range; `most` labels at most.
pub fn linear(title: &str, range: [f64; 2], most: f64) -> Axis {
    let range = range.map(finite);
    stepped(title, range, steps(range, most))
}

fn stepped(title: &str, range: [f64; 2], (major, minor): (f64, f64)) -> Axis {
    let decimals = |unit: f64| (-floor(log10(major / unit) + 1e-9)).max(0.0);
    let largest = range[0].abs().max(range[1].abs());
    // As many digits as distinguish neighbours, and two more.
    let digits = (log10(largest / major) + 2.0).clamp(10.0, 16.0) as usize;
    let plain = decimals(1.0);
    let label = |x: f64| {
        if plain > 4.0 || largest >= 1e5 {
            // Without the last digits, which have the rounding of the product of count and step.
            number::plain(format!("{x:.digits$e}").parse().unwrap_or(x))
        } else {
            fixed(x, plain)
        }
    };
    let axis = spaced(title, range, major, minor, label);
    let numbers = axis.ticks.iter().filter(|tick| !tick.label.is_empty());
    // Ticks at the ends alone are at no round numbers.
    let is_even = major >= 2.0 * FINEST && minor >= 4.0 * f64::EPSILON * largest;
    if !is_even || numbers.clone().all(|tick| !tick.label.contains("10^")) {
        return axis;
    }
    // Once for all, the power of the largest number.
    let largest = numbers.map(|tick| tick.at.abs()).fold(0.0, f64::max);
    let exponent = floor(log10(largest) + 1e-9);
    let unit = pow(10.0, exponent);
    let decimals = decimals(unit);
    if unit == 0.0 || !unit.is_finite() || decimals > MOST_DECIMALS {
        return axis;
    }
    Axis {
        power: exponent as i32,
        ticks: axis
            .ticks
            .into_iter()
            .map(|tick| Tick {
                label: match tick.label.is_empty() {
                    true => tick.label,
                    false => fixed(tick.at / unit, decimals),
                },
                ..tick
            })
            .collect(),
        ..axis
    }
}

/// Most decimals of numbers over a power of ten.
const MOST_DECIMALS: f64 = 4.0;

/// A number with this many decimals.
fn fixed(x: f64, decimals: f64) -> String {
    match x {
        0.0 if decimals == 0.0 => "0".into(),
        x => format!("{x:.0$}", decimals as usize).replace('-', "−"),
    }
}

/// A linear axis of exactly this range with ticks at multiples of pi; `most` labels at most.
pub fn in_pi(title: &str, range: [f64; 2], most: f64) -> Axis {
    // Major and minor steps over pi.
    const STEPS: [(f64, f64); 13] = [
        (0.05, 0.01),
        (0.1, 0.05),
        (0.25, 0.125),
        (0.5, 0.25),
        (1.0, 0.5),
        (2.0, 1.0),
        (4.0, 1.0),
        (10.0, 2.0),
        (20.0, 5.0),
        (50.0, 10.0),
        (100.0, 20.0),
        (200.0, 50.0),
        (500.0, 100.0),
    ];
    let length = (range[1] - range[0]) / PI;
    match STEPS.iter().find(|(major, _)| length / major <= most) {
        Some((major, minor)) if length >= 0.1 => {
            let range = range.map(finite);
            let label = number::number;
            spaced(title, range, major * PI, minor * PI, label)
        }
        _ => linear(title, range, most),
    }
}

/// A logarithmic axis round the positive ones of the values.
pub fn log(title: &str, values: impl Iterator<Item = f64>, most: f64) -> Axis {
    let logs = values.filter(|x| *x > 0.0).map(log10);
    let [low, high] = span(logs, |_| 0.3);
    let pad = 0.04 * (high - low).max(0.5);
    let logs = [low - pad, high + pad];
    log_range(title, logs.map(|x| pow(10.0, x)), most)
}

/// A logarithmic axis of exactly this range, as far as double precision reaches.
pub fn log_range(title: &str, range: [f64; 2], most: f64) -> Axis {
    let range = range.map(|x| x.clamp(SMALLEST, f64::MAX));
    let (first, last) = (floor(log10(range[0])) as i32, ceil(log10(range[1])) as i32);
    let inside =
        |x: f64| x.is_finite() && x >= range[0] * (1.0 - 1e-12) && x <= range[1] * (1.0 + 1e-12);
    let decades = (first..=last)
        .filter(|k| inside(pow(10.0, f64::from(*k))))
        .count();
    let every = ceil((decades as f64 - 1.0) / most).max(1.0) as i32;
    // Three numbers a decade if that is not much more than `most`.
    let fine = decades < 2 || 3.0 * (log10(range[1]) - log10(range[0])) <= 1.5 * most;
    let all_digits: &[i32] = if every > 1 { &[1] } else { &DIGITS };
    let within = |k: i32| {
        let at = move |digit: &i32| (*digit, f64::from(*digit) * pow(10.0, f64::from(k)));
        all_digits.iter().map(at).filter(move |(_, at)| inside(*at))
    };
    // One form of numbers along an axis: without powers if all are short.
    let plain = fine && (first..=last).all(|k| within(k).all(|(_, at)| (1e-4..1e5).contains(&at)));
    let with_numbers_at = |numbered_digits: &[i32]| {
        let mut ticks = Vec::new();
        for k in first..=last {
            for (digit, at) in within(k) {
                let numbered = match digit {
                    1 => k.rem_euclid(every) == 0,
                    _ => numbered_digits.contains(&digit),
                };
                if decades > MOST_DECADES && !numbered {
                    continue;
                }
                let label = match (numbered, digit) {
                    (false, _) => String::new(),
                    (true, _) if plain => number::short(at),
                    (true, 1) => format!("10^{k}^").replace('-', "−"),
                    (true, _) => format!("{digit} × 10^{k}^").replace('-', "−"),
                };
                ticks.push(Tick { at, label });
            }
        }
        ticks
    };
    let numbers = |ticks: &[Tick]| ticks.iter().filter(|tick| !tick.label.is_empty()).count();
    // As few as possible, but three.
    let choices: &[&[i32]] = match fine {
        true => &[&[1, 2, 5], &[1, 2, 3, 5, 7], &DIGITS],
        false => &[&[1], &[1, 3], &[1, 2, 5]],
    };
    let sets = || choices.iter().map(|digits| with_numbers_at(digits));
    let enough = sets().find(|ticks| numbers(ticks) >= FEWEST);
    let mut ticks = enough.or_else(|| sets().next_back()).unwrap_or_default();
    let mut power = 0;
    // Between round numbers, steps of a linear axis; they are not evenly spaced here.
    for most in [most.min(4.0), 5.0, 8.0] {
        if numbers(&ticks) < FEWEST {
            let even = linear(title, range, most);
            if numbers(&even.ticks) > numbers(&ticks) {
                (ticks, power) = (even.ticks, even.power);
            }
        }
    }
    Axis {
        title: title.into(),
        range,
        scale: Scale::Log,
        ticks,
        power,
        numbered: true,
    }
}

/// Smallest and largest of the finite values; if they are equal, widened by `wider`.
fn span(values: impl Iterator<Item = f64>, wider: impl Fn(f64) -> f64) -> [f64; 2] {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for x in values.filter(|x| x.is_finite()) {
        low = low.min(x);
        high = high.max(x);
    }
    if low > high {
        return [0.0, 1.0];
    }
    if high - low > 1e-9 * low.abs().max(high.abs()) {
        return [low, high];
    }
    let by = wider(low).max(SMALLEST);
    [low - by, high + by].map(finite)
}

/// The nearest finite number.
fn finite(x: f64) -> f64 {
    x.clamp(-f64::MAX, f64::MAX)
}

/// Major and minor step for at most `most` steps over a range: 1, 2 or 5 times a power of ten.
fn steps(range: [f64; 2], most: f64) -> (f64, f64) {
    let length = range[1] - range[0];
    // The difference of the ends is larger than the largest number.
    let spacing = match length.is_finite() {
        true => length / most,
        false => range[1] / most - range[0] / most,
    };
    let raw = spacing.clamp(FINEST, 1e308);
    let power = pow(10.0, floor(log10(raw)));
    let (major, parts) = match raw / power {
        m if m <= 1.0 + 1e-9 => (1.0, 5.0),
        m if m <= 2.0 + 1e-9 => (2.0, 4.0),
        m if m <= 5.0 + 1e-9 => (5.0, 5.0),
        _ => (10.0, 5.0),
    };
    (major * power, major * power / parts)
}

fn spaced(
    title: &str,
    range: [f64; 2],
    major: f64,
    minor: f64,
    label: impl Fn(f64) -> String,
) -> Axis {
    // Too few numbers in the range in double precision: only the ends have ticks.
    let largest = range[0].abs().max(range[1].abs());
    if major < 2.0 * FINEST || minor < 4.0 * f64::EPSILON * largest {
        let end = |at| Tick {
            at,
            label: number::plain(at),
        };
        return Axis {
            title: title.into(),
            range,
            scale: Scale::Linear,
            ticks: range.map(end).to_vec(),
            power: 0,
            numbered: true,
        };
    }
    let each = (major / minor).round() as i64;
    let first = ceil(range[0] / minor - 1e-6) as i64;
    let last = floor(range[1] / minor + 1e-6) as i64;
    let ticks = (first..=last)
        .map(|k| {
            let numbered = k.rem_euclid(each) == 0;
            // A multiple of the major step if it is one, so that 3 steps of 0.1 are not 0.30000000000000004 twice over.
            let at = if numbered {
                (k / each) as f64 * major
            } else {
                k as f64 * minor
            };
            Tick {
                at,
                label: if numbered { label(at) } else { String::new() },
            }
        })
        .collect();
    Axis {
        title: title.into(),
        range,
        scale: Scale::Linear,
        ticks,
        power: 0,
        numbered: true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(axis: &Axis) -> Vec<&str> {
        let labels = axis.ticks.iter().map(|tick| tick.label.as_str());
        labels.filter(|label| !label.is_empty()).collect()
    }

    #[test]
    fn round_numbers() {
        let axis = around("", [-9.9, 12.0].into_iter(), 6.0);
        assert_eq!(axis.range, [-11.0, 13.0]);
        assert_eq!(labels(&axis), ["−10", "−5", "0", "5", "10"]);
        assert_eq!(
            labels(&linear("", [0.0, 0.31], 4.0)),
            ["0.0", "0.1", "0.2", "0.3"]
        );
    }

    #[test]
    fn a_power_of_ten_is_once_at_the_axis() {
        let axis = |range, most| linear("", range, most);
        for (range, most, power, expected) in [
            ([0.0, 3e-6], 4.0, -6, &["0", "1", "2", "3"][..]),
            ([0.0, 1.2e6], 3.0, 6, &["0.0", "0.5", "1.0"]),
            ([-2e5, 2e5], 4.0, 5, &["−2", "−1", "0", "1", "2"]),
            ([0.0, 4e-5], 4.0, -5, &["0", "1", "2", "3", "4"]),
            ([0.0, 0.02], 2.0, 0, &["0.00", "0.01", "0.02"]),
            ([0.0, 99_000.0], 2.0, 0, &["0", "50000"]),
        ] {
            let axis = axis(range, most);
            assert_eq!((axis.power, &labels(&axis)[..]), (power, expected));
        }
        // The numbers times the power are the values.
        let axis = around("", [-3.21e-7, 8.9e-7].into_iter(), 6.0);
        assert_eq!(axis.power, -6);
        assert_eq!(axis.power_label(), "× 10^−6^");
        for tick in axis.ticks.iter().filter(|tick| !tick.label.is_empty()) {
            let number: f64 = tick.label.replace('−', "-").parse().unwrap();
            assert!((number * 1e-6 - tick.at).abs() < 1e-20, "{tick:?}");
        }
    }

    #[test]
    fn multiples_of_pi() {
        let axis = in_pi("", [0.0, 8.0 * PI], 8.0);
        assert_eq!(
            labels(&axis),
            ["0", "π", "2π", "3π", "4π", "5π", "6π", "7π", "8π"]
        );
        assert_eq!(
            labels(&in_pi("", [0.0, 8.0 * PI], 5.0)),
            ["0", "2π", "4π", "6π", "8π"]
        );
        assert_eq!(
            labels(&in_pi("", [0.0, 20.0], 4.0)),
            ["0", "2π", "4π", "6π"]
        );
        assert_eq!(labels(&in_pi("", [0.0, 1e5], 5.0)).last(), Some(&"1.0"));
    }

    #[test]
    fn decades() {
        let axis = log("", [2e-3, 5.0].into_iter(), 4.0);
        assert_eq!(labels(&axis), ["10^−2^", "10^−1^", "10^0^"]);
        let roomy = log("", [0.02, 5.0].into_iter(), 8.0);
        assert_eq!(labels(&roomy)[..4], ["0.02", "0.05", "0.1", "0.2"]);
        // What counts is the powers of ten in the range, not those around it.
        let narrow = log("", [0.05, 10.0].into_iter(), 3.0);
        assert_eq!(labels(&narrow), ["10^−1^", "10^0^", "10^1^"]);
        let between = log("", [0.28, 0.39].into_iter(), 6.0);
        assert_eq!(labels(&between), ["0.30", "0.35", "0.40"]);
        let short = log("", [0.02, 0.09].into_iter(), 8.0);
        assert_eq!(labels(&short), ["0.02", "0.03", "0.05", "0.07"]);
        // One form of numbers along an axis.
        let thousands = log("", [300.0, 4e4].into_iter(), 12.0);
        assert_eq!(labels(&thousands)[..3], ["500", "1000", "2000"]);
        let larger = log("", [3000.0, 4e5].into_iter(), 12.0);
        assert!(labels(&larger).iter().all(|label| label.contains("10^")));
        // Two powers of ten alone do not show that an axis is logarithmic.
        let two = log("", [0.9, 11.0].into_iter(), 2.0);
        assert_eq!(labels(&two), ["10^0^", "3 × 10^0^", "10^1^"]);
        assert!(
            (axis.fraction(0.1) - (axis.fraction(0.01) + axis.fraction(1.0)) / 2.0).abs() < 1e-12
        );
        assert!(axis.fraction(0.0).is_nan());
    }

    #[test]
    fn odd_values_still_make_an_axis() {
        for values in [vec![], vec![0.0], vec![3.0, 3.0], vec![f64::NAN]] {
            for axis in [
                around("", values.iter().copied(), 5.0),
                log("", values.iter().copied(), 5.0),
            ] {
                sound(&axis, 5.0);
            }
        }
    }

    #[test]
    fn the_ends_of_double_precision() {
        let wide = around("", [-1e300, 1e300].into_iter(), 5.0);
        assert_eq!(labels(&wide), ["−1.0", "−0.5", "0.0", "0.5", "1.0"]);
        assert_eq!(wide.power, 300);
        assert!((wide.fraction(0.0) - 0.5).abs() < 1e-15);
        let widest = linear("", [-f64::MAX, f64::MAX], 5.0);
        assert_eq!(labels(&widest), ["−1", "0", "1"]);
        assert_eq!(widest.power, 308);
        // 616 decades in powers of ten that are multiples of 124.
        let decades = log_range("", [1e-308, 1e308], 5.0);
        assert_eq!(
            labels(&decades),
            ["10^−248^", "10^−124^", "10^0^", "10^124^", "10^248^"]
        );
        assert!((decades.fraction(1.0) - 0.5).abs() < 1e-15);
        let least = linear("", [0.0, SMALLEST], 5.0);
        assert_eq!(labels(&least), ["0", "5 × 10^−324^"]);
        let close = linear("", [1.0, 1.0 + 2.0 * f64::EPSILON], 5.0);
        assert_eq!(labels(&close), ["1", "1.0000000000000004"]);
        let near = linear("", [1.0, 1.0 + 3e-13], 4.0);
        assert_eq!(labels(&near)[1], "1.0000000000001");
    }

    /// What an axis must be whatever it was made from: few ticks, rising, inside a range that is finite and not empty;
    /// numbers that differ, two of them at least.
    fn sound(axis: &Axis, most: f64) {
        let [low, high] = axis.range;
        assert!(
            low.is_finite() && high.is_finite() && low < high,
            "{axis:?}"
        );
        assert!(axis.ticks.len() <= 100, "{axis:?}");
        assert!(axis.ticks.windows(2).all(|t| t[0].at < t[1].at), "{axis:?}");
        // Ends are taken within 1e-6 of the smaller steps; a tick of a short range far from zero is rounded besides.
        let rounding = 2.0 * f64::EPSILON * (low.abs().max(high.abs()) / (high - low));
        let slack = 1e-5 + rounding.min(0.5);
        let fraction = |tick: &Tick| axis.fraction(tick.at);
        assert!(
            axis.ticks
                .iter()
                .all(|t| (-slack..1.0 + slack).contains(&fraction(t))),
            "{axis:?}"
        );
        let labels = labels(axis);
        let distinct: std::collections::HashSet<&&str> = labels.iter().collect();
        assert_eq!(distinct.len(), labels.len(), "{axis:?}");
        assert!(labels.len() >= 2, "{axis:?}");
        // Unless the range has no three numbers of double precision.
        let is_wide = low > FINEST && high / low > 1.0 + 1e-9;
        assert!(
            axis.scale == Scale::Linear || !is_wide || labels.len() >= FEWEST,
            "{axis:?}"
        );
        assert!(labels.len() as f64 <= 3.0 * most + 2.0, "{axis:?}");
    }

    proptest::proptest! {
        #![proptest_config(proptest::test_runner::Config {
            cases: 4000,
            failure_persistence: None,
            ..Default::default()
        })]
        #[test]
        fn every_finite_range_has_an_axis(
            a in proptest::num::f64::NORMAL | proptest::num::f64::SUBNORMAL | proptest::num::f64::ZERO,
            b in proptest::num::f64::NORMAL | proptest::num::f64::SUBNORMAL | proptest::num::f64::ZERO,
            near in 0_u64..1_000_000,
            most in 5.0..9.0_f64,
        ) {
            // Ends anywhere, and ends that are neighbours of double precision or nearly so.
            let close = f64::from_bits(a.to_bits() ^ near);
            for other in [b, close] {
                let (low, high) = (a.min(other), a.max(other));
                sound(&around("", [low, high].into_iter(), most), most);
                sound(&log("", [low, high].into_iter(), most), most);
                if low < high {
                    sound(&linear("", [low, high], most), most);
                    sound(&in_pi("", [low, high], most), most);
                }
                let (low, high) = (low.abs().min(high.abs()), low.abs().max(high.abs()));
                if low < high {
                    sound(&log_range("", [low, high], most), most);
                }
            }
        }
    }
}
