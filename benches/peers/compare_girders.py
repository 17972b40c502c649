"""Prints how fast each program steps the three girders, and how far their displacements lie apart over 20 s.

The displacements of all nodes at every 0.1 s are written to target/peers-girders/PROGRAM-N.csv.
"""

import csv
import json
import pathlib
import statistics
import subprocess
import sys
import time

import numpy as np

import at_hand
import girders_loop
from girders import ELEMENTS, STEP, STEPS, write

HERE = pathlib.Path(__file__).parent
TURNS = 3
CASES = 64  # widths of the gap, for the time of a sweep by slipgap
DEMANDED = 1e-10  # m


def slipgap(program, study, folder, *more):
    """Seconds of a run on one thread."""
    file = folder / "girders.json"
    file.write_text(json.dumps(study))
    start = time.perf_counter()
    done = subprocess.run([program, "run", file, "--out", folder, "--jobs", "1", *more], capture_output=True, text=True)
    if done.returncode:
        raise RuntimeError(done.stderr.strip().splitlines()[0])
    return time.perf_counter() - start


def swept(study, n):
    """The study with one mesh and many widths of the gap."""
    return {**study, "parameters": {**study["parameters"], "n": n, "gap": {"linspace": [0.01, 0.03, CASES]}}}


def displacements(file, names, times):
    """Displacements of the nodes at the times from a history."""
    with open(file, encoding="utf-8") as table:
        rows = list(csv.DictReader(table))
    picked = [rows[round(t / STEP)] for t in times]
    assert all(abs(float(row["t"]) - t) < 1e-9 for row, t in zip(picked, times))
    return np.array([[float(row[f"{name}.u"]) for name in names] for row in picked])


def by_slipgap(root, folder, found):
    """ns a step for each mesh and the displacements; nothing, and a message, where slipgap refuses the study."""
    program, study = root / "target" / "release" / "slipgap", json.loads((HERE / "girders.json").read_text())
    try:
        slipgap(program, study, folder, "--histories", "--format", "csv")
    except RuntimeError as fault:
        print(f"slipgap does not run girders.json, its row is left out: {fault}")
        return None
    for case, n in enumerate(ELEMENTS):
        names, times, _ = found["numba loop", n]
        file = folder / "girders" / "histories" / f"{case}.csv"
        found["slipgap", n] = names, times, displacements(file, names, times)
    return [statistics.median(slipgap(program, swept(study, n), folder) for _ in range(TURNS)) / CASES / STEPS * 1e9
            for n in ELEMENTS]


def main():
    root = pathlib.Path(sys.argv[1])
    folder = root / "target" / "peers-girders"
    folder.mkdir(parents=True, exist_ok=True)
    programs = {"numba loop": girders_loop}
    if opensees := at_hand.opensees("girders_opensees"):
        programs["OpenSees"] = opensees
    found, times, rounds = {}, {}, {}
    for _ in range(TURNS):
        for n in ELEMENTS:
            for name, module in programs.items():
                *found[name, n], ns, rounds[name, n] = module.run(n)
                times.setdefault((name, n), []).append(ns)
    rows = {name: [statistics.median(times[name, n]) for n in ELEMENTS] for name in programs}
    if own := by_slipgap(root, folder, found):
        rows = {f"slipgap run, {CASES} cases": own, **rows}
    print("\n| ns a step, degrees of freedom |", " | ".join(str(3 * (n + 2)) for n in ELEMENTS), "|")
    print("|---|---:|---:|---:|---:|")
    for name, row in rows.items():
        print(f"| {name} |", " | ".join(f"{ns:.0f}" for ns in row), "|")
    for name in programs:
        print(f"| rounds a step, {name} |", " | ".join(f"{rounds[name, n]:.3f}" for n in ELEMENTS), "|")
    apart = {}
    for (name, n), (names, t, u) in found.items():
        write(folder / f"{name.split()[0].lower()}-{n}.csv", names, t, u)
        if name != "numba loop":
            assert names == found["numba loop", n][0]
            apart.setdefault(name, []).append(np.max(np.abs(u - found["numba loop", n][2])))
    for name, row in apart.items():
        print(f"| displacements, {name} less numba loop, m |", " | ".join(f"{x:.0e}" for x in row), "|")
    if any(x > DEMANDED for row in apart.values() for x in row):
        sys.exit(f"displacements differ by more than {DEMANDED} m")


main()
