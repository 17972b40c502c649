//! The offers of all laws as tables, for constants.

use super::offered::{In, Offer, Offered, Place};
use crate::contact::number::Number;
use crate::contact::{ContactKind, WhichLaw};

/// The most numbers that a law has in a problem.
pub const fn most_numbers(offers: &[Offered], place: Place) -> usize {
    let (mut most, mut i) = (0, 0);
    while i < offers.len() {
        if let Some(offer) = offers[i].at(place)
            && offer.numbers.len() > most
        {
            most = offer.numbers.len();
        }
        i += 1;
    }
    most
}

/// The offers of laws, one after the other.
type Laws = [OffersOf];

/// A law, its kind, whether S follows from rdot alone and whether it slides in a plane, and its offers.
pub(in crate::contact) type OffersOf = (WhichLaw, ContactKind, [bool; 2], &'static [Offer]);

/// Number of all offers.
pub(in crate::contact) const fn count(laws: &Laws) -> usize {
    let (mut i, mut sum) = (0, 0);
    while i < laws.len() {
        sum += laws[i].3.len();
        i += 1;
    }
    sum
}

/// All offers: impacts, friction, links.
pub(in crate::contact) const fn collect<const N: usize>(
    laws: &Laws,
    none: Offered,
) -> [Offered; N] {
    let mut table = [none; N];
    let (mut next, mut kind) = (0, 0);
    while kind < 3 {
        let mut i = 0;
        while i < laws.len() {
            let (law, law_kind, [of_velocity, in_plane], offers) = laws[i];
            let mut j = 0;
            while law_kind as usize == kind && j < offers.len() {
                table[next] = Offered {
                    law,
                    kind: law_kind,
                    of_velocity,
                    in_plane,
                    offer: &offers[j],
                };
                next += 1;
                j += 1;
            }
            i += 1;
        }
        kind += 1;
    }
    table
}

/// Which of the offers in a problem a list is of.
#[derive(Debug, Clone, Copy)]
pub enum Which {
    /// All.
    All,
    /// Those with this number.
    With(&'static Number),
    /// Those of friction whose S does not follow from rdot alone.
    Hysteretic,
}

impl Which {
    const fn takes(self, offered: &Offered, offer: &In) -> bool {
        match self {
            Which::All => true,
            Which::With(number) => number.is_in(offer.numbers),
            Which::Hysteretic => {
                matches!(offered.kind, ContactKind::Friction) && !offered.of_velocity
            }
        }
    }
}

/// Number of offers in a problem.
pub const fn number_of(offers: &[Offered], place: Place, which: Which) -> usize {
    let (mut i, mut sum) = (0, 0);
    while i < offers.len() {
        if let Some(offer) = offers[i].at(place)
            && which.takes(&offers[i], &offer)
        {
            sum += 1;
        }
        i += 1;
    }
    sum
}

/// Names and meanings of the offers in a problem.
pub const fn names<const N: usize>(
    offers: &[Offered],
    place: Place,
    which: Which,
) -> [(&'static str, &'static str); N] {
    let mut names = [("", ""); N];
    let (mut i, mut next) = (0, 0);
    while i < offers.len() {
        if let Some(offer) = offers[i].at(place)
            && which.takes(&offers[i], &offer)
        {
            names[next] = (offers[i].offer.name, offer.meaning);
            next += 1;
        }
        i += 1;
    }
    names
}
