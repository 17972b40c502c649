//! Clips lines and areas at a frame, and cuts lines into dashes.

use crate::layout::sheet::Rect;

/// A line through points.
pub type Line = Vec<[f64; 2]>;

/// The parts of a line inside a frame; a point that is not finite breaks the line.
pub fn inside(points: &[[f64; 2]], frame: &Rect) -> Vec<Line> {
    let mut lines: Vec<Line> = Vec::new();
    for pair in points.windows(2) {
        let Some([from, to]) = segment(pair[0], pair[1], frame) else {
            continue;
        };
        match lines.last_mut() {
            Some(line) if line.last() == Some(&from) && from == pair[0] => line.push(to),
            _ => lines.push(vec![from, to]),
        }
    }
    lines
}

/// The part of a segment inside a frame (Liang and Barsky).
pub fn segment(a: [f64; 2], b: [f64; 2], frame: &Rect) -> Option<[[f64; 2]; 2]> {
    if ![a[0], a[1], b[0], b[1]].iter().all(|v| v.is_finite()) {
        return None;
    }
    let low = [frame.left, frame.top];
    let high = [frame.right(), frame.bottom()];
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for k in 0..2 {
        let d = b[k] - a[k];
        if d == 0.0 {
            if a[k] < low[k] || a[k] > high[k] {
                return None;
            }
            continue;
        }
        let (first, second) = ((low[k] - a[k]) / d, (high[k] - a[k]) / d);
        enter = enter.max(first.min(second));
        leave = leave.min(first.max(second));
    }
    let at = |t: f64| [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
    (enter <= leave).then(|| {
        // The given ends without rounding, so that neighbours join.
        let from = if enter == 0.0 { a } else { at(enter) };
        let to = if leave == 1.0 { b } else { at(leave) };
        [from, to]
    })
}

/// The part of an area inside a frame (Sutherland and Hodgman); all corners are finite.
pub fn polygon(corners: &[[f64; 2]], frame: &Rect) -> Line {
    let sides = [
        (0, frame.left, 1.0),
        (0, frame.right(), -1.0),
        (1, frame.top, 1.0),
        (1, frame.bottom(), -1.0),
    ];
    let mut kept = corners.to_vec();
    for (k, at, sign) in sides {
        let corners = std::mem::take(&mut kept);
        let Some(mut before) = corners.last().copied() else {
            break;
        };
        for corner in corners {
            let [a, b] = [before, corner].map(|p: [f64; 2]| sign * (p[k] - at));
            if (a < 0.0) != (b < 0.0) {
                let t = a / (a - b);
                let mut cut = [0, 1].map(|j| before[j] + t * (corner[j] - before[j]));
                cut[k] = at;
                kept.push(cut);
            }
            if b >= 0.0 {
                kept.push(corner);
            }
            before = corner;
        }
    }
    kept
}

/// A line cut into the dashes of a pattern (lengths of line and gap in turn); complete for an empty pattern.
pub fn dashes(line: &[[f64; 2]], pattern: &[f64]) -> Vec<Line> {
    if pattern.is_empty() {
        return vec![line.to_vec()];
    }
    let mut dashes = Vec::new();
    let mut dash: Line = line.first().copied().into_iter().collect();
    let mut turn = 0;
    let mut left = pattern[0];
    for pair in line.windows(2) {
        let [a, b] = [pair[0], pair[1]];
        let length = libm::hypot(b[0] - a[0], b[1] - a[1]);
        let mut done = 0.0;
        while length - done > left {
            done += left;
            let t = done / length;
            let cut = [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
            if turn % 2 == 0 {
                dash.push(cut);
                dashes.push(std::mem::take(&mut dash));
            } else {
                dash = vec![cut];
            }
            turn += 1;
            left = pattern[turn % pattern.len()];
        }
        left -= length - done;
        if turn % 2 == 0 {
            dash.push(b);
        }
    }
    if dash.len() > 1 {
        dashes.push(dash);
    }
    dashes
}

/// The parts of lines between these lengths along them, which rise; a line goes on in length where the one before ends.
pub fn between(lines: &[Line], parts: &[[f64; 2]]) -> Vec<Line> {
    let mut found = Vec::new();
    let (mut next, mut reached) = (0, 0.0);
    for line in lines {
        let mut piece: Line = Vec::new();
        for pair in line.windows(2) {
            let [a, b] = [pair[0], pair[1]];
            let (start, length) = (reached, libm::hypot(b[0] - a[0], b[1] - a[1]));
            reached += length;
            let at = |s: f64| [0, 1].map(|k| a[k] + (s - start) / length * (b[k] - a[k]));
            while let Some([from, to]) = parts.get(next).filter(|[from, _]| *from < reached) {
                if piece.is_empty() {
                    piece.push(if *from > start { at(*from) } else { a });
                }
                if *to >= reached {
                    piece.push(b);
                    break;
                }
                // A part may end where the segment before it does.
                if *to > start {
                    piece.push(at(*to));
                }
                found.push(std::mem::take(&mut piece));
                next += 1;
            }
        }
        found.push(piece);
    }
    found.retain(|piece| piece.len() > 1);
    found
}

/// Parallel lines over an area: `a x + b y` is a multiple of `spacing` along each; all corners are finite.
pub fn hatching(corners: &[[f64; 2]], [a, b]: [f64; 2], spacing: f64) -> Vec<[[f64; 2]; 2]> {
    let across = |p: [f64; 2]| (a * p[0] + b * p[1]) / spacing;
    let along = |p: [f64; 2]| a * p[1] - b * p[0];
    let sides = || corners.iter().zip(corners.iter().cycle().skip(1));
    let ends = corners.iter().map(|p| across(*p));
    let [low, high] = ends.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| {
        [low.min(x), high.max(x)]
    });
    let mut lines = Vec::new();
    for k in low.ceil() as i64..=high.floor() as i64 {
        let k = k as f64;
        let mut crossings: Vec<[f64; 2]> = sides()
            .filter(|(p, q)| (across(**p) < k) != (across(**q) < k))
            .map(|(p, q)| {
                let t = (k - across(*p)) / (across(*q) - across(*p));
                [0, 1].map(|j| p[j] + t * (q[j] - p[j]))
            })
            .collect();
        crossings.sort_by(|p, q| along(*p).total_cmp(&along(*q)));
        lines.extend(crossings.chunks_exact(2).map(|pair| [pair[0], pair[1]]));
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: Rect = Rect {
        left: 0.0,
        top: 0.0,
        width: 10.0,
        height: 10.0,
    };

    #[test]
    fn a_peak_out_of_range_is_cut_not_flattened() {
        let peak = [[0.0, 5.0], [5.0, -5.0], [10.0, 5.0]];
        let lines = inside(&peak, &FRAME);
        assert_eq!(
            lines,
            [vec![[0.0, 5.0], [2.5, 0.0]], vec![[7.5, 0.0], [10.0, 5.0]]]
        );
    }

    #[test]
    fn gaps_break_and_what_is_outside_goes() {
        let points = [
            [1.0, 1.0],
            [2.0, 2.0],
            [f64::NAN, 3.0],
            [4.0, 4.0],
            [5.0, 4.0],
        ];
        assert_eq!(inside(&points, &FRAME).len(), 2);
        assert!(inside(&[[-5.0, -1.0], [15.0, -1.0]], &FRAME).is_empty());
        let across = inside(&[[-1e300, 5.0], [1e300, 5.0]], &FRAME);
        assert!(across.len() <= 1);
    }

    #[test]
    fn hatching_covers_an_area_and_nothing_else() {
        // An L: 10 x 10 without its upper right quarter; y downwards.
        let l = [
            [0.0, 0.0],
            [5.0, 0.0],
            [5.0, 5.0],
            [10.0, 5.0],
            [10.0, 10.0],
            [0.0, 10.0],
        ];
        for direction in [[1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, -1.0]] {
            let spacing = 0.01;
            let lines = hatching(&l, direction, spacing);
            let length = |[p, q]: &[[f64; 2]; 2]| libm::hypot(q[0] - p[0], q[1] - p[1]);
            // The lines are spacing over the length of the direction apart: together the area, 75, less the rounding of the ends.
            let apart = spacing / libm::hypot(direction[0], direction[1]);
            let area = apart * lines.iter().map(length).sum::<f64>();
            assert!((area - 75.0).abs() < 0.2, "{direction:?}: {area}");
            let middle = |[p, q]: &[[f64; 2]; 2]| [(p[0] + q[0]) / 2.0, (p[1] + q[1]) / 2.0];
            let outside = |[x, y]: [f64; 2]| x > 5.0 && y < 5.0;
            assert!(!lines.iter().map(middle).any(outside));
        }
        assert!(hatching(&[], [1.0, 0.0], 1.0).is_empty());
    }

    #[test]
    fn dashes_add_up_round_corners() {
        // 6 along, 6 down: dashes of 4 with gaps of 1 make 4, 1 gap, 4 (1 + 3 round the corner), 1 gap, 2.
        let line = [[0.0, 0.0], [6.0, 0.0], [6.0, 6.0]];
        let cut = dashes(&line, &[4.0, 1.0]);
        assert_eq!(
            cut,
            [
                vec![[0.0, 0.0], [4.0, 0.0]],
                vec![[5.0, 0.0], [6.0, 0.0], [6.0, 3.0]],
                vec![[6.0, 4.0], [6.0, 6.0]],
            ]
        );
        assert_eq!(dashes(&line, &[]), [line.to_vec()]);
        assert!(dashes(&[], &[1.0, 1.0]).is_empty());
    }
}
