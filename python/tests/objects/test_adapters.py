"""The programs of examples/programs, against the exact motion and the product's own steps."""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest
import slipgap

FOLDER = Path(__file__).parents[3] / "examples" / "programs"


def solved(folder: Path, program: str, study: dict[str, Any], numbers: Mapping[str, float] | None = None) -> slipgap.Results:
    """The results of a study with a program of the folder as the method `other`."""
    command = [sys.executable, str(FOLDER / f"{program}.py")]
    text = {"problem": "structure", "programs": {"other": {"command": command, "parameters": dict(numbers or {})}}, **study}
    path = folder / "s.json"
    path.write_text(json.dumps(text))
    return slipgap.run(path, allow_programs=True)


def table(folder: Path, program: str, study: dict[str, Any], numbers: Mapping[str, float] | None = None) -> Any:
    """Their table."""
    return solved(folder, program, study, numbers).table


def reason(folder: Path, program: str, study: dict[str, Any]) -> str:
    """Why the one case has no solution."""
    return solved(folder, program, study).failures[0].reason


def release(method: list[str]) -> dict[str, Any]:
    """A mass released on a surface with friction, which comes to rest after three cycles."""
    return {
        "parameters": {"method": method, "dt": 0.05, "duration": 20},
        "structure": {
            "masses": {"a": 1},
            "springs": [{"between": ["ground", "a"], "k": 1}],
            "contacts": {"rub": {"between": ["ground", "a"], "law": "coulomb", "limit": 1}},
            "start": {"a": {"u": 12}},
        },
        "metrics": ["rms_error(a)"],
    }


def turned(method: list[str]) -> dict[str, Any]:
    """A mass on springs of two directions, with friction in the plane."""
    return {
        "parameters": {"method": method, "dt": [0.02, 0.01, 0.005], "duration": 6},
        "structure": {
            "masses": {"a": {"mass": 1, "direction": ["x", "y"]}},
            "springs": [{"between": ["ground", "a"], "directions": ["x", "y"], "k": [4, 9]}],
            "contacts": {"disc": {"between": ["ground", "a"], "directions": ["x", "y"], "law": "coulomb", "limit": 0.5}},
            "start": {"a.x": {"u": 1}, "a.y": {"v": 2}},
            "contacts_reference": "rigid",
        },
        "metrics": ["rms_error(a.x)", "rms_error(a.y)", "mean(disc.S.1)"],
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


def test_opensees_has_the_friction_of_a_disc(tmp_path: Path) -> None:
    pytest.importorskip("openseespy.opensees")
    found = table(tmp_path, "opensees_case", turned(["other"]), {"stiffness": 1e5})
    # Its steps are of order 1; the spring of the section moves by 5e-6.
    for errors in (found["rms_error(a.x)"], found["rms_error(a.y)"]):
        for coarse, fine in zip(errors, errors[1:]):
            assert 1.7 < coarse / fine < 2.3
    # Two bodies on each other: the lower one is held and does not move.
    study = turned(["other"])
    study["structure"]["masses"]["b"] = {"mass": 1, "direction": ["x", "y"]}
    study["structure"]["springs"].append({"between": ["ground", "b"], "directions": ["x", "y"], "k": [1e7, 1e7]})
    study["structure"]["contacts"]["disc"]["between"] = ["b", "a"]
    pair = table(tmp_path, "opensees_case", study, {"stiffness": 1e5})
    for metric in ["rms_error(a.x)", "rms_error(a.y)"]:
        # The spring of b moves by 0.5/1e7 of 1 m.
        assert pair[metric] == pytest.approx(found[metric], abs=1e-6)


def test_mujoco_softens_friction(tmp_path: Path) -> None:
    pytest.importorskip("mujoco")
    study = release(["other"])
    study["parameters"]["dt"] = [0.04, 0.02, 0.01]
    errors = table(tmp_path, "mujoco_case", study)["rms_error(a)"]
    # Steps of order 1 while they are larger than the time constant of its softening.
    for coarse, fine in zip(errors, errors[1:]):
        assert 1.6 < coarse / fine < 2.4


def test_mujoco_has_the_friction_of_a_disc(tmp_path: Path) -> None:
    pytest.importorskip("mujoco")
    found = table(tmp_path, "mujoco_case", turned(["average-acceleration", "other"]), {"timeconst": 0.002, "impedance": 0.9999})
    errors, forces = (found[metric] for metric in ("rms_error(a.x)", "mean(disc.S.1)"))
    for coarse, fine in zip(errors[3:], errors[4:]):
        assert 1.7 < coarse / fine < 2.3
    # Its force chatters with the normal one, so that only the mean converges, with order 1 from 0.0015 on.
    for own, other in zip(forces[:3], forces[3:]):
        assert other == pytest.approx(own, abs=0.0025)


@pytest.mark.parametrize(("module", "program"), [("pybullet", "pybullet_case"), ("pydrake.all", "drake_case")])
def test_friction_of_bodies_converges_to_the_exact_motion(tmp_path: Path, module: str, program: str) -> None:
    pytest.importorskip(module)
    # Explicit forces of springs make steps of order 1; nothing is softened but by the step. In a plane the friction is a cone.
    (error,) = table(tmp_path, program, release(["other"]))["rms_error(a)"]
    assert error < 0.15
    found = table(tmp_path, program, turned(["other"]))
    for errors in (found["rms_error(a.x)"], found["rms_error(a.y)"]):
        for coarse, fine in zip(errors, errors[1:]):
            assert 1.7 < coarse / fine < 2.3
    # The exact mean is -0.0134; of steps of order 1.
    assert all(x == pytest.approx(-0.0134, abs=0.0015) for x in found["mean(disc.S.1)"])
    study = release(["other"])
    study["structure"]["masses"]["b"] = 1
    study["structure"]["contacts"]["rub"]["between"] = ["a", "b"]
    assert "no friction between bodies" in reason(tmp_path, program, study)


def test_exudyn_has_the_steps_of_the_trapezoidal_rule(tmp_path: Path) -> None:
    pytest.importorskip("exudyn")
    numbers = {"radius": 2}
    found = table(tmp_path, "exudyn_case", towers(["average-acceleration", "other"]), numbers)
    for metric in ["peak(joint.S)", "rms(b.v)"]:
        own, other = found[metric]
        # Newton ends at 1e-10 of the first residual, in each of 600 steps.
        assert other == pytest.approx(own, rel=1e-6)
    # Its proportional zone is the law velocity-control.
    study = release(["average-acceleration", "other"])
    study["parameters"]["dt"] = 0.01
    study["structure"]["contacts"]["rub"] = {"between": ["ground", "a"], "law": "velocity-control", "c": 5, "limit": 1}
    study["structure"]["contacts_reference"] = "rigid"
    own, other = table(tmp_path, "exudyn_case", study, numbers)["rms_error(a)"]
    assert other == pytest.approx(own, rel=1e-6)


@pytest.mark.parametrize(
    ("module", "program", "numbers"),
    [("exudyn", "exudyn_case", {"radius": 2}), ("openseespy.opensees", "opensees_case", {}), ("scipy", "scipy_events", {})],
)
def test_a_gap_that_static_loads_close_stays_closed(tmp_path: Path, module: str, program: str, numbers: dict[str, float]) -> None:
    pytest.importorskip(module)
    study = towers(["average-acceleration", "other"])
    structure = study["structure"]
    del structure["loads"], structure["start"]
    structure["contacts"]["joint"]["gap"] = 0
    structure["springs"][1] = {"between": ["ground", "b"], "k": 200}
    structure["static"] = {"a": 30}
    found = table(tmp_path, program, study, numbers)
    # At rest, by hand: 300 u = 30 + S and 200 w = -S with S = 5000 (w - u), so that S = -30 / (1 + 300/200 + 300/5000) = -11.71875.
    for force in found["peak(joint.S)"]:
        assert force == pytest.approx(11.71875, rel=1e-8)
    # And turned, with the nodes in another order.
    structure["contacts"]["joint"]["between"] = ["b", "a"]
    structure["masses"] = {"b": 3, "a": 2}
    structure["static"] = {"a": -30}
    for force in table(tmp_path, program, study, numbers)["peak(joint.S)"]:
        assert force == pytest.approx(11.71875, rel=1e-8)


def test_limits_that_change_are_an_error(tmp_path: Path) -> None:
    for module, program in [("scipy", "scipy_events"), ("mujoco", "mujoco_case")]:
        pytest.importorskip(module)
        study = release(["other"])
        study["structure"]["contacts"]["rub"]["static_ratio"] = 1.5
        assert "no limit of friction that changes" in reason(tmp_path, program, study)


def test_what_a_program_cannot_express_is_an_error(tmp_path: Path) -> None:
    pytest.importorskip("openseespy.opensees")
    study = towers(["other"])
    study["structure"]["contacts"]["joint"]["law"] = "hertz"
    with pytest.raises(slipgap.SlipgapError, match="hertz"):
        table(tmp_path, "opensees_case", study)
