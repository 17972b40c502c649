"""Figures of matplotlib, in its own style."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from .._errors import SlipgapError, UnknownNameError
from .._frames import library

if TYPE_CHECKING:
    from .._results import Results
    from .._solution import Solution

MOST_LABELS = 12
"""Most lines with a legend."""

MOST_CHANNELS = 6
"""Most channels of a case in one figure."""


def plot(
    results: Results,
    metric: str | None,
    x: str | None,
    y: str | None,
    case: int | Sequence[int] | None,
    ax: Any,
) -> Any:
    """What ``Results.plot`` returns."""
    Figure = library("matplotlib.figure", "results.plot").Figure
    if case is not None:
        if x is not None or y is not None:
            raise SlipgapError("the history of a case is over time: x and y belong to metrics")
        cases = [case] if isinstance(case, int) else [int(number) for number in case]
        return _history(results, metric, cases, ax, Figure)
    metrics = results.metrics
    metric = metric or metrics[0]
    if metric not in metrics:
        raise SlipgapError(f"{metric} is no metric of the study; it has {', '.join(metrics)}")
    figure = Figure(layout="constrained") if ax is None else ax.figure
    axes = figure.add_subplot() if ax is None else ax
    values = {name: _column(results, name) for name in results.parameters}
    for name in (x, y):
        if name is not None and name not in values:
            raise SlipgapError(f"{name} is no parameter of the study; it has {', '.join(values)}")
    if y is None:
        _lines(axes, values, metric, results, x)
    else:
        _map(figure, axes, values, metric, results, x, y)
    return figure


def _column(results: Results, name: str) -> list[Any]:
    column = results.table[name]
    return list(column if isinstance(column, list) else column.tolist())


def _varying(values: dict[str, list[Any]]) -> dict[str, int]:
    """The parameters with several values, and how many."""
    counts = {name: len({str(value) for value in column}) for name, column in values.items()}
    return {name: count for name, count in counts.items() if count > 1}


def _over(values: dict[str, list[Any]], x: str | None) -> str:
    """The parameter along the axis: the given one, or the numbers with the most values."""
    if x is not None:
        return x
    counts = _varying(values)
    numbers = [name for name in counts if not any(isinstance(v, str) for v in values[name])]
    if not numbers:
        raise SlipgapError("no parameter varies: a history needs case=0, a metric several cases")
    return max(numbers, key=lambda name: counts[name])


def _follows(name: str, others: list[str], values: dict[str, list[Any]]) -> bool:
    """Whether a parameter has one value for each combination of others."""
    seen: dict[tuple[str, ...], str] = {}
    for row, value in enumerate(values[name]):
        key = tuple(str(values[other][row]) for other in others)
        if seen.setdefault(key, str(value)) != str(value):
            return False
    return True


def _others(values: dict[str, list[Any]], along: list[str]) -> list[str]:
    """The parameters that tell lines apart: those that vary and do not follow from the rest."""
    counts = _varying(values)
    rest = [name for name in counts if name not in along]
    for name in sorted(rest, key=lambda name: -counts[name]):
        others = [other for other in rest if other != name]
        if _follows(name, [*along, *others], values):
            rest = others
    return rest


def _text(value: Any) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value)


def _lines(
    axes: Any, values: dict[str, list[Any]], metric: str, results: Results, x: str | None
) -> None:
    along = _over(values, x)
    by = _others(values, [along])
    lines: dict[tuple[str, ...], list[tuple[Any, float]]] = {}
    for row, number in enumerate(_column(results, metric)):
        key = tuple(f"{name} = {_text(values[name][row])}" for name in by)
        lines.setdefault(key, []).append((values[along][row], number))
    for key, points in lines.items():
        places = [x_value for x_value, _ in points]
        if not any(isinstance(x_value, str) for x_value in places):
            points.sort(key=lambda point: point[0])
        # Several cases at one place, as of an ensemble, are no line.
        style = "o-" if len(set(places)) == len(places) else "o"
        axes.plot(*zip(*points, strict=True), style, label=", ".join(key))
    axes.set_xlabel(along)
    axes.set_ylabel(metric)
    if by and len(lines) <= MOST_LABELS:
        axes.legend()


def _map(
    figure: Any,
    axes: Any,
    values: dict[str, list[Any]],
    metric: str,
    results: Results,
    x: str | None,
    y: str,
) -> None:
    import numpy

    along = _over({name: column for name, column in values.items() if name != y}, x)
    if others := _others(values, [along, y]):
        what = ", ".join(others)
        raise SlipgapError(f"a map needs one case at each place, and {what} varies; set it in run")
    columns, rows = (sorted(set(values[name])) for name in (along, y))
    numbers = numpy.full((len(rows), len(columns)), numpy.nan)
    for row, number in enumerate(_column(results, metric)):
        numbers[rows.index(values[y][row]), columns.index(values[along][row])] = number
    mesh = axes.pcolormesh(columns, rows, numbers, shading="nearest")
    figure.colorbar(mesh, ax=axes, label=metric)
    axes.set_xlabel(along)
    axes.set_ylabel(y)


def _history(
    results: Results, channel: str | None, cases: list[int], ax: Any, figures: Any
) -> Any:
    """The channels of cases over time; one channel if there are several cases that do not fit otherwise."""
    if not cases or len(cases) > MOST_LABELS:
        raise SlipgapError(f"case: must be a case, or 1 to {MOST_LABELS} of them")
    solutions = [results.solution(case) for case in cases]
    time, *names = solutions[0].channels
    if channel is not None:
        try:
            # A channel that is no column of a history is computed, or refused.
            for solution in solutions:
                solution.channels[channel]
        except UnknownNameError as error:
            known = ", ".join(names)
            raise SlipgapError(f"{channel} is no channel of the study; it has {known}") from error
    shown = [channel] if channel is not None else names
    if len(shown) > MOST_CHANNELS or (ax is not None and len(shown) > 1):
        raise SlipgapError(f"too many channels; name one of {', '.join(names)}")
    if ax is None:
        figure = figures(layout="constrained")
        all_axes = figure.subplots(len(shown), 1, sharex=True, squeeze=False)[:, 0]
    else:
        figure, all_axes = ax.figure, [ax]
    labels = _labels(results, cases)
    for axes, name in zip(all_axes, shown, strict=True):
        for i, (solution, label) in enumerate(zip(solutions, labels, strict=True)):
            _draw(axes, solution, name, label, f"C{i}" if len(cases) > 1 else None)
        if len(axes.lines) > 1:
            axes.legend()
        axes.set_ylabel(name)
    all_axes[-1].set_xlabel(time)
    return figure


def _labels(results: Results, cases: list[int]) -> list[str]:
    """What tells the cases apart, for a legend; empty for one case."""
    if len(cases) == 1:
        return [""]
    values = {name: _column(results, name) for name in results.parameters}
    few = {name: [column[case] for case in cases] for name, column in values.items()}
    differing = _varying(few)
    by = [name for name in _others(values, []) if name in differing]
    texts = [
        ", ".join(f"{name} = {_text(few[name][i])}" for name in by)
        for i in range(len(cases))
    ]
    return [text or f"case {case}" for text, case in zip(texts, cases, strict=True)]


def _draw(axes: Any, solution: Solution, name: str, label: str, colour: str | None) -> None:
    """A channel of a case with what was measured and the exact motion; those of several cases have the colour of the case."""
    of_case = f", {label}" if label else ""
    if name in solution.measured:
        style = {"color": colour or "0.6", "alpha": 0.5 if colour else 1}
        axes.plot(solution.time, solution.measured[name], label=f"measured{of_case}", **style)
    axes.plot(solution.time, solution.channels[name], color=colour, label=label or "computed")
    if name in solution.references:
        style = {"color": colour or "k", "linewidth": 0.8, "linestyle": "--" if colour else "-"}
        axes.plot(solution.time, solution.references[name], label=f"exact{of_case}", **style)
