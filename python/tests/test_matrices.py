"""Matrices of other programs as objects of SciPy."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import slipgap

sparse = pytest.importorskip("scipy.sparse")


def study(matrices: dict[str, Any], node: str) -> dict[str, Any]:
    return {
        "problem": "structure",
        "parameters": {"dt": 0.01, "duration": 3},
        "structure": {
            **matrices,
            "contacts": {"stop": {"law": "impact", "between": [node, "ground"], "gap": 0.05, "k": 1e3}},
            "ground": {"sine": {"amplitude": 1, "omega": 5}},
        },
        "metrics": [f"peak({node})", "peak(stop.S)"],
    }


def test_sparse_matrices_give_what_masses_and_springs_give() -> None:
    masses = {
        "masses": {"a": 2, "b": 1},
        "springs": [{"between": ["ground", "a"], "k": 100}, {"between": ["a", "b"], "k": 70}],
    }
    K = sparse.csr_array(np.array([[170.0, -70.0], [-70.0, 70.0]]))
    model = {"M": sparse.diags_array([2.0, 1.0]), "K": K, "dofs": [("1", "x"), ("2", "x")]}
    expected = slipgap.solve(study(masses, "b")).metrics
    metrics = slipgap.solve(study({"matrices": {"t": model}}, "t.2.x")).metrics
    # The same structure with another order of elimination.
    assert list(metrics.values()) == pytest.approx(list(expected.values()), rel=1e-12, abs=0)


def test_arrays_are_matrices_and_motions() -> None:
    K = np.array([[170.0, -70.0], [-70.0, 70.0]])
    model = {"M": np.diag([2.0, 1.0]), "K": K, "dofs": np.array([("1", "x"), ("2", "x")])}
    arrays = study({"matrices": {"t": model}}, "t.2.x")
    same = {"M": sparse.csr_array(model["M"]), "K": sparse.csr_array(K), "dofs": [["1", "x"], ["2", "x"]]}
    assert slipgap.solve(arrays).metrics == slipgap.solve(study({"matrices": {"t": same}}, "t.2.x")).metrics
    t = np.linspace(0, 3, 301)
    arrays["structure"]["ground"] = {"table": {"t": t, "f": np.sin(5 * t)}}
    listed = slipgap.solve({**arrays, "structure": {**arrays["structure"], "ground": {"table": {"t": t.tolist(), "f": np.sin(5 * t).tolist()}}}})
    assert slipgap.solve(arrays).metrics == listed.metrics
    assert listed.channels["ground"] == pytest.approx(np.sin(5 * t), abs=1e-12)


def test_a_measurement_of_arrays_is_that_of_a_file(tmp_path: Path) -> None:
    t = np.linspace(0, 1, 21)
    rows = "\n".join(f"{x!r},{y!r}" for x, y in zip(t.tolist(), np.sin(4 * t).tolist(), strict=True))
    (tmp_path / "test.csv").write_text(f"t,u\n{rows}\n")
    given = {
        "problem": "structure",
        "parameters": {"dt": 0.01, "duration": 1},
        "structure": {
            "masses": {"a": 1}, "springs": [{"between": ["ground", "a"], "k": 16}], "start": {"a": {"v": 4}},
        },
        "metrics": ["rms_error(a, measured)"],
    }  # fmt: skip
    of_file = {**given, "measured": {"file": str(tmp_path / "test.csv"), "time": "t", "columns": {"a": "u"}}}
    of_arrays = slipgap.Study(given, measured={"time": t, "columns": {"a": np.sin(4 * t)}})
    expected = slipgap.solve(of_file)
    assert slipgap.solve(of_arrays).metrics == expected.metrics
    assert slipgap.run(dict(given, measured={"time": t, "columns": {"a": np.sin(4 * t)}})).table["rms_error(a, measured)"] == expected.metrics["rms_error(a, measured)"]
    assert np.array_equal(of_arrays.solve().measured["a"], expected.measured["a"], equal_nan=True)
    # A saved study has a file of its own beside it.
    saved = of_arrays.save(tmp_path / "saved.json")
    assert saved["measured"]["file"].startswith("saved-measured-") and (tmp_path / saved["measured"]["file"]).exists()
    assert saved.solve().metrics == expected.metrics


def test_a_matrix_that_does_not_fit_is_a_fault() -> None:
    model = {"M": sparse.eye_array(2), "K": sparse.eye_array(3), "dofs": [("1", "x"), ("2", "x")]}
    with pytest.raises(slipgap.SlipgapError, match="3 rows"):
        slipgap.solve(study({"matrices": {"t": model}}, "t.2.x"))
