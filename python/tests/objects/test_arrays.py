"""Arrays and frames as records, tables and measurements give what their files give."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import slipgap

T = np.arange(0, 3, 0.01)
A = np.sin(7 * T) * np.exp(-(((T - 1.5) / 0.7) ** 2)) * 3


def study(ground: dict[str, Any], **parameters: Any) -> dict[str, Any]:
    return {
        "problem": "structure",
        "parameters": {"dt": 0.005, "duration": 3, **parameters},
        "structure": {
            "units": "t, kN, m, s",
            "masses": {"a": 1},
            "springs": [{"between": ["ground", "a"], "k": 40}],
            "ground": ground,
        },
        "metrics": ["peak(a)"],
    }


@pytest.fixture(scope="module")
def expected(tmp_path_factory: pytest.TempPathFactory) -> float:
    """The peak under the motion in a file."""
    file = tmp_path_factory.mktemp("records") / "motion.csv"
    file.write_text("t,a\n" + "".join(f"{t!r},{a!r}\n" for t, a in zip(T.tolist(), A.tolist(), strict=True)))
    return peak({"record": str(file), "unit": "m/s2"})


def peak(ground: dict[str, Any]) -> float:
    return float(slipgap.run(study(ground)).table["peak(a)"][0])


def test_arrays_and_frames_are_records(expected: float) -> None:
    pandas, polars = pytest.importorskip("pandas"), pytest.importorskip("polars")
    columns = {"t": T, "a": A}
    for record in (
        (T, A),
        [T.tolist(), A.tolist()],
        np.stack([T, A]),
        np.column_stack([T, A]),
        pandas.DataFrame(columns),
        pandas.DataFrame({"time": T, "value": A}),
        pandas.Series(A, index=T),
        polars.DataFrame(columns),
        (T.astype(np.longdouble), A),
    ):
        assert peak({"record": record, "unit": "m/s2"}) == expected
    # Values at equal steps.
    assert peak({"record": A, "dt": 0.01, "unit": "m/s2"}) == pytest.approx(expected, rel=1e-9)
    assert peak({"record": pandas.Series(A / 9.80665), "dt": 0.01, "unit": "g"}) == pytest.approx(expected, rel=1e-9)
    # A table is straight between its points, as a record is.
    assert peak({"table": pandas.DataFrame({"t": T, "f": A})}) == pytest.approx(expected, rel=1e-9)


def test_records_are_an_axis(expected: float, tmp_path: Path) -> None:
    records = [(T, A), (T, 2 * A)]
    ground = {"record": "motion", "unit": "m/s2"}
    given = slipgap.Study(study(ground, motion=records))
    for results in (given.run(), slipgap.run(study(ground, motion=[(T, 9 * A)]), set={"motion": records})):
        # The structure is linear.
        assert results.table["peak(a)"].tolist() == pytest.approx([expected, 2 * expected], rel=1e-12)
    assert given.with_(motion=[(T, 3 * A)]).run().table["peak(a)"].tolist() == pytest.approx([3 * expected], rel=1e-12)
    # A saved study has its records beside it.
    saved = given.save(tmp_path / "saved.json")
    assert len(list(tmp_path.glob("saved-motion-*.csv"))) == 2
    assert saved.run().table["peak(a)"].tolist() == given.run().table["peak(a)"].tolist()


def test_a_frame_is_a_measurement() -> None:
    pandas = pytest.importorskip("pandas")
    given = study({"record": (T, A), "unit": "m/s2"})
    u = slipgap.solve(given).channels["a"]
    frame = pandas.DataFrame({"time": np.arange(len(u)) * 0.005, "top": u})
    of_frame = {**given, "metrics": ["rms_error(a, measured)"], "measured": {"file": frame, "time": "time", "columns": {"a": "top"}}}
    assert slipgap.run(of_frame).table["rms_error(a, measured)"][0] == pytest.approx(0, abs=1e-12)


def test_a_number_that_is_none_is_named_with_its_place() -> None:
    wrong = A.copy()
    wrong[7] = np.nan
    with pytest.raises(slipgap.SlipgapError, match=r"structure.ground.record: number 7 is nan"):
        slipgap.run(study({"record": (T, wrong)}))
    with pytest.raises(slipgap.SlipgapError, match=r"parameters.motion\[1\]: number 7 is nan"):
        slipgap.run(study({"record": "motion"}, motion=[(T, A), (T, wrong)]))
    with pytest.raises(slipgap.SlipgapError, match=r"structure.ground.table.f\[7\] is nan"):
        slipgap.run(study({"table": {"t": T, "f": wrong}}))
    with pytest.raises(slipgap.SlipgapError, match=r"parameters.dt\[1\] is nan"):
        slipgap.run(study({"table": {"t": T, "f": A}}, dt=np.array([0.01, np.nan])))
    with pytest.raises(slipgap.SlipgapError, match="a record is times and accelerations of one length"):
        slipgap.run(study({"record": (T, A[:-1])}))
    with pytest.raises(slipgap.SlipgapError, match=r"parameters.dt is nan"):
        slipgap.run(study({"table": {"t": T, "f": A}}, dt=np.longdouble("nan")))
    measured = {"time": T, "columns": {"a": wrong}}
    for given, place in [(measured, r"columns.a"), ({"time": wrong, "columns": {"a": A}}, "time")]:
        with pytest.raises(slipgap.SlipgapError, match=rf"measured.{place}\[7\] is nan, which a measurement does not have"):
            slipgap.run({**study({"table": {"t": T, "f": A}}), "measured": given})
    # Numbers of more digits are those of Python.
    longer = slipgap.run(study({"table": {"t": T, "f": A.astype(np.longdouble)}}, dt=np.longdouble("0.005")))
    assert longer.table["peak(a)"][0] == slipgap.run(study({"table": {"t": T, "f": A}})).table["peak(a)"][0]
