"""A run from Python writes the bytes of the program, and its table has the numbers of results.csv."""

import csv
import json
import os
import subprocess
from pathlib import Path

import numpy
import pytest

import slipgap

ROOT = Path(__file__).resolve().parents[2]

# All problems, and all kinds of figures and tables; all studies with SLIPGAP_ALL_STUDIES=1.
SOME = """bridges-fragility bridges-spectrum-friction building-floors ensemble-size friction-budget friction-fig5 friction-map-beta impact-budget
impact-fig4 impact-fig5 impact-fig6 impact-sobol impact-wave laws-best-width laws-friction laws-front-impact methods-maps-dt
methods-periods structure-bars-in-a-row structure-block structure-den-hartog structure-girders structure-lift-off structure-response
structure-stop plane-circle recorded-set""".split()


def shipped() -> list[Path]:
    files = sorted(file for file in (ROOT / "studies").rglob("*.json"))
    if os.environ.get("SLIPGAP_ALL_STUDIES"):
        return files
    assert {file.stem for file in files} >= set(SOME)
    return [file for file in files if file.stem in SOME]


def study_file(studies: Path, name: str) -> Path:
    """A study in the folder or one of its sub-folders."""
    (file,) = studies.rglob(f"{name}.json")
    return file


def results_of(out: Path) -> Path:
    """The folder of results of the only study of a run."""
    (manifest,) = out.rglob("manifest.json")
    return manifest.parent


def files(folder: Path) -> dict[str, Path]:
    return {str(p.relative_to(folder)): p for p in folder.rglob("*") if p.is_file()}


def test_some_studies_have_every_kind_of_figure() -> None:
    def kinds(names: list[Path]) -> set[str]:
        studies = [json.loads(file.read_text()) for file in names]
        return {figure["kind"] for study in studies for figure in study.get("figures", [])}

    assert kinds(shipped()) == kinds(sorted((ROOT / "studies").rglob("*.json")))


@pytest.mark.parametrize("study", shipped(), ids=lambda file: str(file.stem))
def test_files_and_numbers(study: Path, program: str, tmp_path: Path) -> None:
    theirs, ours = tmp_path / "program", tmp_path / "python"
    # Bridges take minutes in a development build; a part of their motion has the same tables and figures.
    long = study.stem.startswith("bridges") or study.stem == "structure-girders"
    settings = {"duration": 3} if long and not os.environ.get("SLIPGAP_ALL_STUDIES") else {}
    words = [f"--set={name}={value}" for name, value in settings.items()]
    done = subprocess.run([program, "run", study, "--out", theirs, *words], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    results = slipgap.run(study, out=ours, set=settings)
    left, right = files(theirs), files(ours)
    assert left.keys() == right.keys() and len(left) > 3
    for name, file in left.items():
        assert file.read_bytes() == right[name].read_bytes(), name
    assert slipgap.compare(theirs, ours).same

    folder = results_of(theirs)
    assert results.manifest == json.loads((folder / "manifest.json").read_text())
    for name, figure in results.figures.items():
        assert figure.svg == (folder / f"{name}.svg").read_text()
    if not (folder / "results.csv").is_file():
        return
    with open(folder / "results.csv", newline="") as text:
        header, *rows = csv.reader(text)
    assert results.table.columns == header and len(results.table) == len(rows)
    for column, name in enumerate(header):
        cells = [row[column] for row in rows]
        values = results.table[name]
        if values.dtype == object:
            assert [value or "" for value in values] == cells
        else:
            # The shortest decimal form reads back as the same double.
            expected = [float(cell) if cell else float("nan") for cell in cells]
            assert repr(values.astype(float).tolist()) == repr(expected), name


@pytest.mark.parametrize("name", ["friction-fig5", "impact-fig4", "structure-block"])
def test_a_run_in_memory_is_the_same(name: str, program: str, studies: Path, tmp_path: Path) -> None:
    study = study_file(studies, name)
    before = sorted(tmp_path.iterdir())
    memory, files = slipgap.run(study), slipgap.run(study, out=tmp_path)
    assert memory.folder is None and before == []
    assert memory.table.columns == files.table.columns
    for column in memory.table.columns:
        a, b = memory.table[column], files.table[column]
        assert repr(list(a)) == repr(list(b)), column
    assert memory.checks == files.checks and memory.failures == files.failures == []
    assert memory.figures.keys() == files.figures.keys()
    out = str(tmp_path / "program")
    words = [program, "run", str(study), "--out", out]
    subprocess.run(words, capture_output=True, check=True)
    for name, figure in memory.figures.items():
        drawn = results_of(tmp_path / "program") / name
        assert figure.svg == drawn.with_suffix(".svg").read_text()
        assert figure.png == drawn.with_suffix(".png").read_bytes()
        assert figure.pdf == drawn.with_suffix(".pdf").read_bytes()
    left = {key: value for key, value in memory.manifest.items() if key != "files"}
    right = {key: value for key, value in files.manifest.items() if key != "files"}
    assert left == right


def test_settings_and_threads_are_those_of_the_program(program: str, studies: Path, tmp_path: Path) -> None:
    study = studies / "friction-fig5.json"
    settings = ["--set", "dT=pi/20", "--set", "alpha=[0.1, 1, 2, 5]", "--set", "x0=11"]
    command: list[str | Path] = [program, "run", study, "--out", tmp_path / "program", "--jobs", "2", *settings]
    subprocess.run(command, check=True, capture_output=True)
    given = {"dT": "pi/20", "alpha": [0.1, 1, 2, 5], "x0": 11}
    for jobs in [1, 3]:
        out = tmp_path / f"python{jobs}"
        slipgap.run(study, out=out, set=given, jobs=jobs)
        for name, file in files(tmp_path / "program").items():
            assert file.read_bytes() == (out / name).read_bytes(), name


@pytest.mark.parametrize("name", ["friction-fig5", "impact-unequal", "structure-block"])
def test_a_solution_is_the_history_of_the_program(
    name: str, program: str, studies: Path, tmp_path: Path
) -> None:
    study = study_file(studies, name)
    command: list[str | Path] = [program, "run", study, "--out", tmp_path, "--histories"]
    subprocess.run(command, check=True, capture_output=True)
    with open(results_of(tmp_path) / "results.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    for case in {0, len(rows) // 2, len(rows) - 1}:
        with open(results_of(tmp_path) / "histories" / f"{case}.csv", newline="") as file:
            header, *history = csv.reader(file)
        solution = slipgap.solve(study, case)
        columns = dict(solution.channels)
        columns |= {f"{key}_exact": values for key, values in solution.references.items()}
        assert solution.measured == {}
        for index, column in enumerate(header):
            expected = [float(row[index]) for row in history]
            assert columns[column].tolist() == expected, column
        assert solution.time.tolist() == [float(row[0]) for row in history]
        for metric, value in solution.metrics.items():
            cell = rows[case][metric]
            assert value == (float(cell) if cell else None), metric


def test_a_solution_has_the_measured_columns_of_the_program(program: str, tmp_path: Path) -> None:
    rows = "".join(f"{0.3 + 0.07 * i},{20 - i},{i * i}\n" for i in range(12))
    (tmp_path / "test.csv").write_text("t,disp_mm,force\n" + rows)
    columns = {"m": {"column": "disp_mm", "unit": "mm"}, "pad.S": "force"}
    study = {
        "problem": "structure",
        "parameters": {"dt": 0.05, "duration": 1.5},
        "measured": {"file": "test.csv", "time": "t", "columns": columns, "delay": 0.1},
        "structure": {
            "units": "t, kN, m, s",
            "masses": {"m": 1},
            "springs": [{"between": ["ground", "m"], "k": 20}],
            "contacts": {"pad": {"law": "coulomb", "between": ["ground", "m"], "limit": 0.1}},
            "start": {"m": {"u": 0.1}},
        },
        "metrics": ["rms_error(m, measured)"],
    }
    (tmp_path / "s.json").write_text(json.dumps(study))
    command: list[str | Path] = [program, "run", tmp_path / "s.json", "--out", tmp_path]
    subprocess.run([*command, "--histories"], check=True, capture_output=True)
    with open(tmp_path / "s" / "histories" / "0.csv", newline="") as file:
        history = list(csv.DictReader(file))
    measured = slipgap.solve(tmp_path / "s.json").measured
    assert list(measured) == ["t", "m", "pad.S"]
    for name in ["m", "pad.S"]:
        cells = [row[f"{name}_measured"] for row in history]
        # The file has times from 0.2 to 0.97 of the motion.
        assert [cell == "" for cell in cells] == [not 0.2 <= t <= 0.97 for t in measured["t"]]
        values = [float(cell) for cell in cells if cell]
        assert measured[name][~numpy.isnan(measured[name])].tolist() == values
    # 20 - i mm at 0.2 + 0.07 i is a straight line.
    steps = measured["t"][~numpy.isnan(measured["m"])]
    line = 1e-3 * (20 - (steps - 0.2) / 0.07)
    assert numpy.abs(measured["m"][~numpy.isnan(measured["m"])] - line).max() < 1e-15
