"""Prints one table: time for each step and case by each program, over slipgap's, and how far the results lie apart."""

import json
import pathlib
import statistics
import sys
import time

import numpy as np

import at_hand
import loops
from cases import BAR_STEPS, N, STEPS, alphas, gammas, slipgap

MODES = 2 * (N + 1)
PEERS = [
    ("numba loop", loops.numba_oscillator, loops.numba_bars, 20_000, 2_000),
    ("numpy loop", loops.numpy_oscillator, loops.numpy_bars, 500, 50),
]
if opensees := at_hand.opensees("opensees"):
    PEERS.append(("OpenSees", opensees.opensees_oscillator, opensees.opensees_bars, 100, 20))
CASES = 200_000
TURNS = 5


def kernel(root, name):
    """Median of criterion's last measurement, in ns for the 4096 cases of a benchmark."""
    file = root / "target" / "criterion" / "sweep" / "metrics" / name / "new" / "estimates.json"
    return json.loads(file.read_text())["median"]["point_estimate"] / 4096


def main():
    root = pathlib.Path(sys.argv[1])
    program = root / "target" / "release" / "slipgap"
    for problem, per, values, bench, unit in [
        ("oscillator", STEPS, alphas, "displacement-control 80", "step and case"),
        ("bars", BAR_STEPS * MODES, gammas, "bars 10", "step and mode"),
    ]:
        # Times of all programs in turn, so that a slow moment of the machine meets them alike.
        times = {name: [] for name, *_ in PEERS}
        whole, apart = [], {}
        for turn in range(TURNS):
            whole.append(slipgap(program, problem, CASES)[0] / CASES * 1e9)
            for name, oscillator, bars, many, few in PEERS:
                count = many if problem == "oscillator" else few
                sweep = oscillator if problem == "oscillator" else bars
                x = values(count)
                if turn == 0:
                    # The first call compiles, and shows whether all compute the same.
                    wanted = slipgap(program, problem, count, csv_wanted=True)[1]
                    found = sweep(x)
                    apart[name] = np.nanmax(np.abs(found / wanted - 1)), np.isnan(found).sum(), count
                start = time.perf_counter()
                sweep(x)
                times[name].append((time.perf_counter() - start) / count * 1e9)
        own = statistics.median(whole)
        rows = [("slipgap, metrics alone", kernel(root, bench), None), ("slipgap run", own, None)]
        rows += [(name, statistics.median(t), apart[name]) for name, t in times.items()]
        metric = "rms_error" if problem == "oscillator" else "peak_force"
        print(f"\n| {problem} | ns a {unit} | over `slipgap run` | {metric} differs by | not converged |")
        print("|---|---:|---:|---:|---:|")
        for name, ns, told in rows:
            far = "|" if told is None else f"{told[0]:.0e} | {told[1]} of {told[2]}"
            print(f"| {name} | {ns / per:.3g} | {ns / own:.3g} | {far} |")


main()
