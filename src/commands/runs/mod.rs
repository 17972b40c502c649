//! The verbs that compute the cases of studies: run with its shards, status, merge, Slurm, and check.

pub(super) mod check;
pub(super) mod merge;
pub(super) mod run;
pub(super) mod sbatch;
pub(super) mod shard;
pub(super) mod status;
