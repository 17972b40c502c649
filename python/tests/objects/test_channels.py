"""Channels have all names that studies have, with the values that figures draw."""

from typing import Any

import numpy
import pytest

import slipgap
from slipgap import Study

# The force of the friction damper is that of the law; the support moves by a sine.
STUDY = Study(
    problem="structure",
    parameters={"dt": 0.01, "duration": 3, "rE": 0.001},
    structure={
        "masses": {"a": 2, "b": 1},
        "springs": [{"between": ["ground", "a"], "k": 100, "name": "column"}, {"between": ["a", "b"], "k": 70}],
        "contacts": {
            "stop": {"law": "impact", "between": ["b", "ground"], "gap": 0.05, "k": 1e3},
            "pad": {"law": "displacement-control", "between": ["ground", "a"], "nu": 0.1, "N": 20, "rE": "rE"},
        },
        "ground": {"sine": {"amplitude": 1, "omega": 5}},
    },
    metrics=["peak(b - a)", "peak(a.a_abs)", "peak(pad.slip)", "peak(energy.kinetic)"],
)


def test_names_of_studies_are_channels() -> None:
    solution = STUDY.solve()
    columns = list(solution.channels)
    assert "b - a" not in columns and "a.a_abs" not in columns
    channels, metrics = solution.channels, solution.metrics
    assert numpy.array_equal(channels["b - a"], channels["b.u"] - channels["a.u"])
    assert numpy.array_equal(channels["b-a"], channels["b - a"]) and numpy.array_equal(channels["a"], channels["a.u"])
    # The metrics are the largest values of the same channels, at the steps.
    for name in ["b - a", "a.a_abs", "pad.slip", "energy.kinetic"]:
        assert channels[name].shape == solution.time.shape and not channels[name].flags.writeable
        assert numpy.abs(channels[name]).max() == pytest.approx(metrics[f"peak({name})"], rel=1e-12)
        assert channels[name] is channels[name]
    # Newton's law: a_abs is a plus the acceleration of the ground.
    ground = numpy.sin(5 * solution.time)
    assert numpy.allclose(channels["ground"], ground, atol=1e-12)
    assert numpy.allclose(channels["a.a_abs"], channels["a.a"] + ground, atol=1e-9)
    # The columns of the history are as before.
    assert list(channels) == columns


def test_drawn_channels_are_there_at_once() -> None:
    drawn = STUDY.replace(figures=[{"name": "f", "kind": "history", "y": ["b - a", "pad.S"]}])
    expected = STUDY.solve().channels["b - a"]
    assert numpy.array_equal(drawn.solve().channels["b - a"], expected)
    assert numpy.array_equal(drawn.run().solution(0).channels["b - a"], expected)


def test_a_channel_of_one_of_many_cases() -> None:
    """The case alone has the same motion, whatever the study has beside it."""
    many = STUDY.with_(dt=[0.01, 0.02, 0.005], rE=[0.001, 0.01, 0.1, 1]).replace(
        reductions=["greatest peak(b - a) over rE"],
        figures=[{"name": "f", "kind": "metric", "x": "rE", "y": "peak(b - a)"}],
        checks=[{"metric": "peak(b - a)", "max": 1}],
    )
    solution = many.run().solution(7)
    assert solution.parameters["rE"] == 1 and solution.parameters["dt"] == 0.02
    largest = numpy.abs(solution.channels["a.a_abs"]).max()
    assert largest == pytest.approx(solution.metrics["peak(a.a_abs)"], rel=1e-12)


@pytest.mark.parametrize(
    ("name", "hint"),
    [
        ("stop.s", "did you mean stop.S?"),
        ("A.U", "did you mean a.u?"),
        ("a.q", "no node or contact 'a.q'"),
        ("tower", "channels are u, v, a and a_abs of nodes"),
        ("a - stop.S", "different dimensions"),
    ],
)
def test_mistakes_have_a_hint(name: str, hint: str) -> None:
    with pytest.raises(KeyError) as caught:
        STUDY.solve().channels[name]
    assert isinstance(caught.value, slipgap.SlipgapError)
    assert str(caught.value).startswith(f"no channel {name}") and hint in str(caught.value)


def test_other_problems_have_their_channels() -> None:
    parameters: dict[str, Any] = {"law": "velocity-control", "beta": 1, "dT": 0.5, "duration": 5}
    flat = slipgap.solve({"problem": "friction-oscillator", **parameters})
    for solution in (flat, Study(problem="friction-oscillator", parameters=parameters).solve()):
        with pytest.raises(KeyError, match="no channel x; did you mean X?"):
            solution.channels["x"]
        with pytest.raises(KeyError, match="no channel force; there are T, X, V, S"):
            solution.channels["force"]
        assert solution.channels.get("force") is None and "force" not in solution.channels
