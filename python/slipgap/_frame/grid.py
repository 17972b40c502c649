"""Results as arrays over the axes of a study."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from .library import library

if TYPE_CHECKING:
    import xarray

    from .._study import Study
    from .._table import Table

CASE = "case"
"""The dimension of results that are no grid, and the coordinate with the numbers of cases."""


class Axis:
    """A column of parameters: its values, each once, and the position of that of each case, -1 where it does not apply."""

    def __init__(self, name: str, column: Any) -> None:
        import numpy

        self.name = name
        if column.dtype == object:
            places: dict[Any, int] = {}
            codes = [-1 if value is None else places.setdefault(value, len(places)) for value in column]
            self.values: Any = numpy.array(list(places), dtype=object)
            self.codes = numpy.array(codes, dtype=numpy.int64)
        else:
            known = ~numpy.isnan(column)
            self.values, inverse = numpy.unique(column[known], return_inverse=True)
            self.codes = numpy.full(len(column), -1, dtype=numpy.int64)
            self.codes[known] = inverse

    @property
    def everywhere(self) -> bool:
        """Whether it applies to all cases."""
        return bool((self.codes >= 0).all())

    @property
    def varies(self) -> bool:
        return len(self.values) + (not self.everywhere) > 1


def dataset(
    table: Table,
    parameters: Sequence[str],
    metrics: Sequence[str],
    study: Study,
    attributes: Mapping[str, Any],
) -> xarray.Dataset:
    """What ``Results.to_xarray`` returns."""
    make = library("xarray", "to_xarray").Dataset
    axes = {name: Axis(name, table[name]) for name in parameters}
    dimensions = _dimensions([axis for axis in axes.values() if axis.varies], set(study.axes))
    if dimensions is None:
        variables, coordinates = _by_case(table, axes, metrics)
    else:
        variables, coordinates = _on_grid(table, axes, metrics, dimensions)
    units = table.units
    for name, (_, _, attrs) in [*variables.items(), *coordinates.items()]:
        if name in units:
            attrs["units"] = units[name]
    known = {name: value for name, value in attributes.items() if value is not None}
    found: xarray.Dataset = make(variables, coordinates, known)
    return found


def _dimensions(axes: list[Axis], given: set[str]) -> list[Axis] | None:
    """The parameters that tell all cases apart and span a grid with a case at most places; None without such a grid."""
    import numpy

    if not axes or not all(axis.everywhere for axis in axes):
        return None
    kept = list(axes)
    for axis in sorted(reversed(axes), key=lambda axis: axis.name in given):
        others = [other for other in kept if other is not axis]
        if _follows(axis, others):
            kept = others
    cases = len(axes[0].codes)
    if _places(_joined(kept)) < cases or numpy.prod([float(len(axis.values)) for axis in kept]) > 2 * cases:
        return None
    return kept


def _joined(axes: Sequence[Axis]) -> Any:
    """A number for each case that is the same where all of these are the same."""
    import numpy

    joined = numpy.zeros(len(axes[0].codes), dtype=numpy.int64)
    for axis in axes:
        joined = joined * (len(axis.values) + 1) + axis.codes + 1
        # Small numbers again, so that no product overflows.
        joined = numpy.unique(joined, return_inverse=True)[1]
    return joined


def _places(joined: Any) -> int:
    return int(joined.max()) + 1 if len(joined) else 0


def _follows(axis: Axis, others: Sequence[Axis]) -> bool:
    """Whether a parameter has one value for each combination of others."""
    return bool(others) and _places(_joined(others)) == _places(_joined([*others, axis]))


def _by_case(table: Table, axes: Mapping[str, Axis], metrics: Sequence[str]) -> Any:
    """Metrics over the number of the case, with the parameters as coordinates."""
    coordinates: dict[str, Any] = {CASE: ((CASE,), table[CASE], {})}
    for name, axis in axes.items():
        coordinates[name] = ((CASE,), table[name], {}) if axis.varies else _constant(axis)
    known = {name: coordinate for name, coordinate in coordinates.items() if coordinate is not None}
    return {name: ((CASE,), table[name], {}) for name in metrics}, known


def _on_grid(
    table: Table, axes: Mapping[str, Axis], metrics: Sequence[str], dimensions: list[Axis]
) -> Any:
    """Metrics over the grid of these parameters."""
    import numpy

    shape = tuple(len(axis.values) for axis in dimensions)
    at = tuple(axis.codes for axis in dimensions)
    names = tuple(axis.name for axis in dimensions)

    def spread(column: Any, empty: Any) -> Any:
        array = numpy.full(shape, empty, dtype=column.dtype)
        array[at] = column
        return array

    variables: dict[str, Any] = {name: (names, spread(table[name], numpy.nan), {}) for name in metrics}
    coordinates: dict[str, Any] = {CASE: (names, spread(table[CASE], -1), {})}
    for name, axis in axes.items():
        if axis in dimensions:
            coordinates[name] = ((name,), axis.values, {})
        elif axis.varies:
            over = list(dimensions)
            for axis_over in dimensions:
                fewer = [other for other in over if other is not axis_over]
                over = fewer if _follows(axis, fewer) else over
            cells = table[name]
            is_name = cells.dtype == object
            array = numpy.full(
                [len(axis_over.values) for axis_over in over], None if is_name else numpy.nan, cells.dtype if is_name else float
            )
            array[tuple(axis_over.codes for axis_over in over)] = cells
            coordinates[name] = (tuple(axis_over.name for axis_over in over), array, {})
        else:
            coordinates[name] = _constant(axis)
    return variables, {name: coordinate for name, coordinate in coordinates.items() if coordinate is not None}


def _constant(axis: Axis) -> Any:
    """The coordinate of a parameter with one value; None if it never applies."""
    return ((), axis.values[0], {}) if len(axis.values) else None
