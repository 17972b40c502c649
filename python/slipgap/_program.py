"""The program that comes with the package, and the functions that run it."""

from __future__ import annotations

import shutil
import subprocess
import sysconfig
from collections.abc import Mapping, Sequence
from os import PathLike, fspath
from pathlib import Path
from typing import Any

from ._errors import SlipgapError
from ._json import dumps
from ._study import Study

Given = str | PathLike[str] | Mapping[str, Any]

UNSOLVED = 3
"""Exit code of a study with a case that could not be solved."""


def program() -> str:
    """The path of the program: that of this environment, else the first one in PATH."""
    installed = shutil.which("slipgap", path=sysconfig.get_path("scripts"))
    found = installed or shutil.which("slipgap")
    if found is None:
        raise SlipgapError("the program slipgap is neither in this environment nor in PATH")
    return found


def call(verb: str, words: Sequence[str], study: Given, allowed: Sequence[int] = (0,)) -> str:
    """What the program prints. A dict is its standard input, of which files are relative to the folder of the program."""
    text = None
    if isinstance(study, Study):
        text = study.to_json()
    elif isinstance(study, Mapping):
        text = dumps(study)
    done = subprocess.run(
        [program(), verb, "-" if text is not None else _path(study), *words],
        input=text or "",
        capture_output=True,
        encoding="utf-8",
        cwd=study.folder if isinstance(study, Study) else None,
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


def _path(study: Given) -> str:
    """A path that is no option."""
    path = Path(fspath(study))  # type: ignore[arg-type]
    return fspath(path if path.is_absolute() else Path(".") / path) if path.parts else "."


def report(
    study: str | PathLike[str] | Mapping[str, Any] = "studies",
    *,
    out: str | PathLike[str] = "figures",
    jobs: int | None = None,
    set: Mapping[str, Any] | None = None,
    allow_programs: bool = False,
) -> Path:
    """Write one page about a study, or about all studies of a folder, with checks, warnings, figures and tables.

    It runs the program ``slipgap report``, which comes with this package.

    :param study: path of a study file or of a folder of them, or a dict, whose results go to ``out/stdin``
    :param out: folder for ``report.html`` and the results; cases that it has already are not computed again
    :param jobs: number of threads; if left out, one for each core
    :param set: parameters to set, as in :func:`run`
    :param allow_programs: whether the programs of others that the study names may be started, as ``--allow-programs`` does
    :returns: path of the page, which needs no other file
    :raises SlipgapError: mistakes, or a file that cannot be read or written
    """
    # A study runs in its own folder.
    folder = Path(out).absolute() if isinstance(study, Study) else Path(out)
    words = ["--out", fspath(folder), *settings(set)]
    if jobs is not None:
        words += ["--jobs", str(jobs)]
    if allow_programs:
        words.append("--allow-programs")
    return Path(call("report", words, study).rstrip("\n"))


def explain(
    study: str | PathLike[str] | Mapping[str, Any],
    case: int = 0,
    *,
    set: Mapping[str, Any] | None = None,
) -> str:
    """Describe one case of a study: parameters with units and origin, steps, cost, estimated time, warnings.

    It runs the program ``slipgap explain``, which comes with this package.

    :param study: a study as in :func:`run`
    :param case: number of the case, from 0
    :param set: parameters to set, as in :func:`run`
    :returns: text to print
    :raises SlipgapError: mistakes
    """
    words = [str(case), *settings(set)]
    return call("explain", words, study, allowed=(0, UNSOLVED))
