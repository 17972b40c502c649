//! Contours of a field on a grid by marching squares, as closed rings that can be filled one after the other.
//!
//! Outside the grid and where a value is missing the field counts as low, so that every ring closes. A ring that has the
//! high side on its left runs counter-clockwise round a rise and clockwise round a hollow; painted by falling area, each
//! in the colour of the band just inside, rings give the filled map for any nesting.

/// Values over a grid.
#[derive(Debug, Clone)]
pub struct Field {
    /// Places along x, rising, evenly scaled.
    pub x: Vec<f64>,
    /// Places along y, rising, evenly scaled.
    pub y: Vec<f64>,
    /// One value a place, y fastest; NaN where there is none.
    pub z: Vec<f64>,
}

/// A closed contour.
#[derive(Debug, Clone, PartialEq)]
pub struct Ring {
    /// Number of the level.
    pub level: usize,
    /// Points; the last is joined to the first.
    pub points: Vec<[f64; 2]>,
    /// For each point, whether it is between two values, and not at the edge of the known values.
    pub real: Vec<bool>,
    /// Area, negative round a hollow.
    pub area: f64,
}

/// How far outside the grid rings close, over its size.
const OUTSIDE: f64 = 1e-3;

impl Field {
    /// The rings of all levels, by falling area.
    pub fn rings(&self, levels: &[f64]) -> Vec<Ring> {
        let mut rings: Vec<Ring> = Vec::new();
        for (level, at) in levels.iter().enumerate() {
            rings.extend(self.closed(level, *at));
        }
        rings.sort_by(|a, b| b.area.abs().total_cmp(&a.area.abs()));
        rings
    }

    /// Nodes of the grid with one more on every side.
    fn size(&self) -> [usize; 2] {
        [self.x.len() + 2, self.y.len() + 2]
    }

    fn value(&self, [i, j]: [usize; 2]) -> f64 {
        let [nx, ny] = self.size();
        if i == 0 || j == 0 || i + 1 == nx || j + 1 == ny {
            return f64::NAN;
        }
        self.z[(i - 1) * self.y.len() + j - 1]
    }

    fn node(&self, [i, j]: [usize; 2]) -> [f64; 2] {
        let along = |places: &[f64], k: usize| {
            let (first, last) = (places[0], places[places.len() - 1]);
            let out = OUTSIDE * (last - first);
            match k {
                0 => first - out,
                k if k > places.len() => last + out,
                k => places[k - 1],
            }
        };
        [along(&self.x, i), along(&self.y, j)]
    }

    fn closed(&self, level: usize, at: f64) -> Vec<Ring> {
        let [nx, ny] = self.size();
        let high = |node| self.value(node) >= at;
        // An edge of the grid by its lower node, along x or y; from each the contour goes on to one other.
        let edge = |a: [usize; 2], b: [usize; 2]| {
            let low = a.min(b);
            2 * (low[0] * ny + low[1]) + usize::from(a[0] == b[0])
        };
        const NOWHERE: usize = usize::MAX;
        let mut next = vec![NOWHERE; 2 * nx * ny];
        for i in 0..nx - 1 {
            for j in 0..ny - 1 {
                let corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
                let inside = corners.map(high);
                // Edges of the square where its high part, seen counter-clockwise, ends and begins again.
                let turn = |k: usize| (inside[k], inside[(k + 1) % 4]);
                let id = |k: usize| edge(corners[k], corners[(k + 1) % 4]);
                let ends = (0..4).filter(|k| turn(*k) == (true, false));
                for end in ends {
                    let ahead = (1..4).map(|s| (end + s) % 4);
                    let mut begins = ahead.filter(|k| turn(*k) == (false, true));
                    let saddle = inside[0] == inside[2] && inside[1] == inside[3];
                    let joined = {
                        let middle = corners.map(|c| self.value(c)).iter().sum::<f64>() / 4.0;
                        middle >= at
                    };
                    let begin = match saddle && !joined {
                        true => begins.next_back(),
                        false => begins.next(),
                    };
                    if let Some(begin) = begin {
                        next[id(end)] = id(begin);
                    }
                }
            }
        }
        let mut rings = Vec::new();
        for start in 0..next.len() {
            let mut points = Vec::new();
            let mut real = Vec::new();
            let mut now = start;
            while next[now] != NOWHERE {
                let (point, between) = self.crossing(now, at);
                points.push(point);
                real.push(between);
                now = std::mem::replace(&mut next[now], NOWHERE);
            }
            if points.len() > 2 {
                let area = area(&points);
                rings.push(Ring {
                    level,
                    points,
                    real,
                    area,
                });
            }
        }
        rings
    }

    /// Where the field passes a level on an edge, and whether both ends of the edge have a value.
    fn crossing(&self, edge: usize, at: f64) -> ([f64; 2], bool) {
        let ny = self.size()[1];
        let low = [edge / 2 / ny, edge / 2 % ny];
        let high = match edge % 2 {
            0 => [low[0] + 1, low[1]],
            _ => [low[0], low[1] + 1],
        };
        let (a, b) = (self.value(low), self.value(high));
        let between = !a.is_nan() && !b.is_nan();
        let part = if between { (at - a) / (b - a) } else { 0.5 };
        let (from, to) = (self.node(low), self.node(high));
        let point = [0, 1].map(|k| from[k] + part * (to[k] - from[k]));
        (point, between)
    }
}

fn area(points: &[[f64; 2]]) -> f64 {
    let following = points.iter().cycle().skip(1);
    let twice = points
        .iter()
        .zip(following)
        .map(|(a, b)| a[0] * b[1] - b[0] * a[1]);
    0.5 * twice.sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn field(count: usize, of: impl Fn(f64, f64) -> f64) -> Field {
        let places: Vec<f64> = (0..count).map(|i| i as f64 / (count - 1) as f64).collect();
        let z = places
            .iter()
            .flat_map(|x| places.iter().map(|y| of(*x, *y)))
            .collect();
        Field {
            x: places.clone(),
            y: places,
            z,
        }
    }

    #[test]
    fn a_plane_has_straight_contours() {
        let rings = field(11, |x, y| x + 2.0 * y).rings(&[1.1]);
        let [ring] = rings.as_slice() else {
            panic!("{rings:?}")
        };
        let on_line = ring
            .points
            .iter()
            .zip(&ring.real)
            .filter(|(_, real)| **real);
        for ([x, y], _) in on_line {
            assert!((x + 2.0 * y - 1.1).abs() < 1e-12);
        }
        // The part above the line, but for the narrow rim: 1 - (0.55 + 0.05)/2.
        assert!((ring.area - 0.7).abs() < 3e-3, "{}", ring.area);
    }

    #[test]
    fn rises_and_hollows_turn_their_own_way_and_lie_in_order() {
        let bump = |x: f64, y: f64| -((x - 0.5).powi(2) + (y - 0.5).powi(2)).sqrt();
        let rings = field(41, bump).rings(&[-0.4, -0.2]);
        let areas: Vec<f64> = rings.iter().map(|ring| ring.area).collect();
        let pi = std::f64::consts::PI;
        // Chords of a circle, and a kinked field between nodes: some thousandths.
        assert!(
            (areas[0] - 0.16 * pi).abs() < 4e-3 && (areas[1] - 0.04 * pi).abs() < 2e-3,
            "{areas:?}"
        );
        let hollow = field(41, |x, y| -bump(x, y)).rings(&[0.2]);
        assert_eq!(hollow.len(), 2);
        assert!((hollow[0].area - 1.0).abs() < 5e-3 && (hollow[1].area + 0.04 * pi).abs() < 2e-3);
    }

    #[test]
    fn saddles_and_gaps_close() {
        for sign in [1.0, -1.0] {
            let saddle = field(8, |x, y| sign * (x - 0.45) * (y - 0.52));
            let whole: f64 = saddle.rings(&[0.0]).iter().map(|ring| ring.area).sum();
            let other = field(8, |x, y| -sign * (x - 0.45) * (y - 0.52));
            let rest: f64 = other.rings(&[0.0]).iter().map(|ring| ring.area).sum();
            // High and low part make the square and its rim, counted twice.
            assert!((whole + rest - 1.0).abs() < 5e-3, "{whole} {rest}");
        }
        let mut gap = field(6, |x, _| x);
        gap.z[14] = f64::NAN;
        let rings = gap.rings(&[-1.0]);
        assert_eq!(rings.len(), 2);
        assert!(rings[1].area < 0.0 && rings[1].real.iter().all(|real| !real));
    }
}
