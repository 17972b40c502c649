"""Mistakes in studies, each as a change of a good study."""

import copy
from typing import Any

GONE = object()

OSCILLATOR: dict[str, Any] = {
    "problem": "friction-oscillator",
    "parameters": {"law": "displacement-control", "alpha": 0.1, "dT": "pi/10", "duration": "8*pi"},
}

BARS: dict[str, Any] = {
    "problem": "bar-impact",
    "parameters": {"gamma": 1, "n": 10, "dt": 0.01, "duration": 3},
}

STRUCTURE: dict[str, Any] = {
    "problem": "structure",
    "parameters": {"dt": 0.001, "duration": 1, "k": 100},
    "structure": {
        "units": "t, kN, m, s",
        "masses": {"a": 1, "b": {"mass": 2, "direction": "y"}, "c": 3},
        "bars": {"g": {"L": 10, "EA": 100, "mass": 5, "n": 4}},
        "springs": [
            {"between": ["ground", "a"], "k": "k"},
            {"between": ["ground", "c"], "k": 10},
            {"between": ["ground", "b"], "k": 10, "direction": "y"},
        ],
        "contacts": {
            "gap": {"law": "impact", "between": ["a", "c"], "gap": 0.1, "k": 1000},
            "f": {"law": "coulomb", "between": ["ground", "g.left"], "limit": 2},
        },
        "loads": [{"at": "a", "sine": {"amplitude": 1, "omega": 3}}],
        "start": {"a": {"u": 0.1, "v": 0}},
    },
    "metrics": ["peak(a)", "impacts(gap)"],
    "figures": [{"kind": "history", "name": "h", "y": "a"}],
    "checks": [{"metric": "peak(a)", "min": 0}],
}

GOOD = [OSCILLATOR, BARS, STRUCTURE]

# A mistake, the study, the place of the change, and what stands there.
CHANGES: list[tuple[str, dict[str, Any], str, Any]] = [
    ("negative alpha", OSCILLATOR, "parameters/alpha", -0.1),
    ("zero step", OSCILLATOR, "parameters/dT", 0),
    ("unknown law", OSCILLATOR, "parameters/law", "displacement"),
    ("key of another law", OSCILLATOR, "parameters/beta", 0.1),
    ("no duration", OSCILLATOR, "parameters/duration", GONE),
    ("unknown parameter", OSCILLATOR, "parameters/dt", 0.1),
    ("empty axis", OSCILLATOR, "parameters/alpha", []),
    ("true as a number", OSCILLATOR, "parameters/alpha", True),
    ("null", OSCILLATOR, "parameters/alpha", None),
    ("decimal comma", OSCILLATOR, "parameters/alpha", "0,1"),
    ("linspace of two", OSCILLATOR, "parameters/alpha", {"linspace": [0, 1]}),
    ("two rules", OSCILLATOR, "parameters/alpha", {"linspace": [0, 1, 3], "geomspace": [1, 2, 3]}),
    ("unknown problem", OSCILLATOR, "problem", "friction"),
    ("unknown key", OSCILLATOR, "figure", []),
    ("unknown metric", OSCILLATOR, "metrics", ["rms"]),
    ("unknown kind", OSCILLATOR, "figures", [{"kind": "lines", "name": "a"}]),
    ("figure without name", OSCILLATOR, "figures", [{"kind": "sweep"}]),
    ("unknown method", OSCILLATOR, "parameters/method", "newmark2"),
    ("both forms", OSCILLATOR, "blocks", [{"parameters": {"law": "displacement-control", "alpha": 0.1, "dT": "pi/10", "duration": "8*pi"}}]),
    ("calibrate", OSCILLATOR, "calibrate", {}),
    ("x0 of zero", OSCILLATOR, "parameters/x0", 0),
    ("iteration", OSCILLATOR, "iteration", "twice"),
    ("check without limits", OSCILLATOR, "checks", [{"metric": "rms_error"}]),
    ("restitution for a spring", BARS, "parameters/restitution", 0.5),
    ("fractional n", BARS, "parameters/n", 2.5),
    ("n of zero", BARS, "parameters/n", 0),
    ("negative density", BARS, "parameters/rho", -1),
    ("unknown key of right", BARS, "parameters/right", {"Q": 1}),
    ("right misspelt", BARS, "parameters/right", "Wall"),
    ("mass misspelt", BARS, "parameters/mass", "lump"),
    ("negative gap", BARS, "parameters/gap", -1),
    ("too many elements", BARS, "parameters/n", 1000000000),
    ("units in another order", STRUCTURE, "structure/units", "kN, t, m, s"),
    ("one unit", STRUCTURE, "structure/units", "foo"),
    ("Fortran's exponent", STRUCTURE, "structure/contacts/gap/k", "5d4"),
    ("digits in groups", STRUCTURE, "structure/contacts/gap/k", "50_000"),
    ("law with a capital", STRUCTURE, "structure/contacts/gap/law", "Impact"),
    ("law with an underscore", STRUCTURE, "structure/contacts/gap/law", "kelvin_voigt"),
    ("channel in other letters", STRUCTURE, "metrics", ["peak(gap.s)"]),
    ("channel of other programs", STRUCTURE, "metrics", ["2*peak(gap.F)"]),
    ("channel of a figure in other letters", STRUCTURE, "figures/0/y", ["a - c", "gap.Rdot"]),
    ("negative mass", STRUCTURE, "structure/masses/a", -1),
    ("negative mass in y", STRUCTURE, "structure/masses/b/mass", -2),
    ("unknown direction", STRUCTURE, "structure/masses/b/direction", "w"),
    ("unknown key of mass", STRUCTURE, "structure/masses/b/m", 2),
    ("zero length", STRUCTURE, "structure/bars/g/L", 0),
    ("negative EA", STRUCTURE, "structure/bars/g/EA", -1),
    ("bar without n", STRUCTURE, "structure/bars/g/n", GONE),
    ("fractional elements", STRUCTURE, "structure/bars/g/n", 2.5),
    ("zero elements", STRUCTURE, "structure/bars/g/n", 0),
    ("negative ratio", STRUCTURE, "structure/springs/0/ratio", -0.1),
    ("negative dashpot", STRUCTURE, "structure/springs/0/c", -1),
    ("spring without k", STRUCTURE, "structure/springs/1/k", GONE),
    ("spring without nodes", STRUCTURE, "structure/springs/1/between", GONE),
    ("three nodes", STRUCTURE, "structure/springs/1/between", ["ground", "a", "c"]),
    ("unknown key of spring", STRUCTURE, "structure/springs/1/K", 1),
    ("between and along", STRUCTURE, "structure/springs/1/along", {"c": 1}),
    ("direction twice", STRUCTURE, "structure/springs/1/direction", "up"),
    ("unknown law of a contact", STRUCTURE, "structure/contacts/gap/law", "gapp"),
    ("contact without law", STRUCTURE, "structure/contacts/gap/law", GONE),
    ("contact without nodes", STRUCTURE, "structure/contacts/gap/between", GONE),
    ("contact without k", STRUCTURE, "structure/contacts/gap/k", GONE),
    ("key of another law in a contact", STRUCTURE, "structure/contacts/gap/nu", 0.1),
    ("rE for coulomb", STRUCTURE, "structure/contacts/f/rE", 0.1),
    ("limit for gap", STRUCTURE, "structure/contacts/gap/limit", 1),
    ("negative k of gap", STRUCTURE, "structure/contacts/gap/k", -5),
    ("negative limit", STRUCTURE, "structure/contacts/f/limit", -2),
    ("unknown key of contact", STRUCTURE, "structure/contacts/gap/stiffness", 5),
    ("restitution above 1", STRUCTURE, "structure/contacts/gap", {"law": "kelvin-voigt", "between": ["a", "c"], "gap": 0, "k": 10, "restitution": 1.5}),
    ("velocity-control without rdotE", STRUCTURE, "structure/contacts/f", {"law": "velocity-control", "between": ["ground", "a"], "limit": 1}),
    ("velocity-control with rE", STRUCTURE, "structure/contacts/f", {"law": "velocity-control", "between": ["ground", "a"], "limit": 1, "rdotE": 0.1, "rE": 0.1}),
    ("negative rE", STRUCTURE, "structure/contacts/f", {"law": "displacement-control", "between": ["ground", "a"], "limit": 1, "rE": -0.1}),
    ("limit and nu N", STRUCTURE, "structure/contacts/f", {"law": "coulomb", "between": ["ground", "a"], "limit": 1, "nu": 0.1, "N": 5}),
    ("nu without N", STRUCTURE, "structure/contacts/f", {"law": "coulomb", "between": ["ground", "a"], "nu": 0.1}),
    ("two relations", STRUCTURE, "structure/contacts/f", {"law": "coulomb", "between": ["ground", "a"], "limit": 1, "series": []}),
    ("series of one", STRUCTURE, "structure/contacts/f", {"between": ["ground", "a"], "series": [{"law": "coulomb", "limit": 1}]}),
    ("unknown law in a series", STRUCTURE, "structure/contacts/f", {"between": ["ground", "a"], "series": [{"law": "coulomb", "limit": 1}, {"law": "gup", "k": 1}]}),
    ("negative in a series", STRUCTURE, "structure/contacts/f", {"between": ["ground", "a"], "series": [{"law": "coulomb", "limit": -1}, {"law": "impact", "gap": 0, "k": 1}]}),
    ("N without weight", STRUCTURE, "structure/contacts/f", {"law": "coulomb", "between": ["ground", "a"], "nu": 0.1, "N": {"vertical": {"sine": {"amplitude": 1, "omega": 1}}}}),
    ("zero weight", STRUCTURE, "structure/contacts/f", {"law": "coulomb", "between": ["ground", "a"], "nu": 0.1, "N": {"weight": 0, "vertical": {"sine": {"amplitude": 1, "omega": 1}}}}),
    ("load without node", STRUCTURE, "structure/loads/0/at", GONE),
    ("load without function", STRUCTURE, "structure/loads/0/sine", GONE),
    ("two functions", STRUCTURE, "structure/loads/0/table", {"t": [0, 1], "f": [0, 1]}),
    ("sine without omega", STRUCTURE, "structure/loads/0/sine/omega", GONE),
    ("unknown key of load", STRUCTURE, "structure/loads/0/node", "a"),
    ("end of a sine", STRUCTURE, "structure/loads/0/end", 1),
    ("zero frequency", STRUCTURE, "structure/ground", {"pulse": {"ricker": {"amplitude": 1, "frequency": 0, "at": 1, "sampled": 0.01}}}),
    ("pulse of two forms", STRUCTURE, "structure/ground", {"pulse": {"ricker": {"amplitude": 1, "frequency": 1, "at": 1, "sampled": 0.01}, "cosine": {"amplitude": 1, "period": 1, "sampled": 0.01}}}),
    ("empty pulse", STRUCTURE, "structure/ground", {"pulse": {}}),
    ("negative period", STRUCTURE, "structure/ground", {"pulse": {"cosine": {"amplitude": 1, "period": -1, "sampled": 0.01}}}),
    ("negative seed", STRUCTURE, "structure/ground", {"synthetic": -3}),
    ("fractional seed", STRUCTURE, "structure/ground", {"synthetic": 1.5}),
    ("seed above", STRUCTURE, "structure/ground", {"synthetic": 4294967296}),
    ("zero omega", STRUCTURE, "structure/ground", {"synthetic": {"seed": 1, "omega": 0}}),
    ("unknown unit", STRUCTURE, "structure/ground", {"table": {"t": [0, 1], "f": [0, 1]}, "unit": "gal"}),
    ("unknown baseline", STRUCTURE, "structure/ground", {"table": {"t": [0, 1], "f": [0, 1]}, "baseline": "quadratic"}),
    ("negative start", STRUCTURE, "structure/ground", {"table": {"t": [0, 1], "f": [0, 1]}, "start": -1}),
    ("negative delay", STRUCTURE, "structure/ground", {"table": {"t": [0, 1], "f": [0, 1]}, "delay": -1}),
    ("unknown measure", STRUCTURE, "structure/ground", {"table": {"t": [0, 1], "f": [0, 1]}, "scale_to": {"PGA": 1}}),
    ("zero pga", STRUCTURE, "structure/ground", {"table": {"t": [0, 1], "f": [0, 1]}, "scale_to": {"pga": 0}}),
    ("two measures", STRUCTURE, "structure/ground", {"table": {"t": [0, 1], "f": [0, 1]}, "scale_to": {"pga": 1, "pgv": 1}}),
    ("table without f", STRUCTURE, "structure/ground", {"table": {"t": [0, 1]}}),
    ("empty table", STRUCTURE, "structure/ground", {"table": {"t": [], "f": []}}),
    ("dt of zero", STRUCTURE, "structure/ground", {"record": "a.txt", "dt": 0}),
    ("column of zero", STRUCTURE, "structure/ground", {"record": "a.txt", "column": 0}),
    ("mean misspelt", STRUCTURE, "structure/ground", {"record": "a.txt", "mean": "remove"}),
    ("unknown key of function", STRUCTURE, "structure/ground", {"sin": {"amplitude": 1, "omega": 1}}),
    ("no function", STRUCTURE, "structure/ground", {}),
    ("direction w", STRUCTURE, "structure/ground", {"w": {"synthetic": 1}}),
    ("negative rayleigh", STRUCTURE, "structure/rayleigh", {"mass": -1}),
    ("unknown key of rayleigh", STRUCTURE, "structure/rayleigh", {"alpha": 1}),
    ("negative damping", STRUCTURE, "structure/modal_damping", -0.1),
    ("unknown key of structure", STRUCTURE, "structure/nodes", {}),
    ("unknown reference", STRUCTURE, "structure/contacts_reference", "exact"),
    ("unknown damping stiffness", STRUCTURE, "structure/damping_stiffness", "tangent"),
    ("unknown key of start", STRUCTURE, "structure/start/a/x", 1),
    ("no structure", STRUCTURE, "structure", GONE),
    ("zero dt", STRUCTURE, "parameters/dt", 0),
    ("negative duration", STRUCTURE, "parameters/duration", -1),
    ("no dt", STRUCTURE, "parameters/dt", GONE),
    ("method misspelt", STRUCTURE, "parameters/method", "average-accel"),
    ("list of methods misspelt", STRUCTURE, "parameters/method", ["moreau-jean", "moreau"]),
    ("alpha of hht", STRUCTURE, "parameters/alpha_hht", 0.1),
    ("rho above one", STRUCTURE, "parameters", {"dt": 0.001, "duration": 1, "k": 100, "method": "generalized-alpha", "rho_inf": 1.5}),
    ("rho without its method", STRUCTURE, "parameters/rho_inf", 0.5),
    ("unknown reduction", STRUCTURE, "metrics", ["peek(a)"]),
    ("reduction without channel", STRUCTURE, "metrics", ["peak"]),
    ("unclosed metric", STRUCTURE, "metrics", ["peak(a"]),
    ("measure of the ground", STRUCTURE, "metrics", ["ground.PGA"]),
    ("channel for steps", STRUCTURE, "metrics", ["energy_error(a)"]),
    ("unknown figure", STRUCTURE, "figures/0/kind", "histories"),
    ("figure of bars", STRUCTURE, "figures/0", {"kind": "snapshots", "name": "a"}),
    ("file name", STRUCTURE, "figures/0/name", "a b/c"),
    ("check in words", STRUCTURE, "checks/0/min", "low"),
    ("check without limits of a structure", STRUCTURE, "checks/0/min", GONE),
    ("unknown key of check", STRUCTURE, "checks/0/maximum", 1),
    ("cut of zero", STRUCTURE, "structure/matrices", {"m": {"M": "M.mtx", "K": "K.mtx", "dofs": "d.csv", "reduce": {"up_to": 0}}}),
    ("matrices without K", STRUCTURE, "structure/matrices", {"m": {"M": "M.mtx", "dofs": "d.csv"}}),
    ("two reductions", STRUCTURE, "structure/matrices", {"m": {"M": "M.mtx", "K": "K.mtx", "dofs": "d.csv", "reduce": {"up_to": 1, "modes": 2}}}),
    ("support without motion", STRUCTURE, "structure/supports", {"s": {}}),
    ("negative delay of a support", STRUCTURE, "structure/supports", {"s": {"synthetic": 1, "delay": -1}}),
    ("displacement and acceleration", STRUCTURE, "structure/supports", {"s": {"synthetic": 1, "displacement": {"t": [0, 1], "u": [0, 1]}}}),
    ("node with a dot", STRUCTURE, "structure/masses/a.b", 1),
    ("name with a space", STRUCTURE, "structure/masses/a b", 1),
    ("contact with a space", STRUCTURE, "structure/contacts/a b", {"law": "impact", "between": ["a", "c"], "gap": 0, "k": 1}),
    ("reserved name", STRUCTURE, "structure/masses/ground", 1),
    ("measured without columns", STRUCTURE, "measured", {"file": "a.csv", "time": "t"}),
]

# A law may be a parameter, and any name may be a parameter that an expression contains.
ONLY_THE_PROGRAM = {"unknown law of a contact", "unknown law in a series", "alpha of hht", "unknown parameter"}


def changed(study: dict[str, Any], path: str, value: Any) -> dict[str, Any]:
    """The study with one change."""
    new = copy.deepcopy(study)
    *folders, key = (int(part) if part.isdigit() else part for part in path.split("/"))
    at: Any = new
    for folder in folders:
        at = at[folder]
    if value is GONE:
        del at[key]
    else:
        at[key] = value
    return new


MISTAKES = {name: changed(study, path, value) for name, study, path, value in CHANGES}
