"""The program that comes with the package."""

from __future__ import annotations

import shutil
import subprocess
import sysconfig
from collections.abc import Mapping, Sequence
from os import PathLike, fspath
from pathlib import Path
from typing import Any

from ._records import SlipgapError, dumps

Study = str | PathLike[str] | Mapping[str, Any]

UNSOLVED = 3
"""Exit code of a study with a case that could not be solved."""


def program() -> str:
    """The path of the program: that of this environment, else the first one in PATH."""
    own = shutil.which("slipgap", path=sysconfig.get_path("scripts"))
    found = own or shutil.which("slipgap")
    if found is None:
        raise SlipgapError("the program slipgap is neither in this environment nor in PATH")
    return found


def call(
    verb: str, words: Sequence[str], study: Study | None, allowed: Sequence[int] = (0,)
) -> str:
    """What the program prints; a dict is its standard input."""
    text = dumps(study) if isinstance(study, Mapping) else None
    names = [] if study is None else ["-" if isinstance(study, Mapping) else _path(study)]
    done = subprocess.run(
        [program(), verb, *names, *words],
        input=text if text is not None else "",
        capture_output=True,
        encoding="utf-8",
    )
    if done.returncode not in allowed:
        message = done.stderr.strip() or f"slipgap {verb}: exit code {done.returncode}"
        raise SlipgapError(message.removeprefix("slipgap: "))
    return done.stdout


def settings(values: Mapping[str, Any] | None) -> list[str]:
    """The options that set parameters."""
    texts = {
        name: value if isinstance(value, str) else dumps(value)
        for name, value in (values or {}).items()
    }
    return [word for name, text in texts.items() for word in ("--set", f"{name}={text}")]


def _path(study: str | PathLike[str]) -> str:
    """A path that is no option."""
    path = Path(fspath(study))
    return fspath(path if path.is_absolute() else Path(".") / path) if path.parts else "."
