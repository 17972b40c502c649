"""Progress bars of runs."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib import import_module
from typing import Any

Report = Callable[[int, int], object]


def _is_watched() -> bool:
    """Whether somebody may look at a bar: on a terminal or in a notebook."""
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    if shell is not None and hasattr(shell, "kernel"):
        return True
    stderr = sys.stderr
    return stderr is not None and stderr.isatty()


@contextmanager
def reporter(progress: bool | Report | None) -> Iterator[Report | None]:
    """What a run calls with the numbers of finished and of all cases; None without a bar.

    A bar needs tqdm. It appears after half a second.
    """
    if callable(progress):
        yield progress
        return
    if progress is False or (progress is None and not _is_watched()):
        yield None
        return
    bars: list[Any] = []

    def report(done: int, total: int) -> None:
        if not bars:
            # The last report of a run that took no time.
            if done == total:
                return
            try:
                tqdm = import_module("tqdm.auto").tqdm
            except ImportError:
                if progress:
                    raise ImportError("progress=True needs tqdm: pip install tqdm") from None
                bars.append(None)
            else:
                bars.append(tqdm(total=total, unit=" cases", delay=0.5))
        if bars[0] is not None:
            bars[0].update(done - bars[0].n)

    try:
        yield report
    finally:
        if bars and bars[0] is not None:
            bars[0].close()
