//! The arguments of `slipgap recommend`.

use super::friction::FrictionArgs;
use super::impact::ImpactArgs;
use super::recommend;
use super::study::StudyArgs;
use crate::error::Error;
use clap::{Args, Subcommand};

#[derive(Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub struct RecommendArgs {
    #[command(subcommand)]
    problem: Option<ProblemArgs>,
    #[command(flatten)]
    study: StudyArgs,
}

#[derive(Subcommand)]
enum ProblemArgs {
    /// Find law, method, width and time step of a friction model
    FrictionOscillator(FrictionArgs),
    /// Find law, method, gamma, n, mass matrix and time step for the impact of two bars
    BarImpact(ImpactArgs),
}

impl RecommendArgs {
    /// Searches; returns the exit code.
    pub fn execute(self) -> Result<u8, Error> {
        let task = match self.problem {
            None => return self.study.execute(),
            Some(ProblemArgs::FrictionOscillator(args)) => args.search_task()?,
            Some(ProblemArgs::BarImpact(args)) => args.search_task()?,
        };
        task.common.jobs.run(|| recommend(&task))
    }
}
