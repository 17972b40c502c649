"""The materials IMKPeakOriented, IMKPinching and IMKBilin of OpenSees along random loops; writes ../../data/imk_opensees.json.

Each row is a material that is stretched to `x`, step by step, and its force `S`; `numbers` are those of the law of slipgap, in which
lambda, left out, is no degradation (here 1e30). Most turns are between the peaks so far, some go to the same peak again, and every second
row has a failure by its deflection.

A force that becomes 0 tells that the material has failed; rows end 3 steps later. They also end where the force of OpenSees is no
number: it takes powers of energies below 0, which it has because it looks at energies at ends of steps. Rows of IMKBilin have no
residual, from which it has rules of its own (it unloads with k/2), and end at a failure, after which it keeps the other direction; and at a
change of sign from which on its force rises beyond its cap without a bound, where such a power is no number.

Run:  python3 imk_opensees.py [rows] [file]     (needs openseespy)
"""

import json
import math
import pathlib
import random
import sys

import openseespy.opensees as ops

SIDE = ["Up", "Upc", "Uu", "Fy", "Fcap_ratio", "Fres_ratio"]


def forces(material, xs):
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    ops.uniaxialMaterial(material[0], 1, *material[1:])
    ops.testUniaxialMaterial(1)
    found = []
    for x in xs:
        ops.setStrain(x)
        found.append(ops.getStress())
    return found


def side(chance, fails):
    return {
        "Up": round(chance.uniform(0.5, 2), 3),
        "Upc": round(chance.uniform(2, 8), 3),
        "Uu": round(chance.uniform(3, 5), 3) if fails else 1e3,
        "Fy": round(chance.uniform(2, 4), 3),
        "Fcap_ratio": round(chance.uniform(1.02, 1.4), 3),
        "Fres_ratio": chance.choice([0, 0.1, 0.3]),
    }


def numbers(chance, row):
    own = {"k": round(chance.uniform(5, 12), 3)}
    fails = row % 2 == 1
    first = side(chance, fails)
    other = first if row % 3 == 0 else side(chance, fails)
    own.update(first)
    own.update({key + "_negative": value for key, value in other.items()})
    for which in "SCAK":
        if row % 4 != 0:
            own["lambda_" + which] = round(10 ** chance.uniform(0.9, 2.2), 3)
            own["c_" + which] = round(chance.uniform(0.8, 1.5), 3) if row % 4 == 3 else 1.0
    own["D_positive"] = chance.choice([1, 0.7])
    own["D_negative"] = chance.choice([1, 0.9])
    if row // 2 % 2 == 1:
        own["kappa_F"] = round(chance.uniform(0.2, 0.8), 3)
        own["kappa_D"] = round(chance.uniform(0.1, 0.7), 3)
    return own


def material(own):
    sides = [own[key] for key in SIDE] + [own[key + "_negative"] for key in SIDE]
    lambdas = [own.get("lambda_" + which, 1e30) for which in "SCAK"]
    exponents = [own.get("c_" + which, 1.0) for which in "SCAK"]
    rest = lambdas + exponents + [own["D_positive"], own["D_negative"]]
    pinching = [own["kappa_F"], own["kappa_D"]] if "kappa_F" in own else []
    name = "IMKPinching" if pinching else "IMKPeakOriented"
    return [name, own["k"], *sides, *rest, *pinching]


def bilinear(chance, row):
    own = numbers(chance, row)
    for key in ["lambda_A", "c_A", "kappa_F", "kappa_D"]:
        own.pop(key, None)
    # A hardening line that is above the residual wherever it begins: there it goes from the residual to the cap.
    for side in ["", "_negative"]:
        own["Fcap_ratio" + side] = round(1 + 0.3 * (own["Fcap_ratio" + side] - 1), 3)
        own["Fres_ratio" + side] = 0
    sides = [own[key] for key in SIDE] + [own[key + "_negative"] for key in SIDE]
    lambdas = [own.get("lambda_" + which, 1e30) for which in "SCK"]
    exponents = [own.get("c_" + which, 1.0) for which in "SCK"]
    return own, ["IMKBilin", own["k"], *sides, *lambdas, *exponents, own["D_positive"], own["D_negative"]]


def history(chance):
    turns, size = [], 0.5
    for _ in range(12):
        size = min(size * chance.uniform(0.9, 1.6), 4.5)
        turns.append(size if chance.random() < 0.9 else size * chance.uniform(-0.3, 0.8))
        turns.append(-size if chance.random() < 0.9 else -size * chance.uniform(-0.3, 0.8))
        if chance.random() < 0.3:
            turns += turns[-2:]
    points, last = [], 0.0
    for turn in turns:
        count = chance.randint(3, 12)
        # No step is of no length, and none ends at 0.
        points += [last + (turn - last) * i / count for i in range(1, count + 1)]
        last = turn
    return points


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 8
    out = pathlib.Path(__file__).parents[2] / "data" / "imk_opensees.json"
    out = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else out
    chance = random.Random(1)
    rows = []
    for row in range(count):
        own = numbers(chance, row)
        xs = history(chance)
        found = forces(material(own), xs)
        failed = next((i for i in range(1, len(xs)) if found[i] == 0 and found[i - 1] != 0), len(xs))
        unknown = next((i for i, s in enumerate(found) if math.isnan(s)), len(xs))
        end = min(failed + 3, unknown)
        law = "imk-pinching" if "kappa_F" in own else "imk-peak-oriented"
        rows.append({"law": law, "numbers": own, "x": xs[:end], "S": found[:end]})
    chance = random.Random(2)
    for row in range(count):
        own, material_numbers = bilinear(chance, row)
        xs = history(chance)
        found = forces(material_numbers, xs)
        end = next((i for i, s in enumerate(found) if math.isnan(s) or s == 0), len(xs))
        caps = [own["Fcap_ratio" + side] * own["Fy" + side] for side in ["", "_negative"]]
        beyond = next((i for i in range(end) if abs(found[i]) > 1.001 * max(caps)), end)
        while 0 < beyond < end and found[beyond - 1] * found[beyond] > 0:
            beyond -= 1
        end = min(end, beyond)
        rows.append({"law": "imk-bilinear", "numbers": own, "x": xs[:end], "S": found[:end]})
    out.write_text("[\n%s\n]\n" % ",\n".join(json.dumps(row) for row in rows))


if __name__ == "__main__":
    main()
