//! The event, station and component that the header of a record names.

use super::file_text::decode;
use super::{FORMATS, Reading};

/// What a header names; empty where it names nothing.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Heading {
    /// The event, or its date.
    pub event: String,
    /// The station.
    pub station: String,
    /// The component.
    pub component: String,
}

impl Heading {
    /// The heading of a record file; empty for a table.
    pub fn of(bytes: &[u8], reading: &Reading) -> Heading {
        let text = decode(bytes);
        let lines: Vec<&str> = text.lines().collect();
        let format = FORMATS.iter().find(|format| (format.find)(&lines).is_ok());
        format.map_or_else(Heading::default, |format| (format.heading)(&lines, reading))
    }

    /// `event, station, component`, without what is empty.
    pub fn words(&self) -> String {
        let texts = [&self.event, &self.station, &self.component].map(String::as_str);
        let parts: Vec<&str> = texts.into_iter().filter(|part| !part.is_empty()).collect();
        parts.join(", ")
    }
}

/// A component as figures write it: `43°` of `043` or `43 Deg`, another text unchanged.
pub(super) fn component(text: &str) -> String {
    let text = text.trim();
    let mut words = text.split_whitespace();
    let unit = (words.next(), words.next().unwrap_or_default());
    let degrees = match unit {
        (Some(number), "" | "Deg" | "deg" | "Deg." | "DEG") => number.parse::<u16>().ok(),
        _ => None,
    };
    match degrees {
        Some(degrees) if degrees <= 360 => format!("{degrees}°"),
        _ => text.to_owned(),
    }
}

/// Words with single blanks between.
pub(super) fn spaced(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> String {
        Heading::of(text.as_bytes(), &Reading::default()).words()
    }

    #[test]
    fn a_record_is_named_by_event_station_and_component() {
        let at2 = |title: &str| {
            words(&format!(
                "PEER NGA STRONG MOTION DATABASE RECORD\n{title}\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 2, DT= 1\n1 2\n"
            ))
        };
        for (title, expected) in [
            (
                "Nowhere-01, 1/1/2000, Hand Written, 90",
                "Nowhere-01, Hand Written, 90°",
            ),
            (
                "NOWHERE EQ 1/17/94, 12:31, UPPER HILLS MULHOL, 009 (USC STATION 90013)",
                "NOWHERE EQ, UPPER HILLS MULHOL, 9°",
            ),
            (
                "NO PLACE 10/18/89 00:05, ARRAY #1, 000 (CDMG STATION 47379)",
                "NO PLACE, ARRAY #1, 0°",
            ),
            (
                "Nowhere-01, 1/1/2000, Hill, Upper, UP",
                "Nowhere-01, Hill, Upper, UP",
            ),
            (
                "Nowhere-01, 1/1/2000, Hand Written",
                "Nowhere-01, Hand Written",
            ),
            ("no title", ""),
        ] {
            assert_eq!(at2(title), expected);
        }
        let smc = "2 CORRECTED ACCELEROGRAM\n*\nA0\n     1989  10  18    0004 No Place, CA\nMag\n\
                   station = Lower Town, 1295 Hill Roa, F component=    043\n";
        assert_eq!(words(smc), "No Place, Lower Town, 1295 Hill Roa, 43°");
        assert_eq!(
            words(&smc.replace("043", "up")),
            "No Place, Lower Town, 1295 Hill Roa, up"
        );
        let geonet = "Corrected accelerogram X\nSite HSES      42 31 24S\nSome Hall\n4\n5\n6\n7\n\
                      2016 November 13         11:02:56 UT\nComponent N80W  Transverse\n";
        assert_eq!(words(geonet), "2016-11-13, HSES, N80W");
        let knet = "Origin Time       2000/01/02 00:00:00\nStation Code      AKT023\nDir.              N-S\n\
                    Scale Factor      1(gal)/2\n";
        assert_eq!(words(knet), "2000-01-02, AKT023, N-S");
        let cosmos = "Corrected acceleration (Format v01.20 with 13 text lines) Src: x\n\
                      Nowhere Earthquake                       January 17, 2000 12:30 UTC\n\
                      Statn No: 03- 24278   Code:CE-24278  CSMIP  Old Road\nSta Chan   1: 90 Deg (Rcrdr)\n";
        assert_eq!(words(cosmos), "Nowhere Earthquake, CE-24278, 90°");
        assert_eq!(words("t, a\n0, 1\n1, 2\n"), "");
    }

    #[test]
    fn a_table_with_the_header_of_a_format_has_no_heading_of_it() {
        let text = "Nowhere-01, 1/1/2000, Hand Written, 90\nNPTS= 2, DT= 1\n0 2\n1 3\n";
        let reading = Reading {
            column: Some(2),
            ..Reading::default()
        };
        assert_eq!(Heading::of(text.as_bytes(), &reading), Heading::default());
    }

    #[test]
    fn a_component_in_degrees_has_their_sign() {
        for (text, expected) in [
            (" 43", "43°"),
            ("000", "0°"),
            ("90 Deg", "90°"),
            ("N28W", "N28W"),
            ("up", "up"),
            ("1000", "1000"),
            ("", ""),
        ] {
            assert_eq!(component(text), expected);
        }
    }
}
