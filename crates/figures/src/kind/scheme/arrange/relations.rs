//! Which parts of a scheme are side by side, and which are above which.
//!
//! All motion is horizontal. An impact is between two faces, so its parts are side by side, in the order of the contact: r opens
//! to the right. Friction acts on a horizontal face, so its upper part is on the lower one. Springs join the storeys of a
//! building, and a bar to the mass that carries it; bars are joined end to end. The part that springs and friction connect
//! to the ground in fewer steps is the lower one; a bar is on masses that are held, or that come first in their link.

use super::join::{Join, end};
use super::pairs::Facts;
use slipgap_problem::problem::structure::described::scheme::picture::{
    Link, LinkKind, Place, Scheme,
};
use std::collections::BTreeMap;

/// The joins of a scheme and the rows of its parts.
pub struct Relations {
    /// One for each link.
    pub joins: Vec<Join>,
    /// Row of each part; 0 is the lowest.
    pub rows: Vec<usize>,
    /// Parts that links connect, each group by its first part.
    pub groups: Vec<usize>,
}

/// The root of `i` among sets of parts.
fn root(sets: &[usize], mut i: usize) -> usize {
    while sets[i] != i {
        i = sets[i];
    }
    i
}

fn join(sets: &mut [usize], a: usize, b: usize) {
    let (a, b) = (root(sets, a), root(sets, b));
    sets[a.max(b)] = a.min(b);
}

impl Relations {
    /// The relations of a scheme.
    pub fn of(scheme: &Scheme) -> Relations {
        let count = scheme.parts.len();
        let ends = |link: &Link| [end(link, 0), end(link, 1)];
        let mut pairs: BTreeMap<[usize; 2], Vec<usize>> = BTreeMap::new();
        let mut groups: Vec<usize> = (0..count).collect();
        for (l, link) in scheme.links.iter().enumerate() {
            if let [Some((i, _)), Some((j, _))] = ends(link) {
                pairs.entry([i.min(j), i.max(j)]).or_default().push(l);
                join(&mut groups, i, j);
            }
        }
        let facts = Facts::of(scheme);
        let mut joins = vec![Join::Above(None, 0); scheme.links.len()];
        let mut same: Vec<usize> = (0..count).collect();
        for (pair, links) in &pairs {
            let how = facts.of_pair(*pair, links);
            for l in links {
                joins[*l] = how;
            }
            if let Join::Beside([Some(a), Some(b)]) = how {
                join(&mut same, a, b);
            }
        }
        let same: Vec<usize> = (0..count).map(|i| root(&same, i)).collect();
        let groups: Vec<usize> = (0..count).map(|i| root(&groups, i)).collect();
        let mut orders: Vec<[usize; 2]> = Vec::new();
        for how in &mut joins {
            if let Join::Above(Some(a), b) = *how {
                // Others put them into one row, or the lower one above the upper one.
                match is_above(&orders, same[b], same[a]) {
                    true => *how = Join::Over(a, b),
                    false => orders.push([same[a], same[b]]),
                }
            }
        }
        let rows = rows(&joins, &same);
        let mut relations = Relations {
            joins,
            rows,
            groups,
        };
        relations.ground(scheme, &facts);
        relations
    }

    /// Whether a part is drawn over or under another one, or its group has such a part.
    fn has_storeys(&self, part: usize) -> bool {
        let of_group = |other: usize| self.groups[other] == self.groups[part];
        let mut joins = self.joins.iter();
        joins.any(|join| matches!(join, Join::Above(Some(_), upper) if of_group(*upper)))
    }

    /// Whether a part is drawn over another one.
    fn is_carried(&self, part: usize) -> bool {
        let mut joins = self.joins.iter();
        joins.any(|join| matches!(join, Join::Above(Some(_), upper) if *upper == part))
    }

    /// What is at the left and right face of a part.
    fn faces(&self, part: usize, done: &[bool]) -> [Face; 2] {
        let mut faces = [Face::Free; 2];
        for (join, _) in self.joins.iter().zip(done).filter(|(_, done)| **done) {
            if let Join::Beside([left, right]) = *join {
                if left == Some(part) {
                    faces[1] = if right.is_some() {
                        Face::Part
                    } else {
                        Face::Wall
                    };
                }
                if right == Some(part) {
                    faces[0] = if left.is_some() {
                        Face::Part
                    } else {
                        Face::Wall
                    };
                }
            }
        }
        faces
    }

    /// Joins parts to the ground: impacts and friction first, since springs leave them their faces.
    fn ground(&mut self, scheme: &Scheme, facts: &Facts) {
        let link = |l: usize| &scheme.links[l];
        let of_ground = |l: &usize| end(link(*l), 0).is_none() || end(link(*l), 1).is_none();
        let mut done: Vec<bool> = (0..scheme.links.len()).map(|l| !of_ground(&l)).collect();
        let mut order: Vec<usize> = (0..scheme.links.len()).filter(of_ground).collect();
        order.sort_by_key(|l| matches!(link(*l).kind, LinkKind::Spring { .. }));
        for l in order {
            done[l] = true;
            let first_is_ground = end(link(l), 0).is_none();
            let Some((part, loaded_place)) = end(link(l), usize::from(first_is_ground)) else {
                // From ground to support: no part has it.
                self.joins[l] = Join::Beside([None, None]);
                continue;
            };
            let mut before = done.clone();
            before[l] = false;
            let [left, right] = self.faces(part, &before);
            let (at_left, at_right) = (
                Join::Beside([None, Some(part)]),
                Join::Beside([Some(part), None]),
            );
            let below = Join::Above(None, part);
            let at = |face, wall| if face == Face::Part { below } else { wall };
            let free = || match [left, right] {
                [Face::Free, _] => at_left,
                [_, Face::Free] => at_right,
                [Face::Wall, _] => at_left,
                [_, Face::Wall] => at_right,
                [Face::Part, Face::Part] => below,
            };
            self.joins[l] = match (link(l).kind, loaded_place) {
                (LinkKind::Friction, _) | (_, Place::Inner(_)) => below,
                (_, Place::Left) => at(left, at_left),
                (_, Place::Right) => at(right, at_right),
                (LinkKind::Impact, Place::Mass | Place::Dof(_)) if first_is_ground => {
                    at(left, at_left)
                }
                (LinkKind::Impact, Place::Mass | Place::Dof(_)) => at(right, at_right),
                (LinkKind::Spring { .. }, Place::Mass | Place::Dof(_)) => {
                    let stands = self.has_storeys(part) && !facts.rests[part];
                    if stands && !self.is_carried(part) {
                        below
                    } else {
                        free()
                    }
                }
            };
        }
    }
}

/// What is at a face of a part.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Face {
    Free,
    Wall,
    Part,
}

/// Whether a set of parts is `lower` itself, or above it by these orders of lower and upper sets.
fn is_above(orders: &[[usize; 2]], lower: usize, upper: usize) -> bool {
    let mut reached = vec![lower];
    let mut next = 0;
    while let Some(set) = reached.get(next).copied() {
        next += 1;
        for [_, above] in orders.iter().filter(|order| order[0] == set) {
            if !reached.contains(above) {
                reached.push(*above);
            }
        }
    }
    reached.contains(&upper)
}

/// The row of each part; parts with the same `same` share one.
fn rows(joins: &[Join], same: &[usize]) -> Vec<usize> {
    let mut rows = vec![0; same.len()];
    for _ in 0..same.len() {
        for join in joins {
            if let Join::Above(Some(lower), upper) = *join {
                let (lower, upper) = (same[lower], same[upper]);
                rows[upper] = rows[upper].max(rows[lower] + 1);
            }
        }
    }
    (0..same.len()).map(|i| rows[same[i]]).collect()
}
