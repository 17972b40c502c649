"""Studies as objects: what `with_` changes is what `--set` changes, and nothing else changes."""

import copy
import csv
import json
import pickle
import subprocess
from pathlib import Path
from typing import Any

import numpy
import pytest

import slipgap
from slipgap import Study

PARAMETERS: dict[str, Any] = {"law": "velocity-control", "beta": [0.5, 2], "dT": 0.5, "duration": 10}
PLAIN: dict[str, Any] = {"problem": "friction-oscillator", "parameters": PARAMETERS}
BLOCKS: dict[str, Any] = {
    "problem": "friction-oscillator",
    "blocks": [
        {"parameters": {"law": "displacement-control", "alpha": [0.1, 1], "dT": 0.1, "duration": 25}},
        {"parameters": {"law": "velocity-control", "beta": 0.5, "dT": 0.1, "duration": 25}},
    ],
}


def test_a_study_has_several_sources(tmp_path: Path) -> None:
    file = tmp_path / "mine.json"
    file.write_text(json.dumps(PLAIN))
    of_dict, of_keys, of_text = Study(PLAIN), Study(**PLAIN), Study(json.dumps(PLAIN))
    assert of_dict == of_keys == of_text == Study(of_dict) and len({of_dict, of_keys, of_text}) == 1
    of_file = Study(file)
    assert dict(of_file) == dict(of_dict) == PLAIN
    # Files in it are relative to another folder.
    assert of_file != of_dict and of_file.folder == tmp_path
    assert (of_file.name, of_dict.name) == ("mine", "study")
    assert repr(of_file) == "<slipgap.Study mine: friction-oscillator>"
    assert Study(PLAIN, title="Mine")["title"] == "Mine" and "title" not in of_dict
    assert of_dict != PLAIN and of_dict != of_dict.with_(dT=0.25)


def test_a_study_does_not_change() -> None:
    given = copy.deepcopy(PLAIN)
    study = Study(given)
    given["parameters"]["dT"] = 1
    study.parameters["dT"] = 2
    study["parameters"]["dT"] = 3
    study.with_(dT=4)
    study.replace(problem="bar-impact")
    assert dict(study) == PLAIN
    with pytest.raises(AttributeError):
        study.name = "other"  # type: ignore[misc]
    with pytest.raises(TypeError):
        study["problem"] = "bar-impact"  # type: ignore[index]


@pytest.mark.parametrize("source", [PLAIN, BLOCKS])
def test_a_changed_study_gives_what_set_gives(source: dict[str, Any], program: str, tmp_path: Path) -> None:
    (tmp_path / "s.json").write_text(json.dumps(source))
    words = ["--set", "beta=[0.5,1]", "--set", "x0=9", "--set", "duration=8*pi", "--out", str(tmp_path)]
    subprocess.run([program, "run", str(tmp_path / "s.json"), *words], check=True, capture_output=True)
    with (tmp_path / "s" / "results.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    changed = Study(tmp_path / "s.json").with_(beta=numpy.array([0.5, 1]), x0=9, duration="8*pi")
    results = changed.run(out=tmp_path / "of_python")
    assert [row["rms_error"] for row in rows] == [repr(x) for x in results.table["rms_error"].tolist()]
    assert [float(row["x0"]) for row in rows] == results.table["x0"].tolist() == [9.0] * len(rows)
    # The results have the name of the file, and know the study.
    assert results.folder == tmp_path / "of_python" / "s" and results.study == changed
    by_set = slipgap.run(tmp_path / "s.json", set={"beta": [0.5, 1], "x0": 9, "duration": "8*pi"})
    assert by_set.study == changed and by_set.table == results.table


def test_parameters_within_others() -> None:
    bars = {"gamma": 1, "n": 4, "dt": 0.05, "duration": 2, "L": 10, "right": {"L": 20}}
    one = Study(problem="bar-impact", parameters=bars)
    assert one.with_({"right.L": [20, 40]}, gamma=2).parameters == {**bars, "gamma": 2, "right": {"L": [20, 40]}}
    assert one.with_({"right.L": [20, 40]}).check() == 2
    assert Study(problem="bar-impact").with_({"right.L": 20}).parameters == {"right": {"L": 20}}
    with pytest.raises(slipgap.SlipgapError, match="right is not an object"):
        one.with_(right="wall").with_({"right.L": 20})


@pytest.mark.parametrize("source", [PLAIN, BLOCKS])
def test_cases_are_those_of_the_run(source: dict[str, Any]) -> None:
    study = Study(source)
    cases, table = study.expand(), study.run().table
    results = study.run()
    assert cases.columns == ["case", *results.parameters] and study.check() == len(cases) == len(table)
    for name in cases.columns:
        assert numpy.array_equal(cases[name], table[name], equal_nan=cases[name].dtype != object)
    assert cases.units == {name: unit for name, unit in table.units.items() if name in cases}


def test_a_large_study_is_not_a_table() -> None:
    axis = {"linspace": [0.1, 5, 10000]}
    large = Study(PLAIN).with_(beta=axis, x0={"linspace": [5, 9, 2000]})
    assert large.check() == 20_000_000
    with pytest.raises(slipgap.SlipgapError, match="20000000 combinations; allowed: at most 10000000"):
        large.expand()


def test_mistakes_have_their_place(tmp_path: Path) -> None:
    file = tmp_path / "x.json"
    file.write_text('{ "problem": "friction-oscillator",\n  "parameters": { "law": "dahl", "alpha": -2, "dT": 0.1, "duration": 9 } }')
    with pytest.raises(slipgap.SlipgapError) as caught:
        Study(file).check()
    assert (caught.value.file, caught.value.line, caught.value.path) == (str(file), 2, "parameters.alpha")
    # A changed study has no lines.
    with pytest.raises(slipgap.SlipgapError) as caught:
        Study(file).with_(alpha=-3).run()
    assert (caught.value.file, caught.value.line, caught.value.path) == (None, None, "parameters.alpha")
    assert str(caught.value).startswith("parameters.alpha: must be > 0, got -3")
    with pytest.raises(slipgap.SlipgapError, match="none.json") as caught:
        Study(tmp_path / "none.json")
    assert caught.value.file == str(tmp_path / "none.json")
    (tmp_path / "bad.json").write_text('{\n"problem": }')
    with pytest.raises(slipgap.SlipgapError) as caught:
        Study(tmp_path / "bad.json").with_(dT=1)
    assert (caught.value.line, caught.value.column) == (2, 12)
    with pytest.raises(slipgap.SlipgapError):
        Study("{").parameters
    with pytest.raises(slipgap.SlipgapError, match="JSON compliant|not valid|nan"):
        Study(PLAIN).with_(dT=float("nan"))
    with pytest.raises(KeyError, match="no key paramters; did you mean parameters?"):
        Study(PLAIN)["paramters"]


def recorded(folder: Path) -> Path:
    """A study with a record beside it."""
    (folder / "records").mkdir(parents=True)
    rows = "\n".join(f"{0.02 * i:.2f},{(-1) ** (i // 10)}" for i in range(200))
    (folder / "records" / "own.csv").write_text(f"t,a (m/s2)\n{rows}\n")
    structure = {
        "units": "t, kN, m, s",
        "masses": {"m": 1},
        "springs": [{"between": ["ground", "m"], "k": "k"}],
        "ground": {"record": "records/own.csv"},
    }
    study = {"problem": "structure", "parameters": {"k": 50, "dt": 0.02, "duration": 3}, "structure": structure}
    file = folder / "shaken.json"
    file.write_text(json.dumps({**study, "metrics": ["peak(m)"]}))
    return file


def test_files_are_relative_to_the_study(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, program: str) -> None:
    file = recorded(tmp_path / "studies")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("slipgap._program.program", lambda: program)
    study = Study(Path("studies") / "shaken.json")
    changed = study.with_(k=80).with_(dt=0.01).replace(title="Shaken")
    expected = slipgap.run(file, set={"k": 80, "dt": 0.01}).table["peak(m)"]
    assert changed.folder == Path("studies") and changed.name == "shaken"
    assert changed.run().table["peak(m)"] == expected
    assert changed.solve().metrics["peak(m)"] == expected[0]
    assert "case 0 of 1" in slipgap.explain(changed)
    assert slipgap.report(changed, out="pages") == tmp_path / "pages" / "report.html"
    # Written beside the first one it is the same study.
    assert dict(changed.save("studies/other.json")) == dict(changed)
    assert slipgap.run("studies/other.json").table["peak(m)"] == expected
    assert changed.to_json() == (tmp_path / "studies" / "other.json").read_text()
    with pytest.raises(slipgap.SlipgapError, match="cannot write"):
        study.save(tmp_path / "none" / "x.json")


def test_functions_take_studies() -> None:
    study = Study(PLAIN)
    assert study.solve(1).metrics == slipgap.solve(study, 1).metrics == slipgap.solve(PLAIN, 1).metrics
    assert slipgap.run(study, set={"x0": 9}).study.parameters["x0"] == 9
    assert study.solve(1).channels["X"].tolist() == slipgap.solve(PLAIN, 1).channels["X"].tolist()
    seen: list[tuple[int, int]] = []
    study.run(jobs=1, progress=lambda done, total: seen.append((done, total)))
    assert seen[-1] == (2, 2)


def test_copies_are_equal() -> None:
    study = Study(PLAIN).with_(x0=9)
    for other in [copy.copy(study), copy.deepcopy(study), pickle.loads(pickle.dumps(study))]:
        assert other == study and hash(other) == hash(study)
