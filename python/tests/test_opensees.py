"""Export of models of OpenSees with constraints, against OpenSees itself: examples/models/opensees.py."""

import csv
import json
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

linalg = pytest.importorskip("scipy.linalg")
io = pytest.importorskip("scipy.io")
try:
    import openseespy.opensees as ops
except Exception as why:  # It raises errors of several types where a library of the system is missing.
    pytest.skip(f"no openseespy: {why}", allow_module_level=True)

MODELS = Path(__file__).resolve().parents[2] / "examples" / "models"


@pytest.fixture
def export(monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[..., None]]:
    monkeypatch.syspath_prepend(str(MODELS))
    from opensees import export

    yield export
    ops.wipe()


def column(rotary: float = 20.0) -> None:
    """A cantilever with its top at node 2, and node 3 above it, in a plane; mass at 3."""
    ops.wipe()
    ops.model("basic", "-ndm", 2, "-ndf", 3)
    ops.geomTransf("Linear", 1)
    for node, x, y in [(1, 0.0, 0.0), (2, 0.0, 5.0), (3, 0.5, 7.0)]:
        ops.node(node, x, y)
    ops.fix(1, 1, 1, 1)
    ops.element("elasticBeamColumn", 1, 1, 2, 1.0, 3e7, 0.1, 1)
    ops.mass(2, 10.0, 10.0, 2.0)
    ops.mass(3, 100.0, 90.0, rotary)


def linked(kind: str) -> None:
    column()
    if kind == "bar":
        # A link without rotation leaves that of node 3 to a column of its own.
        ops.node(4, 0.5, 10.0)
        ops.fix(4, 1, 1, 1)
        ops.element("elasticBeamColumn", 2, 3, 4, 1.0, 3e7, 0.01, 1)
    ops.rigidLink(kind, 2, 3)


def equal(dofs: list[int]) -> None:
    column()
    if 3 not in dofs:
        ops.node(4, 0.5, 10.0)
        ops.fix(4, 1, 1, 1)
        ops.element("elasticBeamColumn", 2, 3, 4, 1.0, 3e7, 0.01, 1)
    ops.equalDOF(2, 3, *dofs)


def chain(of_first: bool) -> None:
    """Node 4 follows node 3, which follows node 2; or both follow node 2, which is the same."""
    column()
    ops.node(4, 1.5, 8.0)
    ops.mass(4, 30.0, 30.0, 3.0)
    ops.rigidLink("beam", 2, 3)
    ops.rigidLink("beam", 2 if of_first else 3, 4)


def storeys(floors: int, middle: bool) -> None:
    """A frame in space with rigid floors; each has a node in its middle, or follows a column. Masses differ from node to node."""
    ops.wipe()
    ops.model("basic", "-ndm", 3, "-ndf", 6)
    ops.geomTransf("Linear", 1, 1, 0, 0)
    ops.geomTransf("Linear", 2, 0, 0, 1)
    plan, element = [(0, 0), (6, 0), (6, 4), (0, 4)], 0
    for floor in range(floors + 1):
        for i, (x, y) in enumerate(plan, 1):
            node = 10 * floor + i
            ops.node(node, x, y, 3.2 * floor)
            if floor == 0:
                ops.fix(node, 1, 1, 1, 1, 1, 1)
                continue
            ops.mass(node, 25 + i, 25 + i, 20, 0, 0, 0)
            element += 1
            ops.element("elasticBeamColumn", element, node - 10, node, 0.09, 3e7, 1.25e7, 1e-3, 6.75e-4, 6.75e-4, 1)
        if floor == 0:
            continue
        for i in range(1, 5):
            element += 1
            ends = 10 * floor + i, 10 * floor + i % 4 + 1
            ops.element("elasticBeamColumn", element, *ends, 0.01, 3e7, 1.25e7, 1e-5, 1e-5, 1e-5, 2)
        if middle:
            centre = 10 * floor + 9
            ops.node(centre, 2.9, 2.1, 3.2 * floor)
            ops.mass(centre, 10, 10, 0, 0, 0, 60)
            ops.fix(centre, 0, 0, 1, 1, 1, 0)
            ops.rigidDiaphragm(3, centre, *(10 * floor + i for i in range(1, 5)))
        else:
            ops.rigidDiaphragm(3, *(10 * floor + i for i in range(1, 5)))


def arm(of_first: bool) -> None:
    """A rigid arm in space from a column, and one from its end, with masses without rotary inertia."""
    ops.wipe()
    ops.model("basic", "-ndm", 3, "-ndf", 6)
    ops.geomTransf("Linear", 1, 1, 0, 0)
    for node, at in [(1, (0, 0, 0)), (2, (0, 0, 4)), (3, (1, 0.5, 4.5)), (4, (1, 2, 5))]:
        ops.node(node, *map(float, at))
    ops.fix(1, 1, 1, 1, 1, 1, 1)
    ops.element("elasticBeamColumn", 1, 1, 2, 0.09, 3e7, 1.25e7, 1e-3, 6.75e-4, 5e-4, 1)
    ops.mass(3, 5.0, 5.0, 5.0, 0.0, 0.0, 0.0)
    ops.mass(4, 8.0, 8.0, 8.0, 0.0, 0.0, 0.0)
    ops.rigidLink("beam", 2, 3)
    ops.rigidLink("beam", 2 if of_first else 3, 4)


def theirs(count: int) -> list[float]:
    """Squares of the lowest circular frequencies by the Transformation handler of OpenSees."""
    ops.wipeAnalysis()
    for command, name in [("constraints", "Transformation"), ("numberer", "RCM"), ("system", "BandGeneral")]:
        getattr(ops, command)(name)
    return sorted(ops.eigen("-fullGenLapack", count))


def ours(prefix: Path, count: int) -> list[float]:
    """The same of the exported matrices, with the rows without mass condensed."""
    M, K = (io.mmread(f"{prefix}.{name}.mtx").toarray() for name in "MK")
    r, s = M.any(axis=1), ~M.any(axis=1)
    K = K[np.ix_(r, r)] - K[np.ix_(r, s)] @ np.linalg.solve(K[np.ix_(s, s)], K[np.ix_(s, r)])
    return list(linalg.eigh(K, M[np.ix_(r, r)], eigvals_only=True)[:count])


# A model, the same without chains of constraints, which the Transformation handler does not know, and the number of modes.
CASES: dict[str, tuple[Callable[[], None], Callable[[], None], int]] = {
    "beam": (lambda: linked("beam"),) * 2 + (3,),
    "bar": (lambda: linked("bar"),) * 2 + (3,),
    "equal": (lambda: equal([1, 2, 3]),) * 2 + (3,),
    "equal in x": (lambda: equal([1]),) * 2 + (4,),
    "chain": (lambda: chain(False), lambda: chain(True), 3),
    "arm": (lambda: arm(False), lambda: arm(True), 5),
    "floor at a column": (lambda: storeys(1, False),) * 2 + (6,),
    "floors with a middle": (lambda: storeys(3, True),) * 2 + (9,),
}


@pytest.mark.parametrize("case", CASES)
def test_periods_are_those_of_the_transformation_handler(case: str, export: Callable[..., None], tmp_path: Path) -> None:
    model, unchained, count = CASES[case]
    unchained()
    expected = theirs(count)
    model()
    export(tmp_path / "m")
    # Squares of frequencies, so that periods agree to half of it.
    assert ours(tmp_path / "m", count) == pytest.approx(expected, rel=1e-9, abs=0)


def test_a_model_without_constraints_has_no_ties(export: Callable[..., None], tmp_path: Path) -> None:
    column()
    ops.element("elasticBeamColumn", 2, 2, 3, 1.0, 3e7, 0.1, 1)
    export(tmp_path / "m")
    assert not (tmp_path / "m.ties.csv").exists()
    assert len((tmp_path / "m.dofs.csv").read_text().splitlines()) == 7


def test_mass_at_a_tied_end_stays_where_it_is(export: Callable[..., None], tmp_path: Path) -> None:
    column(rotary=0.0)
    ops.mass(2, 0.0, 0.0, 0.0)
    ops.rigidLink("beam", 2, 3)
    export(tmp_path / "m")
    # At node 2 the matrix of the mass at node 3 would be singular without a row of zeros.
    M = io.mmread(tmp_path / "m.M.mtx").toarray()
    assert sorted(M.diagonal()) == [0.0, 90.0, 100.0] and not (M - np.diag(M.diagonal())).any()


def negative(mass: float) -> None:
    column()
    ops.element("elasticBeamColumn", 2, 2, 3, 1.0, 3e7, 0.1, 1)
    ops.uniaxialMaterial("Elastic", 1, -1e9)
    ops.mass(2, mass, 10.0, 2.0)
    if mass > 0:
        ops.element("zeroLength", 3, 1, 2, "-mat", 1, "-dir", 1)


def pinned() -> None:
    column()
    ops.remove("sp", 1, 3)
    ops.fix(2, 1, 1, 0)
    ops.rigidLink("beam", 2, 3)


@pytest.mark.parametrize(
    ("model", "supports", "part"),
    [
        (lambda: negative(10.0), {}, r"K has an eigenvalue below 0 .* at 2\.x"),
        (lambda: negative(-1.0), {}, r"M has an eigenvalue below 0 .* at 2\.x"),
        (lambda: linked("beam"), {3: "top"}, r"3\.x is fixed or tied"),
        (pinned, {}, r"ground in x .* 2\.rz"),
    ],
)
def test_what_is_no_structure_is_named(model: Callable[[], None], supports: dict[int, str], part: str, export: Callable[..., None], tmp_path: Path) -> None:
    model()
    with pytest.raises(ValueError, match=part):
        export(tmp_path / "m", supports=supports)


def floor(unit: float) -> None:
    """A wide rigid floor at the top of a column, a second one on it; `unit` is the length of a metre, forces are kN."""
    ops.wipe()
    ops.model("basic", "-ndm", 2, "-ndf", 3)
    ops.geomTransf("Linear", 1)
    for node, x, y in [(1, 0.0, 0.0), (2, 0.0, 5.0), (3, 60.0, 5.0), (4, 90.0, 6.0), (5, 90.0, 0.0)]:
        ops.node(node, x * unit, y * unit)
    for node in (1, 5):
        ops.fix(node, 1, 1, 1)
    for node, mass in [(2, 40.0), (3, 70.0), (4, 10.0)]:
        ops.mass(node, mass / unit, mass / unit, 3.0 * mass * unit)
    for element, ends in enumerate([(1, 2), (5, 4)], 1):
        ops.element("elasticBeamColumn", element, *ends, unit**2, 3e7 / unit**2, 0.1 * unit**4, 1)
    ops.rigidLink("beam", 2, 3)
    ops.rigidLink("beam", 3, 4)


def test_constraints_do_not_depend_on_the_unit_of_length(export: Callable[..., None], tmp_path: Path) -> None:
    values = []
    for unit in (1.0, 1000.0):
        floor(unit)
        export(tmp_path / "m")
        values.append(ours(tmp_path / "m", 3))
    assert [len(found) for found in values] == [3, 3]
    # Round-off of the matrices, more where a floor turns than where it moves.
    assert values[1] == pytest.approx(values[0], rel=1e-9, abs=0)


@pytest.mark.parametrize("unit", [1.0, 1000.0])
def test_a_rigid_body_on_nothing_has_no_stiffness(unit: float, export: Callable[..., None], tmp_path: Path) -> None:
    ops.wipe()
    ops.model("basic", "-ndm", 2, "-ndf", 3)
    ops.geomTransf("Linear", 1)
    for node, x, y in [(1, 0.0, 0.0), (2, 0.7, 3.1), (3, 5.3, 1.7), (4, -2.3, 0.9)]:
        ops.node(node, x * unit, y * unit)
        ops.mass(node, 10.0, 10.0, 0.0)
    for element in (1, 2):
        ops.element("elasticBeamColumn", element, element + 1, element + 2, 1.0, 1e12, 0.1, 1)
    for node in (2, 3, 4):
        ops.rigidLink("beam", 1, node)
    export(tmp_path / "m")
    # Its elements do not deform: what is left of them is round-off.
    assert not io.mmread(tmp_path / "m.K.mtx").toarray().any()
    assert len((tmp_path / "m.dofs.csv").read_text().splitlines()) == 4


@pytest.mark.parametrize("factor", [-0.99, -1.01])
def test_a_slender_column_that_a_spring_pushes_over_is_named(factor: float, export: Callable[..., None], tmp_path: Path) -> None:
    # The stiffness of the tip, 3 EI/L^3, is 1e-8 of that of a dof.
    count = 60
    ops.wipe()
    ops.model("basic", "-ndm", 2, "-ndf", 3)
    ops.geomTransf("Linear", 1)
    for node in range(count + 1):
        ops.node(node + 1, 0.0, 10.0 * node / count)
        ops.mass(node + 1, 1.0, 1.0, 0.0)
    ops.node(999, 0.0, 10.0)
    for node in (1, 999):
        ops.fix(node, 1, 1, 1)
    for element in range(1, count + 1):
        ops.element("elasticBeamColumn", element, element, element + 1, 1.0, 3e7, 0.1, 1)
    ops.uniaxialMaterial("Elastic", 1, factor * 3.0 * 3e7 * 0.1 / 1000.0)
    ops.element("zeroLength", 999, 999, count + 1, "-mat", 1, "-dir", 1)
    if factor > -1.0:
        export(tmp_path / "m")
        return
    with pytest.raises(ValueError, match=r"K has an eigenvalue below 0 .* at (5\d|6\d)\.x"):
        export(tmp_path / "m")


def test_directions_are_those_of_the_space(export: Callable[..., None], tmp_path: Path) -> None:
    ops.wipe()
    ops.model("basic", "-ndm", 3, "-ndf", 3)
    ops.uniaxialMaterial("Elastic", 1, 1e5)
    ops.node(9, 0.1, 0.2, 3.0)
    ops.mass(9, 1.0, 1.0, 1.0)
    for node, x, y in [(1, 0.0, 0.0), (2, 2.0, 0.0), (3, 0.0, 2.0)]:
        ops.node(node, x, y, 0.0)
        ops.fix(node, 1, 1, 1)
        ops.element("Truss", node, node, 9, 0.01, 1)
    export(tmp_path / "m")
    rows = (tmp_path / "m.dofs.csv").read_text().splitlines()[1:]
    assert [row.split(",")[:2] for row in rows] == [["9", "x"], ["9", "y"], ["9", "z"]]
    with pytest.raises(ValueError, match="has 3 dofs and 3 coordinates"):
        export(tmp_path / "m", directions=["x", "y"])


DT, STEPS = 0.005, 600
CHANNELS = ["mast.4.x", "mast.4.y", "mast.foot", "mast.shear", "2.5*mast.4.x - 1e-1*mast.3.x"]
METRICS = [f"{reduction}({channel})" for channel in CHANNELS for reduction in ("peak", "last", "rms")]


def excitation() -> Any:
    return np.sin(np.linspace(0.0, 40.0, STEPS + 1)) * np.linspace(0.0, 1.0, STEPS + 1)


def their_motion() -> Any:
    """u of node 4 in x and y, forces of the column and a sum of displacements, by Newmark's method, with a gap of 4 mm at node 4, a load on node 3 and a motion of the ground."""
    chain(True)
    ops.rayleigh(0.3, 0.0, 0.001, 0.0)
    ops.node(5, 1.5, 8.0)
    ops.fix(5, 1, 1, 1)
    ops.uniaxialMaterial("ElasticPPGap", 7, 4e4, -1e20, -0.004)
    ops.element("zeroLength", 7, 4, 5, "-mat", 7, "-dir", 1)
    ops.timeSeries("Path", 1, "-dt", DT, "-values", *excitation(), "-factor", 4.0)
    ops.timeSeries("Path", 2, "-dt", DT, "-values", *excitation() ** 2, "-factor", 50.0)
    ops.pattern("UniformExcitation", 1, 1, "-accel", 1)
    ops.pattern("Plain", 2, 2)
    ops.load(3, 0.0, 1.0, 0.0)
    ops.constraints("Transformation")
    ops.numberer("RCM")
    ops.system("FullGeneral")
    ops.test("NormUnbalance", 1e-10, 50)
    ops.algorithm("Newton")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")
    rows = [[0.0] * len(CHANNELS)]
    for _ in range(STEPS):
        assert ops.analyze(1, DT) == 0
        x, y = ops.nodeDisp(4, 1), ops.nodeDisp(4, 2)
        rows.append([x, y, ops.eleResponse(1, "localForce")[2], ops.eleResponse(1, "force")[0], 2.5 * x - 0.1 * ops.nodeDisp(3, 1)])
    return np.array(rows)


def test_contacts_loads_and_channels_name_tied_dofs(export: Callable[..., None], program: str, tmp_path: Path) -> None:
    chain(False)
    ops.rayleigh(0.3, 0.0, 0.001, 0.0)
    export(tmp_path / "mast", forces={"foot": [(1, "localForce", 3)], "shear": [(1, "force", 1)]})
    times = (DT * np.arange(STEPS + 1)).tolist()
    study = {
        "problem": "structure",
        "parameters": {"dt": DT, "duration": STEPS * DT},
        "structure": {
            "matrices": {"mast": {**{key: f"mast.{key}.mtx" for key in "MKC"}, "dofs": "mast.dofs.csv", "ties": "mast.ties.csv", "forces": "mast.forces.csv"}},
            "contacts": {"stop": {"law": "impact", "between": ["mast.4.x", "ground"], "gap": 0.004, "k": 4e4}},
            "loads": [{"at": "mast.3.y", "table": {"t": times, "f": (excitation() ** 2).tolist()}, "scale": 50}],
            "ground": {"table": {"t": times, "f": excitation().tolist()}, "scale": 4},
        },
        "metrics": ["impacts(stop)", *METRICS],
    }
    (tmp_path / "study.json").write_text(json.dumps(study))
    subprocess.run([program, "run", str(tmp_path / "study.json"), "--out", str(tmp_path / "out")], check=True, capture_output=True)
    found = next(csv.DictReader((tmp_path / "out" / "study" / "results.csv").read_text().splitlines()))
    assert float(found["impacts(stop)"]) > 1
    expected = [value for u in their_motion().T for value in (np.abs(u).max(), u[-1], np.sqrt((u**2).mean()))]
    # Round-off: both solve the same equations, and OpenSees stops at an unbalanced force of 1e-10.
    assert [float(found[metric]) for metric in METRICS] == pytest.approx(expected, rel=1e-8, abs=0)


def plain(more: Callable[[], None] = lambda: None) -> None:
    """A column in space with its top at node 2; `more` adds what a study has to know."""
    ops.wipe()
    ops.model("basic", "-ndm", 3, "-ndf", 6)
    ops.geomTransf("Linear", 1, 1, 0, 0)
    ops.node(1, 0.0, 0.0, 0.0)
    ops.node(2, 0.0, 0.0, 5.0)
    ops.node(3, 0.0, 0.0, 5.0)
    for node in (1, 3):
        ops.fix(node, 1, 1, 1, 1, 1, 1)
    ops.mass(2, 50.0, 50.0, 50.0, 0.0, 0.0, 0.0)
    ops.element("elasticBeamColumn", 1, 1, 2, 0.2, 3e7, 1.2e7, 0.003, 0.002, 0.002, 1)
    more()


def spring(material: str, *numbers: float) -> Callable[[], None]:
    def add() -> None:
        ops.uniaxialMaterial(material, 5, *numbers)
        ops.element("zeroLength", 90, 3, 2, "-mat", 5, "-dir", 1)

    return add


def upper(transformation: str) -> Callable[[], None]:
    def add() -> None:
        ops.geomTransf(transformation, 7, 1, 0, 0)
        ops.node(4, 0.0, 0.0, 9.0)
        ops.mass(4, 10.0, 10.0, 10.0, 0.0, 0.0, 0.0)
        ops.element("elasticBeamColumn", 90, 2, 4, 0.2, 3e7, 1.2e7, 0.003, 0.002, 0.002, 7)

    return add


def bearing() -> None:
    ops.uniaxialMaterial("Elastic", 9, 1e6)
    others = [part for key in ("-P", "-T", "-My", "-Mz") for part in (key, 9)]
    ops.element("elastomericBearingPlasticity", 90, 3, 2, 5000.0, 50.0, 0.1, 0.0, 2.0, *others, "-orient", 0, 0, 1, 1, 0, 0)


def hinge() -> None:
    ops.node(4, 0.0, 0.0, 9.0)
    ops.mass(4, 10.0, 10.0, 10.0, 0.0, 0.0, 0.0)
    ops.uniaxialMaterial("Steel02", 1, 4e5, 2e8, 0.01, 18, 0.925, 0.15)
    ops.section("Fiber", 1, "-GJ", 1e6)
    ops.patch("rect", 1, 8, 8, -0.3, -0.3, 0.3, 0.3)
    ops.beamIntegration("Lobatto", 1, 1, 5)
    ops.element("forceBeamColumn", 90, 2, 4, 1, 1)


CHANGING: dict[str, Callable[[], None]] = {
    "bearing": bearing,
    "fibres": hinge,
    "corotational": upper("Corotational"),
    "P-delta": upper("PDelta"),
    "gap": spring("ElasticPPGap", 1e6, -1e9, -0.05),
    "wide gap": spring("ElasticPPGap", 1e6, 1e9, 0.2),
    "hook": spring("ENT", 1e6),
    "damper": spring("Viscous", 500.0, 0.4),
    "yielding": spring("Steel01", 100.0, 1e5, 0.01),
}


def straight(m: float, c: float, k: float) -> Any:
    """m M + c C + k K of all dofs in one matrix, those that are held as well."""
    ops.wipeAnalysis()
    for command, *values in [("system", "FullGeneral"), ("numberer", "Plain"), ("constraints", "Penalty", 0.0, 0.0),
                             ("algorithm", "Linear"), ("integrator", "GimmeMCK", m, c, k), ("analysis", "Transient")]:
        getattr(ops, str(command))(*values)
    ops.analyze(1, 0.0)
    return np.reshape(ops.printA("-ret"), (ops.systemSize(), -1))


@pytest.mark.parametrize("modal", [False, True])
def test_blocks_of_rows_are_the_matrix_at_once(modal: bool, export: Callable[..., None], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    storeys(3, True)
    if modal:
        ops.eigen("-fullGenLapack", 5)
        ops.modalDamping(0.05)
    else:
        ops.rayleigh(0.1, 0.0, 0.01, 0.0)
    import opensees

    monkeypatch.setattr(opensees, "PART", 20)
    export(tmp_path / "m")
    found = {key: io.mmread(tmp_path / f"m.{key}.mtx").toarray() for key in "MCK"}
    # The rows that are kept, and those that follow them, by names.
    names = [(node, direction) for node in ops.getNodeTags() for direction in ("x", "y", "z", "rx", "ry", "rz")]
    kept = [tuple(line.split(",")[:2]) for line in (tmp_path / "m.dofs.csv").read_text().splitlines()[1:]]
    T = np.zeros((len(names), len(kept)))
    for column, (node, direction) in enumerate(kept):
        T[names.index((int(node), direction)), column] = 1.0
    for node, direction, *cells in (line.split(",") for line in (tmp_path / "m.ties.csv").read_text().splitlines()[1:]):
        for cell in cells:
            dof, factor = cell.split(":")
            T[names.index((int(node), direction)), kept.index(tuple(dof.split(".")))] = float(factor)
    for key, matrix in found.items():
        expected = T.T @ straight(*(float(key == other) for other in "MCK")) @ T
        assert matrix == pytest.approx(expected, rel=0, abs=1e-13 * np.abs(expected).max())


SIZE = """
import openseespy.opensees as ops
from opensees import export
ops.model("basic", "-ndm", 3, "-ndf", 6)
ops.geomTransf("Linear", 1, 0, 0, 1)
for i in range(200):
    ops.node(i, 2.0 * i, 0.0, 0.0)
    ops.mass(i, 10, 10, 10, 1, 1, 1)
    if i:
        ops.element("elasticBeamColumn", i, i - 1, i, 6.0, 3e7, 1.2e7, 8.0, 3.0, 40.0, 1)
    if i % 2:
        ops.node(1000 + i, 2.0 * i, 3.0, -1.0)
        ops.rigidLink("beam", i, 1000 + i)
    if i % 20 == 0:
        ops.fix(i, 1, 1, 1, 1, 0, 0)
export("m")
# ru_maxrss would count what the parent had when it began this process.
print("MB", next(int(line.split()[1]) // 1024 for line in open("/proc/self/status") if line.startswith("VmHWM")))
"""


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="only Linux tells the largest memory of a process")
def test_a_model_of_1800_dofs_needs_little_memory(tmp_path: Path) -> None:
    done = subprocess.run([sys.executable, "-c", SIZE], cwd=tmp_path, env={**os.environ, "PYTHONPATH": str(MODELS)}, capture_output=True, text=True, check=True)
    # One matrix of all dofs as numbers of Python has 100 MB, with a dense one beside it.
    assert int(next(line.split()[1] for line in done.stdout.splitlines() if line.startswith("MB"))) < 200
    assert len((tmp_path / "m.dofs.csv").read_text().splitlines()) == 1 + 6 * 200 - 4 * 10


E_I, LENGTH = 3e7 * 0.002, 5.0


def gravity(load: float, steps: int = 10) -> None:
    """A column with P-delta and a load on its top, at rest."""
    ops.wipe()
    ops.model("basic", "-ndm", 2, "-ndf", 3)
    ops.geomTransf("PDelta", 1)
    ops.node(1, 0.0, 0.0)
    ops.node(2, 0.0, LENGTH)
    ops.fix(1, 1, 1, 1)
    ops.mass(2, 50.0, 50.0, 0.0)
    ops.element("elasticBeamColumn", 1, 1, 2, 0.2, 3e7, 0.002, 1)
    ops.timeSeries("Linear", 1)
    ops.pattern("Plain", 1, 1)
    ops.load(2, 0.0, -load, 0.0)
    for command, *values in [("constraints", "Transformation"), ("numberer", "RCM"), ("system", "BandGeneral"), ("test", "NormUnbalance", 1e-9, 20),
                             ("algorithm", "Newton"), ("integrator", "LoadControl", 0.1), ("analysis", "Static")]:
        getattr(ops, str(command))(*values)
    if steps:
        assert ops.analyze(steps) == 0
    ops.loadConst("-time", 0.0)


# Euler's load of this element is a little above 3 EI/L^2, where the P/L of P-delta takes all of 3 EI/L^3.
@pytest.mark.parametrize("part", [0.5, 1.01])
def test_gravity_is_in_k_by_p_delta(part: float, export: Callable[..., None], tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    load = part * 3.0 * E_I / LENGTH**2
    gravity(load)
    export(tmp_path / "m")
    printed = capsys.readouterr().out
    assert "at rest under pattern 1" in printed and "element 1 of nodes 1, 2" in printed
    assert ("K has 1 eigenvalue below 0, largest at 2.x" in printed) == (part > 1.0)
    K = io.mmread(tmp_path / "m.K.mtx").toarray()
    expected = [[12.0 * E_I / LENGTH**3 - load / LENGTH, 0.0, 6.0 * E_I / LENGTH**2], [0.0, 0.2 * 3e7 / LENGTH, 0.0], [6.0 * E_I / LENGTH**2, 0.0, 4.0 * E_I / LENGTH]]
    # The load is balanced to 1e-9.
    assert K == pytest.approx(np.array(expected), rel=1e-9, abs=1e-6)


def test_the_example_of_the_guide_runs(export: Callable[..., None], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    code = (MODELS / "pier.py").read_text()
    page = (MODELS.parents[1] / "docs" / "guide.md").read_text()
    assert code.splitlines()[-1] in page
    ops.wipe()
    monkeypatch.chdir(tmp_path)
    exec(code, {})
    K = io.mmread("pier.K.mtx").toarray()
    # The weight over the height.
    assert K[0, 0] == pytest.approx(12.0 * 3e7 * 0.12 / 8.0**3 - 60.0 * 9.81 / 8.0, rel=1e-9, abs=0)
    found = forces_of(tmp_path / "pier.forces.csv")
    assert {name: quantity for name, (quantity, _) in found.items()} == {"base_shear": "force", "base_moment": "moment"}
    assert found["base_shear"][1]["2.x"] == pytest.approx(-K[0, 0], rel=1e-9, abs=0)


def test_loads_that_are_not_analysed_are_refused(export: Callable[..., None], tmp_path: Path) -> None:
    gravity(1000.0, steps=0)
    with pytest.raises(ValueError, match="pattern 1 has a load on node 2: .* at rest"):
        export(tmp_path / "m", nonlinear=True)


def forces_of(path: Path) -> dict[str, tuple[str, dict[str, float]]]:
    rows = [line.split(",") for line in path.read_text().splitlines()[1:]]
    return {name: (quantity, {dof: float(factor) for dof, factor in (cell.split(":") for cell in cells)}) for name, quantity, *cells in rows}


def test_forces_of_members_are_those_of_opensees(export: Callable[..., None], tmp_path: Path) -> None:
    storeys(2, True)
    names: dict[str, list[tuple[int, str, int]]] = {
        "shear": [(element, "force", 1) for element in range(1, 5)],
        "foot": [(1, "localForce", 5)],
        "axial": [(10, "localForce", 1)],
        "torsion": [(12, "force", 4)],
    }
    export(tmp_path / "m", forces=names)
    found = forces_of(tmp_path / "m.forces.csv")
    assert [quantity for quantity, _ in found.values()] == ["force", "moment", "force", "moment"]
    # The model moves under forces that have nothing to do with one another.
    ops.timeSeries("Linear", 1)
    ops.pattern("Plain", 1, 1)
    for node in (11, 12, 13, 14, 21, 22, 23, 24):
        ops.load(node, *(1e3 * np.sin(node * np.arange(1.0, 7.0))))
    for command, *values in [("constraints", "Transformation"), ("numberer", "RCM"), ("system", "BandGeneral"),
                             ("algorithm", "Linear"), ("integrator", "LoadControl", 1.0), ("analysis", "Static")]:
        getattr(ops, str(command))(*values)
    assert ops.analyze(1) == 0
    for name, (_, terms) in found.items():
        dofs = [dof.split(".") for dof in terms]
        value = sum(factor * ops.nodeDisp(int(node), 1 + ["x", "y", "z", "rx", "ry", "rz"].index(direction)) for (node, direction), factor in zip(dofs, terms.values(), strict=True))
        expected = sum(ops.eleResponse(element, response)[number - 1] for element, response, number in names[name])
        largest = max(abs(factor * ops.nodeDisp(int(node), 1 + ["x", "y", "z", "rx", "ry", "rz"].index(direction))) for (node, direction), factor in zip(dofs, terms.values(), strict=True))
        assert value == pytest.approx(expected, rel=0, abs=1e-11 * largest), name


@pytest.mark.parametrize(
    ("force", "part"),
    [
        ([(1, "force", 13)], "element 1 has no `force` of its 12 dofs with a number 13"),
        ([(99, "force", 1)], "element 99 has no"),
        ([(1, "basicForce", 1)], "has no `basicForce`"),
        ([(1, "force", 1), (1, "force", 5)], "must be a sum of forces, or of moments"),
    ],
)
def test_forces_that_are_none_are_named(force: list[tuple[int, str, int]], part: str, export: Callable[..., None], tmp_path: Path) -> None:
    plain()
    with pytest.raises(ValueError, match=f"force f.* {part}|force f {part}"):
        export(tmp_path / "m", forces={"f": force})


@pytest.mark.parametrize("case", CHANGING)
def test_elements_whose_matrices_change_are_named(case: str, export: Callable[..., None], tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    plain(CHANGING[case])
    with pytest.raises(ValueError, match=r"1 elements .* \(element 90 of nodes") as refused:
        export(tmp_path / "m")
    assert "nonlinear=True" in str(refused.value) and not list(tmp_path.iterdir())
    # The model is at its start again.
    export(tmp_path / "m", nonlinear=True)
    assert "element 90 of nodes" in capsys.readouterr().out
    assert io.mmread(tmp_path / "m.K.mtx").toarray()[0, 0] >= 5760.0 - 1e-6


@pytest.mark.parametrize("material", [("Elastic", 1e6), ("Viscous", 500.0, 1.0)])
def test_linear_parts_beside_a_column_are_exported(material: tuple[Any, ...], export: Callable[..., None], tmp_path: Path) -> None:
    plain(spring(*material))
    ops.rayleigh(0.1, 0.0, 0.001, 0.0)
    export(tmp_path / "m")
    K, C = (io.mmread(tmp_path / f"m.{key}.mtx").toarray() for key in "KC")
    # 12 EI/L^3; Rayleigh damping is that of the column, since springs without length have none unless it is asked for.
    k, c = (1e6, 0.0) if material[0] == "Elastic" else (0.0, 500.0)
    assert K[0, 0] == pytest.approx(5760.0 + k, rel=1e-12, abs=0)
    assert C[0, 0] == pytest.approx(0.1 * 50.0 + 0.001 * 5760.0 + c, rel=1e-12, abs=0)


def test_modal_damping_is_in_c(export: Callable[..., None], tmp_path: Path) -> None:
    plain()
    squares = ops.eigen("-fullGenLapack", 2)
    ops.modalDamping(0.05)
    export(tmp_path / "m")
    C = io.mmread(tmp_path / "m.C.mtx").toarray()
    # The two modes of bending have mass in x and y alone.
    assert C.diagonal()[:3] == pytest.approx([*(2.0 * 0.05 * np.sqrt(squares) * 50.0), 0.0], rel=1e-9, abs=1e-12)


def loaded(load: Callable[[], None]) -> Callable[[], None]:
    def add() -> None:
        ops.timeSeries("Linear", 1)
        ops.pattern("Plain", 4, 1)
        load()

    return add


@pytest.mark.parametrize(
    ("load", "part"),
    [
        (lambda: ops.load(2, 10.0, 0, 0, 0, 0, 0), "a load on node 2"),
        (lambda: ops.eleLoad("-ele", 1, "-type", "-beamUniform", 1.0, 1.0, 0.0), "a load on element 1"),
        (lambda: ops.sp(2, 1, 0.01), "a motion of nodes"),
    ],
)
def test_loads_are_refused(load: Callable[[], None], part: str, export: Callable[..., None], tmp_path: Path) -> None:
    plain(loaded(load))
    with pytest.raises(ValueError, match=f"pattern 4 has {part}"):
        export(tmp_path / "m")
    assert not list(tmp_path.iterdir())
