#!/usr/bin/env python3
"""PyBullet as a program: a box without rotation on a plane for each mass, pressed by its weight.

A degree of freedom is the x of a box, or x and y of one box where a contact in a plane joins them to the ground. The friction is that of
Bullet's contacts, its limit the coefficient times the weight that makes the normal force of the request. Springs, dashpots and loads
are forces at the start of each step, as Bullet has none. Numbers: `substeps` of dt (1), `iterations` of the solver (50), `residual` at
which it ends (1e-7), `cone` (1: a cone of friction, 0: two directions on their own), `erp` of friction (0.2).
"""
import numpy as np

import lines

LAWS = ["coulomb"]
pybullet = lines.engine("pybullet", LAWS)


def run(case):
    mass, damping, stiffness = (lines.matrix(case, name) for name in "MCK")
    p, n, given = lines.loads(case, mass), len(mass), case["numbers"]
    parts = int(given.get("substeps", 1))
    dt, size = case["dt"] / parts, 1.0
    client = pybullet.connect(pybullet.DIRECT)
    try:
        pybullet.setPhysicsEngineParameter(
            fixedTimeStep=dt, numSubSteps=0, numSolverIterations=int(given.get("iterations", 50)),
            solverResidualThreshold=given.get("residual", 1e-7), enableConeFriction=int(given.get("cone", 1)),
            frictionERP=given.get("erp", 0.2), deterministicOverlappingPairs=1,
        )
        ground = pybullet.createMultiBody(0, pybullet.createCollisionShape(pybullet.GEOM_PLANE))
        pybullet.changeDynamics(ground, -1, lateralFriction=1.0, restitution=0.0)
        boxes, u, v = [], np.array(case["start"]["u"]), np.array(case["start"]["v"])
        for dofs, contact in lines.boxes(case, mass):
            m = float(mass[dofs[0], dofs[0]])
            shape = pybullet.createCollisionShape(pybullet.GEOM_BOX, halfExtents=[0.5 * size] * 3)
            at = np.array([0.0, 0.0, 0.5 * size])
            at[: len(dofs)] = u[dofs]
            box = pybullet.createMultiBody(m, shape, basePosition=at)
            # No rotation, so that the weight is all that presses; no damping and no sleep, which Bullet has by default.
            limit = lines.constant_limit(contact) if contact else 0.0
            weight = m * 9.81
            pybullet.changeDynamics(
                box, -1, localInertiaDiagonal=[0, 0, 0], lateralFriction=limit / weight, restitution=0.0, linearDamping=0.0,
                angularDamping=0.0, activationState=pybullet.ACTIVATION_STATE_DISABLE_SLEEPING,
            )
            for other in boxes:
                pybullet.setCollisionFilterPair(other[0], box, -1, -1, 0)
            velocity = np.zeros(3)
            velocity[: len(dofs)] = v[dofs]
            pybullet.resetBaseVelocity(box, velocity.tolist(), [0, 0, 0])
            boxes.append((box, dofs, contact, weight, np.array([0.0, 0.0, 0.5 * size])))
        rows, rates = [u.copy()], [v.copy()]
        forces = {name: [value] for name, value in case["start"]["S"].items()}
        for step in range(case["steps"]):
            for part in range(parts):
                share = part / parts
                load = (1 - share) * p[step] + share * p[step + 1] - stiffness @ u - damping @ v
                for box, dofs, _, weight, at in boxes:
                    push = np.array([0.0, 0.0, -weight])
                    push[: len(dofs)] = load[dofs]
                    position = pybullet.getBasePositionAndOrientation(box)[0]
                    pybullet.applyExternalForce(box, -1, push.tolist(), position, pybullet.WORLD_FRAME)
                pybullet.stepSimulation()
                for box, dofs, *_ in boxes:
                    u[dofs] = pybullet.getBasePositionAndOrientation(box)[0][: len(dofs)]
                    v[dofs] = pybullet.getBaseVelocity(box)[0][: len(dofs)]
            if not np.all(np.isfinite(u)):
                raise RuntimeError(f"not finite at t = {(step + 1) * case['dt']:.6g}")
            rows.append(u.copy())
            rates.append(v.copy())
            for box, dofs, contact, *_ in boxes:
                if contact:
                    force = np.zeros(3)
                    for point in pybullet.getContactPoints(box, ground):
                        force -= point[10] * np.array(point[11]) + point[12] * np.array(point[13])
                    for name, sign, x in zip(lines.names(contact), lines.signs(contact), force):
                        forces[name].append(sign * x)
        return np.array(rows), np.array(rates), forces, parts * case["steps"]
    finally:
        pybullet.disconnect(client)


if __name__ == "__main__":
    lines.serve("pybullet", str(pybullet.getAPIVersion()), LAWS, run)
