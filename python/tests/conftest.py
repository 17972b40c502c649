"""Places of the repository, and the program to compare with."""

import os
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def studies() -> Path:
    return ROOT / "studies"


@pytest.fixture(scope="session")
def program() -> str:
    """The program built from the same sources, see `make python-test`."""
    path = os.environ.get("SLIPGAP_PROGRAM", str(ROOT / "target" / "release" / "slipgap"))
    if not Path(path).is_file():
        pytest.fail(f"no program at {path}; run `make python-test`")
    return path
