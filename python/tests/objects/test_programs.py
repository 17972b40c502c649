"""Programs of others start only where the caller allows it."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import slipgap

PROGRAM = Path(__file__).parents[3] / "examples" / "programs" / "average_acceleration.py"


@pytest.fixture(autouse=True)
def in_path(program: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """The tests have the program that was built from the same sources, not an installed one."""
    monkeypatch.setattr("slipgap._program.program", lambda: program)


def study(folder: Path) -> Path:
    """Write a study whose program leaves a file when it starts."""
    code = f"open('started', 'w').close(); exec(open({str(PROGRAM)!r}).read())"
    text = {
        "problem": "structure",
        "programs": {"plain": {"command": [sys.executable, "-c", code]}},
        "parameters": {"method": ["average-acceleration", "plain"], "dt": 0.01, "duration": 2},
        "structure": {
            "masses": {"a": 1},
            "springs": [{"between": ["ground", "a"], "k": 40}],
            "start": {"a": {"u": 0.1}},
        },
        "metrics": ["peak(a.v)"],
    }
    path = folder / "s.json"
    path.write_text(json.dumps(text))
    return path


def ledger(folder: Path) -> Path:
    """Write a ledger whose claim needs the study."""
    reading = {"reading": "as run", "study": "s", "expect": [{"metric": "peak(a.v)", "min": 0}], "holds": True}
    claim = {"id": "A1", "where": "here", "says": "It moves.", "quantity": "peak", "readings": [reading]}
    path = folder / "claims.json"
    path.write_text(json.dumps({"paper": "A test", "studies": ".", "claims": [claim]}))
    return path


VERBS: list[Callable[..., Any]] = [
    lambda path, **more: slipgap.run(path, **more),
    lambda path, **more: slipgap.Study(path).run(**more),
    lambda path, **more: slipgap.solve(path, 1, **more),
    lambda path, **more: slipgap.Study(path).solve(1, **more),
    lambda path, **more: slipgap.animate(path, 1, **more),
    lambda path, **more: slipgap.report(path, out=path.parent / "out", **more),
    lambda path, **more: slipgap.claims(ledger(path.parent), **more),
]


@pytest.mark.parametrize("verb", VERBS)
def test_a_program_starts_only_where_it_is_allowed(verb: Callable[..., Any], tmp_path: Path) -> None:
    path = study(tmp_path)
    with pytest.raises(slipgap.SlipgapError, match="allow_programs=True"):
        verb(path)
    assert not (tmp_path / "started").exists()
    verb(path, allow_programs=True)
    assert (tmp_path / "started").exists()


@pytest.mark.parametrize("verb", [slipgap.recommend, slipgap.calibrate])
def test_searches_are_refused_too(verb: Callable[..., Any], tmp_path: Path) -> None:
    with pytest.raises(slipgap.SlipgapError, match="allow_programs=True"):
        verb(study(tmp_path))


def test_the_program_has_the_motion_of_the_method(tmp_path: Path) -> None:
    results = slipgap.run(study(tmp_path), allow_programs=True)
    own, other = results.table["peak(a.v)"]
    # Round-off of 200 steps.
    assert other == pytest.approx(own, rel=1e-12)
