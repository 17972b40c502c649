"""Writes the studies of programs, and the claims about them, without engines that cannot be had here.

    python3 programs.py FOLDER [ID...]

FOLDER gets studies/programs, and claims.json without the claims that are named.
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
        print(f"skipped, since it cannot be had: {module} ({why})", flush=True)
        return False
    return True


ROOT = pathlib.Path(__file__).resolve().parent.parent
STUDIES, CLAIMS = ROOT / "studies/programs", ROOT / "claims/programs.json"
MISSING = {word for word, module in MODULES.items() if not can_be_had(module)}


def is_here(method):
    return method.split("-")[0] not in MISSING


def without(values, folder):
    """A part of a study without the methods that are missing. Paths are those from the folder of the study."""
    if isinstance(values, list):
        return [without(value, folder) for value in values if not isinstance(value, str) or is_here(value)]
    if isinstance(values, dict):
        return {key: without(value, folder) for key, value in values.items() if is_here(key)}
    if isinstance(values, str) and values.startswith("../"):
        return str((folder / values).resolve())
    return values


def studies(written):
    written.mkdir(parents=True, exist_ok=True)
    for path in sorted(STUDIES.glob("*.json")):
        study = without(json.loads(path.read_text()), path.parent)
        if not study["parameters"]["method"]:
            print(f"skipped, since no engine of it can be had: {path.name}", flush=True)
            continue
        study["figures"] = [figure for figure in study["figures"] if figure.get("where", {}).get("method") != []]
        (written / path.name).write_text(json.dumps(study, indent=2))


def claims(written, left_out):
    ledger = json.loads(CLAIMS.read_text())
    judged = []
    for claim in ledger["claims"]:
        here = lambda reading: all(is_here(limit["where"]["method"]) for limit in reading["expect"])
        claim["readings"] = [reading for reading in claim["readings"] if here(reading)]
        if claim["readings"] and claim["id"] not in left_out:
            judged.append(claim)
    written.write_text(json.dumps(ledger | {"claims": judged, "studies": "studies/programs"}))


folder, *left_out = sys.argv[1:]
studies(pathlib.Path(folder, "studies/programs"))
claims(pathlib.Path(folder, "claims.json"), left_out)
