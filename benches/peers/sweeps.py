"""The rows of the oscillators and the bars."""

import time

import numpy as np

import at_hand
from cases import BAR_STEPS, STEPS, alphas, gammas, slipgap, study

loops, opensees = at_hand.module("loops"), at_hand.module("sweeps_opensees")
# Problem, its name, steps, cases of slipgap, numba and OpenSees, additions of a step: those of the bars are for 22 modes.
SWEEPS = [
    ("oscillator", "friction oscillators", STEPS, alphas, (1_000_000, 40_000, 100), 10),
    ("bars", "pairs of bars, 10 elements", BAR_STEPS, gammas, (200_000, 4_000, 20), 4.1 * 22),
]
KERNEL = 4096  # cases
DEMANDED = 1e-9  # relative difference of a metric


def of(problem, module, name):
    """The sweep of a problem by a module; `None` without it."""
    return module and getattr(module, f"{name}_{problem}")


def row(own, program, turns, part, rates):
    problem, name, steps, values, counts, additions = own
    count, *few = (max(count // part, 2) for count in counts)
    found = {"problem": name, "cases": count, "steps": steps, "floor": additions / rates["additions"]}
    for column, sweep, own_count in zip(("numba", "OpenSees"), (of(problem, loops, "numba"), of(problem, opensees, "opensees")), few):
        if sweep is None:
            continue
        x = values(own_count)
        # The first call compiles, and shows that both compute the same. Newton's iteration fails in some cases.
        apart = np.abs(sweep(x) / slipgap(program.folder / "slipgap", problem, own_count, csv_wanted=True)[1] - 1)
        assert np.nanmax(apart) < DEMANDED, (name, column, np.nanmax(apart))
        found[column] = min(timed(sweep, x) for _ in range(turns)) / own_count / steps * 1e9
    runs = [program.run(study(problem, count), None, "--format", "parquet") for _ in range(turns)]
    found["whole"] = min(seconds for seconds, *_ in runs) / count / steps * 1e9
    found["MB"] = max(memory for _, memory, _ in runs)
    found["kernel"] = min(program.kernel(study(problem, KERNEL)) for _ in range(turns)) / KERNEL / steps * 1e9
    return found


def timed(sweep, x):
    start = time.perf_counter()
    sweep(x)
    return time.perf_counter() - start


def rows(program, turns, part, rates):
    return [row(own, program, turns, part, rates) for own in SWEEPS]
