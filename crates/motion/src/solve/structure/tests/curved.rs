//! Laws that are not clipped lines.

use super::*;
use crate::contact::impact::collision::{DampedHertz, HertzDashpot, Linear as Dashpot};
use crate::contact::{
    Bearing, Bilinear, BoucWen, ClippedLine, ContactKind, ContactLaw, Dahl, Decay, Hertz,
    HertzDamp, HuntCrossley, ImpactSpring, Jankowski, KelvinVoigt, Lugre, Stribeck, Tanh, Unsolved,
    VelocityControl, Ye,
};
use crate::lane::Lane;
use crate::methods::{AverageAcceleration, Method};
use crate::solve::structure::{Books, Prepared, run};
use crate::solve::{ContactTrack, Unsolvable, run as run_modes};
use crate::system::{Linear, Mode, System};

fn friction(law: ContactLaw, limit: f64) -> StructureLaw {
    StructureLaw::new(law, Limit::constant(limit)).from_its_answer()
}

fn impact(law: ContactLaw) -> StructureLaw {
    StructureLaw::new(law, None).from_its_answer()
}

/// Every law of friction with a limit of 1.
fn frictions() -> Vec<ContactLaw> {
    let (compliance, limit) = (0.02, 1.0);
    vec![
        ContactLaw::Tanh(Tanh {
            compliance,
            limit,
            ratio: 0.6,
            rate: 2.0,
        }),
        ContactLaw::Bearing(Bearing {
            compliance,
            limit,
            ratio: 0.5,
            rate: 1.0,
        }),
        ContactLaw::Stribeck(Stribeck {
            compliance,
            limit,
            static_limit: 1.3,
            stribeck_velocity: 0.5,
            decay: Decay::Exponential,
        }),
        ContactLaw::BoucWen(BoucWen {
            compliance,
            limit,
            exponent: 2.0,
            beta: 0.5,
        }),
        ContactLaw::Dahl(Dahl {
            compliance,
            limit,
            exponent: 1.0,
        }),
        ContactLaw::Lugre(Lugre {
            sigma0: 50.0,
            sigma1: 0.2,
            sigma2: 0.05,
            limit,
            static_limit: 1.3,
            stribeck_velocity: 0.5,
        }),
    ]
}

/// r, rdot and S of all contacts at all steps, and the energy error.
fn motion(structure: &Structure, dt: f64, steps: usize) -> (Vec<Vec<[f64; 3]>>, f64) {
    let prepared = Prepared::new(structure, dt).unwrap();
    let mut books: Option<Books<1>> = None;
    let mut rows = Vec::new();
    let [done] = run::<1>(&[structure], &prepared, steps, |_, state| {
        let contact = |c: usize| {
            let now = state.contact(c);
            [now.displacement, now.velocity, now.force].map(|x| x.0[0])
        };
        rows.push((0..state.contacts()).map(contact).collect());
        match &mut books {
            Some(books) => books.add(state),
            None => books = Some(Books::new(state)),
        }
    });
    done.unwrap();
    (rows, books.unwrap().energy_error().0[0])
}

#[test]
fn a_mass_with_each_friction_law_moves_like_the_oscillator() {
    for law in frictions() {
        let mut structure = masses(&[1.0]);
        structure.stiffness.add(0, 0, 1.0);
        structure.displacement[0] = 12.0;
        structure.contacts = vec![contact([None, Some(0)], 0.0, friction(law, 1.0))];
        let (dt, last) = (0.02, 3000);
        let system = System {
            linear: Linear::Oscillator {
                mode: Mode::new(1.0, 1.0),
                displacement: 12.0,
            },
            law,
            gap: 0.0,
            force: 0.0,
            step: dt,
            last,
            method: Method::AverageAcceleration(AverageAcceleration),
        };
        let expected = run_modes::<ContactTrack>(&system).unwrap().track.0;
        let (rows, error) = motion(&structure, dt, last as usize);
        assert_eq!(rows.len(), expected.len());
        for (i, (row, expected)) in rows.iter().zip(&expected).enumerate() {
            for k in 0..3 {
                // Sums of 3000 steps of a motion of 12.
                let difference = (row[0][k] - expected[k]).abs();
                assert!(difference < 1e-9, "{law:?} {i} {k} {row:?} {expected:?}");
            }
        }
        assert!(error < 1e-12, "{law:?} {error}");
    }
}

/// The greatest overlap and the speed of parting over that of closing of two free masses that collide.
fn collide(law: ContactLaw, v0: f64, dt: f64) -> [f64; 2] {
    let mut structure = masses(&[1.0, 3.0]);
    structure.velocity = vec![0.75 * v0, -0.25 * v0];
    structure.contacts = vec![contact([Some(0), Some(1)], 0.013 * v0, impact(law))];
    let (rows, error) = motion(&structure, dt, (6.0 / dt) as usize);
    assert!(error < 1e-12, "{law:?} {error}");
    let overlap = rows.iter().fold(0.0, |most: f64, row| most.max(-row[0][0]));
    assert!(rows.iter().all(|row| row[0][2] <= 0.0));
    [overlap, rows[rows.len() - 1][0][1] / v0]
}

#[test]
fn two_masses_collide_as_the_closed_forms_of_each_law_say() {
    // m = m1 m2/(m1 + m2)
    let (mass, k, e, v0) = (0.75, 40.0, 0.6, 2.0);
    let linear = v0 * f64::sqrt(mass / k);
    let curved = libm::pow(mass * v0 * v0 / k, 0.4);
    let spring = KelvinVoigt::new(k, e, mass);
    let dashpot = Dashpot {
        ratio: spring.ratio(mass),
    };
    let hertz = |damping: f64| {
        let collision = DampedHertz { damping };
        [curved * collision.overlap(), collision.restitution()]
    };
    let jankowski = Jankowski::new(k, e, mass);
    let approach = HertzDashpot {
        ratio: jankowski.ratio(mass),
    };
    let damped = HertzDamp::new(k, e);
    let (hunt, ye) = (HuntCrossley::new(k, e), Ye::new(k, e));
    for (law, expected) in [
        (ContactLaw::Hertz(Hertz { stiffness: k }), hertz(0.0)),
        (ContactLaw::HertzDamp(damped), hertz(damped.damping)),
        (ContactLaw::HuntCrossley(hunt), hertz(hunt.damping)),
        (ContactLaw::Ye(ye), hertz(ye.damping)),
        (
            ContactLaw::Jankowski(jankowski),
            [curved * approach.overlap(), approach.restitution()],
        ),
        (
            ContactLaw::KelvinVoigt(spring),
            [linear * dashpot.overlap(), dashpot.restitution()],
        ),
    ] {
        let dts = [4e-3, 1e-3, 2.5e-4];
        let errors = dts.map(|dt| {
            let found = collide(law, v0, dt);
            f64::max(
                (found[0] / expected[0] - 1.0).abs(),
                (found[1] / expected[1] - 1.0).abs(),
            )
        });
        // A jump of the force, and its steep rise, are met within a step: first order. The other laws have the second.
        let jumps = matches!(law, ContactLaw::KelvinVoigt(_) | ContactLaw::Jankowski(_));
        let most = if jumps { 0.05 } else { 1e-3 };
        assert!(
            errors[0] < most && errors[2] < 0.15 * errors[0],
            "{law:?} {errors:?}"
        );
    }
}

/// Girders with every law of impact and friction somewhere, and two contacts between the same nodes.
fn various(which: usize, ground: &Arc<Signal>) -> Structure {
    let mut structure = girders(4, 0.3, 1.0, ground);
    let k = 4e6;
    let (e, mass) = (0.6, 250.0);
    let impacts = [
        ContactLaw::KelvinVoigt(KelvinVoigt::new(k, e, mass)),
        ContactLaw::Hertz(Hertz {
            stiffness: 10.0 * k,
        }),
        ContactLaw::HertzDamp(HertzDamp::new(10.0 * k, e)),
        ContactLaw::HuntCrossley(HuntCrossley::new(10.0 * k, e)),
        ContactLaw::Ye(Ye::new(10.0 * k, e)),
        ContactLaw::Jankowski(Jankowski::new(10.0 * k, e, mass)),
    ];
    let (compliance, limit) = (1.0 / 5e4, 245.0);
    let slow = 0.01;
    let frictions = [
        ContactLaw::Tanh(Tanh {
            compliance: slow / limit,
            limit,
            ratio: 0.7,
            rate: 5.0,
        }),
        ContactLaw::Bearing(Bearing {
            compliance: slow / limit,
            limit,
            ratio: 0.7,
            rate: 5.0,
        }),
        ContactLaw::BoucWen(BoucWen {
            compliance,
            limit,
            exponent: 1.5,
            beta: 0.5,
        }),
        ContactLaw::Dahl(Dahl {
            compliance,
            limit,
            exponent: 1.0,
        }),
        ContactLaw::Lugre(Lugre {
            sigma0: 1.0 / compliance,
            sigma1: 100.0,
            sigma2: 10.0,
            limit,
            static_limit: 1.2 * limit,
            stribeck_velocity: 0.1,
        }),
        ContactLaw::Stribeck(Stribeck {
            compliance: slow / limit,
            limit,
            static_limit: 1.2 * limit,
            stribeck_velocity: 0.1,
            decay: Decay::Exponential,
        }),
    ];
    structure.contacts[0].law = impact(impacts[which]);
    structure.contacts[1].law = impact(impacts[(which + 1) % 6]);
    structure.contacts[2].law = friction(frictions[which], limit);
    structure.contacts[3].law = friction(frictions[(which + 1) % 6], limit);
    structure.contacts.push(Contact {
        gap: 0.0,
        law: friction(frictions[0], 60.0),
        ..structure.contacts[0].clone()
    });
    structure
}

/// S of the laws that r and rdot alone tell.
fn force(law: &StructureLaw, [r, rdot]: [f64; 2]) -> Option<f64> {
    let d = (-r).max(0.0);
    let given = law.as_given();
    if let ContactLaw::Hertz(law) = given {
        return Some(-law.stiffness * d * d.sqrt());
    }
    if let ContactLaw::Jankowski(law) = given {
        let dashpot = law.damping * d.sqrt().sqrt() * (-rdot).max(0.0);
        return Some(-(law.stiffness * d * d.sqrt() + dashpot));
    }
    if let (ContactLaw::KelvinVoigt(law), true) = (given, d > 0.0) {
        return Some(-(law.stiffness * d - law.damping * rdot).max(0.0));
    }
    let ContactLaw::Tanh(tanh) = given else {
        return None;
    };
    let least = (1.0 - tanh.ratio) * libm::exp(-tanh.rate * rdot.abs());
    let limit = law.limit()?.constant;
    Some(limit * (1.0 - least) * libm::tanh(rdot / (tanh.compliance * limit)))
}

#[test]
fn several_contacts_with_various_laws_obey_each_law() {
    let ground = ground();
    let mut touched = [0; 6];
    for (which, touched) in touched.iter_mut().enumerate() {
        let structure = various(which, &ground);
        let (rows, error) = motion(&structure, 0.001, 5000);
        assert!(error < 1e-12, "{which} {error}");
        for (i, row) in rows.iter().enumerate().skip(1) {
            for (c, [r, rdot, s]) in row.iter().enumerate() {
                let law = &structure.contacts[c].law;
                if law.kind() == ContactKind::Impact {
                    assert!(*s <= 0.0 && (*r < 1e-12 || *s == 0.0));
                    *touched += usize::from(*s < 0.0);
                } else if !matches!(law.as_given(), ContactLaw::Lugre(_)) {
                    let most = law.limit().unwrap().constant * 1.2;
                    assert!(s.abs() <= most * (1.0 + 1e-12));
                }
                let Some(expected) = force(law, [*r, *rdot]) else {
                    continue;
                };
                // Round-off of displacements of 0.1 (rdot: of 1) through slopes of up to 1e7 (4e4 dt/2 of a step).
                let slope = match law.kind() == ContactKind::Impact {
                    true => {
                        6e7 * r.abs().sqrt() + 1e6 * libm::pow(r.abs() + 1e-12, -0.75) * rdot.abs()
                    }
                    false => 3e4,
                };
                let near = 1e-13 * slope + 1e-11 * expected.abs();
                assert!(
                    (s - expected).abs() <= near,
                    "{which} {i} {c} {r} {rdot} {s} {expected}"
                );
            }
        }
    }
    // Every pair of impacts has touched.
    assert!(touched.iter().all(|touched| *touched > 20), "{touched:?}");
}

#[test]
fn clipped_lines_move_alike_on_both_ways() {
    let ground = ground();
    let lines = mixed(4, 1.3, &ground);
    let mut structure = lines.clone();
    for (contact, line) in structure.contacts.iter_mut().zip(&lines.contacts) {
        if let Some(ClippedLine::Spring { stiffness }) = line.law.line() {
            contact.law = impact(ContactLaw::ImpactSpring(ImpactSpring { stiffness }));
        }
    }
    assert_alike(&structure, &lines);
}

/// While impacts with curved laws stay open, friction as clipped lines is solved in lanes; by its answers it is not.
#[test]
fn open_impacts_move_alike_on_both_ways() {
    let ground = ground();
    let (k, e, mass) = (4e6, 0.6, 250.0);
    for law in [
        ContactLaw::KelvinVoigt(KelvinVoigt::new(k, e, mass)),
        ContactLaw::HertzDamp(HertzDamp::new(10.0 * k, e)),
        ContactLaw::Jankowski(Jankowski::new(10.0 * k, e, mass)),
    ] {
        let mut lines = mixed(4, 1.3, &ground);
        for contact in lines.contacts.iter_mut() {
            if contact.law.kind() == ContactKind::Impact {
                contact.law = impact(law);
            }
        }
        let mut answers = lines.clone();
        let sliding = ContactLaw::VelocityControl(VelocityControl {
            compliance: 1.0 / 6500.0,
            limit: 60.0,
        });
        answers.contacts[5].law = friction(sliding, 60.0);
        assert_alike(&answers, &lines);
    }
}

fn assert_alike(structure: &Structure, lines: &Structure) {
    let (rows, error) = motion(structure, 0.002, 2500);
    let (expected, _) = motion(lines, 0.002, 2500);
    assert!(error < 1e-12, "{error}");
    let mut most = [0.0_f64; 3];
    let mut worst = [0.0_f64; 3];
    for (row, expected) in rows.iter().flatten().zip(expected.iter().flatten()) {
        for k in 0..3 {
            most[k] = most[k].max(expected[k].abs());
            worst[k] = worst[k].max((row[k] - expected[k]).abs());
        }
    }
    for k in 0..3 {
        // Impacts enlarge round-off.
        assert!(worst[k] < 1e-7 * most[k], "{k} {worst:?} {most:?}");
    }
}

#[test]
fn a_mirrored_structure_has_mirrored_forces() {
    let ground = ground();
    for law in frictions() {
        let make = |sign: f64| {
            let mut structure = masses(&[1.0, 2.0, 1.5]);
            for i in 0..2 {
                structure
                    .stiffness
                    .add_spring([Some(i), Some(i + 1)], 300.0);
            }
            structure.stiffness.add_spring([None, Some(0)], 100.0);
            let pattern = vec![(0, -sign), (1, -2.0 * sign), (2, -1.5 * sign)];
            structure.loads = vec![Load {
                pattern,
                signal: ground.clone(),
            }];
            structure.velocity = vec![0.5 * sign, -sign, 0.2 * sign];
            for i in 0..3 {
                structure
                    .contacts
                    .push(contact([None, Some(i)], 0.0, friction(law, 1.0)));
            }
            motion(&structure, 0.005, 800).0
        };
        let [there, mirrored] = [make(1.0), make(-1.0)];
        for (a, b) in there.iter().flatten().zip(mirrored.iter().flatten()) {
            // The same operations with other signs.
            assert_eq!(*a, b.map(|x| -x), "{law:?}");
        }
    }
}

#[test]
fn a_lane_with_curved_laws_has_its_own_bits_and_leaves_others_alone() {
    let ground = ground();
    let mut cases = [
        various(0, &ground),
        mixed(4, 1.0, &ground),
        various(3, &ground),
    ];
    // The limit changes in some lanes.
    let varying = Limit {
        constant: 200.0,
        varying: Some((30.0, ground.clone())),
        ..Limit::constant(0.0)
    };
    let law = ContactLaw::Tanh(Tanh {
        compliance: 1e-4,
        limit: 200.0,
        ratio: 1.0,
        rate: 0.0,
    });
    cases[2].contacts[4].law = StructureLaw::new(law, varying).from_its_answer();
    let prepared = Prepared::new(&cases[0], 0.002).unwrap();
    fn bits<const L: usize>(cases: &[&Structure; L], prepared: &Prepared) -> [Vec<u64>; L] {
        let mut bits = [const { Vec::new() }; L];
        let done = run::<L>(cases, prepared, 1500, |_, state| {
            for c in 0..state.contacts() {
                let now = state.contact(c);
                let channels = [
                    now.displacement,
                    now.velocity,
                    now.force,
                    now.limit,
                    now.slip,
                ];
                for Lane(channel) in channels {
                    for (bits, x) in bits.iter_mut().zip(channel) {
                        bits.push(x.to_bits());
                    }
                }
            }
        });
        assert!(done.iter().all(Result::is_ok), "{done:?}");
        bits
    }
    let together = bits::<4>(&[&cases[0], &cases[1], &cases[2], &cases[0]], &prepared);
    for (case, together) in cases.iter().zip(&together) {
        let [alone] = bits::<1>(&[case], &prepared);
        assert!(alone == *together);
    }
}

#[test]
fn a_limit_that_varies_moves_the_curved_laws_as_the_line() {
    // tanh with a wide rdot^E hardly bends: S = c rdot, so the limit is seen in the cubic term only.
    let signal = Signal::Table(Table::new(vec![0.0, 1.0, 2.0], vec![1.0, 0.2, 1.0]).unwrap());
    let limit = Limit {
        constant: 0.5,
        varying: Some((2.0, Arc::new(signal))),
        pressure: Some(crate::system::structure::Pressure {
            at_rest: 2.5,
            exponent: 0.3,
        }),
        pressed_by: None,
        static_ratio: 1.0,
    };
    let mut structure = masses(&[1.0]);
    structure.velocity[0] = 3.0;
    let law = ContactLaw::Tanh(Tanh {
        compliance: 0.5,
        limit: 2.5,
        ratio: 1.0,
        rate: 0.0,
    });
    let lane_limit = limit.clone();
    structure.contacts = vec![contact(
        [None, Some(0)],
        0.0,
        StructureLaw::new(law, limit).from_its_answer(),
    )];
    let dt = 0.01;
    let prepared = Prepared::new(&structure, dt).unwrap();
    let [done] = run::<1>(&[&structure], &prepared, 200, |step, state| {
        let now = state.contact(0);
        let [rdot, s, limit] = [now.velocity, now.force, now.limit].map(|x| x.0[0]);
        let t = dt * step as f64;
        let raw = 0.5 + 2.0 * (1.0 - 0.8 * (1.0 - (t - 1.0).abs()));
        let expected = raw * libm::pow(raw / 2.5, -0.3);
        assert!((limit - expected).abs() < 1e-13 && (lane_limit.at(t) - expected).abs() < 1e-13);
        let expected = limit * libm::tanh(rdot / (0.5 * limit));
        assert!((s - expected).abs() < 1e-13, "{t} {s} {expected}");
    });
    done.unwrap();
}

#[test]
fn friction_that_falls_too_fast_is_refused() {
    let law = |stribeck_velocity: f64| {
        ContactLaw::Stribeck(Stribeck {
            compliance: 0.01,
            limit: 1.0,
            static_limit: 2.0,
            stribeck_velocity,
            decay: Decay::Exponential,
        })
    };
    // Of a free mass of 1: h_rate = dt/2.
    for (velocity, expected) in [
        (0.0051, Ok(())),
        (
            0.0049,
            Err(Unsolvable::NoForces {
                step: 0,
                why: Unsolved::Falling,
            }),
        ),
    ] {
        let mut structure = masses(&[1.0]);
        structure.velocity[0] = 1.0;
        structure.contacts = vec![contact([None, Some(0)], 0.0, friction(law(velocity), 1.0))];
        let prepared = Prepared::new(&structure, 0.01).unwrap();
        let [done] = run::<1>(&[&structure], &prepared, 300, |_, _| ());
        assert_eq!(done, expected, "{velocity}");
    }
}

#[test]
fn a_link_that_softens_too_fast_is_refused() {
    // Of a free mass of 1: h = dt^2/4.
    let dt = 0.01;
    let falling = Err(Unsolvable::NoForces {
        step: 0,
        why: Unsolved::Falling,
    });
    for (part, expected) in [(0.99, Ok(())), (1.01, falling)] {
        let hardening = -part * 4.0 / (dt * dt);
        let law = ContactLaw::Bilinear(Bilinear {
            stiffness: 1e5,
            yield_force: 1.0,
            hardening,
        });
        let mut structure = masses(&[1.0]);
        structure.velocity[0] = 1e-4;
        structure.contacts = vec![contact([None, Some(0)], 0.0, StructureLaw::new(law, None))];
        let prepared = Prepared::new(&structure, dt).unwrap();
        let [done] = run::<1>(&[&structure], &prepared, 30, |_, _| ());
        assert_eq!(done, expected, "{part}");
    }
}
