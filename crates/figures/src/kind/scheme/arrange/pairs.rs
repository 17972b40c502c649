//! How the links between two parts of a scheme are drawn: side by side or above one another.

use super::join::{Join, end};
use slipgap_problem::problem::structure::described::scheme::picture::{LinkKind, Place, Scheme};

/// What decides how pairs are drawn.
pub struct Facts<'a> {
    scheme: &'a Scheme,
    /// Steps from the ground through springs and friction; `None` if none lead there.
    steps: Vec<Option<usize>>,
    /// Whether masses and links of all kinds lead to the ground.
    held: Vec<bool>,
    /// Whether friction connects it to the ground.
    pub rests: Vec<bool>,
}

impl Facts<'_> {
    /// The facts of a scheme.
    pub fn of(scheme: &Scheme) -> Facts<'_> {
        let is_bar = |part: usize| scheme.parts[part].elements.is_some();
        let mut rests = vec![false; scheme.parts.len()];
        for link in scheme
            .links
            .iter()
            .filter(|link| link.kind == LinkKind::Friction)
        {
            match [end(link, 0), end(link, 1)] {
                [None, Some((part, _))] | [Some((part, _)), None] => rests[part] = true,
                _ => {}
            }
        }
        Facts {
            scheme,
            steps: steps(scheme, |_| true, |kind| kind != LinkKind::Impact),
            held: steps(scheme, |part| !is_bar(part), |_| true)
                .iter()
                .map(Option::is_some)
                .collect(),
            rests,
        }
    }

    /// How the links between two parts are drawn.
    pub fn of_pair(&self, [a, b]: [usize; 2], links: &[usize]) -> Join {
        let first = &self.scheme.links[links[0]];
        let ends = [end(first, 0), end(first, 1)].map(|end| end.unwrap_or((a, Place::Mass)));
        let [i, j] = ends.map(|end| end.0);
        if i == j {
            return Join::Over(i, j);
        }
        let any = |what: fn(&LinkKind) -> bool| {
            let mut kinds = links.iter().map(|l| &self.scheme.links[*l].kind);
            kinds.any(what)
        };
        let inner = |k: usize| matches!(ends[k].1, Place::Inner(_));
        let friction = any(|kind| *kind == LinkKind::Friction);
        let impact = any(|kind| *kind == LinkKind::Impact);
        let ij = Join::Beside([Some(i), Some(j)]);
        let ji = Join::Beside([Some(j), Some(i)]);
        let bars = [a, b].map(|part| self.scheme.parts[part].elements.is_some());
        match bars {
            [true, true] if inner(0) || inner(1) => Join::Above(Some(i), j),
            [true, true] if ends[0].1 == Place::Left && ends[1].1 == Place::Right => ji,
            [true, true] => ij,
            [false, false] if friction => self.by_steps(i, j),
            [false, false] if impact || self.rests[i] && self.rests[j] => ij,
            [false, false] => self.by_steps(i, j),
            [first_is_bar, _] => {
                let (bar, mass) = if first_is_bar { (a, b) } else { (b, a) };
                let of_bar = if i == bar { 0 } else { 1 };
                let only_impact = !any(|kind| *kind != LinkKind::Impact);
                if !only_impact || inner(of_bar) {
                    // A mass that nothing else holds may be on the bar: the first end is the lower one.
                    match self.held[mass] || i == mass {
                        true => Join::Above(Some(mass), bar),
                        false => Join::Above(Some(bar), mass),
                    }
                } else if ends[of_bar].1 == Place::Left {
                    Join::Beside([Some(mass), Some(bar)])
                } else {
                    Join::Beside([Some(bar), Some(mass)])
                }
            }
        }
    }

    fn by_steps(&self, i: usize, j: usize) -> Join {
        let far = |part: usize| self.steps[part].unwrap_or(usize::MAX);
        match far(j) < far(i) {
            true => Join::Above(Some(j), i),
            false => Join::Above(Some(i), j),
        }
    }
}

/// Steps from the ground to each part through these parts and links.
fn steps(
    scheme: &Scheme,
    through: impl Fn(usize) -> bool,
    by: impl Fn(LinkKind) -> bool,
) -> Vec<Option<usize>> {
    let mut steps: Vec<Option<usize>> = vec![None; scheme.parts.len()];
    // As many rounds as parts reach all.
    for _ in 0..scheme.parts.len() {
        for link in scheme.links.iter().filter(|link| by(link.kind)) {
            let of = |end: Option<(usize, Place)>, steps: &[Option<usize>]| match end {
                None => Some(0),
                Some((part, _)) => steps[part].filter(|_| through(part)),
            };
            for [from, to] in [[0, 1], [1, 0]] {
                if let (Some(known), Some((part, _))) = (of(end(link, from), &steps), end(link, to))
                    && through(part)
                    && steps[part].is_none_or(|step| step > known + 1)
                {
                    steps[part] = Some(known + 1);
                }
            }
        }
    }
    steps
}
