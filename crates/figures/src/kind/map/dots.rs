//! Dots at the cases of a map.

use slipgap_drawing::colour_map::bands;
use slipgap_drawing::layout::cloud::{Cloud, Dot};
use slipgap_drawing::layout::sheet::Panel;
use slipgap_drawing::style;

/// Least distance of dots, in points: closer ones would hide the shades.
const APART: f64 = 5.0;

/// The places of the values; `None` if they are too close.
pub fn dots(panel: &Panel, values: &bands::Values) -> Option<Cloud> {
    let [xs, ys] = &values.places;
    let axes = [
        (&panel.x, xs, panel.frame.width),
        (&panel.y, ys, panel.frame.height),
    ];
    let far = axes.into_iter().all(|(axis, places, length)| {
        let at = |x: f64| length * axis.fraction(x);
        places
            .windows(2)
            .all(|pair| at(pair[1]) - at(pair[0]) >= APART)
    });
    let pairs = xs.iter().flat_map(|x| ys.iter().map(move |y| [*x, *y]));
    let known = pairs.zip(&values.z).filter(|(_, z)| !z.is_nan());
    let dot = |(at, _)| Dot {
        at,
        value: None,
        // The bands are lighter.
        shade: 0.0,
    };
    far.then(|| Cloud {
        dots: known.map(dot).collect(),
        radius: style::MAP_DOT,
        image: false,
    })
}
