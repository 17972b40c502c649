"""Functions that run the program or test claims."""

import json
import subprocess
from pathlib import Path
from typing import Any

import pytest

import slipgap

STUDY: dict[str, Any] = {
    "problem": "friction-oscillator",
    "parameters": {"law": "velocity-control", "beta": [0.5, 2], "dT": 0.5, "duration": 10},
    "checks": [{"metric": "rms_error", "max": 10}],
}


@pytest.fixture(autouse=True)
def in_path(program: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """The tests have the program that was built from the same sources, not an installed one."""
    monkeypatch.setattr("slipgap._program.program", lambda: program)


def test_a_report_is_a_page(tmp_path: Path) -> None:
    page = slipgap.report(STUDY, out=tmp_path, jobs=1, set={"dT": [0.5, 0.25]})
    assert page == tmp_path / "report.html"
    assert "Checks: 4 of 4 met" in page.read_text()


def test_a_case_is_explained_as_by_the_program(program: str, tmp_path: Path) -> None:
    file = tmp_path / "-s.json"
    file.write_text(json.dumps(STUDY))
    words = [program, "explain", str(file), "1"]
    lines = subprocess.run(words, capture_output=True, text=True, check=True).stdout.splitlines()
    found = slipgap.explain(file, 1).splitlines()
    # Times are measured anew.
    assert [line for line in found if "time" not in line] == [line for line in lines if "time" not in line]
    assert any(line.split()[:2] == ["beta", "2"] for line in found)
    assert slipgap.explain(STUDY).startswith("stdin: case 0 of 2")


def test_mistakes_are_exceptions(tmp_path: Path) -> None:
    with pytest.raises(slipgap.SlipgapError, match="case 9: stdin has cases 0 to 1"):
        slipgap.explain(STUDY, 9)
    with pytest.raises(slipgap.SlipgapError, match="no-such"):
        slipgap.report(tmp_path / "no-such.json", out=tmp_path)


def test_a_missing_program_is_an_exception(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.undo()
    monkeypatch.setattr("shutil.which", lambda *_, **__: None)
    with pytest.raises(slipgap.SlipgapError, match="neither in this environment nor in PATH"):
        slipgap.explain(STUDY)


def test_claims_have_verdicts(tmp_path: Path) -> None:
    (tmp_path / "s.json").write_text(json.dumps(STUDY))
    reading = {"reading": "r", "study": "s", "holds": True}
    claims = [
        {"id": "A", "where": "p", "says": "The error is small.", "quantity": "q",
         "readings": [{**reading, "expect": [{"metric": "rms_error", "max": 10}]}]},
        {"id": "B", "where": "p", "says": "The error is large.", "quantity": "q",
         "readings": [{**reading, "expect": [{"metric": "rms_error", "min": 10}]}]},
    ]  # fmt: skip
    (tmp_path / "l.json").write_text(json.dumps({"paper": "P", "studies": ".", "claims": claims}))
    found = slipgap.claims(tmp_path / "l.json")
    assert [(c.paper, c.id, c.verdict, c.changed) for c in found] == [
        ("P", "A", "holds", False),
        ("P", "B", "fails", True),
    ]
    assert "rms_error" in found[0].readings[0].found[0]
