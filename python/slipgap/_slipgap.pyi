from collections.abc import Callable, Mapping
from os import PathLike
from pathlib import Path
from typing import Any, final

import numpy
from numpy.typing import NDArray

from ._records import Calibration, Check, Claim, Comparison, Failure, Recommendation, WarnedCases

__all__ = [
    "Animation",
    "Figure",
    "Results",
    "Solution",
    "Table",
    "__version__",
    "animate",
    "calibrate",
    "claims",
    "compare",
    "exact",
    "recommend",
    "run",
    "schema",
    "solve",
]

__version__: str

@final
class Table:
    @property
    def columns(self) -> list[str]: ...
    def __len__(self) -> int: ...
    def __getitem__(self, name: str, /) -> Any: ...
    def __arrow_c_schema__(self) -> object: ...
    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object: ...

@final
class Figure:
    @property
    def name(self) -> str: ...
    @property
    def svg(self) -> str: ...
    @property
    def png(self) -> bytes: ...
    @property
    def pdf(self) -> bytes: ...
    def save(self, file: str | PathLike[str]) -> None: ...
    def _repr_svg_(self) -> str: ...

@final
class Animation:
    @property
    def html(self) -> str: ...
    def save(self, file: str | PathLike[str]) -> None: ...
    def _repr_html_(self) -> str: ...

@final
class Results:
    @property
    def table(self) -> Table: ...
    @property
    def figures(self) -> dict[str, Figure]: ...
    @property
    def checks(self) -> list[Check]: ...
    @property
    def failures(self) -> list[Failure]: ...
    @property
    def warnings(self) -> list[WarnedCases]: ...
    @property
    def tables(self) -> dict[str, Table]: ...
    @property
    def parameters(self) -> list[str]: ...
    @property
    def metrics(self) -> list[str]: ...
    def plot(
        self,
        metric: str | None = None,
        x: str | None = None,
        y: str | None = None,
        *,
        case: int | None = None,
        ax: Any = None,
    ) -> Any: ...
    def solution(self, case: int) -> Solution: ...
    @property
    def manifest(self) -> dict[str, Any]: ...
    @property
    def folder(self) -> Path | None: ...

@final
class Solution:
    @property
    def case_number(self) -> int: ...
    @property
    def time(self) -> NDArray[numpy.float64]: ...
    @property
    def channels(self) -> dict[str, NDArray[numpy.float64]]: ...
    @property
    def references(self) -> dict[str, NDArray[numpy.float64]]: ...
    @property
    def measured(self) -> dict[str, NDArray[numpy.float64]]: ...
    @property
    def metrics(self) -> dict[str, float | None]: ...
    @property
    def parameters(self) -> dict[str, float | int | str]: ...

def run(
    study: str | PathLike[str] | Mapping[str, Any],
    out: str | PathLike[str] | None,
    jobs: int | None,
    set: Mapping[str, Any] | None,
    progress: Callable[[int, int], object] | None,
) -> Results: ...
def animate(
    study: str | PathLike[str] | Mapping[str, Any],
    cases: list[int],
    exact: bool,
    set: Mapping[str, Any] | None,
) -> Animation: ...
def solve(study: str | PathLike[str] | Mapping[str, Any], case: int) -> Solution: ...
def exact(
    problem: str, t: bytes, parameters: dict[str, Any]
) -> dict[str, NDArray[numpy.float64]]: ...
def calibrate(
    study: str | PathLike[str] | Mapping[str, Any],
    out: str | PathLike[str] | None,
    jobs: int | None,
    set: Mapping[str, Any] | None,
) -> Calibration: ...
def recommend(
    problem: str | PathLike[str] | Mapping[str, Any],
    targets: dict[str, Any],
    jobs: int | None,
    set: Mapping[str, Any] | None,
) -> Recommendation: ...
def schema() -> str: ...
def claims(
    ledgers: str | PathLike[str], out: str | PathLike[str] | None, jobs: int | None
) -> list[Claim]: ...
def compare(
    a: str | PathLike[str], b: str | PathLike[str], tolerance: float
) -> Comparison: ...
