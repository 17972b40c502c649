"""Titles of axes in the words of the program, for matplotlib."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from .. import _slipgap

if TYPE_CHECKING:
    from .._study import Study

PIECE = re.compile(r"\\([*_^\\])|\*([^*]+)\*|_([^_]+)_|\^([^^]+)\^|([$])")
"""A mark that is meant literally, italic text, a subscript, a superscript, and what matplotlib would take for mathematics."""


class Titles:
    """The titles of the columns and channels of a study."""

    def __init__(self, study: Study, channels: list[str] | None = None, where: Mapping[str, Any] | None = None) -> None:
        if channels:
            # A channel has words once a figure draws it, of the case in `where`.
            figure = {"name": "channels", "kind": "history", "y": channels, "where": where or {}}
            study = study.replace(figures=[figure])
        self._markup = _slipgap.titles(study)

    def of(self, name: str) -> str:
        """The title of an axis, with its unit."""
        return mathtext(self._markup[name]) if name in self._markup else name

    def value(self, name: str, value: Any) -> str:
        """A value of a parameter, as in a legend."""
        text = f"{value:g}" if isinstance(value, float) else str(value)
        title, comma, unit = self.of(name).rpartition(", ")
        return f"{title} = {text} {unit}" if comma else f"{unit} = {text}"


def mathtext(markup: str) -> str:
    """The markup of titles for matplotlib."""
    return PIECE.sub(_piece, markup)


def _piece(found: re.Match[str]) -> str:
    literal, italic, below, above, dollar = found.groups()
    if literal or dollar:
        return str(literal or r"\$")
    if italic:
        return f"${italic}$"
    sign, text = ("_", below) if below else ("^", above)
    return f"${sign}{{\\mathrm{{{text}}}}}$"
