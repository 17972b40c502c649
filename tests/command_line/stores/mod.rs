//! Stores and the runs that share one: kept, continued, interrupted, in shards.

#[cfg(unix)]
mod ended;
mod inputs;
#[cfg(unix)]
mod interrupted;
mod kept;
mod large;
mod same_bytes;
mod shards;
mod status;
mod store;
