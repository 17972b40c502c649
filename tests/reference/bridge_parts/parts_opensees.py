"""The laws of parts of bridges by OpenSees; writes ../../data/parts_opensees.json.

Each row of `materials` is a uniaxial material that is stretched to `x`, step by step, and its force `S`. The signs are those of slipgap:
r = x + `gap`, S > 0 pulls. `numbers` are those of the law of slipgap.

The histories have a point at every end of the gap. Two materials need it, because they look at whole steps: ElasticPPGap without
damage moves its spring back only in a step that ends in the gap, and ImpactMaterial gives the whole step that closes the gap
to its spring.

`damper` is a mass on a spring with the material Viscous, by Newmark's average acceleration: u after each step.

Run:  python3 parts_opensees.py     (needs openseespy)
"""

import json
import math
import pathlib

import openseespy.opensees as ops

STEPS = 150


def history(gap):
    points, last = [], 0.0
    for i in range(1, STEPS + 1):
        t = i / STEPS
        x = (1 + 2.2 * t) * math.sin(2 * math.pi * 3.3 * t) + 0.8 * math.sin(2 * math.pi * 8.7 * t)
        if gap and (last + gap) * (x + gap) < 0:
            # Just closed where it opens.
            points.append(-gap - (1e-13 if last < -gap else 0.0))
        points.append(x)
        last = x
    return points


def forces(material, xs):
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    ops.uniaxialMaterial(material[0], 1, *material[1:])
    ops.testUniaxialMaterial(1)
    found = []
    for x in xs:
        ops.setStrain(x)
        found.append(ops.getStress())
    return found


def materials():
    k, fy, gap = 2.5, 3.0, 0.4
    table = [0.5, 1.0, 1.5, 2.0, 4.0, 2.5]
    for ratio in (0.1, -0.1):
        yield "bilinear", {"k1": k, "Fy": fy, "ratio": ratio}, 0.0, ["Steel01", fy, k, ratio]
    for eta in (0.0, 0.1):
        for damage in (1, 0):
            numbers = {"k": k, "Fy": fy, "hardening": eta, "damage": damage}
            yield "gap-yield", numbers, gap, ["ElasticPPGap", k, -fy, -gap, eta] + ["damage"] * damage
    yield "restrainer", {"slack": gap, "k": k, "Fy": fy, "hardening": 0.1}, 0.0, ["ElasticPPGap", k, fy, gap, 0.1, "damage"]
    points = {"r": table[::2], "S": table[1::2]}
    yield "multilinear", {"table": points}, 0.0, ["MultiLinear", *table]
    numbers = {"k": k, "Fult": 5.0, "Rf": 0.7, "k_unloading": 4.0}
    yield "hyperbolic-gap", numbers, gap, ["HyperbolicGapMaterial", k, 4.0, 0.7, -5.0, -gap]
    yield "impact-yield", {"k1": k, "k2": 0.8, "delta_y": 0.5}, gap, ["ImpactMaterial", k, 0.8, -0.5, -gap]


def damper(mass, k, c, a, v, dt, steps):
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    for node in (1, 2):
        ops.node(node, 0.0)
    ops.fix(1, 1)
    ops.mass(2, mass)
    ops.uniaxialMaterial("Elastic", 1, k)
    ops.uniaxialMaterial("Viscous", 2, c, a)
    for part in (1, 2):
        ops.element("zeroLength", part, 1, 2, "-mat", part, "-dir", 1)
    ops.setNodeVel(2, 1, v, "-commit")
    ops.setNodeAccel(2, 1, -c * v**a / mass, "-commit")
    ops.constraints("Plain")
    ops.numberer("Plain")
    ops.system("FullGeneral")
    ops.test("NormUnbalance", 1e-13, 200, 0)
    ops.algorithm("Newton")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")
    u = []
    for _ in range(steps):
        assert ops.analyze(1, dt) == 0
        u.append(ops.nodeDisp(2, 1))
    return {"mass": mass, "k": k, "c": c, "a": a, "v": v, "dt": dt, "u": u}


def main():
    rows = []
    for law, numbers, gap, material in materials():
        xs = history(gap or (-numbers["slack"] if "slack" in numbers else 0.0))
        row = {"law": law, "numbers": numbers, "gap": gap, "material": material[0], "x": xs, "S": forces(material, xs)}
        rows.append(row)
    dampers = [damper(1.5, 20.0, 0.8, a, 1.3, 0.02, 60) for a in (0.5, 1.0, 1.4, 2.0)]
    out = pathlib.Path(__file__).parents[2] / "data" / "parts_opensees.json"
    lists = ",\n".join(json.dumps(row) for row in rows), ",\n".join(json.dumps(row) for row in dampers)
    out.write_text('{"materials": [\n%s\n],\n"dampers": [\n%s\n]}\n' % lists)


if __name__ == "__main__":
    main()
