"""Frames and grids of other libraries have the cells of the files of the program, and their units."""

import csv
import math
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy
import pyarrow
import pytest

import slipgap
from slipgap import Study

# The scaled stiffness k_I follows from gamma and n, and n is a whole number.
STOP: dict[str, Any] = {
    "masses": {"a": "m"},
    "springs": [{"between": ["ground", "a"], "k": "k"}],
    "contacts": {"stop": {"law": "law", "between": ["a", "ground"], "gap": "gap", "k": 1e4, "k_h": 1e4}},
    "start": {"a": {"v": 1}},
}
GRID = Study(
    problem="structure",
    title="A mass and a stop",
    parameters={
        "law": ["impact", "hertz"],
        "m": [2, 1],
        "gap": [0.02, 0.05, 0.1],
        "k": "50*m",
        "dt": 0.002,
        "duration": 1,
    },
    names={"gap": ["clear distance", "m"]},
    structure={**STOP, "units": "t, kN, m, s"},
    metrics=["peak(a)", "peak(stop.S)", "impacts(stop)"],
)


@pytest.fixture(scope="module")
def results() -> slipgap.Results:
    return GRID.run()


@pytest.fixture(scope="module")
def rows(program: str, tmp_path_factory: pytest.TempPathFactory) -> list[dict[str, str]]:
    """The rows of results.csv of the program."""
    folder = tmp_path_factory.mktemp("grid")
    GRID.save(folder / "grid.json")
    command = [program, "run", str(folder / "grid.json"), "--out", str(folder)]
    subprocess.run(command, check=True, capture_output=True)
    with (folder / "grid" / "results.csv").open(newline="") as file:
        return list(csv.DictReader(file))


def test_a_table_is_a_mapping(results: slipgap.Results) -> None:
    table = results.table
    assert table.keys() == table.columns == list(dict(table))
    assert len(table) == 12 and "gap" in table and "gapp" not in table
    for (name, column), again, other in zip(table.items(), table.values(), dict(table).values(), strict=True):
        assert numpy.array_equal(column, again) and numpy.array_equal(column, table[name]) and len(other) == 12
    with pytest.raises(KeyError, match=r"no column peak\(stop.s\); did you mean peak\(stop.S\)\?"):
        table["peak(stop.s)"]
    with pytest.raises(slipgap.UnknownNameError, match="no column zzz; there are case, law"):
        table["zzz"]


def test_arrays_cannot_be_written(results: slipgap.Results) -> None:
    column = results.table["gap"]
    assert not column.flags.writeable and results.table["gap"] is column
    with pytest.raises(ValueError, match="read-only"):
        column[0] = 1
    # Names are an array, too, and select rows.
    names = results.table["law"]
    assert not names.flags.writeable and names.dtype == object
    assert len(results.table["gap"][names == "hertz"]) == 6
    solution = results.solution(0)
    for part in (solution.channels, solution.references, solution.measured):
        assert not any(array.flags.writeable for array in part.values())
    assert not solution.time.flags.writeable and solution.time is solution.channels["t"]
    with pytest.raises(TypeError):
        solution.channels["a.u"] = solution.time  # type: ignore[index]
    solution.metrics["peak(a)"] = 0
    assert solution.metrics["peak(a)"] == results.table["peak(a)"][0]


def test_units_are_those_of_the_study(results: slipgap.Results) -> None:
    units = results.table.units
    assert units["gap"] == "m" and units["dt"] == units["duration"] == "s"
    assert units["peak(a)"] == "m" and units["peak(stop.S)"] == "kN" and units["impacts(stop)"] == "1"
    # A parameter has the unit of the key of the structure that it is the value of.
    assert units["k"] == "kN/m" and units["m"] == "t" and "law" not in units
    solution = results.solution(0)
    assert (solution.units["t"], solution.units["a.v"], solution.units["stop.S"]) == ("s", "m/s", "kN")
    assert pyarrow.table(results.table).schema.field("peak(a)").metadata == {b"units": b"m"}
    scaled = slipgap.run({"problem": "bar-impact", "parameters": {"gamma": 1, "n": 2, "dt": 0.25, "duration": 2}})
    assert scaled.solution(0).units == {"t": "T_I", "r": "c T_I/2", "rdot": "c", "force": "F0"}
    without = slipgap.run(GRID.replace(structure=STOP, names=None))
    assert set(without.table.units) == set()


def test_frames_have_the_cells_of_the_file(results: slipgap.Results, rows: list[dict[str, str]]) -> None:
    pandas, polars = results.to_pandas(), results.to_polars()
    assert list(pandas.columns) == polars.columns == list(rows[0]) == results.table.columns
    assert pandas.attrs["units"] == results.table.units
    for name in rows[0]:
        cells = [row[name] if name == "law" else float(row[name] or "nan") for row in rows]
        assert numpy.array_equal(cells, list(pandas[name]), equal_nan=name != "law")
        plain = [math.nan if cell is None else cell for cell in polars[name].to_list()]
        assert numpy.array_equal(cells, plain, equal_nan=name != "law")


def test_a_grid_has_the_cells_of_the_file(results: slipgap.Results, rows: list[dict[str, str]]) -> None:
    grid = results.to_xarray()
    assert dict(grid.sizes) == {"law": 2, "m": 2, "gap": 3} and set(grid.data_vars) == set(results.metrics)
    # Numbers rise, names are as they come.
    assert grid["m"].values.tolist() == [1, 2] and grid["law"].values.tolist() == ["impact", "hertz"]
    assert grid["k"].dims == ("m",) and grid["k"].values.tolist() == [50, 100]
    assert grid["dt"].dims == () and float(grid["dt"]) == 0.002
    assert grid["gap"].attrs == {"units": "m"} and grid["peak(stop.S)"].attrs == {"units": "kN"}
    assert grid.attrs == {"study": "study", "title": "A mass and a stop"}
    for row in rows:
        cell = grid.sel(law=row["law"], m=float(row["m"]), gap=float(row["gap"]))
        assert int(cell["case"]) == int(row["case"]) and float(cell["k"]) == float(row["k"])
        for name in results.metrics:
            assert numpy.array_equal(float(cell[name]), float(row[name] or "nan"), equal_nan=True)


def test_places_without_a_case_are_empty() -> None:
    parameters = {"law": "velocity-control", "duration": 5}
    blocks = [
        {"parameters": {**parameters, "beta": [1, 2], "dT": [0.25, 0.5]}},
        {"parameters": {**parameters, "beta": 3, "dT": 0.5}},
    ]
    results = Study(problem="friction-oscillator", blocks=blocks).run()
    grid = results.to_xarray()
    assert dict(grid.sizes) == {"beta": 3, "dT": 2}
    assert grid["case"].values.tolist() == [[0, 1], [2, 3], [-1, 4]]
    assert math.isnan(grid["rms_error"].values[2, 0])
    assert grid["rms_error"].values[2, 1] == results.table["rms_error"][4]


def test_cases_that_are_no_grid_are_in_a_row() -> None:
    laws = [
        {"parameters": {"law": "displacement-control", "alpha": [0.1, 1], "dT": 0.5, "duration": 5}},
        {"parameters": {"law": "velocity-control", "beta": 0.5, "dT": 0.5, "duration": 5}},
    ]
    results = Study(problem="friction-oscillator", blocks=laws).run()
    grid = results.to_xarray()
    assert dict(grid.sizes) == {"case": 3} and grid["law"].dims == ("case",)
    assert grid["alpha"].values.tolist()[:2] == [0.1, 1] and math.isnan(grid["alpha"].values[2])
    assert grid["rms_error"].values.tolist() == results.table["rms_error"].tolist()
    one = slipgap.run({"problem": "friction-oscillator", "parameters": laws[1]["parameters"]}).to_xarray()
    assert dict(one.sizes) == {"case": 1} and float(one["beta"]) == 0.5 and "alpha" not in one


def test_a_motion_has_the_columns_of_a_history(program: str, tmp_path: Path) -> None:
    parameters = {"law": "displacement-control", "alpha": 0.1, "dT": "pi/10", "duration": "8*pi"}
    study = Study(problem="friction-oscillator", parameters=parameters).save(tmp_path / "s.json")
    command = [program, "run", str(tmp_path / "s.json"), "--histories", "--out", str(tmp_path)]
    subprocess.run(command, check=True, capture_output=True)
    [history] = (tmp_path / "s" / "histories").glob("*.csv")
    with history.open(newline="") as file:
        header, *lines = csv.reader(file)
    solution = study.solve()
    assert sorted(solution.table.columns) == sorted(header)
    pandas, polars, dataset = solution.to_pandas(), solution.to_polars(), solution.to_xarray()
    assert pandas.index.name == "T" and dict(dataset.sizes) == {"T": 81} and dataset.attrs["alpha"] == 0.1
    for index, name in enumerate(header):
        cells = [float(line[index]) for line in lines]
        assert polars[name].to_list() == dataset[name].values.tolist() == cells
        assert (pandas.reset_index()[name].tolist()) == cells


def test_pandas_takes_a_table(results: slipgap.Results) -> None:
    pandas = pytest.importorskip("pandas")
    for table in (results.table, *results.tables.values(), results.solution(0).table):
        if len(table):
            # The columns go to pandas in two ways, by rows and by arrays.
            pandas.testing.assert_frame_equal(pandas.DataFrame(table), table.to_pandas())
            assert pandas.DataFrame(dict(table)).columns.tolist() == table.columns
    some = pandas.DataFrame(results.table, columns=["rms_error", "gap"])
    assert some["gap"].tolist() == results.table["gap"].tolist() and list(some) == ["rms_error", "gap"]


def test_a_table_has_rows(results: slipgap.Results, tmp_path: Path) -> None:
    results.study.run(out=tmp_path)
    rows = list(results.table)
    assert len(rows) == len(results.table) == 12 and "gap" in results.table
    with next(tmp_path.glob("*/results.csv")).open(newline="") as file:
        for row, line in zip(rows, csv.DictReader(file), strict=True):
            assert list(row) == list(line)
            for name, text in line.items():
                cell = row[name]
                assert (cell or "") == text if cell is None or isinstance(cell, str) else repr(float(text or "nan")) == repr(float(cell))


@pytest.mark.parametrize("name", ["pandas", "polars", "xarray"])
def test_without_a_library_an_error_says_so(name: str, results: slipgap.Results, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, name, None)
    for thing in (results, results.solution(0)):
        with pytest.raises(ImportError, match=f"to_{name} needs {name}: pip install {name}"):
            getattr(thing, f"to_{name}")()
