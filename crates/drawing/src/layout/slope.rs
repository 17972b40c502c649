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

/// Writes the slope of every curve of a panel next to its straight stretch, if there is space nearer to this than to any other curve.
pub fn write(panel: &mut Panel) {
    let mut taken: Vec<Rect> = Vec::new();
    let mut notes = Vec::new();
    for (k, series) in panel.series.iter().enumerate() {
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
        let centre = (stretch.from + stretch.to) / 2;
        let mut order: Vec<usize> = (stretch.from..=stretch.to).collect();
        order.sort_by_key(|i| i.abs_diff(centre));
        let beside = [5.0, 9.0, 14.0].into_iter().flat_map(|away| {
            let [left, right, over] = [-width - away, away, -away - height];
            match stretch.slope > 0.0 {
                true => [[left, over], [right, away]],
                false => [[right, over], [left, away]],
            }
        });
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
                inside
                    && !taken.iter().any(|t| t.overlaps(area))
                    && legend::is_free(panel, area)
                    && is_nearest(panel, area, k, &stretch)
                    // The end of a long label reaches far along the curve.
                    && is_nearest(panel, &middle(area), k, &stretch)
                    && (point(stretch.from)[0]..point(stretch.to)[0]).contains(&middle(area).left)
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

/// Whether an area is nearer to a stretch of curve `k` than to what else is drawn of curves.
fn is_nearest(panel: &Panel, area: &Rect, k: usize, stretch: &Stretch) -> bool {
    let [mut of_stretch, mut of_others] = [f64::INFINITY; 2];
    let curves = panel.series.iter().enumerate();
    for (other, series) in curves.filter(|(_, series)| !series.label.is_empty()) {
        let places: Vec<[f64; 2]> = series.points.iter().map(|p| panel.place(*p)).collect();
        for (i, pair) in places.windows(2).enumerate() {
            let is_of_stretch = other == k && (stretch.from..stretch.to).contains(&i);
            let least = match is_of_stretch {
                true => &mut of_stretch,
                false => &mut of_others,
            };
            // NaN is no place.
            *least = least.min(distance(area, pair[0], pair[1]));
        }
    }
    of_stretch < of_others
}

/// The middle of an area.
fn middle(area: &Rect) -> Rect {
    Rect {
        left: area.left + area.width / 2.0,
        top: area.top + area.height / 2.0,
        ..Rect::default()
    }
}

/// The least distance of an area from points of a piece of a line.
fn distance(area: &Rect, a: [f64; 2], b: [f64; 2]) -> f64 {
    const PARTS: usize = 16;
    let point = |i: usize| [0, 1].map(|k| a[k] + (b[k] - a[k]) * i as f64 / PARTS as f64);
    let from = |[x, y]: [f64; 2]| {
        let dx = (area.left - x).max(x - area.right()).max(0.0);
        let dy = (area.top - y).max(y - area.bottom()).max(0.0);
        match x.is_finite() && y.is_finite() {
            true => libm::hypot(dx, dy),
            false => f64::INFINITY,
        }
    };
    (0..=PARTS)
        .map(|i| from(point(i)))
        .fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::sheet::Series;
    use crate::layout::ticks;

    /// A panel of 200 by 100 points with these curves from (0.01, 0.01) to (1, 1).
    fn panel(curves: &[&[[f64; 2]]]) -> Panel {
        let frame = Rect {
            left: 50.0,
            top: 20.0,
            width: 300.0,
            height: 300.0,
        };
        let axis = || ticks::log("", [0.01, 1.0].into_iter(), 5.0);
        let mut panel = Panel::new(frame, 40.0, axis(), axis());
        panel.series = curves
            .iter()
            .enumerate()
            .map(|(k, points)| Series {
                label: format!("c{k}"),
                ..Series::exact(points.to_vec())
            })
            .collect();
        panel
    }

    #[test]
    fn a_slope_is_written_next_to_its_stretch_and_not_next_to_another_curve() {
        let line = |of: &dyn Fn(f64) -> f64| -> Vec<[f64; 2]> {
            let xs = (0..=8).map(|i| 0.01 * libm::pow(100.0, f64::from(i) / 8.0));
            xs.map(|x| [x, of(x)]).collect()
        };
        let rising = line(&|x| x);
        let mut alone = panel(&[&rising]);
        write(&mut alone);
        assert_eq!(alone.notes.len(), 1);
        assert_eq!(alone.notes[0].text, "c0: slope 1.00");
        // Curves on both sides, 2 points away: no place is nearer to the one between them.
        let [over, under] = [1.03, 1.0 / 1.03].map(|factor| line(&|x| factor * x));
        let mut crowded = panel(&[&over, &rising, &under]);
        write(&mut crowded);
        assert!(
            crowded
                .notes
                .iter()
                .all(|note| !note.text.starts_with("c1"))
        );
        // A fall, then a rise: the slope of the rise is not at the fall.
        let bent = line(&|x| if x < 0.05 { 2e-5 / (x * x) } else { 0.4 * x });
        let mut valley = panel(&[&bent]);
        write(&mut valley);
        let stretch = straight(&bent).unwrap();
        let [begin, end] = [stretch.from, stretch.to].map(|i| valley.place(bent[i])[0]);
        assert!(stretch.from >= 3 && stretch.slope > 0.9);
        assert_eq!(valley.notes.len(), 1);
        let area = valley.notes[0].area();
        assert!((begin..end).contains(&(area.left + area.width / 2.0)));
    }

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
