//! Where vertical links are from left to right: straight below their upper parts, or around parts that are in between.

use super::super::arrange::join::Join;
use super::super::symbols::{self, NAME_GAP, length};
use super::painter::Painter;

/// Distance from what a link is led around.
const CLEAR: f64 = 5.0;

/// From where to where something is.
type Interval = [f64; 2];

impl Painter<'_> {
    /// The middle of the symbol of each vertical link; `None` for others.
    pub fn vertical(&self) -> Vec<Option<f64>> {
        let links = 0..self.scheme.links.len();
        let crosses = |l: &usize| {
            let x = self.straight(*l)?;
            let parts = self.between(*l, self.half(*l));
            Some(!is_free(x, &parts))
        };
        let (around, straight): (Vec<usize>, Vec<usize>) =
            links.clone().partition(|l| crosses(l) == Some(true));
        let mut middles = vec![None; links.len()];
        for l in straight {
            middles[l] = self.straight(l);
        }
        for l in around {
            middles[l] = self.around(l, &middles);
        }
        middles
    }

    /// The place straight below the upper part of a vertical link.
    pub fn straight(&self, l: usize) -> Option<f64> {
        let slot = self.sizes.slots[l]?;
        Some(self.rects[slot.of].left + self.sizes.offset(slot))
    }

    /// The lower and the upper part of a vertical link.
    fn lower_and_upper(&self, l: usize) -> Option<(Option<usize>, usize)> {
        match self.relations.joins[l] {
            Join::Above(lower, upper) => Some((lower, upper)),
            Join::Beside(_) | Join::Over(..) => None,
        }
    }

    fn half(&self, l: usize) -> f64 {
        symbols::across(self.scheme.links[l].kind) / 2.0
    }

    /// How far a symbol reaches to the left and to the right of its middle with its name.
    fn reach(&self, l: usize) -> [f64; 2] {
        let half = self.half(l);
        let name = &self.scheme.links[l].name;
        let named = match name.is_empty() {
            true => half,
            false => half + NAME_GAP + length(name),
        };
        match self.sizes.slots[l].is_some_and(|slot| slot.name_right) {
            true => [half, named],
            false => [named, half],
        }
    }

    /// Where the middle of a vertical link would be on or too near to a part between its own.
    fn between(&self, l: usize, half: f64) -> Vec<Interval> {
        let rows = &self.relations.rows;
        let Some((lower, upper)) = self.lower_and_upper(l) else {
            return Vec::new();
        };
        let between = (0..self.rects.len()).filter(|part| {
            rows[*part] < rows[upper] && lower.is_none_or(|lower| rows[*part] > rows[lower])
        });
        let rects = between.map(|part| &self.rects[part]);
        rects
            .map(|rect| [rect.left - half - CLEAR, rect.right() + half + CLEAR])
            .collect()
    }

    /// The nearest free place beside the parts in between, where no other symbol is; those at `middles` have theirs.
    fn around(&self, l: usize, middles: &[Option<f64>]) -> Option<f64> {
        let x = self.straight(l)?;
        let (lower, upper) = self.lower_and_upper(l)?;
        let row = |part: Option<usize>| part.map(|part| self.relations.rows[part]);
        let mut taken = self.between(l, self.half(l));
        let [left, right] = self.reach(l);
        for (other, middle) in middles.iter().enumerate() {
            if let Some((at, (under, _))) = middle.zip(self.lower_and_upper(other))
                && row(under) == row(lower)
            {
                let [low, high] = self.reach(other);
                taken.push([at - low - right - CLEAR, at + high + left + CLEAR]);
            }
        }
        // A rod that crosses other links below its upper part is worse than a long one.
        let crossed = |to: f64| {
            let others = middles.iter().enumerate().filter(|(other, _)| {
                self.lower_and_upper(*other)
                    .is_some_and(|rows| rows.1 == upper)
            });
            let places = others.filter_map(|(other, _)| self.straight(other));
            places
                .filter(|edge| *edge != x && x.min(to) <= *edge && *edge <= x.max(to))
                .count()
        };
        let ends = taken.iter().flatten().copied();
        let nearest = ends.filter(|end| is_free(*end, &taken)).min_by(|a, b| {
            let far = |end: f64| (end - x).abs();
            crossed(*a)
                .cmp(&crossed(*b))
                .then(far(*a).total_cmp(&far(*b)))
        });
        nearest.or(Some(x))
    }
}

fn is_free(x: f64, taken: &[Interval]) -> bool {
    !taken.iter().any(|[low, high]| *low < x && x < *high)
}
