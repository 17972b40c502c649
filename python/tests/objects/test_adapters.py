"""The programs of examples/programs, against the exact motion and the product's own steps."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import pytest
import slipgap

FOLDER = Path(__file__).parents[3] / "examples" / "programs"


def table(folder: Path, program: str, study: dict[str, Any]) -> Any:
    """The results of a study with a program of the folder as the method `other`."""
    command = [sys.executable, str(FOLDER / f"{program}.py")]
    text = {"problem": "structure", "programs": {"other": {"command": command}}, **study}
    path = folder / "s.json"
    path.write_text(json.dumps(text))
    return slipgap.run(path, allow_programs=True).table


def release(method: list[str]) -> dict[str, Any]:
    """The shipped study, with one step: it comes to rest after three cycles."""
    study = json.loads((FOLDER / "release.json").read_text())
    return {
        "parameters": {"method": method, "dt": 0.05, "duration": 20},
        "structure": study["structure"],
        "metrics": ["rms_error(a)"],
    }


def towers(method: list[str]) -> dict[str, Any]:
    """Two towers with a gap and a load that is straight between the instants."""
    return {
        "parameters": {"method": method, "dt": 0.005, "duration": 3},
        "structure": {
            "units": "t, kN, m, s",
            "masses": {"a": 2, "b": 3},
            "springs": [{"between": ["ground", "a"], "k": 300, "c": 2}, {"between": ["a", "b"], "k": 200}],
            "contacts": {"joint": {"between": ["a", "b"], "law": "impact-spring", "k": 5000, "gap": 0.02}},
            "loads": [{"at": "b", "table": {"t": [0, 1, 2], "f": [0, 3, 0]}}],
            "start": {"b": {"v": -0.4}},
            "contacts_reference": "softened",
        },
        "metrics": ["rms_error(a)", "peak(joint.S)", "rms(b.v)"],
    }


def test_events_of_scipy_are_the_exact_motion(tmp_path: Path) -> None:
    pytest.importorskip("scipy")
    # solve_ivp keeps 1e-10 of a step; its order is 8, and all terms of a step are smooth.
    (error,) = table(tmp_path, "scipy_events", release(["other"]))["rms_error(a)"]
    assert error < 1e-11
    (error,) = table(tmp_path, "scipy_events", towers(["other"]))["rms_error(a)"]
    assert error < 1e-11


def test_opensees_has_the_steps_of_average_acceleration(tmp_path: Path) -> None:
    pytest.importorskip("openseespy.opensees")
    found = table(tmp_path, "opensees_case", towers(["average-acceleration", "other"]))
    for metric in ["peak(joint.S)", "rms(b.v)"]:
        own, other = found[metric]
        # Newton's tolerance is 1e-10 of the typical length.
        assert other == pytest.approx(own, rel=1e-8)


def test_mujoco_softens_friction(tmp_path: Path) -> None:
    pytest.importorskip("mujoco")
    study = release(["other"])
    study["parameters"]["dt"] = [0.04, 0.02, 0.01]
    errors = table(tmp_path, "mujoco_case", study)["rms_error(a)"]
    # Steps of order 1 while they are larger than the time constant of its softening.
    for coarse, fine in zip(errors, errors[1:]):
        assert 1.6 < coarse / fine < 2.4


def test_what_a_program_cannot_express_is_an_error(tmp_path: Path) -> None:
    pytest.importorskip("openseespy.opensees")
    study = towers(["other"])
    study["structure"]["contacts"]["joint"]["law"] = "hertz"
    with pytest.raises(slipgap.SlipgapError, match="hertz"):
        table(tmp_path, "opensees_case", study)
