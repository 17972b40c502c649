//! The scale of colours of maps.

/// Colours of a map at equal distances, dark (small) to light (large): matplotlib's viridis (CC0), whose lightness
/// rises evenly, so that it is readable in grey.
const VIRIDIS: [[u8; 3]; 11] = [
    [68, 1, 84],
    [72, 36, 117],
    [65, 68, 135],
    [53, 95, 141],
    [42, 120, 142],
    [33, 145, 140],
    [34, 168, 132],
    [68, 191, 112],
    [122, 209, 81],
    [189, 223, 38],
    [253, 231, 37],
];

/// The fraction of the scale of colours for band `k` of `count`: above 0.3, so that black lines and numbers
/// show on all of them.
pub fn band(k: usize, count: usize) -> f64 {
    0.3 + 0.7 * (k as f64 + 0.5) / count as f64
}

/// The colour at `fraction` of a map's range; values outside of 0..1 have the end colours.
pub fn colour(fraction: f64) -> [u8; 3] {
    let last = VIRIDIS.len() - 1;
    let at = fraction.clamp(0.0, 1.0) * last as f64;
    let i = (at as usize).min(last - 1);
    let blend = |k: usize| {
        let (a, b) = (f64::from(VIRIDIS[i][k]), f64::from(VIRIDIS[i + 1][k]));
        (a + (b - a) * (at - i as f64)).round() as u8
    };
    [blend(0), blend(1), blend(2)]
}
