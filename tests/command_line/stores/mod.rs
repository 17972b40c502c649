//! Stores and the runs that share one: kept, continued, interrupted, in shards.

#[cfg(unix)]
mod ended;
#[cfg(unix)]
mod interrupted;
mod kept;
mod large;
mod same_bytes;
mod shards;
mod status;
mod store;
