//! `slipgap run --shard I/N`: the parts of one shard of every study, kept in the stores and nowhere else.

use crate::batch::store::Store;
use crate::batch::{Shard, ShardResult, run_shard};
use crate::commands::arguments::sources::Source;
use crate::commands::terminal::{note, progress};
use crate::error::Error;
use std::path::Path;

/// Computes the parts of the shard into the stores in `out`; returns the exit code. A case that cannot be solved is a row.
pub fn run(sources: &[Source], out: &Path, shard: Shard) -> Result<u8, Error> {
    // All folders are made first: one that cannot be made ends the command before any computing.
    for source in sources {
        Store::open_shared(&out.join(&source.name))?;
    }
    for source in sources {
        let name = format!("{}, shard {shard}", source.name);
        let store = Store::open_shared(&out.join(&source.name))?;
        let bar = progress::counter(&name);
        let result = run_shard(&source.study, shard, &store, &bar)?;
        bar.finish_and_clear();
        note(&summary(&name, result));
    }
    Ok(0)
}

/// One line about the parts of a shard.
fn summary(name: &str, result: ShardResult) -> String {
    let ShardResult {
        parts,
        computed,
        unsolved,
    } = result;
    let of_parts = if parts == 1 { "part" } else { "parts" };
    let mut line = format!("{name}: {computed} of {parts} {of_parts} computed");
    if computed < parts {
        line += &format!(", {} in the store already", parts - computed);
    }
    match unsolved {
        0 => line,
        1 => line + "; 1 case could not be solved",
        _ => line + &format!("; {unsolved} cases could not be solved"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_counts_parts_and_unsolved_cases() {
        let line = |parts, computed, unsolved| {
            let result = ShardResult {
                parts,
                computed,
                unsolved,
            };
            summary("s, shard 2/3", result)
        };
        assert_eq!(line(4, 4, 0), "s, shard 2/3: 4 of 4 parts computed");
        assert_eq!(
            line(1, 0, 0),
            "s, shard 2/3: 0 of 1 part computed, 1 in the store already"
        );
        assert_eq!(
            line(7, 5, 2),
            "s, shard 2/3: 5 of 7 parts computed, 2 in the store already; 2 cases could not be solved"
        );
        // More shards than parts.
        assert_eq!(line(0, 0, 0), "s, shard 2/3: 0 of 0 parts computed");
    }
}
