//! The film of two bars that meet, or of a bar that meets a wall: displacements and stresses along them.

use super::film::Film;
use super::film::contact_history::Contact;
use super::film::scene::{Bar, Link, Mover, Scene};
use super::film::short_numbers::peak;
use super::film::thin;
use slipgap_motion::history::History;
use slipgap_problem::problem::{Case, Lines, Problem};
use std::borrow::Cow;

/// Times at which the bars are shown.
const TIMES: u64 = 300;

/// Nodes of a bar whose displacements are shown, but for the first one.
const NODES: usize = 40;

/// Length of the longer bar in points, and height of both.
const SIZE: [f64; 2] = [190.0, 36.0];

/// Room for a wall beside a bar.
const WALL: f64 = 8.0;

/// The film of a case with this motion of its contact.
pub fn film<'a>(problem: &dyn Problem, case: &Case, history: &'a History, exact: bool) -> Film<'a> {
    let contact = Contact::impact("contact", Cow::Borrowed(history.force()));
    let last = history.len().saturating_sub(1) as u64;
    let steps = steps(history, &contact, last);
    let times: Vec<f64> = steps
        .iter()
        .map(|step| history.time[*step as usize])
        .collect();
    let snapshots = problem
        .as_textbook()
        .map_or(Vec::new(), |textbook| textbook.snapshots(case, &times));
    let chosen = |lines: &'_ Lines| match exact {
        true => lines.exact.clone(),
        false => lines.computed.clone(),
    };
    let displacements: Vec<Vec<Vec<[f64; 2]>>> = snapshots
        .iter()
        .map(|snapshot| chosen(&snapshot.displacement))
        .collect();
    let stresses: Vec<Vec<Vec<[f64; 2]>>> = snapshots
        .iter()
        .map(|snapshot| snapshot.profiles.get(1).map_or_else(Vec::new, chosen))
        .collect();
    let mut film = Film {
        last,
        ..Film::default()
    };
    let lengths = lengths(&displacements);
    // The faces are drawn together. What is right of the contact is moved by the gap, too, so that they are r apart.
    let gap = history.displacement().first().copied().unwrap_or(0.0);
    let longest = lengths
        .iter()
        .fold(f64::MIN_POSITIVE, |a: f64, b| a.max(*b));
    let mut left = 0.0;
    for (bar, length) in lengths.iter().enumerate() {
        // From left to right, and the left bar ends at 0.
        let start = if bar == 0 { -length } else { 0.0 };
        let node = |i: usize| start + length * i as f64 / NODES as f64;
        let more = if bar == 0 { 0.0 } else { gap };
        let numbered = (0..=NODES).map(|i| {
            let values = displacements
                .iter()
                .map(|lines| more + at(&lines[bar], node(i)));
            film.moves.push(Cow::Owned(values.collect()));
            Some(film.moves.len() - 1)
        });
        let nodes: Vec<Option<usize>> = numbered.collect();
        let piece = |i: usize| start + length * (i as f64 + 0.5) / NODES as f64;
        let mut stresses_of_nodes: Vec<Vec<f64>> = (0..NODES)
            .map(|i| {
                stresses
                    .iter()
                    .map(|lines| step_at(&lines[bar], piece(i), exact))
                    .collect()
            })
            .collect();
        let largest = stresses_of_nodes
            .iter()
            .map(|values| peak(values))
            .fold(0.0, f64::max);
        let first = film.stresses.len();
        if largest > 0.0 {
            stresses_of_nodes
                .iter_mut()
                .flatten()
                .for_each(|x| *x /= largest);
            film.stresses
                .extend(stresses_of_nodes.into_iter().map(Cow::Owned));
        }
        let width = SIZE[0] * length / longest;
        film.scene.bars.push(Bar {
            rect: [left, 0.0, width, SIZE[1]],
            name: if lengths.len() > 1 {
                ["left bar", "right bar"][bar]
            } else {
                "bar"
            }
            .into(),
            nodes,
            stresses: (first..film.stresses.len()).collect(),
        });
        left += width;
    }
    film.moves.push(Cow::Owned(vec![gap; steps.len()]));
    film.places = film.moves.len();
    contact_between(&mut film.scene, film.places - 1);
    film.steps = steps;
    film.contacts = vec![contact];
    film
}

/// The steps that are shown: evenly spaced, and those at which the contact changes and is strongest.
fn steps(history: &History, contact: &Contact, last: u64) -> Vec<u64> {
    let mut steps: Vec<u64> = (0..=TIMES)
        .map(|i| (last as u128 * i as u128 / TIMES as u128) as u64)
        .collect();
    let changes: Vec<u64> = contact.changes().filter(|step| *step <= last).collect();
    let every = changes.len().div_ceil(TIMES as usize).max(1);
    steps.extend(changes.into_iter().step_by(every));
    steps.push(contact.peak().0);
    let extremes = thin::extremes(history.displacement());
    steps.extend(extremes.map(|step| step as u64));
    steps.sort_unstable();
    steps.dedup();
    steps
}

/// The lengths of the bars.
fn lengths(displacements: &[Vec<Vec<[f64; 2]>>]) -> Vec<f64> {
    let first = displacements.first().map_or(&[][..], Vec::as_slice);
    let length = |line: &Vec<[f64; 2]>| {
        line.iter()
            .fold(0.0, |most: f64, point| most.max(point[0].abs()))
    };
    first.iter().map(length).collect()
}

/// The value of a line at a place. Its points are in the order of their distance from 0.
fn at(line: &[[f64; 2]], x_at: f64) -> f64 {
    let beyond = line.iter().position(|point| point[0].abs() >= x_at.abs());
    match beyond {
        Some(0) => line[0][1],
        Some(i) => {
            let ([x, a], [to, b]) = (line[i - 1], line[i]);
            let part = if to == x { 0.0 } else { (x_at - x) / (to - x) };
            a + part * (b - a)
        }
        None => line.last().map_or(0.0, |point| point[1]),
    }
}

/// The value of a line of constant pieces at a place: that of the piece if the line has its corners, or else the nearest.
fn step_at(line: &[[f64; 2]], x_at: f64, corners: bool) -> f64 {
    if corners {
        return at(line, x_at);
    }
    let nearest = line
        .iter()
        .min_by(|a, b| (a[0] - x_at).abs().total_cmp(&(b[0] - x_at).abs()));
    nearest.map_or(0.0, |point| point[1])
}

/// The contact, with a wall that is moved by `gap` if there is no right bar.
fn contact_between(scene: &mut Scene, gap: usize) {
    let (face, left, right) = match scene.bars.as_slice() {
        [left, right] => (
            left.rect[2],
            left.nodes.last(),
            right.nodes.first().copied().flatten(),
        ),
        [only] => (only.rect[2], only.nodes.last(), Some(gap)),
        _ => return,
    };
    let left = left.copied().flatten();
    if scene.bars.len() == 1 {
        let by = Mover::right(right);
        let wall = [[face, -WALL], [face, SIZE[1] + WALL]];
        scene.grounds.push((wall, [1.0, 0.0], by));
    }
    let at = [face, SIZE[1] / 2.0];
    scene.links.push(Link {
        kind: "faces",
        contact: Some(0),
        name: ("contact".into(), [face, -WALL], "none"),
        ends: [(at, Mover::right(left)), (at, Mover::right(right))],
        direction: [1.0, 0.0],
        opening: None,
        rods: Vec::new(),
    });
}
