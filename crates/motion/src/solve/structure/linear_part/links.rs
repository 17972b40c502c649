//! K and C as springs, dashpots and couplings, and the rows of Khat with its factor.

use crate::system::structure::sparse::factor::{Blocks, Columns, Entry, Factor, Triangle};
use crate::system::structure::{Structure, Symmetric};

/// A row of Khat/4. Most nodes have one neighbour that is eliminated later, in trees all of them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Row {
    /// The first neighbour that is eliminated later; the ground if there is none.
    pub(crate) to: usize,
    /// Stiffness between both.
    pub(crate) k: f64,
    /// c/dt between both.
    pub(crate) c: f64,
    /// Entry of L in row `to`.
    pub(crate) l: f64,
    /// 1/D.
    pub(crate) reciprocal: f64,
    /// Whether L has more entries in this column.
    pub(crate) more: bool,
}

/// Spring and dashpot between two places, which fit in 32 bits: the matrices of a step have 24 bytes for each place of K and C.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Link {
    from: u32,
    to: u32,
    /// Stiffness.
    pub(crate) k: f64,
    /// c/dt.
    pub(crate) c: f64,
}

impl Link {
    #[inline(always)]
    fn new([i, j]: [usize; 2], k: f64, c: f64) -> Link {
        let [from, to] = [i.min(j), i.max(j)].map(|row| row as u32);
        Link { from, to, k, c }
    }

    /// The smaller place and the other one.
    #[inline(always)]
    pub(crate) fn ends(&self) -> [usize; 2] {
        [self.from as usize, self.to as usize]
    }
}

/// K and C as springs and dashpots between places of one direction and to the ground, and as couplings of different directions,
/// whose k and c are entries of K and C.
///
/// Differences of displacements are exact where neighbours move alike, while the terms of a row of K cancel. Between a
/// displacement and a rotation there is no such difference: their sizes depend on the units.
pub(crate) fn links(structure: &Structure, row_of: &[usize], dt: f64) -> [Vec<Link>; 2] {
    let n = structure.len();
    let direction = |node: usize| structure.nodes[node].direction;
    // Vectors that grow would take twice the memory.
    let entries = [&structure.stiffness, &structure.damping].map(Symmetric::entries);
    let others = entries.into_iter().flatten().filter(|((i, j), _)| i != j);
    let [mut inside, mut crossing] = [n, 0];
    for ((i, j), _) in others {
        match direction(i) == direction(j) {
            true => inside += 1,
            false => crossing += 1,
        }
    }
    let (mut links, mut couplings) = (Vec::with_capacity(inside), Vec::with_capacity(crossing));
    for (matrix, damps) in [(&structure.stiffness, false), (&structure.damping, true)] {
        let between = |places: [usize; 2], value: f64| match damps {
            false => Link::new(places, value, 0.0),
            true => Link::new(places, 0.0, value * (1.0 / dt)),
        };
        // The sum of a row is the spring to the ground. For a row without ground it is round-off.
        let (mut sums, mut sizes) = (vec![0.0; n], vec![0.0; n]);
        for ((i, j), value) in matrix.entries() {
            let places = [row_of[i], row_of[j]];
            if direction(i) != direction(j) {
                if value != 0.0 {
                    couplings.push(between(places, value));
                }
                continue;
            }
            for row in [Some(i), (i != j).then_some(j)].into_iter().flatten() {
                sums[row] += value;
                sizes[row] += value.abs();
            }
            if i != j && value != 0.0 {
                links.push(between(places, -value));
            }
        }
        for (i, (sum, size)) in sums.into_iter().zip(sizes).enumerate() {
            if f64::abs(sum) > 4.0 * f64::EPSILON * size {
                links.push(between([row_of[i], n], sum));
            }
        }
    }
    [links, couplings].map(merged)
}

/// The same with one link between two places, by places.
fn merged(mut links: Vec<Link>) -> Vec<Link> {
    links.sort_unstable_by_key(|link| (link.from, link.to));
    links.dedup_by(|link, kept| {
        let same = (link.from, link.to) == (kept.from, kept.to);
        if same {
            kept.k += link.k;
            kept.c += link.c;
        }
        same
    });
    links
}

/// Khat = L D L^T and its links, as steps go through them.
#[derive(Debug, Clone)]
pub(crate) struct Elimination {
    /// The rows of the matrix; none where L has much fill-in.
    pub(crate) rows: Vec<Row>,
    /// Entries of L that are in no row.
    pub(crate) more: Columns,
    /// L and D where L has much fill-in.
    pub(crate) blocks: Option<Blocks>,
    /// Links that are in no row. The place behind the last one is the ground.
    pub(crate) links: Vec<Link>,
}

impl Elimination {
    /// Of a factor and all links.
    pub(crate) fn new(factor: Factor, mut links: Vec<Link>) -> Elimination {
        let n = factor.order().len();
        let (reciprocals, columns) = match factor.into_triangle() {
            Triangle::Columns {
                reciprocals,
                columns,
            } => (reciprocals, columns),
            Triangle::Blocks(blocks) => {
                return Elimination {
                    rows: Vec::new(),
                    more: Columns::none(),
                    blocks: Some(blocks),
                    links,
                };
            }
        };
        let row = |(i, reciprocal): (usize, &f64)| {
            let (first, others) = match columns.column(i) {
                [first, others @ ..] => (*first, others),
                [] => (Entry { at: n, value: 0.0 }, &[][..]),
            };
            Row {
                to: first.at,
                k: 0.0,
                c: 0.0,
                l: first.value,
                reciprocal: *reciprocal,
                more: !others.is_empty(),
            }
        };
        let mut rows: Vec<Row> = reciprocals.iter().enumerate().map(row).collect();
        links.retain(|link| {
            let [from, to] = link.ends();
            let row = &mut rows[from];
            let is_own = row.to == to;
            if is_own {
                (row.k, row.c) = (link.k, link.c);
            }
            !is_own
        });
        Elimination {
            rows,
            more: columns.without_first(),
            blocks: None,
            links,
        }
    }

    /// Without rows.
    pub(crate) fn none() -> Elimination {
        Elimination {
            rows: Vec::new(),
            more: Columns::none(),
            blocks: None,
            links: Vec::new(),
        }
    }

    /// All springs and dashpots.
    #[inline(always)]
    pub(crate) fn all_links(&self) -> impl Iterator<Item = Link> + '_ {
        let link = |(from, row): (usize, &Row)| Link::new([from, row.to], row.k, row.c);
        let of_rows = self.rows.iter().enumerate().map(link);
        of_rows.chain(self.links.iter().copied())
    }
}
