//! Whether units of mass, force, length and time agree: force = mass length/time^2.

use crate::problem::numbers::unit::Dimension;
use crate::system::loads::STANDARD_GRAVITY;

/// Names of units with their size in SI units. Other names are not interpreted.
const MASSES: [(&str, f64); 7] = [
    ("kg", 1.0),
    ("t", 1e3),
    ("g", 1e-3),
    ("Mg", 1e3),
    ("kt", 1e6),
    ("Gg", 1e6),
    // lbf s2/ft.
    ("slug", POUND / FOOT),
];

/// Units of force.
const FORCES: [(&str, f64); 10] = [
    ("N", 1.0),
    ("kN", 1e3),
    ("MN", 1e6),
    ("mN", 1e-3),
    ("daN", 10.0),
    ("GN", 1e9),
    ("dyn", 1e-5),
    ("lbf", POUND),
    ("kip", 1e3 * POUND),
    ("kgf", STANDARD_GRAVITY),
];

/// Units of length.
const LENGTHS: [(&str, f64); 6] = [
    ("m", 1.0),
    ("mm", 1e-3),
    ("cm", 1e-2),
    ("km", 1e3),
    ("ft", FOOT),
    ("in", FOOT / 12.0),
];

/// Units of time.
const TIMES: [(&str, f64); 2] = [("s", 1.0), ("ms", 1e-3)];

/// A foot in m, by definition.
const FOOT: f64 = 0.3048;

/// A pound-force in N: 0.45359237 kg times standard gravity.
const POUND: f64 = 0.45359237 * STANDARD_GRAVITY;

/// The tables in the order in which a study writes the units, with what they measure.
const TABLES: [(&str, &[(&str, f64)]); 4] = [
    ("mass", &MASSES),
    ("force", &FORCES),
    ("length", &LENGTHS),
    ("time", &TIMES),
];

/// Relative difference of two sizes that are the same: the sizes have round-off, and different units are far apart.
const SAME: f64 = 1e-9;

/// Why these units do not agree, and the units that would; `None` if they agree or are not known.
pub fn fault(text: &str) -> Option<String> {
    let listed: Vec<&str> = text.split(',').map(str::trim).collect();
    let names: [&str; 4] = listed.try_into().ok()?;
    let mut sizes = [0.0; 4];
    for (place, (name, (what, table))) in names.iter().zip(TABLES).enumerate() {
        let known = size(table, name).or_else(|| match place {
            0 => force_over_acceleration(name),
            _ => None,
        });
        match known {
            Some(size) => sizes[place] = size,
            None => {
                let (other, _) = TABLES
                    .iter()
                    .find(|(_, table)| size(table, name).is_some())?;
                return Some(format!(
                    "must name units of mass, force, length and time in this order, as in \"t, kN, m, s\", got {name}, a unit of \
                     {other}, for the {what}"
                ));
            }
        }
    }
    let [mass, force, length, time] = sizes;
    let product = mass * length / (time * time);
    if same(force, product) {
        return None;
    }
    // The size that each unit must have with the other three, the force first.
    let wanted = [
        (1, product),
        (0, force * time * time / length),
        (2, force * time * time / mass),
        (3, (mass * length / force).sqrt()),
    ];
    let suggestions = wanted.iter().filter_map(|(place, wanted)| {
        let known = TABLES[*place].1.iter();
        let (name, _) = known.clone().find(|(_, size)| same(*size, *wanted))?;
        let mut names = names;
        names[*place] = name;
        Some(format!("\"{}\"", names.join(", ")))
    });
    let mended: Vec<String> = suggestions.collect();
    let [m, f, l, t] = names;
    // Without round-off.
    let newton: f64 = format!("{product:.6e}").parse().unwrap_or(product);
    let give = match mended.join(" or ") {
        none if none.is_empty() => "give units with force = mass length/time^2".to_owned(),
        all => format!("give {all}"),
    };
    let named = FORCES.iter().find(|(_, size)| same(*size, product));
    let unit = named.map_or(String::new(), |(name, _)| format!("{name}, "));
    Some(format!(
        "units must agree, force = mass length/time^2: {m} {l}/{t}^2 is {unit}{newton} N, not {f}; {give}"
    ))
}

/// Size of a unit of this dimension in SI units, such as of `mm/s2` or `kN m`; `None` for other texts.
pub fn size_of(name: &str, dimension: Dimension) -> Option<f64> {
    let over_time = |power: &str, exponent: i32| {
        let (length, time) = name.strip_suffix(power)?.split_once('/')?;
        Some(size(&LENGTHS, length)? / size(&TIMES, time)?.powi(exponent))
    };
    match dimension {
        Dimension::Time => size(&TIMES, name),
        Dimension::Length => size(&LENGTHS, name),
        Dimension::Velocity => over_time("", 1),
        Dimension::Acceleration if name == "g" => Some(STANDARD_GRAVITY),
        Dimension::Acceleration => over_time("2", 2),
        Dimension::Force => size(&FORCES, name),
        Dimension::Energy => {
            let (force, length) = name.split_once(' ')?;
            Some(size(&FORCES, force)? * size(&LENGTHS, length)?)
        }
    }
}

/// What a unit measures; `None` for an unknown one.
pub fn dimension_of(name: &str) -> Option<Dimension> {
    let mut all = Dimension::ALL.into_iter();
    all.find(|dimension| size_of(name, *dimension).is_some())
}

/// Examples of units of a dimension, for messages.
pub fn examples(dimension: Dimension) -> String {
    let names = |table: &[(&str, f64)]| {
        let names: Vec<&str> = table.iter().map(|own| own.0).collect();
        names.join(", ")
    };
    match dimension {
        Dimension::Time => names(&TIMES),
        Dimension::Length => names(&LENGTHS),
        Dimension::Force => names(&FORCES),
        Dimension::Velocity => format!("one of {} over s or ms, as in mm/s", names(&LENGTHS)),
        Dimension::Acceleration => {
            format!(
                "g, or one of {} over s2 or ms2, as in mm/s2",
                names(&LENGTHS)
            )
        }
        Dimension::Energy => "a unit of force, a blank and one of length, as in kN m".to_owned(),
    }
}

/// A mass as a force over an acceleration, such as `kip s2/in`.
fn force_over_acceleration(name: &str) -> Option<f64> {
    let (force, length) = name.split_once(" s2/")?;
    Some(size(&FORCES, force)? / size(&LENGTHS, length)?)
}

/// The unit of length in m, of units of mass, force, length and time; `None` without a known one.
pub fn metres(units: &str) -> Option<f64> {
    units
        .split(',')
        .find_map(|name| size(&LENGTHS, name.trim()))
}

/// The names of the units of length, for messages.
pub fn lengths() -> String {
    let [first @ .., last] = LENGTHS.map(|unit| unit.0);
    format!("{} or {last}", first.join(", "))
}

fn size(table: &[(&str, f64)], name: &str) -> Option<f64> {
    let known = table.iter().find(|known| known.0 == name);
    known.map(|known| known.1)
}

fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME * b.abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_that_agree_or_are_not_known_are_allowed() {
        for text in [
            "t, kN, m, s",
            "kg, N, m, s",
            "t, N, mm, s",
            "kg,kN,mm,ms",
            "Mg, kN, m, s",
            "kt, kN, mm, s",
            "g, dyn, cm, s",
            "slug, lbf, ft, s",
            "kip s2/in, kip, in, s",
            "t, kN, ell, s",
            "m, s",
            "",
        ] {
            assert_eq!(fault(text), None, "{text}");
        }
    }

    #[test]
    fn units_have_sizes_by_their_dimension() {
        use crate::problem::structure::metrics::unit_names::UnitNames;
        for (name, dimension, size) in [
            ("ms", Dimension::Time, 1e-3),
            ("in", Dimension::Length, 0.0254),
            ("mm/s", Dimension::Velocity, 1e-3),
            ("mm/ms", Dimension::Velocity, 1.0),
            ("g", Dimension::Acceleration, 9.80665),
            ("ft/s2", Dimension::Acceleration, 0.3048),
            ("mm/ms2", Dimension::Acceleration, 1e3),
            // 1000 lb of 0.45359237 kg under standard gravity.
            ("kip", Dimension::Force, 4448.2216152605),
            ("kip in", Dimension::Energy, 4448.2216152605 * 0.0254),
        ] {
            let found = size_of(name, dimension).unwrap();
            assert!((found - size).abs() < 1e-14 * size, "{name}: {found}");
            assert_eq!(dimension_of(name), Some(dimension));
        }
        for name in [
            "", "g/s", "m/s3", "m/ s", "kNm", "kg", "furlong", "/s", "m/",
        ] {
            assert_eq!(dimension_of(name), None, "{name}");
        }
        let units = UnitNames::of("kip s2/in, kip, in, s").unwrap();
        let factor = |unit, dimension| units.factor(unit, dimension).unwrap();
        assert_eq!(factor("in", Dimension::Length), 1.0);
        // 9.80665 m/s2 over 0.0254 m.
        let g = factor("g", Dimension::Acceleration);
        assert!((g - 386.08858267716535).abs() < 1e-12, "{g}");
        assert_eq!(units.factor("kN", Dimension::Length), None);
        let own = UnitNames::of("t, kN, ell, s").unwrap();
        assert_eq!(own.factor("m", Dimension::Length), None);
        assert_eq!(own.factor("N", Dimension::Force), Some(1e-3));
    }

    #[test]
    fn units_that_do_not_agree_are_refused_with_those_that_would() {
        for (text, says) in [
            (
                "kg, kN, mm, s",
                "kg mm/s^2 is mN, 0.001 N, not kN; give \"kg, mN, mm, s\" or \"kt, kN, mm, s\" or \"kg, kN, km, s\" or \"kg, kN, mm, ms\"",
            ),
            (
                "kg, kN, m, s",
                "kg m/s^2 is N, 1 N, not kN; give \"kg, N, m, s\" or \"t, kN, m, s\" or \"kg, kN, km, s\"",
            ),
            (
                "t, kN, mm, s",
                "t mm/s^2 is N, 1 N, not kN; give \"t, N, mm, s\" or \"kt, kN, mm, s\" or \"t, kN, m, s\"",
            ),
            (
                "t, kN, cm, s",
                "t cm/s^2 is daN, 10 N, not kN; give \"t, daN, cm, s\" or \"t, kN, m, s\"",
            ),
        ] {
            let fault = fault(text).unwrap();
            assert!(fault.ends_with(says), "{fault}\n{says}");
        }
        // All mendings agree.
        for text in ["kg, kN, mm, s", "t, MN, m, s", "g, N, cm, ms"] {
            let fault = fault(text).unwrap();
            let mended = fault.split('"').skip(1).step_by(2);
            assert!(mended.map(self::fault).all(|f| f.is_none()), "{fault}");
        }
        let fault = fault("m, kN, t, s").unwrap();
        assert!(
            fault.ends_with("got m, a unit of length, for the mass"),
            "{fault}"
        );
    }
}
