//! Names of the units that a study's parameters are in, and of the columns and titles in these units.

use slipgap_problem::problem::numbers::parameter::shortest;
use slipgap_problem::problem::numbers::unit::Dimension;
use slipgap_problem::problem::{Case, Problem};

/// The message for results in units in a study without the key.
pub(crate) const NEEDS_UNITS: &str = "results in units need the key \"units\" of the study";

/// Names of the units of the parameters of a study. The program converts nothing; the units must be consistent.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Units {
    pub(crate) length: String,
    pub(crate) force: String,
    pub(crate) time: String,
}

impl Units {
    /// The unit of a dimension, as figures write it.
    pub fn of(&self, dimension: Dimension) -> String {
        self.joined(dimension, "/")
    }

    /// The name of a column in the units of the study: `peak_force` as `peak_force_in_kN`.
    pub fn column(&self, scaled: &str, dimension: Dimension) -> String {
        format!("{scaled}{IN}{}", self.joined(dimension, "_per_"))
    }

    /// A scaled title or symbol in units: `*F*/*F*_0_` as `*F* (kN)`.
    pub fn title(&self, problem: &dyn Problem, scaled: &str, dimension: Dimension) -> String {
        let mut known = problem.schema().units.iter();
        let scale = known.find(|unit| unit.dimension == dimension);
        let bare = scaled.replacen(scale.map_or("", |scale| &scale.over), "", 1);
        format!("{bare} ({})", self.of(dimension))
    }

    /// A unit in words, such as `force/length`, in these units; others as they are.
    pub fn of_words(&self, words: &str) -> String {
        let Units {
            length,
            force,
            time,
        } = self;
        match words {
            // A mass is a force over an acceleration.
            "mass/length^3" => format!("{force} {time}2/{length}4"),
            _ => {
                let name = |part: &str| {
                    let (base, power) = part.split_once('^').unwrap_or((part, ""));
                    let unit = match base {
                        "length" => length,
                        "force" => force,
                        "time" => time,
                        _ => base,
                    };
                    format!("{unit}{power}")
                };
                let parts: Vec<String> = words.split('/').map(name).collect();
                let is_known = ["length", "force", "time"]
                    .iter()
                    .any(|base| words.starts_with(base));
                if is_known {
                    parts.join("/")
                } else {
                    words.to_owned()
                }
            }
        }
    }

    /// The scales of the results of a completed case of bars in these units, with the overlap and the steps of a contact.
    pub fn scales(&self, problem: &dyn Problem, case: &Case) -> Option<String> {
        let textbook = problem.as_textbook()?;
        let short = |x: f64| shortest(format!("{x:.5e}").parse().unwrap_or(x));
        let size = |dimension| textbook.size(case, dimension);
        let number = |x: f64, dimension| format!("{} {}", short(x), self.of(dimension));
        let (time, force) = (size(Dimension::Time)?, size(Dimension::Force)?);
        let speed = 2.0 * case.number("L")? / time;
        let mut text = format!(
            "T_I = {}, C0 = {}, F0 = {}",
            number(time, Dimension::Time),
            number(speed, Dimension::Velocity),
            number(force, Dimension::Force)
        );
        if let Some(stiffness) = case.number("k_I") {
            let overlap = number(force / stiffness, Dimension::Length);
            text += &format!("; overlap F0/k_I = {overlap}");
        }
        let steps = short(1.0 / case.number("dt")?);
        Some(format!("{text}; {steps} steps in a contact of T_I\n"))
    }

    fn joined(&self, dimension: Dimension, over: &str) -> String {
        match dimension {
            Dimension::Time => self.time.clone(),
            Dimension::Length => self.length.clone(),
            Dimension::Velocity => format!("{}{over}{}", self.length, self.time),
            Dimension::Acceleration => format!("{}{over}{}2", self.length, self.time),
            Dimension::Force => self.force.clone(),
            Dimension::Energy => {
                let times = if over == "/" { " " } else { "_" };
                format!("{}{times}{}", self.force, self.length)
            }
        }
    }
}

/// The text between metric and unit in the name of a column. No name of a table contains it.
pub(crate) const IN: &str = "_in_";

/// The metric in the name of a column in units.
pub fn scaled(column: &str) -> Option<&str> {
    column.split_once(IN).map(|(scaled, _)| scaled)
}

#[cfg(test)]
mod tests {
    #[test]
    fn scales_of_bars_are_in_the_units_of_the_study() {
        let study = crate::parse(
            "s",
            r#"{"problem": "bar-impact", "units": {"length": "m", "force": "kN", "time": "s"},
                "parameters": {"E": 3e7, "A": 5, "rho": 2.5, "L": 30, "V0": 0.5, "n": 10, "gamma": 0.3, "dt": 0.01, "duration": 2}}"#,
        )
        .unwrap();
        let (units, case) = (study.units.as_ref().unwrap(), study.case(0).unwrap());
        // Concrete of 30 GPa and 2.5 t/m3: C0 = sqrt(3e7/2.5) = 3464.1 m/s, T_I = 60 m/C0. Two equal bars that close at 1 m/s:
        // F0 = rho A C0 1/2 = 21650.6 kN; k_I = 0.3 * 10 E A/L = 1.5e7 kN/m.
        assert_eq!(
            units.scales(&*study.problem, &case).unwrap(),
            "T_I = 0.0173205 s, C0 = 3464.1 m/s, F0 = 21650.6 kN; overlap F0/k_I = 0.00144338 m; 100 steps in a contact of T_I\n"
        );
        for (words, unit) in [
            ("force/length^2", "kN/m2"),
            ("length/time", "m/s"),
            ("mass/length^3", "kN s2/m4"),
            ("T_I", "T_I"),
            ("1", "1"),
        ] {
            assert_eq!(units.of_words(words), unit);
        }
    }
}
