//! Distance of two loops by their shape.

use crate::metrics::structure::extent;

/// Number of pieces of equal length into which a loop is divided.
const PIECES: usize = 400;

/// Pieces side by side: a search takes 20 000 distances of loops.
const LANES: usize = 8;

/// Distance of the shapes of two loops, each of a displacement and a force, in half ranges of the measured one: no time counts.
///
/// Modified Hausdorff distance (Dubuisson and Jain, 12th International Conference on Pattern Recognition, 1994): the mean distance of the
/// points of a loop from the other loop, the larger one of the two. The points are 401 at equal distances along the loop, the other
/// loop is the line through its 401 points. `None` if a measured half range is 0, or a loop is a point.
pub fn loop_distance(c: [&[f64]; 2], m: [&[f64]; 2]) -> Option<f64> {
    let sizes = m.map(|x| {
        let [low, high] = extent(x);
        0.5 * (high - low)
    });
    if !sizes.iter().all(|size| *size > 0.0 && size.is_finite()) {
        return None;
    }
    let points = |[x, y]: [&[f64]; 2]| -> Vec<[f64; 2]> {
        let pairs = x.iter().zip(y);
        pairs.map(|(x, y)| [x / sizes[0], y / sizes[1]]).collect()
    };
    let (c, m) = (even(&points(c))?, even(&points(m))?);
    let [from_m, from_c] = [
        Pieces::of(&m).mean_distance(&c),
        Pieces::of(&c).mean_distance(&m),
    ];
    Some(from_m.max(from_c))
}

/// Points of a line at equal distances along it; `None` without a length.
fn even(line: &[[f64; 2]]) -> Option<Vec<[f64; 2]>> {
    let mut at = vec![0.0];
    for pair in line.windows(2) {
        at.push(at[at.len() - 1] + distance(pair[0], pair[1]));
    }
    let length = at[at.len() - 1];
    if !(length > 0.0 && length.is_finite()) {
        return None;
    }
    let mut before = 0;
    let point = |k: usize| {
        let s = length * (k as f64 / PIECES as f64);
        while before + 2 < at.len() && at[before + 1] < s {
            before += 1;
        }
        let piece = at[before + 1] - at[before];
        let share = if piece > 0.0 {
            ((s - at[before]) / piece).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let [a, b] = [line[before], line[before + 1]];
        [0, 1].map(|i| a[i] + share * (b[i] - a[i]))
    };
    Some((0..=PIECES).map(point).collect())
}

/// Pieces of a line side by side.
struct Pieces(Vec<[[f64; LANES]; 5]>);

impl Pieces {
    /// x and y of the beginning of each piece, of its way to its end, and 1 over the square of its length; 0 without length.
    fn of(line: &[[f64; 2]]) -> Pieces {
        let mut groups = vec![[[0.0; LANES]; 5]; PIECES / LANES];
        for (i, pair) in line.windows(2).enumerate() {
            let [a, b] = [pair[0], pair[1]];
            let [x, y] = [b[0] - a[0], b[1] - a[1]];
            let square = x * x + y * y;
            let inverse = if square > 0.0 { 1.0 / square } else { 0.0 };
            for (numbers, number) in groups[i / LANES]
                .iter_mut()
                .zip([a[0], a[1], x, y, inverse])
            {
                numbers[i % LANES] = number;
            }
        }
        Pieces(groups)
    }

    /// Mean distance of points from the line.
    fn mean_distance(&self, points: &[[f64; 2]]) -> f64 {
        let sum: f64 = points.iter().map(|point| self.distance(*point)).sum();
        sum / points.len() as f64
    }

    /// Distance of a point from the nearest piece.
    fn distance(&self, point: [f64; 2]) -> f64 {
        let mut nearest = [f64::INFINITY; LANES];
        for [x, y, along, up, inverse] in &self.0 {
            for l in 0..LANES {
                let [dx, dy] = [point[0] - x[l], point[1] - y[l]];
                let share = ((dx * along[l] + dy * up[l]) * inverse[l]).clamp(0.0, 1.0);
                let [dx, dy] = [dx - share * along[l], dy - share * up[l]];
                let square = dx * dx + dy * dy;
                nearest[l] = if square < nearest[l] {
                    square
                } else {
                    nearest[l]
                };
            }
        }
        nearest.into_iter().fold(f64::INFINITY, f64::min).sqrt()
    }
}

/// Distance of two points.
fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let [x, y] = [b[0] - a[0], b[1] - a[1]];
    (x * x + y * y).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// A closed square of side 2 about (x, y), in `pieces` a side, from its corner `first` on.
    fn square(x: f64, y: f64, pieces: usize, first: usize) -> [Vec<f64>; 2] {
        let corners = [[-1.0, -1.0], [-1.0, 1.0], [1.0, 1.0], [1.0, -1.0]];
        let point = |k: usize| {
            let (side, share) = (first + k / pieces, (k % pieces) as f64 / pieces as f64);
            let [a, b] = [side, side + 1].map(|i| corners[i % 4]);
            [
                x + a[0] + share * (b[0] - a[0]),
                y + a[1] + share * (b[1] - a[1]),
            ]
        };
        let points: Vec<[f64; 2]> = (0..=4 * pieces).map(point).collect();
        [0, 1].map(|i| points.iter().map(|point| point[i]).collect())
    }

    fn of(c: &[Vec<f64>; 2], m: &[Vec<f64>; 2]) -> f64 {
        loop_distance([&c[0], &c[1]], [&m[0], &m[1]]).unwrap()
    }

    #[test]
    fn shifted_squares_are_half_the_shift_apart() {
        // Of a square that is shifted by d < 1 along a side, the side ahead is d away, the one behind d except for its ends, where it
        // is min(d, distance of the corner), and the others are 0 except for the part ahead: (2 d + (2 d - d^2) + d^2)/8 = d/2.
        for d in [0.02, 0.25, 0.8] {
            let m = square(0.0, 0.0, 1, 0);
            for c in [square(d, 0.0, 1, 0), square(0.0, -d, 3, 2)] {
                let distance = of(&c, &m);
                // A sum of 401 points instead of an integral, with the first corner twice: one in 400 of the distances.
                assert!(
                    (distance - 0.5 * d).abs() < 0.5 * d / 400.0,
                    "{d}: {distance}"
                );
            }
        }
    }

    #[test]
    fn time_direction_and_units_do_not_count() {
        let m = square(0.0, 0.0, 1, 0);
        // The same square, with other points and from another corner on.
        assert!(of(&square(0.0, 0.0, 17, 3), &m) < 1e-15);
        let [mut r, mut s] = square(0.0, 0.0, 17, 3);
        r.reverse();
        s.reverse();
        assert!(of(&[r, s], &m) < 1e-15);
        // Standing still adds no length.
        let still = m.clone().map(|x| x.iter().flat_map(|x| [*x, *x]).collect());
        assert_eq!(of(&still, &m), 0.0);
        let c = square(0.3, 0.1, 1, 0);
        let scaled = |of: &[Vec<f64>; 2]| -> [Vec<f64>; 2] {
            [0, 1].map(|i| of[i].iter().map(|x| x * [1024.0, 0.25][i]).collect())
        };
        // Powers of two do not round.
        assert_eq!(of(&scaled(&c), &scaled(&m)), of(&c, &m));
        for flat in [[vec![1.0; 3], vec![0.0, 1.0, 2.0]], [vec![], vec![]]] {
            assert_eq!(loop_distance([&c[0], &c[1]], [&flat[0], &flat[1]]), None);
        }
        let point = [vec![1.0; 3], vec![1.0; 3]];
        assert_eq!(loop_distance([&point[0], &point[1]], [&m[0], &m[1]]), None);
    }

    #[test]
    fn an_ellipse_is_as_far_as_its_radius_differs() {
        // A measured circle in half ranges, and one with 1.1 times the radius: 0.1 everywhere, from both sides.
        let circle = |a: f64| -> [Vec<f64>; 2] {
            let angles: Vec<f64> = (0..=4000)
                .map(|i| 2.0 * PI * f64::from(i) / 4000.0)
                .collect();
            [
                angles.iter().map(|t| 5.0 * a * t.cos()).collect(),
                angles.iter().map(|t| 300.0 * a * t.sin()).collect(),
            ]
        };
        // A chord of 1/400 of a circle is at most (2 pi/400)^2/8 = 3.1e-5 within it.
        assert!((of(&circle(1.1), &circle(1.0)) - 0.1).abs() < 3.1e-5);
    }

    #[test]
    fn pieces_side_by_side_have_the_distances_of_each() {
        // A curve that crosses itself, against the distances from one piece after the other, by the angle at its ends.
        let curve = |a: f64, b: f64| -> Vec<[f64; 2]> {
            let angles = (0..=900).map(|i| 2.0 * PI * f64::from(i) / 900.0);
            angles
                .map(|t| [(a * t).sin(), (b * t + 0.3).cos()])
                .collect()
        };
        let (c, m) = (
            even(&curve(3.0, 2.0)).unwrap(),
            even(&curve(5.0, 4.0)).unwrap(),
        );
        let pieces = Pieces::of(&m);
        for point in &c {
            let from_piece = |pair: &[[f64; 2]]| {
                let [a, b] = [pair[0], pair[1]];
                let [to_a, to_b, length] =
                    [distance(*point, a), distance(*point, b), distance(a, b)];
                let is_beside = (to_a * to_a - to_b * to_b).abs() < length * length;
                // Twice the area of the triangle over its base.
                let area = (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0]);
                if is_beside {
                    area.abs() / length
                } else {
                    to_a.min(to_b)
                }
            };
            let least = m.windows(2).map(from_piece).fold(f64::INFINITY, f64::min);
            assert!((pieces.distance(*point) - least).abs() < 1e-13);
        }
    }
}
