//! Lines as the cells of a grid that they cover.

use crate::layout::clip;
use crate::layout::sheet::{Panel, Series};
use crate::style;

/// Side of the cells that a line covers with their neighbours: a quarter of a line, so that a point in one is on it or at its edge.
const CELL: f64 = 0.25 * style::CASE_LINE;

/// Width of the fields in which curves that coincide have their turns: the length of a level dash.
const DASH: f64 = 9.0;

/// Height of the fields over their width: if it were 1, a line rising by 1 would miss every second one.
const STEEP: f64 = 1.37;

/// Least length of a stretch in which curves coincide without a break: where they only cross, it is shorter.
pub const LEAST: f64 = 30.0;

/// Least length of a dash: a shorter one is no line.
const SHORTEST: f64 = 5.0 * style::CASE_LINE;

/// Least part of a line across, the cosine of 80 degrees: on a steeper one, such as a spike, dashes would look like bars.
const UPRIGHT: f64 = 0.173_648;

/// Length of a dense curve, each place once, over the width and height of its frame: it crosses the frame several times.
const DENSE: f64 = 3.0;

/// Half the side of the square that an oscillation fills, in cells: 3 lines.
const HALF: usize = 12;

/// Least number of cells of an oscillation in that square of 625: a line has 25 to 37, and at a corner or crossing twice as many.
const FULL: usize = 100;

/// Least part of a curve under the line of another that hides it.
const HIDDEN: f64 = 0.9;

/// The distance of two places.
pub fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    libm::hypot(b[0] - a[0], b[1] - a[1])
}

/// The visible steps of a curve from point to point.
fn steps(panel: &Panel, series: &Series) -> Vec<[[f64; 2]; 2]> {
    let places: Vec<[f64; 2]> = series.points.iter().map(|p| panel.place(*p)).collect();
    let pairs = places.windows(2);
    pairs
        .filter_map(|pair| clip::segment(pair[0], pair[1], &panel.frame))
        .collect()
}

/// A frame as cells.
pub struct Cells {
    columns: usize,
    rows: usize,
    corner: [f64; 2],
}

/// A cell that a curve crosses.
struct Crossed {
    cell: usize,
    /// Length of the curve in it.
    length: f64,
    /// Part of this length across.
    across: f64,
}

/// The cells along a curve.
pub struct Path {
    cells: Vec<Crossed>,
    /// The whole length.
    pub length: f64,
}

impl Cells {
    /// The cells of the frame of a panel.
    pub fn of(panel: &Panel) -> Cells {
        let frame = &panel.frame;
        // Two rows and columns of cells more on each side, for neighbours and rounding.
        let count = |length: f64| (length / CELL).ceil() as usize + 4;
        Cells {
            columns: count(frame.width),
            rows: count(frame.height),
            corner: [frame.left - 2.0 * CELL, frame.top - 2.0 * CELL],
        }
    }

    /// The cells along a curve.
    pub fn path(&self, panel: &Panel, series: &Series) -> Path {
        let mut cells: Vec<Crossed> = Vec::new();
        for [a, b] in steps(panel, series) {
            let count = (distance(a, b) / CELL).ceil().max(1.0);
            let (step, across) = (distance(a, b) / count, (b[0] - a[0]).abs() / count);
            for k in 0..count as u32 {
                let t = (f64::from(k) + 0.5) / count;
                let at = [0, 1].map(|i| a[i] + t * (b[i] - a[i]) - self.corner[i]);
                let [x, y] = at.map(|x| (x / CELL) as usize);
                let cell = y * self.columns + x;
                match cells.last_mut() {
                    Some(last) if last.cell == cell => {
                        last.length += step;
                        last.across += across;
                    }
                    _ => cells.push(Crossed {
                        cell,
                        length: step,
                        across,
                    }),
                }
            }
        }
        let length = cells.iter().map(|crossed| crossed.length).sum();
        Path { cells, length }
    }

    /// The least length of a dense curve.
    fn least(&self) -> f64 {
        DENSE * (self.columns + self.rows) as f64 * CELL
    }

    /// Whether a curve is long enough to be dense, without the cells along it.
    pub fn is_long(&self, panel: &Panel, series: &Series) -> bool {
        let steps = steps(panel, series).into_iter();
        // The sum of the cells along it may be rounded in another way.
        steps.map(|[a, b]| distance(a, b)).sum::<f64>() > 0.999 * self.least()
    }

    /// The length of a dense curve, each place once; `None` if it is not dense.
    pub fn dense(&self, path: &Path) -> Option<f64> {
        let least = self.least();
        if path.length <= least {
            return None;
        }
        let visited = self
            .visited(path)
            .into_iter()
            .filter(|is_visited| *is_visited);
        let extent = visited.count() as f64 * CELL;
        (extent > least).then_some(extent)
    }

    fn visited(&self, path: &Path) -> Vec<bool> {
        let mut visited = vec![false; self.columns * self.rows];
        path.cells
            .iter()
            .for_each(|crossed| visited[crossed.cell] = true);
        visited
    }

    /// Of the cells that a path covers those round which it does not fill a square.
    pub fn thin(&self, path: &Path, covered: &[bool]) -> Vec<bool> {
        // Sums of the visited cells over and left of a corner.
        let (visited, width) = (self.visited(path), self.columns + 1);
        let mut sums = vec![0_usize; width * (self.rows + 1)];
        for row in 0..self.rows {
            for column in 0..self.columns {
                let at = row * width + column;
                let cell = usize::from(visited[row * self.columns + column]);
                sums[at + width + 1] = sums[at + width] + sums[at + 1] + cell - sums[at];
            }
        }
        let is_full = |cell: usize| {
            let (row, column) = (cell / self.columns, cell % self.columns);
            let [top, left] = [row, column].map(|k| k.saturating_sub(HALF));
            let bottom = (row + HALF + 1).min(self.rows);
            let right = (column + HALF + 1).min(self.columns);
            let sum = |row: usize, column: usize| sums[row * width + column];
            sum(bottom, right) + sum(top, left) - sum(top, right) - sum(bottom, left) >= FULL
        };
        let cells = covered.iter().enumerate();
        cells
            .map(|(cell, is_covered)| *is_covered && !is_full(cell))
            .collect()
    }

    /// The parts of a path that other lines show instead, as lengths along it: where it coincides with some `under` and some `over` it
    /// for long enough and is not upright, the sheet has fields, and each of the lines its turn.
    pub fn shown_by_others(&self, path: &Path, [under, over]: [&[&[bool]]; 2]) -> Vec<[f64; 2]> {
        let count =
            |lines: &[&[bool]], cell: usize| lines.iter().filter(|covered| covered[cell]).count();
        let joined =
            |parts: &mut Vec<[f64; 2]>, [from, to]: [f64; 2], gap: f64| match parts.last_mut() {
                Some(last) if from - last[1] <= gap => last[1] = to,
                _ => parts.push([from, to]),
            };
        let (mut stretches, mut parts) = (Vec::new(), Vec::new());
        let mut to = 0.0;
        for crossed in &path.cells {
            let (from, cell) = (to, crossed.cell);
            to += crossed.length;
            let (before, after) = (count(under, cell), count(over, cell));
            if before == 0 {
                continue;
            }
            // Lines at a constant distance may be in neighbouring cells with a short break.
            joined(&mut stretches, [from, to], style::CASE_LINE);
            let [x, y] = [cell % self.columns, cell / self.columns].map(|k| k as f64 * CELL);
            let field = (x / DASH) as usize + (y / (STEEP * DASH)) as usize;
            let is_upright = crossed.across < UPRIGHT * crossed.length;
            if field % (before + after + 1) != before && !is_upright {
                joined(&mut parts, [from, to], 0.0);
            }
        }
        let is_long = |part: &[f64; 2]| {
            let mut long = stretches
                .iter()
                .filter(|[from, to]: &&[f64; 2]| to - from >= LEAST);
            long.any(|[from, to]| part[0] >= *from && part[1] <= *to)
        };
        parts.retain(|part| part[1] - part[0] >= SHORTEST && is_long(part));
        parts
    }

    /// The cells of a path and their neighbours.
    pub fn covered(&self, path: &Path) -> Vec<bool> {
        let mut covered = vec![false; self.columns * self.rows];
        for Crossed { cell, .. } in &path.cells {
            for row in [cell - self.columns, *cell, cell + self.columns] {
                covered[row - 1..=row + 1].fill(true);
            }
        }
        covered
    }
}

impl Path {
    /// Whether nearly all of it is in covered cells.
    pub fn is_in(&self, covered: &[bool]) -> bool {
        let mut outside = 0.0;
        self.cells.iter().all(|crossed| {
            outside += match covered[crossed.cell] {
                true => 0.0,
                false => crossed.length,
            };
            outside <= (1.0 - HIDDEN) * self.length
        })
    }
}
