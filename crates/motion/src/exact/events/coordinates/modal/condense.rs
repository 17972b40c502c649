//! Nodes without mass are condensed: they follow the others, the loads and the contacts at every instant.

use super::super::flexible::Flexible;
use super::project;
use crate::exact::events::EventsFault;
use crate::exact::events::coordinates::modes::Modes;
use crate::system::structure::{Structure, Symmetric};
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// A pivot of K_ss below this part of its entry is round-off: nothing but contacts holds the node.
const FREE: f64 = 1e-11;

/// A structure without its nodes without mass.
pub struct Condensed {
    /// The nodes with mass.
    pub kept: Vec<usize>,
    /// The place of each node among them.
    pub places: Vec<Option<usize>>,
    /// K.
    pub stiffness: DMatrix<f64>,
    /// B of each contact.
    pub columns: Vec<DVector<f64>>,
    /// p of each load.
    pub patterns: Vec<DVector<f64>>,
    /// What the contacts feel of nodes without mass.
    pub flexible: Option<Flexible>,
    held: Held,
    plates: Vec<usize>,
}

/// The nodes without mass that K holds.
struct Held {
    nodes: Vec<usize>,
    /// u of them for u of a node with mass, a plate, a load, a contact of 1.
    by_kept: DMatrix<f64>,
    by_plates: DMatrix<f64>,
    by_loads: DMatrix<f64>,
    by_contacts: DMatrix<f64>,
}

/// All entries of a matrix between nodes that have places.
pub fn entries(matrix: &Symmetric, places: &[Option<usize>]) -> Vec<(usize, usize, f64)> {
    let mut triplets = Vec::new();
    for ((i, j), value) in matrix.entries() {
        if let (Some(i), Some(j)) = (places[i], places[j]) {
            triplets.push((i, j, value));
            if i != j {
                triplets.push((j, i, value));
            }
        }
    }
    triplets
}

/// The rows of some nodes and the columns of others.
fn between(matrix: &Symmetric, rows: &[usize], columns: &[usize]) -> DMatrix<f64> {
    let places = |nodes: &[usize]| {
        let mut places = vec![None; matrix.size()];
        for (row, node) in nodes.iter().enumerate() {
            places[*node] = Some(row);
        }
        places
    };
    let (of_rows, of_columns) = (places(rows), places(columns));
    let mut block = DMatrix::zeros(rows.len(), columns.len());
    for ((i, j), value) in matrix.entries() {
        for (i, j) in [(i, j), (j, i)] {
            if let (Some(row), Some(column)) = (of_rows[i], of_columns[j]) {
                block[(row, column)] = value;
            }
        }
    }
    block
}

/// Some nodes of patterns, a column for each pattern.
fn rows<'a>(
    patterns: impl Iterator<Item = &'a Vec<(usize, f64)>>,
    nodes: &[usize],
    size: usize,
) -> DMatrix<f64> {
    let mut places = vec![None; size];
    for (row, node) in nodes.iter().enumerate() {
        places[*node] = Some(row);
    }
    let patterns: Vec<_> = patterns.collect();
    let mut rows = DMatrix::zeros(nodes.len(), patterns.len());
    for (column, pattern) in patterns.iter().enumerate() {
        for (node, factor) in *pattern {
            if let Some(row) = places[*node] {
                rows[(row, column)] += factor;
            }
        }
    }
    rows
}

impl Condensed {
    /// Condenses a structure.
    pub fn new(structure: &Structure) -> Result<Condensed, EventsFault> {
        let size = structure.len();
        let has_mass = |node: &usize| structure.nodes[*node].mass > 0.0;
        let (kept, massless): (Vec<usize>, Vec<usize>) = (0..size).partition(has_mass);
        let mut places = vec![None; size];
        for (row, node) in kept.iter().enumerate() {
            places[*node] = Some(row);
        }
        for ((i, j), value) in structure
            .damping
            .entries()
            .chain(structure.coupled_mass.entries())
        {
            if let (true, Some(node)) = (
                value != 0.0,
                [i, j].into_iter().find(|node| !has_mass(node)),
            ) {
                let node = structure.nodes[node].name.clone();
                return Err(EventsFault::MasslessDamping { node });
            }
        }
        let k = &structure.stiffness;
        let (nodes, plates) = held(k, &massless);
        let columns = || structure.contacts.iter().map(|contact| &contact.along);
        let patterns = || structure.loads.iter().map(|load| &load.pattern);
        let factor = k.block(&nodes).full().cholesky();
        let solve = |matrix: DMatrix<f64>| solve(factor.as_ref(), matrix);
        let [of_contacts, of_loads] = [
            rows(columns(), &nodes, size),
            rows(patterns(), &nodes, size),
        ];
        let held = Held {
            by_kept: solve(between(k, &nodes, &kept)),
            by_plates: solve(between(k, &nodes, &plates)),
            by_loads: solve(of_loads.clone()),
            by_contacts: solve(of_contacts.clone()),
            nodes,
        };
        let stiffness =
            symmetric(k.block(&kept).full() - dots(&between(k, &held.nodes, &kept), &held.by_kept));
        let reduced = |patterns: DMatrix<f64>, of_held: &DMatrix<f64>, by: &DMatrix<f64>| {
            patterns - dots(by, of_held)
        };
        let kept_columns = reduced(rows(columns(), &kept, size), &of_contacts, &held.by_kept);
        let kept_patterns = reduced(rows(patterns(), &kept, size), &of_loads, &held.by_kept);
        let plate_columns = reduced(
            rows(columns(), &plates, size),
            &of_contacts,
            &held.by_plates,
        );
        let plate_loads = reduced(rows(patterns(), &plates, size), &of_loads, &held.by_plates);
        let at_massless = |column: &Vec<(usize, f64)>| {
            column
                .iter()
                .any(|(node, factor)| !has_mass(node) && *factor != 0.0)
        };
        let contacts: Vec<usize> = columns()
            .enumerate()
            .filter(|(_, c)| at_massless(c))
            .map(|(i, _)| i)
            .collect();
        if let Some(plate) =
            (0..plates.len()).find(|i| plate_columns.row(*i).iter().all(|x| *x == 0.0))
        {
            let node = structure.nodes[plates[plate]].name.clone();
            return Err(EventsFault::Unheld { node });
        }
        let flexible = (!contacts.is_empty()).then(|| Flexible {
            contacts,
            compliance: symmetric(dots(&of_contacts, &held.by_contacts)),
            plates: plate_columns.transpose(),
            gaps: dots(&held.by_contacts, &of_loads),
            plate_loads,
            start: plates
                .iter()
                .map(|node| structure.displacement[*node])
                .collect(),
        });
        let to_vectors = |matrix: DMatrix<f64>| {
            matrix
                .column_iter()
                .map(|column| column.into_owned())
                .collect()
        };
        Ok(Condensed {
            kept,
            places,
            stiffness,
            columns: to_vectors(kept_columns),
            patterns: to_vectors(kept_patterns),
            flexible,
            held,
            plates,
        })
    }

    /// What the motion of modes with these shapes is at all nodes.
    pub fn modes(&self, structure: &Structure, shapes: &DMatrix<f64>) -> Modes {
        let size = structure.len();
        let mut modes = Modes {
            shapes: vec![Vec::new(); size],
            massless: (0..size).map(|_| None).collect(),
        };
        for (row, node) in self.kept.iter().enumerate() {
            modes.shapes[*node] = shapes.row(row).iter().copied().collect();
        }
        let list = |row: nalgebra::DMatrixView<f64>, sign: f64| {
            row.iter().map(|x| sign * x).collect::<Vec<f64>>()
        };
        for (row, node) in self.held.nodes.iter().enumerate() {
            let by_kept = DVector::from_iterator(
                self.kept.len(),
                self.held.by_kept.row(row).iter().map(|x| -x),
            );
            modes.shapes[*node] = project(shapes, &by_kept);
            modes.massless[*node] = Some([
                list(self.held.by_loads.rows(row, 1), 1.0),
                list(self.held.by_contacts.rows(row, 1), -1.0),
                list(self.held.by_plates.rows(row, 1), -1.0),
            ]);
        }
        for (column, node) in self.plates.iter().enumerate() {
            let unit = (0..self.plates.len()).map(|i| if i == column { 1.0 } else { 0.0 });
            modes.shapes[*node] = vec![0.0; self.kept.len()];
            modes.massless[*node] = Some([
                vec![0.0; structure.loads.len()],
                vec![0.0; structure.contacts.len()],
                unit.collect(),
            ]);
        }
        modes
    }
}

/// The nodes that K holds, and the others: those with a pivot of 0.
fn held(stiffness: &Symmetric, massless: &[usize]) -> (Vec<usize>, Vec<usize>) {
    let k = stiffness.block(massless).full();
    let mut lower = k.clone();
    let (mut nodes, mut plates) = (Vec::new(), Vec::new());
    for (j, node) in massless.iter().enumerate() {
        let pivot = lower[(j, j)];
        if pivot.is_nan() || pivot <= FREE * k[(j, j)] {
            plates.push(*node);
            continue;
        }
        nodes.push(*node);
        let column: Vec<f64> = (j + 1..massless.len()).map(|i| lower[(i, j)]).collect();
        for (c, l) in column.iter().enumerate().filter(|(_, l)| **l != 0.0) {
            for (i, other) in column.iter().enumerate().skip(c) {
                lower[(j + 1 + i, j + 1 + c)] -= l / pivot * other;
            }
        }
    }
    (nodes, plates)
}

/// K_ss^-1 times a matrix.
fn solve(factor: Option<&Cholesky<f64, Dyn>>, mut matrix: DMatrix<f64>) -> DMatrix<f64> {
    if let (Some(factor), false) = (factor, matrix.is_empty()) {
        factor.solve_mut(&mut matrix);
    }
    matrix
}

/// A^T B, with sums in the order of the rows.
fn dots(a: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
    let mut product = DMatrix::zeros(a.ncols(), b.ncols());
    for (i, a) in a.column_iter().enumerate() {
        let entries: Vec<(usize, f64)> = a
            .iter()
            .copied()
            .enumerate()
            .filter(|(_, x)| *x != 0.0)
            .collect();
        for (j, b) in b.column_iter().enumerate() {
            product[(i, j)] = entries.iter().map(|(row, x)| x * b[*row]).sum();
        }
    }
    product
}

fn symmetric(matrix: DMatrix<f64>) -> DMatrix<f64> {
    DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| {
        0.5 * (matrix[(i, j)] + matrix[(j, i)])
    })
}
