//! Tests over all laws: what each descriptor says agrees with what the law does.

mod properties;
mod stiffness;

use slipgap_contact::contact::number::{Number, Range, Usual};
use slipgap_contact::contact::numbers::structure;
use slipgap_contact::contact::offer::{Offered, Place};
use slipgap_contact::contact::{
    AnyRunningLaw, ClippedLine, ContactKind, ContactLaw, ContactResponse, Flexibility,
    GivenNumbers, LAWS, StepFlexibility, StoredEnergy, Trial,
};
use slipgap_contact::lane::Lane;
use slipgap_system::system::structure::{Limit, StructureLaw};

/// A value of a number that no law treats specially.
fn sample(number: &Number) -> f64 {
    // A part that fails has a force that jumps.
    if ["Uu", "lambda"]
        .iter()
        .any(|key| number.key.starts_with(key))
    {
        return 1e3;
    }
    match number.range {
        Range::Positive | Range::NotZero | Range::Any => 1.5,
        Range::NotNegative => 0.5,
        Range::Fraction | Range::UpToOne | Range::FromHalfToOne | Range::AtLeastHalf => 0.6,
        Range::AtLeastOne => 2.0,
        Range::ZeroOrOne => 1.0,
        Range::FromTenthToTwo => 0.4,
        Range::AtMostOne => 0.1,
        Range::HilberHughesTaylor => -0.1,
    }
}

/// The law with these numbers in structures, with the friction limit 2.
fn made(law: &Offered) -> Option<ContactLaw> {
    made_with(law, sample)
}

/// The law with these values of its numbers in structures, with the friction limit 2.
fn made_with(law: &Offered, value: impl Fn(&Number) -> f64) -> Option<ContactLaw> {
    let in_structure = law.offer.structure?;
    // A study gives one of two numbers that take each other's place.
    let given = |number: &&Number| {
        let first = number.instead_of.is_none_or(|other| !law.has(other));
        first.then(|| value(number))
    };
    let values: Vec<Option<f64>> = in_structure.numbers.iter().map(given).collect();
    let given = GivenNumbers {
        law: law.offer.name,
        numbers: in_structure.numbers,
        values: &values,
        table: &[[0.5, 1.0], [1.5, 2.0], [4.0, 2.5]],
        others: &[("limit", 2.0), ("nu", 2.0)],
    };
    let form = (law.offer.form)(&given).unwrap_or_else(|why| panic!("{}: {why}", law.offer.name));
    let relation = StructureLaw::new(form, Limit::constant(2.0));
    assert_eq!(relation.kind(), law.kind, "{}", law.offer.name);
    Some(relation.law(2.0))
}

/// Whether r >= 0 holds without compliance.
fn is_rigid(law: &ContactLaw) -> bool {
    matches!(law.line(), Some(ClippedLine::Stop { .. }))
}

/// Every law by its names, with numbers; a law that is a form of another one by the numbers that make it so.
fn laws() -> Vec<(&'static Offered, ContactLaw)> {
    LAWS.iter()
        .filter_map(|law| Some((law, made(law)?)))
        .collect()
}

#[test]
fn every_law_has_names_numbers_units_and_meanings() {
    assert!(LAWS.len() >= 17);
    for law in &LAWS {
        let name = law.offer.name;
        let plain = |c: char| c.is_ascii_lowercase() || c == '-';
        assert!(!name.is_empty() && name.chars().all(plain), "{name}");
        let places = [Place::Oscillator, Place::Bars, Place::Structure];
        let offers: Vec<_> = places.iter().filter_map(|place| law.at(*place)).collect();
        assert!(!offers.is_empty(), "{name} is offered nowhere");
        for offer in offers {
            assert!(offer.meaning.len() > 10, "{name}");
            assert!(offer.numbers.len() <= 25, "{name}");
            for number in offer.numbers {
                let Number {
                    key,
                    symbol,
                    unit,
                    range,
                    ..
                } = number;
                assert!(
                    !key.is_empty() && !symbol.is_empty() && !unit.is_empty(),
                    "{name} {key}"
                );
                assert!(number.meaning.len() > 5, "{name} {key}");
                assert!(range.contains(sample(number)), "{name} {key}");
                if let Usual::Is(usual) = number.usual {
                    assert!(range.contains(usual), "{name} {key}");
                }
            }
        }
        let twice = LAWS.iter().filter(|other| other.offer.name == name);
        assert_eq!(twice.count(), 1, "{name}");
        for place in places {
            let found = Offered::named(place, name).map(|found| found.offer.name);
            assert_eq!(found, law.at(place).map(|_| name));
        }
    }
    for number in structure::TABLE {
        assert!(LAWS.iter().any(|law| law.has(number.key)), "{}", number.key);
    }
}

#[test]
fn the_name_in_text_is_a_name_of_studies() {
    for (law, made) in laws() {
        assert_eq!(made.kind(), law.kind);
        assert!(
            LAWS.iter().any(|law| law.offer.name == made.name()),
            "{made:?}"
        );
        let shown = made.properties().shown();
        assert!(
            !shown.is_empty() && shown.iter().all(|pair| !pair.0.is_empty()),
            "{made:?}"
        );
    }
}

#[test]
fn friction_has_the_bounds_of_its_limit() {
    for (_, law) in laws() {
        let [low, high] = law.properties().bounds();
        let other = law.at_limit(1.0).properties().bounds();
        // Half the limit 2: exact in floating point.
        match law.kind() {
            ContactKind::Friction => assert_eq!(other, [0.5 * low, 0.5 * high], "{law:?}"),
            ContactKind::Impact | ContactKind::Link => assert_eq!(other, [low, high]),
        }
    }
}

/// S of a law after each of many steps of a motion that is given: r, rdot and S.
fn follow(
    law: &ContactLaw,
    motion: impl Fn(f64) -> [f64; 2],
    end: f64,
    steps: u32,
) -> Vec<[f64; 3]> {
    let mut states = Vec::new();
    watch(law, motion, end, steps, |_, state| states.push(state));
    states
}

/// The same; `see` has the law with its memory and r, rdot and S after each step.
fn watch(
    law: &ContactLaw,
    motion: impl Fn(f64) -> [f64; 2],
    end: f64,
    steps: u32,
    mut see: impl FnMut(&AnyRunningLaw<1>, [f64; 3]),
) {
    // Without compliance a motion that is given leaves S open: the end yields a little.
    let open = law.of_velocity() && law.properties().shown()[0].1 == f64::INFINITY;
    let flexibility = |h_rate: f64| Flexibility {
        h: Lane([0.0]),
        h_rate: Lane([h_rate]),
    };
    let (none, end_of_step) = (flexibility(0.0), flexibility(if open { 1e-9 } else { 0.0 }));
    let dt = end / f64::from(steps);
    let on = StepFlexibility {
        start: none,
        end: end_of_step,
        dt: Lane([dt]),
        by_impulse: false,
    };
    let mut running = ContactLaw::running(&[*law], &[on; 2]);
    let mut s = 0.0;
    for k in 1..=steps {
        let [before, now] = [k - 1, k].map(|k| motion(f64::from(k) * dt));
        let trial = Trial {
            displacement: Lane([before[0]]),
            velocity: Lane([before[1]]),
            force: Lane([s]),
            change: Lane([now[0] - before[0]]),
            rate: Lane([now[1]]),
        };
        Lane([s]) = running.force(0, &trial);
        see(&running, [now[0], now[1], s]);
    }
}

#[test]
fn friction_and_links_answer_as_their_closed_form() {
    for (law, made) in laws() {
        if law.kind == ContactKind::Impact {
            continue;
        }
        for velocity in [0.02, 0.7, 5.0] {
            for time in [0.1, 1.0, 8.0] {
                let expected = made.driven(velocity, time).expect("a closed form");
                // dz/dt of bristles is that of a parabola: of second order.
                let error = [1000, 4000].map(|steps| {
                    let motion = |t: f64| [velocity * t, velocity];
                    let states = follow(&made, motion, time, steps);
                    let [_, _, s] = states[states.len() - 1];
                    // Where a part is slack there is no force at all.
                    (s - expected).abs() / if expected > 0.0 { expected } else { 1e-300 }
                });
                // Round-off of 4000 steps where the law has the exact flow.
                let exact = error[1] < 1e-11;
                assert!(
                    exact || error[1] < 0.1 * error[0] && error[1] < 1e-4,
                    "{made:?} {velocity} {time} {error:?}"
                );
                let [low, high] = made.properties().bounds();
                let slack = low == 0.0 && expected == 0.0;
                assert!(expected > 0.0 || slack, "{made:?}");
                // The other direction, in which a part that only pulls has no force.
                let back = follow(&made, |t: f64| [-velocity * t, -velocity], time, 1000);
                let there = follow(&made, |t: f64| [velocity * t, velocity], time, 1000);
                let other = if low == -high { -there[999][2] } else { low };
                assert_eq!(back[999][2], other, "{made:?}");
            }
        }
    }
}

/// Restitution, largest overlap and duration of a collision of two rigid masses.
struct Collided {
    restitution: f64,
    overlap: f64,
    duration: f64,
}

/// The collision in closed form, of a law without one by steps.
fn collided(law: &ContactLaw, mass: f64, speed: f64) -> Collided {
    let Some(known) = law.collision(mass, speed) else {
        return by_steps(law, mass, speed);
    };
    Collided {
        restitution: known.restitution,
        overlap: known.overlap,
        duration: known.duration(),
    }
}

/// The collision by average acceleration, m r'' + S = 0, with so small steps that they err by less than 1e-6 of it.
fn by_steps(law: &ContactLaw, mass: f64, speed: f64) -> Collided {
    // A first guess of the duration: that of the spring of the law for the overlap of its energy.
    let stored = |overlap: f64| {
        let force = follow(law, |_| [-overlap, 0.0], 1.0, 1)[0][2];
        law.stored_energy(-overlap, force)
    };
    let energy = 0.5 * mass * speed * speed;
    let depths = (-60..60).map(|i| libm::exp2(f64::from(i) * 0.5));
    let overlap = depths.into_iter().find(|depth| stored(*depth) > energy);
    let dt = overlap.expect("an overlap that stores the energy") / speed / 20_000.0;
    let half = Flexibility {
        h: Lane([0.25 * dt * dt / mass]),
        h_rate: Lane([0.5 * dt / mass]),
    };
    let on = StepFlexibility {
        start: half,
        end: half,
        dt: Lane([dt]),
        by_impulse: false,
    };
    let mut running = ContactLaw::running(&[*law], &[on; 2]);
    let ([mut r, mut v, mut s], mut deepest, mut steps) = ([0.0, -speed, 0.0], 0.0_f64, 0);
    loop {
        let trial = Trial {
            displacement: Lane([r]),
            velocity: Lane([v]),
            force: Lane([s]),
            change: Lane([v * dt]),
            rate: Lane([v]),
        };
        let Lane([next]) = running.force(0, &trial);
        r += v * dt - 0.25 * dt * dt / mass * (s + next);
        v -= 0.5 * dt / mass * (s + next);
        (s, deepest, steps) = (next, deepest.max(-r), steps + 1);
        if s == 0.0 && v > 0.0 {
            break;
        }
        assert!(steps < 10_000_000, "{law:?} does not part");
    }
    Collided {
        restitution: v / speed,
        overlap: deepest,
        duration: f64::from(steps) * dt,
    }
}

/// What a law without a closed form is tested by agrees with the closed forms of the others.
#[test]
fn collisions_by_steps_are_those_in_closed_form() {
    for (law, made) in laws() {
        if law.kind != ContactKind::Impact || is_rigid(&made) {
            continue;
        }
        let (known, found) = (collided(&made, 0.7, 1.3), by_steps(&made, 0.7, 1.3));
        let errors = [
            known.restitution - found.restitution,
            known.overlap / found.overlap - 1.0,
            known.duration / found.duration - 1.0,
        ];
        // A force that jumps at the first touch, as of a dashpot, is met within a step; the end is that of a step.
        assert!(
            errors.iter().all(|error| error.abs() < 3e-4),
            "{made:?} {errors:?}"
        );
    }
}

#[test]
fn impacts_push_as_their_stored_energy_and_never_pull() {
    for (law, made) in laws()
        .iter()
        .filter(|law| law.0.kind == ContactKind::Impact)
    {
        let collision = collided(made, 0.7, 1.3);
        let restitution = collision.restitution;
        assert!((0.0..=1.0).contains(&restitution), "{made:?} {restitution}");
        if is_rigid(made) {
            assert_eq!([collision.duration, collision.overlap], [0.0; 2]);
            continue;
        }
        assert!(
            collision.duration > 0.0 && collision.overlap > 0.0,
            "{}",
            law.offer.name
        );
        for (part, overlap) in [0.2, 0.5, 1.0].map(|part| (part, part * collision.overlap)) {
            // The slope of the stored energy is the force that stores it: S itself where S stores.
            let force = |r: f64| {
                let motion = |_: f64| [r, 0.0];
                follow(made, motion, 1.0, 1)[0][2]
            };
            let width = 1e-5 * overlap;
            let [low, high] =
                [-overlap - width, -overlap + width].map(|r| made.stored_energy(r, force(r)));
            let slope = (high - low) / (2.0 * width);
            let expected = made.conservative_force(-overlap, force(-overlap));
            // Central differences of a smooth function, of the second order.
            assert!(
                (slope / expected - 1.0).abs() < 1e-8,
                "{made:?} {part} {slope} {expected}"
            );
            assert!(expected < 0.0 && made.stored_energy(-overlap, force(-overlap)) > 0.0);
        }
        assert_eq!(made.stored_energy(0.1, 0.0), 0.0);
        // In and out again, with and without damping.
        let out = follow(
            made,
            |t: f64| {
                let x = 0.3 * libm::sin(t);
                [0.1 - x, -0.3 * libm::cos(t)]
            },
            6.0,
            3000,
        );
        assert!(
            out.iter()
                .all(|[r, _, s]| *s <= 0.0 && (*r < 0.0 || *s == 0.0)),
            "{made:?}"
        );
    }
}

/// Steps in which an impact stays open leave out its law.
#[test]
fn an_impact_that_stays_open_remembers_what_it_did() {
    let impacts = laws()
        .into_iter()
        .filter(|law| law.0.kind == ContactKind::Impact);
    for (_, made) in impacts {
        // Open, deep contact and open again, twice.
        let motion = |t: f64| [0.1 - 0.9 * libm::sin(t), -0.9 * libm::cos(t)];
        let (mut before, mut open) = (None, 0);
        watch(&made, motion, 12.0, 3000, |running, [r, _, s]| {
            let is_open = r > 0.0 && s == 0.0;
            let remembers = is_open.then(|| format!("{running:?}"));
            if before.is_some() && is_open {
                open += 1;
                assert_eq!(before, remembers, "{made:?}");
            }
            before = remembers.clone();
        });
        assert!(open > 1000, "{made:?} {open}");
    }
}

#[test]
fn no_law_gives_energy_and_bounds_hold() {
    for (_, made) in laws() {
        let [low, high] = made.properties().bounds();
        // Two cycles about a moving centre.
        let motion = |t: f64| [0.4 * libm::sin(t) + 0.02 * t, 0.4 * libm::cos(t) + 0.02];
        let states = follow(&made, motion, 12.0, 24_000);
        let (mut work, mut least) = (0.0, 0.0_f64);
        let mut before = [0.0, 0.42, 0.0];
        for state in states {
            let [r, _, s] = state;
            assert!(low <= s && s <= high, "{made:?}");
            work += 0.5 * (before[2] + s) * (r - before[0]);
            least = least.min(work - made.stored_energy(r, s));
            before = state;
        }
        // Sums of trapezoids of second order, and jumps of the force within a step.
        assert!(least > -2e-3, "{made:?} {least}");
    }
}

#[test]
fn a_friction_law_has_the_limit_that_it_is_given() {
    for (law, made) in laws() {
        let other = made.at_limit(0.5);
        if law.kind != ContactKind::Friction {
            assert_eq!(other, made);
            continue;
        }
        let last = |law: &ContactLaw| {
            let states = follow(law, |t: f64| [5e4 * t, 5e4], 10.0, 2000);
            states[1999][2]
        };
        // Without the viscosity of a law that has one.
        let mut viscous = 0.0;
        if let ContactLaw::Lugre(law) = made {
            viscous = 5e4 * law.sigma2;
        }
        let ratio = (last(&other) - viscous) / (last(&made) - viscous);
        // With the exponent 2 Dahl's force is 1/(1 + z) below its limit, z > 3e5.
        assert!((ratio - 0.25).abs() < 1e-5, "{made:?} {ratio}");
        assert_eq!(other.at_limit(2.0), made);
    }
}

#[test]
fn curves_show_the_law_within_its_bounds() {
    for (_, made) in laws() {
        let properties = made.properties();
        let reach = properties.reach();
        assert!(reach > 0.0 && reach.is_finite(), "{made:?}");
        let (points, marked) = made.cycle(reach);
        let [low, high] = properties.bounds();
        assert!(points.len() > 2 && marked.iter().all(|at| *at < points.len()));
        for [x, s] in &points {
            assert!(x.is_finite() && s.is_finite(), "{made:?}");
            assert!((low..=high).contains(s), "{made:?} {x} {s}");
        }
        // Elastic at rest, as the curve of the law shows: its first step from rest.
        let stiffness = properties.initial_stiffness(0.0);
        if made.kind() == ContactKind::Friction && stiffness > 0.0 {
            let small = 1e-7;
            let states = follow(&made, |t: f64| [small * t, small], 1.0, 1);
            let mut damping = 0.0;
            if let ContactLaw::Lugre(law) = made {
                damping = (law.sigma1 + law.sigma2) * small;
            }
            let slope = (states[0][2] - damping) / small;
            assert!((slope / stiffness - 1.0).abs() < 1e-6, "{made:?} {slope}");
        }
    }
}
