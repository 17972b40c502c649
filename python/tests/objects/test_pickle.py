"""What is pickled is equal afterwards, with everything it could be asked for."""

import pickle
from pathlib import Path
from typing import Any

import joblib
import numpy
import polars
import pyarrow
import pytest

import slipgap
from slipgap import Study

STUDY = Study(
    problem="friction-oscillator",
    parameters={"law": "velocity-control", "beta": [0.5, 2], "x0": [5, 9], "dT": 0.5, "duration": 10},
    checks=[{"metric": "rms_error", "max": 0.04}],
    figures=[{"name": "error", "kind": "metric", "x": "beta", "y": "rms_error", "by": "x0"}],
    reductions=["greatest rms_error over x0"],
)


def again(thing: Any) -> Any:
    return pickle.loads(pickle.dumps(thing))


@pytest.mark.parametrize("in_folder", [False, True])
def test_results(in_folder: bool, tmp_path: Path) -> None:
    results = STUDY.run(out=tmp_path if in_folder else None)
    other = again(again(results))
    assert isinstance(other, slipgap.Results) and repr(other) == repr(results)
    for name in ("table", "tables", "checks", "failures", "warnings", "parameters", "metrics", "manifest", "folder", "study"):
        assert getattr(other, name) == getattr(results, name), name
    figure = other.figures["error"]
    assert figure.name == "error" and figure.svg == results.figures["error"].svg
    assert (figure.png, figure.pdf) == (results.figures["error"].png, results.figures["error"].pdf)
    figure.save(tmp_path / "again.png")
    assert (tmp_path / "again.png").read_bytes() == figure.png
    # A case is solved again from the study.
    assert other.solution(3).table == results.solution(3).table
    assert other._repr_html_() == results._repr_html_()


def test_a_table_goes_to_other_libraries_afterwards() -> None:
    results = STUDY.run()
    table = again(results.table)
    assert table == results.table and table != results.tables["reductions"] and table != 3
    assert polars.DataFrame(table).equals(polars.DataFrame(results.table))
    assert pyarrow.table(table).schema.field("dT").metadata == pyarrow.table(results.table).schema.field("dT").metadata
    assert not table["beta"].flags.writeable
    # Null stays null.
    alone = again(Study(problem="friction-oscillator", blocks=[{"parameters": {"law": law, name: 1, "dT": 0.5, "duration": 5}} for law, name in [("displacement-control", "alpha"), ("velocity-control", "beta")]]).run().table)
    assert polars.DataFrame(alone)["alpha"].to_list() == [1.0, None]


def test_tables_of_columns() -> None:
    table = slipgap.Table({"n": numpy.array([1, 2]), "x": [None, "b"]}, {"n": "m"})
    assert table.to_polars().to_dicts() == [{"n": 1, "x": None}, {"n": 2, "x": "b"}]
    assert table.units == {"n": "m"} and len(table) == 2 and polars.DataFrame(table)["n"].dtype == polars.Int64
    with pytest.raises(slipgap.SlipgapError, match="columns"):
        slipgap.Table({"n": numpy.array([1, 2]), "x": ["b"]}).to_polars()


def test_solutions() -> None:
    model = {"problem": "friction-oscillator", "law": "displacement-control", "alpha": 0.1, "dT": 0.3, "duration": 25}
    for solution in (slipgap.solve(model), STUDY.solve(2)):
        other = again(again(solution))
        assert repr(other) == repr(solution) and other.table == solution.table
        for name in ("case_number", "metrics", "parameters", "units", "problem"):
            assert getattr(other, name) == getattr(solution, name), name
        for part in ("channels", "references", "measured"):
            assert list(getattr(other, part)) == list(getattr(solution, part))
        assert not other.time.flags.writeable


def test_animations() -> None:
    animation = slipgap.animate(STUDY)
    other = again(animation)
    assert other.html == animation.html and repr(other) == repr(animation)


def error_of(study: Study, beta: float) -> slipgap.Results:
    return study.with_(beta=beta).run(jobs=1)


def test_joblib_runs_studies_in_other_processes() -> None:
    betas = [0.5, 1, 2]
    found = joblib.Parallel(n_jobs=2)(joblib.delayed(error_of)(STUDY, beta) for beta in betas)
    for beta, results in zip(betas, found, strict=True):
        assert results.table == STUDY.with_(beta=beta).run().table
    assert joblib.hash(STUDY) == joblib.hash(Study(STUDY)) != joblib.hash(STUDY.with_(beta=1))
