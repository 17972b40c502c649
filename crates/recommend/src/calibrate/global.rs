//! The search over all points: independent starts next to one another, until enough of them end at the same minimum.

use super::counted::{Counted, Round, round};
use super::ends::Ends;
use super::search_start::Start;
use super::{Best, Objective, Options, Stopped};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use slipgap_study::{Design, Sampling};

/// Starts and points of a generation in the first round; later rounds have fewer starts with twice the points.
const FIRST: [usize; 2] = [4, 32];

/// Points of the Sobol' sequence from which starts are chosen in each round.
const POINTS: usize = 128;

/// Rounds of first points after which a search without any solution ends.
const HOPELESS: usize = 16;

/// Searches the smallest misfit over all points. It spends three quarters of the cases at most: the rest is for [`determine`](super::determine).
///
/// # Errors
/// The user ended the search.
pub fn search(
    dimensions: usize,
    objective: &mut dyn Objective,
    options: &Options,
) -> Result<Best, Stopped> {
    let limit = (options.cases - options.cases / 4).max(1);
    let mut counted = Counted::new(objective, limit);
    let mut ends = Ends {
        all: Vec::new(),
        usual: f64::INFINITY,
        jumps: f64::INFINITY,
    };
    let mut rounds = 0;
    let spent = loop {
        let [count, population] = match rounds {
            0 => FIRST,
            _ => [
                (FIRST[0] >> rounds.min(2)).max(1),
                FIRST[1] << rounds.min(10),
            ],
        };
        let points = sequence(
            dimensions,
            options.seed,
            rounds * POINTS,
            POINTS.min(counted.left() as usize),
        );
        let Some(misfits) = counted.misfits(&points)?.filter(|_| !points.is_empty()) else {
            break true;
        };
        if ends.usual.is_infinite() {
            ends.usual = median(&misfits);
        }
        // Successive points of the sequence are as evenly distributed as all.
        let size = points.len().div_ceil(count);
        let first = |start: usize| {
            let block = start * size..points.len().min((start + 1) * size);
            let best = block.min_by(|a, b| misfits[*a].total_cmp(&misfits[*b]))?;
            let mut random = ChaCha8Rng::seed_from_u64(options.seed);
            random.set_stream((1 << 32) + ((rounds as u64) << 8) + start as u64);
            Some(Start::new(
                (points[best].clone(), misfits[best]),
                ends.usual,
                population,
                random,
            ))
        };
        let mut starts: Vec<Start> = (0..count).filter_map(first).collect();
        let spent = loop {
            match round(&mut starts, &mut counted)? {
                Round::Next => {}
                Round::Ended => break false,
                Round::Spent => break true,
            }
        };
        for start in starts.into_iter().filter(Start::has_ended) {
            ends.jumps = ends.jumps.min(start.residual());
            ends.all.push(start.best);
        }
        rounds += 1;
        let hopeless = ends.usual.is_infinite() && rounds >= HOPELESS;
        if spent || hopeless || ends.agree(&mut counted)? {
            break spent;
        }
    };
    let solved = counted.solved;
    let (at, misfit) = counted
        .best
        .unwrap_or((vec![0.5; dimensions], f64::INFINITY));
    Ok(Best {
        at,
        misfit,
        solved,
        starts: [ends.equal(misfit), ends.all.len()],
        spent,
    })
}

/// The middle of the finite values; infinite without any.
fn median(values: &[f64]) -> f64 {
    let mut finite: Vec<f64> = values.iter().copied().filter(|x| x.is_finite()).collect();
    finite.sort_by(f64::total_cmp);
    finite
        .get(finite.len() / 2)
        .copied()
        .unwrap_or(f64::INFINITY)
}

/// Points of a Sobol' sequence with a random shift, from the one at `first` on.
fn sequence(dimensions: usize, seed: u64, first: usize, count: usize) -> Vec<Vec<f64>> {
    let design = Design {
        sampling: Sampling::Sobol,
        n: (first + count) as u64,
        seed,
        parameters: Vec::new(),
        scales: Vec::new(),
    };
    let coordinates: Vec<Vec<f64>> = (0..dimensions).map(|k| design.coordinates(k)).collect();
    let point = |i: usize| coordinates.iter().map(|line| line[i]).collect();
    (first..first + count).map(point).collect()
}
