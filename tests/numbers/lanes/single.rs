//! Cases in lanes have the same bits as single cases, for every number of lanes.

use slipgap::contact::{
    ContactResponse, DisplacementControl, ImpactSpring, RunningLaw, VelocityControl,
};
use slipgap::lane::Lane;
use slipgap::methods::{
    AverageAcceleration, ContactState, ManyModes, ModeStart, OneMode, Recursion, Scheme, Start,
};
use slipgap::system::Mode;
use slipgap::system::bar::{Bar, Mass};
use std::array;

/// dt, compliance of the law, x0 of eight different cases.
const CASES: [[f64; 3]; 8] = [
    [0.1, 1.0, 12.0],
    [0.31, 0.1, -12.5],
    [0.05, 5.0, 3.3],
    [1.1, 0.3, 40.0],
    [0.0123, 0.01, -0.7],
    [0.7, 2.0, 11.2],
    [0.2, 0.5, 1e-3],
    [0.33, 0.05, -100.0],
];

const STEPS: usize = 500;

/// The method with this storage of modes.
type Lanes<const L: usize, N> = <AverageAcceleration as Scheme>::Lanes<L, N>;

/// The bits of r, rdot and S over the steps, one list a lane.
fn bits<const L: usize>(
    mut stepper: impl Recursion<L>,
    mut law: impl ContactResponse<L>,
) -> [Vec<[u64; 3]>; L] {
    let mut lists = array::from_fn(|_| Vec::new());
    for _ in 0..STEPS {
        let ContactState {
            displacement,
            velocity,
            force,
        } = stepper.step(&mut law);
        for (l, list) in lists.iter_mut().enumerate() {
            list.push([displacement, velocity, force].map(|lane| lane.0[l].to_bits()));
        }
    }
    lists
}

/// One number of L cases from the `first` on.
fn lane<const L: usize>(first: usize, which: usize) -> Lane<L> {
    Lane(array::from_fn(|l| CASES[(first + l) % 8][which]))
}

/// The compliances of L cases from the `first` on.
fn numbers<const L: usize>(first: usize) -> [f64; L] {
    lane::<L>(first, 1).0
}

fn at<const L: usize>(dt: Lane<L>, gap: Lane<L>) -> Start<L> {
    Start {
        method: [AverageAcceleration.into(); L],
        dt,
        gap,
        force: Lane::splat(0.0),
    }
}

fn oscillators<const L: usize>(first: usize) -> Lanes<L, OneMode> {
    let unit = Mode::new(1.0, 1.0);
    let start = ModeStart {
        mode: [unit; L],
        displacement: lane(first, 2),
        velocity: Lane::splat(0.0),
    };
    let at = at(lane(first, 0), Lane::splat(0.0));
    Lanes::<L, OneMode>::new(&at, [start].into_iter()).unwrap()
}

fn displacement<const L: usize>(first: usize) -> [Vec<[u64; 3]>; L] {
    let stepper = oscillators(first);
    let laws = numbers(first).map(|compliance| DisplacementControl {
        compliance,
        limit: 1.0,
    });
    let law = RunningLaw::of(&laws, &stepper.flexibilities());
    bits(stepper, law)
}

fn velocity<const L: usize>(first: usize) -> [Vec<[u64; 3]>; L] {
    let stepper = oscillators(first);
    let laws = numbers(first).map(|compliance| VelocityControl {
        compliance,
        limit: 1.0,
    });
    let law = RunningLaw::of(&laws, &stepper.flexibilities());
    bits(stepper, law)
}

/// A bar of six elements against a wall, its mass, travel time and gap the case's own.
fn impact<const L: usize>(first: usize) -> [Vec<[u64; 3]>; L] {
    let bars: [Bar; L] = array::from_fn(|l| Bar {
        elements: 6,
        mass: 0.3 + CASES[(first + l) % 8][1],
        travel_time: 1.0 + CASES[(first + l) % 8][0],
        kind: Mass::Lumped,
    });
    let modes: [Vec<Mode>; L] = array::from_fn(|l| bars[l].modes().collect());
    let start = (0..=6).map(|j| ModeStart {
        mode: array::from_fn(|l| modes[l][j]),
        displacement: Lane::splat(0.0),
        velocity: Lane::splat(if j == 0 { -2.0 } else { 0.0 }),
    });
    let (dt, gap) = (lane(first, 0) * 0.02, lane(first, 0) * 0.07);
    let stepper = Lanes::<L, ManyModes>::new(&at(dt, gap), start).unwrap();
    let laws = numbers(first).map(|compliance| ImpactSpring {
        stiffness: 1.0 / compliance,
    });
    let law = RunningLaw::of(&laws, &stepper.flexibilities());
    bits(stepper, law)
}

#[test]
fn lanes_are_independent() {
    for (one, four, many) in [
        (
            displacement::<1> as fn(usize) -> [Vec<[u64; 3]>; 1],
            displacement::<4> as fn(usize) -> [Vec<[u64; 3]>; 4],
            displacement::<32>(0),
        ),
        (velocity::<1>, velocity::<4>, velocity::<32>(0)),
        (impact::<1>, impact::<4>, impact::<32>(0)),
    ] {
        let fours: Vec<_> = four(0).into_iter().chain(four(4)).collect();
        for (i, alone) in (0..8).flat_map(one).enumerate() {
            assert!(alone == fours[i], "case {i} of four");
            for together in many.iter().skip(i).step_by(8) {
                assert!(alone == *together, "case {i} of many");
            }
            // Without motion equal bits would prove nothing.
            assert!(
                alone.iter().any(|row| row[2] << 1 != 0),
                "case {i}: no force"
            );
        }
    }
}
