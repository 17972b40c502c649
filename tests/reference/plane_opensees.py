"""OpenSees' singleFPBearing in three dimensions, for docs/findings-plane.md. Needs numpy and openseespy.

    plane_opensees.py static    force at a displacement of 0.05 to 0.3 R in three directions, nearly without friction
    plane_opensees.py motion    peak displacement of a mass on the bearing under the two components of a record
"""

import math
import pathlib
import sys

import numpy as np
import openseespy.opensees as ops

from records import smc

RECORDS = pathlib.Path(__file__).parents[2] / "studies" / "records"
PAIRS = {
    "redwood": ["lomaprieta-1989-redwoodcity-apeel2-043.smc", "lomaprieta-1989-redwoodcity-apeel2-133.smc"],
    "shafter": ["lomaprieta-1989-sanfrancisco-shafter-360.smc", "lomaprieta-1989-sanfrancisco-shafter-270.smc"],
}
G = 9.81


def bearing(radius, friction, initial, weight):
    """A node on the bearing, pressed by its weight; rotations are held."""
    ops.wipe()
    ops.model("basic", "-ndm", 3, "-ndf", 6)
    ops.node(1, 0, 0, 0)
    ops.node(2, 0, 0, 0)
    ops.fix(1, 1, 1, 1, 1, 1, 1)
    ops.fix(2, 0, 0, 0, 1, 1, 1)
    ops.frictionModel("Coulomb", 1, friction)
    ops.uniaxialMaterial("Elastic", 1, 1e7 * weight)
    ops.uniaxialMaterial("Elastic", 2, 0.0)
    ops.element("singleFPBearing", 1, 1, 2, 1, radius, initial, "-P", 1, "-T", 2, "-My", 2, "-Mz", 2,
                "-orient", 0, 0, 1, 1, 0, 0, "-iter", 100, 1e-12)
    ops.timeSeries("Linear", 1)
    ops.pattern("Plain", 1, 1)
    ops.load(2, 0, 0, -weight, 0, 0, 0)
    ops.constraints("Transformation")
    ops.numberer("RCM")
    ops.system("FullGeneral")
    ops.test("NormDispIncr", 1e-12, 100)
    ops.algorithm("Newton")
    ops.integrator("LoadControl", 0.1)
    ops.analysis("Static")
    assert ops.analyze(10) == 0
    ops.loadConst("-time", 0.0)


def static():
    for part in (0.05, 0.1, 0.2, 0.3):
        for degrees in (0.0, 22.5, 45.0):
            bearing(1.0, 1e-6, 1e6, 1000.0)
            c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
            ops.timeSeries("Linear", 2)
            ops.pattern("Plain", 2, 2)
            ops.sp(2, 1, part * c)
            ops.sp(2, 2, part * s)
            ops.integrator("LoadControl", 0.01)
            ops.analysis("Static")
            assert ops.analyze(100) == 0
            force = ops.eleResponse(1, "force")
            along, across = force[6] * c + force[7] * s, force[7] * c - force[6] * s
            print(f"u/R {part}, {degrees} degrees: force/(W u/R) {along / (1000 * part):.5f}, across {across / (1000 * part):.5f}, "
                  f"sphere {1 / math.sqrt(1 - part**2):.5f}")


def motion(radius=2.0, friction=0.05, elastic=0.0005, step=0.0005):
    for name, files in PAIRS.items():
        for scale in (1, 2):
            components = []
            for file in files:
                dt, unit, values = smc((RECORDS / file).read_text().splitlines())
                components.append(scale * unit * values)
            end = min(map(len, components))
            mass, weight = 1.0, G
            bearing(radius, friction, friction * weight / elastic, weight)
            ops.mass(2, mass, mass, mass, 0, 0, 0)
            for direction, values in enumerate(components, 1):
                ops.timeSeries("Path", 10 + direction, "-dt", dt, "-values", *values[:end])
                ops.pattern("UniformExcitation", 10 + direction, direction, "-accel", 10 + direction)
            ops.wipeAnalysis()
            ops.constraints("Transformation")
            ops.numberer("RCM")
            ops.system("FullGeneral")
            ops.test("NormDispIncr", 1e-10, 100)
            ops.algorithm("Newton")
            ops.integrator("Newmark", 0.5, 0.25)
            ops.analysis("Transient")
            peak, last = 0.0, None
            for _ in range(int(round((end - 1) * dt / step))):
                if ops.analyze(1, step) != 0:
                    print(name, scale, "fails at", ops.getTime())
                    break
                last = (ops.nodeDisp(2, 1), ops.nodeDisp(2, 2))
                peak = max(peak, math.hypot(*last))
            print(f"{name}, scale {scale}: peak {peak:.6f} m, peak/R {peak / radius:.3f}, last {math.hypot(*last):.6f}")


if __name__ == "__main__":
    {"static": static, "motion": motion}[sys.argv[1]]()
