//! The arguments of a search for a friction model.

use super::task::{CommonArgs, SearchTask, choice, folder_name, parse_target};
use clap::Args;
use clap::builder::PossibleValuesParser;
use slipgap::error::Error;
use slipgap::problem::friction::FrictionOscillator;
use slipgap::problem::parameter::shortest;
use slipgap::recommend::friction::{Friction, law_names};
use slipgap::recommend::setting::choices;
use slipgap::recommend::{Fixed, Request, Target, Variants, metric};

const X0: f64 = 12.0;

/// A softened law returns energy that the exact motion has lost. 5 % of the energy is 2.5 % of an amplitude.
const ENERGY_GAIN: f64 = 0.05;

#[derive(Args)]
pub struct FrictionArgs {
    /// Friction law; if left out, all are searched
    #[arg(long, value_name = "LAW", value_parser = PossibleValuesParser::new(law_names()))]
    law: Option<String>,
    /// Method of integration; if left out, all are searched
    #[arg(long, value_name = "METHOD", value_parser = PossibleValuesParser::new(choices(&FrictionOscillator, "method")))]
    method: Option<String>,
    /// Displacement at release over Delta; not 0, from -1000 to 1000
    #[arg(long, value_name = "X0", default_value_t = X0, allow_negative_numbers = true, value_parser = parse_release)]
    x0: f64,
    /// Largest rms_error, the root mean square of the error of X over |x0|
    #[arg(long, value_name = "TARGET", value_parser = parse_target)]
    rms: f64,
    /// Largest excess of energy over the exact motion at any step, relative to the energy at release
    #[arg(long, value_name = "LIMIT", default_value_t = ENERGY_GAIN, value_parser = parse_target)]
    energy_gain: f64,
    #[command(flatten)]
    common: CommonArgs,
}

/// Parses a release whose motion is short enough for a search.
fn parse_release(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(x) if x != 0.0 && x.abs() <= 1000.0 => Ok(x),
        Ok(_) | Err(_) => Err("must be a number from -1000 to 1000, but not 0".into()),
    }
}

impl FrictionArgs {
    /// The search that the arguments define.
    pub fn search_task(self) -> Result<SearchTask, Error> {
        let rms = Target {
            name: "rms_error",
            metric: metric(&FrictionOscillator, "rms_error"),
            ideal: 0.0,
            limit: self.rms,
        };
        let methods = choices(&FrictionOscillator, "method");
        let fixed = Fixed {
            law: choice(&law_names(), self.law.as_ref()),
            method: choice(&methods, self.method.as_ref()),
        };
        let space = Friction::new(fixed, self.x0);
        if space.variants().is_empty() {
            return Err(Error::Usage(
                "--law and --method: this method has no stable step with this law; allowed: a law with compliance, or another method"
                    .into(),
            ));
        }
        let words = [
            Some(format!("rms-{}", shortest(self.rms))),
            self.law,
            self.method,
            (self.x0 != X0).then(|| format!("x0-{}", shortest(self.x0))),
            (self.energy_gain != ENERGY_GAIN)
                .then(|| format!("energy-gain-{}", shortest(self.energy_gain))),
        ];
        Ok(SearchTask {
            folder: folder_name(&FrictionOscillator, words),
            space: Box::new(space),
            request: Request {
                targets: vec![rms],
                energy_gain: self.energy_gain,
                energy_loss: f64::INFINITY,
            },
            common: self.common,
        })
    }
}
