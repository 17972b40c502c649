//! What the law says of itself.

use super::{Backbone, Imk, Numbers};
use crate::contact::prelude::*;

const TO_CAP: Number = Number::new(
    ["Up", "*U*_p_", "length"],
    Range::Positive,
    "imk: plastic deflection from the yield point to the cap",
);
const TO_ZERO: Number = Number::new(
    ["Upc", "*U*_pc_", "length"],
    Range::Positive,
    "imk: deflection from the cap to no force",
);
const ULTIMATE: Number = Number::new(
    ["Uu", "*U*_u_", "length"],
    Range::Positive,
    "imk: deflection of failure; never if left out",
)
.usually(Usual::Follows("it does not fail by its deflection"));
const CAP: Number = Number::new(
    ["Fcap_ratio", "*F*_cap_/*F*_y_", "1"],
    Range::AtLeastOne,
    "imk: force at the cap over Fy",
);
const RESIDUAL: Number = Number::new(
    ["Fres_ratio", "*F*_res_/*F*_y_", "1"],
    Range::UpToOne,
    "imk: residual force over Fy; default 0",
)
.usually(Usual::Is(0.0));

const AS_POSITIVE: Usual = Usual::Follows("that of r > 0");
const fn negative(names: [&'static str; 2], unit: &'static str, range: Range) -> Number {
    let [key, symbol] = names;
    Number::new(
        [key, symbol, unit],
        range,
        "the same for r < 0; that of r > 0 if left out",
    )
    .usually(AS_POSITIVE)
}
const FY_NEGATIVE: Number = negative(["Fy_negative", "*F*_y_^−^"], "force", Range::Positive);
const TO_CAP_NEGATIVE: Number = negative(["Up_negative", "*U*_p_^−^"], "length", Range::Positive);
const TO_ZERO_NEGATIVE: Number =
    negative(["Upc_negative", "*U*_pc_^−^"], "length", Range::Positive);
const ULTIMATE_NEGATIVE: Number = negative(["Uu_negative", "*U*_u_^−^"], "length", Range::Positive);
const CAP_NEGATIVE: Number = negative(
    ["Fcap_ratio_negative", "*F*_cap_/*F*_y_^−^"],
    "1",
    Range::AtLeastOne,
);
const RESIDUAL_NEGATIVE: Number = negative(
    ["Fres_ratio_negative", "*F*_res_/*F*_y_^−^"],
    "1",
    Range::UpToOne,
);

const fn lambda(names: [&'static str; 2], meaning: &'static str) -> Number {
    let [key, symbol] = names;
    Number::new([key, symbol, "length"], Range::Positive, meaning)
        .usually(Usual::Follows("no degradation"))
}
const LAMBDA_S: Number = lambda(
    ["lambda_S", "*λ*_S_"],
    "imk: energy over Fy by which the strength degrades; it does not if left out",
);
const LAMBDA_C: Number = lambda(
    ["lambda_C", "*λ*_C_"],
    "the same for the falling line beyond the cap",
);
const LAMBDA_A: Number = lambda(
    ["lambda_A", "*λ*_A_"],
    "the same for the deflection to which it is loaded again",
);
const LAMBDA_K: Number = lambda(
    ["lambda_K", "*λ*_K_"],
    "the same for the stiffness of unloading",
);

const fn exponent(names: [&'static str; 2]) -> Number {
    let [key, symbol] = names;
    Number::new(
        [key, symbol, "1"],
        Range::Positive,
        "exponent of this degradation; default 1",
    )
    .usually(Usual::Is(1.0))
}
const C_S: Number = exponent(["c_S", "*c*_S_"]);
const C_C: Number = exponent(["c_C", "*c*_C_"]);
const C_A: Number = exponent(["c_A", "*c*_A_"]);
const C_K: Number = exponent(["c_K", "*c*_K_"]);

const fn damage(names: [&'static str; 2], meaning: &'static str) -> Number {
    let [key, symbol] = names;
    Number::new([key, symbol, "1"], Range::UpToOne, meaning).usually(Usual::Is(1.0))
}
const D_POSITIVE: Number = damage(
    ["D_positive", "*D*^+^"],
    "imk: part of the degradation for r > 0, from 0 to 1; default 1",
);
const D_NEGATIVE: Number = damage(["D_negative", "*D*^−^"], "the same for r < 0; default 1");

const KAPPA_F: Number = Number::new(
    ["kappa_F", "*κ*_F_", "1"],
    Range::UpToOne,
    "slope to the point of pinching over that to the peak, from 0 to 1",
);
const KAPPA_D: Number = Number::new(
    ["kappa_D", "*κ*_D_", "1"],
    Range::UpToOne,
    "1 - its deflection over the plastic part of that of the peak, from 0 to 1",
);

/// Those of both offers.
const COMMON: [&Number; 23] = [
    &structure::K,
    &structure::FY,
    &TO_CAP,
    &TO_ZERO,
    &ULTIMATE,
    &CAP,
    &RESIDUAL,
    &FY_NEGATIVE,
    &TO_CAP_NEGATIVE,
    &TO_ZERO_NEGATIVE,
    &ULTIMATE_NEGATIVE,
    &CAP_NEGATIVE,
    &RESIDUAL_NEGATIVE,
    &LAMBDA_S,
    &LAMBDA_C,
    &LAMBDA_A,
    &LAMBDA_K,
    &C_S,
    &C_C,
    &C_A,
    &C_K,
    &D_POSITIVE,
    &D_NEGATIVE,
];

/// The same with pinching.
const WITH_PINCHING: [&Number; 25] = {
    let mut all = [&KAPPA_F; 25];
    let mut i = 0;
    while i < COMMON.len() {
        all[i] = COMMON[i];
        i += 1;
    }
    all[24] = &KAPPA_D;
    all
};

/// The law of given numbers.
fn form(given: &GivenNumbers, pinching: Option<[f64; 2]>) -> Result<Form, LawFault> {
    let stiffness = given.need("k")?;
    let side = |suffix: [&'static str; 6], damage: &'static str| -> Result<Backbone, LawFault> {
        let positive = ["Fy", "Up", "Upc", "Fcap_ratio", "Fres_ratio", "Uu"];
        let number = |which: usize| match given.given(suffix[which]) {
            Some(value) => Ok(value),
            None if which == 5 => Ok(given.given("Uu").unwrap_or(f64::INFINITY)),
            None => given.need(positive[which]),
        };
        let [fy, up, upc] = [number(0)?, number(1)?, number(2)?];
        let [cap, residual, ultimate] = [number(3)?, number(4)?, number(5)?];
        Ok(Backbone::new(
            stiffness,
            [fy, up, upc],
            [cap, given.at_most(suffix[4], residual, (suffix[3], cap))?],
            [ultimate, given.need(damage)?],
        ))
    };
    let positive = side(
        ["Fy", "Up", "Upc", "Fcap_ratio", "Fres_ratio", "Uu"],
        "D_positive",
    )?;
    let negative = side(
        [
            "Fy_negative",
            "Up_negative",
            "Upc_negative",
            "Fcap_ratio_negative",
            "Fres_ratio_negative",
            "Uu_negative",
        ],
        "D_negative",
    )?;
    let fy = given.need("Fy")?;
    let energy = |key: &str| given.given(key).map_or(f64::INFINITY, |lambda| lambda * fy);
    let [s, c, a, k] = [
        given.need("c_S")?,
        given.need("c_C")?,
        given.need("c_A")?,
        given.need("c_K")?,
    ];
    Ok(Form::of(Imk::new(Numbers {
        stiffness,
        sides: [negative, positive],
        energies: ["lambda_S", "lambda_C", "lambda_A", "lambda_K"].map(energy),
        exponents: [s, c, a, k],
        pinching,
    })))
}

impl Described for Imk {
    const KIND: ContactKind = ContactKind::Link;
    const NAME: &'static str = "imk-peak-oriented";
    const OFFERS: &'static [Offer] = &[
        Offer::new(Self::NAME, |given| form(given, None))
            .also(&["imkpeakoriented", "modimkpeakoriented", "imk", "clough"])
            .in_structures(
                "a hinge that hardens, softens and degrades with the energy that it takes, loaded again towards its peak (Ibarra, Medina and Krawinkler 2005)",
                &COMMON,
            ),
        Offer::new("imk-pinching", |given| {
            let pinching = [given.need("kappa_F")?, given.need("kappa_D")?];
            form(given, Some(pinching))
        })
            .also(&["imkpinching", "modimkpinching"])
            .in_structures(
                "the same with pinching: loaded again first towards a point below the line to its peak",
                &WITH_PINCHING,
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
    fn shown(&self) -> Vec<(&'static str, f64)> {
        let [_, side] = &self.sides;
        vec![("k =", self.stiffness), ("Fy =", side.yield_force)]
    }

    fn largest_stiffness(&self, _: f64) -> f64 {
        let falling = self.sides.iter().map(|side| -side.falling);
        falling.fold(self.stiffness, f64::max)
    }

    fn initial_stiffness(&self, _: f64) -> f64 {
        self.stiffness
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

    fn has_rigid_form(&self) -> bool {
        false
    }

    fn only_in_steps(&self) -> Option<&'static str> {
        Some("adds up its energy step by step")
    }
}
