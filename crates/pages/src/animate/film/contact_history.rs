//! A contact over time: when it touches or slides, and its force.

use super::short_numbers::{differences, digits, peak};
use super::trace;
use serde_json::{Value, json};
use std::borrow::Cow;

/// What a contact is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// An impact: lit while it has a force.
    Impact,
    /// Friction: lit while it slides.
    Friction,
    /// Another part with a force, drawn as a spring.
    Link,
}

/// A contact with its values at all steps.
#[derive(Debug)]
pub struct Contact<'a> {
    /// Its name; empty for the only one.
    pub name: String,
    /// What it is.
    pub kind: Kind,
    /// Its force S.
    pub force: Cow<'a, [f64]>,
    /// Whether it touches or slides.
    pub lit: Vec<bool>,
}

/// Force over its limit from which a contact slides: smooth laws come near their limits only.
const AT_LIMIT: f64 = 0.99;

/// Velocity over the largest one from which a contact without a known limit slides.
const SLIDES: f64 = 0.02;

/// Most times of touching of a contact in the page; shorter pauses are left out if there are more.
const MOST_SPANS: usize = 3000;

impl<'a> Contact<'a> {
    /// An impact.
    pub fn impact(name: &str, force: Cow<'a, [f64]>) -> Contact<'a> {
        Contact {
            name: name.to_owned(),
            kind: Kind::Impact,
            lit: force.iter().map(|s| *s != 0.0).collect(),
            force,
        }
    }

    /// Friction with a limit at each step, or else judged by its velocity.
    pub fn friction(
        name: &str,
        force: Cow<'a, [f64]>,
        rate: &[f64],
        limit: Option<&[f64]>,
    ) -> Contact<'a> {
        let fast = SLIDES * peak(rate);
        let by_rate = |v: &f64| v.abs() > fast;
        let lit = match limit {
            Some(limit) => {
                let at = force.iter().zip(limit);
                at.map(|(s, limit)| *limit > 0.0 && s.abs() >= AT_LIMIT * limit)
                    .collect()
            }
            None => rate.iter().map(by_rate).collect(),
        };
        Contact {
            name: name.to_owned(),
            kind: Kind::Friction,
            force,
            lit,
        }
    }

    /// A part with a force that is not lit.
    pub fn link(name: &str, force: Cow<'a, [f64]>) -> Contact<'a> {
        Contact {
            name: name.to_owned(),
            kind: Kind::Link,
            lit: Vec::new(),
            force,
        }
    }

    /// First and last step of each time of touching or sliding.
    pub fn spans(&self) -> Vec<[u64; 2]> {
        let mut spans: Vec<[u64; 2]> = Vec::new();
        for (step, _) in self.lit.iter().enumerate().filter(|(_, lit)| **lit) {
            let step = step as u64;
            match spans.last_mut() {
                Some(last) if last[1] + 1 == step => last[1] = step,
                _ => spans.push([step, step]),
            }
        }
        spans
    }

    /// The steps at its changes: the last one before and the first one after each.
    pub fn changes(&self) -> impl Iterator<Item = u64> + '_ {
        let spans = self.spans().into_iter();
        spans.flat_map(|[first, last]| [first.saturating_sub(1), first, last, last + 1])
    }

    /// Step and value of the largest absolute force.
    pub fn peak(&self) -> (u64, f64) {
        let mut best = (0, 0.0_f64);
        for (step, s) in self.force.iter().enumerate() {
            if s.abs() > best.1.abs() {
                best = (step as u64, *s);
            }
        }
        best
    }

    /// The contact in the page. Times are in half steps: a contact touches from half a step before to half a step after the
    /// steps with a force.
    pub fn data(&self) -> Value {
        let mut spans = self.spans();
        let mut pause = 1;
        while spans.len() > MOST_SPANS {
            pause *= 2;
            let mut joined: Vec<[u64; 2]> = Vec::new();
            for span in spans {
                match joined.last_mut() {
                    Some(last) if span[0] - last[1] <= pause => last[1] = span[1],
                    _ => joined.push(span),
                }
            }
            spans = joined;
        }
        let ends = spans
            .iter()
            .flat_map(|[first, last]| [2 * *first as i64 - 1, 2 * *last as i64 + 1]);
        let (step, force) = self.peak();
        json!({
            "name": self.name,
            "kind": match self.kind {
                Kind::Impact => "impact",
                Kind::Friction => "friction",
                Kind::Link => "link",
            },
            "spans": differences(ends),
            "peak": [2 * step, digits(force, 5)],
            "force": trace::of_steps(&self.force),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_contact_is_lit_where_it_has_a_force() {
        let force = [0.0, -1.0, -2.0, 0.0, 0.0, -0.5, 0.0];
        let contact = Contact::impact("c", Cow::Borrowed(&force));
        assert_eq!(contact.spans(), [[1, 2], [5, 5]]);
        assert_eq!(contact.peak(), (2, -2.0));
        let changes: Vec<u64> = contact.changes().collect();
        assert_eq!(changes, [0, 1, 2, 3, 4, 5, 5, 6]);
        // In half steps, as differences.
        assert_eq!(contact.data()["spans"], json!([1, 4, 4, 2]));
    }

    #[test]
    fn friction_slides_at_its_limit() {
        let force = [0.5, 1.0, 1.0, -1.0, 0.0];
        let limit = [1.0, 1.0, 2.0, 1.0, 0.0];
        let rate = [0.0; 5];
        let contact = Contact::friction("c", Cow::Borrowed(&force), &rate, Some(&limit));
        assert_eq!(contact.lit, [false, true, false, true, false]);
        let rate = [0.0, 0.001, 1.0, -0.5, 0.0];
        let contact = Contact::friction("c", Cow::Borrowed(&force), &rate, None);
        assert_eq!(contact.lit, [false, false, true, true, false]);
    }

    #[test]
    fn chatter_is_joined_to_few_spans() {
        let force: Vec<f64> = (0..100_000).map(|i| f64::from(-(i % 2))).collect();
        let contact = Contact::impact("c", Cow::Owned(force));
        let spans = contact.data()["spans"].as_array().unwrap().len();
        assert!(spans <= 2 * MOST_SPANS);
    }
}
