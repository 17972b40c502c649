//! The numbers that several laws have, in each problem. A number of one law alone may stand in the file of the law instead.

/// Numbers of the oscillator, by their names in [`oscillator`].
macro_rules! of_oscillator {
    ($($number:ident),+) => { &[$(&oscillator::$number),+] };
}

/// Numbers of structures, by their names in [`structure`].
macro_rules! of_structures {
    ($($number:ident),+) => { &[$(&structure::$number),+] };
}

pub(in crate::contact) use {of_oscillator, of_structures};

/// Of the friction oscillator, without dimension.
pub mod oscillator {
    use crate::contact::number::{Number, Range, Usual};

    /// alpha
    pub const ALPHA: Number = Number::new(
        ["alpha", "*α*", "1"],
        Range::Positive,
        "elastic displacement before sliding, r^E/Delta [F (22)]; of bouc-wen and dahl by the stiffness at S = 0",
    );
    /// beta
    pub const BETA: Number = Number::new(
        ["beta", "*β*", "1"],
        Range::Positive,
        "velocity up to which the force is viscous, (rdot^E/omega_n)/Delta [F (22)]; of tanh by the slope at rdot = 0",
    );
    /// n
    pub const EXPONENT: Number = Number::new(
        ["exponent", "*n*", "1"],
        Range::AtLeastOne,
        "exponent of the hysteretic laws",
    )
    .usually(Usual::Is(1.0));
    /// sigma0
    pub const SIGMA0: Number = Number::new(
        ["sigma0", "*σ*_0_", "1"],
        Range::Positive,
        "stiffness of the bristles, over k; 1/alpha",
    );
    /// sigma1
    pub const SIGMA1: Number = Number::new(
        ["sigma1", "*σ*_1_", "1"],
        Range::NotNegative,
        "damping of the bristles, over k/omega_n",
    )
    .usually(Usual::Is(0.0));
    /// sigma2
    pub const SIGMA2: Number = Number::new(
        ["sigma2", "*σ*_2_", "1"],
        Range::NotNegative,
        "viscous damping of the sliding contact, over k/omega_n",
    )
    .usually(Usual::Is(0.0));
    /// L_s/L_k
    pub const STATIC_RATIO: Number = Number::new(
        ["static_ratio", "*ν*_s_/*ν*", "1"],
        Range::AtLeastOne,
        "static friction limit over the kinetic one",
    )
    .usually(Usual::Is(1.0));
    /// v_S
    pub const STRIBECK_VELOCITY: Number = Number::new(
        ["stribeck_velocity", "*v*_S_/(*ω*_n_Δ)", "1"],
        Range::Positive,
        "velocity over which the limit falls to the kinetic one, over omega_n Delta",
    )
    .usually(Usual::Is(1.0));
    /// nu_min/nu
    pub const NU_RATIO: Number = Number::new(
        ["nu_ratio", "*ν*_min_/*ν*", "1"],
        Range::Fraction,
        "nu_min/nu_max, coefficient of friction at rest over that at high velocity (Constantinou et al. 1990)",
    )
    .usually(Usual::Is(1.0));
    /// a
    pub const NU_RATE: Number = Number::new(
        ["nu_rate", "*a* *ω*_n_Δ", "1"],
        Range::NotNegative,
        "rate a of the coefficient of friction over velocity, times omega_n Delta",
    )
    .usually(Usual::Is(1.0));
}

/// Of the bars, besides the stiffness of the linear spring.
pub mod bars {
    use crate::contact::number::{Number, Range, Usual};

    /// k_h
    pub const K_H: Number = Number::new(
        ["k_h", "*k*_h_", "force/length^1.5"],
        Range::Positive,
        "stiffness of the laws with delta^1.5",
    )
    .usually(Usual::Follows(
        "k_I^1.5/F0^0.5; one of gamma, k_I, k_h is given",
    ));
    /// e
    pub const RESTITUTION: Number = Number::new(
        ["restitution", "*e*", "1"],
        Range::UpToOne,
        "target of the restitution of two rigid bodies, > 0; of rigid with moreau-jean that of the ends of the bars",
    )
    .usually(Usual::Follows("1, or 0 for rigid"));
}

/// Of the contacts of structures, in the units of the study.
pub mod structure {
    use crate::contact::number::{Number, Range, Usual};

    /// All of them, in the order of schema and pages.
    pub const TABLE: [&Number; 23] = [
        &K,
        &K_H,
        &RESTITUTION,
        &COLLIDING_MASS,
        &E,
        &C,
        &R_E,
        &RDOT_E,
        &EXPONENT,
        &SIGMA0,
        &SIGMA1,
        &SIGMA2,
        &STATIC_RATIO,
        &STRIBECK_VELOCITY,
        &LIMIT,
        &NU,
        &N,
        &NU_MIN,
        &NU_RATE,
        &PRESSURE_EXPONENT,
        &K1,
        &K2,
        &FY,
    ];

    /// Of the limit, which every law of friction has.
    pub(in crate::contact) const OF_LIMIT: [&Number; 4] = [&LIMIT, &NU, &N, &PRESSURE_EXPONENT];

    /// k
    pub const K: Number = Number::new(
        ["k", "*k*", "force/length"],
        Range::Positive,
        "stiffness of an impact, of {friction} below the limit, and of other laws before they yield or bend",
    );
    /// k_h
    pub const K_H: Number = Number::new(
        ["k_h", "*k*_h_", "force/length^1.5"],
        Range::Positive,
        "{laws}: k_h of k_h delta^1.5, delta = -r",
    );
    /// Target of the coefficient of restitution.
    pub const RESTITUTION: Number = Number::new(
        ["restitution", "*e*", "1"],
        Range::Fraction,
        "target of the restitution of a damped law of impact, > 0 and <= 1; default 1 (no damping)",
    )
    .usually(Usual::Is(1.0));
    /// m
    pub const COLLIDING_MASS: Number = Number::new(
        ["colliding_mass", "*m*", "mass"],
        Range::Positive,
        "m1 m2/(m1 + m2) of the bodies, for the dashpots of {laws}",
    );
    /// e
    pub const E: Number = Number::new(
        ["e", "*e*", "1"],
        Range::NotNegative,
        "restitution of a rigid impact, from 0 to 1",
    )
    .instead_of("k");
    /// c
    pub const C: Number = Number::new(
        ["c", "*c*", "force/velocity"],
        Range::Positive,
        "viscosity of {friction} at rdot = 0; of viscous, c of c abs(rdot)^a",
    );
    /// r^E
    pub const R_E: Number = Number::new(
        ["rE", "*r*^E^", "length"],
        Range::Positive,
        "instead of k = (limit without motion)/r^E; k does not change with N",
    )
    .instead_of("k");
    /// rdot^E
    pub const RDOT_E: Number = Number::new(
        ["rdotE", "*ṙ*^E^", "length/time"],
        Range::Positive,
        "instead of c = (limit without motion)/rdot^E, of stribeck the static limit; c does not change with N",
    )
    .instead_of("c");
    /// n
    pub const EXPONENT: Number = Number::new(
        ["exponent", "*n*", "1"],
        Range::AtLeastOne,
        "exponent of {laws}, >= 1; default 1",
    )
    .usually(Usual::Is(1.0));
    /// sigma0
    pub const SIGMA0: Number = Number::new(
        ["sigma0", "*σ*_0_", "force/length"],
        Range::Positive,
        "{laws}: stiffness of the bristles",
    );
    /// sigma1
    pub const SIGMA1: Number = Number::new(
        ["sigma1", "*σ*_1_", "force/velocity"],
        Range::NotNegative,
        "{laws}: damping of the bristles; default 0",
    )
    .usually(Usual::Is(0.0));
    /// sigma2
    pub const SIGMA2: Number = Number::new(
        ["sigma2", "*σ*_2_", "force/velocity"],
        Range::NotNegative,
        "{laws}: viscosity of the sliding contact; default 0",
    )
    .usually(Usual::Is(0.0));
    /// L_s/L_k
    pub const STATIC_RATIO: Number = Number::new(
        ["static_ratio", "*ν*_s_/*ν*", "1"],
        Range::AtLeastOne,
        "{laws}: static limit over the kinetic one, >= 1; default 1",
    )
    .usually(Usual::Is(1.0));
    /// v_S
    pub const STRIBECK_VELOCITY: Number = Number::new(
        ["stribeck_velocity", "*v*_S_", "length/time"],
        Range::Positive,
        "{laws}: velocity v_S over which the limit falls to the kinetic one",
    );
    /// v_S of a law that does without a static limit.
    pub const STRIBECK_VELOCITY_OF_STATIC: Number =
        STRIBECK_VELOCITY.usually(Usual::Follows("needed with static_ratio"));
    /// L
    pub const LIMIT: Number = Number::new(
        ["limit", "*νN*", "force"],
        Range::NotNegative,
        "friction limit, instead of nu and N; of coulomb, stribeck and lugre the kinetic one",
    );
    /// nu
    pub const NU: Number = Number::new(
        ["nu", "*ν*", "1"],
        Range::NotNegative,
        "coefficient of friction; the limit is nu N",
    );
    /// N
    pub const N: Number = Number::new(
        ["N", "*N*", "force"],
        Range::Any,
        "force that presses, positive when pressed: a number, one of those below, or a contact with its own law, NAME.N, that presses",
    );
    /// nu_min
    pub const NU_MIN: Number = Number::new(
        ["nu_min", "*ν*_min_", "1"],
        Range::Positive,
        "{laws}: coefficient of friction at rest; nu - (nu - nu_min) exp(-nu_rate |rdot|) when sliding",
    )
    .usually(Usual::Follows("nu"));
    /// a
    pub const NU_RATE: Number = Number::new(
        ["nu_rate", "*a*", "time/length"],
        Range::NotNegative,
        "its rate over velocity",
    )
    .usually(Usual::Follows("given with nu_min"));
    /// p
    pub const PRESSURE_EXPONENT: Number = Number::new(
        ["pressure_exponent", "*p*", "1"],
        Range::UpToOne,
        "p from 0 to 1: nu is multiplied by (N/N0)^(-p), N0 without motion; default 0",
    )
    .usually(Usual::Is(0.0));
    /// k1
    pub const K1: Number = Number::new(
        ["k1", "*k*_1_", "force/length"],
        Range::Positive,
        "stiffness of {laws} before yielding",
    );
    /// k2
    pub const K2: Number = Number::new(
        ["k2", "*k*_2_", "force/length"],
        Range::Any,
        "stiffness of {laws} after yielding, at most k1; of impact-yield > 0",
    );
    /// Fy
    pub const FY: Number = Number::new(
        ["Fy", "*F*_y_", "force"],
        Range::Positive,
        "yield force of {laws}",
    );
}
