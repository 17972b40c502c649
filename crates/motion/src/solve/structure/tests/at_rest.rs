//! Forces of contacts of bodies that are exactly at rest: every number of such a contact is 0 until another contact moves it.

use super::*;
use crate::contact::offer::Form;
use crate::contact::{
    Bearing, BoucWen, ClippedLine, ContactLaw, Dahl, Decay, Hertz, HertzDamp, HuntCrossley,
    Jankowski, KelvinVoigt, Lugre, Stribeck, Tanh, Unsolved, Ye,
};
use crate::methods::{AverageAcceleration, Bathe, Coefficients, Method, MoreauJean};
use crate::solve::Unsolvable;
use crate::solve::structure::{Prepared, run};

/// SplitMix64.
pub(super) struct Random(pub(super) u64);

impl Random {
    /// Between 0 and 1.
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(super) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Evenly in its logarithm.
    pub(super) fn scale(&mut self, low: f64, high: f64) -> f64 {
        low * libm::pow(high / low, self.unit())
    }

    fn below(&mut self, end: usize) -> usize {
        (self.unit() * end as f64) as usize
    }
}

pub(super) const LAWS: usize = 17;

/// The law with this number, and the gap of the contact.
pub(super) fn law(number: usize, random: &mut Random) -> (StructureLaw, f64) {
    let (k, e, mass) = (random.scale(1e2, 1e5), random.between(0.2, 1.0), 1.5);
    let gap = random.between(0.0, 0.01) * [0.0, 1.0][random.below(2)];
    let impact = |law: ContactLaw| {
        StructureLaw::new(Form::of(law).with_restitution(e), None).from_its_answer()
    };
    let relation = match number {
        0 => StructureLaw::new(ClippedLine::Spring { stiffness: k }, None),
        1 => StructureLaw::new(ClippedLine::Stop { restitution: e }, None),
        2 => impact(ContactLaw::KelvinVoigt(KelvinVoigt::new(k, e, mass))),
        3 => impact(ContactLaw::Hertz(Hertz { stiffness: k })),
        4 => impact(ContactLaw::HertzDamp(HertzDamp::new(k, e))),
        5 => impact(ContactLaw::Jankowski(Jankowski::new(k, e, mass))),
        6 => impact(ContactLaw::HuntCrossley(HuntCrossley::new(k, e))),
        7 => impact(ContactLaw::Ye(Ye::new(k, e))),
        _ => return (friction(number, random), 0.0),
    };
    (relation, gap)
}

/// A law of friction with a limit that is constant, or changes, or is 0 for some time.
fn friction(number: usize, random: &mut Random) -> StructureLaw {
    let constant = random.between(0.5, 6.0);
    let varying = match random.below(3) {
        0 => None,
        _ => {
            let values = vec![random.between(-4.0, 2.0), 3.0, random.between(-4.0, 2.0)];
            let table = Table::new(vec![0.0, 0.05, 0.1], values).unwrap();
            Some((1.0, Arc::new(Signal::Table(table))))
        }
    };
    let given_limit = Limit {
        constant,
        varying,
        ..Limit::constant(0.0)
    };
    let limit = constant;
    let (k, c) = (random.scale(1e2, 1e5), random.scale(1e1, 1e4));
    let exponent = [1.0, 1.5, 2.0, 3.0][random.below(4)];
    let (ratio, rate) = (random.between(0.3, 1.0), random.between(0.0, 5.0));
    let compliance = 1.0 / k;
    let law = match number {
        8 => {
            return StructureLaw::new(ClippedLine::Elastic { stiffness: k }, given_limit);
        }
        9 => {
            return StructureLaw::new(ClippedLine::Viscous { viscosity: c }, given_limit);
        }
        10 => return StructureLaw::new(ClippedLine::Coulomb, given_limit),
        11 => ContactLaw::Tanh(Tanh {
            compliance: 1.0 / c,
            limit,
            ratio,
            rate,
        }),
        12 => ContactLaw::Bearing(Bearing {
            compliance: 1.0 / c,
            limit,
            ratio,
            rate,
        }),
        13 => ContactLaw::Stribeck(Stribeck {
            compliance: 1.0 / c,
            limit,
            static_limit: 1.2 * limit,
            stribeck_velocity: random.between(0.3, 1.0),
            decay: Decay::Exponential,
        }),
        14 => ContactLaw::BoucWen(BoucWen {
            compliance,
            limit,
            exponent,
            beta: 0.5,
        }),
        15 => ContactLaw::Dahl(Dahl {
            compliance,
            limit,
            exponent,
        }),
        _ => ContactLaw::Lugre(Lugre {
            sigma0: k,
            sigma1: random.between(0.0, 0.3) * k.sqrt(),
            sigma2: random.between(0.0, 0.5),
            limit,
            static_limit: limit,
            stribeck_velocity: 0.5,
        }),
    };
    StructureLaw::new(law, given_limit).from_its_answer()
}

fn method(number: usize) -> Method {
    let family = Method::Family;
    match number {
        0 => Method::AverageAcceleration(AverageAcceleration),
        1 => family(Coefficients::linear_acceleration()),
        2 => family(Coefficients::newmark(0.3025, 0.6)),
        3 => family(Coefficients::hht(-0.2)),
        4 => family(Coefficients::generalized_alpha(0.7)),
        5 => Method::Bathe(Bathe),
        6 => Method::MoreauJean(MoreauJean { theta: 0.5 }),
        7 => Method::MoreauJean(MoreauJean { theta: 0.8 }),
        _ => family(Coefficients::central_difference()),
    }
}

const METHODS: usize = 9;

/// A few masses, two or three contacts of which the first two have the laws of this number, and one body that moves at the start
/// or by a load. The others are at rest.
fn structure(number: usize, random: &mut Random) -> Structure {
    let n = 2 + random.below(3);
    let node_masses: Vec<f64> = (0..n).map(|_| random.scale(0.1, 10.0)).collect();
    let mut structure = masses(&node_masses);
    let node = |i: usize| (i < n).then_some(i);
    for i in 0..n {
        if random.below(4) == 0 {
            let between = [Some(i), node(i + 1)];
            let k = random.scale(1.0, 1e3);
            structure.stiffness.add_spring(between, k);
            structure.damping.add_spring(between, 1e-3 * k);
        }
    }
    let first = random.below(n);
    if random.below(2) == 0 {
        structure.velocity[first] = random.between(-1.0, 1.0);
    } else {
        structure.loads = vec![Load {
            pattern: vec![(first, random.between(-20.0, 20.0))],
            signal: Arc::new(Signal::Sine {
                amplitude: 1.0,
                omega: random.between(1.0, 30.0),
                phase: 0.3,
            }),
        }];
    }
    for c in 0..2 + random.below(2) {
        let which = match c {
            0 => number % LAWS,
            1 => number / LAWS % LAWS,
            _ => random.below(LAWS),
        };
        let (law, gap) = law(which, random);
        // The ground is the last.
        let from = random.below(n + 1);
        let to = (from + 1 + random.below(n)) % (n + 1);
        structure
            .contacts
            .push(contact([node(from), node(to)], gap, law));
    }
    structure
}

/// Whether two contacts without compliance may depend on each other.
fn may_be_singular(structure: &Structure) -> bool {
    let rigid = structure
        .contacts
        .iter()
        .filter(|contact| contact.law.line().is_some_and(ClippedLine::is_rigid));
    rigid.count() > 1
}

/// Runs structures; returns how many were solved, how many have laws that the method or the step does not allow, and in how many
/// rigid contacts depend on each other.
fn solve(seed: u64, structures: usize) -> [usize; 3] {
    let mut random = Random(seed);
    let [mut solved, mut refused, mut singular] = [0; 3];
    for number in 0..structures {
        let structure = structure(number, &mut random);
        let method = method(number / (LAWS * LAWS) % METHODS);
        let dt = random.scale(1e-4, 5e-3);
        let Ok(prepared) = Prepared::by(&method, &structure, dt) else {
            refused += 1;
            continue;
        };
        let [done] = run::<1>(&[&structure], &prepared, 60, |_, _| ());
        match done {
            Ok(()) => solved += 1,
            // A law or a step that the method refuses.
            Err(Unsolvable::BrokenRules(_)) => refused += 1,
            Err(Unsolvable::NoForces {
                why: Unsolved::Singular,
                ..
            }) if may_be_singular(&structure) => singular += 1,
            Err(why) => panic!("{number}: {why} {method:?} {dt} {structure:?}"),
        }
    }
    [solved, refused, singular]
}

#[test]
fn bodies_at_rest_have_forces_with_every_pair_of_laws() {
    // Each pair with each method. Central difference has no curved laws, and moreau-jean not beside rigid ones.
    let [solved, refused, singular] = solve(1, METHODS * LAWS * LAWS);
    assert!(solved > 2000, "{solved} {refused} {singular}");
}

/// `cargo test --lib two_hundred_thousand -- --ignored`, some minutes.
#[test]
#[ignore = "takes minutes"]
fn two_hundred_thousand_structures_with_bodies_at_rest_have_forces() {
    let [solved, refused, singular] = solve(2, 200_000);
    println!("{solved} solved, {refused} refused, {singular} not unique");
    assert!(solved > 160_000, "{solved} {refused} {singular}");
}
