"""What notebooks show has the values, and is well-formed."""

from typing import Any
from xml.etree import ElementTree

import numpy
import pytest

import slipgap
from slipgap import Study
from slipgap._show.curves import curves

STUDY = Study(
    problem="friction-oscillator",
    title="A & B",
    parameters={"law": "velocity-control", "beta": [0.5, 1, 2], "x0": {"linspace": [5, 9, 10]}, "dT": 0.5, "duration": 10},
    checks=[{"metric": "rms_error", "max": 0.04}],
    figures=[{"name": "error", "kind": "metric", "x": "beta", "y": "rms_error", "by": "x0"}],
)


def parsed(thing: Any) -> tuple[str, ElementTree.Element]:
    """The words and the tree of what a notebook shows."""
    root = ElementTree.fromstring(f"<div>{thing._repr_html_()}</div>")
    return " ".join("".join(root.itertext()).split()), root


def pictures(root: ElementTree.Element) -> int:
    return len(root.findall(".//{http://www.w3.org/2000/svg}svg"))


def cells(root: ElementTree.Element) -> list[list[str]]:
    return [[cell.text or "" for cell in row] for row in root.iter("tr")]


def test_results() -> None:
    results = STUDY.run()
    text, root = parsed(results)
    met = sum(check.met for check in results.checks)
    assert "30 cases" in text and f"{met} of 30 checks met" in text and 0 < met < 30
    first = next(check for check in results.checks if not check.met)
    assert f"case {first.case}: rms_error = {first.value:.6g}, allowed .. 0.04" in text
    head, *rows = cells(root)
    assert head[:3] == ["case", "beta", "x0"] and "rms_error" in head
    assert rows[0][head.index("rms_error")] == f"{results.table['rms_error'][0]:.6g}"
    assert [row[0] for row in rows[:10]] == ["0", "1", "2", "3", "4", "5", "…", "27", "28", "29"]
    assert ["law", "velocity-control"] in rows and pictures(root) == 1


def test_warnings_and_failures() -> None:
    bars = {"gamma": 1, "n": 2, "dt": 0.25, "gap": [0, 2, 3], "duration": 1, "L": 10, "E": 100, "V0": 0.1}
    with pytest.warns(slipgap.SlipgapWarning):
        results = slipgap.run({"problem": "bar-impact", "parameters": bars})
    text, _ = parsed(results)
    assert "Warnings" in text and all(warned.message in text for warned in results.warnings)
    beyond = {"law": "velocity-control", "beta": 1e-300, "dT": [0.1, 0.2], "x0": 1e308, "duration": 1}
    unsolved = slipgap.run({"problem": "friction-oscillator", "parameters": beyond})
    assert unsolved.failures == [] or unsolved.failures[0].reason in parsed(unsolved)[0]


def test_tables_and_studies() -> None:
    table = STUDY.run().table
    text, root = parsed(table)
    assert "30 rows" in text and cells(root)[1][0] == "0"
    text, root = parsed(STUDY)
    assert "A & B" in text and ["beta", "[0.5, 1, 2]"] in cells(root) and "with checks, figures" in text


def test_solutions() -> None:
    solution = STUDY.solve(3)
    text, root = parsed(solution)
    assert repr(solution)[1:-1] in text and pictures(root) == 1
    assert ["rms_error", f"{solution.metrics['rms_error']:.6g}"] in cells(root)
    assert ["x0", f"{solution.parameters['x0']:.6g}"] in cells(root)


def test_calibrations() -> None:
    truth = Study(
        problem="structure",
        parameters={"dt": 0.01, "duration": 3, "k": 30},
        structure={"masses": {"a": 1}, "springs": [{"between": ["ground", "a"], "k": "k"}], "start": {"a": {"v": 1}}},
        metrics=["peak(a)"],
    )
    motion = truth.solve()
    seen: list[tuple[int, int]] = []
    found = slipgap.calibrate(
        truth.replace(
            metrics=["rms_error(a.u, measured)"],
            measured={"time": motion.time, "columns": {"a.u": motion.channels["a.u"]}},
            calibrate={"k": {"log": [10, 100]}, "minimise": "rms_error(a.u, measured)", "cases": 400},
        ),
        progress=lambda done, total: seen.append((done, total)),
    )
    assert found.best.values["k"] == pytest.approx(30, rel=1e-4)
    assert seen[-1] == (400, 400) and [done for done, _ in seen] == sorted(done for done, _ in seen)
    text, root = parsed(found)
    head, row = cells(root)[:2]
    assert head[:4] == ["alternative", "misfit", "verdict", "k"] and float(row[3]) == pytest.approx(30, rel=1e-4)
    assert all(" ".join(sentence.split()) in text for sentence in found.sentences) and pictures(root) == 1


def test_a_long_curve_keeps_its_extremes() -> None:
    t = numpy.linspace(0, 1, 100_001)
    x = numpy.sin(400 * t)
    x[54321] = 7
    root = ElementTree.fromstring(curves({"x": (t, x)}, "t", "x (m)"))
    texts = [element.text for element in root.iter("{http://www.w3.org/2000/svg}text")]
    assert "7" in texts and "x (m)" in texts
    [line] = root.iter("{http://www.w3.org/2000/svg}polyline")
    points = line.attrib["points"].split()
    assert len(points) < 2000 and min(float(point.split(",")[1]) for point in points) == 18
    assert curves({"x": (t[:0], x[:0])}, "t", "x") == ""
    assert "<svg" in curves({"x": (t, 0 * t)}, "t", "x")
