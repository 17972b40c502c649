"""Arrays and frames in a study: the files of records and measurements that they stand for."""

from __future__ import annotations

import shutil
from collections.abc import Mapping, Sequence
from hashlib import sha256
from math import isfinite
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

_folders: list[TemporaryDirectory[str]] = []


def with_files(study: Mapping[str, Any]) -> dict[str, Any]:
    """A study in which arrays as records, tables and measurements are files and lists.

    :raises ValueError: a record or a measurement with a number that is not finite, or a record with columns that are no motion
    """
    return {key: _measured(value) if key == "measured" else _member(key, value, key) for key, value in study.items()}


def _member(key: str, value: Any, path: str) -> Any:
    if key == "record" and _is_given(value):
        return _record("record", value, path)
    if key == "table" and _is_frame(value):
        return _columns(value)
    if key == "parameters" and isinstance(value, Mapping):
        return {name: axis(name, given, f"{path}.{name}") for name, given in value.items()}
    if isinstance(value, Mapping):
        return {name: _member(name, inner, f"{path}.{name}") for name, inner in value.items()}
    if isinstance(value, list) and value and isinstance(value[0], Mapping):
        return [_member("", inner, f"{path}[{i}]") for i, inner in enumerate(value)]
    return value


def axis(name: str, value: Any, path: str = "value") -> Any:
    """A parameter: each record of a list of them is a file."""
    if not isinstance(value, list | tuple) or not any(_is_motion(item) for item in value):
        return value
    return [_record(name, item, f"{path}[{i}]") if _is_motion(item) else item for i, item in enumerate(value)]


def _is_given(value: Any) -> bool:
    """Whether a record is no file, parameter or rule."""
    return not isinstance(value, str | Mapping) and hasattr(value, "__len__")


def _is_motion(value: Any) -> bool:
    """Whether a value of a parameter is a record: an array, a frame, or a pair of arrays."""
    pair = isinstance(value, tuple) and len(value) == 2 and all(hasattr(part, "__array__") for part in value)
    return pair or _is_frame(value) or (hasattr(value, "__array__") and getattr(value, "ndim", 0) > 0)


def _is_frame(value: Any) -> bool:
    return hasattr(value, "columns") and hasattr(value, "__array__")


def _columns(frame: Any) -> dict[str, list[float]]:
    """The columns of a frame of pandas or polars."""
    return {str(name): [float(x) for x in frame[name]] for name in frame.columns}


def _record(name: str, value: Any, path: str) -> str:
    """The file of a motion: times and accelerations, or accelerations alone, which need the key `dt`."""
    columns = _motion(value)
    lengths = {len(column) for column in columns}
    if len(columns) not in (1, 2) or len(lengths) != 1:
        raise ValueError(f"{path}: a record is times and accelerations of one length, (t, a), or accelerations with the key dt")
    for i, row in enumerate(zip(*columns, strict=True)):
        for x in row:
            if not isfinite(x):
                raise ValueError(f"{path}: number {i} is {x}, which a record does not have")
    return _file(name, ["t", "a"][-len(columns) :], columns)


def _motion(value: Any) -> list[list[float]]:
    """The columns of a motion."""
    if _is_frame(value):
        found = _columns(value)
        return [found["t"], found["a"]] if {"t", "a"} <= set(found) else list(found.values())
    index: Any = getattr(value, "index", None)
    if getattr(getattr(index, "dtype", None), "kind", "") == "f":
        # A series of pandas over time.
        return [[float(x) for x in index], [float(x) for x in value]]
    if getattr(value, "ndim", 1) == 2:
        across = value if value.shape[0] == 2 and value.shape[1] != 2 else value.T
        return [[float(x) for x in column] for column in across]
    if len(value) == 2 and all(hasattr(part, "__len__") for part in value):
        return [[float(x) for x in part] for part in value]
    return [[float(x) for x in value]]


def _measured(given: Any) -> Any:
    """What was measured, with a file if it has arrays or a frame in place of one."""
    if not isinstance(given, Mapping):
        return given
    if _is_frame(given.get("file")):
        found = {name: _finite(f"measured.file.{name}", values) for name, values in _columns(given["file"]).items()}
        return {**given, "file": _file("measured", list(found), list(found.values()))}
    columns = given.get("columns") if "file" not in given else None
    if not isinstance(columns, Mapping) or "time" not in given:
        return dict(given)
    arrays = [given["time"], *columns.values()]
    if any(isinstance(values, str | Mapping) for values in arrays):
        return dict(given)
    names = ["t", *(f"c{i}" for i in range(len(columns)))]
    paths = ["measured.time", *(f"measured.columns.{name}" for name in columns)]
    file = _file("measured", names, [_finite(path, values) for path, values in zip(paths, arrays, strict=True)])
    return {**given, "file": file, "time": "t", "columns": dict(zip(columns, names[1:], strict=True))}


def _finite(path: str, values: Any) -> list[float]:
    """A column of a measurement."""
    numbers = [float(x) for x in values]
    for i, x in enumerate(numbers):
        if not isfinite(x):
            raise ValueError(f"{path}[{i}] is {x}, which a measurement does not have")
    return numbers


def _file(name: str, names: Sequence[str], columns: Sequence[Sequence[float]]) -> str:
    """A table of these columns."""
    rows = zip(*columns, strict=True)
    content = "\n".join([",".join(names), *(",".join(map(repr, row)) for row in rows)]) + "\n"
    file = _folder() / f"{name}-{sha256(content.encode()).hexdigest()[:16]}.csv"
    if not file.exists():
        file.write_text(content, encoding="utf-8")
    return str(file)


def _folder() -> Path:
    """The folder of such files, which the end of Python removes."""
    if not _folders:
        _folders.append(TemporaryDirectory(prefix="slipgap-"))
    return Path(_folders[0].name)


def keep_beside(value: Any, path: Path) -> Any:
    """A study to save: the files of arrays are copied beside it."""
    if isinstance(value, dict):
        return {key: keep_beside(inner, path) for key, inner in value.items()}
    if isinstance(value, list):
        return [keep_beside(inner, path) for inner in value]
    if not isinstance(value, str) or Path(value).parent != _folder():
        return value
    copied = path.with_name(f"{path.stem}-{Path(value).name}")
    shutil.copyfile(value, copied)
    return copied.name
