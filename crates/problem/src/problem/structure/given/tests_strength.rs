//! The strength that motions, pairs and sets get, with strengths that are given.

use super::amount::{self, Amount};
use super::motion_set::{Motions, Set, Statistic};
use super::pair::Pair;
use super::scale_to::{Goal, ScaleTo};
use super::shape::Scaled;
use super::source::{Kind, Source};
use super::strength::{Asked, Strengths};
use super::target_spectrum::TargetSpectrum;
use crate::problem::friction::FrictionOscillator;
use crate::problem::numbers::parameter::{Range, Value};
use crate::problem::{Case, Problem, Violation};
use crate::system::loads::measures::Measure;
use crate::system::loads::pair::Component;
use crate::system::loads::target::Fit;

fn amount(x: f64) -> Amount {
    Amount {
        source: amount::Source::Number(x),
        range: Range::Any,
        at: 0,
        path: "x".into(),
    }
}

fn case() -> Case {
    Case::new(FrictionOscillator.schema())
}

/// A motion with this largest acceleration and these pseudo-accelerations at all periods.
#[derive(Debug)]
struct Level {
    peak: f64,
    spectral: f64,
}

impl Strengths for Level {
    fn strength(&self, asked: Asked, _: &Case, _: f64) -> Result<f64, Violation> {
        match asked.measure == Measure::PeakAcceleration {
            true => Ok(self.peak),
            false => Ok(self.spectral),
        }
    }

    fn identity(&self, _: &Case) -> Result<Vec<u64>, Violation> {
        Ok(vec![self.peak.to_bits(), self.spectral.to_bits()])
    }
}

/// A set of one motion whose spectrum must be at least 1 between the periods, and at T = 0 at least this.
fn set(between: [(f64, Vec<Amount>); 2], at_zero: Option<f64>) -> Set {
    let amounts = |values: [f64; 2]| values.map(amount).to_vec();
    Set {
        rule: None,
        members: vec![Vec::<(usize, Value)>::new()],
        statistic: Statistic::Mean,
        component: None,
        least: amount(1.0),
        at_zero: at_zero.map(amount),
        between,
        target: TargetSpectrum::Table([amounts([0.0, 10.0]), amounts([1.0, 1.0])]),
        factor: None,
        made: Default::default(),
    }
}

fn of_set<T>(level: &Level, of: impl FnOnce(&Motions) -> T) -> T {
    of(&Motions {
        strengths: level,
        factor: &|_| Ok(1.0),
        identity: &|_| Ok(Vec::new()),
        ratio: 0.05,
        unit: 1.0,
        metre: 1.0,
    })
}

fn wide() -> [(f64, Vec<Amount>); 2] {
    [(1.0, vec![amount(0.2)]), (1.0, vec![amount(2.0)])]
}

/// The factor is the least one with which the rule holds, also after rounding: 1/49 times 49 is below 1.
#[test]
fn a_set_meets_its_rule_to_the_last_bit() {
    for spectral in [0.3, 0.7, 49.0, 98.0, 1.0 / 3.0] {
        let level = Level {
            peak: 1.0,
            spectral,
        };
        let state = of_set(&level, |motions| set(wide(), None).state(&case(), motions)).unwrap();
        assert!(state.ratio >= 1.0, "{spectral} {state:?}");
        assert!(
            state.factor.next_down() * spectral < 1.0,
            "{spectral} {state:?}"
        );
    }
}

#[test]
fn the_rule_reaches_from_the_least_to_the_largest_period() {
    let periods = |values: [f64; 3]| values.map(amount).to_vec();
    let between = [
        (0.2, periods([0.9, 0.5, 0.7])),
        (2.0, periods([0.5, 1.1, 0.7])),
    ];
    let level = Level {
        peak: 1.0,
        spectral: 1.0,
    };
    let drawn = of_set(&level, |motions| {
        set(between, None).drawn(&[1.0], &case(), motions)
    });
    assert_eq!(drawn.unwrap().between, [0.2 * 0.5, 2.0 * 1.1]);
}

#[test]
fn the_rule_for_the_largest_accelerations_counts_too() {
    let level = Level {
        peak: 0.25,
        spectral: 2.0,
    };
    let state = |at_zero| {
        of_set(&level, |motions| {
            set(wide(), at_zero).state(&case(), motions)
        })
    };
    let without = state(None).unwrap();
    assert_eq!(without.factor, 0.5);
    let with = state(Some(0.9)).unwrap();
    assert_eq!(with.period, 0.0);
    // 1/ratio, instead of its inverse.
    assert!((with.factor / 3.6 - 1.0).abs() < 4e-16, "{with:?}");
}

#[test]
fn a_peak_acceleration_is_in_its_unit() {
    let scale_to = ScaleTo {
        goal: Goal::PeakAcceleration(amount(0.4)),
        unit: 9.81,
        ratio: None,
        fit: Fit::Linear,
        component: None,
        set: None,
    };
    let level = Level {
        peak: 2.0,
        spectral: 1.0,
    };
    let factor = scale_to.factor(&case(), 1.0, &level).unwrap();
    assert!(
        (factor / (0.4 * 9.81 / 2.0) - 1.0).abs() < 1e-15,
        "{factor}"
    );
}

/// sqrt(3 4) and sqrt(3^2 + 4^2), asked in turn.
#[test]
fn a_pair_keeps_each_strength_by_its_component() {
    let motion = |peak: f64| Scaled {
        source: Source::new(
            Kind::Table {
                t: [0.0, 1.0, 2.0].map(amount).to_vec(),
                f: [0.0, peak, 0.0].map(amount).to_vec(),
            },
            (0, "ground".into()),
        ),
        scale: None,
        shape: Box::default(),
    };
    let pair = Pair::new([motion(3.0), motion(4.0)]);
    let strength = |component| {
        let asked = Asked {
            measure: Measure::PeakAcceleration,
            component: Some(component),
        };
        pair.strength(asked, &case(), 1.0).unwrap()
    };
    for _ in 0..2 {
        assert_eq!(strength(Component::Srss), 5.0);
        assert!((strength(Component::GeometricMean) - 12.0_f64.sqrt()).abs() < 1e-15);
    }
}
