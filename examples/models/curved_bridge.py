"""A curved bridge of two frames by OpenSees, exported as `curved-bridge`, without contacts.

    python3 curved_bridge.py [FOLDER]

Units t, kN, m, s; z up. The deck has a radius of 150 m: 84 m from abutment A1 over pier P1 to pier P2 (nodes 100 to 107), 36 m from there
to abutment A2 (200 to 203). Each pier is a column with a rigid cap (1000 to 1003, 2000 to 2003, its top). Ten pairs of nodes are bearings,
which hold z only: below 3000 to 3009, above 4000 to 4009, at A1, P1, P2 (of each frame) and A2, 3 m left and right of the axis. Corners of
the deck, 5 m left and right: 5000, 5001 and 5010, 5011 at the joint, 5020, 5021 at A1, 5030, 5031 at A2. The weight on each bearing is
printed. Needs openseespy and scipy.
"""

import math
import sys
from pathlib import Path

import openseespy.opensees as ops

from opensees import export

RADIUS, DEPTH, CAP = 150.0, 1.2, 2.0                                     # axis; axis of the deck to bearings; bearings to a column
DECK = (7.0, 3.3e7, 1.35e7, 8.0, 3.0, 55.0)                              # A, E, G, J, I of vertical bending, I of lateral bending
COLUMN = (3.2, 3.3e7, 1.35e7, 1.6, 0.82, 0.82)
DECK_MASS, WIDTH, COLUMN_MASS, CAP_MASS, VERTICAL = 17.0, 10.0, 8.0, 40.0, 2e6
FRAMES = {100: (0.0, 84.0, 7), 200: (84.0, 36.0, 3)}                     # first node: from, length, elements
PIERS = {1000: (36.0, 14.0), 2000: (84.0, 9.0)}                          # first node: where, height
# Node of the deck, pier (0: abutment), along the axis.
BEARINGS = [(100, 0, 0.0), (103, 1000, 36.0), (107, 2000, 83.2), (200, 2000, 84.8), (203, 0, 120.0)]
CORNERS = {5000: (107, 84.0), 5010: (200, 84.0), 5020: (100, 0.0), 5030: (203, 120.0)}


def position(s, left=0.0, z=0.0):
    angle = s / RADIUS
    return (RADIUS - left) * math.sin(angle), RADIUS - (RADIUS - left) * math.cos(angle), z


def build(horizontal=0.0):
    """The bridge; `horizontal` is a stiffness of the bearings, for its weight at rest."""
    ops.wipe()
    ops.model("basic", "-ndm", 3, "-ndf", 6)
    ops.geomTransf("Linear", 1, 0, 0, 1)
    ops.geomTransf("Linear", 2, 1, 0, 0)
    element = 0
    for first, (start, length, count) in FRAMES.items():
        for i in range(count + 1):
            ops.node(first + i, *position(start + length * i / count))
            m = DECK_MASS * length / count * (0.5 if i in (0, count) else 1.0)
            ops.mass(first + i, m, m, m, m * WIDTH**2 / 12, m / 2, m * WIDTH**2 / 12)
            if i:
                element += 1
                ops.element("elasticBeamColumn", element, first + i - 1, first + i, *DECK, 1)
    for first, (s, height) in PIERS.items():
        for k in range(4):
            ops.node(first + k, *position(s, 0.0, -DEPTH - CAP - height + height * k / 3))
            if k == 0:
                ops.fix(first, *[1] * 6)
                continue
            m, turning = COLUMN_MASS * height / 3, 0.0
            if k == 3:
                m = m / 2 + CAP_MASS
                turning = 1.5 * m
            ops.mass(first + k, m, m, m, turning, turning, turning)
            element += 1
            ops.element("elasticBeamColumn", element, first + k - 1, first + k, *COLUMN, 2)
    ops.uniaxialMaterial("Elastic", 1, VERTICAL)
    ops.uniaxialMaterial("Elastic", 2, max(horizontal, 1.0))
    bearings = []
    for deck, pier, s in BEARINGS:
        for left in (-3.0, 3.0):
            below, above = 3000 + len(bearings), 4000 + len(bearings)
            for node in (below, above):
                ops.node(node, *position(s, left, -DEPTH))
            ops.rigidLink("beam", deck, above)
            if pier:
                ops.rigidLink("beam", pier + 3, below)
            else:
                ops.fix(below, *[1] * 6)
            element += 1
            ops.element("zeroLength", element, below, above, "-mat", 1, "-dir", 3)
            bearings.append(element)
            if horizontal:
                ops.element("zeroLength", 10000 + element, below, above, "-mat", 2, 2, "-dir", 1, 2)
    for corner, (deck, s) in CORNERS.items():
        for side, left in enumerate((-5.0, 5.0)):
            ops.node(corner + side, *position(s, left))
            ops.rigidLink("beam", deck, corner + side)
    return bearings


def weights():
    """The weight on each bearing, kN."""
    bearings = build(horizontal=1e4)
    ops.timeSeries("Linear", 1)
    ops.pattern("Plain", 1, 1)
    for node in ops.getNodeTags():
        ops.load(node, 0, 0, -9.81 * ops.nodeMass(node)[2], 0, 0, 0)
    ops.constraints("Transformation")
    ops.numberer("RCM")
    ops.system("UmfPack")
    ops.test("NormDispIncr", 1e-10, 10)
    ops.algorithm("Newton")
    ops.integrator("LoadControl", 1.0)
    ops.analysis("Static")
    if ops.analyze(1) != 0:
        raise RuntimeError("the bridge does not come to rest under its weight")
    return [-ops.basicForce(bearing)[0] for bearing in bearings]


def main():
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    folder.mkdir(parents=True, exist_ok=True)
    print("weight on the bearings:", [round(force, 1) for force in weights()])
    build()
    export(folder / "curved-bridge")


if __name__ == "__main__":
    main()
