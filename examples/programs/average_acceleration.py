#!/usr/bin/env python3
"""The smallest program for the key `programs` of a study: constant average acceleration in plain Python.

Its contacts are impact springs, S = k r where r < 0. In each step the springs that touch are guessed until the guess holds.
"""
import json
import sys

answers, sys.stdout = sys.stdout, sys.stderr  # What else is printed goes to standard error.


def solve(a, b):
    """x of a x = b by elimination, for matrices that need no pivots."""
    rows = [row + [x] for row, x in zip(a, b)]
    for i in range(len(b)):
        pivot = [x / rows[i][i] for x in rows[i]]
        rows = [pivot if j == i else [x - row[i] * y for x, y in zip(row, pivot)] for j, row in enumerate(rows)]
    return [row[-1] for row in rows]


def run(case):
    dofs, dt, steps, contacts = range(len(case["dofs"])), case["dt"], case["steps"], case["contacts"]
    if case["supports"]:
        raise ValueError("no supports that move")
    m, c, k = ([[0.0] * len(dofs) for _ in dofs] for _ in "mck")
    for matrix, entries in [(m, case["M"]), (c, case["C"]), (k, case["K"])]:
        for i, j, value in entries:
            matrix[i][j] = value
    p = [case["loads"].get(name, [0.0] * (steps + 1)) for name in case["dofs"]]
    for ground in case["ground"].values():
        pull = [sum(x * y for x, y in zip(row, ground["influence"])) for row in m]
        p = [[x - y * a for x, a in zip(row, ground["a"])] for row, y in zip(p, pull)]
    u, v, s = case["start"]["u"], case["start"]["v"], [case["start"]["S"][x["name"]] for x in contacts]
    motion = [(u, v, s)]
    for step in range(1, steps + 1):
        guess = [x < 0 for x in s]
        for _ in range(50):
            # (4 M/dt^2 + 2 C/dt + K) du = p(i) + p(i+1) + 4 M v/dt - 2 K u + .. in terms of the change du of u
            touching, a = guess, [[4 * m[i][j] / dt**2 + 2 * c[i][j] / dt + k[i][j] for j in dofs] for i in dofs]
            b = [p[i][step] + p[i][step - 1] + sum(4 * m[i][j] * v[j] / dt - 2 * k[i][j] * u[j] for j in dofs) for i in dofs]
            for contact, force, touches in zip(contacts, s, touching):
                along, stiffness = contact["along"], contact["numbers"]["k"] if touches else 0.0
                r = contact["numbers"]["gap"] + sum(x * u[j] for j, x in along)
                for i, x in along:
                    b[i] -= x * (force + stiffness * r)
                    for j, y in along:
                        a[i][j] += stiffness * x * y
            du = solve(a, b)
            new = [x + y for x, y in zip(u, du)]
            r = [x["numbers"]["gap"] + sum(y * new[j] for j, y in x["along"]) for x in contacts]
            guess = [x < 0 for x in r]
            if guess == touching:
                break
        else:
            raise ValueError(f"the contacts do not settle at t = {step * dt}")
        u, v, s = new, [2 * x / dt - y for x, y in zip(du, v)], [x["numbers"]["k"] * min(y, 0.0) for x, y in zip(contacts, r)]
        motion.append((u, v, s))
    names = {name + end: (of, i) for i, name in enumerate(case["dofs"]) for of, end in enumerate(["", ".v"])}
    names |= {x["name"] + ".S": (2, i) for i, x in enumerate(contacts)}
    return {name: [state[names[name][0]][names[name][1]] for state in motion] for name in case["channels"]}


print(json.dumps({"format": 1, "program": "average_acceleration.py", "version": "1", "laws": ["impact-spring"]}), file=answers, flush=True)
for line in sys.stdin:
    case = json.loads(line)
    try:
        answer = {"channels": run(case), "cost": case["steps"]}
    except (ValueError, ZeroDivisionError) as why:
        answer = {"error": str(why)}
    print(json.dumps({"case": case["case"]} | answer), file=answers, flush=True)
