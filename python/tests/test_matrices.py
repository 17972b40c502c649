"""Matrices of other programs as objects of SciPy."""

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
    own = slipgap.solve(study({"matrices": {"t": model}}, "t.2.x")).metrics
    # The same structure with another order of elimination.
    assert list(own.values()) == pytest.approx(list(expected.values()), rel=1e-12, abs=0)


def test_a_matrix_that_does_not_fit_is_a_fault() -> None:
    model = {"M": sparse.eye_array(2), "K": sparse.eye_array(3), "dofs": [("1", "x"), ("2", "x")]}
    with pytest.raises(slipgap.SlipgapError, match="3 rows"):
        slipgap.solve(study({"matrices": {"t": model}}, "t.2.x"))
