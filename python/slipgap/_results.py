"""The results of a run."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _slipgap
from ._frame import grid
from ._records import Check, Failure, WarnedCases
from ._show import html, plot
from ._solution import Solution
from ._study import Study
from ._table import Table

if TYPE_CHECKING:
    import pandas
    import polars
    import xarray

PARTS = ("figures", "folder", "checks", "failures", "warnings", "parameters", "metrics", "manifest")
"""What is kept when results are pickled, beside tables and the study."""


class Results:
    """The results of a study, as ``slipgap.run`` returns them. They can be pickled, with the figures drawn."""

    def __init__(self, compiled: _slipgap.Results | dict[str, Any]) -> None:
        self._own = compiled
        # What was asked for.
        self._parts: dict[str, Any] = compiled if isinstance(compiled, dict) else {}

    def _part(self, name: str) -> Any:
        if name not in self._parts:
            self._parts[name] = getattr(self._own, name)
        return self._parts[name]

    @property
    def study(self) -> Study:
        """The study, with the parameters that ``set`` gave."""
        if "study" not in self._parts:
            self._parts["study"] = Study._of(*self._own.source)  # type: ignore[union-attr]
        return self._parts["study"]  # type: ignore[no-any-return]

    @property
    def table(self) -> Table:
        """The table with one row for each case."""
        table = self._part("table")
        if not isinstance(table, Table):
            table = self._parts["table"] = Table(table)
        return table

    @property
    def tables(self) -> dict[str, Table]:
        """The tables over groups of cases by name, with the columns of the files: ``quantiles``, ``two_samples`` and ``tests`` of an ensemble,
        ``sobol`` of a saltelli design, ``reductions``, those that the study has; and ``warnings``, one row for each kind."""
        tables = self._part("tables")
        if not all(isinstance(table, Table) for table in tables.values()):
            tables = self._parts["tables"] = {name: Table(rows) for name, rows in tables.items()}
        return dict(tables)

    @property
    def figures(self) -> dict[str, _slipgap.Figure]:
        """Figures by name."""
        return dict(self._part("figures"))

    @property
    def checks(self) -> list[Check]:
        """The checks of the study, each with its case, its value and whether it is met."""
        return list(self._part("checks"))

    @property
    def failures(self) -> list[Failure]:
        """The cases that could not be solved."""
        return list(self._part("failures"))

    @property
    def warnings(self) -> list[WarnedCases]:
        """The kinds of warnings, each with the number of its cases and one of them."""
        return list(self._part("warnings"))

    @property
    def parameters(self) -> list[str]:
        """Names of the columns of the table that are parameters."""
        return list(self._part("parameters"))

    @property
    def metrics(self) -> list[str]:
        """Names of the columns of the table that are metrics."""
        return list(self._part("metrics"))

    @property
    def manifest(self) -> dict[str, Any]:
        """The origin of the results, as in manifest.json."""
        return dict(self._part("manifest"))

    @property
    def folder(self) -> Path | None:
        """The folder with the files of the run; None without one."""
        folder = self._part("folder")
        return None if folder is None else Path(folder)

    def solution(self, case: int) -> Solution:
        """A case of the study with its motion, as :func:`slipgap.solve` gives it."""
        if isinstance(self._own, _slipgap.Results):
            return Solution(self._own.solution(case))
        return Solution(_slipgap.solve(self.study, case, False))

    def plot(
        self,
        metric: str | None = None,
        x: str | None = None,
        y: str | None = None,
        *,
        case: int | Sequence[int] | None = None,
        ax: Any = None,
    ) -> Any:
        """A figure of matplotlib with the words, units and colours of the program: a metric over a parameter, a metric over two, or the
        history of cases. Members of an ensemble are thin lines, with their median. Where pyplot is in use, its current figure is this one.

        ``plot(y)`` draws the metric over the parameter with the most values, and ``plot(y, x)`` over another one, a line for each
        combination of the others that vary; ``plot(z, x, y)`` draws a map. ``plot(case=3)`` draws the channels of a case over time,
        ``plot("r", case=3)`` one of them, with the exact motion if there is one, and ``plot("r", case=[0, 3])`` that of two cases.
        Axes that are given are drawn on.
        """
        return plot.plot(self, metric, x, y, case, ax)

    def to_pandas(self) -> pandas.DataFrame:
        """The table of cases as a frame of pandas."""
        return self.table.to_pandas()

    def to_polars(self) -> polars.DataFrame:
        """The table of cases as a frame of polars."""
        return self.table.to_polars()

    def to_xarray(self) -> xarray.Dataset:
        """The metrics as arrays of xarray over the axes of the study, with coordinates and units.

        The parameters that vary are dimensions, in the order of the table, with rising numbers or with names as they come.
        A parameter that follows from others is a coordinate over them, and a constant one is a single coordinate. ``case`` has the
        numbers of the cases, -1 at a place without a case, where metrics are NaN. If a parameter does not apply to all cases, if
        two cases are at one place, or if more than half of the places have no case, the one dimension is ``case``.
        """
        attributes = {"study": self.study.name, "title": self.study.get("title")}
        return grid.dataset(self.table, self.parameters, self.metrics, self.study, attributes)

    def __getstate__(self) -> dict[str, Any]:
        parts = {name: self._part(name) for name in PARTS}
        return {**parts, "table": self.table, "tables": self.tables, "study": self.study}

    def __setstate__(self, state: dict[str, Any]) -> None:
        Results.__init__(self, state)

    def __repr__(self) -> str:
        cases, unsolved = html.count(len(self.table), "case"), len(self.failures)
        without = f", {unsolved} without a solution" if unsolved else ""
        return f"<slipgap.Results of {self.study.name}: {cases}{without}>"

    def _repr_html_(self) -> str:
        return html.results(self)
