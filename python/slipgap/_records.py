"""What results consist of."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

from ._show import html


class Check(NamedTuple):
    """A check of a study on a case: a metric and its limits."""

    case: int
    """Number of the case."""
    metric: str
    """Name of the metric or of the reduction."""
    value: float | None
    """Its value; None if it is undefined, which does not meet the check."""
    min: float | None
    """Smallest value allowed; None without one."""
    max: float | None
    """Largest value allowed; None without one."""
    met: bool
    """Whether the value is within the limits."""


class Failure(NamedTuple):
    """A case that could not be solved."""

    case: int
    """Number of the case."""
    reason: str
    """Why."""


class WarnedCases(NamedTuple):
    """The cases of a study with one kind of warning."""

    kind: str
    """Name of the kind, such as ``contact-gain``."""
    cases: int
    """Number of the cases."""
    case: int
    """Number of the first one."""
    parameters: dict[str, Any]
    """Its parameters that vary in the study."""
    message: str
    """What the cases have, as on stderr of the program."""
    is_note: bool
    """Whether it is a note: worth to know, and no reason to doubt the results."""


class Reading(NamedTuple):
    """One way to understand a statement, tested by a study."""

    name: str
    """What is tested."""
    holds: bool
    """Whether it holds."""
    recorded: bool
    """Whether the ledger says that it holds."""
    found: list[str]
    """The values of each expectation, in Markdown."""


class Claim(NamedTuple):
    """A statement of a paper or of the literature, with its verdict."""

    paper: str
    """Title of the ledger."""
    id: str
    """Short name."""
    statement: str
    """The statement."""
    verdict: str
    """``holds`` in every reading, ``holds if`` in some of them, ``fails`` in all."""
    readings: list[Reading]
    """The readings in the order of the ledger."""

    @property
    def changed(self) -> bool:
        """Whether a reading differs from what the ledger says."""
        return any(reading.holds != reading.recorded for reading in self.readings)


class Change(NamedTuple):
    """A metric that differs between two results of a study."""

    study: str
    """Its folder; empty if the compared folders are those of one study."""
    metric: str
    """Name of the metric."""
    cases: int
    """Number of cases that differ."""
    common: int
    """Number of cases that both have."""
    largest: float
    """Largest difference, relative to the larger of the two values; infinite if only one side has a value."""
    case: int | None
    """Number of its case on the first side."""
    first: float | None
    """The value of the first side."""
    second: float | None
    """The value of the second side."""


class Comparison(NamedTuple):
    """The differences of two folders of results."""

    equal: list[str]
    """Studies without a difference."""
    changes: list[Change]
    """Metrics that differ, study by study, the largest difference first."""
    notes: list[str]
    """Studies, cases and metrics that only one side has."""

    @property
    def same(self) -> bool:
        """Whether nothing differs."""
        return not self.changes and not self.notes


class Candidate(NamedTuple):
    """A candidate of a study with the key ``recommend``."""

    parameters: dict[str, Any]
    """Its chosen and free parameters."""
    cost: int
    """Its cost: steps times modes or nodes, times the sub-steps of the method, over all physical cases."""
    errors: dict[str, float]
    """By metric: the largest error over all physical cases."""
    reached: bool
    """Whether it keeps every metric within its tolerance."""
    converged: bool
    """Whether it also does in all further tests: half its step, the next finer mesh, neighbours, and fresh seeds."""
    warnings: tuple[str, ...]
    """What `slipgap run` warns of in its cases."""
    verdict: str
    """What becomes of it, such as "recommended" or "a contact may make energy"."""


class FreeParameter(NamedTuple):
    """A free parameter of a calibration with its best value."""

    best: float
    """The best value."""
    interval: tuple[float, float] | None
    """The 95 % interval; an end of the range that was searched where it is open there. None if the misfit has no probability."""
    within_tenth: tuple[float, float] | None
    """The values with misfits at most 10 % above the best; None without a profile."""
    state: str | None
    """Whether it is ``determined``, has ``only a smallest value`` or ``only a largest value``, or is ``not determined``."""
    profile: list[tuple[float, float]]
    """Values with the smallest misfit over all values of the other free parameters."""


class Alternative(NamedTuple):
    """An alternative of a calibration, such as a law."""

    name: str
    """The values by which it differs from the others; empty for a single one."""
    misfit: float | None
    """The smallest misfit; None if no case has a solution."""
    numerical: float | None
    """How much of the misfit the time step and the mesh may be; None if unknown."""
    rho_1: float | None
    """Correlation of neighbouring residuals: about 0 if they are noise; None for another metric than ``rms_error``."""
    parameters: dict[str, FreeParameter]
    """The free parameters by name."""
    unused: list[str]
    """Free parameters that it does not use."""
    correlation: list[list[float]] | None
    """Correlation of the parameters, in their order."""
    verdict: str
    """``best``; ``worse``, ``not told apart`` or ``unknown`` compared with the best one; or ``no solution``."""
    cases: int
    """Number of cases solved."""
    study: dict[str, Any] | None
    """The study with the best values, ready to run."""

    @property
    def values(self) -> dict[str, float]:
        """The best values by name."""
        return {name: parameter.best for name, parameter in self.parameters.items()}


class Calibration(NamedTuple):
    """The result of a calibration."""

    alternatives: list[Alternative]
    """The alternatives, the smallest misfit first."""
    sentences: list[str]
    """What the measurement does not determine, and which alternatives are told apart."""
    cases: int
    """Number of cases solved."""
    folder: Path | None
    """The folder with tables, figures and studies; None without one."""

    @property
    def best(self) -> Alternative:
        """The alternative with the smallest misfit."""
        return self.alternatives[0]

    def _repr_html_(self) -> str:
        return html.calibration(self)


class Recommendation(NamedTuple):
    """The candidates of a study, and the recommended one."""

    reached: bool
    """Whether a candidate is recommended."""
    best: Candidate | None
    """The recommended one, else the nearest one; None if no candidate is within the limits of energy."""
    front: list[Candidate]
    """The candidates, the cheapest first; of more than a thousand those that are better than all cheaper ones."""
    solved: int
    """Number of cases solved."""
    own_step: Candidate | None
    """The cheapest candidate that keeps every metric but is not recommended, if it costs less than the best; else None."""
    sentences: tuple[str, ...]
    """The answer in words, as `slipgap recommend` prints it."""
