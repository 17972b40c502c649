"""Two planar frames with bending, built with OpenSees and exported as `frames`: what opensees.py is tried with.

    python3 frame.py [FOLDER]

Units t, kN, m, s. The left frame is plumb. The columns of the right one lean to the left by 0.02: at its roof the frames are 0.06 m
apart, and its face there has the normal (0.9998, 0.02). The masses of the nodes are in x and y: the rotations have none. Needs openseespy.
"""

import sys
from pathlib import Path

import openseespy.opensees as ops

from opensees import export

# Nodes: storey s (0 is the ground), column c of frame f is 100 f + 10 s + c.
FRAMES = {1: {"x": (0.0, 6.0), "lean": 0.0, "mass": 20.0, "storey": 3.2},
          2: {"x": (6.24, 11.24), "lean": -0.02, "mass": 32.0, "storey": 3.0}}
COLUMN = (0.09, 3.0e7, 6.75e-4)   # A, E, I
BEAM = (0.12, 3.0e7, 1.6e-3)


def build(rotary=0.0, damping=(0.4, 0.0), storeys=3, fixed=True):
    """`rotary`: mass of the rotations; `damping`: Rayleigh's factors of M and K; `fixed`: whether the ground holds the columns."""
    ops.wipe()
    ops.model("basic", "-ndm", 2, "-ndf", 3)
    ops.geomTransf("Linear", 1)
    element = 0
    for f, frame in FRAMES.items():
        for s in range(storeys + 1):
            for c, x in enumerate(frame["x"], 1):
                y = s * frame["storey"]
                node = 100 * f + 10 * s + c
                ops.node(node, x + frame["lean"] * y, y)
                if s == 0:
                    if fixed:
                        ops.fix(node, 1, 1, 1)
                    continue
                ops.mass(node, frame["mass"] / 2, frame["mass"] / 2, rotary)
                element += 1
                ops.element("elasticBeamColumn", element, node - 10, node, *COLUMN, 1)
            if s > 0:
                element += 1
                ops.element("elasticBeamColumn", element, node - 1, node, *BEAM, 1)
    ops.rayleigh(damping[0], damping[1], 0.0, 0.0)


def main():
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    folder.mkdir(parents=True, exist_ok=True)
    build()
    export(folder / "frames")


if __name__ == "__main__":
    main()
