//! The arguments of `slipgap recommend`.

use super::friction::FrictionArgs;
use super::impact::ImpactArgs;
use super::recommend;
use super::task::SearchTask;
use clap::Subcommand;
use slipgap::error::Error;

#[derive(Subcommand)]
pub enum RecommendArgs {
    /// Find law, method, width and time step of a friction model
    FrictionOscillator(FrictionArgs),
    /// Find law, method, gamma, n, mass matrix and time step for the impact of two bars
    BarImpact(ImpactArgs),
}

impl RecommendArgs {
    /// Searches; returns the exit code.
    pub fn execute(self) -> Result<u8, Error> {
        let task = self.search_task()?;
        task.common.jobs.run(|| recommend(&task))
    }

    /// The search that the arguments define.
    fn search_task(self) -> Result<SearchTask, Error> {
        match self {
            RecommendArgs::FrictionOscillator(args) => args.search_task(),
            RecommendArgs::BarImpact(args) => args.search_task(),
        }
    }
}
