#!/usr/bin/env python3
"""MuJoCo as a program: a slide joint for each degree of freedom, a fixed tendon for each spring, dashpot and contact.

Friction is `frictionloss` of a tendon, which MuJoCo softens: it creeps where it should stick. In a plane it is that of a ball on the
plane, pressed by its weight, with an elliptic cone. M must be diagonal. Numbers: `timeconst` (0.02 s) and `impedance` (0.9; nearer 1 is
harder) of friction, `impratio` in a plane (1), `substeps` of dt (1), `integrator` (0: Euler, 1: implicit), `tolerance` of the solver (1e-8).
"""
import numpy as np

import lines

LAWS = ["coulomb"]
G = 9.81  # The weight that presses in a plane.
mujoco = lines.engine("mujoco", LAWS)


def tendon(name, along, attributes):
    """A tendon whose length is a sum of displacements."""
    joints = "".join(f'<joint joint="q{i}" coef="{value!r}"/>' for i, value in along)
    return f'<fixed name="{name}" springlength="0" {attributes}>{joints}</fixed>'


def links(full):
    """The springs of a symmetric matrix, as sums of displacements with their stiffness."""
    for i in range(len(full)):
        for j in range(i):
            if full[i, j] != 0:
                yield [(i, 1.0), (j, -1.0)], -full[i, j]
        ground = full[i].sum()
        if abs(ground) > 1e-12 * np.abs(full[i]).sum():
            yield [(i, 1.0)], ground


def flat(case, mass):
    """The contacts in a plane with the degrees of freedom of their bodies."""
    found = {}
    for contact in case["contacts"]:
        if "plane" in contact:
            dofs = [axis[0][0] for axis in contact["plane"]]
            if any(len(axis) != 1 or abs(axis[0][1]) != 1 for axis in contact["plane"]) or len({mass[i, i] for i in dofs}) != 1:
                raise ValueError(f"contact {contact['name']}: in a plane only a body on the ground, with one mass")
            if any(set(dofs) & set(other) for other in found.values()):
                raise ValueError(f"contact {contact['name']}: no second contact of a body")
            found[contact["name"]] = dofs
    return found


def model(case):
    """The model as MuJoCo's XML."""
    mass, damping, stiffness = (lines.matrix(case, name) for name in "MCK")
    if np.count_nonzero(mass - np.diag(np.diag(mass))):
        raise ValueError("no masses off the diagonal")
    numbers = case["numbers"]
    time, impedance = numbers.get("timeconst", 0.02), numbers.get("impedance", 0.9)
    parts = []
    for full, word in [(stiffness, "stiffness"), (damping, "damping")]:
        for place, (along, value) in enumerate(links(full)):
            if value < 0:
                raise ValueError("no negative stiffness or damping of a tendon")
            parts.append(tendon(f"{word}{place}", along, f'{word}="{float(value)!r}"'))
    planes, balls, pairs = flat(case, mass), "", ""
    for contact in case["contacts"]:
        limit = lines.constant_limit(contact)
        if contact["name"] in planes:
            name, dofs = contact["name"], planes[contact["name"]]
            m = float(mass[dofs[0], dofs[0]])
            joints = "".join(f'<joint name="q{i}" type="slide" axis="{axis}"/>' for i, axis in zip(dofs, ["1 0 0", "0 1 0"]))
            balls += f'<geom name="{name}.ground" type="plane" size="1 1 1" contype="0" conaffinity="0"/><body pos="0 0 0.1">{joints}'
            balls += f'<joint name="{name}.z" type="slide" axis="0 0 1"/><inertial pos="0 0 0" mass="{m!r}" diaginertia="1 1 1"/>'
            balls += f'<geom name="{name}.ball" type="sphere" size="0.1" contype="0" conaffinity="0"/></body>'
            mu, soft = float(limit) / (m * G), f'solreffriction="{time!r} 1" solimp="{impedance!r} {max(impedance, 0.95)!r} 0.001"'
            pairs += f'<pair geom1="{name}.ground" geom2="{name}.ball" condim="3" friction="{mu!r} {mu!r} 1 1 1" {soft}/>'
            continue
        lines.direction(case, contact)
        soft = f'solreffriction="{time!r} 1" solimpfriction="{impedance!r} {max(impedance, 0.95)!r} 0.001"'
        parts.append(tendon(contact["name"], contact["along"], f'frictionloss="{float(limit)!r}" {soft}'))
    bodies = "".join(
        f'<body><joint name="q{i}" type="slide" axis="1 0 0"/><inertial pos="0 0 0" mass="{float(m)!r}" diaginertia="1 1 1"/></body>'
        for i, m in enumerate(np.diag(mass))
        if not any(i in dofs for dofs in planes.values())
    )
    integrator = ["Euler", "implicit"][int(numbers.get("integrator", 0))]
    dt = case["dt"] / int(numbers.get("substeps", 1))
    cone, rest = f'cone="elliptic" impratio="{numbers.get("impratio", 1)!r}"', f'tolerance="{numbers.get("tolerance", 1e-8)!r}" iterations="500"'
    option = f'timestep="{dt!r}" gravity="0 0 {-G}" {cone} integrator="{integrator}" {rest}'
    # Otherwise the impedance and the mass of a body have bounds that are not those of the case.
    text = f'<mujoco><compiler boundmass="0" boundinertia="0"/><option {option}/><worldbody>{bodies}{balls}</worldbody>'
    text += (f"<tendon>{''.join(parts)}</tendon>" if parts else "") + (f"<contact>{pairs}</contact>" if pairs else "")
    return mujoco.MjModel.from_xml_string(text + "</mujoco>"), mass, planes


def forces_in_plane(system, data, name):
    """The force of the ground on a ball."""
    force, wanted = np.zeros(6), mujoco.mj_name2id(system, mujoco.mjtObj.mjOBJ_GEOM, f"{name}.ball")
    for place in range(data.ncon):
        if data.contact[place].geom2 == wanted:
            mujoco.mj_contactForce(system, data, place, force)
            return data.contact[place].frame.reshape(3, 3).T @ force[:3]
    return np.zeros(3)


def run(case):
    system, mass, planes = model(case)
    data, p, n = mujoco.MjData(system), lines.loads(case, mass), len(mass)
    at = [system.joint(f"q{i}").qposadr[0] for i in range(n)]

    def start():
        data.qpos[at], data.qvel[at] = case["start"]["u"], case["start"]["v"]

    start()
    substeps = int(case["numbers"].get("substeps", 1))
    if planes:  # First the balls come to rest on their planes, so that the normal force is the weight from t = 0 on.
        for _ in range(5000):
            mujoco.mj_step(system, data)
            start()
        data.time = 0.0
    names = [contact["name"] for contact in case["contacts"]]
    place = {name: mujoco.mj_name2id(system, mujoco.mjtObj.mjOBJ_TENDON, name) for name in names if name not in planes}
    u, v, forces = [data.qpos[at]], [data.qvel[at]], {name: [value] for name, value in case["start"]["S"].items()}
    for step in range(case["steps"]):
        for part in range(substeps):
            share = part / substeps
            data.qfrc_applied[at] = (1 - share) * p[step] + share * p[step + 1]
            mujoco.mj_step(system, data)
        if not np.all(np.isfinite(data.qpos)):
            raise RuntimeError(f"not finite at t = {(step + 1) * case['dt']:.6g}")
        u.append(data.qpos[at])
        v.append(data.qvel[at])
        data.qfrc_applied[at] = p[step + 1]
        mujoco.mj_forward(system, data)  # Otherwise the forces are those at the start of the last step.
        friction = mujoco.mjtConstraint.mjCNSTR_FRICTION_TENDON
        rows = {int(i): float(f) for i, f, kind in zip(data.efc_id, data.efc_force, data.efc_type) if kind == friction}
        for name in place:
            forces[name].append(-rows.get(place[name], 0.0))
        for contact in case["contacts"]:
            if contact["name"] in planes:
                force = forces_in_plane(system, data, contact["name"])
                for name, sign, x in zip(lines.names(contact), lines.signs(contact), force):
                    forces[name].append(-sign * x)
    return np.array(u), np.array(v), forces, substeps * case["steps"]


if __name__ == "__main__":
    lines.serve("mujoco", mujoco.__version__, LAWS, run)
