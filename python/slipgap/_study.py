"""Studies as objects to build, change, run and save."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable, Iterator, Mapping
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _slipgap
from ._arrays import keep_beside
from ._errors import SlipgapError, UnknownNameError
from ._json import axes, pretty, put, read, text_of
from ._show import html
from ._table import Table

if TYPE_CHECKING:
    from ._results import Results
    from ._solution import Solution

DICT = "<dict>"
"""Name of a study without a file, in messages."""

NAME = "study"
"""Its folder of results."""


class Study(Mapping[str, Any]):
    """A study that does not change: ``with_`` and ``replace`` make another one.

    ``Study("studies/friction-fig5.json")`` reads a file, ``Study({...})`` takes a dict with the same content, ``Study('{...}')`` a
    text, and ``Study(problem="friction-oscillator", parameters={...})`` its keys. All functions of slipgap that take a study take
    it. It is a mapping of the keys of the study. Files in it, such as records, are relative to its ``folder``.

    >>> import slipgap
    >>> study = slipgap.Study(problem="friction-oscillator", parameters={"law": "velocity-control", "dT": 0.1, "duration": 9})
    >>> study.with_(beta=[0.5, 1, 2]).check()
    3
    """

    __slots__ = ("_data", "_file", "_text")
    _file: str
    _text: str

    def __init__(
        self, source: str | PathLike[str] | Mapping[str, Any] | None = None, /, **keys: Any
    ) -> None:
        """A study of a path, a text, a dict, or keys; keys are added to those of the source.

        :raises SlipgapError: a file that cannot be read, or a text that is no JSON object
        """
        self._data: dict[str, Any] | None = None
        self._file, self._text = _given(source)
        if keys:
            changed = self.replace(**keys)
            self._file, self._text, self._data = changed._file, changed._text, None

    @classmethod
    def _of(cls, file: str, text: str, settings: list[tuple[str, str]]) -> Study:
        """The study of a run: its file, its text, and the parameters that were set, each as JSON or as text."""
        study = cls()
        study.__setstate__((file, text))
        values: dict[str, Any] = {}
        for name, value in settings:
            try:
                values[name] = json.loads(value)
            except json.JSONDecodeError:
                values[name] = value
        return study.with_(values) if values else study

    def _content(self) -> dict[str, Any]:
        """The content of the text, which nobody changes."""
        if self._data is None:
            try:
                found = json.loads(self._text)
            except json.JSONDecodeError:
                found = None
            if not isinstance(found, dict):
                self.check()
                raise SlipgapError(f"{self._file}: a study must be a JSON object")
            self._data = found
        return self._data

    def _with(self, data: dict[str, Any]) -> Study:
        """A study of the same folder."""
        other = Study(data)
        path = Path(self._file)
        name = path.name if path.name.startswith("<") else f"<{path.stem}>"
        other._file = fspath(path.with_name(name))
        return other

    @property
    def name(self) -> str:
        """Its name: that of the file, or ``study``. Results of ``run(out=...)`` are in a folder of this name.

        Those of a study in a folder of ``studies`` are in the same folder of ``out``.
        """
        path = Path(self._file)
        changed = path.name.startswith("<")
        return NAME if path.name == DICT else path.name.strip("<>") if changed else path.stem

    @property
    def folder(self) -> Path:
        """The folder to which files of the study are relative."""
        return Path(self._file).parent

    @property
    def parameters(self) -> dict[str, Any]:
        """The parameters of the study, without those of its blocks."""
        return copy.deepcopy(self._content().get("parameters", {}))

    @property
    def axes(self) -> list[str]:
        """Names of the parameters that the study gives as axes, with a list or an object; others that vary follow by expressions."""
        return axes(self._content())

    def with_(self, parameters: Mapping[str, Any] | None = None, /, **more: Any) -> Study:
        """The study with parameters set, as ``--set`` does: in every block that gives one, or in all blocks if none does.

        A list, or an object such as ``{"geomspace": [0.1, 1, 5]}``, is an axis. A text is a name or an expression.

        >>> import slipgap
        >>> one = slipgap.Study(problem="bar-impact", parameters={"gamma": 1, "n": 4, "dt": 0.1, "duration": 2})
        >>> one.with_({"right.L": 20}, gamma=[0.1, 1]).parameters["right"]
        {'L': 20}

        :param parameters: names with values, for names with a point
        """
        data = copy.deepcopy(self._content())
        for name, value in {**(parameters or {}), **more}.items():
            put(data, name, json.loads(text_of({"parameters": {name: value}}))["parameters"][name])
        return self._with(data)

    def replace(self, **keys: Any) -> Study:
        """The study with other keys, such as ``metrics`` or ``figures``; None removes one."""
        data = {**self._content(), **json.loads(text_of(keys))}
        return self._with({key: value for key, value in data.items() if value is not None})

    def check(self) -> int:
        """Read the study as a run does, without computing anything.

        :returns: number of its cases
        :raises SlipgapError: all mistakes in it
        """
        return _slipgap.count(self)

    def expand(self) -> Table:
        """The cases of the study with their parameters, as a table; nothing is computed.

        :raises SlipgapError: all mistakes in it
        """
        return Table(_slipgap.expand(self))

    def run(
        self,
        *,
        out: str | PathLike[str] | None = None,
        jobs: int | None = None,
        progress: bool | Callable[[int, int], object] | None = None,
        allow_programs: bool = False,
    ) -> Results:
        """Run every case; see :func:`slipgap.run`."""
        from . import run

        return run(self, out=out, jobs=jobs, progress=progress, allow_programs=allow_programs)

    def solve(self, case: int = 0, *, allow_programs: bool = False) -> Solution:
        """Solve one case with its motion; see :func:`slipgap.solve`."""
        from . import solve

        return solve(self, case, allow_programs=allow_programs)

    def to_json(self) -> str:
        """The text of the study, as a file has it."""
        return pretty(self._content())

    def save(self, path: str | PathLike[str]) -> Study:
        """Write the study to a file. Files in it are relative to the folder of this file then.

        :returns: the study of the file
        """
        try:
            data = keep_beside(self._content(), Path(path))
            Path(path).write_text(pretty(data), encoding="utf-8")
        except OSError as error:
            raise SlipgapError(f"cannot write {path}: {error.strerror}", file=fspath(path)) from error
        return Study(path)

    def _source(self) -> tuple[str, str, str]:
        """File, name and text, as the compiled module takes it."""
        return self._file, self.name, self._text

    def __getitem__(self, key: str) -> Any:
        content = self._content()
        if key not in content:
            raise UnknownNameError.of("key", key, content)
        return copy.deepcopy(content[key])

    def __contains__(self, key: object) -> bool:
        return key in self._content()

    def __iter__(self) -> Iterator[str]:
        return iter(self._content())

    def __len__(self) -> int:
        return len(self._content())

    def __eq__(self, other: object) -> bool:
        """Whether the content is the same, and that files are relative to."""
        if not isinstance(other, Study):
            return NotImplemented
        return self.folder == other.folder and self._content() == other._content()

    def __hash__(self) -> int:
        return hash((self.folder, json.dumps(self._content(), sort_keys=True)))

    def __getstate__(self) -> tuple[str, str]:
        return self._file, self._text

    def __setstate__(self, state: tuple[str, str]) -> None:
        self._data = None
        self._file, self._text = state

    def __repr__(self) -> str:
        return f"<slipgap.Study {self.name}: {self._content().get('problem', 'without a problem')}>"

    def _repr_html_(self) -> str:
        return html.study(self)


def _given(source: str | PathLike[str] | Mapping[str, Any] | None) -> tuple[str, str]:
    """The file and the text of a study."""
    if isinstance(source, Study):
        return source._file, source._text
    if source is None or isinstance(source, Mapping):
        return DICT, text_of(source or {})
    if isinstance(source, str) and source.lstrip().startswith("{"):
        return DICT, source
    return fspath(source), read(Path(source))
