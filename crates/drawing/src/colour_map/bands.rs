//! A map as filled contours: the field over its axes, and the levels between bands.

use crate::colour_map::contours::{Field, Ring};
use crate::colour_map::labels;
use crate::layout::axis::Scale;
use crate::layout::axis::{Axis, Tick};
use crate::layout::sheet::{FilledMap, Panel, Series};
use crate::style::{self, Marker, Stroke};
use crate::text::number::{self, Form};

/// Most levels.
const MOST_LEVELS: usize = 10;

/// Places along both axes from which on contour lines would fill the picture.
const FINE: usize = 200;

/// A metric over two parameters, one value for each place.
pub struct Values {
    /// Places along x and y, rising.
    pub places: [Vec<f64>; 2],
    /// Values, y fastest; NaN where there is none.
    pub z: Vec<f64>,
}

/// Round levels over the range of the colours.
pub fn levels(colours: &Axis) -> Vec<f64> {
    let [low, high] = colours.range;
    let inside = |x: &f64| *x > low && *x < high;
    let linear = || {
        let ticks = crate::layout::ticks::linear("", colours.range, MOST_LEVELS as f64 - 1.0).ticks;
        let major = ticks.into_iter().filter(|tick| !tick.label.is_empty());
        major.map(|tick| tick.at).filter(inside).collect()
    };
    if colours.scale == Scale::Linear {
        return linear();
    }
    let (first, last) = (libm::log10(low) as i32 - 2, libm::log10(high) as i32 + 1);
    let decades = |digits: &[f64], every: i32| -> Vec<f64> {
        let powers = (first..=last).filter(|k| k.rem_euclid(every) == 0);
        let numbers = powers.flat_map(|k| {
            digits
                .iter()
                .map(move |d| d * libm::pow(10.0, f64::from(k)))
        });
        numbers.filter(inside).collect()
    };
    let series: [(&[f64], i32); 7] = [
        (&[1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0], 1),
        (&[1.0, 1.5, 2.0, 3.0, 5.0, 7.0], 1),
        (&[1.0, 2.0, 5.0], 1),
        (&[1.0, 3.0], 1),
        (&[1.0], 1),
        (&[1.0], 2),
        (&[1.0], 5),
    ];
    let fitting = series.iter().map(|(digits, every)| decades(digits, *every));
    match fitting
        .into_iter()
        .find(|levels| levels.len() <= MOST_LEVELS)
    {
        Some(levels) if levels.len() > 2 => levels,
        _ => linear(),
    }
}

/// The axis of the colours of contours, with a tick at every level and at both ends.
/// Numbers that would touch another one along a bar of this height are left out.
pub fn limited(colours: Axis, height: f64) -> Axis {
    let [low, high] = colours.range;
    let levels = levels(&colours);
    let height_of = |x: f64| height * colours.fraction(x);
    let mut numbered = vec![height_of(low), height_of(high)];
    let unit = libm::pow(10.0, f64::from(colours.power));
    let form = Form::of([low, high].map(|x| x / unit).into_iter());
    let end = |at: f64| Tick {
        at,
        label: form.write(at / unit),
    };
    let mut ticks = vec![end(low)];
    for at in levels {
        let free = numbered
            .iter()
            .all(|other| (height_of(at) - other).abs() >= style::LABEL);
        let label = if free {
            numbered.push(height_of(at));
            number::short(at / unit)
        } else {
            String::new()
        };
        ticks.push(Tick { at, label });
    }
    ticks.push(end(high));
    Axis { ticks, ..colours }
}

impl Values {
    /// Fills the panel with bands, their lines and numbers; no number covers an `occupied` place.
    pub fn fill(&self, panel: &mut Panel, map: FilledMap, occupied: &[[f64; 2]]) {
        let levels = levels(&map.colours);
        let scale = |axis: &Axis, x: f64| match axis.scale {
            Scale::Linear => x,
            Scale::Log => libm::log(x),
        };
        let back = |axis: &Axis, x: f64| match axis.scale {
            Scale::Linear => x,
            Scale::Log => libm::exp(x),
        };
        let even = |axis: &Axis, k: usize| self.places[k].iter().map(|x| scale(axis, *x)).collect();
        let z = |x: &f64| match scale(&map.colours, *x) {
            z if z.is_finite() => z,
            _ => f64::NAN,
        };
        let field = Field {
            x: even(&panel.x, 0),
            y: even(&panel.y, 1),
            z: self.z.iter().map(z).collect(),
        };
        let at: Vec<f64> = levels.iter().map(|x| scale(&map.colours, *x)).collect();
        let mut rings = field.rings(&at);
        for point in rings.iter_mut().flat_map(|ring| &mut ring.points) {
            *point = [back(&panel.x, point[0]), back(&panel.y, point[1])];
        }
        let lines: Vec<(String, Vec<[f64; 2]>)> = rings
            .iter()
            .map(|ring| (number::short(levels[ring.level]), line(ring)))
            .collect();
        // A fine map has no contour lines: the edges of its colours are enough.
        for (_, points) in lines.iter().filter(|_| !self.is_fine()) {
            panel.series.push(Series {
                label: String::new(),
                points: points.clone(),
                stroke: Stroke::Solid,
                width: style::CONTOUR_LINE,
                marker: None,
                marked: Vec::new(),
            });
        }
        let labels = labels::place(panel, lines, occupied);
        // Inside of a rise is the band above its level, inside of a hollow the one below.
        let band = |ring: &Ring| ring.level + usize::from(ring.area > 0.0);
        panel.map = Some(FilledMap {
            areas: rings.into_iter().map(|r| (band(&r), r.points)).collect(),
            blank: self.blank(),
            levels,
            labels,
            ..map
        });
    }

    /// Whether it has so many places that contour lines would fill the picture.
    fn is_fine(&self) -> bool {
        self.places.iter().all(|places| places.len() >= FINE)
    }

    /// Squares of the grid with a corner that has no value.
    fn blank(&self) -> Vec<[[f64; 2]; 2]> {
        let [x, y] = &self.places;
        let known = |i: usize, j: usize| self.z[i * y.len() + j].is_finite();
        let mut blank = Vec::new();
        for i in 1..x.len() {
            for j in 1..y.len() {
                if !(known(i - 1, j - 1) && known(i, j - 1) && known(i - 1, j) && known(i, j)) {
                    blank.push([[x[i - 1], y[j - 1]], [x[i], y[j]]]);
                }
            }
        }
        blank
    }
}

/// A ring as a line, without the parts along the edge of the known values.
fn line(ring: &Ring) -> Vec<[f64; 2]> {
    let points = ring.points.iter().zip(&ring.real);
    let mut line: Vec<[f64; 2]> = points
        .map(|(point, real)| if *real { *point } else { [f64::NAN; 2] })
        .collect();
    line.extend(line.first().copied());
    line
}

/// Markers without a line, with the label of the legend in markup.
pub fn marks(label: &str, at: &[[f64; 2]]) -> Series {
    let apart = at.iter().flat_map(|point| [*point, [f64::NAN; 2]]);
    Series {
        label: label.to_owned(),
        points: apart.collect(),
        stroke: Stroke::Solid,
        width: 0.0,
        marker: Some(Marker::Circle),
        marked: (0..at.len()).map(|i| 2 * i).collect(),
    }
}
