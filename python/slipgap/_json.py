"""The JSON of studies: arrays and matrices of other libraries in it, and parameters to set."""

from __future__ import annotations

import json
from collections.abc import Mapping
from math import isfinite
from os import PathLike, fspath
from pathlib import Path
from typing import Any

from ._arrays import axis, with_files
from ._errors import SlipgapError


def dumps(value: object) -> str:
    """The JSON of a study or of a value in it."""
    if isinstance(value, Mapping):
        value = with_files(value)
    try:
        # A list of `set`.
        value = axis("value", value) if isinstance(value, list | tuple) else value
        return json.dumps(value, default=_plain, allow_nan=False)
    except ValueError as error:
        found = _not_finite(value, "")
        raise ValueError(f"{found}, which JSON does not have" if found else str(error)) from None


def _plain(value: object) -> object:
    """What JSON has for numbers, arrays and matrices of NumPy and SciPy, other mappings and paths."""
    to_coordinates = getattr(value, "tocoo", None)
    if callable(to_coordinates):
        matrix = to_coordinates()
        matrix.sum_duplicates()
        return _matrix_market(matrix.shape, matrix.row, matrix.col, matrix.data)
    if getattr(value, "ndim", 0) == 2 and _has_numbers(value):
        rows, columns = value.nonzero()  # type: ignore[attr-defined]
        entries = value[rows, columns]  # type: ignore[index]
        return _matrix_market(value.shape, rows, columns, entries)  # type: ignore[attr-defined]
    to_list = getattr(value, "tolist", None)
    if callable(to_list):
        dtype = getattr(value, "dtype", None)
        # Numbers of more digits than those of Python give themselves.
        longer = getattr(dtype, "kind", "") == "f" and getattr(dtype, "itemsize", 0) > 8
        return value.astype(float).tolist() if longer else to_list()  # type: ignore[attr-defined]
    if isinstance(value, Mapping):
        return dict(value)
    if isinstance(value, PathLike):
        return fspath(value)
    raise TypeError(f"a study cannot contain {type(value)}")


def _has_numbers(array: Any) -> bool:
    """Whether an array of NumPy has numbers: a table of names is a list of lists in a study."""
    return getattr(getattr(array, "dtype", None), "kind", "") in "fiu"


def _matrix_market(shape: tuple[int, int], rows: Any, columns: Any, entries: Any) -> str:
    """The content of a Matrix Market file of a matrix by coordinates."""
    each = zip(rows.tolist(), columns.tolist(), entries.tolist(), strict=True)
    lines = [f"{i + 1} {j + 1} {float(x)!r}" for i, j, x in each]
    header = "%%MatrixMarket matrix coordinate real general"
    return "\n".join([header, f"{shape[0]} {shape[1]} {len(lines)}", *lines])


def pretty(data: dict[str, Any]) -> str:
    """The text of a study file."""
    return json.dumps(data, indent=2, ensure_ascii=False) + "\n"


def text_of(value: Mapping[str, Any]) -> str:
    """The JSON of a dict; numbers that JSON does not have are mistakes."""
    try:
        return dumps(value)
    except ValueError as error:
        raise SlipgapError(str(error)) from None


def _not_finite(value: object, path: str) -> str | None:
    """The first number that is not finite, with its key and index."""
    if isinstance(value, float) or (_has_numbers(value) and getattr(value, "ndim", 1) == 0):
        return None if isfinite(value) else f"{path} is {value}"  # type: ignore[arg-type]
    if isinstance(value, Mapping):
        members = ((f"{path}.{key}" if path else str(key), member) for key, member in value.items())
    elif isinstance(value, list | tuple):
        members = ((f"{path}[{i}]", item) for i, item in enumerate(value))
    elif getattr(value, "ndim", 0) > 0:
        members = ((f"{path}[{i}]", item) for i, item in enumerate(value.tolist()))  # type: ignore[attr-defined]
    else:
        return None
    return next((found for key, member in members if (found := _not_finite(member, key))), None)


def read(path: Path) -> str:
    """The text of a file."""
    try:
        return path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        why = getattr(error, "strerror", None) or "not UTF-8"
        raise SlipgapError(f"cannot read {path}: {why}", file=fspath(path)) from error


def put(data: dict[str, Any], name: str, value: Any) -> None:
    """Set a parameter in every block that gives it, or in all blocks if none does, as ``--set`` does."""
    blocks, keys = _blocks(data), name.split(".")
    given = [block for block in blocks if _gives(block, keys)]
    for block in given or blocks:
        _put(block, keys, value)


def axes(data: dict[str, Any]) -> list[str]:
    """Names of the parameters that are lists or objects, and of those in objects."""
    found: dict[str, None] = {}
    for block in _blocks(data):
        for name, value in block.items():
            inner = value if isinstance(value, dict) else {}
            names = [f"{name}.{key}" for key, member in inner.items() if isinstance(member, list | dict)]
            found.update(dict.fromkeys([name, *names] if isinstance(value, list | dict) else []))
    return list(found)


def _blocks(data: dict[str, Any]) -> list[dict[str, Any]]:
    """The parameters of a study and of its blocks."""
    inner = data.get("blocks", [])
    inner = [block.get("parameters") for block in inner] if isinstance(inner, list) else []
    outer = data.get("parameters") if inner else data.setdefault("parameters", {})
    return [block for block in (outer, *inner) if isinstance(block, dict)]


def _gives(block: dict[str, Any], keys: list[str]) -> bool:
    for key in keys:
        if not isinstance(block, dict) or key not in block:
            return False
        block = block[key]
    return True


def _put(block: dict[str, Any], keys: list[str], value: Any) -> None:
    for key in keys[:-1]:
        block = block.setdefault(key, {})
        if not isinstance(block, dict):
            raise SlipgapError(f"{'.'.join(keys)}: {key} is not an object")
    block[keys[-1]] = value
