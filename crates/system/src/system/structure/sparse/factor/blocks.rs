//! A factor with much fill-in in memory.

use super::Entry;
use super::panels::Panel;
use super::products::products;
use crate::lane::Lane;
use slipgap_contact::for_wide;
use std::ops::Range;

/// Most columns of a group.
const GROUP: usize = 4;

/// L and D by panels, whose columns share the numbers of the rows below them.
///
/// A solution takes as long as its way through memory. Here that is 8 bytes for an entry, half as many as in columns with their
/// rows, and in one direction: the columns of a panel form groups of up to four, whose entries follow one another row by row. All
/// sums have an order that does not depend on the number of lanes.
#[derive(Debug, Clone)]
pub struct Blocks {
    blocks: Vec<Block>,
    /// Rows below each panel.
    rows: Vec<u32>,
    /// Entries of L by groups: first those in the rows of the group by columns, then all others by rows.
    values: Vec<f64>,
    /// 1/D.
    reciprocals: Vec<f64>,
}

/// A panel.
#[derive(Debug, Clone, Copy)]
struct Block {
    first: usize,
    /// The column after the last one.
    end: usize,
    /// Places of its first row and of the first after its rows.
    rows: [usize; 2],
    /// Place of its first entry.
    values: usize,
}

/// Number of entries of so many columns in the rows of one another.
fn inside(columns: usize) -> usize {
    columns * columns.saturating_sub(1) / 2
}

impl Block {
    /// The groups: their columns and the place of their first entry.
    fn groups(&self) -> impl Iterator<Item = (Range<usize>, usize)> + '_ {
        let mut start = self.values;
        (self.first..self.end).step_by(GROUP).map(move |first| {
            let columns = first..self.end.min(first + GROUP);
            let first = start;
            start += self.entries(&columns);
            (columns, first)
        })
    }

    /// Number of entries of a group.
    #[inline(always)]
    fn entries(&self, columns: &Range<usize>) -> usize {
        let below = self.end - columns.end + self.rows[1] - self.rows[0];
        inside(columns.len()) + columns.len() * below
    }
}

impl Blocks {
    /// The entries of L by columns, and D, of fewer than 2^32 rows.
    pub(super) fn new(panels: &[Panel], pivots: &[f64], by_columns: Vec<f64>) -> Blocks {
        let mut blocks = Vec::with_capacity(panels.len());
        let count = panels.iter().map(|panel| panel.rows.len()).sum();
        let mut rows = Vec::with_capacity(count);
        // A panel has the same place in both orders.
        let mut values = by_columns;
        let (mut start, mut panel_by_columns) = (0, Vec::new());
        for panel in panels {
            let first_row = rows.len();
            rows.extend(panel.rows.iter().map(|row| *row as u32));
            let block = Block {
                first: panel.first,
                end: panel.end,
                rows: [first_row, rows.len()],
                values: start,
            };
            let columns = panel.first..panel.end;
            let end = start + columns.map(|column| panel.entries(column)).sum::<usize>();
            panel_by_columns.clear();
            panel_by_columns.extend_from_slice(&values[start..end]);
            let mut left = &panel_by_columns[..];
            let mut to = values[start..end].iter_mut();
            let mut write = |from: &f64| {
                if let Some(to) = to.next() {
                    *to = *from;
                }
            };
            for (columns, _) in block.groups() {
                let mut below = [&[][..]; GROUP];
                for (column, below) in columns.clone().zip(&mut below) {
                    let (column_values, after) = left.split_at(panel.entries(column));
                    let (inside, below_diagonal) = column_values.split_at(columns.end - 1 - column);
                    inside.iter().for_each(&mut write);
                    (*below, left) = (below_diagonal, after);
                }
                for row in 0..below[0].len() {
                    let inside = &below[..columns.len()];
                    inside.iter().for_each(|column| write(&column[row]));
                }
            }
            start = end;
            blocks.push(block);
        }
        Blocks {
            blocks,
            rows,
            values,
            reciprocals: pivots.iter().map(|pivot| 1.0 / pivot).collect(),
        }
    }

    /// 1/D.
    pub fn reciprocals(&self) -> &[f64] {
        &self.reciprocals
    }

    /// Its size in memory.
    pub(super) fn bytes(&self) -> usize {
        let numbers = size_of_val(&self.values[..]) + size_of_val(&self.reciprocals[..]);
        size_of_val(&self.blocks[..]) + size_of_val(&self.rows[..]) + numbers
    }

    /// Number of entries of L.
    pub(super) fn entries(&self) -> usize {
        self.values.len()
    }

    /// The entries of a column, whose rows rise.
    pub(super) fn column(&self, column: usize) -> impl Iterator<Item = Entry> + '_ {
        let index = self.blocks.partition_point(|block| block.end <= column);
        let block = &self.blocks[index];
        let mut groups = block.groups();
        let group = groups.find(|(columns, _)| columns.contains(&column));
        let (columns, start) = group.unwrap_or((column..column + 1, block.values));
        let width = columns.len();
        let before = column - columns.start;
        let values = &self.values[start..start + block.entries(&columns)];
        let (triangle, below) = values.split_at(inside(width));
        // Each column has one entry there less than the one before.
        let column_values =
            &triangle[triangle.len() - inside(width - before)..][..width - 1 - before];
        let below = below.iter().skip(before).step_by(width);
        let rows_below = self.rows[block.rows[0]..block.rows[1]].iter();
        let rows = (column + 1..block.end).chain(rows_below.map(|row| *row as usize));
        rows.zip(column_values.iter().chain(below))
            .map(|(at, value)| Entry { at, value: *value })
    }

    /// Replaces x by L^-1 x.
    pub fn eliminate<const L: usize>(&self, x: &mut [Lane<L>]) {
        eliminate(self, x);
    }

    #[inline(always)]
    fn eliminate_all<const L: usize>(&self, x: &mut [Lane<L>]) {
        let mut start = 0;
        for block in &self.blocks {
            let mut first = block.first;
            while first < block.end {
                let columns = first..block.end.min(first + GROUP);
                let end = start + block.entries(&columns);
                let values = &self.values[start..end];
                match columns.len() {
                    4 => self.eliminate_group::<L, 4>(block, first, values, x),
                    3 => self.eliminate_group::<L, 3>(block, first, values, x),
                    2 => self.eliminate_group::<L, 2>(block, first, values, x),
                    _ => self.eliminate_group::<L, 1>(block, first, values, x),
                }
                (first, start) = (columns.end, end);
            }
        }
    }

    /// Subtracts the products of C columns, one after the other from each number.
    #[inline(always)]
    fn eliminate_group<const L: usize, const C: usize>(
        &self,
        block: &Block,
        first: usize,
        values: &[f64],
        x: &mut [Lane<L>],
    ) {
        let (inside, values) = values.split_at(inside(C));
        let mut factors = [Lane::splat(0.0); C];
        for (factor, x) in factors.iter_mut().zip(&x[first..]) {
            *factor = *x;
        }
        let mut inside = inside.iter();
        for j in 0..C {
            for i in j + 1..C {
                if let Some(l) = inside.next() {
                    factors[i] = factors[i] - factors[j] * *l;
                }
            }
        }
        for (factor, x) in factors.iter().zip(&mut x[first..]) {
            *x = *factor;
        }
        let subtract = |x: &mut Lane<L>, values: &[f64; C]| {
            let mut sum = *x;
            for (factor, l) in factors.iter().zip(values) {
                sum = sum - *factor * *l;
            }
            *x = sum;
        };
        let inner = &mut x[first + C..block.end];
        let (of_inner, of_rows) = values.as_chunks::<C>().0.split_at(inner.len());
        for (x, values) in inner.iter_mut().zip(of_inner) {
            subtract(x, values);
        }
        let rows = &self.rows[block.rows[0]..block.rows[1]];
        for (row, values) in rows.iter().zip(of_rows) {
            subtract(&mut x[*row as usize], values);
        }
    }

    /// Replaces y by the solution x of D L^T x = y.
    pub fn substitute<const L: usize>(&self, y: &mut [Lane<L>]) {
        substitute(self, y);
    }

    #[inline(always)]
    fn substitute_all<const L: usize>(&self, y: &mut [Lane<L>]) {
        let mut end = self.values.len();
        for block in self.blocks.iter().rev() {
            let mut last = block.end;
            while block.first < last {
                let first = last - 1 - (last - 1 - block.first) % GROUP;
                let start = end - block.entries(&(first..last));
                let values = &self.values[start..end];
                match last - first {
                    4 => self.substitute_group::<L, 4>(block, first, values, y),
                    3 => self.substitute_group::<L, 3>(block, first, values, y),
                    2 => self.substitute_group::<L, 2>(block, first, values, y),
                    _ => self.substitute_group::<L, 1>(block, first, values, y),
                }
                (last, end) = (first, start);
            }
        }
    }

    /// Solves for C numbers.
    #[inline(always)]
    fn substitute_group<const L: usize, const C: usize>(
        &self,
        block: &Block,
        first: usize,
        values: &[f64],
        x: &mut [Lane<L>],
    ) {
        let (inside, values) = values.split_at(inside(C));
        let inner = &x[first + C..block.end];
        let (of_inner, of_rows) = values.as_chunks::<C>().0.split_at(inner.len());
        let rows = &self.rows[block.rows[0]..block.rows[1]];
        let mut sums = [Lane::splat(0.0); C];
        if L == 1 {
            sums = products::<L, C, C>(rows, of_rows, 0, x);
        } else {
            // The sums of several columns of lanes do not fit into the registers.
            for (j, sum) in sums.iter_mut().enumerate() {
                [*sum] = products::<L, C, 1>(rows, of_rows, j, x);
            }
        }
        for (x, values) in inner.iter().zip(of_inner).rev() {
            for (sum, l) in sums.iter_mut().zip(values) {
                *sum = *sum + *x * *l;
            }
        }
        let mut inside = inside.iter().rev();
        for j in (0..C).rev() {
            for i in (j + 1..C).rev() {
                if let Some(l) = inside.next() {
                    sums[j] = sums[j] + x[first + i] * *l;
                }
            }
            x[first + j] = x[first + j] * self.reciprocals[first + j] - sums[j];
        }
    }
}

// Functions of their own, so that the steps of small structures keep their registers.
for_wide! {
    fn eliminate<const L: usize>(blocks: &Blocks, x: &mut [Lane<L>]) {
        blocks.eliminate_all(x);
    }
}

for_wide! {
    fn substitute<const L: usize>(blocks: &Blocks, y: &mut [Lane<L>]) {
        blocks.substitute_all(y);
    }
}
