"""The rows of the girders with 9 and 99 degrees of freedom, and how far the displacements of all programs lie apart."""

import csv
import json
import pathlib

import numpy as np

import at_hand
from girders import STEP, STEPS

STUDY = json.loads((pathlib.Path(__file__).parent / "girders.json").read_text())
ELEMENTS, CONTACTS = (1, 31), 5
CASES = 64  # widths of the gap
DEMANDED = 1e-10  # m


def study(n, gap):
    return {**STUDY, "parameters": {**STUDY["parameters"], "n": n, "gap": gap}}


def displacements(program, n, names, times):
    """Displacements of the nodes at the times."""
    def history(results):
        with open(results / "histories" / "0.csv", encoding="utf-8") as table:
            return list(csv.DictReader(table))

    *_, rows = program.run(study(n, 0.02), None, "--histories", "--format", "csv", read=history)
    return np.array([[float(rows[round(t / STEP)][f"{name}.u"]) for name in names] for t in times])


def row(n, program, turns, part, rates):
    size, cases = 3 * (n + 2), max(CASES // part, 16)
    # Ten additions for a node, ten for a contact and their matrix.
    additions = 10 * size + 10 * CONTACTS + CONTACTS**2
    found = {"problem": f"girders, {size} dofs, {CONTACTS} contacts", "cases": cases, "steps": STEPS}
    found["floor"] = additions / rates["additions"]
    for column, name in (("numba", "girders_loop"), ("OpenSees", "girders_opensees")):
        if module := at_hand.module(name):
            runs = [module.run(n) for _ in range(turns if column == "numba" else 1)]
            names, times, u, *_ = runs[0]
            found[column] = min(ns for *_, ns, _ in runs)
            apart = np.max(np.abs(u - displacements(program, n, names, times)))
            assert apart < DEMANDED, (name, n, apart)
    swept = study(n, {"linspace": [0.01, 0.03, cases]})
    runs = [program.run(swept) for _ in range(turns)]
    found["whole"] = min(seconds for seconds, *_ in runs) / cases / STEPS * 1e9
    found["MB"] = max(memory for _, memory, _ in runs)
    found["kernel"] = min(program.kernel(swept) for _ in range(turns)) / cases / STEPS * 1e9
    return found


def rows(program, turns, part, rates):
    return [row(n, program, turns, part, rates) for n in ELEMENTS]
