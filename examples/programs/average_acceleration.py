#!/usr/bin/env python3
"""The smallest program for the key `programs` of a study: constant average acceleration in plain Python.

Its contacts are impact springs, S = k r where r < 0. In each step the springs that touch are guessed until the guess holds.
"""
import json
import sys

answers, sys.stdout = sys.stdout, sys.stderr  # What else is printed goes to standard error.


def solve(a, b):
    """x of a x = b by elimination with pivots; a and b are written over."""
    n = len(b)
    for i in range(n):
        p = max(range(i, n), key=lambda row: abs(a[row][i]))
        a[i], a[p], b[i], b[p] = a[p], a[i], b[p], b[i]
        for row in range(i + 1, n):
            factor = a[row][i] / a[i][i]
            a[row] = [x - factor * y for x, y in zip(a[row], a[i])]
            b[row] -= factor * b[i]
    for i in reversed(range(n)):
        b[i] = (b[i] - sum(a[i][j] * b[j] for j in range(i + 1, n))) / a[i][i]
    return b


def run(case):
    n, dt, steps = len(case["dofs"]), case["dt"], case["steps"]
    dofs, contacts = range(n), case["contacts"]
    if case["supports"]:
        raise ValueError("no supports that move")
    m, c, k = ([[0.0] * n for _ in dofs] for _ in "mck")
    for matrix, entries in [(m, case["M"]), (c, case["C"]), (k, case["K"])]:
        for i, j, value in entries:
            matrix[i][j] = value
    p = [[0.0] * (steps + 1) for _ in dofs]
    for name, values in case["loads"].items():
        p[case["dofs"].index(name)] = list(values)
    for ground in case["ground"].values():
        pull = [sum(m[i][j] * ground["influence"][j] for j in dofs) for i in dofs]
        for i in dofs:
            p[i] = [x - pull[i] * a for x, a in zip(p[i], ground["a"])]
    u, v, s = case["start"]["u"], case["start"]["v"], [case["start"]["S"][x["name"]] for x in contacts]
    motion = [(u, v, s)]
    for step in range(1, steps + 1):
        # (4 M/dt^2 + 2 C/dt + K) du = p(i) + p(i+1) + 4 M v/dt + 2 C v ... in terms of the change du of u
        for closed in [[x < 0 for x in s]] + [None] * 50:
            touching = closed if closed is not None else guess
            a = [[4 * m[i][j] / dt**2 + 2 * c[i][j] / dt + k[i][j] for j in dofs] for i in dofs]
            b = [p[i][step] + p[i][step - 1] + sum(4 * m[i][j] * v[j] / dt - 2 * k[i][j] * u[j] for j in dofs) for i in dofs]
            for contact, force, touches in zip(contacts, s, touching):
                stiffness, gap = contact["numbers"]["k"], contact["numbers"]["gap"]
                r = gap + sum(x * u[j] for j, x in contact["along"])
                for i, x in contact["along"]:
                    b[i] -= x * (force + (stiffness * r if touches else 0.0))
                    for j, y in contact["along"]:
                        a[i][j] += stiffness * x * y if touches else 0.0
            du = solve(a, b)
            new = [x + y for x, y in zip(u, du)]
            r = [x["numbers"]["gap"] + sum(y * new[j] for j, y in x["along"]) for x in contacts]
            guess = [x < 0 for x in r]
            if guess == touching:
                break
        else:
            raise ValueError(f"the contacts do not settle at t = {step * dt}")
        v = [2 * x / dt - y for x, y in zip(du, v)]
        u, s = new, [x["numbers"]["k"] * min(y, 0.0) for x, y in zip(contacts, r)]
        motion.append((u, v, s))
    names = {}
    for i, name in enumerate(case["dofs"]):
        names |= {name: (0, i), name + ".v": (1, i)}
    names |= {x["name"] + ".S": (2, i) for i, x in enumerate(contacts)}
    channels = {name: [state[names[name][0]][names[name][1]] for state in motion] for name in case["channels"]}
    return {"case": case["case"], "channels": channels, "cost": steps}


print(json.dumps({"format": 1, "program": "average_acceleration.py", "version": "1", "laws": ["impact-spring"]}), file=answers, flush=True)
for line in sys.stdin:
    case = json.loads(line)
    try:
        answer = run(case)
    except (ValueError, ZeroDivisionError) as why:
        answer = {"case": case["case"], "error": str(why)}
    print(json.dumps(answer), file=answers, flush=True)
