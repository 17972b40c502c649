//! What the law says of itself.

use super::{Backbone, Imk, Numbers, Reloading};
use crate::contact::prelude::*;

const fn negative([key, symbol, unit]: [&'static str; 3], range: Range) -> Number {
    let meaning = "the same for r < 0; default: that of r > 0";
    Number::new([key, symbol, unit], range, meaning).usually(Usual::Follows("that of r > 0"))
}

const fn lambda([key, symbol]: [&'static str; 2], meaning: &'static str) -> Number {
    Number::new([key, symbol, "length"], Range::Positive, meaning)
        .usually(Usual::Follows("no degradation"))
}

const fn exponent([key, symbol]: [&'static str; 2]) -> Number {
    let meaning = "exponent of this degradation; default 1";
    Number::new([key, symbol, "1"], Range::Positive, meaning).usually(Usual::Is(1.0))
}

const fn damage([key, symbol]: [&'static str; 2], meaning: &'static str) -> Number {
    Number::new([key, symbol, "1"], Range::UpToOne, meaning).usually(Usual::Is(1.0))
}

/// Those of all forms, and those without pinching.
const COMMON: [usize; 2] = [21, 23];

/// The numbers; the last four are of peaks, of which the last two are of pinching.
static NUMBERS: [Number; 25] = [
    structure::K,
    structure::FY,
    Number::new(
        ["Up", "*U*_p_", "length"],
        Range::Positive,
        "{laws}: plastic deflection from the yield point to the cap",
    ),
    Number::new(
        ["Upc", "*U*_pc_", "length"],
        Range::Positive,
        "{laws}: deflection from the cap to no force",
    ),
    Number::new(
        ["Uu", "*U*_u_", "length"],
        Range::Positive,
        "{laws}: deflection at failure; default none",
    )
    .usually(Usual::Follows("it does not fail by its deflection")),
    Number::new(
        ["Fcap_ratio", "*F*_cap_/*F*_y_", "1"],
        Range::AtLeastOne,
        "{laws}: force at the cap over Fy",
    ),
    Number::new(
        ["Fres_ratio", "*F*_res_/*F*_y_", "1"],
        Range::UpToOne,
        "{laws}: residual force over Fy; default 0",
    )
    .usually(Usual::Is(0.0)),
    negative(["Fy_negative", "*F*_y_^−^", "force"], Range::Positive),
    negative(["Up_negative", "*U*_p_^−^", "length"], Range::Positive),
    negative(["Upc_negative", "*U*_pc_^−^", "length"], Range::Positive),
    negative(["Uu_negative", "*U*_u_^−^", "length"], Range::Positive),
    negative(
        ["Fcap_ratio_negative", "*F*_cap_/*F*_y_^−^", "1"],
        Range::AtLeastOne,
    ),
    negative(
        ["Fres_ratio_negative", "*F*_res_/*F*_y_^−^", "1"],
        Range::UpToOne,
    ),
    lambda(
        ["lambda_S", "*λ*_S_"],
        "{laws}: energy over Fy by which the strength degrades; default no degradation",
    ),
    lambda(
        ["lambda_C", "*λ*_C_"],
        "the same for the falling line beyond the cap",
    ),
    lambda(
        ["lambda_K", "*λ*_K_"],
        "the same for the stiffness of unloading",
    ),
    exponent(["c_S", "*c*_S_"]),
    exponent(["c_C", "*c*_C_"]),
    exponent(["c_K", "*c*_K_"]),
    damage(
        ["D_positive", "*D*^+^"],
        "{laws}: part of the degradation that acts for r > 0, from 0 to 1; default 1",
    ),
    damage(["D_negative", "*D*^−^"], "the same for r < 0; default 1"),
    lambda(
        ["lambda_A", "*λ*_A_"],
        "{laws}: energy over Fy by which the deflection degrades to which they are loaded again; default no degradation",
    ),
    exponent(["c_A", "*c*_A_"]),
    Number::new(
        ["kappa_F", "*κ*_F_", "1"],
        Range::UpToOne,
        "{laws}: slope to the point of pinching over that to the peak, from 0 to 1",
    ),
    Number::new(
        ["kappa_D", "*κ*_D_", "1"],
        Range::UpToOne,
        "{laws}: 1 - its deflection over the plastic part of that of the peak, from 0 to 1",
    ),
];

/// Each of them.
static EACH: [&Number; 25] = {
    let mut each = [&NUMBERS[0]; 25];
    let mut i = 0;
    while i < each.len() {
        each[i] = &NUMBERS[i];
        i += 1;
    }
    each
};

/// The keys of a first loading, to r < 0 and to r > 0.
const SIDES: [[&str; 7]; 2] = [
    [
        "Fy_negative",
        "Up_negative",
        "Upc_negative",
        "Fcap_ratio_negative",
        "Fres_ratio_negative",
        "Uu_negative",
        "D_negative",
    ],
    [
        "Fy",
        "Up",
        "Upc",
        "Fcap_ratio",
        "Fres_ratio",
        "Uu",
        "D_positive",
    ],
];

/// The first loading of given numbers in a direction; what is not given for r < 0 is that of r > 0.
fn side(
    given: &GivenNumbers,
    stiffness: f64,
    keys: [&'static str; 7],
) -> Result<Backbone, LawFault> {
    let number = |which: usize| match given.given(keys[which]) {
        Some(value) => Ok(value),
        None => given.need(SIDES[1][which]),
    };
    let [fy, up, upc] = [number(0)?, number(1)?, number(2)?];
    let [cap, residual] = [number(3)?, number(4)?];
    let ultimate = given.given(keys[5]).or_else(|| given.given("Uu"));
    Ok(Backbone::new(
        stiffness,
        [fy, up, upc],
        [cap, given.at_most(keys[4], residual, (keys[3], cap))?],
        [ultimate.unwrap_or(f64::INFINITY), given.need(keys[6])?],
    ))
}

/// The law of given numbers.
fn form(given: &GivenNumbers, reloading: Reloading) -> Result<Form, LawFault> {
    let stiffness = given.need("k")?;
    let positive = side(given, stiffness, SIDES[1])?;
    let negative = side(given, stiffness, SIDES[0])?;
    let fy = given.need("Fy")?;
    let energy = |key: &str| given.given(key).map_or(f64::INFINITY, |lambda| lambda * fy);
    let [s, c] = [given.need("c_S")?, given.need("c_C")?];
    // Without peaks there is no number of them.
    let [a, k] = [given.given("c_A").unwrap_or(1.0), given.need("c_K")?];
    Ok(Form::of(Imk::new(Numbers {
        stiffness,
        sides: [negative, positive],
        energies: ["lambda_S", "lambda_C", "lambda_A", "lambda_K"].map(energy),
        exponents: [s, c, a, k],
        reloading,
    })))
}

impl Described for Imk {
    const KIND: ContactKind = ContactKind::Link;
    const NAME: &'static str = "imk-peak-oriented";
    const OFFERS: &'static [Offer] = &[
        Offer::new("imk-bilinear", |given| form(given, Reloading::Bilinear))
            .also(&["imkbilin", "bilin", "modimkbilin"])
            .in_structures(
                "a hinge that hardens, softens and degrades with the energy that it takes, loaded again elastically (Lignos and Krawinkler 2011)",
                EACH.split_at(COMMON[0]).0,
            ),
        Offer::new(Self::NAME, |given| form(given, Reloading::PeakOriented))
            .also(&["imkpeakoriented", "modimkpeakoriented", "imk", "clough"])
            .in_structures(
                "the same, loaded again towards its peak (Ibarra, Medina and Krawinkler 2005)",
                EACH.split_at(COMMON[1]).0,
            ),
        Offer::new("imk-pinching", |given| {
            let pinching = [given.need("kappa_F")?, given.need("kappa_D")?];
            form(given, Reloading::Pinching(pinching))
        })
            .also(&["imkpinching", "modimkpinching"])
            .in_structures(
                "the same with pinching: loaded again first towards a point below the line to its peak",
                &EACH,
            ),
    ];
    const CLOSED_FORM: ClosedForm<Self> = ClosedForm::Driven(|law, velocity, time| {
        let r = velocity * time;
        let [_, side] = &law.sides;
        let top = side.yield_force + side.hardening * (r - side.yield_force / law.stiffness);
        let falling = side.projected + side.falling * r;
        Some(match r < side.ultimate {
            true => (law.stiffness * r).min(top).min(falling.max(side.residual)),
            false => 0.0,
        })
    });
}

impl Properties for Imk {
    fn family(&self) -> Family {
        Family::Link(self.stiffness)
    }

    fn shown(&self) -> Vec<(&'static str, f64)> {
        let [_, side] = &self.sides;
        vec![("k =", self.stiffness), ("Fy =", side.yield_force)]
    }

    fn largest_stiffness(&self, _: f64) -> f64 {
        let falling = self.sides.iter().map(|side| -side.falling);
        falling.fold(self.stiffness, f64::max)
    }

    /// Half-way down from the cap, but before it fails.
    fn reach(&self) -> f64 {
        let reach = self.sides.iter().map(|side| {
            let half = -0.75 * side.projected / side.falling;
            half.min(0.99 * side.ultimate)
        });
        reach.fold(f64::INFINITY, f64::min)
    }

    fn bounds(&self) -> [f64; 2] {
        let [negative, positive] = &self.sides;
        [-negative.top(self.stiffness), positive.top(self.stiffness)]
    }

    fn falls(&self) -> bool {
        true
    }

    fn has_one_root(&self, on: &StepFlexibility<1>) -> bool {
        let [h] = on.end.h.0;
        self.sides.iter().all(|side| 1.0 + side.falling * h > 0.0)
    }

    fn only_in_steps(&self) -> Option<&'static str> {
        Some("adds up its energy step by step")
    }
}
