//! Contacts in a plane among others: the forces are the minimum of 1/2 S^T H S - S^T d over discs and intervals, which the conditions of
//! the minimum tell.

use super::*;
use crate::contact::coupled::tests::Random;

/// Rigid contacts: discs of these radii, two rows each, then intervals.
struct Rigid {
    discs: Vec<f64>,
    intervals: Vec<[f64; 2]>,
    own: Vec<f64>,
}

impl Rigid {
    fn rows(&self) -> usize {
        2 * self.discs.len() + self.intervals.len()
    }
}

impl Laws for Rigid {
    fn answer(&self, contact: usize, y: f64) -> f64 {
        let [low, high] = self.bounds(contact);
        (y / self.own[contact]).clamp(low, high)
    }

    fn compliance(&self, _: usize, _: f64, _: f64, _: f64) -> f64 {
        0.0
    }

    fn bounds(&self, contact: usize) -> [f64; 2] {
        self.intervals[contact - 2 * self.discs.len()]
    }

    fn is_plane(&self, contact: usize) -> bool {
        contact < 2 * self.discs.len() && contact.is_multiple_of(2)
    }

    fn answer_plane(&self, contact: usize, y: [f64; 2]) -> [f64; 2] {
        let limit = self.discs[contact / 2];
        let length = y[0].hypot(y[1]) / self.own[contact];
        let share = if length > limit { limit / length } else { 1.0 };
        y.map(|y| y / self.own[contact] * share)
    }

    fn directions(&self, contact: usize, y: [f64; 2], _: [f64; 2]) -> Directions {
        let (limit, length) = (self.discs[contact / 2], y[0].hypot(y[1]));
        match length > limit * self.own[contact] {
            true => Directions {
                along: y.map(|y| y / length),
                slopes: [f64::INFINITY, length / limit - self.own[contact]],
            },
            false => Directions {
                along: [1.0, 0.0],
                slopes: [0.0; 2],
            },
        }
    }
}

#[test]
fn forces_in_discs_meet_the_conditions_of_the_minimum() {
    let mut random = Random(5);
    let mut most = 0;
    for problem in 0..2000 {
        let (planes, others) = (1 + random.below(4), random.below(4));
        let rows = 2 * planes + others;
        // H = F^T F of some more rows than columns, with stiffness ratios up to 1e6.
        let mut scale: Vec<f64> = (0..rows).map(|_| random.decades(3.0)).collect();
        // The nodes of a disc move alike in both directions.
        (0..planes).for_each(|p| scale[2 * p + 1] = scale[2 * p]);
        let factor: Vec<f64> = (0..(rows + 2) * rows).map(|_| random.even()).collect();
        let h = |i: usize, j: usize| {
            let products = (0..rows + 2).map(|k| factor[k * rows + i] * factor[k * rows + j]);
            products.sum::<f64>() * scale[i] * scale[j]
        };
        let flexibility: Vec<f64> = (0..rows * rows).map(|ij| h(ij / rows, ij % rows)).collect();
        let first: Vec<usize> = (0..planes).map(|p| 2 * p).collect();
        let mut forces = CurvedForces::with_planes(flexibility.clone(), rows, &first);
        let laws = Rigid {
            discs: (0..planes).map(|_| random.decades(2.0)).collect(),
            intervals: (0..others)
                .map(|_| [-random.decades(2.0), random.decades(2.0)])
                .collect(),
            own: (0..rows).map(|i| forces.flexibility(i)).collect(),
        };
        assert_eq!(laws.rows(), rows);
        let mut force = vec![0.0; rows];
        // Loads that the contacts can hold, and loads that make them slide.
        let wanted: Vec<f64> = (0..rows)
            .map(|_| random.even() * random.decades(2.0))
            .collect();
        let times = |s: &[f64]| -> Vec<f64> {
            let row = |i: usize| flexibility[i * rows..(i + 1) * rows].iter().zip(s);
            (0..rows)
                .map(|i| row(i).map(|(h, s)| h * s).sum())
                .collect()
        };
        let d = times(&wanted);
        let size: Vec<f64> = d.iter().map(|d| d.abs()).collect();
        forces.solve(&d, &size, &laws, &mut force).unwrap();
        most = most.max(forces.steps());
        let held = times(&force);
        // q = d - H S, with the round-off of its terms: rows of a disc share theirs.
        let terms = |i: usize| -> f64 {
            let row = flexibility[i * rows..(i + 1) * rows].iter();
            row.zip(force.iter().zip(&wanted))
                .map(|(h, (s, w))| h.abs() * (s.abs() + w.abs()))
                .sum()
        };
        let q = |i: usize| d[i] - held[i];
        for p in 0..planes {
            let (i, limit) = (2 * p, laws.discs[p]);
            let (s, q) = ([force[i], force[i + 1]], [q(i), q(i + 1)]);
            let length = s[0].hypot(s[1]);
            let small = 1e-12 * (terms(i) + terms(i + 1));
            assert!(length <= limit * (1.0 + 1e-14), "{problem}");
            let across = (q[0] * s[1] - q[1] * s[0]) / length;
            let along = (q[0] * s[0] + q[1] * s[1]) / length;
            match length < limit * (1.0 - 1e-12) {
                true => assert!(q[0].hypot(q[1]) <= small, "{problem} {q:?} {small}"),
                false => assert!(across.abs() <= small && along >= -small, "{problem}"),
            }
        }
        for c in 0..others {
            let (i, [low, high]) = (2 * planes + c, laws.intervals[c]);
            let small = 1e-12 * terms(i);
            let right = match force[i] {
                s if s == low => q(i) <= small,
                s if s == high => q(i) >= -small,
                s => low < s && s < high && q(i).abs() <= small,
            };
            assert!(right, "{problem} {c} {}", q(i));
        }
    }
    // Newton's method: few steps.
    assert!(most <= 60, "{most}");
}

/// A disc and an interval in its first direction on one body: the interval is at its bound and the disc slides. Where both hold, nothing
/// tells their parts.
#[test]
fn a_disc_that_slides_beside_an_interval_has_one_answer() {
    let flexibility = vec![1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0];
    let mut forces = CurvedForces::with_planes(flexibility, 3, &[0]);
    let mut laws = Rigid {
        discs: vec![10.0],
        intervals: vec![[-5.0, 5.0]],
        own: (0..3).map(|i| forces.flexibility(i)).collect(),
    };
    let d = [30.0, 40.0, 30.0];
    let mut force = [0.0; 3];
    forces.solve(&d, &d, &laws, &mut force).unwrap();
    // Along what the interval leaves of d; some round-offs of d.
    let length = 25.0_f64.hypot(40.0);
    for (force, wanted) in force.iter().zip([250.0 / length, 400.0 / length, 5.0]) {
        assert!((force - wanted).abs() < 1e-13, "{force} {wanted}");
    }
    laws.discs[0] = 100.0;
    laws.intervals[0] = [-100.0, 100.0];
    let unsolved = forces.solve(&d, &d, &laws, &mut force);
    assert_eq!(unsolved, Err(Unsolved::Singular));
}
