//! Moreau and Jean's method on rigid stops.

use super::*;

/// A rigid stop with restitution at velocity level: rdot' = -e rdot if r would become negative, as long as the stop pushes.
struct Stop {
    on: StepFlexibility<1>,
    restitution: f64,
}

impl Answer<1> for Stop {
    fn force(&mut self, _: usize, trial: &Trial<1>) -> Lane<1> {
        assert!(self.on.by_impulse);
        if trial.displacement.0[0] + trial.change.0[0] >= 0.0 {
            return Lane([0.0]);
        }
        let target = -self.restitution * trial.velocity.0[0].min(0.0);
        Lane([((trial.rate.0[0] - target) / self.on.end.h_rate.0[0]).min(0.0)])
    }
}

fn rigid(
    theta: f64,
    dt: f64,
    gap: f64,
    modes: &[ModeStart<1>],
    restitution: f64,
) -> (MoreauJean<1>, Stop) {
    let at = Start {
        rigid: [true],
        ..start(MethodChoice::MoreauJean { theta }, dt, gap, 0.0)
    };
    let method = MoreauJean::<1>::new(&at, modes.iter().copied()).unwrap();
    let on = method.flexibilities()[0];
    (method, Stop { on, restitution })
}

/// A ball on a soft spring that presses it on the stop: at rest it is 1 inside, so that its acceleration is close to -1.
const SOFT: f64 = 1e-4;

#[test]
fn a_ball_bounces_with_its_restitution_and_comes_to_rest() {
    for theta in [0.5, 0.7, 1.0] {
        for restitution in [0.0, 0.5, 0.8] {
            // x = r - gap; the spring pushes back to r = gap < 0 with acceleration 1.
            let gap = -1.0 / SOFT;
            let dt = 1e-3;
            let ball = [mode(SOFT, 0.5, 0.5 - gap, 0.0)];
            let (mut method, mut stop) = rigid(theta, dt, gap, &ball, restitution);
            let mut rebounds: Vec<[f64; 2]> = Vec::new();
            let mut rest = 0;
            for step in 0..20_000 {
                let before = method.contact();
                let after = method.step(&mut stop);
                let (was, v) = (before.velocity.0[0], after.velocity.0[0]);
                assert!(
                    after.displacement.0[0] >= 0.0,
                    "{theta} {restitution} {step}"
                );
                if after.force.0[0] < 0.0 {
                    assert!(
                        (v + restitution * was.min(0.0)).abs() < 1e-12,
                        "{step}: {was} {v}"
                    );
                    // Impacts much faster than the last ones before the rest.
                    if was < -0.1 {
                        rebounds.push([was, v]);
                    }
                }
                rest = if v == 0.0 || v.abs() < 1e-12 {
                    rest + 1
                } else {
                    0
                };
            }
            // The first fall from 0.5 has the velocity 1, up to one step.
            assert!((rebounds[0][0] + 1.0).abs() < 3.0 * dt, "{:?}", rebounds[0]);
            // Each flight returns with the velocity that it left with, up to some steps and the dissipation of theta.
            for pair in rebounds.windows(2) {
                assert!(
                    (pair[1][0] + pair[0][1]).abs() < 5.0 * dt,
                    "{theta} {pair:?}"
                );
            }
            // At rest after 2 v0/(1 - e) at most 10 s, it stays, without drift.
            assert!(rest > 5_000, "{theta} {restitution}: {rest}");
            let end = method.contact();
            // The mean force of the load: weight/phi2 with the acceleration 1.
            assert!((end.force.0[0] + 2.0).abs() < 1e-9, "{:?}", end.force);
            let (x, _) = Method::modes(&method).next().unwrap();
            // It came to rest within the fall of one step under the load, and it has not moved since.
            let height = end.displacement.0[0];
            assert!(height < dt * dt, "{theta} {restitution}: {height}");
            // The coordinate is 1e4: 20,000 roundings of 1e-12.
            assert!(
                (x.0[0] + gap - height).abs() < 4e-8,
                "{theta} {restitution}"
            );
        }
    }
}

#[test]
fn bars_in_contact_have_no_overlap_and_no_drift() {
    // Many modes on a stop: each impact would leave an overlap of up to dt times the velocity. The modes agree with r.
    let modes: Vec<_> = (0..12)
        .map(|j| {
            let j = f64::from(j);
            mode(
                4.0 * j * j,
                if j > 0.0 { 2.0 } else { 1.0 },
                0.0,
                if j > 0.0 { 0.0 } else { -1.0 },
            )
        })
        .collect();
    for theta in [0.5, 0.6] {
        let (mut method, mut stop) = rigid(theta, 0.01, 0.005, &modes, 0.0);
        let mut impacts = 0;
        for step in 0..2000 {
            let after = method.step(&mut stop);
            impacts += u32::from(after.force.0[0] < 0.0);
            assert!(after.displacement.0[0] >= 0.0);
            let sum: f64 = Method::modes(&method).map(|(x, _)| x.0[0]).sum();
            // Sums of 12 terms, 2000 steps; the bar has left by up to 20.
            assert!(
                (sum + 0.005 - after.displacement.0[0]).abs() < 1e-12,
                "{step}"
            );
        }
        assert!(impacts > 5);
    }
}

#[test]
fn only_rigid_contacts_are_projected() {
    let modes = [mode(1.0, 1.0, -0.5, 0.0)];
    let at = start(MethodChoice::MoreauJean { theta: 0.5 }, 0.1, 0.0, 0.0);
    let mut free = MoreauJean::<1>::new(&at, modes.into_iter()).unwrap();
    assert!(free.step(&mut Prescribed([0.0; 2])).displacement.0[0] < -0.4);
    let at = Start {
        rigid: [true],
        ..at
    };
    let mut stopped = MoreauJean::<1>::new(&at, modes.into_iter()).unwrap();
    let velocity = free.contact().velocity;
    let contact = stopped.step(&mut Prescribed([0.0; 2]));
    assert_eq!(contact.displacement.0[0], 0.0);
    // The projection changes positions only.
    assert_eq!(contact.velocity, velocity);
}

#[test]
fn projection_moves_modes_by_their_inverse_masses() {
    // Two modes with phi2 1 and 3 share the overlap as 1 to 3.
    let modes = [mode(0.0, 1.0, -0.1, 0.0), mode(0.0, 3.0, -0.3, 0.0)];
    let at = Start {
        rigid: [true],
        ..start(MethodChoice::MoreauJean { theta: 0.5 }, 0.1, 0.2, 0.0)
    };
    let mut method = MoreauJean::<1>::new(&at, modes.into_iter()).unwrap();
    method.step(&mut Prescribed([0.0; 2]));
    let x: Vec<f64> = Method::modes(&method).map(|(x, _)| x.0[0]).collect();
    assert!(
        (x[0] + 0.05).abs() < 1e-15 && (x[1] + 0.15).abs() < 1e-15,
        "{x:?}"
    );
}
