#!/usr/bin/env python3
"""Drake as a program: a body on prismatic joints for each mass, with a sphere on a half-space, pressed by its weight.

A degree of freedom is the x of a body, or x and y of one body where a contact in a plane joins them to the ground. The friction is that of
Drake's discrete contact, its limit the coefficient times the weight. Springs, dashpots and loads are forces at the start of each step.
Numbers: `substeps` of dt (1), `solver` (0: SAP, 1: TAMSI, 2: similar, 3: lagged), `stiction`, the velocity of the last three up
to which friction is viscous (1e-3 of the typical velocity).
"""
import importlib.metadata

import numpy as np
import lines

LAWS = ["coulomb"]
drake = lines.engine("pydrake.all", LAWS)
G = 9.81


def surface(mu):
    """The properties of a surface in contact: its friction, and no dissipation."""
    properties = drake.ProximityProperties()
    properties.AddProperty("material", "coulomb_friction", drake.CoulombFriction(mu, mu))
    return properties


def run(case):
    mass, damping, stiffness = (lines.matrix(case, name) for name in "MCK")
    boxes = lines.boxes(case, mass)
    p, n, given = lines.loads(case, mass), len(mass), case["numbers"]
    parts = int(given.get("substeps", 1))
    solver = ["kSap", "kTamsi", "kSimilar", "kLagged"][int(given.get("solver", 0))]
    builder = drake.DiagramBuilder()
    plant, scene = drake.AddMultibodyPlantSceneGraph(builder, case["dt"] / parts)
    plant.set_discrete_contact_approximation(getattr(drake.DiscreteContactApproximation, solver))
    plant.mutable_gravity_field().set_gravity_vector([0, 0, -G])
    joints, places = {}, []
    for place, (dofs, contact) in enumerate(boxes):
        m = float(mass[dofs[0], dofs[0]])
        last = plant.world_body()
        for axis, direction in enumerate(np.eye(3)):
            if axis == 1 and len(dofs) == 1:
                continue
            inertia = drake.SpatialInertia.SolidSphereWithMass(m, 0.1) if axis == 2 else drake.SpatialInertia.Zero()
            body = plant.AddRigidBody(f"{place}.{axis}", inertia)
            joint = plant.AddJoint(drake.PrismaticJoint(f"{place}.{axis}", last.body_frame(), body.body_frame(), direction))
            if axis < len(dofs):
                joints[dofs[axis]] = joint
            last = body
        places.append(last)
        if contact:
            limit = lines.constant_limit(contact)
            # Each pair has the friction 2 mu mu/(mu + mu) = mu of its surfaces, and a half-space of its own.
            plant.RegisterCollisionGeometry(last, drake.RigidTransform(), drake.Sphere(0.1), f"ball{place}", surface(limit / (m * G)))
            plant.RegisterCollisionGeometry(
                plant.world_body(), drake.RigidTransform([0, 0, -0.1]), drake.HalfSpace(), f"plane{place}", surface(limit / (m * G))
            )
    plant.set_stiction_tolerance(given.get("stiction", 1e-3 * case["scales"]["velocity"]))
    plant.Finalize()
    diagram = builder.Build()
    simulator = drake.Simulator(diagram)
    context = plant.GetMyMutableContextFromRoot(simulator.get_mutable_context())
    for i, joint in joints.items():
        joint.set_translation(context, case["start"]["u"][i])
        joint.set_translation_rate(context, case["start"]["v"][i])
    lift = [plant.GetJointByName(f"{place}.2") for place, (_, contact) in enumerate(boxes) if contact]
    port = plant.get_applied_generalized_force_input_port()
    u, v = np.array(case["start"]["u"]), np.array(case["start"]["v"])
    rows, rates, forces = [u.copy()], [v.copy()], {name: [value] for name, value in case["start"]["S"].items()}
    # First the bodies come to rest on their planes, so that the normal force is the weight from t = 0 on.
    weights = np.zeros(plant.num_velocities())
    for place, (dofs, contact) in enumerate(boxes):
        if not contact:  # Nothing carries its weight.
            weights[plant.GetJointByName(f"{place}.2").velocity_start()] = mass[dofs[0], dofs[0]] * G
    port.FixValue(context, weights)
    for joint in joints.values():
        joint.Lock(context)
    for settling in range(1, 5001):
        simulator.AdvanceTo(settling * case["dt"] / parts)
        if settling > 20 and all(abs(joint.get_translation_rate(context)) < 1e-12 for joint in lift):
            break
    simulator.get_mutable_context().SetTime(0.0)
    for i, joint in joints.items():
        joint.Unlock(context)
        joint.set_translation_rate(context, case["start"]["v"][i])
    simulator.Initialize()
    for step in range(case["steps"]):
        for part in range(parts):
            share = part / parts
            load = (1 - share) * p[step] + share * p[step + 1] - stiffness @ u - damping @ v
            push = weights.copy()
            for i, joint in joints.items():
                push[joint.velocity_start()] = load[i]
            port.FixValue(context, push)
            simulator.AdvanceTo((step + (part + 1) / parts) * case["dt"])
            for i, joint in joints.items():
                u[i], v[i] = joint.get_translation(context), joint.get_translation_rate(context)
        rows.append(u.copy())
        rates.append(v.copy())
        results = plant.get_contact_results_output_port().Eval(context)
        found = {}
        for k in range(results.num_point_pair_contacts()):
            info = results.point_pair_contact_info(k)
            force = np.array(info.contact_force())
            for index, sign in [(info.bodyA_index(), -1.0), (info.bodyB_index(), 1.0)]:
                found[int(index)] = found.get(int(index), 0.0) + sign * force
        for place, (dofs, contact) in enumerate(boxes):
            if contact:
                force = -found.get(int(places[place].index()), np.zeros(3))
                for name, sign, x in zip(lines.names(contact), lines.signs(contact), force):
                    forces[name].append(sign * x)
    return np.array(rows), np.array(rates), forces, parts * case["steps"]


if __name__ == "__main__":
    lines.serve("drake", importlib.metadata.version("drake"), LAWS, run)
