//! The arguments of a search for a friction model.

use super::task::{CommonArgs, SearchTask, folder_name, parse_target};
use clap::Args;
use slipgap::problem::friction::FrictionOscillator;
use slipgap::problem::parameter::shortest;
use slipgap::recommend::friction::Friction;
use slipgap::recommend::{Request, Target, metric};

const LAWS: [&str; 2] = ["displacement-control", "velocity-control"];
const X0: f64 = 12.0;

#[derive(Args)]
pub struct FrictionArgs {
    /// Friction law; if left out, both are searched
    #[arg(long, value_parser = LAWS)]
    law: Option<String>,
    /// Displacement at release over Delta; not 0, from -1000 to 1000
    #[arg(long, value_name = "X0", default_value_t = X0, allow_negative_numbers = true, value_parser = parse_release)]
    x0: f64,
    /// Largest rms_error, the root mean square of the error of X over |x0|
    #[arg(long, value_name = "TARGET", value_parser = parse_target)]
    rms: f64,
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
    pub fn search_task(self) -> SearchTask {
        let rms = Target {
            name: "rms_error",
            metric: metric(&FrictionOscillator, "rms_error"),
            ideal: 0.0,
            limit: self.rms,
        };
        let searched = |law: &&'static str| self.law.as_deref().is_none_or(|only| only == *law);
        let space = Friction {
            laws: LAWS.into_iter().filter(searched).collect(),
            x0: self.x0,
        };
        let x0 = (self.x0 != X0).then(|| format!("x0-{}", shortest(self.x0)));
        let rms_name = format!("rms-{}", shortest(self.rms));
        SearchTask {
            folder: folder_name(&FrictionOscillator, [Some(rms_name), self.law, x0]),
            space: Box::new(space),
            request: Request {
                targets: vec![rms],
                energy_gain: None,
            },
            common: self.common,
        }
    }
}
