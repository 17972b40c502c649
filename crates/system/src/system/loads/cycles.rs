//! The whole cycles of an excitation, each from a rise through zero on.

use libm::sqrt;
use std::f64::consts::{PI, TAU};

/// Cycles of one frequency, one after the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cycles {
    /// Cycles per time.
    pub frequency: f64,
    /// Time at which the first one begins.
    pub start: f64,
    /// Number of whole ones.
    pub count: usize,
}

/// Most cycles of a sweep; those of more are too short for the steps of a figure.
const MOST: usize = 5_000_000;

/// How far a part of a cycle may be round-off.
const ROUND_OFF: f64 = 1e-9;

impl Cycles {
    /// The cycles of sin(omega t + phase) at all times from its first rise after t = 0 on; `None` for a constant.
    pub fn of_sine(omega: f64, phase: f64) -> Option<Cycles> {
        let rising = if omega < 0.0 { PI - phase } else { phase } / TAU;
        let frequency = omega.abs() / TAU;
        let start = ((rising - ROUND_OFF).ceil() - rising) / frequency;
        (frequency > 0.0).then_some(Cycles {
            frequency,
            start,
            count: usize::MAX,
        })
    }

    /// The same ones later.
    pub fn delayed(self, by: f64) -> Cycles {
        Cycles {
            start: self.start + by,
            ..self
        }
    }

    /// Those that are as a whole from the first to the second time.
    pub fn within(self, [first, last]: [f64; 2]) -> Cycles {
        let Cycles {
            frequency, start, ..
        } = self;
        let before = ((first - start) * frequency - ROUND_OFF).ceil().max(0.0);
        let until = ((last - start) * frequency + ROUND_OFF).floor().max(0.0) as usize;
        let count = until.min(self.count).saturating_sub(before as usize);
        Cycles {
            frequency,
            start: start + before / frequency,
            count,
        }
    }

    /// Beginning and end of the cycle of this number.
    pub fn ends(self, cycle: usize) -> [f64; 2] {
        [cycle, cycle + 1].map(|number| self.start + number as f64 / self.frequency)
    }
}

/// The cycles of a sweep of these numbers: one of each frequency.
pub(super) fn of_sweep(numbers: &[f64]) -> Vec<Cycles> {
    let [_, from, to, duration, _] = *numbers else {
        return Vec::new();
    };
    let whole = (0.5 * (from + to) * duration + ROUND_OFF).floor() as usize;
    // The phase from t + (to - from) t^2/(2 duration) is a whole number.
    let time = |cycle: usize| {
        let cycle = cycle as f64;
        let root = from * from + 2.0 * (to - from) * cycle / duration;
        2.0 * cycle / (from + sqrt(root.max(0.0)))
    };
    let cycle = |number: usize| {
        let [start, end] = [number, number + 1].map(time);
        Cycles {
            frequency: 1.0 / (end - start),
            start,
            count: 1,
        }
    };
    (0..whole.min(MOST)).map(cycle).collect()
}

/// The frequency of a step of a stepped sweep, the time at which it begins, and the phase in cycles there.
pub(super) fn step([from, to, steps, duration]: [f64; 4], step: f64) -> [f64; 3] {
    let (held, rise) = (duration / steps, (to - from) / (steps - 1.0));
    let frequency = from + rise * step;
    let phase = held * step * (from + 0.5 * rise * (step - 1.0));
    [frequency, held * step, phase]
}

/// The cycles of a stepped sweep of these numbers.
pub(super) fn of_stepped_sweep(numbers: &[f64]) -> Vec<Cycles> {
    let [_, from, to, steps, duration, _] = *numbers else {
        return Vec::new();
    };
    let of_step = |number: u32| {
        let of = |number: f64| step([from, to, steps, duration], number);
        let [frequency, begin, phase] = of(f64::from(number));
        let rise = ((phase - ROUND_OFF).ceil() - phase) / frequency;
        let endless = Cycles {
            frequency,
            start: begin + rise,
            count: usize::MAX,
        };
        endless.within([begin, begin + duration / steps])
    };
    (0..steps as u32).map(of_step).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::loads::pulse::PULSES;

    /// Asserts that a function rises through 0 at both ends of each cycle, and is above 0 before its middle and below after it.
    fn assert_rises(cycles: &[Cycles], value: impl Fn(f64) -> f64) {
        for cycles in cycles {
            for number in 0..cycles.count {
                let [begin, end] = cycles.ends(number);
                let part = |share: f64| begin + share * (end - begin);
                for (share, sign) in [(1e-4, 1.0), (0.3, 1.0), (0.7, -1.0), (0.9999, -1.0)] {
                    assert!(sign * value(part(share)) > 0.0, "{begin} {share}");
                }
            }
        }
    }

    #[test]
    fn cycles_begin_where_their_function_rises_through_zero() {
        for (omega, phase) in [(3.0, 0.0), (2.0, 1.0), (0.7, -4.0), (-5.0, 0.4), (1.0, TAU)] {
            let sine = Cycles::of_sine(omega, phase).unwrap();
            assert!(sine.start >= 0.0 && sine.start < 1.0 / sine.frequency);
            let part = sine.within([4.0, 25.0]);
            let whole = 21.0 * omega.abs() / TAU;
            assert!(part.count as f64 <= whole && part.count as f64 > whole - 2.0);
            assert_rises(&[part], |t| libm::sin(omega * t + phase));
        }
        assert_eq!(Cycles::of_sine(0.0, 1.0), None);
        for (from, to) in [(1.0, 3.0), (3.0, 1.0), (2.0, 2.0)] {
            let numbers = [2.0, from, to, 10.0, 1e-4];
            let pulse = PULSES.iter().find(|pulse| pulse.name == "sweep").unwrap();
            let table = pulse.table(&numbers).unwrap();
            let cycles = of_sweep(&numbers);
            assert_eq!(cycles.len(), (5.0 * (from + to)) as usize);
            assert_rises(&cycles, |t| table.at(t));
        }
    }

    #[test]
    fn a_stepped_sweep_has_its_frequencies_and_no_jump() {
        for [from, to] in [[1.0, 2.0], [2.0, 1.0]] {
            let numbers = [0.5, from, to, 5.0, 37.0, 1e-4];
            let pulse = PULSES.iter().find(|pulse| pulse.name == "stepped_sweep");
            let table = pulse.unwrap().table(&numbers).unwrap();
            let cycles = of_stepped_sweep(&numbers);
            for (i, cycles) in cycles.iter().enumerate() {
                let frequency = from + 0.25 * (to - from) * i as f64;
                assert!((cycles.frequency - frequency).abs() < 1e-15);
                // 7.4 times the frequency, less the parts of cycles at both ends.
                let whole = 7.4 * frequency;
                assert!(cycles.count as f64 <= whole && cycles.count as f64 > whole - 2.0);
            }
            assert_rises(&cycles, |t| table.at(t));
            // The slope of the sine is at most 0.5 (2 pi) 2; a jump is larger.
            let jump = |pair: &[f64]| (pair[1] - pair[0]).abs();
            let largest = table.values().windows(2).map(jump).fold(0.0, f64::max);
            // The last point is a jump to 0 unless the sine ends there.
            let inner = table.values().len() - 2;
            let inside = table.values()[..inner].windows(2).map(jump);
            assert!(inside.fold(0.0, f64::max) < 0.5 * TAU * 2.0 * 1.001e-4);
            assert!(largest <= 0.5);
        }
    }

    #[test]
    fn only_whole_cycles_are_within() {
        let cycles = Cycles {
            frequency: 2.0,
            start: 1.0,
            count: 6,
        };
        let part = |first, last| {
            let part = cycles.within([first, last]);
            (part.start, part.count)
        };
        assert_eq!(part(0.0, 9.0), (1.0, 6));
        assert_eq!(part(1.2, 3.9), (1.5, 4));
        // A multiple but for round-off.
        assert_eq!(part(1.5 + 1e-12, 4.0 - 1e-12), (1.5, 5));
        assert_eq!(part(5.0, 9.0).1, 0);
        assert_eq!(cycles.delayed(0.5).ends(2), [2.5, 3.0]);
    }
}
