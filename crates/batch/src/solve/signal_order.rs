//! The order of cases in which every sampled signal is made once.

use slipgap_problem::problem::Samples;
use slipgap_problem::problem::structure::MOST_SAMPLED;
use slipgap_problem::problem::table::cases::Cases;
use slipgap_study::Study;
use std::collections::BTreeMap;

/// The rows in blocks whose sampled signals fit in memory, in the order of their first use; one block if all of them fit. In a
/// block the order of the rows stays. Blocks that are computed one after the other need each signal in one block only.
pub(crate) fn signal_order(study: &Study, cases: &Cases, rows: Vec<u32>) -> Vec<Vec<u32>> {
    let mut shown = cases.shown();
    let mut samples = |row: &u32| study.samples(shown.at(*row as usize));
    match rows.first() {
        None => return Vec::new(),
        Some(first) if samples(first).key.is_empty() => return vec![rows],
        Some(_) => {}
    }
    // Each thread may compute another part of the study, and half of what is kept is dropped at a time.
    let room = MOST_SAMPLED / (2 * rayon::current_num_threads());
    let mut blocks: Vec<Vec<u32>> = vec![Vec::new()];
    let mut known: BTreeMap<Samples, usize> = BTreeMap::new();
    let (mut used, mut total) = (0, 0);
    for row in &rows {
        let samples = samples(row);
        let block = match known.get(&samples) {
            Some(block) => *block,
            None => {
                if used + samples.numbers > room && used > 0 {
                    blocks.push(Vec::new());
                    used = 0;
                }
                used += samples.numbers;
                total += samples.numbers;
                known.insert(samples, blocks.len() - 1);
                blocks.len() - 1
            }
        };
        blocks[block].push(*row);
    }
    match total <= MOST_SAMPLED {
        true => vec![rows],
        false => blocks,
    }
}
