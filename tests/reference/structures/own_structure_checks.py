"""Checks of own_structure.py; each prints what it compares.

    python3 own_structure_checks.py opensees     frames with contacts against OpenSees (needs openseespy)
    python3 own_structure_checks.py massless     rotations without mass against rotations with small masses
    python3 own_structure_checks.py supports     all supports with one motion against ground with it, for several steps
"""

import copy
import sys

import numpy as np
from scipy.io import mmread, mmwrite

from own_structure import solve
from own_structure_data import FOLDER, GAPS, cases, channels, ground
from own_structure_model import Motion

OPTIONS = {"frames": {}, "rotations with mass": {"rotary": 0.5, "damping": (0.3, 0.002)},
           "rotations with damping and no mass": {"damping": (0.3, 0.002)}}


def named(name):
    return copy.deepcopy(next(data for found, data in cases() if found == name))


def opensees_motion(options, data):
    """u of all nodes by OpenSees' own transient analysis, with a zero-length element of `ElasticPPGap` for every gap."""
    import frame
    import openseespy.opensees as ops

    frame.build(**options)
    for tag, (name, gap) in enumerate(data["structure"]["contacts"].items(), 1):
        # Its force is E (strain - gap) below a negative gap: that of S = k min(r, 0). The yield force is out of reach.
        ops.uniaxialMaterial("ElasticPPGap", tag, gap["k"], -1e20, -gap["gap"])
        dofs = gap.get("between") or ["f.132.x", "f.231.x"]
        i, j = (int(d.split(".")[1]) for d in dofs)
        axis = (0.6, 0.8) if name == "skew" else (1.0, 0.0)
        ops.element("zeroLength", 100 + tag, i, j, "-mat", tag, "-dir", 1, "-orient", *axis, 0.0, -axis[1], axis[0], 0.0)
    for tag, (d, g) in enumerate(data["structure"]["ground"].items(), 1):
        table = np.loadtxt(FOLDER / g["record"], delimiter=",", skiprows=1)
        ops.timeSeries("Path", tag, "-dt", 0.01, "-values", *(g["scale"] * table[:, 1]))
        ops.pattern("UniformExcitation", tag, {"x": 1, "y": 2}[d], "-accel", tag)
    ops.constraints("Plain")
    ops.numberer("RCM")
    ops.system("UmfPack")
    ops.test("NormUnbalance", 1e-9, 50)
    ops.algorithm("Newton")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")
    dt, nodes = data["parameters"]["dt"], [n for n in ops.getNodeTags() if n % 100 > 10]
    rows = [np.zeros(3 * len(nodes))]
    for step in range(round(data["parameters"]["duration"] / dt)):
        ops.setTime(step * dt)
        if ops.analyze(1, dt):
            raise ArithmeticError(f"OpenSees does not converge at step {step + 1}")
        rows.append(np.array([ops.nodeDisp(n, d) for n in nodes for d in (1, 2, 3)]))
    return [f"f.{n}.{d}.u" for n in nodes for d in ("x", "y", "rz")], np.array(rows)


def opensees():
    for name, options in OPTIONS.items():
        data = named(name)
        for title, keep in (("without contacts", ()), ("with contacts", GAPS)):
            data["structure"]["contacts"] = {c: GAPS[c] for c in keep}
            _, found = channels(*solve(data, FOLDER))
            columns, theirs = opensees_motion(options, data)
            worst = max((float(np.abs(theirs[:, i] - found[c]).max() / np.abs(found[c]).max()), c) for i, c in enumerate(columns))
            print(f"{name}, {title}: largest difference over the largest value of the channel {worst[0]:.2e} in {worst[1]}")


def massless():
    data = named("frames")
    _, found = channels(*solve(data, FOLDER))
    M = mmread(FOLDER / "frames.M.mtx").todense()
    for mass in (1e-4, 1e-5, 1e-6):
        small = np.array(M)
        small[2::3, 2::3] += mass * np.eye(12)
        mmwrite(str(FOLDER / "small.M.mtx"), small, precision=17, symmetry="symmetric")
        data["structure"]["matrices"]["f"]["M"] = "small.M.mtx"
        _, other = channels(*solve(data, FOLDER))
        (FOLDER / "small.M.mtx").unlink()
        worst = {q: max(float(np.abs(other[c] - a).max() / np.abs(a).max()) for c, a in found.items() if c.endswith(q))
                 for q in ("x.u", "rz.u", "S")}
        print(f"rotary mass {mass}: differences over the largest values {worst}")


def supports():
    for dt in (0.01, 0.005, 0.0025, 0.00125):
        data = named("supports")
        data["parameters"]["dt"] = dt
        s = data["structure"]
        record = ground()["x"]
        s["contacts"] = {"top": s["contacts"]["top"]}
        s["supports"] = {"west": record, "east": record}
        forms = [channels(*solve(data, FOLDER, split))[1] for split in (False, True)]
        del s["supports"]
        s["ground"] = {"x": record}
        # The rows of supports are left out: the ground holds them.
        relative = fixed_bases(data)
        moving = Motion(record, FOLDER)
        us = np.array([moving.at(np.longdouble(dt) * i)[2] for i in range(len(relative["f.121.x.u"]))])
        worst = [max(float(np.abs(found[c] - (us if ".x." in c else 0) - a).max() / np.abs(a).max())
                     for c, a in relative.items() if c.endswith(".u")) for found in forms]
        print(f"dt {dt}: supports less ground with one motion, over the peak: steps of u {worst[0]:.2e}, of w {worst[1]:.2e}")


def fixed_bases(data):
    with open(FOLDER / "bases.dofs.csv", encoding="utf-8") as file:
        rows = file.read().splitlines()
    free = [i for i, row in enumerate(rows[1:]) if row.split(",")[2] == ""]
    for m in "MKC":
        a = np.asarray(mmread(FOLDER / f"bases.{m}.mtx").todense())
        mmwrite(str(FOLDER / f"small.{m}.mtx"), a[np.ix_(free, free)], precision=17, symmetry="symmetric")
    (FOLDER / "small.dofs.csv").write_text("\n".join([rows[0]] + [rows[i + 1] for i in free]) + "\n", encoding="utf-8")
    data["structure"]["matrices"]["f"] = {**{m: f"small.{m}.mtx" for m in "MKC"}, "dofs": "small.dofs.csv"}
    _, found = channels(*solve(data, FOLDER))
    for path in FOLDER.glob("small.*"):
        path.unlink()
    return found


if __name__ == "__main__":
    {"opensees": opensees, "massless": massless, "supports": supports}[sys.argv[1]]()
