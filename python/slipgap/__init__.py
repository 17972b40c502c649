"""Parameter studies of friction and impact models in time-history analysis.

Every case is compared with its exact solution. A study is the path of a study file, a dict with the same content
(docs/study-files.md), or a :class:`Study`. The numbers are those of the program ``slipgap``, which comes with this package.

>>> import slipgap
>>> solution = slipgap.solve({"problem": "friction-oscillator", "law": "displacement-control",
...                           "alpha": 0.1, "dT": "pi/10", "duration": "8*pi"})
>>> round(solution.metrics["rms_error"], 4)
0.0245
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from os import PathLike
from typing import TYPE_CHECKING, Any

from . import _slipgap
from ._errors import Fault, SlipgapError, SlipgapWarning, UnknownNameError
from ._program import explain, report
from ._run.progress import reporter
from ._records import (
    Alternative,
    Calibration,
    Candidate,
    Change,
    Check,
    Claim,
    Comparison,
    Failure,
    FreeParameter,
    Reading,
    Recommendation,
    WarnedCases,
)
from ._results import Results
from ._slipgap import Animation, Figure, __version__
from ._solution import Channels, Solution
from ._study import Study
from ._table import Table
from ._run.warn import issue

if TYPE_CHECKING:
    import numpy
    from numpy.typing import ArrayLike, NDArray

__all__ = [
    "Alternative",
    "Animation",
    "Calibration",
    "Candidate",
    "Change",
    "Channels",
    "Check",
    "Claim",
    "Comparison",
    "Failure",
    "Fault",
    "Figure",
    "FreeParameter",
    "Reading",
    "Recommendation",
    "Results",
    "SlipgapError",
    "SlipgapWarning",
    "Solution",
    "Study",
    "Table",
    "UnknownNameError",
    "WarnedCases",
    "__version__",
    "animate",
    "calibrate",
    "claims",
    "compare",
    "exact",
    "explain",
    "recommend",
    "report",
    "run",
    "schema",
    "solve",
]


def run(
    study: str | PathLike[str] | Mapping[str, Any],
    *,
    out: str | PathLike[str] | None = None,
    jobs: int | None = None,
    set: Mapping[str, Any] | None = None,
    progress: bool | Callable[[int, int], object] | None = None,
    allow_programs: bool = False,
) -> Results:
    """Run every case of a study.

    Ctrl-C ends the run. Other threads of Python go on.

    :param study: path of a study file, a dict with the content of one, or a :class:`Study`; records are relative to the file, of a
        dict to the current folder
    :param out: folder for the files of the program, in ``out/NAME`` for the file ``NAME.json`` and in ``out/study`` for a
        dict; cases that it has already are not computed again; if left out, nothing is written
    :param jobs: number of threads, 1 to 1024; if left out, one for each core
    :param set: parameters to set, as ``--set`` does: names with numbers, lists, or text (a name or an expression)
    :param progress: whether a bar of tqdm shows the progress; if left out, on a terminal and in a notebook; or a function
        that is called some times a second with the numbers of finished and of all cases
    :param allow_programs: whether the programs of others that the study names may be started, as ``--allow-programs`` does
    Each kind of warning is issued once, as a :class:`SlipgapWarning`; a note goes to the log ``slipgap`` of :mod:`logging`, with the
    level INFO. ``results.warnings`` has both.

    :returns: table, figures, checks, failures and warnings; a case that cannot be solved is a row without metrics
    :raises SlipgapError: a study with mistakes, or a file that cannot be read or written
    """
    with reporter(progress) as report:
        results = Results(_slipgap.run(study, out, jobs, set, report, allow_programs))
    issue(results.warnings)
    return results


def solve(
    study_or_parameters: str | PathLike[str] | Mapping[str, Any],
    case: int = 0,
    *,
    allow_programs: bool = False,
) -> Solution:
    """Solve one case, with its motion at every step.

    :param study_or_parameters: a study as in :func:`run`, or a dict of the problem and its parameters, such as
        ``{"problem": "friction-oscillator", "law": "displacement-control", "alpha": 0.1, "dT": 0.3, "duration": 25}``
    :param case: number of the case of a study, from 0
    :param allow_programs: whether the programs of others that the study names may be started, as ``--allow-programs`` does
    :returns: channels and exact motion as arrays of shape (N + 1,) for N time steps, metrics and parameters
    :raises SlipgapError: mistakes, or a case that cannot be solved
    """
    return Solution(_slipgap.solve(study_or_parameters, case, allow_programs))


def animate(
    study: str | PathLike[str] | Mapping[str, Any],
    *cases: int,
    exact: bool = False,
    set: Mapping[str, Any] | None = None,
    allow_programs: bool = False,
) -> Animation:
    """Show cases of a study in motion.

    The drawing of the structure moves under its loads or the ground motion, with contacts lit when they touch or slide, and the
    forces below. A notebook shows it; ``animate(study).save("motion.html")`` writes the page, which needs no other file.

    :param study: a study as in :func:`run`
    :param cases: numbers of one case or of two, from 0; if left out, the first case that a history figure shows, or else the first
        case
    :param exact: whether the exact motion of the one case is shown beside it
    :param set: parameters to set, as in :func:`run`
    :param allow_programs: whether the programs of others that the study names may be started, as ``--allow-programs`` does
    :raises SlipgapError: mistakes, a case that cannot be solved, or one without an exact motion
    """
    return _slipgap.animate(study, list(cases), exact, set, allow_programs)


def exact(
    problem: str, t: ArrayLike, **parameters: Any
) -> dict[str, NDArray[numpy.float64]]:
    """Exact motion at given times.

    ``exact("friction-oscillator", t, x0=12)`` is free vibration with Coulomb friction: ``X`` in Delta = nu N/k, ``V`` = dX/dT and
    the friction force ``S`` in nu N, at T = omega_n t. With ``law="displacement-control", alpha=0.1`` or
    ``law="velocity-control", beta=0.1`` it is the exact motion of the softened law.

    ``exact("bar-impact", t, L=10, right={"L": 20})`` is the wave solution of two elastic bars, or of a bar and a wall
    (``right="wall"``): ``r`` in c T_I/2, ``rdot`` in c and ``force`` in F0, at t in T_I; at a jump the value after it.

    The exact motion of a structure is ``solve(study).references``.

    :param problem: ``friction-oscillator`` or ``bar-impact``
    :param t: times >= 0 that do not decrease, of shape (n,)
    :param parameters: parameters of the problem, apart from time step and duration
    :returns: channels by name, each of shape (n,)
    :raises SlipgapError: mistakes
    """
    import numpy

    times = numpy.ascontiguousarray(t, dtype=numpy.float64)
    if times.ndim != 1:
        raise SlipgapError(f"t: must have one dimension, got {times.ndim}")
    found = _slipgap.exact(problem, times.tobytes(), parameters)
    # Nobody else has them: the caller may change them.
    return {name: values.copy() for name, values in found.items()}


def calibrate(
    study: str | PathLike[str] | Mapping[str, Any],
    *,
    out: str | PathLike[str] | None = None,
    jobs: int | None = None,
    set: Mapping[str, Any] | None = None,
    progress: bool | Callable[[int, int], object] | None = None,
    allow_programs: bool = False,
) -> Calibration:
    """Find the values of free parameters with which a study comes nearest to what was measured.

    The key ``calibrate`` of the study has the free parameters with their ranges and the metric to minimise. Each alternative, such
    as a law, has a search of its own. Numbers are those of ``slipgap calibrate``, for any number of threads. Ctrl-C ends the search.

    :param study: a study as in :func:`run`
    :param out: folder for the files of the program, as in :func:`run`; if left out, nothing is written
    :param jobs: number of threads; if left out, one for each core
    :param set: parameters to set, as in :func:`run`
    :param progress: as in :func:`run`; the number of all cases is the most that the search takes
    :param allow_programs: whether the programs of others that the study names may be started, as ``--allow-programs`` does
    :returns: the alternatives, the smallest misfit first, with best values and intervals
    :raises SlipgapError: a study with mistakes or without ``calibrate``, or a file that cannot be read or written
    """
    with reporter(progress) as report:
        return _slipgap.calibrate(study, out, jobs, set, report, allow_programs)


def recommend(
    study: str | PathLike[str] | Mapping[str, Any],
    *,
    jobs: int | None = None,
    set: Mapping[str, Any] | None = None,
    allow_programs: bool = False,
) -> Recommendation:
    """Find the cheapest candidate of a study that keeps metrics within tolerances.

    :param study: a study as in :func:`run` with the key ``recommend``; ``"friction-oscillator"`` and ``"bar-impact"`` are studies of
        the program, as of ``slipgap recommend``
    :param jobs: number of threads; if left out, one for each core
    :param set: parameters to set, as in :func:`run`
    :param allow_programs: whether the programs of others that the study names may be started, as ``--allow-programs`` does
    :returns: the candidates, the cheapest first, and the recommended one
    :raises SlipgapError: a study with mistakes or without ``recommend``, or a file that cannot be read
    """
    return _slipgap.recommend(study, jobs, set, allow_programs)


def claims(
    ledgers: str | PathLike[str] = "claims",
    *,
    out: str | PathLike[str] | None = None,
    jobs: int | None = None,
    allow_programs: bool = False,
) -> list[Claim]:
    """Test the statements of ledgers by their studies.

    :param ledgers: path of a ledger, or of a folder of them
    :param out: folder with results of studies, whose cases are not computed again; nothing else is written there
    :param jobs: number of threads; if left out, one for each core
    :param allow_programs: whether the programs of others that the studies name may be started, as ``--allow-programs`` does; if not,
        ledgers of a folder that need them are left out
    :returns: each statement with its verdict and the values of its readings
    :raises SlipgapError: a ledger or a study with mistakes
    """
    return _slipgap.claims(ledgers, out, jobs, allow_programs)


def schema() -> dict[str, Any]:
    """Return the JSON schema of study files."""
    parsed: dict[str, Any] = json.loads(_slipgap.schema())
    return parsed


def compare(
    a: str | PathLike[str], b: str | PathLike[str], tolerance: float = 0.0
) -> Comparison:
    """Compare two folders of results, of one study or of several.

    Cases are the same if all their parameters are the same.

    :param tolerance: largest difference to ignore, relative to the larger of the two values
    :raises SlipgapError: a folder without results
    """
    return _slipgap.compare(a, b, tolerance)
