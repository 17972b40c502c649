//! The survey: every law with every method on a coarse grid. The best of them are then searched on the fine one.

use super::level::{Found, LevelSearch};
use super::search::too_expensive;
use super::{Answer, Candidate, Grid, Request, Variants, search};
use rayon::prelude::*;

/// Most variants whose fine grids are searched, besides those of the papers.
pub const MOST: usize = 6;

/// Most variants besides, which are the cheapest with their own step only.
pub const MOST_OWN_STEP: usize = 2;

/// Levels searched at once, see [`search`].
const BATCH: usize = 64;

/// Work after which a survey ends, in cases times their cost.
const MOST_WORK: u64 = 500_000_000;

/// What a survey knows of a variant.
#[derive(Debug, Clone)]
pub struct Surveyed {
    /// The cheapest candidate that reaches the target, also with finer steps.
    pub best: Option<Candidate>,
    /// Cost of the cheapest candidate that reaches it only with its own step.
    own_step: Option<u64>,
    /// The smallest `worst` of the others.
    worst: f64,
}

/// The result of a survey.
#[derive(Debug)]
pub struct Survey {
    /// By variant.
    pub variants: Vec<Surveyed>,
    /// All levels up to this cost were searched.
    pub cost: u64,
    /// Number of cases solved.
    pub solved: u64,
}

/// An answer, and how it was found.
#[derive(Debug)]
pub struct Recommendation {
    /// The answer of the fine grids.
    pub answer: Answer,
    /// The survey; `None` if there are few variants.
    pub survey: Option<Survey>,
    /// Indices of the variants with fine grids.
    pub searched: Vec<usize>,
}

/// Searches all variants on coarse grids, if there are many, and the best of them and those of the papers on fine grids.
pub fn recommend(space: &dyn Variants, request: &Request) -> Recommendation {
    let all: Vec<usize> = (0..space.variants().len()).collect();
    let survey = (all.len() > MOST).then(|| survey(&*space.with(&all, Grid::Coarse), request));
    let searched = match &survey {
        None => all,
        Some(survey) => {
            let papers = |at: &usize| space.variants()[*at].of_the_papers();
            let mut searched = survey.cheapest();
            searched.truncate(MOST);
            searched.extend(survey.cheapest_with_own_step());
            searched.extend(all.into_iter().filter(papers));
            searched.sort_unstable();
            searched.dedup();
            searched
        }
    };
    let fine = space.with(&searched, Grid::Fine);
    Recommendation {
        answer: search(fine.space(), request),
        survey,
        searched,
    }
}

/// Searches each variant up to its first candidate that reaches the target.
fn survey(space: &dyn Variants, request: &Request) -> Survey {
    let mut order: Vec<(u64, usize)> = space.costs().into_iter().zip(0..).collect();
    order.sort_unstable();
    let unknown = Surveyed {
        best: None,
        own_step: None,
        worst: f64::INFINITY,
    };
    let mut survey = Survey {
        variants: vec![unknown; space.variants().len()],
        cost: 0,
        solved: 0,
    };
    let mut work: u64 = 0;
    for batch in order.chunks(BATCH) {
        if survey.is_complete(batch[0].0) || work > MOST_WORK || request.stop.is_stopped() {
            break;
        }
        let open = |level: &&(u64, usize)| {
            let variant = &survey.variants[space.variant_of(level.1)];
            variant.best.is_none()
        };
        let levels: Vec<&(u64, usize)> = batch.iter().filter(open).collect();
        let results: Vec<(Found, u64)> = levels
            .par_iter()
            .map(|(cost, index)| {
                if request.stop.is_stopped() {
                    return (Found::default(), 0);
                }
                let limit = survey.variants[space.variant_of(*index)].worst;
                let mut level = LevelSearch::new(space.space(), request, space.level(*index));
                (level.best(*cost, limit), level.solved)
            })
            .collect();
        for ((cost, index), (found, solved)) in levels.into_iter().zip(results) {
            survey.solved += solved;
            work = work.saturating_add(solved.saturating_mul(*cost));
            survey.variants[space.variant_of(*index)].add(found);
        }
        survey.cost = batch.last().map_or(0, |level| level.0);
    }
    survey
}

impl Surveyed {
    fn add(&mut self, found: Found) {
        let own_step = found.own_step.map(|own| own.cost);
        self.own_step = self.own_step.or(own_step);
        let Some(best) = found.best.filter(|best| best.worst < self.worst) else {
            return;
        };
        if best.worst > 1.0 {
            self.worst = best.worst;
        } else if self.best.is_none() {
            self.best = Some(best);
        }
    }

    /// Cost of the best candidate.
    pub fn cost(&self) -> Option<u64> {
        self.best.as_ref().map(|best| best.cost)
    }
}

impl Survey {
    fn is_complete(&self, cost: u64) -> bool {
        let best = self.variants.iter().filter_map(Surveyed::cost).min();
        let own = self.variants.iter().filter_map(|v| v.own_step).min();
        too_expensive(cost, best, own)
    }

    /// The variants, the cheapest first; those that miss the target in the order of their errors.
    fn cheapest(&self) -> Vec<usize> {
        let cost = |cost: Option<u64>| cost.unwrap_or(u64::MAX);
        let mut order: Vec<usize> = (0..self.variants.len()).collect();
        order.sort_by(|a, b| {
            let [a, b] = [*a, *b].map(|at| &self.variants[at]);
            let costs = |v: &Surveyed| [cost(v.cost()), cost(v.own_step)];
            costs(a).cmp(&costs(b)).then(a.worst.total_cmp(&b.worst))
        });
        order
    }

    /// The variants that reach the target with their own step for less than with finer ones, the cheapest first.
    fn cheapest_with_own_step(&self) -> Vec<usize> {
        let mut order: Vec<(u64, usize)> = Vec::new();
        for (at, variant) in self.variants.iter().enumerate() {
            let own = variant.own_step;
            let own = own.filter(|own| variant.cost().is_none_or(|cost| *own < cost));
            order.extend(own.map(|own| (own, at)));
        }
        order.sort_unstable();
        order
            .into_iter()
            .take(MOST_OWN_STEP)
            .map(|(_, at)| at)
            .collect()
    }
}
