"""pandas, polars, pyarrow and DuckDB read the table, and do not copy it."""

from typing import Any

import numpy
import pytest

import slipgap

STUDY: dict[str, Any] = {
    "problem": "friction-oscillator",
    "blocks": [
        {"parameters": {"law": "displacement-control", "alpha": [0.1, 1.0], "dT": [0.1, 0.2], "duration": 25}},
        {"parameters": {"law": "velocity-control", "beta": 0.5, "dT": [0.1, 0.2], "duration": 25}},
    ],
}


@pytest.fixture(scope="module")
def table() -> slipgap.Table:
    return slipgap.run(STUDY).table


def test_columns_without_a_library(table: slipgap.Table) -> None:
    assert len(table) == 6 and table.columns[:4] == ["case", "law", "alpha", "beta"]
    assert table["case"].tolist() == list(range(6)) and table["case"].dtype == numpy.int64
    assert table["law"].tolist() == ["displacement-control"] * 4 + ["velocity-control"] * 2
    assert numpy.isnan(table["beta"][:4]).all() and table["beta"][4:].tolist() == [0.5, 0.5]
    with pytest.raises(KeyError):
        table["gamma"]


def test_polars(table: slipgap.Table) -> None:
    polars = pytest.importorskip("polars")
    frame = polars.DataFrame(table)
    assert frame.columns == table.columns and frame.height == 6
    assert frame["law"].dtype == polars.String and frame["case"].dtype == polars.Int64
    assert frame["beta"].null_count() == 4 and frame["alpha"].null_count() == 2
    assert frame["rms_error"].to_list() == table["rms_error"].tolist()


def test_pyarrow(table: slipgap.Table) -> None:
    pyarrow = pytest.importorskip("pyarrow")
    rows = pyarrow.table(table)
    assert rows.column_names == table.columns and rows.num_rows == 6
    assert rows["beta"].null_count == 4
    assert pyarrow.schema(table) == rows.schema
    # The same memory, however often it is taken.
    address = [pyarrow.table(table)["rms_error"].chunk(0).buffers()[1].address for _ in range(2)]
    assert address[0] == address[1] == rows["rms_error"].chunk(0).buffers()[1].address


def test_rows_outlive_the_table() -> None:
    pyarrow = pytest.importorskip("pyarrow")
    expected = slipgap.run(STUDY).table["rms_error"].tolist()
    rows = pyarrow.table(slipgap.run(STUDY).table)
    slipgap.run(STUDY)
    assert rows["rms_error"].to_pylist() == expected


def test_pandas(table: slipgap.Table) -> None:
    pandas = pytest.importorskip("pandas")
    if not hasattr(pandas.DataFrame, "from_arrow"):
        pytest.skip("pandas before 3 does not read Arrow by itself")
    frame = pandas.DataFrame.from_arrow(table)
    assert list(frame.columns) == table.columns and len(frame) == 6
    assert frame["rms_error"].tolist() == table["rms_error"].tolist()


def test_duckdb(table: slipgap.Table) -> None:
    duckdb = pytest.importorskip("duckdb")
    table_ = table
    rows = duckdb.sql("select law, count(*) from table_ group by law order by law").fetchall()
    assert rows == [("displacement-control", 4), ("velocity-control", 2)]
    assert len(table_) == 6


def test_a_capsule_that_nobody_takes_is_freed(table: slipgap.Table) -> None:
    for _ in range(1000):
        table.__arrow_c_stream__()
        table.__arrow_c_schema__()
