//! Tests of all methods together: against closed forms, the equations of the papers, exact motions and identities.

mod amplification;
mod bar;
mod critical_step;
mod descriptions;
mod energy;
mod impact;
mod order;
mod recursion;

use super::{
    AverageAcceleration, Bathe, Coefficients, ContactStabilized, ContactWork, ManyModes, Method,
    Mode, ModeStart, MoreauJean, Recursion, Scheme, Start,
};
use crate::contact::{ContactResponse, StepFlexibility, Trial};
use crate::lane::Lane;

/// Methods of the family, each with its largest omega dt.
fn family() -> Vec<(Coefficients, f64)> {
    let mut members = vec![
        (Coefficients::linear_acceleration(), f64::sqrt(12.0)),
        (Coefficients::central_difference(), 2.0),
        (Coefficients::newmark(0.25, 0.5), f64::INFINITY),
        (Coefficients::newmark(0.3025, 0.6), f64::INFINITY),
    ];
    for alpha in [-0.05, -0.1, -0.2, -1.0 / 3.0] {
        members.push((Coefficients::hht(alpha), f64::INFINITY));
    }
    for rho in [0.0, 0.3, 0.8, 1.0] {
        members.push((Coefficients::generalized_alpha(rho), f64::INFINITY));
    }
    members
}

/// All methods with a file here, each with its largest omega dt.
fn all() -> Vec<(Method, f64)> {
    let family = family().into_iter();
    let mut methods: Vec<_> = family
        .map(|(member, limit)| (Method::Family(member), limit))
        .collect();
    methods.push((Method::Bathe(Bathe), f64::INFINITY));
    for theta in [0.5, 0.7, 1.0] {
        methods.push((Method::MoreauJean(MoreauJean { theta }), f64::INFINITY));
    }
    methods.push((Method::ContactStabilized(ContactStabilized), f64::INFINITY));
    methods
}

/// A mode at t = 0.
fn mode(omega2: f64, phi2: f64, x: f64, v: f64) -> ModeStart<1> {
    ModeStart {
        mode: [Mode::new(omega2, phi2)],
        displacement: Lane([x]),
        velocity: Lane([v]),
    }
}

fn start(choice: Method, dt: f64, gap: f64, force: f64) -> Start<1> {
    Start {
        method: [choice],
        dt: Lane([dt]),
        gap: Lane([gap]),
        force: Lane([force]),
    }
}

/// Runs code with a method whatever its type is.
trait WithMethod {
    type Output;
    fn run<N: Recursion<1>>(self, method: N) -> Self::Output;
}

fn with<W: WithMethod>(start: &Start<1>, modes: &[ModeStart<1>], work: W) -> W::Output {
    fn of<W: WithMethod, S: Scheme>(
        _: S,
        start: &Start<1>,
        modes: &[ModeStart<1>],
        work: W,
    ) -> W::Output {
        work.run(Lanes::<S, 1>::new(start, modes.iter().copied()).unwrap())
    }
    crate::each_method!(start.method[0], method => of(method, start, modes, work))
}

/// The recursion of a scheme for L structures.
type Lanes<S, const L: usize> = <S as Scheme>::Lanes<L, ManyModes>;

/// A force that is known beforehand, at the ends of both sub-steps.
#[derive(Clone, Copy)]
struct Prescribed([f64; 2]);

impl ContactResponse<1> for Prescribed {
    fn force(&mut self, part: usize, _: &Trial<1>) -> Lane<1> {
        Lane([self.0[part]])
    }
}

/// S = f(r) for a function that does not fall, by bisection.
struct Elastic<F> {
    on: [StepFlexibility<1>; 2],
    law: F,
}

impl<F: Fn(f64) -> f64> ContactResponse<1> for Elastic<F> {
    fn force(&mut self, part: usize, trial: &Trial<1>) -> Lane<1> {
        let on = &self.on[part];
        let h = on.end.h.0[0];
        let r = trial.displacement.0[0] + (trial.change.0[0] - on.start.h.0[0] * trial.force.0[0]);
        // S(r - h S) - S falls in S.
        let excess = |s: f64| (self.law)(r - h * s) - s;
        let bound = (self.law)(r).abs() * (1.0 + f64::EPSILON) + f64::MIN_POSITIVE;
        let (mut low, mut high) = (-bound, bound);
        loop {
            let middle = 0.5 * (low + high);
            if !(low < middle && middle < high) {
                return Lane([middle]);
            }
            if excess(middle) > 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
    }
}

#[test]
fn lanes_are_the_same_alone_and_together() {
    // Different coefficients, steps and modes in each lane; only one of them hits its rigid stop.
    let (choices, limit) = (family(), 4);
    let force = |l: usize, i: u32| libm::sin(f64::from(i) * 0.3 + l as f64);
    let dt = [0.01, 0.1, 0.02, 0.3];
    let starts: Vec<Vec<ModeStart<1>>> = (0..limit)
        .map(|l| {
            let l = l as f64;
            vec![
                mode(1.0 + l, 0.7, 0.1 * l, 1.0),
                mode(9.0 + l, 0.2 + l, -0.3, 0.2),
            ]
        })
        .collect();
    struct Own<'a>(&'a dyn Fn(usize, u32) -> f64, u32);
    impl<const L: usize> ContactResponse<L> for Own<'_> {
        fn force(&mut self, _: usize, _: &Trial<L>) -> Lane<L> {
            let mut lane = Lane::splat(0.0);
            for l in 0..L {
                lane.0[l] = (self.0)(l, self.1);
            }
            lane
        }
    }
    fn check<A: Recursion<1>, B: Recursion<4>>(
        choice: [Method; 4],
        dt: [f64; 4],
        starts: &[Vec<ModeStart<1>>],
        force: &dyn Fn(usize, u32) -> f64,
    ) {
        let of = |l: usize| Start::<1> {
            method: [choice[l]],
            dt: Lane([dt[l]]),
            gap: Lane([0.05]),
            force: Lane([0.2]),
        };
        let together = Start::<4> {
            method: choice,
            dt: Lane(dt),
            gap: Lane::splat(0.05),
            force: Lane::splat(0.2),
        };
        let modes = (0..starts[0].len()).map(|j| ModeStart::<4> {
            mode: std::array::from_fn(|l| starts[l][j].mode[0]),
            displacement: Lane(std::array::from_fn(|l| starts[l][j].displacement.0[0])),
            velocity: Lane(std::array::from_fn(|l| starts[l][j].velocity.0[0])),
        });
        let mut four = B::new(&together, modes).unwrap();
        let mut alone: Vec<A> = (0..4)
            .map(|l| A::new(&of(l), starts[l].iter().copied()).unwrap())
            .collect();
        for i in 0..200 {
            let together = four.step(&mut Own(force, i));
            for (l, one) in alone.iter_mut().enumerate() {
                let shifted = |_: usize, i: u32| force(l, i);
                let alone = one.step(&mut Own(&shifted, i));
                assert_eq!(
                    alone.displacement.0[0].to_bits(),
                    together.displacement.0[l].to_bits()
                );
                assert_eq!(
                    alone.velocity.0[0].to_bits(),
                    together.velocity.0[l].to_bits()
                );
            }
        }
    }
    let family = std::array::from_fn(|l| Method::Family(choices[l + 3].0));
    check::<Lanes<Coefficients, 1>, Lanes<Coefficients, 4>>(family, dt, &starts, &force);
    check::<Lanes<Bathe, 1>, Lanes<Bathe, 4>>([Method::Bathe(Bathe); 4], dt, &starts, &force);
    let theta = std::array::from_fn(|l| {
        Method::MoreauJean(MoreauJean {
            theta: 0.5 + 0.1 * l as f64,
        })
    });
    check::<Lanes<MoreauJean, 1>, Lanes<MoreauJean, 4>>(theta, dt, &starts, &force);
    let corrected = [Method::ContactStabilized(ContactStabilized); 4];
    check::<Lanes<ContactStabilized, 1>, Lanes<ContactStabilized, 4>>(
        corrected, dt, &starts, &force,
    );
}

#[test]
fn methods_need_a_mode_and_their_own_choice() {
    let none = || std::iter::empty::<ModeStart<1>>();
    let family = Method::Family(Coefficients::hht(-0.1));
    let theta = Method::MoreauJean(MoreauJean { theta: 0.5 });
    let at = |choice| start(choice, 0.1, 0.0, 0.0);
    assert!(Lanes::<Coefficients, 1>::new(&at(family), none()).is_none());
    assert!(Lanes::<Bathe, 1>::new(&at(Method::Bathe(Bathe)), none()).is_none());
    assert!(Lanes::<MoreauJean, 1>::new(&at(theta), none()).is_none());
    let one = || [mode(1.0, 1.0, 0.0, 0.0)].into_iter();
    assert!(Lanes::<Coefficients, 1>::new(&at(theta), one()).is_none());
    assert!(Lanes::<MoreauJean, 1>::new(&at(family), one()).is_none());
    let corrected = Method::ContactStabilized(ContactStabilized);
    assert!(Lanes::<ContactStabilized, 1>::new(&at(corrected), none()).is_none());
    assert!(Lanes::<ContactStabilized, 1>::new(&at(theta), one()).is_none());
}
