"""A block of plane-stress elements meets a wall along 50 contacts: the model in three sizes, and its study for slipgap."""

import json
import pathlib
import sys

import numpy as np

MODELS = pathlib.Path(__file__).parents[3] / "examples" / "models"
sys.path.insert(0, str(MODELS))

from matrix_market import write_dofs, write_matrices  # noqa: E402
from plane_stress import block, dofs, pairs  # noqa: E402

LENGTH, WIDTH, NU = 1.0, 0.2, 0.3
MESHES = [(31, 15), (100, 49), (316, 157)]  # 10^3, 10^4 and 10^5 degrees of freedom
CONTACTS = 50
STIFFNESS = 1.0
FEW = 10  # steps of the run whose time is subtracted
STEPS = [4000, 1000, 100]


class Block:
    """M (diagonal), K, and the nodes 0, 1, .. of the face with contacts."""

    def __init__(self, nx, ny):
        self.nx, self.ny, self.dt = nx, ny, LENGTH / nx
        mass, self.K, self.places = block(nx, ny, LENGTH, WIDTH, nu=NU)
        self.mass = mass.diagonal()
        inner = range(nx * (ny + 1) + 1, nx * (ny + 1) + ny)
        count = min(CONTACTS, len(inner))
        self.face = [inner[i * len(inner) // count] for i in range(count)]

    def __len__(self):
        return len(self.mass)

    def start(self):
        """u and v: the block moves towards the wall."""
        v = np.zeros(len(self))
        v[::2] = 1
        return np.zeros(len(self)), v


def write(of, folder):
    """The files of the study."""
    from scipy.sparse import diags_array

    folder.mkdir(parents=True, exist_ok=True)
    write_matrices(folder / "block", M=diags_array(of.mass), K=of.K)
    write_dofs(folder / "block.dofs.csv", dofs(of.places))
    pairs(folder / "face.csv", [[f"block.{node + 1}.x:-1"] for node in of.face])


def study(of, steps, metrics):
    """The study with this number of steps."""
    return json.dumps({
        "problem": "structure",
        "parameters": {"dt": of.dt, "duration": steps * of.dt},
        "structure": {
            "matrices": {"block": {"M": "block.M.mtx", "K": "block.K.mtx", "dofs": "block.dofs.csv"}},
            "contacts": {"face": {"law": "impact", "pairs": "face.csv", "k": STIFFNESS}},
            "start": {"block.x": {"v": 1}},
        },
        "metrics": metrics,
    })
