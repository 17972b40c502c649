//! A search for an impact of two bars, from the numbers and names that a user gives.

use super::{FixedParameters, Impact};
use crate::setting::choices;
use crate::task::{Search, check_target, choice, folder_name};
use crate::{Fixed, Request, Stop, Target, metric};
use slipgap_problem::problem::Problem;
use slipgap_problem::problem::impact::BarImpact;
use slipgap_problem::problem::numbers::parameter::{Kind, Value, shortest};
use slipgap_problem::problem::table::schema::Text;
use slipgap_study::error::Error;
use std::fmt;

/// The exact motion keeps its energy. A gain of 1 % of the energy is 0.5 % of a velocity, less than most targets allow.
pub const ENERGY_GAIN: f64 = 0.01;

/// A loss of 10 % of the energy is 5 % of a velocity. Without a limit the search would choose methods that damp the whole motion.
pub const ENERGY_LOSS: f64 = 0.1;

/// Largest number of elements of the left bar.
pub const MOST_ELEMENTS: u32 = 1000;

/// What is given of two bars, and the targets, of which at least one must be given.
#[derive(Debug, Clone)]
pub struct ImpactTask {
    /// Largest error of the peak force, relative to the exact peak.
    pub peak_force_error: Option<f64>,
    /// Largest overlap, in c T_I/2.
    pub overlap: Option<f64>,
    /// Largest rms_error_r, in c T_I/2.
    pub r: Option<f64>,
    /// Largest rms_error_rdot, in c.
    pub rdot: Option<f64>,
    /// The law; `None` to search all.
    pub law: Option<String>,
    /// The method; `None` to search all.
    pub method: Option<String>,
    /// Largest gain of energy at any step, relative to the initial energy.
    pub energy_gain: f64,
    /// Largest loss of energy up to the last step, relative to the same.
    pub energy_loss: f64,
    /// Elements of the left bar; `None` to search them.
    pub n: Option<u32>,
    /// Stiffness of the contact over that of an element; `None` to search it, or with `k_i`.
    pub gamma: Option<f64>,
    /// Stiffness of the contact, in the units of the bars.
    pub k_i: Option<f64>,
    /// The mass matrix; `None` to search all.
    pub mass: Option<String>,
    /// Data of the bars, each as [`bar`] reads it.
    pub bars: Vec<(Text, Value)>,
}

impl Default for ImpactTask {
    fn default() -> ImpactTask {
        ImpactTask {
            peak_force_error: None,
            overlap: None,
            r: None,
            rdot: None,
            law: None,
            method: None,
            energy_gain: ENERGY_GAIN,
            energy_loss: ENERGY_LOSS,
            n: None,
            gamma: None,
            k_i: None,
            mass: None,
            bars: Vec::new(),
        }
    }
}

/// The names of a parameter of the bars.
fn names(parameter: &str) -> Vec<&'static str> {
    choices(&BarImpact, parameter)
}

/// Parameters of the bars, apart from those of the right bar.
const BARS: [&str; 6] = ["E", "A", "rho", "L", "V0", "right"];

/// Why a name and a text are no parameter of the bars with its value. Displayed with what is allowed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum BarFault {
    /// A name that no parameter has.
    Unknown {
        /// The name.
        name: String,
        /// The names that there are.
        allowed: Vec<Text>,
    },
    /// A text that the parameter does not allow.
    NotAllowed {
        /// Name of the parameter.
        name: Text,
        /// What it allows.
        allowed: String,
        /// The text.
        got: String,
    },
}

impl fmt::Display for BarFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BarFault::Unknown { name, allowed } => {
                write!(f, "unknown {name}, allowed: {}", allowed.join(", "))
            }
            BarFault::NotAllowed { name, allowed, got } => {
                write!(f, "{name} must be {allowed}, got {got}")
            }
        }
    }
}

impl std::error::Error for BarFault {}

/// A parameter of the bars with its value, as `right.L` and `20`.
///
/// # Errors
/// An unknown name, or a value that its parameter does not allow.
pub fn bar(name: &str, value: &str) -> Result<(Text, Value), BarFault> {
    let bars = |name: &str| BARS.contains(&name) || name.starts_with("right.");
    let mut table = BarImpact.parameters().iter().filter(|p| bars(&p.name));
    let Some(parameter) = table.clone().find(|p| p.name == name) else {
        return Err(BarFault::Unknown {
            name: name.to_owned(),
            allowed: table.by_ref().map(|p| p.name.clone()).collect(),
        });
    };
    let number = value.parse::<f64>().ok().filter(|x| x.is_finite());
    let (parsed, allowed) = match parameter.kind {
        Kind::Number(range) => {
            let x = number.filter(|x| range.contains(*x));
            (x.map(Value::Number), format!("a number, {range}"))
        }
        Kind::Whole { min, max } => {
            let n = value.parse().ok().filter(|n| (min..=max).contains(n));
            (n.map(Value::Whole), format!("whole, {min} to {max}"))
        }
        Kind::Choice(choices) => {
            let name = choices.iter().find(|choice| choice.0 == value);
            let names: Vec<&str> = choices.iter().map(|choice| choice.0).collect();
            (name.map(|choice| Value::Name(choice.0)), names.join(", "))
        }
    };
    let value = parsed.ok_or_else(|| BarFault::NotAllowed {
        name: parameter.name.clone(),
        allowed,
        got: value.to_owned(),
    })?;
    Ok((parameter.name.clone(), value))
}

impl ImpactTask {
    /// The search.
    ///
    /// # Errors
    /// A name or a number that is not allowed, bars that break a rule, and no target.
    pub fn search(mut self) -> Result<Search, Error> {
        self.check()?;
        let gamma = self.gamma.map(|gamma| ("gamma", gamma));
        let spring = gamma.or(self.k_i.map(|k_i| ("k_I", k_i)));
        let mass = choice(&names("mass"), "mass", self.mass.as_ref())?;
        let fixed = FixedParameters {
            choice: Fixed {
                law: choice(&names("law"), "law", self.law.as_ref())?,
                method: choice(&names("method"), "method", self.method.as_ref())?,
            },
            spring,
            n: self.n,
            mass,
            bars: self.bars.clone(),
        };
        let space = Impact::new(fixed).map_err(|broken| {
            let messages = broken
                .iter()
                .map(|v| format!("{}: {}", v.parameter, v.message));
            Error::Usage(messages.collect::<Vec<_>>().join("\n"))
        })?;
        let (mut words, targets) = self.targets(space.peak);
        words.extend(self.law.into_iter().chain(self.method));
        if self.energy_gain != ENERGY_GAIN {
            words.push(format!("energy-gain-{}", shortest(self.energy_gain)));
        }
        if self.energy_loss != ENERGY_LOSS {
            words.push(format!("energy-loss-{}", shortest(self.energy_loss)));
        }
        words.extend(self.n.map(|n| format!("n-{n}")));
        words.extend(spring.map(|(name, x)| format!("{name}-{}", shortest(x))));
        words.extend(mass.map(str::to_owned));
        let bars = self.bars.iter();
        words.extend(bars.map(|(name, value)| format!("{name}-{value}")));
        Ok(Search {
            folder: folder_name(&BarImpact, words.into_iter().map(Some)),
            space: Box::new(space),
            request: Request {
                targets,
                energy_gain: self.energy_gain,
                energy_loss: self.energy_loss,
                stop: Stop::default(),
            },
        })
    }

    /// Tests the numbers, and sorts the data of the bars.
    fn check(&mut self) -> Result<(), Error> {
        let targets = [
            ("peak_force_error", self.peak_force_error),
            ("overlap", self.overlap),
            ("r", self.r),
            ("rdot", self.rdot),
        ];
        if targets.iter().all(|target| target.1.is_none()) {
            let names = targets.map(|target| target.0).join(", ");
            return Err(Error::Usage(format!(
                "bar-impact needs at least one target; allowed: {names}"
            )));
        }
        let others = [
            ("energy_gain", Some(self.energy_gain)),
            ("energy_loss", Some(self.energy_loss)),
            ("gamma", self.gamma),
            ("k_I", self.k_i),
        ];
        for (key, x) in targets.into_iter().chain(others) {
            x.map_or(Ok(()), |x| check_target(key, x))?;
        }
        if self.gamma.is_some() && self.k_i.is_some() {
            return Err(Error::Usage("gamma and k_I: give one of them".into()));
        }
        if self.n.is_some_and(|n| !(1..=MOST_ELEMENTS).contains(&n)) {
            return Err(Error::Usage(format!("n: must be 1 to {MOST_ELEMENTS}")));
        }
        // In the order of the table, so that the name of the folder does not depend on the order of the arguments.
        let row = |name: &str| BarImpact.parameters().iter().position(|p| p.name == name);
        self.bars.sort_by_key(|(name, _)| row(name));
        if let Some(twice) = self.bars.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            return Err(Error::Usage(format!("bars: {} is given twice", twice[0].0)));
        }
        let wall = self.bars.iter().any(|(name, _)| *name == "right");
        let right = |(name, _): &&(Text, Value)| name.starts_with("right.");
        match self.bars.iter().find(right) {
            Some((name, _)) if wall => Err(Error::Usage(format!("bars: a wall has no {name}"))),
            Some(_) | None => Ok(()),
        }
    }

    /// The targets, each with a word for the name of the folder; `peak` is the exact peak of the force.
    fn targets(&self, peak: f64) -> (Vec<String>, Vec<Target>) {
        let targets = [
            (
                "peak-force-error",
                "peak_force",
                peak,
                self.peak_force_error,
            ),
            ("overlap", "max_overlap", 0.0, self.overlap),
            ("r", "rms_error_r", 0.0, self.r),
            ("rdot", "rms_error_rdot", 0.0, self.rdot),
        ];
        let given = targets
            .into_iter()
            .filter_map(|(word, name, ideal, limit)| {
                let target = Target {
                    name: if ideal == 0.0 {
                        name
                    } else {
                        "peak_force error"
                    },
                    metric: metric(&BarImpact, name),
                    ideal,
                    limit: limit?,
                };
                Some((format!("{word}-{}", shortest(target.limit)), target))
            });
        given.unzip()
    }
}
