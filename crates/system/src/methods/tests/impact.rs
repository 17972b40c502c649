//! Rigid stops, by the method of Moreau and Jean and by the contact-stabilised one.

use super::*;

/// A rigid stop at velocity level: rdot' = -e rdot if the gap predicted for the middle of the step is not positive, as long as the
/// stop pushes.
struct Stop {
    on: StepFlexibility<1>,
    restitution: f64,
}

impl ContactResponse<1> for Stop {
    fn force(&mut self, _: usize, trial: &Trial<1>) -> Lane<1> {
        assert!(self.on.by_impulse);
        let ([r], [rdot], [dt]) = (trial.displacement.0, trial.velocity.0, self.on.dt.0);
        if r + 0.5 * dt * rdot > 0.0 {
            return Lane([0.0]);
        }
        let target = -self.restitution * rdot;
        Lane([((trial.rate.0[0] - target) / self.on.end.h_rate.0[0]).min(0.0)])
    }
}

fn rigid(
    theta: f64,
    dt: f64,
    gap: f64,
    modes: &[ModeStart<1>],
    restitution: f64,
) -> (Lanes<MoreauJean, 1>, Stop) {
    let at = start(Method::MoreauJean(MoreauJean { theta }), dt, gap, 0.0);
    let method = Lanes::<MoreauJean, 1>::new(&at, modes.iter().copied()).unwrap();
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
                // The ball falls with a speed of 1 at most, and is stopped before the middle of the next step.
                assert!(
                    after.displacement.0[0] >= -dt,
                    "{theta} {restitution} {step}"
                );
                if after.force.0[0] < 0.0 {
                    assert!((v + restitution * was).abs() < 1e-12, "{step}: {was} {v}");
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
            // The mean force of the load: weight/phi2 with the acceleration 1 at r = 0.
            let load = 2.0 * (1.0 + SOFT * end.displacement.0[0]);
            assert!((end.force.0[0] + load).abs() < 1e-9, "{:?}", end.force);
            let (x, _) = Recursion::modes(&method).next().unwrap();
            // Without restitution it keeps the overlap of the first impact. With it, later impacts are slow.
            let height = end.displacement.0[0];
            let deep = if restitution == 0.0 {
                dt
            } else {
                4.0 * dt * dt
            };
            assert!(
                -deep <= height && height <= 0.0,
                "{theta} {restitution}: {height}"
            );
            // The coordinate is 1e4: 20,000 roundings of 1e-12.
            assert!(
                (x.0[0] + gap - height).abs() < 4e-8,
                "{theta} {restitution}"
            );
        }
    }
}

/// The modes of a bar of length 1, mass 1 and n elements with half of the mass of an element at its ends, in closed form. A wave
/// passes it in 1/2, and it moves with -1 towards the stop. r is the displacement of its end.
fn bar(n: u32) -> Vec<ModeStart<1>> {
    let n = f64::from(n);
    let of = |j: u32| {
        let j = f64::from(j);
        let sine = libm::sin(0.5 * std::f64::consts::PI * j / n);
        let phi2 = if j == 0.0 || j == n { 1.0 } else { 2.0 };
        let v = if j == 0.0 { -1.0 } else { 0.0 };
        mode(16.0 * n * n * sine * sine, phi2, 0.0, v)
    };
    (0..=n as u32).map(of).collect()
}

/// Energies after each step, and the smallest r, of a bar with this gap.
fn energies(theta: f64, e: f64, dt: f64, gap: f64, bar: &[ModeStart<1>]) -> (Vec<f64>, f64) {
    let (mut method, mut stop) = rigid(theta, dt, gap, bar, e);
    let mut least = f64::INFINITY;
    let mut rows = Vec::new();
    for _ in 0..(2.5 / dt) as u32 {
        let after = method.step(&mut stop);
        least = least.min(after.displacement.0[0]);
        let states = Recursion::modes(&method).zip(bar);
        let energy_and_displacement = |((x, v), start): ((Lane<1>, Lane<1>), &ModeStart<1>)| {
            (start.mode[0].energy(x.0[0], v.0[0]), x.0[0])
        };
        let (energy, sum): (Vec<f64>, Vec<f64>) = states.map(energy_and_displacement).unzip();
        rows.push(energy.iter().sum::<f64>() / 0.5);
        // The modes agree with r: sums of 41 terms.
        let r = gap + sum.iter().sum::<f64>();
        assert!((r - after.displacement.0[0]).abs() < 1e-12);
    }
    (rows, least)
}

#[test]
fn bars_lose_the_energy_of_the_standard_scheme_and_never_gain() {
    // The lost parts are those of a program with the masses and springs of the elements and a solver of its equations, without
    // modes: smallest and largest of twenty gaps. Round-off of 12 digits printed.
    let bar = bar(40);
    for (theta, e, [smallest, largest]) in [
        (0.5, 0.0, [0.051_538_820_320, 0.051_538_820_320]),
        (0.5, 0.5, [0.020_833_330_949, 0.073_771_784_090]),
        (0.5, 1.0, [0.0, 0.0]),
        (1.0, 0.0, [0.576_678_254_860, 0.599_862_422_995]),
        (1.0, 1.0, [0.569_737_312_930, 0.654_282_826_727]),
    ] {
        let mut lost = Vec::new();
        for k in 0..20 {
            let gap = 0.2025 + 0.005 * f64::from(k);
            let (energies, least) = energies(theta, e, 0.05, gap, &bar);
            lost.push(1.0 - energies[energies.len() - 1]);
            // Never more than at the start; and in no step, unless a contact that opens is pushed back (0 < e < 1).
            assert!(energies.iter().all(|energy| *energy < 1.0 + 1e-12));
            let falls = |pair: &[f64]| pair[1] < pair[0] + 1e-13;
            assert!(e > 0.0 || energies.windows(2).all(falls), "{theta} {gap}");
            // The first touch leaves an overlap below a step.
            assert!(
                [theta, e] != [0.5, 0.0] || -0.05 < least && least < 0.0,
                "{least}"
            );
        }
        let found = [
            lost.iter().fold(1.0_f64, |a, b| a.min(*b)),
            lost.iter().fold(-1.0_f64, |a, b| a.max(*b)),
        ];
        let expected = [smallest, largest];
        assert!(
            (0..2).all(|i| (found[i] - expected[i]).abs() < 1e-11),
            "{theta} {e} {found:?} {expected:?}"
        );
    }
}

/// r >= 0 at the end of each step, as the law has it.
struct Wall(StepFlexibility<1>);

impl ContactResponse<1> for Wall {
    fn force(&mut self, _: usize, trial: &Trial<1>) -> Lane<1> {
        // The part of S(i) that is still to be applied moves r, too.
        let still = self.0.start.h * trial.force;
        let r = (trial.displacement + trial.change - still).0[0];
        Lane([if r < 0.0 { r / self.0.end.h.0[0] } else { 0.0 }])
    }

    fn correction(&self, displacement: Lane<1>) -> Lane<1> {
        displacement.map(|r| (-r).max(0.0))
    }
}

/// The forces of a bar on a wall, which are 2 for a time of 1 in the exact motion, and its energies over that at the start.
struct OnWall<'a>(&'a [ModeStart<1>], u32);

impl WithMethod for OnWall<'_> {
    type Output = (Vec<f64>, Vec<f64>);
    fn run<N: Recursion<1>>(self, mut method: N) -> Self::Output {
        let mut wall = Wall(method.flexibilities()[0]);
        let step = |_| {
            let after = method.step(&mut wall);
            assert!(after.displacement.0[0] > -1e-12);
            let states = Recursion::modes(&method).zip(self.0);
            let energy: f64 = states
                .map(|((x, v), start)| start.mode[0].energy(x.0[0], v.0[0]))
                .sum();
            (-after.force.0[0], energy / 0.5)
        };
        (0..self.1).map(step).unzip()
    }
}

#[test]
fn a_corrected_contact_has_quieter_forces_and_loses_little_energy() {
    let bar = bar(40);
    for dt in [0.0125, 0.00625] {
        let steps = (1.5 / dt) as u32;
        let run = |method| with(&start(method, dt, 0.2, 0.0), &bar, OnWall(&bar, steps));
        let (forces, energies) = run(Method::ContactStabilized(ContactStabilized));
        let (usual, _) = run(Method::Family(Coefficients::newmark(0.25, 0.5)));
        // From 0.1 after the first touch to 0.1 before the end of the contact.
        let inner = |forces: &[f64]| -> Vec<f64> {
            let between = [0.3, 1.1].map(|t| (t / dt) as usize);
            forces[between[0]..between[1]].to_vec()
        };
        let largest = |forces: &[f64]| {
            inner(forces)
                .iter()
                .fold(0.0_f64, |a, f| a.max((f - 2.0).abs()))
        };
        let mean = inner(&forces).iter().sum::<f64>() / inner(&forces).len() as f64;
        // The mesh leaves a ripple of some per cent. Forces of Newmark's method alone swing by several times the force, more at
        // shorter steps.
        assert!(largest(&forces) < 0.05, "{dt} {}", largest(&forces));
        assert!(largest(&usual) > 5.0, "{dt} {}", largest(&usual));
        assert!((mean - 2.0).abs() < 2e-3, "{dt} {mean}");
        assert!(energies.iter().all(|energy| *energy < 1.0 + 1e-12));
        let lost = 1.0 - energies[energies.len() - 1];
        assert!(0.0 < lost && lost < 0.02, "{dt} {lost}");
    }
}
