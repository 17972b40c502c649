"""The exceptions and the warning of the package."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from difflib import get_close_matches
from typing import NamedTuple

MOST_LISTED = 30
"""Most names in a message."""


class Fault(NamedTuple):
    """A mistake in a study: its place, what is wrong, and what is allowed."""

    file: str | None
    """The file, or the parameter that was set; None for a dict."""
    line: int | None
    """Line, from 1; None for a dict."""
    column: int | None
    """Column, from 1, in characters; None for a dict."""
    path: str
    """The key, as in ``parameters.alpha[2]``; empty for faults of syntax."""
    message: str
    """What is wrong and what is allowed."""


class SlipgapWarning(UserWarning):
    """A study with cases that were solved and may still mislead; see ``results.warnings``."""


class SlipgapError(Exception):
    """A study, an argument or a file that slipgap cannot work with, or a case without a solution.

    ``file``, ``line``, ``column`` and ``path`` are those of the first fault, or None. ``faults`` has all faults of a
    study, in the order of the file.
    """

    def __init__(
        self, message: str, *, faults: Sequence[Fault] = (), file: str | None = None
    ) -> None:
        super().__init__(message)
        self.faults: tuple[Fault, ...] = tuple(faults)
        first = self.faults[0] if self.faults else None
        self.file: str | None = first.file if first else file
        self.line: int | None = first.line if first else None
        self.column: int | None = first.column if first else None
        self.path: str | None = first.path if first else None


class UnknownNameError(SlipgapError, KeyError):
    """A name that a table, a solution or a study does not have, with the nearest one that it has."""

    def __str__(self) -> str:
        return Exception.__str__(self)

    @classmethod
    def of(cls, what: str, name: object, known: Iterable[str]) -> UnknownNameError:
        """The error for a name of this kind that is not among the known ones."""
        names = list(known)
        plain = {known_name.casefold(): known_name for known_name in names}
        near = get_close_matches(str(name).casefold(), plain, n=1, cutoff=0.7)
        hint = f"; did you mean {plain[near[0]]}?" if near else f"; there are {_listed(names)}"
        return cls(f"no {what} {name}{hint}")


def _listed(names: Sequence[str]) -> str:
    """Names in a sentence, not too many."""
    more = len(names) - MOST_LISTED
    return ", ".join(names[:MOST_LISTED]) + (f" and {more} more" if more > 0 else "")
