//! Response spectra of ground motions and of floors.

use crate::Scale;
use crate::field::{field, fields, needed};
use crate::figure::checker::{Checker, NARROW};
use crate::figure::keys::{COLOUR, MARKERS, Takes};
use crate::figure::kinds::motion::history;
use crate::figure::kinds::{Decoded, FigureKind, Kind, Needs};
use slipgap_problem::problem::numbers::unit::Dimension;

/// Damping ratio if none is given.
const DAMPING: f64 = 0.05;

/// First and last period if none are given.
const PERIODS: [f64; 2] = [0.05, 5.0];

/// Shortest period in s: one of a far higher frequency than records have.
const SHORTEST: f64 = 0.001;

/// Most cases: each may have another ground motion, which is computed.
const MOST_CASES: usize = 1000;

pub(in crate::figure::kinds) const KIND: Kind = Kind {
    name: "spectrum",
    needs: Needs::Structure,
    meaning: "elastic response spectra of the whole ground motions, also after `duration`, or of floors; one curve for each motion and damping ratio",
    keys: &fields![
        /// acceleration of a floor, such as f2.a_abs, instead of the ground
        field("of", Takes::Quantity),
        /// displacement, pseudo-velocity, pseudo-acceleration, one panel each
        needed("y", Takes::Ordinates),
        /// damping ratios; default 0.05
        field("damping", Takes::Ratios),
        /// first and last period, at least 0.001; default [0.05, 5]
        field("periods", Takes::Periods),
        COLOUR,
        MARKERS,
    ],
    decode: |values, _| {
        let ratios = values.numbers("damping");
        Some(FigureKind::Spectrum(Spectrum {
            of: values.row("of"),
            y: values.rows("y")?.into_iter().map(Ordinate::of).collect(),
            damping: if ratios.is_empty() {
                vec![DAMPING]
            } else {
                ratios
            },
            periods: values.range("periods").unwrap_or(PERIODS),
        }))
    },
};

/// Response spectra of ground motions or of an acceleration over the period.
#[derive(Debug)]
pub struct Spectrum {
    /// Row of `problem.schema().quantities`; `None` for the ground.
    pub of: Option<usize>,
    /// What is drawn, one panel each.
    pub y: Vec<Ordinate>,
    /// Damping ratios.
    pub damping: Vec<f64>,
    /// First and last period.
    pub periods: [f64; 2],
}

/// An ordinate of a spectrum.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ordinate {
    /// S_d.
    Displacement,
    /// 2 pi/T S_d.
    PseudoVelocity,
    /// (2 pi/T)^2 S_d.
    PseudoAcceleration,
}

impl Ordinate {
    /// The ordinate of a row of `ORDINATES`.
    fn of(row: usize) -> Ordinate {
        match row {
            0 => Ordinate::Displacement,
            1 => Ordinate::PseudoVelocity,
            _ => Ordinate::PseudoAcceleration,
        }
    }
}

impl Decoded for Spectrum {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        None
    }

    fn check_keys(&self, checker: &mut Checker) {
        if self.periods[0] < SHORTEST {
            let message = format!("must be at least {SHORTEST}, got {}", self.periods[0]);
            checker.fault_of_item("periods", 0, message);
        }
    }

    fn draws_histories(&self) -> bool {
        self.of.is_some()
    }

    fn check_cases(&self, checker: &mut Checker) {
        if let Some(of) = self.of {
            let schema = checker.scope.problem.schema();
            let of = &schema.quantities[of];
            if of.error || schema.channels[of.channel].dimension != Dimension::Acceleration {
                let message = "must be an acceleration, such as NODE.a_abs";
                checker.fault("of", message);
            }
            history::check(checker, None, None, 1, KIND.name);
            return;
        }
        if checker.has_more_cases_than(MOST_CASES) {
            checker.fault("where", format!("more than {MOST_CASES} cases; {NARROW}"));
            return;
        }
        let first = checker.cases().next();
        if first.is_some_and(|case| {
            checker
                .scope
                .problem
                .as_structure()
                .and_then(|structure| structure.ground_motion(&case))
                .is_none()
        }) {
            let message =
                "a spectrum figure needs a ground motion; give the key \"ground\" of the structure";
            checker.fault("kind", message);
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::parse;

    /// What is wrong with a figure of a mass on this ground.
    fn wrong(ground: &str, figure: &str) -> String {
        let study = format!(
            "{{\"problem\": \"structure\", \"parameters\": {{\"dt\": 0.01, \"duration\": 1}}, \"metrics\": [\"peak(m)\"],\n\
             \"structure\": {{\"masses\": {{\"m\": 1}}, \"springs\": [{{\"between\": [\"ground\", \"m\"], \"k\": 1}}]{ground}}},\n\
             \"figures\": [{{\"name\": \"f\", \"kind\": \"spectrum\"{figure}}}]}}"
        );
        let wrong = parse("s", &study).err().map(|e| e.to_string());
        wrong
            .unwrap_or_default()
            .lines()
            .next()
            .unwrap_or_default()
            .to_owned()
    }

    #[test]
    fn faults_name_the_key_and_what_is_allowed() {
        let ground = r#", "ground": {"synthetic": {"seed": 1}}"#;
        for (figure, message) in [
            (r#", "y": "displacement""#, ""),
            (
                r#", "y": ["pseudo-velocity", "pseudo-acceleration"], "damping": [0, 0.05], "periods": [0.1, 10]"#,
                "",
            ),
            (
                "",
                "s:3:13: figures[0].y: missing: displacement, pseudo-velocity",
            ),
            (
                r#", "y": "acceleration""#,
                "s:3:52: figures[0].y: unknown ordinate \"acceleration\"",
            ),
            (
                r#", "y": "displacement", "damping": [0.05, 1]"#,
                "s:3:86: figures[0].damping[1]: must be less than 1, got 1",
            ),
            (
                r#", "y": "displacement", "damping": -0.1"#,
                "s:3:79: figures[0].damping: must be >= 0",
            ),
            (
                r#", "y": "displacement", "of": "m""#,
                "figures[0].of: must be an acceleration, such as NODE.a_abs",
            ),
            (
                r#", "y": "displacement", "periods": [0, 1]"#,
                "s:3:80: figures[0].periods[0]: must be at least 0.001, got 0",
            ),
            (
                r#", "y": "displacement", "periods": [2, 1]"#,
                "s:3:79: figures[0].periods: the first value must be less than the last, got 2 and 1",
            ),
        ] {
            let told = wrong(ground, figure);
            assert!(
                told.contains(message) && message.is_empty() == told.is_empty(),
                "{figure}: {told}"
            );
        }
        let told = wrong("", r#", "y": "displacement""#);
        let message = "s:3:35: figures[0].kind: a spectrum figure needs a ground motion; give the key \"ground\" of the structure";
        assert!(told.contains(message), "{told}");
    }
}
