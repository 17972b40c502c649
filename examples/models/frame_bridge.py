"""A frame bridge of five spans by OpenSees, exported as `frame-bridge`: piers and deck with bending, without contacts.

    python3 frame_bridge.py [FOLDER]

Units t, kN, m, s; x along the bridge, y up. Pier i = 1 to 4 has the nodes 100 i + 10 (fixed) to 100 i + 13 (its top), span s = 1 to 5
the nodes 1000 s to 1000 s + 4. Each span has a fixed bearing on its left, a bearing that holds y only on its right; the first has a soft
one on the abutment. Files C0.2 and C0.03 have Rayleigh damping, with about these ratios in the first axial mode of a span, of
the members, not of the bearings. Needs openseespy.
"""

import shutil
import sys
from pathlib import Path

import openseespy.opensees as ops

from opensees import export

SPAN, ELEMENTS, HEIGHTS = 40.0, 4, [12.0, 18.0, 15.0, 10.0]
DECK, PIER = (6.0, 3.2e7, 4.0), (4.0, 3.0e7, 1.2)   # A, E, I
DECK_MASS, PIER_MASS = 16.0, 10.0                   # per length
FIXED, VERTICAL, SOFT = 2e5, 5e6, 1e4               # stiffness of bearings
# Factors of M and of K of the members in C.
DAMPING = {"0.2": (0.25, 0.0015), "0.03": (0.25, 0.0002)}


def build(damping):
    ops.wipe()
    ops.model("basic", "-ndm", 2, "-ndf", 3)
    ops.geomTransf("Linear", 1)
    element = 0
    for i, height in enumerate(HEIGHTS, 1):
        for k in range(4):
            node = 100 * i + 10 + k
            ops.node(node, SPAN * i, -height + height * k / 3)
            if k == 0:
                ops.fix(node, 1, 1, 1)
                continue
            m = PIER_MASS * height / 3 * (0.5 if k == 3 else 1.0)
            ops.mass(node, m, m, m * (height / 3) ** 2 / 12)
            element += 1
            ops.element("elasticBeamColumn", element, node - 1, node, *PIER, 1)
    for s in range(1, 6):
        for j in range(ELEMENTS + 1):
            node = 1000 * s + j
            ops.node(node, SPAN * (s - 1) + SPAN * j / ELEMENTS, 0.0)
            m = DECK_MASS * SPAN / ELEMENTS * (0.5 if j in (0, ELEMENTS) else 1.0)
            ops.mass(node, m, m, 0.0)
            if j:
                element += 1
                ops.element("elasticBeamColumn", element, node - 1, node, *DECK, 1)
    for abutment, x in ((1, 0.0), (2, 5 * SPAN)):
        ops.node(abutment, x, 0.0)
        ops.fix(abutment, 1, 1, 1)
    for material, stiffness in ((1, FIXED), (2, VERTICAL), (3, SOFT)):
        ops.uniaxialMaterial("Elastic", material, stiffness)
    under = [1, *(100 * i + 13 for i in range(1, 5)), 2]
    for s in range(1, 6):
        first, last = 1000 * s, 1000 * s + ELEMENTS
        ops.element("zeroLength", element + 1, under[s - 1], first, "-mat", 3 if s == 1 else 1, 2, "-dir", 1, 2)
        ops.element("zeroLength", element + 2, under[s], last, "-mat", 2, "-dir", 2)
        element += 2
    ops.rayleigh(damping[0], damping[1], 0.0, 0.0)


def main():
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    folder.mkdir(parents=True, exist_ok=True)
    for name, damping in DAMPING.items():
        build(damping)
        export(folder / "frame-bridge")
        shutil.move(folder / "frame-bridge.C.mtx", folder / f"frame-bridge.C{name}.mtx")


if __name__ == "__main__":
    main()
