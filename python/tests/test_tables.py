"""The tables over groups of cases are the files of the program, with and without a folder."""

import csv
from pathlib import Path
from typing import Any

import pytest

import slipgap

OSCILLATOR: dict[str, Any] = {"law": "velocity-control", "dT": 0.5, "duration": 10}

ENSEMBLE: dict[str, Any] = {
    "problem": "friction-oscillator",
    "parameters": {**OSCILLATOR, "beta": [0.5, 2], "x0": [5, 7, 9, 11, 13, 15]},
    "ensemble": "x0",
    "reductions": ["greatest rms_error over x0"],
}

DESIGN: dict[str, Any] = {
    "problem": "friction-oscillator",
    "parameters": {**OSCILLATOR, "beta": {"uniform": [0.5, 2]}, "x0": {"uniform": [5, 15]}},
    "design": {"kind": "saltelli", "n": 32},
}

FILES = {
    "quantiles": ENSEMBLE,
    "two_samples": ENSEMBLE,
    "reductions": ENSEMBLE,
    "sobol": DESIGN,
}


@pytest.mark.parametrize("name", FILES)
def test_a_table_has_every_cell_of_the_file(name: str, tmp_path: Path) -> None:
    in_memory = slipgap.run(FILES[name]).tables[name]
    in_folder = slipgap.run(FILES[name], out=tmp_path).tables[name]
    with (tmp_path / "study" / f"{name}.csv").open(newline="") as file:
        header, *rows = csv.reader(file)
    assert rows
    for table in (in_memory, in_folder):
        assert table.columns == header
        for index, column in enumerate(header):
            for cell, value in zip((row[index] for row in rows), table[column], strict=True):
                if isinstance(value, str) or value is None:
                    assert (value or "") == cell
                elif cell == "":
                    assert value != value
                else:
                    assert float(cell) == value


def test_only_the_tables_of_the_study_are_there() -> None:
    plain = {"problem": "friction-oscillator", "parameters": {**OSCILLATOR, "beta": 1}}
    assert set(slipgap.run(plain).tables) == {"warnings"}
    assert set(slipgap.run(ENSEMBLE).tables) == {*FILES, "warnings"} - {"sobol"}
    assert set(slipgap.run(DESIGN).tables) == {"sobol", "warnings"}


def test_warnings_are_a_table() -> None:
    polars = pytest.importorskip("polars")
    # Bars without a gap touch for T_I and a little longer, that is until the end.
    bars = {
        "problem": "bar-impact",
        "parameters": {
            "gamma": 1, "n": 2, "dt": 0.25, "gap": [0, 2, 3], "duration": 1, "L": 10, "E": 100, "V0": 0.1,
        },
    }
    with pytest.warns(slipgap.SlipgapWarning):
        results = slipgap.run(bars)
    frame = polars.DataFrame(results.tables["warnings"])
    row = frame.filter(kind="ends-in-contact").row(0, named=True)
    assert (row["cases"], row["of"], row["case"]) == (1, 3, 0)
    assert row["message"] in {warned.message for warned in results.warnings}
    assert len(slipgap.run(ENSEMBLE).tables["warnings"]) == 0
