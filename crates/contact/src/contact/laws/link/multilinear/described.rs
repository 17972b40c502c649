//! What the multilinear law says of itself.

use super::Multilinear;
use crate::contact::prelude::*;

/// The table.
const TABLE: Number = Number::new(
    ["table", "*S*(*r*)", "force"],
    Range::Any,
    "{laws}: r and S of its first loading, r rising; with r > 0 alone it is symmetric; the last line continues",
);

impl Described for Multilinear {
    const KIND: ContactKind = ContactKind::Link;
    const NAME: &'static str = "multilinear";
    const OFFERS: &'static [Offer] = &[Offer::new(Self::NAME, |given| {
        let law = Multilinear::new(given.table)?;
        Ok(Form::of(law))
    })
        .also(&["trilinear", "iwan", "multilinearplastic"])
        .in_structures(
            "yields along a table of r and S, symmetric or not, and unloads by Masing's rule (Iwan 1966)",
            &[&TABLE],
        )];
    const CLOSED_FORM: ClosedForm<Self> = ClosedForm::Driven(|law, velocity, time| {
        let r = velocity * time;
        Some(law.force(r, &law.first(r)))
    });
}

impl Properties for Multilinear {
    fn shown(&self) -> Vec<(&'static str, f64)> {
        vec![("k =", self.largest_stiffness(0.0))]
    }

    fn largest_stiffness(&self, _: f64) -> f64 {
        self.stiffness + self.yielding()
    }

    fn initial_stiffness(&self, _: f64) -> f64 {
        self.largest_stiffness(0.0)
    }

    /// Twice the last bend.
    fn reach(&self) -> f64 {
        let bends = self.bends.iter().flatten().map(|bend| bend.abs());
        let last = bends.filter(|bend| bend.is_finite()).fold(0.0, f64::max);
        if last > 0.0 { 2.0 * last } else { 1.0 }
    }

    fn bounds(&self) -> [f64; 2] {
        self.bends.map(|bends| {
            let used = self.parts.iter().zip(&bends).filter(|(k, _)| **k > 0.0);
            let bounded = self.stiffness == 0.0 && used.clone().all(|(_, bend)| bend.is_finite());
            match bounded {
                true => used.map(|(k, bend)| k * bend).sum(),
                false => bends[0].signum() * f64::INFINITY,
            }
        })
    }

    fn straight(&self) -> Option<Straight> {
        Some(Straight::Parts(*self))
    }
}
