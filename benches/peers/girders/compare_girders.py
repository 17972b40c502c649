"""Prints how fast each program steps the three girders, and how far their displacements lie apart over 20 s.

The displacements of all nodes at every 0.1 s are written to target/peers-girders/PROGRAM-N.csv.
"""

import csv
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np

import at_hand
import girders_loop
from girders import ELEMENTS, STEP, STEPS, write

HERE = pathlib.Path(__file__).parent
TURNS = 3
CASES = 64  # widths of the gap, for the time of a sweep by slipgap
DEMANDED = 1e-10  # m


def slipgap(program, study, *more, read=lambda folder: None):
    """Seconds of a run on one thread, from nothing, and what is read of its results."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "girders.json"
        file.write_text(json.dumps(study))
        start = time.perf_counter()
        subprocess.run([program, "run", file, "--out", folder, "--jobs", "1", *more], check=True, stdout=subprocess.PIPE)
        return time.perf_counter() - start, read(file.with_suffix(""))


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


def by_slipgap(root, found):
    """ns a step for each mesh; the displacements are added to `found`."""
    program, study = root / "target" / "release" / "slipgap", json.loads((HERE / "girders.json").read_text())

    def histories(folder):
        for case, n in enumerate(ELEMENTS):
            names, times, _ = found["numba loop", n]
            found["slipgap", n] = names, times, displacements(folder / "histories" / f"{case}.csv", names, times)

    slipgap(program, study, "--histories", "--format", "csv", read=histories)
    return [statistics.median(slipgap(program, swept(study, n))[0] for _ in range(TURNS)) / CASES / STEPS * 1e9
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
    rows = {f"slipgap run, {CASES} cases": by_slipgap(root, found), **rows}
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
    if not all(x <= DEMANDED for row in apart.values() for x in row):
        sys.exit(f"displacements differ by more than {DEMANDED} m")


main()
