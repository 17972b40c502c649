//! The cases of a study in chunks and parts, in order, divided into shards.

pub mod chunk;
pub mod pipeline;
pub(super) mod queue;
pub(super) mod shard;
