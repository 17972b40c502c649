"""The two sweeps that all programs run, and what they must find."""

import csv
import json
import math
import pathlib
import subprocess
import tempfile
import time

import numpy as np

# [F] Fig. 5: released at x0 = 12, dT = pi/10, 80 steps; alpha is swept.
X0, DT, STEPS = 12.0, math.pi / 10, 80
# [I] Fig. 3 in its own scales: n = 10 elements a bar, 300 steps to 1.5 T_I; gamma is swept.
N, BAR_DT, BAR_STEPS = 10, 0.005, 300


def alphas(count):
    return np.geomspace(0.01, 10.0, count)


def gammas(count):
    return np.geomspace(0.1, 10.0, count)


def study(problem, count, n=N):
    if problem == "oscillator":
        parameters = {
            "law": "displacement-control", "x0": X0, "dT": "pi/10", "duration": "8*pi",
            "alpha": {"geomspace": [0.01, 10, count]},
        }
        return {"problem": "friction-oscillator", "parameters": parameters}
    parameters = {
        "n": n, "dt": BAR_DT, "duration": 1.5, "gamma": {"geomspace": [0.1, 10, count]},
    }
    return {"problem": "bar-impact", "parameters": parameters}


def exact_oscillator():
    """Coulomb friction from x0 = 12: half-cycles about +1 and -1, at rest at 0 from T = 6 pi on."""
    t = np.arange(STEPS + 1) * DT
    k = np.minimum(np.floor(t / math.pi + 1e-9), 6)
    side = np.where(k % 2 == 0, 1.0, -1.0)
    return np.where(k < 6, side * (1 + (X0 - 2 * k - 1) * np.cos(t - k * math.pi)), 0.0)


def slipgap(program, problem, count, csv_wanted=False):
    """Seconds of a whole run on one thread, and a column of its results if wanted."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        file = folder / "sweep.json"
        file.write_text(json.dumps(study(problem, count)))
        form = ["--format", "csv" if csv_wanted else "parquet"]
        start = time.perf_counter()
        subprocess.run(
            [program, "run", file, "--out", folder, "--jobs", "1", *form],
            check=True, capture_output=True,
        )
        seconds = time.perf_counter() - start
        if not csv_wanted:
            return seconds, None
        metric = "rms_error" if problem == "oscillator" else "peak_force"
        with open(folder / "sweep" / "results.csv") as table:
            return seconds, np.array([float(row[metric]) for row in csv.DictReader(table)])
