"""Ctrl-C, other threads, progress, forks."""

import os
import signal
import subprocess
import sys
import threading
import time
from types import SimpleNamespace
from typing import Any

import pytest

import slipgap
from slipgap._run.progress import reporter

# Minutes of computing.
LONG: dict[str, Any] = {
    "problem": "friction-oscillator",
    "parameters": {
        "law": "displacement-control",
        "alpha": {"linspace": [0.1, 5, 1000]},
        "dT": {"geomspace": [1e-4, 1e-3, 100]},
        "duration": 25,
    },
}
SHORT: dict[str, Any] = {
    "problem": "friction-oscillator",
    "parameters": {"law": "displacement-control", "alpha": 0.1, "dT": 0.1, "duration": 25},
}

INTERRUPTED = """
import os, pathlib, signal, threading, time
import slipgap
LONG = {LONG!r}
def kill():
    time.sleep(1)
    global sent
    sent = time.monotonic()
    os.kill(os.getpid(), signal.SIGINT)
threading.Thread(target=kill, daemon=True).start()
try:
    slipgap.run(LONG, {arguments})
except KeyboardInterrupt:
    print("after", time.monotonic() - sent)
# The sweep that was being computed ends soon after, and its partial files are removed.
for _ in range(300):
    if not list(pathlib.Path().rglob("*.partial")):
        break
    time.sleep(0.1)
print(len(slipgap.run({SHORT!r}).table), "case")
"""


@pytest.mark.parametrize("arguments", ["", "jobs=1", "out='.'"])
def test_interrupt_ends_a_run(arguments: str, tmp_path: Any) -> None:
    """The run ends long before the minutes that it needs, files are complete, and the next run works."""
    code = INTERRUPTED.format(LONG=LONG, SHORT=SHORT, arguments=arguments)
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=60, cwd=tmp_path
    )
    lines = done.stdout.splitlines()
    assert len(lines) == 2 and lines[0].startswith("after ") and lines[1] == "1 case", done
    print(done.stdout)
    assert list(tmp_path.rglob("*.partial")) == []


def test_other_threads_go_on() -> None:
    count, stop = 0, threading.Event()

    def work() -> None:
        nonlocal count
        while not stop.is_set():
            count += 1
            time.sleep(0.001)

    thread = threading.Thread(target=work)
    thread.start()
    ended: list[int] = []

    def progress(done: int, total: int) -> None:
        if done > 0 and count > 5:
            ended.append(count)
            raise InterruptedError

    # A progress function that raises ends the run, too.
    with pytest.raises(InterruptedError):
        slipgap.run(LONG, progress=progress)
    stop.set()
    thread.join()
    assert ended and ended[0] > 5


def test_progress_counts_the_cases() -> None:
    seen: list[tuple[int, int]] = []
    study = {"problem": "friction-oscillator", "parameters": {**SHORT["parameters"], "alpha": [0.1, 0.2, 0.3]}}
    slipgap.run(study, progress=lambda done, total: seen.append((done, total)))
    assert seen[-1] == (3, 3)
    assert [done for done, _ in seen] == sorted(done for done, _ in seen)


class Bar:
    """What the package uses of tqdm."""

    def __init__(self, total: int, unit: str, delay: float) -> None:
        self.total, self.n, self.closed = total, 0, False
        bars.append(self)

    def update(self, more: int) -> None:
        self.n += more

    def close(self) -> None:
        self.closed = True


bars: list[Bar] = []


def test_a_bar_of_tqdm_counts_the_cases(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "tqdm.auto", SimpleNamespace(tqdm=Bar))
    bars.clear()
    with reporter(True) as report:
        assert report is not None and bars == []
        for done in [0, 4, 9]:
            report(done, 9)
    [bar] = bars
    assert (bar.total, bar.n, bar.closed) == (9, 9, True)
    with reporter(None) as report:
        assert report is None
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    with reporter(True) as report, pytest.raises(ImportError, match="pip install tqdm"):
        assert report is not None
        report(0, 9)


def test_no_bar_without_a_terminal(capfd: pytest.CaptureFixture[str]) -> None:
    slipgap.run(SHORT)
    slipgap.run(SHORT, progress=False)
    assert capfd.readouterr() == ("", "")


def test_runs_of_several_threads_at_once() -> None:
    expected = slipgap.run(SHORT).table["rms_error"].tolist()
    found: list[Any] = []
    work = lambda: found.append(slipgap.run(SHORT).table["rms_error"].tolist())  # noqa: E731
    threads = [threading.Thread(target=work) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [expected] * 8


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork")
@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
def test_a_forked_process_has_its_own_threads() -> None:
    expected = slipgap.run(SHORT).table["rms_error"].tolist()
    child = os.fork()
    if child == 0:
        same = slipgap.run(SHORT).table["rms_error"].tolist() == expected
        os._exit(0 if same else 1)
    ended, status = 0, 0
    for _ in range(300):
        ended, status = os.waitpid(child, os.WNOHANG)
        if ended:
            break
        time.sleep(0.1)
    else:
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
    assert ended == child and status == 0
