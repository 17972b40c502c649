//! Impact of two bars by characteristics: d'Alembert's solution for any impedances, lengths and gap, and for a wall.
//!
//! Time is in T_I of the left bar, velocity in the closing speed c, force in F0 = c Z1 Z2/(Z1 + Z2), displacement in
//! c T_I/2. A free end would move with f_i(t); a contact force F takes its share d_i F off it, d_1 + d_2 = 1:
//!
//! ```text
//! v_1 = f_1 - d_1 F,   v_2 = f_2 + d_2 F,   rdot = f_2 - f_1 + F
//! f_1(t) = f_1(t - T_1) - 2 d_1 F(t - T_1),   f_2(t) = f_2(t - T_2) + 2 d_2 F(t - T_2)
//! ```
//!
//! with T_i the time to the free end and back. While the ends touch, F = f_1 - f_2 where that pushes, and rdot = 0.
//! Everything is constant between events, so events are found exactly: a front that arrives, or r reaching 0.

mod along;

use crate::history::History;
use std::collections::VecDeque;

/// Two instants closer than this are one: the round-off of sums of travel times.
const INSTANT: f64 = 1e-12;

/// What decides the motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bars {
    /// Z1/Z2, left over right; zero for a wall.
    pub impedance_ratio: f64,
    /// T_2/T_1, the right bar's travel time over the left's; of no account for a wall.
    pub time_ratio: f64,
    /// Gap at t = 0 over c T_I/2, >= 0.
    pub gap: f64,
}

/// The contact from one event to the next.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Piece {
    start: f64,
    displacement: f64,
    velocity: f64,
    force: f64,
    /// f_1 and f_2.
    free: [f64; 2],
}

/// A front on its way to the free end and back to the contact, where it changes f_i by `jump`.
#[derive(Debug, Clone, Copy)]
struct Front {
    arrival: f64,
    jump: f64,
}

/// The motion of the contact, and through it of the bars, from t = 0 to a given end.
#[derive(Debug, Clone)]
pub struct Wave {
    bars: Bars,
    pieces: Vec<Piece>,
}

/// The contact at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// r over c T_I/2.
    pub displacement: f64,
    /// rdot over c.
    pub velocity: f64,
    /// F over F0, >= 0.
    pub force: f64,
}

impl Bars {
    /// Whether there is no right bar.
    pub fn wall(&self) -> bool {
        self.impedance_ratio == 0.0
    }

    /// Velocities at t = 0 in the frame of their mean; of the wall for a wall.
    fn start(&self) -> [f64; 2] {
        if self.wall() { [1.0, 0.0] } else { [0.5, -0.5] }
    }

    /// d_i, the velocity that a force F0 takes from or gives to bar i.
    fn share(&self) -> [f64; 2] {
        let z = self.impedance_ratio;
        [1.0 / (1.0 + z), z / (1.0 + z)]
    }

    /// T_i, there and back.
    fn trip(&self) -> [f64; 2] {
        [1.0, self.time_ratio]
    }

    /// The motion up to t = `end`.
    pub fn solve(&self, end: f64) -> Wave {
        let trip = self.trip();
        // Profiles ask for fronts that are still to arrive: half a trip more.
        let end = end + 0.5 * trip[0].max(if self.wall() { 0.0 } else { trip[1] }) + INSTANT;
        Wave {
            bars: *self,
            pieces: self.pieces(end, |_| false),
        }
    }

    /// From the first touch until the ends part: the same for any gap; `None` where it is more than `most`.
    ///
    /// It can be longer than a force acts: equal bars of lengths 1 : 2 part a T_I after their force has ended.
    pub fn contact_duration(&self, most: f64) -> Option<f64> {
        let touching = Bars { gap: 0.0, ..*self };
        let parts = |piece: &Piece| piece.velocity > 0.0;
        let last = touching.pieces(most + INSTANT, parts).pop()?;
        parts(&last).then_some(last.start)
    }

    /// The pieces up to t = `end`, or to the first that is the `last`.
    fn pieces(&self, end: f64, last: impl Fn(&Piece) -> bool) -> Vec<Piece> {
        let (share, trip) = (self.share(), self.trip());
        let mut fronts: [VecDeque<Front>; 2] = Default::default();
        let mut now = Piece {
            start: 0.0,
            displacement: self.gap,
            velocity: 0.0,
            force: 0.0,
            free: self.start(),
        };
        let mut pieces: Vec<Piece> = Vec::new();
        let mut arrived = [0.0; 2];
        loop {
            let before = pieces.last().map_or(0.0, |piece| piece.force);
            (now.force, now.velocity) = contact(now.displacement, now.free);
            for (i, sign) in [(0, -2.0), (1, 2.0)] {
                // What has come in goes out again, with the force's share on it.
                let jump = arrived[i] + sign * share[i] * (now.force - before);
                if jump.abs() > INSTANT {
                    fronts[i].push_back(Front {
                        arrival: now.start + trip[i],
                        jump,
                    });
                }
            }
            pieces.push(now);
            if last(&now) {
                return pieces;
            }
            let arrival = fronts
                .iter()
                .filter_map(|queue| queue.front())
                .map(|front| front.arrival)
                .fold(f64::INFINITY, f64::min);
            let touch = if now.velocity < 0.0 {
                now.start - now.displacement / (2.0 * now.velocity)
            } else {
                f64::INFINITY
            };
            let next = arrival.min(touch);
            if next >= end {
                return pieces;
            }
            now.displacement = if touch <= arrival + INSTANT {
                0.0
            } else {
                now.displacement + 2.0 * now.velocity * (next - now.start)
            };
            now.start = next;
            for (i, queue) in fronts.iter_mut().enumerate() {
                arrived[i] = 0.0;
                let count = queue.partition_point(|front| front.arrival <= next + INSTANT);
                for front in queue.drain(..count) {
                    arrived[i] += front.jump;
                }
                now.free[i] += arrived[i];
            }
        }
    }
}

/// F and rdot for ends at distance `r` that would move with `free`.
fn contact(r: f64, free: [f64; 2]) -> (f64, f64) {
    let closing = free[0] - free[1];
    // What is left of sums of order 1 that cancel is round-off: ends that touch and move together.
    if r <= 0.0 && closing > INSTANT {
        (closing, 0.0)
    } else if r <= 0.0 && closing.abs() <= INSTANT {
        (0.0, 0.0)
    } else {
        (0.0, -closing)
    }
}

impl Wave {
    /// What decided the motion.
    pub fn bars(&self) -> &Bars {
        &self.bars
    }

    /// The contact at `t`, at a jump its right-hand limit.
    pub fn at(&self, t: f64) -> State {
        self.piece(t).state(t)
    }

    /// The contact at `t`, at a jump its left-hand limit.
    pub fn before(&self, t: f64) -> State {
        let after = self
            .pieces
            .partition_point(|piece| piece.start < t - INSTANT);
        match after.checked_sub(1) {
            Some(piece) => self.pieces[piece].state(t),
            // Before t = 0 the bars fly.
            None => State {
                displacement: self.bars.gap,
                velocity: -1.0,
                force: 0.0,
            },
        }
    }

    fn piece(&self, t: f64) -> &Piece {
        let after = self
            .pieces
            .partition_point(|piece| piece.start <= t + INSTANT);
        &self.pieces[after.max(1) - 1]
    }

    /// Shows the contact at rising times, each with its number: what [`Wave::at`] gives, and where a piece begins at
    /// that time, what [`Wave::before`] gives.
    pub fn walk(
        &self,
        times: impl Iterator<Item = f64>,
        mut show: impl FnMut(usize, State, Option<State>),
    ) {
        let mut begun = 0;
        for (i, t) in times.enumerate() {
            let later = &self.pieces[begun..];
            begun += later
                .iter()
                .take_while(|piece| piece.start <= t + INSTANT)
                .count();
            let piece = &self.pieces[begun.max(1) - 1];
            let jumps = piece.start >= t - INSTANT;
            show(i, piece.state(t), jumps.then(|| self.before(t)));
        }
    }

    /// The contact at these times, at a jump its right-hand limit.
    pub fn history(&self, times: &[f64]) -> History {
        let mut history = History::of_contact(times.len());
        for &t in times {
            let state = self.at(t);
            history.push(t, [state.displacement, state.velocity, state.force]);
        }
        history
    }

    /// The contact as a line to draw: at these times, rising, and on both sides of every jump between them.
    pub fn line(&self, times: &[f64]) -> History {
        let mut line = History::of_contact(times.len() + 2 * self.pieces.len());
        let mut push = |t: f64, state: State| {
            line.push(t, [state.displacement, state.velocity, state.force]);
        };
        let mut pieces = self.pieces.iter().peekable();
        for &t in times {
            while let Some(piece) = pieces.next_if(|piece| piece.start <= t) {
                push(piece.start, self.before(piece.start));
                push(piece.start, piece.state(piece.start));
            }
            push(t, self.at(t));
        }
        line
    }

    /// When the ends first touch.
    pub fn first_touch(&self) -> f64 {
        self.bars.gap * 0.5
    }

    /// When the force first ends, and when the ends first part; `None` where the run ends before.
    pub fn durations(&self) -> [Option<f64>; 2] {
        let first = |from: f64, what: &dyn Fn(&Piece) -> bool| {
            let found = self.pieces.iter().find(|p| p.start >= from && what(p));
            found.map(|piece| piece.start)
        };
        let touch = self.first_touch();
        [
            first(touch, &|p| p.displacement <= 0.0 && p.force == 0.0),
            first(touch, &|p| p.velocity > 0.0),
        ]
    }

    /// Impulse of the contact force from 0 to `t` over F0 T_I.
    pub fn impulse(&self, t: f64) -> f64 {
        let ends = self.pieces.iter().skip(1).map(|piece| piece.start);
        self.pieces
            .iter()
            .zip(ends.chain([f64::INFINITY]))
            .filter(|(piece, _)| piece.start < t)
            .map(|(piece, end)| piece.force * (end.min(t) - piece.start))
            .sum()
    }

    /// The largest contact force before `t` over F0.
    pub fn peak_force(&self, t: f64) -> f64 {
        let before = self.pieces.iter().take_while(|piece| piece.start < t);
        before.map(|piece| piece.force).fold(0.0, f64::max)
    }

    /// Relative velocity of the mass centres at `t` over c, positive where they move apart: the impulse F0 T_I J takes
    /// 2 d_1 J off the left bar's and gives 2 d_2 J/theta to the right one's, whose mass is theta d_1/d_2 of the left's.
    pub fn restitution(&self, t: f64) -> f64 {
        let [left, right] = self.bars.share();
        let right = if self.bars.wall() {
            0.0
        } else {
            right / self.bars.time_ratio
        };
        2.0 * (left + right) * self.impulse(t) - 1.0
    }
}

impl Piece {
    fn state(&self, t: f64) -> State {
        State {
            displacement: self.displacement + 2.0 * self.velocity * (t - self.start),
            velocity: self.velocity,
            force: self.force,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// z, theta, gap: like and unlike bars, touching and apart, ratios without common measure, walls.
    const CASES: [[f64; 3]; 8] = [
        [1.0, 1.0, 0.0],
        [1.0, 1.0, 0.3],
        [2.0, 1.0, 0.0],
        [1.0, 2.0, 0.1],
        [0.4, 0.37, 0.25],
        [3.0, 1.7, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 1.0, 0.21],
    ];

    const END: f64 = 6.0;

    /// Each case with its shares d_i and trips T_i, written out again, and how many bars there are.
    fn each(check: impl Fn(&Wave, [f64; 2], [f64; 2], usize)) {
        for [z, theta, gap] in CASES {
            let bars = Bars {
                impedance_ratio: z,
                time_ratio: theta,
                gap,
            };
            let count = if z == 0.0 { 1 } else { 2 };
            let share = [1.0 / (1.0 + z), z / (1.0 + z)];
            check(&bars.solve(END), share, [1.0, theta], count);
        }
    }

    /// Times that meet no event of any case: multiples of an irrational number.
    fn times() -> impl Iterator<Item = f64> {
        (0..400).map(|i| f64::from(i) * 0.0141421356 + 1e-4)
    }

    /// Sums of a few numbers of order 1 that were themselves summed along the fronts.
    const ROUND_OFF: f64 = 1e-13;

    #[test]
    fn two_like_bars_and_a_wall_are_as_every_textbook_has_them() {
        let wave = |z, gap| {
            Bars {
                impedance_ratio: z,
                time_ratio: 1.0,
                gap,
            }
            .solve(3.0)
        };
        for z in [0.0, 1.0] {
            for gap in [0.0, 0.5] {
                let (wave, touch) = (wave(z, gap), 0.5 * gap);
                for (t, r, rdot, force) in [
                    (0.5 * touch, 0.5 * gap, -1.0, 0.0),
                    (touch + 0.5, 0.0, 0.0, 1.0),
                    (touch + 1.25, 0.5, 1.0, 0.0),
                ] {
                    let state = State {
                        displacement: r,
                        velocity: rdot,
                        force,
                    };
                    if t > 0.0 {
                        assert_eq!(wave.at(t), state, "z = {z}, gap = {gap}, t = {t}");
                    }
                }
                assert_eq!(wave.durations(), [Some(touch + 1.0); 2]);
                assert_eq!(wave.impulse(touch + 0.25), 0.25);
                assert_eq!(wave.impulse(3.0), 1.0);
            }
        }
    }

    #[test]
    fn each_side_of_a_jump_has_its_own_limit() {
        let wave = Bars {
            impedance_ratio: 1.0,
            time_ratio: 1.0,
            gap: 0.5,
        }
        .solve(2.0);
        for (t, before, after) in [(0.25, -1.0, 0.0), (1.25, 0.0, 1.0)] {
            assert_eq!(
                (wave.before(t).velocity, wave.at(t).velocity),
                (before, after)
            );
            // Not so elsewhere.
            assert_eq!(wave.before(t + 0.1), wave.at(t + 0.1));
        }
        assert_eq!(wave.before(0.0).velocity, -1.0);
        // The line has both sides of both jumps, at t = 1/4 where a time falls on one and at 5/4 where none does.
        let line = wave.line(&[0.0, 0.25, 1.0, 2.0]);
        assert!(line.time.is_sorted());
        for jump in [0.25, 1.25] {
            let at: Vec<f64> = (0..line.len())
                .filter(|&i| line.time[i] == jump)
                .map(|i| line.velocity()[i])
                .collect();
            assert_eq!(
                at[..2],
                [wave.before(jump).velocity, wave.at(jump).velocity]
            );
        }
    }

    #[test]
    fn contact_obeys_the_bars_and_never_pulls() {
        each(|wave, share, trip, count| {
            for t in times() {
                let (
                    State {
                        displacement,
                        velocity,
                        force,
                    },
                    free,
                ) = (wave.at(t), wave.piece(t).free);
                let rdot = free[1] + share[1] * force - (free[0] - share[0] * force);
                assert!((velocity - rdot).abs() < ROUND_OFF);
                assert!(force >= 0.0 && displacement >= -ROUND_OFF);
                // Force only while they touch and stay so.
                assert!(
                    force * displacement.abs() < ROUND_OFF && force * velocity.abs() < ROUND_OFF
                );
                for i in 0..count {
                    let back = t - trip[i];
                    if back > 0.0 {
                        let was = wave.piece(back);
                        let sign = [-2.0, 2.0][i];
                        let delayed = was.free[i] + sign * share[i] * was.force;
                        assert!((free[i] - delayed).abs() < ROUND_OFF, "t = {t}, bar {i}");
                    }
                }
                // r is continuous and the integral of 2 rdot: exactly so within a piece and across its end.
                let step = 1e-5;
                if wave.before(t + step).velocity == velocity {
                    let moved = wave.at(t + step).displacement - displacement;
                    assert!((moved - 2.0 * velocity * step).abs() < ROUND_OFF);
                }
            }
            for piece in &wave.pieces[1..] {
                let gap = wave.at(piece.start).displacement - wave.before(piece.start).displacement;
                assert!(gap.abs() < ROUND_OFF);
            }
        });
    }

    #[test]
    fn profiles_keep_energy_and_momentum() {
        // Z_i is as 1/d_i; a length's energy is as Z_i T_i (v^2 + (d_i sigma)^2), its momentum as Z_i T_i v.
        each(|wave, share, trip, count| {
            let sums = |t: f64| {
                let (mut energy, mut momentum) = (0.0, 0.0);
                for i in 0..count {
                    for pair in wave.profile(i, t).chunks(2) {
                        let [[from, v, sigma], [to, ..]] = [pair[0], pair[1]];
                        let weight = trip[i] / share[i] * (to - from);
                        energy += weight * (v * v + share[i] * share[i] * sigma * sigma);
                        momentum += weight * v;
                    }
                }
                (energy, momentum)
            };
            let (energy, momentum) = sums(0.0);
            for t in times() {
                let (e, p) = sums(t);
                assert!((e / energy - 1.0).abs() < 1e-11, "t = {t}: {e} {energy}");
                if count == 2 {
                    assert!((p - momentum).abs() < 1e-11 * energy, "t = {t}");
                }
            }
        });
    }

    #[test]
    fn fronts_travel_with_c0_and_jump_by_the_impedance() {
        each(|wave, share, trip, count| {
            for t in times() {
                for i in 0..count {
                    let profile = wave.profile(i, t);
                    let (first, last) = (profile[0], profile[profile.len() - 1]);
                    assert_eq!((first[0], last[0]), (0.0, 1.0));
                    assert!(last[2].abs() < ROUND_OFF, "the free end carries no stress");
                    let contact = wave.at(t);
                    assert!((first[2] + contact.force).abs() < ROUND_OFF);
                    let end = wave.piece(t).free[i] + [-1.0, 1.0][i] * share[i] * contact.force;
                    assert!((first[1] - end).abs() < ROUND_OFF);
                    for pair in profile[1..profile.len() - 1].chunks(2) {
                        let [[s, v0, sigma0], [_, v1, sigma1]] = [pair[0], pair[1]];
                        // Where the front stands 1e-6 later tells where it goes.
                        let way = 1e-6 / (0.5 * trip[i]);
                        let later = wave.profile(i, t + 1e-6);
                        let goes = |to: f64| later.iter().any(|c| (c[0] - to).abs() < 1e-3 * way);
                        let (out, back) = (goes(s + way), goes(s - way));
                        assert!(out || back || !(way..1.0 - way).contains(&s));
                        if out != back {
                            // Away from the contact the force is -Z v to the right and Z v to the left.
                            let sign = if out { -1.0 } else { 1.0 } * [-1.0, 1.0][i];
                            let jump = share[i] * (sigma1 - sigma0) - sign * (v1 - v0);
                            assert!(jump.abs() < ROUND_OFF, "t = {t}, s = {s}: {jump}");
                        }
                        let [v, sigma] = wave.inside(i, s - 1e-6, t);
                        assert_eq!([v, sigma], [v0, sigma0]);
                    }
                }
            }
        });
    }

    #[test]
    fn fronts_stand_at_an_end_when_they_reach_it() {
        // Like bars that touch at t = 0: one front in each, to the free end by T_I/2 and back by T_I, then none.
        let like = Bars {
            impedance_ratio: 1.0,
            time_ratio: 1.0,
            gap: 0.0,
        };
        let wave = like.solve(1.5);
        for (t, place) in [
            (0.0, Some(0.0)),
            (0.125, Some(0.25)),
            (0.49, Some(0.98)),
            (0.5, Some(1.0)),
            (0.51, Some(0.98)),
            (0.75, Some(0.5)),
            (1.0, Some(0.0)),
            (1.2, None),
        ] {
            for i in [0, 1] {
                let fronts = wave.fronts(i, t);
                match place {
                    Some(place) => assert!(
                        !fronts.is_empty() && fronts.iter().all(|s| (s - place).abs() < ROUND_OFF),
                        "t = {t}: {fronts:?}"
                    ),
                    None => assert!(fronts.is_empty(), "t = {t}: {fronts:?}"),
                }
            }
        }
    }

    #[test]
    fn every_jump_of_a_profile_is_a_front_and_every_front_inside_is_a_jump() {
        each(|wave, _, _, count| {
            for (t, i) in times().flat_map(|t| (0..count).map(move |i| (t, i))) {
                let line = wave.profile(i, t);
                let inside = line[1..line.len() - 1].chunks(2);
                let jumps: Vec<f64> = inside
                    .filter(|pair| {
                        (pair[0][1] - pair[1][1]).abs() + (pair[0][2] - pair[1][2]).abs() > 1e-9
                    })
                    .map(|pair| pair[0][0])
                    .collect();
                let fronts = wave.fronts(i, t);
                let near = |all: &[f64], s: f64| all.iter().any(|x| (x - s).abs() < 1e-9);
                for s in &jumps {
                    assert!(near(&fronts, *s), "t = {t}, s = {s}: {fronts:?}");
                }
                for s in fronts
                    .into_iter()
                    .filter(|s| (1e-9..1.0 - 1e-9).contains(s))
                {
                    assert!(near(&jumps, s), "t = {t}, s = {s}: {jumps:?}");
                }
            }
        });
    }
}
