"""The rows of the blocks with 10^3, 10^4 and 10^5 degrees of freedom."""

import json

import numpy as np

import at_hand
import large
from large import FEW, MESHES, STEPS
from large_superlu import superlu

STEPS_OF_OPENSEES = [(200, 40), (50, 10), (10, 3)]  # without and with contacts
DEMANDED = 1e-9  # relative difference of u


def row(place, program, folder, turns, part, rate):
    of, steps = large.Block(*MESHES[place]), max(STEPS[place] // part, FEW)
    folder = folder / str(len(of))
    large.write(of, folder)
    below, entries, factor = program.guard("factor", folder / "block.M.mtx", folder / "block.K.mtx", of.dt)
    # Both ways through the factor, 24 bytes for a spring, and twelve vectors.
    data = int(16 * entries + 24 * (below + len(of)) + 96 * len(of))
    found = {"problem": f"block, {len(of)} dofs, {len(of.face)} contacts", "cases": 1, "steps": steps}
    found["floor"] = data / rate(data)
    studies = [json.loads(large.study(of, count, ["peak(face.1.S)"])) for count in (FEW, FEW + steps)]
    runs = [[program.run(study, folder) for study in studies] for _ in range(turns)]
    few, whole = (min(pair[i][0] for pair in runs) for i in (0, 1))
    found["whole"] = whole / (FEW + steps) * 1e9
    found["kernel"] = (whole - few) / steps * 1e9
    found["MB"], found["factor"] = max(pair[1][1] for pair in runs), factor / 1e6
    if opensees := at_hand.module("large_opensees"):
        free, touching = STEPS_OF_OPENSEES[place]
        u = superlu(of, free)
        *_, own = opensees.run(of, False, free)
        apart = np.max(np.abs(own - u)) / np.max(np.abs(u))
        assert apart < DEMANDED, (len(of), apart)
        found["OpenSees"] = 1e6 * opensees.run(of, True, touching)[1]
    return found


def rows(program, folder, turns, part, rate):
    return [row(place, program, folder, turns, part, rate) for place in range(len(MESHES))]
