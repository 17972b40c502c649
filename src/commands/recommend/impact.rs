//! The arguments of a search for an impact of two bars.

use super::task::{CommonArgs, SearchTask, choice, folder_name, parse_target};
use clap::Args;
use clap::builder::PossibleValuesParser;
use slipgap::error::Error;
use slipgap::problem::Problem;
use slipgap::problem::impact::BarImpact;
use slipgap::problem::parameter::{Kind, Value, shortest};
use slipgap::problem::schema::Text;
use slipgap::recommend::impact::{FixedParameters, Impact};
use slipgap::recommend::setting::choices;
use slipgap::recommend::{Fixed, Request, Target, metric};

/// The names of a parameter of the bars.
fn names(parameter: &str) -> Vec<&'static str> {
    choices(&BarImpact, parameter)
}

/// The exact motion keeps its energy. A gain of 1 % of the energy is 0.5 % of a velocity, less than most targets allow.
const ENERGY_GAIN: f64 = 0.01;

/// A loss of 10 % of the energy is 5 % of a velocity. Without a limit the search would choose methods that damp the whole motion.
const ENERGY_LOSS: f64 = 0.1;

#[derive(Args)]
#[group(id = "targets", required = true, multiple = true, args = ["peak_force_error", "overlap", "r", "rdot"])]
pub struct ImpactArgs {
    /// Largest error of the peak force, relative to the exact peak
    #[arg(long, value_name = "TARGET", value_parser = parse_target)]
    peak_force_error: Option<f64>,
    /// Largest overlap, max(-r), in c T_I/2
    #[arg(long, value_name = "TARGET", value_parser = parse_target)]
    overlap: Option<f64>,
    /// Largest rms_error_r, in c T_I/2
    #[arg(long, value_name = "TARGET", value_parser = parse_target)]
    r: Option<f64>,
    /// Largest rms_error_rdot, in c
    #[arg(long, value_name = "TARGET", value_parser = parse_target)]
    rdot: Option<f64>,
    /// Contact law; if left out, all are searched
    #[arg(long, value_name = "LAW", value_parser = PossibleValuesParser::new(names("law")))]
    law: Option<String>,
    /// Method of integration; if left out, all are searched
    #[arg(long, value_name = "METHOD", value_parser = PossibleValuesParser::new(names("method")))]
    method: Option<String>,
    /// Largest gain of energy at any step, relative to the initial energy; 1 % of the energy is 0.5 % of a velocity
    #[arg(long, value_name = "LIMIT", default_value_t = ENERGY_GAIN, value_parser = parse_target)]
    energy_gain: f64,
    /// Largest loss of energy up to the last step, by contact and method, relative to the initial energy
    #[arg(long, value_name = "LIMIT", default_value_t = ENERGY_LOSS, value_parser = parse_target)]
    energy_loss: f64,
    /// Elements of the left bar, at most 1000; if left out, it is searched
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    n: Option<u32>,
    /// Stiffness of the contact over that of an element, for laws with delta^1.5 the secant stiffness at F0; if neither gamma nor k_I is given, it is searched
    #[arg(long, value_name = "GAMMA", value_parser = parse_target)]
    gamma: Option<f64>,
    /// Stiffness of the contact, in the units of the bars; gamma = k_I L/(n E A) follows from n
    #[arg(long = "k_I", alias = "k-I", value_name = "K_I", value_parser = parse_target, conflicts_with = "gamma")]
    k_i: Option<f64>,
    /// Mass matrix; if left out, all are searched
    #[arg(long, value_name = "MASS", value_parser = PossibleValuesParser::new(names("mass")))]
    mass: Option<String>,
    /// Data of the bars as in a study, e.g. L=40,right.L=20 or right=wall
    #[arg(long, value_name = "NAME=VALUE", value_delimiter = ',', value_parser = parse_bar)]
    bars: Vec<(Text, Value)>,
    #[command(flatten)]
    common: CommonArgs,
}

/// Parameters of the bars, apart from those of the right bar.
const BARS: [&str; 6] = ["E", "A", "rho", "L", "V0", "right"];

/// Parses a parameter of the bars with its value, as in `right.L=20`.
fn parse_bar(text: &str) -> Result<(Text, Value), String> {
    let (name, value) = text.split_once('=').ok_or("must be NAME=VALUE")?;
    let bars = |name: &str| BARS.contains(&name) || name.starts_with("right.");
    let mut table = BarImpact.parameters().iter().filter(|p| bars(&p.name));
    let Some(parameter) = table.clone().find(|p| p.name == name) else {
        let names: Vec<&str> = table.by_ref().map(|p| &*p.name).collect();
        return Err(format!("unknown {name}, allowed: {}", names.join(", ")));
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
    let value = parsed.ok_or_else(|| format!("{name} must be {allowed}, got {value}"))?;
    Ok((parameter.name.clone(), value))
}

impl ImpactArgs {
    /// The search that the arguments define.
    pub fn search_task(mut self) -> Result<SearchTask, Error> {
        // In the order of the table, so that the name of the folder does not depend on the order of the arguments.
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
        let gamma = self.gamma.map(|gamma| ("gamma", gamma));
        let spring = gamma.or(self.k_i.map(|k_i| ("k_I", k_i)));
        let mass = choice(&names("mass"), self.mass.as_ref());
        let fixed = FixedParameters {
            choice: Fixed {
                law: choice(&names("law"), self.law.as_ref()),
                method: choice(&names("method"), self.method.as_ref()),
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
        let targets = [
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
        let targets = targets
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
        let (mut words, targets): (Vec<String>, Vec<Target>) = targets.unzip();
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
        words.extend(
            self.bars
                .iter()
                .map(|(name, value)| format!("{name}-{value}")),
        );
        Ok(SearchTask {
            folder: folder_name(&BarImpact, words.into_iter().map(Some)),
            space: Box::new(space),
            request: Request {
                targets,
                energy_gain: self.energy_gain,
                energy_loss: self.energy_loss,
            },
            common: self.common,
        })
    }
}
