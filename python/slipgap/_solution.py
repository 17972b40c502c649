"""One solved case, with its channels by all names that studies have."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from . import _slipgap
from ._errors import SlipgapError, UnknownNameError
from ._frame.library import library
from ._show import html
from ._study import Study
from ._table import Table, kept

if TYPE_CHECKING:
    import numpy
    import pandas
    import polars
    import xarray
    from numpy.typing import NDArray

EXACT, MEASURED = "_exact", "_measured"
"""What names of columns of the exact motion and of a measurement end with, as in the files of ``run --histories``."""


class Channels(Mapping[str, "NDArray[numpy.float64]"]):
    """Time and channels by name: arrays of shape (N + 1,) that cannot be written.

    Iteration has the columns of a history. Of a study of a structure there is any other channel that its figures may draw, such as
    ``"deck.a_abs"``, ``"deck - pier"``, ``"gap.slip"``, ``"energy.kinetic"`` or ``"ground"``: the case is solved once more for it.
    """

    __slots__ = ("_arrays", "_part", "_solution")

    def __init__(self, arrays: Mapping[str, Any], part: str, solution: Solution) -> None:
        self._arrays = arrays
        self._part = part
        self._solution = solution

    def __getitem__(self, name: str) -> NDArray[numpy.float64]:
        if name not in self._arrays:
            array = self._solution._more(name, self._part)
            if array is None:
                raise UnknownNameError.of("channel", name, self._arrays)
            self._solution._found[self._part, name] = array
            return array
        return self._arrays[name]  # type: ignore[no-any-return]

    def __contains__(self, name: object) -> bool:
        return name in self._arrays

    def __iter__(self) -> Iterator[str]:
        return iter(self._arrays)

    def __len__(self) -> int:
        return len(self._arrays)

    def __repr__(self) -> str:
        return f"<slipgap.Channels: {', '.join(self._arrays)}>"


class Solution:
    """A solved case, as ``slipgap.solve`` returns it.

    All arrays have the shape (N + 1,) for N time steps, and cannot be written. Quantities have the scales of docs/scope.md: for the
    oscillator T = omega_n t, X = x/Delta, V = X' and S = force/(nu N); for bars t/T_I, r/(c T_I/2), rdot/c and force/F0. Structures
    have the units of their study. A study with units has further columns in these units.
    """

    __slots__ = ("_found", "_known", "_own", "_saved")

    def __init__(self, compiled: _slipgap.Solution | dict[str, Any], study: Study | None = None) -> None:
        # What was pickled has no compiled solution.
        self._saved = compiled if isinstance(compiled, dict) else None
        self._own = None if isinstance(compiled, dict) else compiled
        self._known = study
        # Channels beyond the columns of a history, by part and name.
        self._found: dict[tuple[str, str], NDArray[numpy.float64]] = {}

    def _part(self, name: str) -> Any:
        """What the compiled solution has under a name."""
        return getattr(self._own, name) if self._saved is None else self._saved[name]

    @property
    def _study(self) -> Study | None:
        """The study of the case; None for a dict of parameters."""
        if self._known is None and self._own is not None and self._own.source is not None:
            self._known = Study._of(*self._own.source)
        return self._known

    def _arrays(self, part: str) -> Channels:
        return Channels(self._part(part), part, self)

    @property
    def problem(self) -> str:
        """The problem of the case."""
        return str(self._part("problem"))

    @property
    def case_number(self) -> int:
        """Number of the case in the study, from 0."""
        return int(self._part("case_number"))

    @property
    def time(self) -> NDArray[numpy.float64]:
        """The times of the steps, of shape (N + 1,)."""
        return next(iter(self.channels.values()))

    @property
    def channels(self) -> Channels:
        """The computed motion: time and channels by name, each of shape (N + 1,)."""
        return self._arrays("channels")

    @property
    def references(self) -> Channels:
        """The exact motion at the same times: time and channels by name, each of shape (N + 1,)."""
        return self._arrays("references")

    @property
    def measured(self) -> Channels:
        """What was measured, at the same times: time and channels by name, each of shape (N + 1,), straight between the measured
        points and NaN outside of them. Empty for a study without ``measured``."""
        return self._arrays("measured")

    @property
    def metrics(self) -> dict[str, float | None]:
        """The metrics by name; None where one is undefined."""
        return dict(self._part("metrics"))

    @property
    def parameters(self) -> dict[str, float | int | str]:
        """The parameters that apply, by name, with defaults and what follows from others."""
        return dict(self._part("parameters"))

    @property
    def units(self) -> dict[str, str]:
        """Units by channel, of those whose unit is known."""
        return dict(self._part("units"))

    def _more(self, name: str, part: str) -> NDArray[numpy.float64] | None:
        """A channel that the study could draw; None without such a study."""
        known = self._found.get((part, name))
        if known is not None or part == "measured" or self._study is None:
            return known
        if self._study.get("problem") != "structure":
            return None
        if self._own is not None and (found := _in(self._own, name, part)) is not None:
            return found
        # The figure shows this case alone.
        case = {key: value for key, value in self.parameters.items() if key in self._study.axes}
        figure = {"name": "channel", "kind": "history", "y": [name], "where": case}
        drawn = self._study.replace(figures=[figure], checks=None)
        try:
            return _in(_slipgap.solve(drawn, self.case_number, False), name, part)
        except SlipgapError as error:
            message = f"{UnknownNameError.of('channel', name, self._arrays(part))}; {error}"
            raise UnknownNameError(message) from None

    @property
    def table(self) -> Table:
        """Time, channels, the exact motion and the measurement as a table, with the columns of ``run --histories``."""
        channels, exact, measured = self.channels, self.references, self.measured
        columns, units = dict(channels), self.units
        of_parts = [(exact, EXACT), (measured, MEASURED)]
        for part, ending in of_parts:
            for name in list(part)[1:]:
                columns[name + ending] = part[name]
                if name in units:
                    units[name + ending] = units[name]
        return Table(columns, units)

    def to_pandas(self) -> pandas.DataFrame:
        """The table of the motion as a frame of pandas, whose index is the time."""
        frame = self.table.to_pandas()
        return frame.set_index(frame.columns[0])

    def to_polars(self) -> polars.DataFrame:
        """The table of the motion as a frame of polars."""
        return self.table.to_polars()

    def to_xarray(self) -> xarray.Dataset:
        """The table of the motion as a dataset of xarray over time, with units, and the parameters as attributes."""
        make = library("xarray", "to_xarray").Dataset
        table = self.table
        time, *names = table.columns
        units = {name: {"units": unit} for name, unit in table.units.items()}
        variables = {name: ((time,), table[name], units.get(name, {})) for name in names}
        times = {time: ((time,), table[time], units.get(time, {}))}
        dataset: xarray.Dataset = make(variables, times, self.parameters)
        return dataset

    def __getstate__(self) -> dict[str, Any]:
        arrays = {part: dict(self._arrays(part)) for part in ("channels", "references", "measured")}
        plain = {name: self._part(name) for name in ("problem", "case_number", "metrics", "parameters", "units")}
        return {**plain, **arrays, "study": self._study, "found": self._found}

    def __setstate__(self, state: dict[str, Any]) -> None:
        study, found = state.pop("study"), state.pop("found")
        for part in ("channels", "references", "measured"):
            state[part] = {name: kept(array) for name, array in state[part].items()}
        Solution.__init__(self, state, study)
        self._found = {key: kept(array) for key, array in found.items()}

    def __repr__(self) -> str:
        steps = html.count(len(self.time) - 1, "step")
        return f"<slipgap.Solution of {self.problem}, case {self.case_number}: {steps}>"

    def _repr_html_(self) -> str:
        return html.solution(self)


def _in(compiled: _slipgap.Solution, name: str, part: str) -> NDArray[numpy.float64] | None:
    """A channel of a solution that is not only a column of its history, also with other blanks."""
    plain = " ".join(name.replace("-", " - ").replace("+", " + ").split())
    all_channels = {**getattr(compiled, part), **compiled.drawn(part == "references")}
    column = next((known for known in (name, plain, f"{plain}.u") if known in all_channels), None)
    return None if column is None else all_channels[column]
