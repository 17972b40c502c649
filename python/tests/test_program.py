"""Functions that run the program or test claims."""

import json
import math
import os
import re
import struct
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


def _on_a_terminal(words: list[str], folder: Path, columns: int, **environment: str) -> str:
    """What a program writes to a terminal of so many columns."""
    fcntl, termios = pytest.importorskip("fcntl"), pytest.importorskip("termios")
    here, there = os.openpty()
    fcntl.ioctl(there, termios.TIOCSWINSZ, struct.pack("HHHH", 40, columns, 0, 0))
    variables = {name: value for name, value in os.environ.items() if name not in ("NO_COLOR", "CLICOLOR_FORCE", "TERM")}
    with subprocess.Popen(words, stdin=there, stdout=there, stderr=there, cwd=folder, env={**variables, "TERM": "xterm", **environment}) as process:
        os.close(there)
        written = b""
        try:
            while chunk := os.read(here, 65536):
                written += chunk
        except OSError:
            # The other end is closed.
            pass
    os.close(here)
    assert process.returncode == 0
    return written.decode()


def test_a_terminal_has_colour_progress_and_lines_that_fit(program: str, tmp_path: Path) -> None:
    (tmp_path / "s.json").write_text(json.dumps({**STUDY, "parameters": {**STUDY["parameters"], "dT": 1.2}}))
    words = [program, "run", "s.json"]
    text = _on_a_terminal(words, tmp_path, 60)
    lines = [line.rsplit("\r", 1)[-1].removeprefix("\x1b[2K") for line in text.replace("\r\n", "\n").splitlines()]
    first = next(i for i, line in enumerate(lines) if "warning:" in line)
    assert lines[first].startswith("\x1b[33m\x1b[1mwarning:\x1b[0m s.json: 2 of 2 cases have a step")
    plain = [re.sub(r"\x1b\[\d+m", "", line) for line in lines[first:]]
    assert all(len(line) <= 60 for line in plain) and plain[1].startswith(" " * 9)
    # The metrics of a few cases, in rows or columns.
    assert any(line.split() == ["case", "0", "1"] for line in lines) and any(line.startswith("rms_error ") for line in lines)
    # Progress is there from reading on; how many cases are done when it is first drawn depends on time.
    many = {**STUDY["parameters"], "beta": {"range": [1, 300, 1]}, "dT": 0.005}
    (tmp_path / "many.json").write_text(json.dumps({**STUDY, "parameters": many}))
    assert re.search(r"reading studies.* \d+/300 cases.*300 cases run", _on_a_terminal([program, "run", "many.json"], tmp_path, 60), re.DOTALL)
    assert "\x1b[33m" not in _on_a_terminal(words, tmp_path, 60, NO_COLOR="1")
    # Elsewhere a warning is one line, and there is no table.
    done = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, check=True)
    assert "rms_error" not in done.stderr and "\x1b" not in done.stderr
    assert [line for line in done.stderr.splitlines() if "(warning long-step; case 0: beta = 0.5; " in line]


def test_a_terminal_shows_how_many_records_have_been_compared(program: str, tmp_path: Path) -> None:
    for record in range(60):
        rows = (f"{0.01 * i:.2f},{math.sin((0.02 + 0.001 * record) * i):.6f}" for i in range(4000))
        (tmp_path / f"r{record}.csv").write_text("\n".join(["Time (s), Acc. (m/s2)", *rows]))
    periods = [0.1 * (i + 1) for i in range(20)]
    choose = {"n": 3, "T": periods, "median": [1] * 20, "sigma": [0.5] * 20, "unit": "m/s2"}
    structure = {"masses": {"m": 1}, "springs": [{"between": ["ground", "m"], "k": 40}], "ground": {"record": {"files": "r*.csv", "choose": choose}}}
    study = {"problem": "structure", "parameters": {"dt": 0.01, "duration": 1}, "structure": {**structure, "units": "kg, N, m, s"}, "metrics": ["peak(m)"]}
    (tmp_path / "s.json").write_text(json.dumps(study))
    words = [program, "list", "s.json"]
    # Half a second of work, drawn each tenth of a second; then the spectra are in the cache.
    assert re.search(r"reading studies.*choosing records \d+/60", _on_a_terminal(words, tmp_path, 60, XDG_CACHE_HOME=str(tmp_path)), re.DOTALL)
    assert "record(3)" in _on_a_terminal(words, tmp_path, 60, XDG_CACHE_HOME=str(tmp_path))
