//! Random structures with any mixture of contacts.

use super::*;
use crate::contact::ClippedLine;

/// SplitMix64.
pub struct Random(pub u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub fn number(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn below(&mut self, count: usize) -> usize {
        (self.next() % count as u64) as usize
    }
}

fn signal(random: &mut Random) -> Signal {
    if random.below(2) == 0 {
        return sine(
            random.number(-1.0, 1.0),
            random.number(0.3, 5.0),
            random.number(0.0, 6.0),
        );
    }
    let mut t = -0.5;
    let drawn: Vec<[f64; 2]> = (0..6)
        .map(|_| {
            // Some points are jumps.
            t += if random.below(4) == 0 && t > 0.0 {
                0.0
            } else {
                random.number(0.1, 2.0)
            };
            [t, random.number(-1.0, 1.0)]
        })
        .collect();
    let points: Vec<[f64; 2]> = drawn
        .iter()
        .enumerate()
        .map(|(i, p)| {
            let before = drawn[..i].iter().filter(|q| q[0] == p[0]).count();
            [p[0] + (before / 2) as f64 * 0.01, p[1]]
        })
        .collect();
    table(&points)
}

fn limit(random: &mut Random) -> Limit {
    let constant = random.number(0.0, 1.0);
    match random.below(3) {
        0 => Limit::constant(constant),
        _ => Limit {
            varying: Some((random.number(0.0, 1.0), Arc::new(signal(random)))),
            ..Limit::constant(constant)
        },
    }
}

pub fn structure(random: &mut Random, rigid: bool) -> Structure {
    let n = 1 + random.below(5);
    let m: Vec<f64> = (0..n).map(|_| random.number(0.3, 3.0)).collect();
    let mut s = masses(&m);
    for i in 0..n {
        let to = if i == 0 || random.below(3) == 0 {
            None
        } else {
            Some(i - 1)
        };
        if random.below(5) > 0 {
            s = s.spring([to, Some(i)], random.number(0.5, 20.0));
        }
        if random.below(3) == 0 {
            s = s.dashpot([to, Some(i)], random.number(0.0, 1.0));
        }
    }
    let u: Vec<f64> = (0..n)
        .map(|_| {
            if random.below(3) == 0 {
                0.0
            } else {
                random.number(-0.1, 0.1)
            }
        })
        .collect();
    let v: Vec<f64> = (0..n)
        .map(|_| {
            if random.below(2) == 0 {
                0.0
            } else {
                random.number(-1.0, 1.0)
            }
        })
        .collect();
    s = s.moving(&u, &v);
    for _ in 0..random.below(3) {
        let pattern: Vec<(usize, f64)> = (0..n).map(|i| (i, random.number(-2.0, 2.0))).collect();
        let signal = signal(random);
        s = s.load(&pattern, signal);
    }
    for _ in 0..1 + random.below(4) {
        let j = random.below(n);
        let i = if j == 0 || random.below(2) == 0 {
            None
        } else {
            Some(random.below(j))
        };
        let law = match random.below(if rigid { 5 } else { 3 }) {
            0 => StructureLaw::new(
                ClippedLine::Spring {
                    stiffness: random.number(5.0, 500.0),
                },
                None,
            ),
            1 => StructureLaw::new(
                ClippedLine::Elastic {
                    stiffness: random.number(1.0, 100.0),
                },
                limit(random),
            ),
            2 => StructureLaw::new(
                ClippedLine::Viscous {
                    viscosity: random.number(0.3, 30.0),
                },
                limit(random),
            ),
            3 => StructureLaw::new(ClippedLine::Coulomb, limit(random)),
            _ => StructureLaw::new(
                ClippedLine::Stop {
                    restitution: if random.below(4) == 0 {
                        0.0
                    } else {
                        random.number(0.0, 1.0)
                    },
                },
                None,
            ),
        };
        let between = if random.below(2) == 0 {
            [i, Some(j)]
        } else {
            [Some(j), i]
        };
        s = s.contact(between, random.number(0.2, 0.4), law);
    }
    s
}

/// The largest violation of the laws in a state at time t.
fn violation(s: &Structure, t: f64, state: &State) -> f64 {
    let mut worst: f64 = 0.0;
    for (i, contact) in s.contacts.iter().enumerate() {
        let (r, rate, force) = (state.r[i], state.rate[i], state.force[i]);
        let limit = contact.law.limit().map_or(0.0, |limit| limit.at(t));
        let off = match contact.law.line() {
            Some(ClippedLine::Spring { stiffness }) => {
                (force - stiffness * r.min(0.0)).abs() / stiffness
            }
            Some(ClippedLine::Stop { .. }) => force.max(0.0).max(-r).max((force * r).abs()),
            Some(ClippedLine::Viscous { viscosity }) => {
                (force - (viscosity * rate).clamp(-limit, limit)).abs()
            }
            Some(ClippedLine::Elastic { .. }) => force.abs() - limit,
            None => unreachable!(),
            Some(ClippedLine::Coulomb) => {
                let over = force.abs() - limit;
                let slip = if rate.abs() > 1e-9 {
                    (force - limit.copysign(rate)).abs()
                } else {
                    0.0
                };
                over.max(slip)
            }
        };
        worst = worst.max(off);
    }
    worst
}

/// A structure with softened contacts only.
pub fn softened() -> Structure {
    structure(&mut Random(7), false)
}

#[test]
fn random_structures_obey_the_laws_and_keep_the_book() {
    for seed in 0..600 {
        let s = structure(&mut Random(seed), seed % 3 > 0);
        let times = steps(0.05, 200);
        let mut worst = 0.0_f64;
        let result = run(&s, &times, |i, state| {
            worst = worst.max(violation(&s, times[i], state));
        });
        let summary = result.unwrap();
        // The tolerance of events, over the largest energy or a force of 1 times a path of 1e-3.
        let largest = summary.book.largest.max(1e-3);
        assert!(summary.book.residual < 1e-12 * largest, "{seed}");
        assert!(worst < 1e-10, "{seed}: {worst}");
    }
}
