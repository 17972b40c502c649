"""What notebooks show of results, in HTML."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from html import escape
from typing import TYPE_CHECKING, Any

from .curves import curves

if TYPE_CHECKING:
    from .._records import Calibration
    from .._results import Results
    from .._solution import Solution
    from .._study import Study
    from .._table import Table

FIRST, LAST = 6, 3
"""Rows of a long table that are shown."""

MOST = 12
"""Most columns of a table, and most parameters and metrics of a list, that are shown."""


def count(number: int, what: str) -> str:
    """A number of things."""
    return f"{number} {what}" if number == 1 else f"{number} {what}s"


def cell(value: Any) -> str:
    """A value in a table, with six digits."""
    if value is None or value != value:
        return ""
    if isinstance(value, tuple):
        return " .. ".join(map(cell, value))
    return f"{value:.6g}" if isinstance(value, float) else escape(str(value))


def grid(head: Iterable[str], lines: Iterable[Iterable[Any]]) -> str:
    """A table of values below their names."""
    top = "".join(f"<th>{escape(name)}</th>" for name in head)
    body = "".join(
        f"<tr>{''.join(f'<td>{cell(value)}</td>' for value in line)}</tr>" for line in lines
    )
    return f"<table><thead><tr>{top}</tr></thead><tbody>{body}</tbody></table>"


def pairs(title: str, values: Mapping[str, Any], units: Mapping[str, str]) -> str:
    """Names with values and units; empty without any."""
    known = {name: unit for name, unit in units.items() if unit != "1" and name in values}
    head = [title, "value", "unit"] if known else [title, "value"]
    shown = [(name, value, known.get(name, ""))[: len(head)] for name, value in values.items()]
    more = len(shown) - MOST
    note = f"<p>and {more} more</p>" if more > 0 else ""
    return grid(head, shown[:MOST]) + note if shown else ""


def side(*parts: str) -> str:
    """Parts beside each other."""
    each = "".join(f"<div>{part}</div>" for part in parts if part)
    return f'<div style="display:flex;flex-wrap:wrap;gap:1.5em;align-items:start">{each}</div>'


def notes(title: str, lines: Sequence[str]) -> str:
    """Sentences below a title; empty without any."""
    items = "".join(f"<li>{escape(line)}</li>" for line in lines[:MOST])
    return f"<p><b>{escape(title)}</b></p><ul>{items}</ul>" if lines else ""


def rows(table: Table, names: Sequence[str] | None = None) -> str:
    """The first and the last rows of a table."""
    names = list(names if names is not None else table.columns)
    shown = names[:MOST]
    columns = [table[name] for name in shown]
    long = len(table) > FIRST + LAST + 1
    places = list(range(len(table)))
    parts = [places[:FIRST], places[-LAST:]] if long else [places]
    lines = [[_plain(column[row]) for column in columns] for row in parts[0]]
    if long:
        lines.append(["…"] * len(shown))
        lines += [[_plain(column[row]) for column in columns] for row in parts[1]]
    units = table.units
    head = [name + (f" ({units[name]})" if units.get(name, "1") != "1" else "") for name in shown]
    hidden = len(names) - len(shown)
    more = f", {hidden} more" if hidden > 0 else ""
    return f"{grid(head, lines)}<p>{count(len(table), 'row')}, {count(len(names), 'column')}{more}</p>"


def _plain(value: Any) -> Any:
    return value.item() if hasattr(value, "item") else value


def study(opened: Study) -> str:
    """The name, the parameters and the other keys of a study."""
    parameters = {name: json.dumps(value, ensure_ascii=False) for name, value in opened.parameters.items()}
    title = opened.get("title") or opened.get("problem") or ""
    others = ", ".join(key for key in opened if key not in ("problem", "title", "parameters", "$schema", "//"))
    beside = f"<p>with {escape(others)}</p>" if others else ""
    return f"<p><b>{escape(opened.name)}</b>: {escape(str(title))}</p>{pairs('parameter', parameters, {})}{beside}"


def solution(solved: Solution) -> str:
    """The parameters, the metrics and the first channel of a solved case."""
    channels, exact = solved.channels, solved.references
    time, first = list(channels)[:2]
    lines = {first: (channels[time], channels[first])}
    if first in exact:
        lines["exact"] = (exact[time], exact[first])
    unit = solved.units.get(first, "1")
    picture = curves(lines, time, first if unit == "1" else f"{first} ({unit})")
    parameters = pairs("parameter", solved.parameters, {})
    return f"<p>{escape(repr(solved)[1:-1])}</p>{side(parameters, pairs('metric', solved.metrics, {}), picture)}"


def results(found: Results) -> str:
    """What a run found: parameters and metrics, checks, warnings, and the first figure."""
    table = found.table
    values = {name: table[name] for name in found.parameters}
    constant = {name: _plain(column[0]) for name, column in values.items() if _is_one(column)}
    varying = [name for name in found.parameters if name not in constant]
    constant = {name: value for name, value in constant.items() if cell(value)}
    met = [check for check in found.checks if check.met]
    failed = [
        f"case {check.case}: {check.metric} = {cell(check.value)}, allowed {cell(check.min)} .. {cell(check.max)}"
        for check in found.checks
        if not check.met
    ]
    unsolved = [f"case {failure.case}: {failure.reason}" for failure in found.failures]
    checks = f"<p>{len(met)} of {count(len(found.checks), 'check')} met</p>" if found.checks else ""
    figure = next(iter(found.figures.values()), None)
    picture = "" if figure is None else figure.svg[figure.svg.find("<svg") :]
    return "".join(
        [
            f"<p>{escape(repr(found)[1:-1])}</p>",
            rows(table, ["case", *varying, *found.metrics]),
            side(pairs("parameter", constant, table.units), picture),
            checks,
            notes("Checks that are not met", failed),
            notes("Cases without a solution", unsolved),
            notes("Warnings", [warned.message for warned in found.warnings if not warned.is_note]),
            notes("Notes", [warned.message for warned in found.warnings if warned.is_note]),
        ]
    )


def _is_one(column: Any) -> bool:
    """Whether a column has the same value in all rows."""
    if column.dtype == object:
        return len(set(column)) == 1
    same = (column == column[:1]) | (column != column) & (column[:1] != column[:1])
    return bool(same.all() and len(column))


def calibration(found: Calibration) -> str:
    """The alternatives with their best values, what is not determined, and the misfit around the best one."""
    names = list(dict.fromkeys(name for each in found.alternatives for name in each.parameters))
    lines = []
    for each in found.alternatives:
        line: list[Any] = [each.name, each.misfit, each.verdict]
        for name in names:
            free = each.parameters.get(name)
            line += [free.best, free.interval] if free else [None, None]
        lines.append(line)
    head = ["alternative", "misfit", "verdict", *(part for name in names for part in (name, "95 %"))]
    profiles = {name: free.profile for name, free in found.best.parameters.items() if free.profile}
    pictures = [
        curves({name: tuple(zip(*sorted(points), strict=True))}, name, "misfit")
        for name, points in profiles.items()
    ]
    return f"{grid(head, lines)}{notes('What the measurement says', found.sentences)}{side(*pictures)}"
