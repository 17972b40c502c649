//! Numbers that describe many values: quantiles, distributions and their intervals, tests. They know no studies.

pub mod quantile;
