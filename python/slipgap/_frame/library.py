"""Libraries that are not needed unless one asks for them."""

from __future__ import annotations

from importlib import import_module
from typing import Any


def library(name: str, what: str) -> Any:
    """The module of a library that something needs.

    :raises ImportError: it is not installed
    """
    try:
        return import_module(name)
    except ImportError as error:
        package = name.split(".")[0]
        raise ImportError(f"{what} needs {package}: pip install {package}") from error
