//! What `slipgap recommend` may be asked, and the words that several verbs share.

use clap::{Args, Subcommand};
use slipgap::problem::{Problem, friction::FrictionOscillator, impact::BarImpact};
use slipgap::recommend::{self, Space, Target};
use std::path::PathBuf;

#[derive(Subcommand)]
pub enum Asked {
    /// Width and step of a friction model
    FrictionOscillator(Friction),
    /// gamma, n and dt for the impact of two equal bars
    BarImpact(Impact),
}

#[derive(Args)]
pub struct Friction {
    /// The friction model
    #[arg(long, value_parser = ["displacement-control", "velocity-control"])]
    law: String,
    /// Release over Delta, not 0, at most 1000
    #[arg(long, value_name = "X0", default_value = "12", allow_negative_numbers = true, value_parser = release)]
    x0: f64,
    /// Largest rms_error, the root mean square of the error of X over |x0|
    #[arg(long, value_name = "TARGET", value_parser = target)]
    rms: f64,
    #[command(flatten)]
    common: Common,
}

#[derive(Args)]
#[group(id = "targets", required = true, multiple = true, args = ["peak_force_error", "overlap"])]
pub struct Impact {
    /// Largest error of the peak force, abs(peak_force - 1), in F0
    #[arg(long, value_name = "TARGET", value_parser = target)]
    peak_force_error: Option<f64>,
    /// Largest overlap, max(-r), in c T_I/2
    #[arg(long, value_name = "TARGET", value_parser = target)]
    overlap: Option<f64>,
    #[command(flatten)]
    common: Common,
}

#[derive(Args)]
pub struct Common {
    /// Folder for the picture and table of the front; a folder is made in it
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
        _ => Err("must be a number, not 0, from -1000 to 1000".into()),
    }
}

#[derive(Args)]
pub struct Jobs {
    /// Number of threads, at most 1024; all cores where it is not given
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub jobs: Option<u16>,
}

impl Asked {
    /// Where to search, for what, and how.
    pub fn meant(self) -> (Box<dyn Space>, Vec<Target>, Common) {
        let row = |problem: &dyn Problem, name: &str| {
            let metrics = problem.metrics().iter();
            metrics.map(|m| m.name).position(|m| m == name).unwrap_or(0)
        };
        match self {
            Asked::FrictionOscillator(asked) => {
                let law = match asked.law.as_str() {
                    "velocity-control" => "velocity-control",
                    _ => "displacement-control",
                };
                let target = Target {
                    name: "rms_error",
                    metric: row(&FrictionOscillator, "rms_error"),
                    ideal: 0.0,
                    limit: asked.rms,
                };
                let space = recommend::friction::Friction { law, x0: asked.x0 };
                (Box::new(space), vec![target], asked.common)
            }
            Asked::BarImpact(asked) => {
                let force = asked.peak_force_error.map(|limit| Target {
                    name: "abs(peak_force - 1)",
                    metric: row(&BarImpact, "peak_force"),
                    ideal: 1.0,
                    limit,
                });
                let overlap = asked.overlap.map(|limit| Target {
                    name: "max_overlap",
                    metric: row(&BarImpact, "max_overlap"),
                    ideal: 0.0,
                    limit,
                });
                let targets = force.into_iter().chain(overlap).collect();
                (Box::new(recommend::impact::Impact), targets, asked.common)
            }
        }
    }
}
