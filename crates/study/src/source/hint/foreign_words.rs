//! Words of other programs. They are written as `super::plain` writes them: without capitals, `_`, `-`, `.` and blanks.

/// Synonyms of names, each with the names that it may refer to. The first of them that is allowed is used. The laws have their own.
pub(crate) const SYNONYMS: &[(&[&str], &[&str])] = &[
    (
        &["logspace", "logrange", "geometric", "geom"],
        &["geomspace"],
    ),
    (&["arange", "seq", "sequence"], &["range"]),
    (&["linrange", "linear"], &["linspace"]),
    (&["lognormal", "logarithmic"], &["loguniform", "log"]),
    (
        &["lhs", "lhc", "latinhypercubesampling"],
        &["latin-hypercube"],
    ),
    (&["alfa"], &["alpha"]),
    (
        &["timestep", "step", "stepsize", "deltat", "h"],
        &["dT", "dt"],
    ),
    (
        &["tend", "tmax", "tfinal", "endtime", "time", "totaltime"],
        &["duration"],
    ),
    (&["initialdisplacement", "amplitude", "u0"], &["x0"]),
    (
        &["initialvelocity", "velocity", "speed", "impactvelocity"],
        &["V0"],
    ),
    (&["elements", "nelements", "nel", "mesh"], &["n"]),
    (&["youngsmodulus", "youngmodulus", "modulus"], &["E"]),
    (&["area", "crosssection"], &["A"]),
    (&["density"], &["rho"]),
    (&["length"], &["L"]),
    (
        &[
            "penalty",
            "contactstiffness",
            "impactstiffness",
            "springstiffness",
        ],
        &["k_I"],
    ),
    (
        &["impact", "collision", "pounding", "bars"],
        &["bar-impact"],
    ),
    (&["oscillator", "sdof"], &["friction-oscillator"]),
    (
        &["structures", "mdof", "frame", "bridge", "building"],
        &["structure"],
    ),
    (
        &["minimize", "objective", "misfit", "target"],
        &["minimise"],
    ),
    (
        &[
            "calibration",
            "fit",
            "identify",
            "identification",
            "optimise",
            "optimize",
        ],
        &["calibrate"],
    ),
    (
        &["recommendation", "advise", "choose", "cheapest"],
        &["recommend"],
    ),
    (&["tolerance", "tolerances", "keep", "limits"], &["within"]),
    (
        &["budget", "evaluations", "maxevaluations", "maxiter"],
        &["cases"],
    ),
    (
        &["integrator", "integration", "scheme", "timeintegration"],
        &["method"],
    ),
    (
        &[
            "trapezoidal",
            "trapezoidalrule",
            "constantaverageacceleration",
        ],
        &["average-acceleration"],
    ),
    (&["hilberhughestaylor", "hhtalpha"], &["hht", "hht_alpha"]),
    (&["explicit", "verlet", "leapfrog"], &["central-difference"]),
    (&["spectralradius"], &["rho_inf"]),
    (&["coefficientofrestitution"], &["restitution"]),
    (&["timehistory"], &["history"]),
    (&["contour", "heatmap"], &["map"]),
    (&["filter", "select"], &["where", "when"]),
    (&["smallest", "lowest", "minimum"], &["least", "min"]),
    (&["largest", "highest", "maximum"], &["greatest", "max"]),
    (&["average", "arithmeticmean"], &["mean"]),
    (&["percentile", "fractile"], &["quantile P of"]),
];

/// Words for quantities that only structures have, and the quantity.
pub(crate) const OF_STRUCTURES: &[(&[&str], &str)] = &[
    (
        &[
            "damping",
            "dampingratio",
            "zeta",
            "xi",
            "rayleigh",
            "dashpot",
        ],
        "damping",
    ),
    (
        &[
            "forcing",
            "load",
            "excitation",
            "forcingfrequency",
            "frequencyratio",
        ],
        "applied forces",
    ),
    (
        &[
            "groundmotion",
            "groundacceleration",
            "record",
            "earthquake",
            "accelerogram",
            "pga",
            "basemotion",
        ],
        "ground motion",
    ),
    (
        &[
            "plasticity",
            "yield",
            "yieldstress",
            "yieldstrength",
            "hardening",
        ],
        "plastic deformation",
    ),
];

/// Words for quantities that this program does not model, and the quantity.
pub(crate) const OUTSIDE: &[(&[&str], &str)] = &[(&["poisson", "poissonratio"], "lateral strain")];

/// Words for the scales of the friction oscillator, which has the parameter `alpha`.
pub(crate) const SCALED: &[&str] = &[
    "mu",
    "nu",
    "frictioncoefficient",
    "normalforce",
    "k",
    "stiffness",
    "m",
    "mass",
    "omega",
    "omegan",
    "frequency",
    "period",
];

/// Units that a number may carry in other programs.
pub(crate) const UNITS: &[&str] = &[
    "s", "sec", "ms", "us", "µs", "min", "Hz", "kHz", "m", "cm", "mm", "km", "um", "µm", "in",
    "ft", "N", "kN", "MN", "Pa", "kPa", "MPa", "GPa", "psi", "kg", "g", "t", "rad", "deg", "°",
    "%",
];
