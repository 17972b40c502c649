"""Writes the claims about programs that can be judged here: without readings of engines that cannot be had, and without these claims.

    python3 programs.py LEDGER WRITTEN [CLAIM...]
"""
import importlib
import json
import pathlib
import sys

# The methods of studies/programs begin with these words.
MODULES = {
    "events": "scipy",
    "opensees": "openseespy.opensees",
    "exudyn": "exudyn",
    "mujoco": "mujoco",
    "pybullet": "pybullet",
    "drake": "pydrake.all",
}


def can_be_had(module):
    try:
        importlib.import_module(module)
    except Exception as why:
        print(f"not judged, since it cannot be had: {module} ({why})", flush=True)
        return False
    return True


given, written, *left_out = sys.argv[1:]
path = pathlib.Path(given).resolve()
ledger = json.loads(path.read_text())
had = {word for word, module in MODULES.items() if can_be_had(module)}
judged = []
for claim in ledger["claims"]:
    methods = lambda reading: {limit["where"]["method"].split("-")[0] for limit in reading["expect"]}
    claim["readings"] = [reading for reading in claim["readings"] if methods(reading) <= had]
    if claim["readings"] and claim["id"] not in left_out:
        judged.append(claim)
ledger |= {"claims": judged, "studies": str(path.parent / ledger["studies"])}
pathlib.Path(written).write_text(json.dumps(ledger))
