"""Animations: the page of the program, in a notebook and in a file."""

import html
import json
from pathlib import Path

import pytest

import slipgap

STUDY = {
    "problem": "friction-oscillator",
    "parameters": {"law": "displacement-control", "alpha": [0.1, 1], "dT": "pi/10", "duration": "8*pi"},
}


def data(page: str) -> dict[str, object]:
    text = page.split('<script id="data" type="application/json">')[1].split("</script>")[0]
    parsed: dict[str, object] = json.loads(text)
    return parsed


def test_two_cases_are_two_films() -> None:
    animation = slipgap.animate(STUDY, 0, 1)
    films = data(animation.html)["films"]
    assert isinstance(films, list)
    assert [film["label"] for film in films] == ["case 0: alpha = 0.1", "case 1: alpha = 1"]


def test_computed_and_exact_motion() -> None:
    films = data(slipgap.animate(STUDY, 1, exact=True).html)["films"]
    assert isinstance(films, list)
    assert [film["label"] for film in films] == ["computed", "exact"]


def test_a_notebook_has_the_page_in_a_frame() -> None:
    animation = slipgap.animate(STUDY, set={"x0": 5})
    frame = animation._repr_html_()
    assert frame.startswith('<iframe srcdoc="') and frame.count('"') == 8
    assert html.unescape(frame.split('"')[1]) == animation.html


def test_the_file_has_the_page(tmp_path: Path) -> None:
    animation = slipgap.animate(STUDY)
    animation.save(tmp_path / "motion.html")
    assert (tmp_path / "motion.html").read_text(encoding="utf-8") == animation.html
    with pytest.raises(slipgap.SlipgapError, match="cannot write"):
        animation.save(tmp_path / "absent" / "motion.html")
    (tmp_path / "mine").write_text("mine")
    (tmp_path / "link.html").symlink_to(tmp_path / "mine")
    with pytest.raises(slipgap.SlipgapError, match="there is a link"):
        animation.save(tmp_path / "link.html")
    assert (tmp_path / "mine").read_text() == "mine"


@pytest.mark.parametrize(
    ("cases", "exact", "message"),
    [
        ((2,), False, "the study has cases 0 to 1"),
        ((-1,), False, "must be 0 or more, got -1"),
        ((0, 1, 0), False, "one case, two cases"),
        ((0, 1), True, "one case, two cases"),
    ],
)
def test_mistakes(cases: tuple[int, ...], exact: bool, message: str) -> None:
    with pytest.raises(slipgap.SlipgapError, match=message):
        slipgap.animate(STUDY, *cases, exact=exact)
