//! The slope of a curve on logarithmic scales, if it is straight.

use crate::layout::legend;
use crate::layout::sheet::{Anchor, Panel, PlacedText, Rect};
use crate::style;
use crate::text;
use libm::log10;

/// A stretch is straight if no slope between neighbours is further from that of its line.
const STRAIGHT: f64 = 0.15;

/// Fewest points of a straight stretch.
const FEWEST: usize = 4;

/// Least slope of a stretch, rising or falling: a level line has no order, nor has the way from it to a slope.
const LEAST: f64 = 0.45;

/// Shortest straight stretch, as the ratio of its ends.
const SHORTEST: f64 = 2.5;

/// A straight stretch of a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// Its first point.
    pub from: usize,
    /// Its last point.
    pub to: usize,
    /// Slope by least squares.
    pub slope: f64,
}

/// The longest straight stretch of a curve of positive points by rising x that is not level; none if no part of it is one.
pub fn straight(points: &[[f64; 2]]) -> Option<Stretch> {
    let logs: Vec<[f64; 2]> = points.iter().map(|p| p.map(log10)).collect();
    let mut best: Option<Stretch> = None;
    let length = |s: &Stretch| logs[s.to][0] - logs[s.from][0];
    for from in 0..logs.len() {
        for to in from + FEWEST - 1..logs.len() {
            let Some(slope) = fitted(&logs[from..=to]) else {
                break;
            };
            let stretch = Stretch { from, to, slope };
            if slope.abs() < LEAST {
                continue;
            }
            let longer = best.as_ref().is_none_or(|b| length(&stretch) > length(b));
            if longer && length(&stretch) >= log10(SHORTEST) {
                best = Some(stretch);
            }
        }
    }
    best
}

/// The slope of the line through the points, if they are on a straight line.
fn fitted(points: &[[f64; 2]]) -> Option<f64> {
    let count = points.len() as f64;
    let mean = |k: usize| points.iter().map(|p| p[k]).sum::<f64>() / count;
    let (x, y) = (mean(0), mean(1));
    let across: f64 = points.iter().map(|p| (p[0] - x) * (p[0] - x)).sum();
    let both: f64 = points.iter().map(|p| (p[0] - x) * (p[1] - y)).sum();
    let slope = both / across;
    let local = |pair: &[[f64; 2]]| (pair[1][1] - pair[0][1]) / (pair[1][0] - pair[0][0]);
    let straight = |pair: &[[f64; 2]]| (local(pair) - slope).abs() <= STRAIGHT;
    points.windows(2).all(straight).then_some(slope)
}

/// Writes the slope of every curve of a panel next to it, if it is straight and there is space.
pub fn write(panel: &mut Panel) {
    let mut taken: Vec<Rect> = Vec::new();
    let mut notes = Vec::new();
    for series in &panel.series {
        let Some(stretch) = straight(&series.points) else {
            continue;
        };
        let slope = format!("slope {:.2}", stretch.slope).replace('-', "−");
        let text = match series.label.as_str() {
            "" => slope,
            label => format!("{label}: {slope}"),
        };
        let (width, height) = (text::width(&text, style::LABEL), style::LABEL);
        let point = |i: usize| panel.place(series.points[i]);
        // From the middle of the stretch to its ends, over and under the line, then farther from it.
        let middle = (stretch.from + stretch.to) / 2;
        let mut order: Vec<usize> = (stretch.from..=stretch.to).collect();
        order.sort_by_key(|i| i.abs_diff(middle));
        let beside = [5.0, 9.0, 14.0]
            .into_iter()
            .flat_map(|away| [[-width - away, -away - height], [away, away]]);
        let places = beside.flat_map(|[dx, dy]| order.iter().map(move |i| (*i, dx, dy)));
        let free = places
            .map(|(i, dx, dy)| {
                let [x, y] = point(i);
                Rect {
                    left: x + dx,
                    top: y + dy,
                    width,
                    height,
                }
            })
            .find(|area| {
                let inner = panel.frame.inflated(-style::MAJOR_TICK);
                let inside = inner.contains([area.left, area.top])
                    && inner.contains([area.right(), area.bottom()]);
                inside && !taken.iter().any(|t| t.overlaps(area)) && legend::is_free(panel, area)
            });
        if let Some(area) = free {
            taken.push(area);
            notes.push(PlacedText {
                at: [area.left, area.bottom() - 0.2 * height],
                anchor: Anchor::Start,
                text,
                size: style::LABEL,
            });
        }
    }
    panel.notes.extend(notes);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(of: impl Fn(f64) -> f64) -> Vec<[f64; 2]> {
        let xs = (0..12).map(|i| 0.01 * 1.5_f64.powi(i));
        xs.map(|x| [x, of(x)]).collect()
    }

    #[test]
    fn a_power_law_has_its_slope() {
        for slope in [-1.5, 0.5, 2.0] {
            let line = straight(&curve(|x| 3.0 * x.powf(slope))).unwrap();
            assert_eq!((line.from, line.to), (0, 11));
            assert!((line.slope - slope).abs() < 1e-12);
        }
    }

    #[test]
    fn the_straight_part_is_found_and_noise_has_none() {
        // A plateau has no slope: 12 points up to 0.86, of which 6 are below 0.1.
        assert_eq!(straight(&curve(|_| 3.0)), None);
        assert_eq!(straight(&curve(|x| (x * x).min(0.02 * 0.02))), None);
        let saturated = straight(&curve(|x| (x * x).max(0.1 * 0.1))).unwrap();
        assert!((saturated.slope - 2.0).abs() < 0.1 && saturated.from >= 5);
        let mut i = 0;
        let zigzag: Vec<_> = curve(|x| x)
            .into_iter()
            .map(|[x, y]| {
                i += 1;
                [x, if i % 2 == 0 { y } else { 2.0 * y }]
            })
            .collect();
        assert_eq!(straight(&zigzag), None);
        assert_eq!(straight(&curve(|x| x)[..3]), None);
        assert_eq!(straight(&[]), None);
        // A point without a logarithm breaks the line.
        let mut broken = curve(|x| x);
        broken[5][1] = f64::NAN;
        let part = straight(&broken).unwrap();
        assert!(part.from > 5 || part.to < 5);
    }
}
