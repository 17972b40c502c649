//! The studies that are part of the program, one for each problem of the papers.

/// The text of the study of this name, as in `slipgap recommend bar-impact`; `None` for another name.
pub fn shipped(name: &str) -> Option<&'static str> {
    match name {
        "friction-oscillator" => Some(include_str!("../studies/friction-oscillator.json")),
        "bar-impact" => Some(include_str!("../studies/bar-impact.json")),
        _ => None,
    }
}
