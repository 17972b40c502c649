"""A pier with P-delta under its weight, exported with its base shear and base moment as `pier`: gravity is analysed first.

    python3 pier.py

Units t, kN, m, s. Needs openseespy.
"""

import openseespy.opensees as ops

from opensees import export

ops.model("basic", "-ndm", 2, "-ndf", 3)
ops.geomTransf("PDelta", 1)
ops.node(1, 0.0, 0.0)
ops.node(2, 0.0, 8.0)
ops.fix(1, 1, 1, 1)
ops.mass(2, 60.0, 60.0, 0.0)
ops.element("elasticBeamColumn", 1, 1, 2, 1.2, 3e7, 0.12, 1)
ops.timeSeries("Linear", 1)
ops.pattern("Plain", 1, 1)
ops.load(2, 0.0, -60.0 * 9.81, 0.0)
ops.constraints("Transformation")
ops.numberer("RCM")
ops.system("BandGeneral")
ops.test("NormUnbalance", 1e-8, 20)
ops.algorithm("Newton")
ops.integrator("LoadControl", 0.1)
ops.analysis("Static")
ops.analyze(10)
ops.loadConst("-time", 0.0)
export("pier", forces={"base_shear": [(1, "force", 1)], "base_moment": [(1, "localForce", 3)]})
