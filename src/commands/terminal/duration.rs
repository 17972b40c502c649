//! How long something takes, as text.

/// A rounded duration with its unit.
pub fn duration(seconds: f64) -> String {
    match seconds {
        _ if seconds < 0.1 => "less than 0.1 s".into(),
        _ if seconds < 10.0 => format!("{seconds:.1} s"),
        _ if seconds < 120.0 => format!("{seconds:.0} s"),
        _ if seconds < 2.0 * 3600.0 => format!("{:.0} min", seconds / 60.0),
        _ if seconds < 48.0 * 3600.0 => format!("{:.0} h", seconds / 3600.0),
        _ => format!("{:.0} days", seconds / 86_400.0),
    }
}
