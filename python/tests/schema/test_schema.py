"""The schema of studies accepts what ships, and refuses what the program refuses."""

import copy
import json
import subprocess
from itertools import combinations
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from mistakes import GOOD, MISTAKES, ONLY_THE_PROGRAM, STRUCTURE

ROOT = Path(__file__).resolve().parents[3]
SCHEMA = jsonschema.Draft7Validator(json.loads((ROOT / "schema" / "study.json").read_text()))


def shipped() -> list[Path]:
    return sorted((ROOT / "studies").rglob("*.json")) + sorted((ROOT / "docs" / "maps").glob("*.json"))


@pytest.mark.parametrize("study", shipped(), ids=lambda file: str(file.stem))
def test_shipped_studies_are_valid(study: Path) -> None:
    assert [fault.message for fault in SCHEMA.iter_errors(json.loads(study.read_text()))] == []


def refused(program: str, study: Any, folder: Path) -> bool:
    (folder / "study.json").write_text(json.dumps(study))
    done = subprocess.run([program, "explain", folder / "study.json"], capture_output=True)
    assert done.returncode in (0, 2), done.stderr
    return done.returncode == 2


def test_good_studies_are_valid(program: str, tmp_path: Path) -> None:
    for study in GOOD:
        assert SCHEMA.is_valid(study) and not refused(program, study, tmp_path)


@pytest.mark.parametrize("name", MISTAKES)
def test_mistakes_are_refused_by_both(name: str, program: str, tmp_path: Path) -> None:
    study = MISTAKES[name]
    assert refused(program, study, tmp_path)
    assert SCHEMA.is_valid(study) == (name in ONLY_THE_PROGRAM)


def test_a_damping_ratio_in_percent_is_shown(program: str, tmp_path: Path) -> None:
    """A run of it warns; an editor shows it before."""
    percent = copy.deepcopy(STRUCTURE)
    percent["structure"]["springs"][1] = {"between": ["ground", "c"], "mass": 3, "period": 1, "ratio": 5}
    assert not SCHEMA.is_valid(percent) and not refused(program, percent, tmp_path)
    percent["structure"]["springs"][1]["ratio"] = 0.05
    assert SCHEMA.is_valid(percent)
    modal = copy.deepcopy(STRUCTURE)
    modal["structure"]["modal_damping"] = 5
    assert not SCHEMA.is_valid(modal)


def test_channels_of_matrices_have_any_name() -> None:
    study = copy.deepcopy(STRUCTURE)
    study["structure"]["matrices"] = {"tower": {"M": "M.mtx", "K": "K.mtx", "dofs": "d.csv", "forces": "f.csv"}}
    study["metrics"] = ["peak(tower.F)"]
    assert SCHEMA.is_valid(study)


def laws() -> list[tuple[str, list[str]]]:
    """The laws of structures, each with the keys of its numbers."""
    definitions = SCHEMA.schema["definitions"]

    def written_out(part: dict[str, Any]) -> dict[str, Any]:
        """What a part refers to, if it is a reference."""
        return definitions[part["$ref"].removeprefix("#/definitions/")] if "$ref" in part else part

    contact = definitions["structure.contact"]
    rules = [rule for rule in map(written_out, contact["allOf"]) if "if" in rule]
    names = [set(written_out(written_out(rule["then"])["propertyNames"])["enum"]) for rule in rules]
    common = set.intersection(*names)
    keys = [sorted(of_law - common) for of_law in names]
    return [(rule["if"]["properties"]["law"]["const"], law_keys) for rule, law_keys in zip(rules, keys)]


VALUES: dict[str, Any] = {
    "table": {"r": [0, 1], "S": [0, 1]},
    "nu": 0.2,
    "nu_min": 0.1,
    "static_ratio": 1.2,
    "restitution": 0.5,
    "e": 0.5,
    "hardening": 0.1,
    "exponent": 1.5,
}


@pytest.mark.parametrize(("law", "keys"), laws(), ids=[law for law, _ in laws()])
def test_the_numbers_of_laws_are_those_of_the_program(
    law: str, keys: list[str], program: str, tmp_path: Path
) -> None:
    """What the schema refuses, the program refuses, for every choice of few keys of a law."""
    most = 3 if len(keys) < 12 else 2
    chosen = [few for count in range(most + 1) for few in combinations(keys, count)]
    valid = 0
    for few in chosen:
        study = copy.deepcopy(STRUCTURE)
        contact = {"law": law, "between": ["ground", "a"]}
        study["structure"]["contacts"]["gap"] = contact | {key: VALUES.get(key, 1) for key in few}
        if SCHEMA.is_valid(study):
            valid += 1
        else:
            assert refused(program, study, tmp_path), few
    assert valid > 0 or most < 3
