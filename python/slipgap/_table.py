"""Tables of results: columns as arrays, and as frames of other libraries."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from . import _slipgap
from ._errors import UnknownNameError
from ._frame.library import library
from ._show import html

if TYPE_CHECKING:
    import pandas
    import polars
    from numpy.typing import NDArray


class Table:
    """A table with the columns of a file of the program, such as results.csv with one row for each case.

    ``table["rms_error"]`` is a column without any other library: an array of shape (rows,) that cannot be written, with NaN for null;
    names are an array of str and None. ``table.columns`` are their names, ``dict(table)`` is a dict of them all. ``len(table)`` is the
    number of rows, and ``for row in table`` gives each as a dict.

    ``to_pandas`` and ``to_polars`` make frames. Other libraries take the table by the Arrow PyCapsule interface, and do not copy it:
    ``polars.DataFrame(table)``, ``pyarrow.table(table)``, ``pandas.DataFrame.from_arrow(table)`` (pandas 3) and
    ``duckdb.sql("from table")``. The metadata of a column has its unit. ``pandas.DataFrame(table)`` reads row by row: slower, and
    without the columns of a table without rows.

    In a table of cases ``case`` is a whole number, parameters are numbers, whole numbers or names, metrics are numbers. Units are
    those of docs/scope.md. A parameter that does not apply and a metric that is undefined are null.
    """

    __slots__ = ("_cells", "_columns", "_given", "_units")

    def __init__(
        self, rows: _slipgap.Table | Mapping[str, Any], units: Mapping[str, str] | None = None
    ) -> None:
        """A table of columns: arrays of numbers, or of str and None."""
        # The columns that were asked for.
        self._cells: dict[str, Any] = {}
        self._given: _slipgap.Table | None = None
        if isinstance(rows, _slipgap.Table):
            self._given, self._columns = rows, rows.columns
            known = rows.units if units is None else units
            self._units = {name: known[name] for name in self._columns if name in known}
        else:
            self._cells = {name: kept(column) for name, column in rows.items()}
            self._columns, self._units = list(rows), dict(units or {})

    @property
    def _rows(self) -> _slipgap.Table:
        if self._given is None:
            cells = {name: plain(column) for name, column in self._cells.items()}
            self._given = _slipgap.Table(cells, self._units)
        return self._given

    @property
    def columns(self) -> list[str]:
        """Names of the columns."""
        return list(self._columns)

    @property
    def units(self) -> dict[str, str]:
        """Units by column, of those whose unit is known; "1" for a number without."""
        return dict(self._units)

    def __len__(self) -> int:
        if self._given is None:
            return max((len(column) for column in self._cells.values()), default=0)
        return len(self._given)

    def __getitem__(self, name: str) -> NDArray[Any]:
        """A column: an array of shape (rows,), of numbers with NaN for null, or of str and None."""
        if name not in self._cells:
            if name not in self._columns:
                raise UnknownNameError.of("column", name, self._columns)
            self._cells[name] = kept(self._rows[name])
        column: NDArray[Any] = self._cells[name]
        return column

    def __iter__(self) -> Iterator[dict[str, Any]]:
        """Each row: its cells by column, whole numbers, numbers with NaN for null, or str and None.

        Rows, not names: of what is no dict, pandas takes only rows.
        """
        cells = [self[name].tolist() for name in self._columns]
        return (dict(zip(self._columns, row, strict=True)) for row in zip(*cells, strict=True))

    def __contains__(self, name: object) -> bool:
        return name in self._columns

    def keys(self) -> list[str]:
        """Names of the columns."""
        return self.columns

    def values(self) -> list[NDArray[Any]]:
        """The columns."""
        return [self[name] for name in self._columns]

    def items(self) -> list[tuple[str, NDArray[Any]]]:
        """The columns with their names."""
        return [(name, self[name]) for name in self._columns]

    def __eq__(self, other: object) -> bool:
        """Whether the names, the cells and the units of all columns are the same; null equals null."""
        if not isinstance(other, Table):
            return NotImplemented
        same = self._columns == other._columns and self._units == other._units
        return same and all(_same(self[name], other[name]) for name in self._columns)

    __hash__ = None  # type: ignore[assignment]

    def __getstate__(self) -> tuple[dict[str, Any], dict[str, str]]:
        return dict(self.items()), self._units

    def __setstate__(self, state: tuple[dict[str, Any], dict[str, str]]) -> None:
        Table.__init__(self, *state)

    def __arrow_c_schema__(self) -> object:
        """The types of the columns, by the Arrow PyCapsule interface."""
        return self._rows.__arrow_c_schema__()

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        """The rows, by the Arrow PyCapsule interface; they are not copied. The types are always those of the table."""
        return self._rows.__arrow_c_stream__(requested_schema)

    def to_pandas(self) -> pandas.DataFrame:
        """A frame of pandas with these columns; its ``attrs["units"]`` has the units."""
        frame: pandas.DataFrame = library("pandas", "to_pandas").DataFrame(
            {name: plain(column) for name, column in self.items()}
        )
        frame.attrs["units"] = self.units
        return frame

    def to_polars(self) -> polars.DataFrame:
        """A frame of polars with these columns, which are not copied."""
        frame: polars.DataFrame = library("polars", "to_polars").DataFrame(self)
        return frame

    def __repr__(self) -> str:
        return f"<slipgap.Table of {html.count(len(self), 'row')}: {', '.join(self._columns)}>"

    def _repr_html_(self) -> str:
        return html.rows(self)


def kept(column: Any) -> NDArray[Any]:
    """A column that is handed out again: an array that cannot be written."""
    import numpy

    is_names = isinstance(column, list | tuple)
    array = numpy.array(column, dtype=object) if is_names else numpy.asarray(column)
    if array.flags.writeable:
        array = array.view()
        array.flags.writeable = False
    return array


def plain(column: NDArray[Any]) -> Any:
    """A column as the compiled module takes it: names are a list."""
    return column.tolist() if column.dtype == object else column


def _same(one: NDArray[Any], other: NDArray[Any]) -> bool:
    import numpy

    numbers = one.dtype != object
    return one.dtype == other.dtype and numpy.array_equal(one, other, equal_nan=numbers)
