"""Writes ../../data/own_structure/ (matrices, records) and ../../data/own_structure.json: studies and their motion by own_structure.py.

Run:  python3 own_structure_data.py [frames]      (needs numpy and scipy; `frames` writes the matrices again and needs openseespy)
"""

import json
import sys
from pathlib import Path

import numpy as np

from own_structure import solve

HERE = Path(__file__).resolve().parent
FOLDER = HERE.parents[1] / "data" / "own_structure"
sys.path.insert(0, str(HERE.parents[2] / "examples" / "models"))


def write_models():
    import plane_stress
    import space_frame
    from matrix_market import write_dofs, write_matrices

    if "frames" in sys.argv:
        import frame
        from opensees import export

        for name, options in {"frames": {}, "rotary": {"rotary": 0.5, "damping": (0.3, 0.002)}, "damped": {"damping": (0.3, 0.002)},
                              "bases": {"fixed": False, "storeys": 2, "rotary": 0.5, "damping": (0.0, 0.002)}}.items():
            frame.build(**options)
            bases = {f * 100 + c: side for f, side in ((1, "west"), (2, "east")) for c in (1, 2)}
            export(FOLDER / name, supports=bases if name == "bases" else None)
    M, K, dofs = space_frame.frame()
    write_matrices(FOLDER / "portal", M=M, K=K)
    write_dofs(FOLDER / "portal.dofs.csv", dofs)
    M, K, places = plane_stress.block(2, 3, 1.0, 0.6, nu=0.3, mass="consistent")
    write_matrices(FOLDER / "block", M=M, K=K)
    write_dofs(FOLDER / "left.dofs.csv", plane_stress.dofs(places))
    write_dofs(FOLDER / "right.dofs.csv", plane_stress.dofs(places, 1.0))
    cells = [[f"left.{8 + j}.x:-1", f"right.{j}.x:1"] for j in range(1, 5)]
    plane_stress.pairs(FOLDER / "face.csv", cells[1:-1])
    plane_stress.pairs(FOLDER / "ends.csv", [cells[0], cells[-1]])
    for seed in (1, 2):
        write_record(FOLDER / f"motion{seed}.csv", seed)


def write_record(path, seed):
    """Nine sines under a smooth envelope, 3 m/s2 at its peak; displacement and velocity end with the record."""
    t = np.arange(201) * 0.01
    numbers = np.random.default_rng(seed)
    a = sum(numbers.normal() * np.sin(2 * np.pi * f * t + numbers.uniform(0, 6)) for f in numbers.uniform(0.5, 6, 9))
    a *= np.sin(np.pi * t / 2) ** 2
    np.savetxt(path, np.c_[t, 3 * a / np.abs(a).max()], fmt="%.15g", delimiter=",", header="t,a", comments="")


def entry(name, matrices="MKC", dofs=None):
    return {**{m: f"{name}.{m}.mtx" for m in matrices}, "dofs": f"{dofs or name}.dofs.csv"}


def ground(scale=2.0, second="y"):
    record = {"unit": "m/s2", "scale": scale}
    return {"x": {"record": "motion1.csv", **record}, second: {"record": "motion2.csv", **record}}


GAPS = {
    "roof": {"law": "impact", "between": ["f.132.x", "f.231.x"], "gap": 0.008, "k": 4e4},
    "floor": {"law": "impact", "between": ["f.122.x", "f.221.x"], "gap": 0.006, "k": 2e4},
    "skew": {"law": "impact", "along": {"f.132.x": -0.6, "f.132.y": -0.8, "f.231.x": 0.6, "f.231.y": 0.8}, "gap": 0.004, "k": 3e4},
}
STEP = {"dt": 0.004, "duration": 2.4}


def study(structure, **parameters):
    return {"problem": "structure", "parameters": parameters or STEP, "structure": {"units": "t, kN, m, s", **structure}}


def cases():
    mixed = {
        "matrices": {"f": entry("frames")},
        "masses": {"tank": 4, "plate": 0},
        "springs": [{"between": ["f.232.x", "tank"], "k": 600, "c": 2}, {"between": ["ground", "plate"], "k": 3e4},
                    {"along": {"f.112.x": -0.6, "f.112.y": -0.8, "f.211.x": 0.6, "f.211.y": 0.8}, "k": 500, "c": 8}],
        "contacts": {
            "roof": GAPS["roof"],
            "soil": {"law": "impact", "between": ["plate", "f.111.x"], "gap": 0.002, "k": 5e4},
            "yield": {"law": "displacement-control", "between": ["ground", "plate"], "k": 2e4, "limit": 8},
            "brace": {"law": "displacement-control", "along": {"f.121.x": -0.8, "f.121.y": -0.6, "f.112.x": 0.8, "f.112.y": 0.6},
                      "k": 2e4, "limit": 10},
            "damper": {"law": "velocity-control", "between": ["f.222.x", "f.231.x"], "c": 600, "limit": 15},
        },
        "ground": ground(), "start": {"tank": {"v": 0.1}},
    }
    moved = {"matrices": {"f": entry("bases", "MKC")}, "springs": [{"between": ["f.112.x", "f.211.x"], "k": 200, "c": 4}],
             "contacts": {"top": {**GAPS["floor"], "gap": 0.003},
                          "pier": {"law": "impact", "between": ["west", "f.111.x"], "gap": 0.002, "k": 1e4}},
             "supports": {"west": ground()["x"], "east": {"x": ground()["x"], "y": ground()["y"], "delay": 0.13}}}
    blocks = {"matrices": {side: entry("block", "MK", side) for side in ("left", "right")},
              "contacts": {"face": {"law": "impact", "pairs": "face.csv", "gap": 0.01, "k": 0.4},
                           "ends": {"law": "impact", "pairs": "ends.csv", "gap": 0.01, "k": 0.2}},
              "start": {"left.x": {"v": 0.5}, "right.3.y": {"v": 0.1}}}
    portal = {"matrices": {"p": entry("portal", "MK")}, "masses": {"block": 5}, "rayleigh": {"mass": 0.4, "stiffness": 0},
              "springs": [{"between": ["ground", "block"], "k": 300, "c": 3}],
              "contacts": {"stop": {"law": "impact", "along": {"p.21.x": -0.8, "p.21.y": -0.6, "block": 1}, "gap": 0.004, "k": 2e4},
                           "seat": {"law": "impact", "along": {"p.23.z": 0.9, "p.14.x": -0.3, "p.14.rz": 1.5}, "gap": 1e-4, "k": 2e4}},
              "ground": ground(second="z")}
    return [("frames", study({"matrices": {"f": entry("frames")}, "contacts": GAPS, "ground": ground()})),
            ("rotations with mass", study({"matrices": {"f": entry("rotary")}, "contacts": GAPS, "ground": ground()})),
            ("rotations with damping and no mass", study({"matrices": {"f": entry("damped")}, "contacts": GAPS, "ground": ground()})),
            ("friction, a massless node", study(mixed)),
            ("supports", study(moved)),
            ("space", study(portal)),
            ("blocks", study(blocks, dt=0.02, duration=4))]


def channels(m, rows, names, sets):
    t, u, v, r, S = (np.array([row[i] for row in rows]) for i in range(5))
    found = {f"{name}.u": u[:, i] for i, name in enumerate(names)}
    found |= {f"{name}.v": v[:, i] for i, name in enumerate(names) if sets["massive"][i]}
    for i, name in enumerate(m.contacts):
        found |= {f"{name}.r": r[:, i], f"{name}.S": S[:, i]}
    return t, found


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    write_models()
    written = []
    both = [(name, data, split) for name, data in cases() for split in ([False, True] if name == "supports" else [False])]
    for name, data, split in both:
        m, *rest = solve(data, FOLDER, split)
        t, found = channels(m, *rest)
        steps = {len(t) // 4, len(t) // 2, len(t) - 1} | {int(np.abs(a).argmax()) for c, a in found.items() if c.endswith(".S")}
        steps = sorted(steps)
        values = {c: {"largest": float(np.abs(a).max()), "values": [float(x) for x in a[steps]]} for c, a in found.items()}
        closed = {c: int((a != 0).sum()) for c, a in found.items() if c.endswith(".S")}
        print(name, len(m.free), "free,", len(t), "steps, steps with a force", closed, "largest u",
              max(x["largest"] for c, x in values.items() if c.endswith(".u")))
        written.append(json.dumps({"name": name + ", steps of w" * split, "study": data, "steps": steps, "channels": values}))
    (HERE.parents[1] / "data" / "own_structure.json").write_text("[\n" + ",\n".join(written) + "\n]\n", encoding="utf-8")


if __name__ == "__main__":
    main()
