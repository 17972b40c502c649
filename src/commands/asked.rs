//! What `slipgap recommend` may be asked, and the words that several verbs share.

use clap::{Args, Subcommand};
use sha2::{Digest, Sha256};
use slipgap::error::Error;
use slipgap::problem::parameter::{Kind, Value, shortest};
use slipgap::problem::schema::Text;
use slipgap::problem::{Problem, friction::FrictionOscillator, impact::BarImpact};
use slipgap::recommend::impact::Fixed;
use slipgap::recommend::{self, Request, Space, Target, metric};
use std::path::PathBuf;

#[derive(Subcommand)]
pub enum Asked {
    /// Find law, width (alpha or beta) and time step of a friction model
    FrictionOscillator(Friction),
    /// Find gamma, n, mass matrix and time step for the impact of two bars
    BarImpact(Impact),
}

#[derive(Args)]
pub struct Friction {
    /// Friction law; if left out, both are searched
    #[arg(long, value_parser = LAWS)]
    law: Option<String>,
    /// Displacement at release over Delta; not 0, from -1000 to 1000
    #[arg(long, value_name = "X0", default_value_t = X0, allow_negative_numbers = true, value_parser = release)]
    x0: f64,
    /// Largest rms_error, the root mean square of the error of X over |x0|
    #[arg(long, value_name = "TARGET", value_parser = target)]
    rms: f64,
    #[command(flatten)]
    common: Common,
}

const LAWS: [&str; 2] = ["displacement-control", "velocity-control"];
const MASSES: [&str; 2] = ["lumped", "consistent"];
const X0: f64 = 12.0;

/// The exact motion keeps its energy. Of the energy, 1 % is 0.5 % of a velocity: less than targets usually allow.
const ENERGY_GAIN: f64 = 0.01;

#[derive(Args)]
#[group(id = "targets", required = true, multiple = true, args = ["peak_force_error", "overlap", "r", "rdot"])]
pub struct Impact {
    /// Largest error of the peak force, relative to the exact peak
    #[arg(long, value_name = "TARGET", value_parser = target)]
    peak_force_error: Option<f64>,
    /// Largest overlap, max(-r), in c T_I/2
    #[arg(long, value_name = "TARGET", value_parser = target)]
    overlap: Option<f64>,
    /// Largest rms_error_r, in c T_I/2
    #[arg(long, value_name = "TARGET", value_parser = target)]
    r: Option<f64>,
    /// Largest rms_error_rdot, in c
    #[arg(long, value_name = "TARGET", value_parser = target)]
    rdot: Option<f64>,
    /// Largest gain of energy at any step, relative to the initial energy; 1 % of the energy is 0.5 % of a velocity
    #[arg(long, value_name = "LIMIT", default_value_t = ENERGY_GAIN, value_parser = target)]
    energy_gain: f64,
    /// Elements of the left bar, at most 1000; if left out, it is searched
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    n: Option<u32>,
    /// Stiffness of the impact spring over that of an element; if neither gamma nor k_I is given, it is searched
    #[arg(long, value_name = "GAMMA", value_parser = target)]
    gamma: Option<f64>,
    /// Stiffness of the impact spring, in the units of the bars; gamma = k_I L/(n E A) follows from n
    #[arg(long = "k_I", alias = "k-I", value_name = "K_I", value_parser = target, conflicts_with = "gamma")]
    k_i: Option<f64>,
    /// Mass matrix; if left out, both are searched
    #[arg(long, value_parser = MASSES)]
    mass: Option<String>,
    /// Data of the bars as in a study, e.g. L=40,right.L=20 or right=wall
    #[arg(long, value_name = "NAME=VALUE", value_delimiter = ',', value_parser = bar)]
    bars: Vec<(Text, Value)>,
    #[command(flatten)]
    common: Common,
}

#[derive(Args)]
pub struct Common {
    /// Folder for the table and picture of cost and error; each request has its own folder in it
    #[arg(long, value_name = "DIR", default_value = "figures")]
    pub out: PathBuf,
    #[command(flatten)]
    pub jobs: Jobs,
}

/// A target: a finite number > 0.
fn target(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(x) if x.is_finite() && x > 0.0 => Ok(x),
        _ => Err("must be a number > 0".into()),
    }
}

/// A release whose motion is short enough to search.
fn release(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(x) if x != 0.0 && x.abs() <= 1000.0 => Ok(x),
        _ => Err("must be a number from -1000 to 1000, but not 0".into()),
    }
}

#[derive(Args)]
pub struct Jobs {
    /// Number of threads, at most 1024; if left out, one for each core
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub jobs: Option<u16>,
}

/// What bars consist of.
const BARS: [&str; 6] = ["E", "A", "rho", "L", "V0", "right"];

/// A parameter of the bars and its value, as `right.L=20`.
fn bar(text: &str) -> Result<(Text, Value), String> {
    let (name, value) = text.split_once('=').ok_or("must be NAME=VALUE")?;
    let bars = |name: &str| BARS.contains(&name) || name.starts_with("right.");
    let mut table = BarImpact.parameters().iter().filter(|p| bars(&p.name));
    let Some(parameter) = table.clone().find(|p| p.name == name) else {
        let names: Vec<&str> = table.by_ref().map(|p| &*p.name).collect();
        return Err(format!("unknown {name}, allowed: {}", names.join(", ")));
    };
    let number = value.parse::<f64>().ok().filter(|x| x.is_finite());
    let (found, allowed) = match parameter.kind {
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
    let found = found.ok_or_else(|| format!("{name} must be {allowed}, got {value}"))?;
    Ok((parameter.name.clone(), found))
}

/// What is asked: where to search, for what, and how.
pub struct Meant {
    pub space: Box<dyn Space>,
    pub request: Request,
    /// Name of the folder: each request has its own.
    pub folder: String,
    pub common: Common,
}

impl Asked {
    pub fn meant(self) -> Result<Meant, Error> {
        match self {
            Asked::FrictionOscillator(asked) => Ok(asked.meant()),
            Asked::BarImpact(asked) => asked.meant(),
        }
    }
}

impl Friction {
    fn meant(self) -> Meant {
        let rms = Target {
            name: "rms_error",
            metric: metric(&FrictionOscillator, "rms_error"),
            ideal: 0.0,
            limit: self.rms,
        };
        let chosen = |law: &&'static str| self.law.as_deref().is_none_or(|own| own == *law);
        let space = recommend::friction::Friction {
            laws: LAWS.into_iter().filter(chosen).collect(),
            x0: self.x0,
        };
        let x0 = (self.x0 != X0).then(|| format!("x0-{}", shortest(self.x0)));
        let rms_word = format!("rms-{}", shortest(self.rms));
        Meant {
            folder: folder(&FrictionOscillator, [Some(rms_word), self.law, x0]),
            space: Box::new(space),
            request: Request {
                targets: vec![rms],
                energy_gain: None,
            },
            common: self.common,
        }
    }
}

impl Impact {
    fn meant(mut self) -> Result<Meant, Error> {
        // In the order of the table: the same bars have one folder, whatever the order of the words.
        let row = |name: &str| BarImpact.parameters().iter().position(|p| p.name == name);
        self.bars.sort_by_key(|(name, _)| row(name));
        if let Some(twice) = self.bars.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            return Err(Error::Usage(format!(
                "--bars: {} is given twice",
                twice[0].0
            )));
        }
        let wall = self.bars.iter().any(|(name, _)| *name == "right");
        if let Some((name, _)) = self
            .bars
            .iter()
            .find(|(name, _)| wall && name.starts_with("right."))
        {
            return Err(Error::Usage(format!("--bars: a wall has no {name}")));
        }
        let spring = match (self.gamma, self.k_i) {
            (Some(gamma), _) => Some(("gamma", gamma)),
            (_, k_i) => k_i.map(|k_i| ("k_I", k_i)),
        };
        let mass = MASSES
            .into_iter()
            .find(|mass| self.mass.as_deref() == Some(mass));
        let fixed = Fixed {
            spring,
            n: self.n,
            mass,
            bars: self.bars.clone(),
        };
        let space = recommend::impact::Impact::new(fixed).map_err(|broken| {
            let told = broken
                .iter()
                .map(|v| format!("{}: {}", v.parameter, v.message));
            Error::Usage(told.collect::<Vec<_>>().join("\n"))
        })?;
        let asked = [
            (
                "peak-force-error",
                "peak_force",
                space.peak,
                self.peak_force_error,
            ),
            ("overlap", "max_overlap", 0.0, self.overlap),
            ("r", "rms_error_r", 0.0, self.r),
            ("rdot", "rms_error_rdot", 0.0, self.rdot),
        ];
        let asked = asked.into_iter().filter_map(|(word, name, ideal, limit)| {
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
        let (mut words, targets): (Vec<String>, Vec<Target>) = asked.unzip();
        if self.energy_gain != ENERGY_GAIN {
            words.push(format!("energy-gain-{}", shortest(self.energy_gain)));
        }
        words.extend(self.n.map(|n| format!("n-{n}")));
        words.extend(spring.map(|(name, x)| format!("{name}-{}", shortest(x))));
        words.extend(mass.map(str::to_owned));
        words.extend(
            self.bars
                .iter()
                .map(|(name, value)| format!("{name}-{value}")),
        );
        Ok(Meant {
            folder: folder(&BarImpact, words.into_iter().map(Some)),
            space: Box::new(space),
            request: Request {
                targets,
                energy_gain: Some(self.energy_gain),
            },
            common: self.common,
        })
    }
}

/// The name of a request's folder; a long one ends with a digest in place of its last words.
fn folder(problem: &dyn Problem, words: impl IntoIterator<Item = Option<String>>) -> String {
    let mut all = vec!["recommend".to_owned(), problem.name().to_owned()];
    all.extend(words.into_iter().flatten());
    let name = all.join("-");
    if name.len() <= LONGEST_NAME {
        return name;
    }
    let digest = Sha256::digest(name.as_bytes());
    let digest: String = digest
        .iter()
        .take(8)
        .map(|byte| format!("{byte:02x}"))
        .collect();
    // All words are ASCII.
    format!("{}-{digest}", &name[..LONGEST_NAME])
}

/// Most bytes of a folder's name before its digest: file systems allow 255.
const LONGEST_NAME: usize = 120;
