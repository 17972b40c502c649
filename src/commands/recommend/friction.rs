//! The arguments of a search for a friction model.

use super::task::{CommonArgs, SearchTask, parse_target};
use crate::error::Error;
use crate::problem::friction::FrictionOscillator;
use crate::recommend::friction::{ENERGY_GAIN, FrictionTask, Releases, X0, law_names};
use crate::recommend::setting::choices;
use clap::Args;
use clap::builder::PossibleValuesParser;

#[derive(Args)]
pub struct FrictionArgs {
    /// Friction law; if left out, all are searched
    #[arg(long, value_name = "LAW", value_parser = PossibleValuesParser::new(law_names()))]
    law: Option<String>,
    /// Method of integration; if left out, all are searched
    #[arg(long, value_name = "METHOD", value_parser = PossibleValuesParser::new(choices(&FrictionOscillator, "method")))]
    method: Option<String>,
    /// Displacements at release over Delta for which the answer must hold: a range, or one number from -1000 to 1000, not 0
    #[arg(long, value_name = "X0", default_value_t = X0, allow_negative_numbers = true)]
    x0: Releases,
    /// Largest rms_error, the root mean square of the error of X over |x0|
    #[arg(long, value_name = "TARGET", value_parser = parse_target)]
    rms: f64,
    /// Largest excess of energy over the exact motion at any step, relative to the energy at release
    #[arg(long, value_name = "LIMIT", default_value_t = ENERGY_GAIN, value_parser = parse_target)]
    energy_gain: f64,
    #[command(flatten)]
    common: CommonArgs,
}

impl FrictionArgs {
    /// The search that the arguments define.
    pub fn search_task(self) -> Result<SearchTask, Error> {
        let task = FrictionTask {
            law: self.law,
            method: self.method,
            x0: self.x0,
            rms: self.rms,
            energy_gain: self.energy_gain,
        };
        Ok(SearchTask {
            search: task.search()?,
            common: self.common,
        })
    }
}
