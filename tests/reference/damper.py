"""Writes test.csv and damper.json, the study of docs/calibrate.md, from a file of the friction damper's data set.

Run:  python3 damper.py 0.5Hz30lbtension1amplitude.json     (needs nothing; the file is in data/dataset-2/characterization datasets)

The data set is github.com/ARTS-Laboratory/Dataset-Friction-Damper-with-Backlash (Coble, Huggins, Cao, Ricles and Downey 2022) under
CC BY-SA 4.0, which then holds for both files written. Its columns are time in s, displacement in inches and force in kip, 1024 rows a
second. Every 8th row is measured, every 16th displacement moves the damper; both begin at 0.
"""

import json
import sys

LAWS = ["displacement-control", "bilinear", "bouc-wen", "stribeck", "lugre"]


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        rows = json.load(file)["data"][::8]
    start = rows[0][1]
    with open("test.csv", "w", encoding="utf-8") as out:
        out.write("t_s,u_in,force_kip\n")
        out.writelines(f"{row[0]:.7f},{row[1] - start:.5f},{row[2]:.5f}\n" for row in rows)
    t = [float(f"{row[0]:.6g}") for row in rows[::2]]
    u = [float(f"{0.0254 * (row[1] - start):.6g}") for row in rows[::2]]
    study = {
        "title": "Banded rotary friction damper",
        "problem": "structure",
        "parameters": {
            "law": LAWS, "k": 2000, "limit": 10, "exponent": 1, "ratio": 0.01, "c": 1000, "static_ratio": 1.1, "velocity": 0.01,
            "sigma1": 10, "sigma2": 1, "dt": 1 / 256, "duration": t[-1] - 0.01,
        },
        "structure": {
            "units": "t, kN, m, s",
            "masses": {"idle": 1},
            "springs": [{"between": ["ground", "idle"], "k": 1}],
            "supports": {"ram": {"displacement": {"t": t, "u": u}}},
            "contacts": {
                "damper": {
                    "law": "law", "between": ["ground", "ram"], "k": "k", "limit": "limit", "exponent": "exponent", "k1": "k",
                    "Fy": "limit", "ratio": "ratio", "sigma0": "k", "sigma1": "sigma1", "sigma2": "sigma2", "c": "c",
                    "static_ratio": "static_ratio", "stribeck_velocity": "velocity",
                }
            },
        },
        "measured": {
            "file": "test.csv",
            "time": "t_s",
            "columns": {
                "damper.S": {"column": "force_kip", "unit": "kip"},
                "damper.r": {"column": "u_in", "unit": "in"},
            },
        },
        "calibrate": {
            "k": {"log": [100, 1e5]}, "limit": [4, 16], "exponent": [1, 5], "ratio": [0, 0.2], "c": {"log": [10, 1e5]},
            "static_ratio": [1, 2], "velocity": {"log": [1e-3, 0.1]}, "sigma1": {"log": [1, 1e3]}, "sigma2": [0, 50],
            "minimise": "rms_error(damper.S, measured)",
        },
        "metrics": ["rms_error(damper.S, measured)", "loop_distance(damper.r, damper.S, measured)", "step_error(damper.S)"],
        "figures": [{"name": "loop", "kind": "curve", "x": "damper.r", "y": "damper.S", "by": "law"}],
    }
    with open("damper.json", "w", encoding="utf-8") as out:
        json.dump(study, out, indent=1)


if __name__ == "__main__":
    main()
