"""Each function, against closed forms, printed numbers and the study language."""

import copy
import json
import math
import pickle
from pathlib import Path
from typing import Any

import numpy
import pytest

import slipgap

# [F] Fig. 5.
FIG5: dict[str, Any] = {
    "problem": "friction-oscillator",
    "law": "displacement-control",
    "alpha": 0.1,
    "dT": math.pi / 10,
    "duration": 8 * math.pi,
}


def test_solve_gives_the_number_of_the_paper() -> None:
    solution = slipgap.solve(FIG5)
    assert solution.time.shape == solution.channels["X"].shape == (81,)
    assert list(solution.channels) == ["T", "X", "V", "S"]
    assert list(solution.references) == ["T", "X", "V"]
    # The committed table of friction-fig5 has 0.0245 in four digits.
    assert solution.metrics["rms_error"] == pytest.approx(0.0245, abs=5e-5)
    assert solution.parameters["x0"] == 12.0 and "beta" not in solution.parameters
    # Sliding from 12 to -10 to 8: the exact half-cycles of Coulomb friction. Steps of pi/10 end there up to round-off.
    assert solution.references["X"][[0, 10, 20]].tolist() == pytest.approx([12, -10, 8], rel=1e-14)


def test_parameters_and_studies_give_the_same_solution() -> None:
    """The quick way without text, the text of a study, and expressions."""
    cases: list[dict[str, Any]] = [
        FIG5,
        FIG5 | {"x0": numpy.float64(-3), "initial_slip": "pulled"},
        FIG5 | {"law": "bouc-wen", "exponent": 2},
        {"problem": "bar-impact", "k_I": 10, "n": 10, "dt": 0.05, "duration": 1.5},
        {"problem": "bar-impact", "gamma": 0.1, "n": 4, "dt": 0.05, "duration": 2, "right": {"L": 20, "n": 8}},
        {"problem": "bar-impact", "gamma": 0.1, "n": 4, "dt": 0.05, "duration": 2, "right": "wall"},
    ]
    for given in cases:
        parameters = {key: value for key, value in given.items() if key != "problem"}
        quick = slipgap.solve(given)
        study = slipgap.solve({"problem": given["problem"], "parameters": parameters})
        assert quick.parameters == study.parameters
        assert quick.metrics == study.metrics
        for name in quick.channels:
            assert numpy.array_equal(quick.channels[name], study.channels[name]), name
    text = FIG5 | {"dT": "pi/10", "duration": "8*pi"}
    assert slipgap.solve(text).metrics == slipgap.solve(FIG5).metrics
    several = FIG5 | {"alpha": [0.1, 1, 5]}
    assert slipgap.solve(several, 1).metrics == slipgap.solve(FIG5 | {"alpha": 1}).metrics


@pytest.mark.parametrize(
    ("change", "path", "part"),
    [
        ({"alpha": -1}, "parameters.alpha", "must be > 0, got -1"),
        ({"alpha": True}, "parameters.alpha", "got true"),
        ({"beta": 1}, "parameters.beta", "does not apply to law displacement-control"),
        ({"lav": 1}, "parameters.lav", "law"),
        ({"law": "coulom"}, "parameters.law", "coulomb"),
        ({"dT": 100}, "parameters.dT", "at most duration"),
        ({"problem": "friction"}, "problem", "friction-oscillator"),
    ],
)
def test_mistakes_in_parameters_have_their_path(change: dict[str, Any], path: str, part: str) -> None:
    with pytest.raises(slipgap.SlipgapError) as caught:
        slipgap.solve(FIG5 | change)
    error = caught.value
    assert error.path == path and part in error.faults[0].message
    assert error.file is None and error.line is None and error.column is None
    assert str(error).startswith(f"{path}: ")


def test_mistakes_in_a_file_have_their_place(tmp_path: Path) -> None:
    file = tmp_path / "x.json"
    file.write_text('{ "problem": "friction-oscillator",\n  "parameters": { "law": "dahl", "alpha": [1, -2], "dT": 0, "duration": 9 } }')
    with pytest.raises(slipgap.SlipgapError) as caught:
        slipgap.run(file)
    error = caught.value
    assert (error.file, error.line, error.column) == (str(file), 2, 47)
    assert error.path == "parameters.alpha[1]"
    assert [fault.path for fault in error.faults] == ["parameters.alpha[1]", "parameters.dT"]
    assert f"{file}:2:47: parameters.alpha[1]: must be > 0, got -2" in str(error)
    with pytest.raises(slipgap.SlipgapError) as caught:
        slipgap.run(tmp_path / "none.json")
    assert caught.value.file == str(tmp_path / "none.json") and caught.value.faults == ()
    with pytest.raises(slipgap.SlipgapError, match="is a folder"):
        slipgap.run(tmp_path)
    with pytest.raises(slipgap.SlipgapError, match="set alpha=-1:1:7"):
        slipgap.run({"problem": "friction-oscillator", "parameters": {}}, set={"alpha": -1})
    with pytest.raises(slipgap.SlipgapError, match="jobs"):
        slipgap.run({"problem": "friction-oscillator", "parameters": {}}, jobs=0)
    for study in [3, None, ["x.json"]]:
        with pytest.raises(TypeError):
            slipgap.run(study)  # type: ignore[arg-type]
    for case in [-1, 1]:
        with pytest.raises(slipgap.SlipgapError, match="case: must be 0 to 0"):
            slipgap.solve(FIG5, case)


def test_a_dict_may_have_numbers_of_numpy_and_no_others() -> None:
    study = {"problem": "friction-oscillator", "parameters": {**FIG5, "alpha": numpy.array([0.1, 1.0])}}
    del study["parameters"]["problem"]  # type: ignore[attr-defined]
    assert len(slipgap.run(study).table) == 2
    with pytest.raises(TypeError, match="a study cannot contain"):
        slipgap.run({"problem": "friction-oscillator", "parameters": {"alpha": {1, 2}}})
    with pytest.raises(slipgap.SlipgapError, match=r"parameters\.alpha is nan, which JSON does not have"):
        slipgap.run({"problem": "friction-oscillator", "parameters": {"alpha": math.nan}})
    with pytest.raises(slipgap.SlipgapError, match=r"parameters\.alpha\[1\] is inf"):
        slipgap.run({"problem": "friction-oscillator", "parameters": {"alpha": numpy.array([0.1, math.inf])}})


def test_numbers_of_more_digits_are_rounded() -> None:
    parameters = {"alpha": numpy.array([0.1, 1.0], dtype=numpy.longdouble), "x0": numpy.longdouble(12)}
    study = {"problem": "friction-oscillator", "parameters": {"law": "displacement-control", "dT": 0.1, "duration": 3, **parameters}}
    assert len(slipgap.run(study).table) == 2


def test_exact_coulomb() -> None:
    t = numpy.linspace(0, 40, 401)
    exact = slipgap.exact("friction-oscillator", t, x0=12)
    assert set(exact) == {"X", "V", "S"}
    # Half-cycle m from (-1)^m (12 - 2m) around (-1)^m; rest within 1 of zero, after six half-cycles.
    m = numpy.minimum(numpy.floor(t / math.pi), 6)
    sign = (-1.0) ** m
    sliding = sign * (1 + (11 - 2 * m) * numpy.cos(t - m * math.pi))
    expected = numpy.where(t < 6 * math.pi, sliding, 0.0)
    # Both are cosines of numbers up to 19: some units of round-off of 12.
    assert numpy.abs(exact["X"] - expected).max() < 1e-13
    # Friction is at its limit against the motion, or holds the spring.
    assert exact["S"][t < 6 * math.pi - 0.01].tolist() == (-sign[t < 6 * math.pi - 0.01]).tolist()
    assert slipgap.exact("friction-oscillator", [])["X"].shape == (0,)


def test_exact_softened() -> None:
    # With S at its limit a peak P is followed by sqrt((P - 1)^2 + 4 alpha) - 1: 12 by 11 for alpha = 5.75.
    t = numpy.linspace(0, 2 * math.pi, 20001)
    law = {"law": "displacement-control", "alpha": 5.75, "initial_slip": "pulled"}
    exact = slipgap.exact("friction-oscillator", t, **law)
    # The sampled extreme misses the peak by at most half a step squared: 11 (1.6e-4)^2.
    assert exact["X"].min() == pytest.approx(-11, abs=3e-7)
    # X'' + X + tanh(X'/beta) = 0 from 12 by the classical Runge-Kutta method, whose error is some (dt/beta)^4 of a step.
    tanh = slipgap.exact("friction-oscillator", t, law="tanh", beta=0.1)
    state, dt = numpy.array([12.0, 0.0]), t[1]

    def rates(state: Any) -> Any:
        return numpy.array([state[1], -state[0] - math.tanh(state[1] / 0.1)])

    for _ in t[1:]:
        a = rates(state)
        b = rates(state + 0.5 * dt * a)
        c = rates(state + 0.5 * dt * b)
        d = rates(state + dt * c)
        state = state + dt / 6 * (a + 2 * b + 2 * c + d)
    assert tanh["X"][-1] == pytest.approx(state[0], abs=1e-9)


def test_exact_bars() -> None:
    # Equal bars touch for T_I with the force F0 and part with the speed at which they met.
    exact = slipgap.exact("bar-impact", [0.25, 0.5, 1.5, 2.0])
    assert exact["r"].tolist() == [0, 0, 1, 2]
    assert exact["rdot"].tolist() == [0, 0, 1, 1]
    assert exact["force"].tolist() == [1, 1, 0, 0]
    # On a wall the same; a gap delays it: r falls from the gap 0.4 by 2 in T_I.
    wall = slipgap.exact("bar-impact", [0.1, 0.5], right="wall", gap=0.4)
    assert wall["r"].tolist() == pytest.approx([0.2, 0], abs=1e-15)


def test_exact_refuses() -> None:
    refused: list[tuple[str, Any, dict[str, Any]]] = [
        ("structure", [0.0], {}),
        ("bar-impact", [0.0], {"dt": 1}),
        ("bar-impact", [0.0], {"L": -1}),
        ("friction-oscillator", [1.0, 0.5], {}),
        ("friction-oscillator", [-1.0], {}),
        ("friction-oscillator", [math.nan], {}),
        ("friction-oscillator", [[1.0]], {}),
        ("friction-oscillator", [1.0], {"x0": 0}),
    ]
    for problem, t, given in refused:
        with pytest.raises(slipgap.SlipgapError):
            slipgap.exact(problem, t, **given)


def falling(parameters: dict[str, Any], **more: Any) -> dict[str, Any]:
    """A mass that hits the ground."""
    contact = {"law": "law", "between": ["ground", "m"], "gap": 0.02, "k": "k", "k_h": "k_h"}
    structure = {
        "masses": {"m": 1},
        "springs": [{"between": ["ground", "m"], "k": 100, "c": 0.5}],
        "contacts": {"gap": contact},
        "start": {"m": {"v": "-v0"}},
    }
    return {"problem": "structure", "parameters": parameters, "structure": structure, **more}


def test_calibrate(tmp_path: Path) -> None:
    truth = {"dt": 0.002, "duration": 0.6, "law": "hertz", "k": 1, "k_h": 20000, "v0": 1}
    motion = slipgap.solve(falling(truth, metrics=["peak(m.u)"]))
    rows = [f"{t},{u}" for t, u in zip(motion.time, motion.channels["m.u"], strict=True)]
    (tmp_path / "test.csv").write_text("\n".join(["t,u", *rows]) + "\n")
    free = {"k": {"log": [100, 1e5]}, "k_h": {"log": [1e3, 1e6]}, "minimise": "rms_error(m.u, measured)"}
    study = falling(
        truth | {"law": ["impact", "hertz"], "k_h": 5000},
        measured={"file": "test.csv", "time": "t", "columns": {"m.u": "u"}},
        calibrate=free | {"cases": 1000},
    )
    file = tmp_path / "law.json"
    file.write_text(json.dumps(study))
    found = slipgap.calibrate(file, out=tmp_path / "out", jobs=1)
    assert [alternative.name for alternative in found.alternatives] == ["hertz", "impact"]
    best = found.best
    # The motion is that of the same steps: only the search limits the agreement.
    assert abs(best.values["k_h"] / 20000 - 1) < 1e-3
    assert best.unused == ["k"] and best.verdict == "best"
    worse = found.alternatives[1].misfit
    assert best.misfit is not None and worse is not None and worse > best.misfit
    assert found.folder == tmp_path / "out" / "law"
    assert (tmp_path / "out" / "law" / "best-hertz.json").exists()
    profile = best.parameters["k_h"].profile
    assert min(misfit for _, misfit in profile) >= best.misfit
    # The same without files and with two threads, and as a study.
    again = slipgap.calibrate(file, jobs=2)
    assert again.folder is None and again.best[:9] == best[:9]
    assert best.study is not None
    results = slipgap.run(best.study)
    assert results.table["rms_error(m.u, measured)"][0] == best.misfit
    with pytest.raises(slipgap.SlipgapError, match="no key"):
        slipgap.calibrate(falling(truth))


def test_recommend() -> None:
    found = slipgap.recommend("friction-oscillator", set={"x0": 12})
    assert found.reached and found.best is not None and found.best in found.front
    assert found.best.errors["rms_error"] <= 0.01
    # The parameters are those of a study: the motion ends a cycle after its rest.
    best = {"problem": "friction-oscillator", **found.best.parameters, "x0": 12, "duration": "8*pi"}
    assert slipgap.solve(best).metrics["rms_error"] == found.best.errors["rms_error"]
    with pytest.raises(slipgap.SlipgapError):
        slipgap.recommend("bars")


def test_recommend_of_a_study() -> None:
    study: dict[str, Any] = {
        "problem": "friction-oscillator",
        "parameters": {**FIG5, "dT": [0.2, 0.1, 0.05], "alpha": [0.1, 1]},
        "recommend": {"over": ["dT", "alpha"], "within": {"rms_error": 0.05}},
    }
    del study["parameters"]["problem"]
    found = slipgap.recommend(study, jobs=1)
    assert found.reached and found.best in found.front and len(found.front) == 6
    assert found == slipgap.recommend(study, jobs=2)
    table = slipgap.run(study).table
    rows = {(step, width): error for step, width, error in zip(table["dT"], table["alpha"], table["rms_error"])}
    for candidate in found.front:
        chosen = candidate.parameters
        assert candidate.errors["rms_error"] == rows[chosen["dT"], chosen["alpha"]]
    assert found.best is not None and found.best.errors["rms_error"] <= 0.05
    assert [candidate.cost for candidate in found.front] == sorted(candidate.cost for candidate in found.front)
    assert found.best.verdict == "recommended" and found.sentences[-1].startswith("Recommended: ")
    # The softening with alpha = 0.1 has an error of its own above 0.02, whatever the step.
    hard = {**study, "recommend": {"over": ["dT", "alpha"], "within": {"rms_error": 0.02}}}
    assert not slipgap.recommend(hard).reached
    with pytest.raises(slipgap.SlipgapError, match="recommend.over"):
        slipgap.recommend(study, set={"dT": 0.1})
    with pytest.raises(slipgap.SlipgapError, match="no key"):
        slipgap.recommend({key: study[key] for key in ["problem", "parameters"]})


def test_schema_names_all_problems() -> None:
    problems = slipgap.schema()["properties"]["problem"]["enum"]
    assert set(problems) == {"friction-oscillator", "bar-impact", "structure"}


def test_compare(tmp_path: Path) -> None:
    study: dict[str, Any] = {"problem": "friction-oscillator", "parameters": {**FIG5}}
    del study["parameters"]["problem"]
    slipgap.run(study, out=tmp_path / "a")
    slipgap.run(study, out=tmp_path / "b")
    assert slipgap.compare(tmp_path / "a", tmp_path / "b") == slipgap.Comparison(["study"], [], [])
    table = tmp_path / "b" / "study" / "results.csv"
    text = table.read_text()
    rms = text.splitlines()[1].split(",")[text.splitlines()[0].split(",").index("rms_error")]
    table.write_text(text.replace(rms, repr(float(rms) * 2)))
    different = slipgap.compare(tmp_path / "a", tmp_path / "b")
    assert not different.same and different.equal == []
    [change] = different.changes
    assert (change.study, change.metric, change.cases, change.case) == ("study", "rms_error", 1, 0)
    assert change.largest == 0.5 and change.second == 2 * float(rms)
    assert slipgap.compare(tmp_path / "a", tmp_path / "b", 0.6).same
    with pytest.raises(slipgap.SlipgapError, match="no results"):
        (tmp_path / "c").mkdir()
        slipgap.compare(tmp_path / "a", tmp_path / "c")


def test_unsolved_cases_are_rows_and_failures() -> None:
    # One bar of n = 10 with dt beyond the stability limit of the explicit method leaves the range of double precision.
    study = {
        "problem": "friction-oscillator",
        "parameters": {"law": "velocity-control", "beta": 1e-300, "dT": [0.1, 0.2], "x0": 1e308, "duration": 1},
    }
    results = slipgap.run(study)
    assert len(results.table) == 2
    for failure in results.failures:
        assert failure.reason and math.isnan(results.table["rms_error"][failure.case])


def test_figures(tmp_path: Path, studies: Path) -> None:
    results = slipgap.run(studies / "friction-fig5.json")
    figure = results.figures["history"]
    assert figure.name == "history" and figure._repr_svg_() == figure.svg
    assert figure.svg.startswith("<svg") or figure.svg.startswith("<?xml")
    assert figure.png.startswith(b"\x89PNG") and figure.pdf.startswith(b"%PDF")
    for ending in ["svg", "png", "pdf"]:
        figure.save(tmp_path / f"f.{ending}")
        assert (tmp_path / f"f.{ending}").stat().st_size > 1000
    with pytest.raises(slipgap.SlipgapError, match=r"must end in \.svg, \.png or \.pdf"):
        figure.save(tmp_path / "f.gif")
    (tmp_path / "mine").write_text("mine")
    (tmp_path / "link.svg").symlink_to(tmp_path / "mine")
    with pytest.raises(slipgap.SlipgapError, match="there is a link"):
        figure.save(tmp_path / "link.svg")
    assert (tmp_path / "mine").read_text() == "mine"
    assert [check.met for check in results.checks] == [True] * len(results.checks)


def test_errors_can_be_copied() -> None:
    with pytest.raises(slipgap.SlipgapError) as caught:
        slipgap.solve(FIG5 | {"alpha": -1})
    for other in [copy.copy(caught.value), pickle.loads(pickle.dumps(caught.value))]:
        assert str(other) == str(caught.value) and other.path == caught.value.path


def test_a_run_warns_of_cases_that_may_mislead(caplog: pytest.LogCaptureFixture) -> None:
    """A body on a spring far too stiff for the step: once with a record of each kind, and once without any."""
    structure = {
        "masses": {"a": 1},
        "springs": [{"between": ["ground", "a"], "k": 1}],
        "contacts": {"stop": {"law": "impact", "between": ["a", "ground"], "gap": "gap", "k": 1e6}},
        "start": {"a": {"v": 1}},
    }
    study: dict[str, Any] = {
        "problem": "structure",
        "parameters": {"gap": [9, 0.1], "dt": 0.01, "duration": 2},
        "structure": structure,
        "metrics": ["peak(a)"],
    }
    # By the function and by the object, a warning is placed here, and a note is in the log.
    for run in (slipgap.run, lambda study: slipgap.Study(study).run()):
        caplog.clear()
        with caplog.at_level("INFO"), pytest.warns(slipgap.SlipgapWarning, match="1 of 2 cases have an impact that touches") as issued:
            results = run(study)
        by_kind = {warned.kind: warned for warned in results.warnings}
        assert {warning.filename for warning in issued} == {__file__}
        [note] = [warned for warned in results.warnings if warned.is_note]
        [logged] = [record for record in caplog.records if record.name == "slipgap"]
        assert (logged.getMessage(), logged.pathname) == (note.message, __file__)
        assert len(issued) == len(by_kind) - 1
    # pi sqrt(1/1e6) is 0.3 steps.
    short = by_kind["short-contact"]
    assert (short.cases, short.case, short.parameters) == (1, 1, {"gap": 0.1})
    # A gap that stays open in some cases is a result: a note says it, which is no warning.
    assert note is by_kind["no-contact"]
    assert (note.cases, note.case, note.parameters) == (1, 0, {"gap": 9})
    assert f"(note {note.kind};" in note.message
    assert "never-slides" not in by_kind
    assert [entry["kind"] for entry in results.manifest["warnings"]] == list(by_kind)
    structure["contacts"] = {}
    study["parameters"] = {"dt": 0.01, "duration": 2}
    assert slipgap.run(study).warnings == []
