"""Warnings at the line of the user, and notes for the log."""

from __future__ import annotations

import logging
import os
import sys
import warnings
from collections.abc import Iterable
from pathlib import Path

from .._errors import SlipgapWarning
from .._records import WarnedCases

LOG = logging.getLogger("slipgap")
LOG.addHandler(logging.NullHandler())

_HERE = f"{Path(__file__).parent.parent}{os.sep}"


def issue(warned: Iterable[WarnedCases]) -> None:
    """Issue each warning once; a note goes to the log ``slipgap`` with the level INFO."""
    for kind in warned:
        if kind.is_note:
            LOG.info(kind.message, stacklevel=_level())
        else:
            warnings.warn(kind.message, SlipgapWarning, stacklevel=_level())


def _level() -> int:
    """The ``stacklevel`` of the first caller outside of the package, for a function that calls this one."""
    frame, level = sys._getframe(1), 1
    while frame is not None and frame.f_code.co_filename.startswith(_HERE):
        frame, level = frame.f_back, level + 1  # type: ignore[assignment]
    return level
