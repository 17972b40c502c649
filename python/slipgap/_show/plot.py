"""Figures of matplotlib with the words and the colours of the program."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from io import BytesIO
from typing import TYPE_CHECKING, Any

from .._errors import SlipgapError, UnknownNameError
from .._frame.library import library
from .titles import Titles

if TYPE_CHECKING:
    from .._results import Results
    from .._solution import Solution

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")
"""The colours of curves, as in the figures of the program."""

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
    make = _figures() if ax is None else None
    if case is not None:
        if x is not None or y is not None:
            raise SlipgapError("the history of a case is over time: x and y belong to metrics")
        cases = [case] if isinstance(case, int) else [int(number) for number in case]
        return _history(results, metric, cases, ax, make)
    metrics = results.metrics
    metric = metric or metrics[0]
    if metric not in metrics:
        raise SlipgapError(f"{metric} is no metric of the study; it has {', '.join(metrics)}")
    values = {name: _column(results, name) for name in results.parameters}
    for name in (x, y):
        if name is not None and name not in values:
            raise SlipgapError(f"{name} is no parameter of the study; it has {', '.join(values)}")
    members = _members(results, values)
    along = _over({name: column for name, column in values.items() if name != y}, x, members)
    if y is not None and (others := _others(values, [along, y])):
        what = ", ".join(others)
        raise SlipgapError(f"a map needs one case at each place, and {what} varies; set it in run")
    figure = ax.figure if make is None else make()
    axes = figure.add_subplot() if ax is None else ax
    axes.set_prop_cycle(color=COLOURS)
    titles = Titles(results.study)
    axes.set_xlabel(titles.of(along))
    if y is None:
        _lines(axes, values, _column(results, metric), along, members, titles)
        axes.set_ylabel(titles.of(metric))
    else:
        mesh = _map(axes, values, _column(results, metric), along, y)
        figure.colorbar(mesh, ax=axes, label=titles.of(metric))
        axes.set_ylabel(titles.of(y))
    return figure


def _figures() -> Any:
    """What makes a figure: pyplot where it is in use, so that ``plt.savefig`` and ``plt.show`` have the figure."""
    Figure = library("matplotlib.figure", "results.plot").Figure
    pyplot: Any = sys.modules.get("matplotlib.pyplot")
    if pyplot is None:
        return lambda: Figure(layout="constrained")

    def show_once(figure: Any) -> None:
        """A notebook shows it as the value of a cell, or with what pyplot has at the end of the cell, not by both."""
        display = library("IPython.display", "a notebook")
        with BytesIO() as png:
            figure.savefig(png, format="png")
            display.display(display.Image(png.getvalue()))
        pyplot.close(figure)

    shown = type("Figure", (Figure,), {"_ipython_display_": show_once})
    return lambda: pyplot.figure(FigureClass=shown, layout="constrained")


def _column(results: Results, name: str) -> list[Any]:
    cells: list[Any] = results.table[name].tolist()
    return cells


def _members(results: Results, values: Mapping[str, list[Any]]) -> list[str]:
    """The parameters by which the members of the ensemble differ, and what follows from them."""
    given = results.study.get("ensemble", [])
    names = [given] if isinstance(given, str) else list(given)
    names = [name for name in names if name in values]
    follow = [name for name in _varying(values) if names and name not in names and _follows(name, names, values)]
    return names + follow


def _varying(values: Mapping[str, list[Any]]) -> dict[str, int]:
    """The parameters with several values, and how many."""
    counts = {name: len({str(value) for value in column}) for name, column in values.items()}
    return {name: count for name, count in counts.items() if count > 1}


def _over(values: dict[str, list[Any]], x: str | None, members: Sequence[str]) -> str:
    """The parameter along the axis: the given one, or the numbers with the most values, of members of an ensemble last."""
    if x is not None:
        return x
    counts = _varying(values)
    numbers = [name for name in counts if not any(isinstance(v, str) for v in values[name])]
    if not numbers:
        raise SlipgapError("no parameter varies: a history needs case=0, a metric several cases")
    return max(numbers, key=lambda name: (name not in members, counts[name]))


def _follows(name: str, others: list[str], values: Mapping[str, list[Any]]) -> bool:
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


def _lines(
    axes: Any, values: dict[str, list[Any]], numbers: list[Any], along: str, members: list[str], titles: Titles
) -> None:
    """A line for each combination of the others that vary; with an ensemble the median, and a thin line for each member."""
    inside = [name for name in members if name != along and name in _varying(values)]
    by = _others({name: column for name, column in values.items() if name not in inside}, [along])
    lines: dict[tuple[str, ...], dict[tuple[Any, ...], list[tuple[Any, float]]]] = {}
    for row, number in enumerate(numbers):
        key = tuple(titles.value(name, values[name][row]) for name in by)
        member = tuple(values[name][row] for name in inside)
        lines.setdefault(key, {}).setdefault(member, []).append((values[along][row], number))
    legend = bool(by) and len(lines) <= MOST_LABELS
    for i, (key, of_members) in enumerate(lines.items()):
        colour, label = COLOURS[i % len(COLOURS)], ", ".join(key)
        if len(of_members) == 1:
            [points] = of_members.values()
            axes.plot(*_sorted(points), _style(points), color=colour, label=label)
            continue
        for points in of_members.values():
            axes.plot(*_sorted(points), color=colour, linewidth=0.5, alpha=0.4, label="_member")
        medians = _medians([point for points in of_members.values() for point in points])
        count = f"median of {len(of_members)}"
        axes.plot(*_sorted(medians), _style(medians), color=colour, label=f"{label}, {count}" if label else count)
        legend = len(lines) <= MOST_LABELS
    if legend:
        axes.legend()


def _sorted(points: list[tuple[Any, float]]) -> tuple[list[Any], list[float]]:
    """The points of a line, by numbers in their order."""
    if not any(isinstance(x, str) for x, _ in points):
        points = sorted(points, key=lambda point: point[0])
    return [x for x, _ in points], [y for _, y in points]


def _style(points: list[tuple[Any, float]]) -> str:
    """Several cases at one place are no line."""
    return "o-" if len({x for x, _ in points}) == len(points) else "o"


def _medians(points: list[tuple[Any, float]]) -> list[tuple[Any, float]]:
    """The median at each place, without cases that have no value."""
    import numpy

    found: dict[Any, list[float]] = {}
    for x, y in points:
        found.setdefault(x, []).append(y)
    known = {x: [y for y in column if y == y] for x, column in found.items()}
    return [(x, float(numpy.median(column)) if column else numpy.nan) for x, column in known.items()]


def _map(axes: Any, values: dict[str, list[Any]], cells: list[Any], along: str, y: str) -> Any:
    import numpy

    columns, rows = (sorted(set(values[name])) for name in (along, y))
    numbers = numpy.full((len(rows), len(columns)), numpy.nan)
    for row, number in enumerate(cells):
        numbers[rows.index(values[y][row]), columns.index(values[along][row])] = number
    return axes.pcolormesh(columns, rows, numbers, shading="nearest")


def _history(
    results: Results, channel: str | None, cases: list[int], ax: Any, make: Any
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
        figure = make()
        all_axes = figure.subplots(len(shown), 1, sharex=True, squeeze=False)[:, 0]
    else:
        figure, all_axes = ax.figure, [ax]
    titles = Titles(results.study, shown, _place(results, cases[0]))
    labels = _labels(results, cases, titles)
    for axes, name in zip(all_axes, shown, strict=True):
        for i, (solution, label) in enumerate(zip(solutions, labels, strict=True)):
            _draw(axes, solution, name, label, COLOURS[i % len(COLOURS)] if len(cases) > 1 else None)
        if len(axes.lines) > 1:
            axes.legend()
        axes.set_ylabel(titles.of(name))
    all_axes[-1].set_xlabel(titles.of(time))
    return figure


def _place(results: Results, case: int) -> dict[str, Any]:
    """The parameters that tell a case from others."""
    values = {name: _column(results, name) for name in results.parameters}
    cells = {name: values[name][case] for name in _varying(values)}
    return {name: cell for name, cell in cells.items() if cell is not None and cell == cell}


def _labels(results: Results, cases: list[int], titles: Titles) -> list[str]:
    """What tells the cases apart, for a legend; empty for one case."""
    if len(cases) == 1:
        return [""]
    values = {name: _column(results, name) for name in results.parameters}
    few = {name: [column[case] for case in cases] for name, column in values.items()}
    differing = _varying(few)
    by = [name for name in _others(values, []) if name in differing]
    texts = [
        ", ".join(titles.value(name, few[name][i]) for name in by)
        for i in range(len(cases))
    ]
    return [text or f"case {case}" for text, case in zip(texts, cases, strict=True)]


def _draw(axes: Any, solution: Solution, name: str, label: str, colour: str | None) -> None:
    """A channel of a case with what was measured and the exact motion; those of several cases have the colour of the case."""
    of_case = f", {label}" if label else ""
    if name in solution.measured:
        style = {"color": colour or "0.6", "alpha": 0.5 if colour else 1}
        axes.plot(solution.time, solution.measured[name], label=f"measured{of_case}", **style)
    axes.plot(solution.time, solution.channels[name], color=colour or COLOURS[0], label=label or "computed")
    if name in solution.references:
        style = {"color": colour or "k", "linewidth": 0.8, "linestyle": "--" if colour else "-"}
        axes.plot(solution.time, solution.references[name], label=f"exact{of_case}", **style)
