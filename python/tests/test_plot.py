"""Figures of matplotlib have the numbers of the table and of the motion."""

import sys
from typing import Any

import numpy
import pytest

import slipgap

STUDY: dict[str, Any] = {
    "problem": "friction-oscillator",
    "parameters": {
        "law": "velocity-control", "beta": [0.5, 1, 2], "x0": [5, 9], "dT": "pi/10", "duration": 10,
    },
}


@pytest.fixture(scope="module")
def results() -> slipgap.Results:
    pytest.importorskip("matplotlib")
    return slipgap.run(STUDY)


def test_a_metric_over_a_parameter_has_a_line_for_each_other_value(results: slipgap.Results) -> None:
    [axes] = results.plot("rms_error").axes
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("beta", "rms_error")
    x0, errors = results.table["x0"], results.table["rms_error"]
    assert len(axes.lines) == 2
    for line, release in zip(axes.lines, [5, 9], strict=True):
        assert line.get_label() == f"x0 = {release}"
        assert line.get_xdata().tolist() == [0.5, 1, 2]
        assert line.get_ydata().tolist() == errors[x0 == release].tolist()


def test_a_metric_over_two_parameters_is_a_map(results: slipgap.Results) -> None:
    axes, bar = results.plot("rms_error", x="beta", y="x0").axes
    assert (axes.get_xlabel(), axes.get_ylabel(), bar.get_ylabel()) == ("beta", "x0", "rms_error")
    drawn = numpy.ravel(axes.collections[0].get_array())
    assert sorted(drawn) == sorted(results.table["rms_error"])


def test_a_history_has_the_motion_and_the_exact_one(results: slipgap.Results) -> None:
    [axes] = results.plot("X", case=3).axes
    solution = results.solution(3)
    computed, exact = axes.lines
    assert numpy.array_equal(computed.get_xdata(), solution.time)
    assert numpy.array_equal(computed.get_ydata(), solution.channels["X"])
    assert numpy.array_equal(exact.get_ydata(), solution.references["X"])
    assert len(results.plot(case=3).axes) == len(solution.channels) - 1


def test_two_cases_are_in_one_plot(results: slipgap.Results) -> None:
    [axes] = results.plot("X", case=[0, 3]).axes
    one, one_exact, other, other_exact = axes.lines
    for case, line, exact in [(0, one, one_exact), (3, other, other_exact)]:
        solution = results.solution(case)
        assert numpy.array_equal(line.get_ydata(), solution.channels["X"])
        assert numpy.array_equal(exact.get_ydata(), solution.references["X"])
        assert line.get_color() == exact.get_color()
    assert one.get_color() != other.get_color()
    labels = [line.get_label() for line in axes.lines[::2]]
    assert labels == ["beta = 0.5, x0 = 5", "beta = 1, x0 = 9"]
    assert axes.lines[1].get_label() == "exact, beta = 0.5, x0 = 5"
    # Only what tells them apart.
    [axes] = results.plot("X", case=[0, 1]).axes
    assert axes.lines[0].get_label() == "x0 = 5"
    [axes] = results.plot("X", case=[2, 2]).axes
    assert axes.lines[0].get_label() == "case 2"
    assert len(results.plot(case=[0, 1]).axes) == 3
    for count in (0, 13):
        with pytest.raises(slipgap.SlipgapError, match="1 to 12 of them"):
            results.plot("X", case=range(count))


def test_axes_that_are_given_are_drawn_on(results: slipgap.Results) -> None:
    from matplotlib.figure import Figure

    figure = Figure()
    axes = figure.add_subplot()
    assert results.plot("rms_error", ax=axes) is figure
    assert len(axes.lines) == 2


def test_a_parameter_that_follows_tells_no_lines_apart() -> None:
    pytest.importorskip("matplotlib")
    parameters = {**STUDY["parameters"], "dT": "beta/10"}
    [axes] = slipgap.run({**STUDY, "parameters": parameters}).plot("rms_error", x="beta").axes
    assert [line.get_label() for line in axes.lines] == ["x0 = 5", "x0 = 9"]


def test_mistakes_name_what_is_allowed(results: slipgap.Results) -> None:
    with pytest.raises(slipgap.SlipgapError, match="no metric of the study; it has .*rms_error"):
        results.plot("rms")
    with pytest.raises(slipgap.SlipgapError, match="no parameter of the study; it has law"):
        results.plot("rms_error", x="gamma")
    with pytest.raises(slipgap.SlipgapError, match="no channel of the study; it has X"):
        results.plot("r", case=0)
    with pytest.raises(slipgap.SlipgapError, match="x0 varies"):
        results.plot("rms_error", x="beta", y="dT")


def test_without_matplotlib_an_error_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    results = slipgap.run(STUDY)
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    with pytest.raises(ImportError, match="pip install matplotlib"):
        results.plot("rms_error")
