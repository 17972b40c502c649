"""Prints what a step, the set-up and the memory of a large model cost: slipgap, SuperLU, CHOLMOD, OpenSees.

All times are processor times on one thread. Those of slipgap are differences of whole runs of `slipgap run`.
"""

import pathlib
import statistics
import subprocess
import sys
import tempfile

import numpy as np

import at_hand
import large
import large_libraries
from large import FEW, MESHES, STEPS

TURNS = 3
SOLUTIONS = [400, 100, 20]
STEPS_OF_OPENSEES = [(200, 40), (50, 10), (10, 3)]  # without and with contacts
FORCES = ["peak(face.1.S)"]
DEMANDED = 1e-9


# A process begins with the memory of the one that starts it: that of this script is larger than what is measured.
MEASURE = """
import resource, subprocess, sys
subprocess.run(sys.argv[1:], check=True, stdout=subprocess.DEVNULL)
used = resource.getrusage(resource.RUSAGE_CHILDREN)
print(used.ru_utime + used.ru_stime, used.ru_maxrss / 1e3)
"""


def slipgap(program, folder, name):
    """Processor time of a run in s, and its largest memory in MB."""
    with tempfile.TemporaryDirectory() as out:
        command = [program, "run", folder / name, "--out", out, "--jobs", "1"]
        done = subprocess.run([sys.executable, "-c", MEASURE, *command], check=True, stdout=subprocess.PIPE, text=True)
    seconds, memory = map(float, done.stdout.split())
    return seconds, memory


def studies(of, folder, steps):
    for name, metrics in (("forces", FORCES), ("energy", [*FORCES, "energy_error"])):
        for kind, count in (("few", FEW), ("all", FEW + steps)):
            (folder / f"{name}-{kind}.json").write_text(large.study(of, count, metrics))


def main():
    root = pathlib.Path(sys.argv[1])
    program = root / "target" / "release" / "slipgap"
    opensees = at_hand.opensees("large_opensees")
    models = [large.Block(*mesh) for mesh in MESHES]
    rows = {}

    def add(row, size, value):
        rows.setdefault(row, {}).setdefault(size, []).append(value)

    for size, (of, steps) in enumerate(zip(models, STEPS)):
        folder = root / "target" / "peers-large" / str(len(of))
        large.write(of, folder)
        studies(of, folder, steps)
        apart = None
        for _ in range(TURNS):
            for name, row in (("forces", "slipgap run"), ("energy", "slipgap run with energy_error")):
                few, _ = slipgap(program, folder, f"{name}-few.json")
                whole, memory = slipgap(program, folder, f"{name}-all.json")
                step = (whole - few) / steps
                add(f"ms of a step, {row}", size, 1e3 * step)
                if name == "forces":
                    add("s of the set-up, slipgap run", size, few - FEW * step)
                    add("MB, slipgap run", size, memory)
            factor, solution, step, _ = large_libraries.superlu(of, SOLUTIONS[size])
            add("ms of a solution, SuperLU", size, solution)
            add("ms of a step without contacts, numpy with SuperLU", size, step)
            add("s of the factor, SuperLU", size, factor)
            factor, solution = large_libraries.cholesky(of, SOLUTIONS[size])
            add("ms of a solution, CHOLMOD", size, solution)
            add("s of the factor, CHOLMOD", size, factor)
        if opensees:
            free, touching = STEPS_OF_OPENSEES[size]
            *_, u = large_libraries.superlu(of, free)
            first, step, own = opensees.run(of, False, free)
            apart = np.max(np.abs(own - u)) / np.max(np.abs(u))
            add("ms of a step without contacts, OpenSees", size, step)
            add("s of the first step, OpenSees", size, first)
            _, step, _ = opensees.run(of, True, touching)
            add("ms of a step, OpenSees", size, step)
            if apart > DEMANDED:
                sys.exit(f"OpenSees has other matrices: u differs by {apart}")
    print("\n| degrees of freedom |", " | ".join(str(len(of)) for of in models), "|")
    print("|---|---:|---:|---:|")
    for name in sorted(rows):
        values = [statistics.median(rows[name][size]) for size in range(len(models))]
        print(f"| {name} |", " | ".join(f"{x:.3g}" for x in values), "|")


main()
