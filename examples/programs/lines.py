"""Lines between slipgap and a program: requests in, answers out, for the programs of this folder."""
import importlib
import json
import os
import sys

import numpy as np


def engine(module, laws):
    """The module of an engine; without it, every case fails with that word."""
    try:
        return importlib.import_module(module)
    except ImportError as why:
        message = str(why)

    def run(case):
        raise RuntimeError(message)

    serve(module, "none", laws, run)
    sys.exit()


def serve(program, version, laws, run):
    """Answers requests: `run` gives u and v at the instants by rows, S of the contacts by name, and the count of its work."""
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # What the engine prints goes to standard error.
    print(json.dumps({"format": 1, "program": program, "version": version, "laws": laws}), file=answers, flush=True)
    for line in sys.stdin:
        case = json.loads(line)
        try:
            u, v, forces, cost = run(case)
            answer = {"channels": {name: channel(case, name, u, v, forces) for name in case["channels"]}, "cost": cost}
        except Exception as why:  # A case that fails is a fault of this case alone.
            answer = {"error": f"{type(why).__name__}: {why}"}
        print(json.dumps({"case": case["case"], **answer}), file=answers, flush=True)


def channel(case, name, u, v, forces):
    """The values of a channel that was asked for."""
    if name in case["dofs"]:
        return [float(x) for x in u[:, case["dofs"].index(name)]]
    of, _, quantity = name.rpartition(".")
    if quantity == "v" and of in case["dofs"]:
        return [float(x) for x in v[:, case["dofs"].index(of)]]
    # NAME.S, and NAME.S.1 of the first direction in a plane.
    known = of if quantity == "S" else f"{of.removesuffix('.S')}.{quantity}"
    if of != known.rpartition(".")[0] and known in forces:
        return [float(x) for x in forces[known]]
    raise ValueError(f"no channel {name}")


def matrix(case, name):
    """M, K or C as an array."""
    n = len(case["dofs"])
    full = np.zeros((n, n))
    for i, j, value in case[name]:
        full[i, j] = value
    return full


def loads(case, mass):
    """The loads of all degrees of freedom at the instants, by rows: those of the nodes, and of the ground."""
    if case["supports"]:
        raise ValueError("no supports that move")
    p = np.zeros((case["steps"] + 1, len(case["dofs"])))
    for name, values in case["loads"].items():
        p[:, case["dofs"].index(name)] = values
    for ground in case["ground"].values():
        p -= np.outer(ground["a"], mass @ np.array(ground["influence"]))
    return p


def direction(case, contact):
    """B of a contact: r = gap + B u."""
    if "plane" in contact:
        raise ValueError("no contacts in a plane")
    b = np.zeros(len(case["dofs"]))
    for i, value in contact["along"]:
        b[i] = value
    return b


def constant_limit(contact):
    """The limit of friction, which must not change."""
    numbers = contact["numbers"]
    if isinstance(contact.get("N"), (list, dict)):
        raise ValueError("no normal force that changes")
    if numbers.get("static_ratio", 1) != 1 or numbers.get("pressure_exponent", 0) != 0 or "nu_min" in numbers:
        raise ValueError("no limit of friction that changes")
    return numbers["limit"] if "limit" in numbers else numbers["nu"] * contact["N"]


def boxes(case, mass):
    """Boxes on a plane, for engines whose friction is that of bodies: the degrees of freedom of each, and its contact or None."""
    if np.count_nonzero(mass - np.diag(np.diag(mass))):
        raise ValueError("no masses off the diagonal")
    found = {}
    for contact in case["contacts"]:
        axes = contact.get("plane", [contact.get("along")])
        if any(len(axis) != 1 or abs(axis[0][1]) != 1 for axis in axes):
            raise ValueError(f"contact {contact['name']}: no friction between bodies, whose normal force is their weight")
        dofs = [axis[0][0] for axis in axes]
        if len({mass[i, i] for i in dofs}) != 1 or len(set(dofs)) != len(dofs):
            raise ValueError(f"contact {contact['name']}: no mass that differs by direction")
        if any(set(dofs) & set(other) for other, _ in found.values()):
            raise ValueError(f"contact {contact['name']}: no second contact of a body")
        found[contact["name"]] = dofs, contact
    known = {i for dofs, _ in found.values() for i in dofs}
    free = [([i], None) for i in range(len(mass)) if i not in known]
    return list(found.values()) + free


def names(contact):
    """The names of its forces, those of both directions of a contact in a plane."""
    return [f"{contact['name']}.{i}" for i in (1, 2)] if "plane" in contact else [contact["name"]]


def signs(contact):
    """The factors of the displacements of a box in r."""
    return [axis[0][1] for axis in contact.get("plane", [contact.get("along")])]
