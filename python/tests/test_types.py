"""mypy accepts the package, its stubs and these tests in strict mode; the stubs are those of the compiled module."""

import subprocess
import sys
from pathlib import Path

import pytest

import slipgap

HERE = Path(__file__).resolve().parent


def run(*command: object) -> str:
    done = subprocess.run(
        [sys.executable, "-m", *map(str, command)], capture_output=True, text=True, cwd=HERE
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_strict_types() -> None:
    pytest.importorskip("mypy")
    run("mypy", "--strict", "--ignore-missing-imports", "-p", "slipgap")
    run("mypy", "--strict", "--ignore-missing-imports", *sorted(HERE.rglob("*.py")))


def test_stubs_are_those_of_the_module(tmp_path: Path) -> None:
    pytest.importorskip("mypy")
    settings = HERE.parent / "pyproject.toml"
    # pandas, which has no types, is imported for types only.
    (tmp_path / "allowed").write_text(r"slipgap\._\w+\.pandas")
    options = ["--ignore-disjoint-bases", "--ignore-unused-allowlist"]
    files = ["--mypy-config-file", settings, "--allowlist", tmp_path / "allowed"]
    run("mypy.stubtest", "slipgap", *options, *files)


def test_everything_public_is_described() -> None:
    for name in slipgap.__all__:
        thing = getattr(slipgap, name)
        if name != "__version__":
            assert thing.__doc__ and "Alias for field" not in thing.__doc__, name
