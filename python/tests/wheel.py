"""The installed wheel works with nothing but NumPy: module, program and their versions."""

import importlib.metadata
import subprocess
import sys
import sysconfig
from pathlib import Path

import slipgap

installed = {distribution.metadata["Name"].lower() for distribution in importlib.metadata.distributions()}
assert installed <= {"slipgap", "numpy", "pip", "setuptools"}, installed
assert Path(slipgap.__file__).is_relative_to(sysconfig.get_paths()["platlib"]), slipgap.__file__
assert importlib.metadata.version("slipgap") == slipgap.__version__

parameters = {"law": "displacement-control", "alpha": 0.1, "dT": "pi/10", "duration": "8*pi"}
solution = slipgap.solve({"problem": "friction-oscillator", **parameters})
# [F] Fig. 5: 0.0245 |x0|.
error = solution.metrics["rms_error"]
assert error is not None and abs(error - 0.0245) < 5e-5
assert solution.channels["X"].shape == (81,)
figure = {"name": "history", "kind": "history"}
results = slipgap.run({"problem": "friction-oscillator", "parameters": parameters, "figures": [figure]})
assert results.table["rms_error"][0] == error
assert results.figures["history"].png.startswith(b"\x89PNG")

program = Path(sysconfig.get_path("scripts")) / "slipgap"
version = subprocess.run([program, "--version"], check=True, capture_output=True, text=True).stdout
# The commit may follow.
assert version.split()[:2] == ["slipgap", slipgap.__version__], version
print("the wheel works with Python", sys.version.split()[0])
