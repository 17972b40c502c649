//! Steps of the laws against their own equations, written here from the papers.

use super::hertz::{jankowski, newton};
use super::*;
use crate::contact::{
    ContactLaw, ContactResponse, Flexibility, ImpactSpring, StepFlexibility, StoredEnergy, Trial,
};
use proptest::prelude::*;
use std::f64::consts::PI;

const EPS: f64 = f64::EPSILON;

/// Numbers of a law.
#[derive(Debug, Clone, Copy)]
struct Numbers {
    stiffness: f64,
    restitution: f64,
    mass: f64,
}

/// The laws with compliance.
fn laws(n: &Numbers) -> [ContactLaw; 6] {
    let Numbers {
        stiffness,
        restitution,
        mass,
    } = *n;
    [
        ContactLaw::KelvinVoigt(KelvinVoigt::new(stiffness, restitution, mass)),
        ContactLaw::Hertz(Hertz { stiffness }),
        ContactLaw::HertzDamp(HertzDamp::new(stiffness, restitution)),
        ContactLaw::HuntCrossley(HuntCrossley::new(stiffness, restitution)),
        ContactLaw::Ye(Ye::new(stiffness, restitution)),
        ContactLaw::Jankowski(Jankowski::new(stiffness, restitution, mass)),
    ]
}

/// F of the law with this index at delta, ddelta.
fn equation(law: usize, n: &Numbers, v0: f64, delta: f64, rate: f64) -> f64 {
    let Numbers {
        stiffness: k,
        restitution: e,
        mass: m,
    } = *n;
    if delta <= 0.0 {
        return 0.0;
    }
    let hertz = k * delta * delta.sqrt();
    let factor = |a: f64| (hertz * (1.0 + a / v0 * rate)).max(0.0);
    match law {
        0 => {
            let xi = -libm::log(e) / libm::hypot(PI, libm::log(e));
            (k * delta + 2.0 * xi * (k * m).sqrt() * rate).max(0.0)
        }
        1 => hertz,
        2 => factor(3.0 * (1.0 - e) * (1.0 + e) / 4.0),
        3 => factor(3.0 * (1.0 - e) / 2.0),
        4 => factor(8.0 * (1.0 - e) / (5.0 * e)),
        _ => {
            let xi =
                4.5 * 5.0_f64.sqrt() * (1.0 - e) * (1.0 + e) / (e * (e * (9.0 * PI - 16.0) + 16.0));
            hertz + 2.0 * xi * (k * delta.sqrt() * m).sqrt() * rate.max(0.0)
        }
    }
}

/// Where 1 + kappa ddelta/v0 is zero, -v0/kappa; a unit of velocity of the law.
fn unit_rate(law: usize, e: f64, v0: f64) -> f64 {
    match law {
        2 => v0 / (3.0 * (1.0 - e) * (1.0 + e) / 4.0),
        3 => v0 / (3.0 * (1.0 - e) / 2.0),
        4 => v0 / (8.0 * (1.0 - e) / (5.0 * e)),
        _ => 0.0,
    }
}

fn trial([displacement, velocity, force, change, rate]: [f64; 5]) -> Trial<1> {
    Trial {
        displacement: Lane([displacement]),
        velocity: Lane([velocity]),
        force: Lane([force]),
        change: Lane([change]),
        rate: Lane([rate]),
    }
}

fn flexibility([h, h_rate]: [f64; 2]) -> StepFlexibility<1> {
    let end = Flexibility {
        h: Lane([h]),
        h_rate: Lane([h_rate]),
    };
    StepFlexibility {
        start: end,
        end,
        dt: Lane([1.0]),
        by_impulse: false,
    }
}

/// A law in contact since it closed at the speed v0.
fn in_contact(
    law: &ContactLaw,
    on: &StepFlexibility<1>,
    v0: f64,
) -> crate::contact::AnyRunningLaw<1> {
    let mut running = ContactLaw::running(&[*law], &[*on; 2]);
    running.force(0, &trial([0.0, -v0, 0.0, -1e-3 * v0, -v0]));
    running
}

fn answer(law: &ContactLaw, on: &StepFlexibility<1>, v0: f64, at: [f64; 5]) -> f64 {
    in_contact(law, on, v0).force(0, &trial(at)).0[0]
}

/// 10^x.
fn decades(range: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    range.prop_map(|x| libm::pow(10.0, x))
}

fn numbers() -> impl Strategy<Value = Numbers> {
    let ranges = (decades(-3.0..6.0), 0.05..1.0_f64, decades(-2.0..2.0));
    ranges.prop_map(|(stiffness, restitution, mass)| Numbers {
        stiffness,
        restitution,
        mass,
    })
}

/// h and h_rate, either of them also zero.
fn compliances() -> impl Strategy<Value = [f64; 2]> {
    let number = || prop_oneof![4 => decades(-7.0..2.0), 1 => Just(0.0)];
    [number(), number()]
}

/// r, rdot, S at the start, and the free change and rate.
fn steps() -> impl Strategy<Value = [f64; 5]> {
    let size = (decades(-4.0..1.0), decades(-2.0..2.0), decades(-3.0..3.0));
    let parts = [-1.0..1.0_f64, -1.0..1.0, -1.0..0.0, -1.0..1.0, -1.0..1.0];
    (size, parts).prop_map(|((length, speed, force), [r, v, s, change, rate])| {
        [
            length * r,
            speed * v,
            force * s,
            length * change,
            speed * rate,
        ]
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 3000, ..ProptestConfig::default() })]

    #[test]
    fn steps_solve_the_equation_of_the_law(
        n in numbers(), [h, h_rate] in compliances(), v0 in decades(-2.0..1.0), at in steps(),
    ) {
        let [r, _, s, change, rate] = at;
        for (index, law) in laws(&n).iter().enumerate() {
            let force = -answer(law, &flexibility([h, h_rate]), v0, at);
            prop_assert!(force >= 0.0, "law {index} pulls: {force}");
            let delta = -(r + (change - h * s)) - h * force;
            let closing = -(rate - h_rate * s) - h_rate * force;
            // Round-off of each term of delta', of ddelta' with that of 1 + kappa ddelta/v0, and of the force.
            let few = 16.0 * EPS;
            let near = few * (r.abs() + change.abs() + h * (s.abs() + force));
            let slow = few * (rate.abs() + h_rate * (s.abs() + force) + unit_rate(index, n.restitution, v0));
            // f does not fall: its largest and smallest value within the round-off.
            let most = equation(index, &n, v0, delta + near, closing + slow) * (1.0 + few);
            let least = equation(index, &n, v0, delta - near, closing - slow) * (1.0 - few);
            prop_assert!(least <= force && force <= most, "law {index}: {least} {force} {most}");
        }
    }

    #[test]
    fn a_deeper_or_faster_end_of_a_step_has_no_smaller_force(
        n in numbers(), on in compliances(), v0 in decades(-2.0..1.0), at in steps(), more in [0.0..1.0_f64, 0.0..1.0],
    ) {
        let mut further = at;
        further[3] -= more[0] * at[3].abs();
        further[4] -= more[1] * at[4].abs();
        for (index, law) in laws(&n).iter().enumerate() {
            let [force, further] = [at, further].map(|at| -answer(law, &flexibility(on), v0, at));
            // Roots of steps have round-off of this size.
            prop_assert!(further >= force * (1.0 - 32.0 * EPS), "law {index}: {force} {further}");
        }
    }

    #[test]
    fn units_change_no_bit(n in numbers(), [h, h_rate] in compliances(), v0 in decades(-2.0..1.0), at in steps()) {
        // Powers of two, for lengths a power of 16 so that their fourth root is one.
        let (length, speed, force) = (16.0, 32.0, 2.0);
        let [r, v, s, change, rate] = at;
        let other = [r * length, v * speed, s * force, change * length, rate * speed];
        let on = [h * length / force, h_rate * speed / force];
        for (index, law) in laws(&n).into_iter().enumerate() {
            let power = |stiffness: f64| stiffness * (force / (length * 4.0));
            #[expect(clippy::wildcard_enum_match_arm, reason = "`laws` has no others")]
            let rescaled = match law {
                ContactLaw::KelvinVoigt(law) => ContactLaw::KelvinVoigt(KelvinVoigt {
                    stiffness: law.stiffness * (force / length),
                    damping: law.damping * (force / speed),
                }),
                ContactLaw::Hertz(law) => ContactLaw::Hertz(Hertz { stiffness: power(law.stiffness) }),
                ContactLaw::HertzDamp(law) => {
                    ContactLaw::HertzDamp(HertzDamp { stiffness: power(law.stiffness), ..law })
                }
                ContactLaw::HuntCrossley(law) => {
                    ContactLaw::HuntCrossley(HuntCrossley { stiffness: power(law.stiffness), ..law })
                }
                ContactLaw::Ye(law) => ContactLaw::Ye(Ye { stiffness: power(law.stiffness), ..law }),
                ContactLaw::Jankowski(law) => ContactLaw::Jankowski(Jankowski {
                    stiffness: power(law.stiffness),
                    damping: law.damping * (force / (speed * 2.0)),
                }),
                other => panic!("{other:?}"),
            };
            let expected = force * answer(&law, &flexibility([h, h_rate]), v0, at);
            let found = answer(&rescaled, &flexibility(on), v0 * speed, other);
            prop_assert_eq!(found.to_bits(), expected.to_bits(), "law {}", index);
        }
    }

    #[test]
    fn lanes_have_the_bits_of_single_contacts(
        n in numbers(),
        on in [compliances(), compliances(), compliances()],
        motions in prop::collection::vec([steps(), steps(), steps()], 4),
    ) {
        let join = |numbers: [f64; 3]| Lane(numbers);
        let end = Flexibility { h: join(on.map(|on| on[0])), h_rate: join(on.map(|on| on[1])) };
        let lanes = StepFlexibility { start: end, end, dt: Lane::splat(1.0), by_impulse: false };
        for law in laws(&n) {
            let mut together = ContactLaw::running(&[law; 3], &[lanes; 2]);
            let mut alone = on.map(|on| ContactLaw::running(&[law], &[flexibility(on); 2]));
            for at in &motions {
                let number = |i: usize| join(at.map(|at| at[i]));
                let [displacement, velocity, force, change, rate] = [0, 1, 2, 3, 4].map(number);
                let forces = together.force(0, &Trial { displacement, velocity, force, change, rate });
                for l in 0..3 {
                    let one = alone[l].force(0, &trial(at[l])).0[0];
                    prop_assert_eq!(forces.0[l].to_bits(), one.to_bits());
                }
            }
        }
    }
}

#[test]
fn no_damping_remains_without_loss() {
    let n = Numbers {
        stiffness: 7.0,
        restitution: 1.0,
        mass: 3.0,
    };
    assert_eq!(KelvinVoigt::new(7.0, 1.0, 3.0).damping, 0.0);
    assert_eq!(HertzDamp::new(7.0, 1.0).damping, 0.0);
    assert_eq!(HuntCrossley::new(7.0, 1.0).damping, 0.0);
    assert_eq!(Ye::new(7.0, 1.0).damping, 0.0);
    assert_eq!(Jankowski::new(7.0, 1.0, 3.0).damping, 0.0);
    // The same motion as on the undamped law, up to the round-off of a root.
    let (on, at) = (flexibility([0.1, 3.0]), [-0.2, -1.5, -0.3, -0.1, -1.4]);
    let [linear, hertz, others @ ..] = laws(&n);
    let spring = answer(
        &ContactLaw::ImpactSpring(ImpactSpring { stiffness: 7.0 }),
        &on,
        1.0,
        at,
    );
    assert!((answer(&linear, &on, 1.0, at) / spring - 1.0).abs() < 4.0 * EPS);
    let hertz = answer(&hertz, &on, 1.0, at);
    for law in others {
        assert!((answer(&law, &on, 1.0, at) / hertz - 1.0).abs() < 16.0 * EPS);
    }
}

#[test]
fn the_closing_speed_is_set_once_for_each_contact() {
    let mut speed = ClosingSpeed::<1>::default();
    let start = Flexibility {
        h: Lane([0.0]),
        h_rate: Lane([0.0]),
    };
    let mut step = |at: [f64; 5]| {
        let trial = trial(at);
        let used = speed.of_step(&trial, &Free::new(&trial, &start)).0[0];
        (used, speed.0.0[0])
    };
    // Open: any speed does, since there is no force.
    assert_eq!(step([1.0, -2.0, 0.0, -0.5, -2.0]).1, 0.0);
    // r = 0 after a quarter of the step: between 2 and 6.
    assert_eq!(step([1.0, -2.0, 0.0, -4.0, -6.0]), (3.0, 3.0));
    // It stays until r* >= 0, also where round-off opens the contact for a moment.
    assert_eq!(step([-0.5, -1.0, -1.0, -1.0, 3.0]), (3.0, 3.0));
    assert_eq!(step([1e-18, -1.0, -1.0, -1.0, -1.0]), (3.0, 3.0));
    assert_eq!(step([-0.5, 1.0, -1.0, 0.5, 1.0]).1, 0.0);
    assert_eq!(step([0.0, -4.0, 0.0, -1.0, -5.0]), (4.0, 4.0));
    assert_eq!(step([-0.5, 1.0, -1.0, 1.5, 1.0]).1, 0.0);
    // A run that starts in contact.
    assert_eq!(step([-0.5, -7.0, 0.0, -1.0, -1.0]), (7.0, 7.0));
    assert_eq!(step([-0.5, 1.0, -1.0, 1.5, 1.0]).1, 0.0);
    // In contact without closing: no damping, until it opens.
    assert_eq!(
        step([-0.5, 0.0, 0.0, -1.0, -1.0]),
        (f64::INFINITY, f64::INFINITY)
    );
    assert_eq!(step([-0.5, -3.0, 0.0, -1.0, -1.0]).0, f64::INFINITY);
}

#[test]
fn an_open_contact_has_a_positive_zero() {
    let n = Numbers {
        stiffness: 7.0,
        restitution: 0.5,
        mass: 3.0,
    };
    let rigid = ContactLaw::Rigid(Rigid {
        restitution: 0.5,
        impulses: true,
    });
    for law in laws(&n).into_iter().chain([rigid]) {
        for at in [[1.0, -1.0, 0.0, -0.5, -1.0], [0.0, 1.0, 0.0, 0.0, 1.0]] {
            assert_eq!(answer(&law, &flexibility([0.1, 2.0]), 1.0, at).to_bits(), 0);
        }
    }
}

#[test]
fn the_conservative_force_is_the_slope_of_the_stored_energy() {
    let n = Numbers {
        stiffness: 7.0,
        restitution: 0.5,
        mass: 3.0,
    };
    for (index, law) in laws(&n).iter().enumerate() {
        for r in [-0.9, -0.3, 0.4] {
            // F at rest. Differences of the energy over 1e-5 have the error 1e-10 F''' and round-off 1e-11.
            let s = -equation(index, &n, 1.0, -r, 0.0);
            let slope = (law.stored_energy(r + 1e-5, s) - law.stored_energy(r - 1e-5, s)) / 2e-5;
            assert!((slope - s).abs() < 1e-9, "law {index}");
            assert!(
                (law.conservative_force(r, s) - s).abs() <= 4.0 * EPS * s.abs(),
                "law {index}"
            );
        }
    }
}

#[test]
fn a_dashpot_that_more_than_fills_the_gap_leaves_no_overlap() {
    // k delta + c ddelta at delta = 0 would be 100: the contact ends the step at r = 0.
    let law = ContactLaw::KelvinVoigt(KelvinVoigt {
        stiffness: 1.0,
        damping: 10.0,
    });
    let force = answer(
        &law,
        &flexibility([1.0, 0.01]),
        1.0,
        [1.0, -10.0, 0.0, -1.5, -10.0],
    );
    assert_eq!(force, -0.5);
    // While parting it has no force where the dashpot would pull.
    let force = answer(
        &law,
        &flexibility([1.0, 0.01]),
        1.0,
        [-1.0, 1.0, 0.0, 0.1, 1.0],
    );
    assert_eq!(force, 0.0);
}

#[test]
fn a_rigid_contact_ends_each_step_without_overlap() {
    let law = ContactLaw::Rigid(Rigid {
        restitution: 0.5,
        impulses: true,
    });
    let on = flexibility([0.25, 4.0]);
    // r' = r + change - h (S + S') = 0.
    assert_eq!(answer(&law, &on, 1.0, [0.5, -2.0, -1.0, -2.0, -2.0]), -5.0);
    assert_eq!(answer(&law, &on, 1.0, [0.5, -2.0, 0.0, -0.5, -2.0]), 0.0);
}

#[test]
fn an_impulse_reverses_the_velocity_by_the_restitution() {
    let law = ContactLaw::Rigid(Rigid {
        restitution: 0.5,
        impulses: true,
    });
    let none = Flexibility {
        h: Lane([0.0]),
        h_rate: Lane([0.0]),
    };
    let end = Flexibility {
        h: Lane([0.0]),
        h_rate: Lane([4.0]),
    };
    let on = StepFlexibility {
        start: none,
        end,
        dt: Lane([0.1]),
        by_impulse: true,
    };
    let after = |r: f64, before: f64, rate: f64| {
        let s = answer(&law, &on, 1.0, [r, before, 0.0, 0.1 * rate, rate]);
        (s, rate - 4.0 * s)
    };
    // From -2, pushed to -3: leaves at +1.
    assert_eq!(after(0.1, -2.0, -3.0), (-1.0, 1.0));
    // The same with the predicted gap 0.1 - 0.05 2 = 0 exactly; a little farther it does not touch in this step.
    assert_eq!(after(0.1 + 1e-15, -2.0, -3.0), (0.0, -3.0));
    // At rest on its support it stays at rest.
    assert_eq!(after(0.0, 0.0, -3.0), (-0.75, 0.0));
    // It parts and the predicted gap is open, also if the load turns it.
    assert_eq!(after(0.0, 2.0, -3.0), (0.0, -3.0));
    // It parts from an overlap and the load turns it: the velocity before counts with its sign.
    assert_eq!(after(-0.2, 2.0, -3.0), (-0.5, -1.0));
    // It parts faster than the restitution requires.
    assert_eq!(after(-0.2, -2.0, 1.5), (0.0, 1.5));
}

#[test]
fn roots_need_few_iterations() {
    let mut random = 1_u64;
    let mut uniform = |low: f64, high: f64| {
        random = random
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((random >> 11) as f64 / (1_u64 << 53) as f64)
    };
    // E from resolved contacts to ones within a small part of a step.
    for (name, damped, [low, high], most) in [
        ("undamped", false, [-6.0, 6.0], 5),
        ("damped", true, [-6.0, 6.0], 8),
        ("damped, far beyond any use", true, [-30.0, 30.0], 9),
    ] {
        let (mut sum, mut largest) = (0, 0);
        for _ in 0..20_000 {
            let mut number = || Lane([libm::pow(10.0, uniform(low, high))]);
            let (e, c) = (number(), if damped { number() } else { Lane([0.0]) });
            let count = std::cell::Cell::new(0);
            let counted = |w| {
                count.set(count.get() + 1);
                hertz::step(w, e, c)
            };
            newton::newton(hertz::bound(e, c), hertz::LAST, counted);
            sum += count.get();
            largest = largest.max(count.get());
        }
        println!("{name}: mean {}, largest {largest}", f64::from(sum) / 2e4);
        assert!(largest <= most, "{name}: {largest}");
    }
    for (high, most) in [(3.0, 12), (30.0, 16)] {
        let (mut sum, mut largest) = (0, 0);
        for _ in 0..20_000 {
            let mut number = || Lane([libm::pow(10.0, uniform(-high, high))]);
            let [e, d, g] = [number(), number(), number()];
            let count = std::cell::Cell::new(0);
            let counted = |s| {
                count.set(count.get() + 1);
                jankowski::step(s, e, d, g)
            };
            let start = jankowski::start(e, d, g);
            let first = start - counted(start);
            newton::newton(first, jankowski::LAST, |s| jankowski::rising(counted(s)));
            sum += count.get();
            largest = largest.max(count.get());
        }
        println!(
            "jankowski: mean {}, largest {largest}",
            f64::from(sum) / 2e4
        );
        assert!(largest <= most, "jankowski: {largest}");
    }
}
