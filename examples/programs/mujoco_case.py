#!/usr/bin/env python3
"""MuJoCo as a program: a slide joint for each degree of freedom, a fixed tendon for each spring, dashpot and contact.

Friction is `frictionloss` of a tendon, which MuJoCo softens: it creeps where it should stick. M must be diagonal. Numbers: `timeconst` of
`solreffriction` (0.02 s), `impedance` (0.9, of `solimpfriction`; nearer 1 is harder), `substeps` of dt (1), `integrator` (0: Euler,
1: implicit), `tolerance` of the solver (1e-8).
"""
import mujoco
import numpy as np

import lines

LAWS = ["coulomb"]


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
    for contact in case["contacts"]:
        lines.direction(case, contact)
        limit = lines.constant_limit(contact)
        soft = f'solreffriction="{time!r} 1" solimpfriction="{impedance!r} {max(impedance, 0.95)!r} 0.001"'
        parts.append(tendon(contact["name"], contact["along"], f'frictionloss="{float(limit)!r}" {soft}'))
    bodies = "".join(
        f'<body><joint name="q{i}" type="slide" axis="1 0 0"/><inertial pos="0 0 0" mass="{float(m)!r}" diaginertia="1 1 1"/></body>'
        for i, m in enumerate(np.diag(mass))
    )
    integrator = ["Euler", "implicit"][int(numbers.get("integrator", 0))]
    dt = case["dt"] / int(numbers.get("substeps", 1))
    option = f'timestep="{dt!r}" gravity="0 0 0" integrator="{integrator}" tolerance="{numbers.get("tolerance", 1e-8)!r}" iterations="500"'
    # Otherwise the impedance and the mass of a body have bounds that are not those of the case.
    text = f'<mujoco><compiler boundmass="0" boundinertia="0"/><option {option}/><worldbody>{bodies}</worldbody>'
    return mujoco.MjModel.from_xml_string(text + (f"<tendon>{''.join(parts)}</tendon>" if parts else "") + "</mujoco>"), mass


def run(case):
    system, mass = model(case)
    data, p = mujoco.MjData(system), lines.loads(case, mass)
    data.qpos[:], data.qvel[:] = case["start"]["u"], case["start"]["v"]
    substeps = int(case["numbers"].get("substeps", 1))
    names = [contact["name"] for contact in case["contacts"]]
    place = {name: mujoco.mj_name2id(system, mujoco.mjtObj.mjOBJ_TENDON, name) for name in names}
    u, v, forces = [data.qpos.copy()], [data.qvel.copy()], {name: [case["start"]["S"][name]] for name in names}
    for step in range(case["steps"]):
        for part in range(substeps):
            share = part / substeps
            data.qfrc_applied[:] = (1 - share) * p[step] + share * p[step + 1]
            mujoco.mj_step(system, data)
        if not np.all(np.isfinite(data.qpos)):
            raise RuntimeError(f"not finite at t = {(step + 1) * case['dt']:.6g}")
        u.append(data.qpos.copy())
        v.append(data.qvel.copy())
        data.qfrc_applied[:] = p[step + 1]
        mujoco.mj_forward(system, data)  # Otherwise the forces are those at the start of the last step.
        rows = {int(i): float(f) for i, f, kind in zip(data.efc_id, data.efc_force, data.efc_type) if kind == mujoco.mjtConstraint.mjCNSTR_FRICTION_TENDON}
        for name in names:
            forces[name].append(-rows.get(place[name], 0.0))
    return np.array(u), np.array(v), forces, substeps * case["steps"]


if __name__ == "__main__":
    lines.serve("mujoco", mujoco.__version__, LAWS, run)
