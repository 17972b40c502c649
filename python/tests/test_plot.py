"""Figures of matplotlib have the numbers of the table and of the motion."""

import sys
from pathlib import Path
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


# The symbol of the program, for matplotlib.
X0 = r"$X$$_{\mathrm{0}}$"

POUNDING: dict[str, Any] = {
    "problem": "structure",
    "parameters": {"seed": {"range": [1, 5, 1]}, "gap": [0.02, 0.05], "dt": 0.005, "duration": 5},
    "structure": {
        "units": "t, kN, m, s",
        "masses": {"a|b": 100},
        "springs": [
            {"between": ["ground", "a"], "mass": 100, "period": 0.5, "ratio": 0.05},
            {"between": ["ground", "b"], "mass": 100, "period": 0.9, "ratio": 0.05},
        ],
        "contacts": {"joint": {"law": "impact", "between": ["a", "b"], "gap": "gap", "k": 5e3}},
        "ground": {"synthetic": "seed"},
    },
    "names": {"gap": ["clear distance", "m"]},
    "ensemble": "seed",
    "metrics": ["max(b - a)", "peak(joint.S)"],
}


@pytest.fixture(scope="module")
def pounding() -> slipgap.Results:
    pytest.importorskip("matplotlib")
    return slipgap.run(POUNDING)


def test_members_of_an_ensemble_are_thin_lines_about_their_median(pounding: slipgap.Results) -> None:
    [axes] = pounding.plot("peak(joint.S)").axes
    # The words and the units of the program.
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("Clear distance, m", "Peak contact force of joint, kN")
    *members, median = axes.lines
    gap, peaks = pounding.table["gap"], pounding.table["peak(joint.S)"]
    assert [line.get_ydata().tolist() for line in members] == [peaks[pounding.table["seed"] == seed].tolist() for seed in range(1, 6)]
    assert median.get_xdata().tolist() == [0.02, 0.05] and median.get_label() == "median of 5"
    assert median.get_ydata().tolist() == [numpy.median(peaks[gap == width]) for width in (0.02, 0.05)]
    assert all(line.get_linewidth() < median.get_linewidth() for line in members)
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["median of 5"]
    # Over the member itself there is a line for each gap.
    [axes] = pounding.plot("peak(joint.S)", x="seed").axes
    assert [line.get_label() for line in axes.lines] == ["Clear distance = 0.02 m", "Clear distance = 0.05 m"]


def test_channels_have_the_words_of_the_program(pounding: slipgap.Results) -> None:
    [axes] = pounding.plot("b - a", case=0).axes
    assert axes.get_ylabel() == "Displacement of b relative to a, m"
    assert axes.get_xlabel() == "Time $t$, s"


def test_pyplot_saves_the_figure(pounding: slipgap.Results, tmp_path: Path) -> None:
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure = pounding.plot("peak(joint.S)")
    assert pyplot.gcf() is figure
    pyplot.savefig(tmp_path / "by_pyplot.png")
    figure.savefig(tmp_path / "by_figure.png")
    assert (tmp_path / "by_pyplot.png").read_bytes() == (tmp_path / "by_figure.png").read_bytes()
    pyplot.close("all")


def test_titles_are_in_the_mathematics_of_matplotlib() -> None:
    from slipgap._show.titles import mathtext

    assert mathtext("*k*_I_, kN/m^2^") == r"$k$$_{\mathrm{I}}$, kN/m$^{\mathrm{2}}$"
    assert mathtext(r"a\_b, 5 $") == r"a_b, 5 \$"


@pytest.fixture(scope="module")
def results() -> slipgap.Results:
    pytest.importorskip("matplotlib")
    return slipgap.run(STUDY)


def test_a_metric_over_a_parameter_has_a_line_for_each_other_value(results: slipgap.Results) -> None:
    [axes] = results.plot("rms_error").axes
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("$β$", "rms error")
    x0, errors = results.table["x0"], results.table["rms_error"]
    assert len(axes.lines) == 2
    for line, release in zip(axes.lines, [5, 9], strict=True):
        assert line.get_label() == f"{X0} = {release}"
        assert line.get_xdata().tolist() == [0.5, 1, 2]
        assert line.get_ydata().tolist() == errors[x0 == release].tolist()


def test_a_metric_over_two_parameters_is_a_map(results: slipgap.Results) -> None:
    axes, bar = results.plot("rms_error", x="beta", y="x0").axes
    assert (axes.get_xlabel(), axes.get_ylabel(), bar.get_ylabel()) == ("$β$", X0, "rms error")
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
    assert labels == [f"$β$ = 0.5, {X0} = 5", f"$β$ = 1, {X0} = 9"]
    assert axes.lines[1].get_label() == f"exact, $β$ = 0.5, {X0} = 5"
    # Only what tells them apart.
    [axes] = results.plot("X", case=[0, 1]).axes
    assert axes.lines[0].get_label() == f"{X0} = 5"
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
    assert [line.get_label() for line in axes.lines] == [f"{X0} = 5", f"{X0} = 9"]


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
