//! The arguments of a search for an impact of two bars.

use super::task::{CommonArgs, SearchTask, parse_target};
use crate::commands::arguments::Expected;
use crate::error::Error;
use crate::problem::impact::BarImpact;
use crate::problem::numbers::parameter::Value;
use crate::problem::table::schema::Text;
use crate::recommend::impact::{ENERGY_GAIN, ENERGY_LOSS, ImpactTask, bar};
use crate::recommend::setting::choices;
use clap::Args;
use clap::builder::PossibleValuesParser;

/// The names of a parameter of the bars.
fn names(parameter: &str) -> Vec<&'static str> {
    choices(&BarImpact, parameter)
}

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

/// Parses a parameter of the bars with its value, as in `right.L=20`.
fn parse_bar(text: &str) -> Result<(Text, Value), Box<dyn std::error::Error + Send + Sync>> {
    let pair = text.split_once('=');
    let (name, value) = pair.ok_or(Expected("NAME=VALUE".into()))?;
    Ok(bar(name, value)?)
}

impl ImpactArgs {
    /// The search that the arguments define.
    pub fn search_task(self) -> Result<SearchTask, Error> {
        let task = ImpactTask {
            peak_force_error: self.peak_force_error,
            overlap: self.overlap,
            r: self.r,
            rdot: self.rdot,
            law: self.law,
            method: self.method,
            energy_gain: self.energy_gain,
            energy_loss: self.energy_loss,
            n: self.n,
            gamma: self.gamma,
            k_i: self.k_i,
            mass: self.mass,
            bars: self.bars,
        };
        Ok(SearchTask {
            search: task.search()?,
            common: self.common,
        })
    }
}
