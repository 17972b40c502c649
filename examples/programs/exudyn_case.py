#!/usr/bin/env python3
"""Exudyn as a program: a Mass1D for each degree of freedom, a CoordinateSpringDamper for each spring and dashpot, and a
CoordinateSpringDamperExt for each contact: friction with a sticking spring or a proportional zone, an impact as a limit stop.

M must be diagonal. Numbers: `stiffness` of coulomb before it slides (1e4 limit/length) or, instead, `zone`, the velocity up to which it is
viscous; `substeps` of dt (1); `radius`, the spectral radius of generalised alpha (0.9; 2 is the trapezoidal rule); `tolerance` of Newton
(1e-10).
"""
import numpy as np

import lines

# Its sticking spring does not unload as displacement-control does, so that it is only a way to soften coulomb.
LAWS = ["coulomb", "velocity-control", "impact-spring"]
exudyn, items = (lines.engine(module, LAWS) for module in ("exudyn", "exudyn.itemInterface"))


def ends(contact):
    """The coordinates q0 and q1 whose difference q1 - q0 is r less the gap; None is the ground."""
    along = sorted((value, i) for i, value in contact["along"])
    values, places = [value for value, _ in along], [i for _, i in along]
    if values == [-1.0, 1.0]:
        return places
    if values == [1.0]:
        return [None, places[0]]
    if values == [-1.0]:
        return [places[0], None]
    raise ValueError(f"contact {contact['name']}: no connector between more than two coordinates, or with other factors")


def law(contact, case):
    """What a connector needs of a contact."""
    numbers, given = contact["numbers"], case["numbers"]
    if contact["law"] == "impact-spring":
        stop = {"limitStopsLower": -numbers["gap"], "limitStopsUpper": 1e9 * case["scales"]["length"]}
        return {"useLimitStops": True, "limitStopsStiffness": numbers["k"], **stop}
    limit = lines.constant_limit(contact)
    friction = {"dynamicFrictionForce": limit}
    if contact["law"] == "velocity-control":
        return {**friction, "frictionProportionalZone": limit / numbers["c"]}
    if contact["law"] == "coulomb" and "zone" in given:
        return {**friction, "frictionProportionalZone": given["zone"]}
    return {**friction, "stickingStiffness": given.get("stiffness", 1e4 * limit / case["scales"]["length"])}


def run(case):
    mass, damping, stiffness = (lines.matrix(case, name) for name in "MCK")
    if np.count_nonzero(mass - np.diag(np.diag(mass))):
        raise ValueError("no masses off the diagonal")
    p, n, dt, steps = lines.loads(case, mass), len(mass), case["dt"], case["steps"]
    container = exudyn.SystemContainer()
    system = container.AddSystem()
    ground = system.AddMarker(items.MarkerNodeCoordinate(nodeNumber=system.AddNode(items.NodePointGround()), coordinate=0))
    nodes = [
        system.AddNode(items.Node1D(referenceCoordinates=[0.0], initialCoordinates=[u], initialVelocities=[v]))
        for u, v in zip(case["start"]["u"], case["start"]["v"])
    ]
    markers = []
    for i, node in enumerate(nodes):
        system.AddObject(items.ObjectMass1D(physicsMass=float(mass[i, i]), nodeNumber=node))
        markers.append(system.AddMarker(items.MarkerNodeCoordinate(nodeNumber=node, coordinate=0)))
    marker = lambda i: ground if i is None else markers[i]
    for i in range(n):
        pairs = [(j, i, -stiffness[i, j], -damping[i, j]) for j in range(i)] + [(None, i, stiffness[i].sum(), damping[i].sum())]
        for j, i, k, c in pairs:
            if k != 0 or c != 0:
                system.AddObject(items.ObjectConnectorCoordinateSpringDamper(markerNumbers=[marker(j), marker(i)], stiffness=k, damping=c))
    sensors = {}
    for contact in case["contacts"]:
        q0, q1 = ends(contact)
        of = lambda i: 0.0 if i is None else case["start"]["u"][i]
        # Friction has no force at the start; a stop may be closed.
        is_closed = contact["law"] == "impact-spring" and of(q1) - of(q0) + contact["numbers"]["gap"] < 0
        memory = [0.0, of(q1) - of(q0), -1.0 if is_closed else 0.0]
        data = system.AddNode(items.NodeGenericData(numberOfDataCoordinates=3, initialCoordinates=memory))
        connector = items.ObjectConnectorCoordinateSpringDamperExt(
            markerNumbers=[marker(q0), marker(q1)], nodeNumber=data, **law(contact, case)
        )
        place = system.AddObject(connector)
        output = exudyn.OutputVariableType.Force
        sensors[contact["name"]] = system.AddSensor(items.SensorObject(objectNumber=place, outputVariableType=output, writeToFile=False))
    loads = [system.AddLoad(items.LoadCoordinate(markerNumber=markers[i], load=p[0, i])) for i in range(n)]
    system.Assemble()
    parts = int(case["numbers"].get("substeps", 1))
    rows, forces, times = [], {name: [] for name in sensors}, np.arange(steps + 1) * dt

    def record(system, time):
        """The state at the beginning of a step that ends at a time, and the loads at its end."""
        if len(rows) <= steps and time - dt / parts > (len(rows) - 1e-6) * dt:
            rows.append(np.concatenate([system.systemData.GetODE2Coordinates(), system.systemData.GetODE2Coordinates_t()]))
            for name, sensor in sensors.items():
                forces[name].append(float(system.GetSensorValues(sensor)))
        for i, load in enumerate(loads):
            system.SetLoadParameter(load, "load", float(np.interp(time, times, p[:, i])))
        return True

    system.SetPreStepUserFunction(record)
    settings = exudyn.SimulationSettings()
    integration, radius = settings.timeIntegration, case["numbers"].get("radius", 0.9)
    integration.numberOfSteps, integration.endTime = steps * parts, steps * dt
    integration.adaptiveStep = integration.automaticStepSize = False
    integration.verboseMode, settings.displayStatistics = 0, False
    settings.solutionSettings.writeSolutionToFile = settings.solutionSettings.sensorsStoreAndWriteFiles = False
    integration.newton.relativeTolerance = case["numbers"].get("tolerance", 1e-10)
    integration.newton.useModifiedNewton = False
    integration.discontinuous.maxIterations, integration.discontinuous.iterationTolerance = 20, 1e-10
    kind = exudyn.DynamicSolverType.GeneralizedAlpha if radius <= 1 else exudyn.DynamicSolverType.TrapezoidalIndex2
    integration.generalizedAlpha.spectralRadius = min(radius, 1.0)
    if not system.SolveDynamic(settings, solverType=kind):
        raise RuntimeError(f"did not converge at t = {(len(rows) - 1) * dt:.6g}")
    record(system, steps * dt + dt / parts)
    rows = np.array(rows)
    for contact in case["contacts"]:  # What the contact has at the start is that of the request.
        forces[contact["name"]][0] = case["start"]["S"][contact["name"]]
    return rows[:, :n], rows[:, n:], forces, steps * parts


if __name__ == "__main__":
    lines.serve("exudyn", exudyn.__version__, LAWS, run)
